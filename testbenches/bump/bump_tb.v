// bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
// made by fixpath 0.1.0; seed 001 (Lee et al.), Fig. 8; the turn psi and the exact pipelines are this project's
//   pipeline=exact-polar conversion=table angle_bits=16 table_addr_bits=10 scheme=direct
//   quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   cos_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
//   highlight=on diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16
//   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 24 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 4.50e-4, largest seen 8.09e-3 (529.9 ulp) at phi_l=54099 theta_l=21061 phi_h=60333 theta_h=25870 phi_n=4085 theta_n=24243 psi=15789 phi_p=37530 theta_p=7850
//   diffuse: mean 3.83e-4, largest seen 4.02e-3 (263.2 ulp) at phi_l=44654 theta_l=8576 phi_h=60159 theta_h=5510 phi_n=58665 theta_n=10045 psi=11801 phi_p=60790 theta_p=4186
//   specular: mean 1.09e-4, largest seen 7.98e-3 (522.8 ulp) at phi_l=40708 theta_l=14134 phi_h=34659 theta_h=13276 phi_n=35527 theta_n=15280 psi=31916 phi_p=11259 theta_p=2671
//   dot_l: mean 1.24e-3, largest seen 6.37e-3 (417.4 ulp) at phi_l=61704 theta_l=22170 phi_h=4275 theta_h=14080 phi_n=20110 theta_n=22175 psi=22018 phi_p=55143 theta_p=8416
//   dot_h: mean 1.25e-3, largest seen 6.38e-3 (417.8 ulp) at phi_l=40990 theta_l=19166 phi_h=52190 theta_h=15291 phi_n=57641 theta_n=20094 psi=62778 phi_p=9870 theta_p=8515
//   lt_angle: mean 1.43e-3 rad, largest seen 4.45e-3 rad at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
//   lt_dot: mean 1.43e-3, largest seen 4.45e-3 at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
//   lt_x: mean 7.74e-4, largest seen 4.05e-3 at phi_l=6884 theta_l=16156 phi_h=11810 theta_h=14024 phi_n=5223 theta_n=13921 psi=46897 phi_p=28640 theta_p=7461
//   lt_y: mean 6.21e-4, largest seen 3.10e-3 at phi_l=40221 theta_l=13057 phi_h=11896 theta_h=1741 phi_n=6618 theta_n=8346 psi=32754 phi_p=13032 theta_p=5385
//   lt_z: mean 7.41e-4, largest seen 4.08e-3 at phi_l=55938 theta_l=23167 phi_h=56369 theta_h=21833 phi_n=7227 theta_n=16515 psi=2242 phi_p=14438 theta_p=4655
//   ht_angle: mean 1.43e-3 rad, largest seen 5.28e-3 rad at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
//   ht_dot: mean 1.43e-3, largest seen 5.28e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
//   ht_x: mean 7.83e-4, largest seen 4.09e-3 at phi_l=31111 theta_l=19790 phi_h=29735 theta_h=16324 phi_n=29676 theta_n=17022 psi=22911 phi_p=3532 theta_p=8126
//   ht_y: mean 6.21e-4, largest seen 3.21e-3 at phi_l=15384 theta_l=20283 phi_h=16010 theta_h=30916 phi_n=33483 theta_n=20732 psi=60970 phi_p=20741 theta_p=7238
//   ht_z: mean 7.39e-4, largest seen 4.45e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
// stated bound on each dot: 2.73e-2
// stated bound on each diffuse: 1.67e-2
// stated bound on each specular: 1.81e-1
// stated bound on each intensity: 1.97e-1
// stated bound on the angle: 1.82e-2 rad
//
// Self-checking testbench of bump. It reads bump_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 260 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes bump_tb.vcd.
module bump_tb;
    localparam LATENCY = 24;
    localparam VECTORS = 260;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg [-1:-16] port_phi_l;
    reg [-1:-16] port_theta_l;
    reg [-1:-16] port_phi_h;
    reg [-1:-16] port_theta_h;
    reg [-1:-16] port_phi_n;
    reg [-1:-16] port_theta_n;
    reg [-1:-16] port_psi;
    reg [-1:-16] port_phi_p;
    reg [-1:-16] port_theta_p;
    wire [-1:-16] port_intensity;
    wire [-1:-16] port_diffuse;
    wire [-1:-16] port_specular;

    bump dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .phi_l(port_phi_l),
        .theta_l(port_theta_l),
        .phi_h(port_phi_h),
        .theta_h(port_theta_h),
        .phi_n(port_phi_n),
        .theta_n(port_theta_n),
        .psi(port_psi),
        .phi_p(port_phi_p),
        .theta_p(port_theta_p),
        .intensity(port_intensity),
        .diffuse(port_diffuse),
        .specular(port_specular)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [47:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg [-1:-16] next_phi_l;
    reg [-1:-16] next_theta_l;
    reg [-1:-16] next_phi_h;
    reg [-1:-16] next_theta_h;
    reg [-1:-16] next_phi_n;
    reg [-1:-16] next_theta_n;
    reg [-1:-16] next_psi;
    reg [-1:-16] next_phi_p;
    reg [-1:-16] next_theta_p;
    reg [-1:-16] next_intensity;
    reg [-1:-16] next_diffuse;
    reg [-1:-16] next_specular;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("bump_tb.vcd");
            $dumpvars(0, bump_tb);
        end
        lfsr = 32'h2545f491;
        mismatches = 0;
        passed = 0;
        stalls = 1'b0;
        started = 1'b0; // nothing is known before the first edge under reset
        for (i = 0; i <= LATENCY; i = i + 1) valid[i] = 1'b0;
        open_vectors;
    end

    task finish_failed;
        begin
`ifdef __ICARUS__
            $finish_and_return(1);
`else
            $fatal(0);
`endif
        end
    endtask

    task open_vectors;
        begin
            sent = 0;
            checked = 0;
            more = 1'b1;
            reset_done = 1'b0;
            file = $fopen("bump_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: bump_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h ", next_phi_l, next_theta_l, next_phi_h, next_theta_h, next_phi_n, next_theta_n, next_psi, next_phi_p, next_theta_p, next_intensity, next_diffuse, next_specular);
            more = fields == 12;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: bump_vectors.txt is cut short after vector %0d", sent);
            end
        end
    endtask

    task check;
        begin
            if (started && valid_out !== valid[LATENCY]) begin
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    $display("mismatch: vector %0d valid_out expected %b got %b", checked, valid[LATENCY], valid_out);
            end
            // Each word counts once: in the cycle after which the pipeline moves on.
            if (ce && valid[LATENCY]) begin
                if (port_intensity !== expected[LATENCY][47:32]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d intensity expected %h got %h",
                            number[LATENCY], expected[LATENCY][47:32], port_intensity);
                end
                if (port_diffuse !== expected[LATENCY][31:16]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d diffuse expected %h got %h",
                            number[LATENCY], expected[LATENCY][31:16], port_diffuse);
                end
                if (port_specular !== expected[LATENCY][15:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d specular expected %h got %h",
                            number[LATENCY], expected[LATENCY][15:0], port_specular);
                end
                checked = checked + 1;
            end
        end
    endtask

    task move_on;
        begin
            for (i = LATENCY; i > 0; i = i - 1) begin
                if (rst) valid[i] = 1'b0;
                else if (ce) valid[i] = valid[i - 1];
                if (ce) expected[i] = expected[i - 1];
                if (ce) number[i] = number[i - 1];
            end
        end
    endtask

    // What goes in after this edge: words stay where the pipeline stood still.
    task drive;
        begin
            lfsr = {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
            rst <= 1'b0;
            ce <= !(stalls && lfsr[2:0] == 3'd0);
            if (ce) begin
                valid[0] = 1'b0;
                if (more && !(stalls && lfsr[5:3] == 3'd0)) begin
                    read_vector;
                    if (more) begin
                        valid[0] = 1'b1;
                        expected[0] = {next_intensity, next_diffuse, next_specular};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 260) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_phi_l <= valid[0] ? next_phi_l : 16'bx;
                port_theta_l <= valid[0] ? next_theta_l : 16'bx;
                port_phi_h <= valid[0] ? next_phi_h : 16'bx;
                port_theta_h <= valid[0] ? next_theta_h : 16'bx;
                port_phi_n <= valid[0] ? next_phi_n : 16'bx;
                port_theta_n <= valid[0] ? next_theta_n : 16'bx;
                port_psi <= valid[0] ? next_psi : 16'bx;
                port_phi_p <= valid[0] ? next_phi_p : 16'bx;
                port_theta_p <= valid[0] ? next_theta_p : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 260 / 2) begin
                rst <= 1'b1;
                ce <= 1'b0;
                reset_done = 1'b1;
            end
        end
    endtask

    always @(posedge clk) begin
        check;
        if (rst && stalls) begin
            // Forgotten, but for what hasn't gone in yet.
            for (i = 1; i <= LATENCY; i = i + 1) if (valid[i]) checked = checked + 1;
        end
        move_on;
        drive;
        started = 1'b1;
        if (!more && checked == sent) begin
            $fclose(file);
            if (!stalls) begin
                passed = checked;
                stalls = 1'b1;
                open_vectors;
            end else finish;
        end
    end

    task finish;
        begin
            if (passed != VECTORS)
                $display("mismatch: bump_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
            if (mismatches == 0 && passed == VECTORS) begin
                $display("PASS %0d vectors", passed);
                $finish(0);
            end else begin
                $display("FAIL %0d mismatches in %0d vectors", mismatches, passed);
                finish_failed;
            end
        end
    endtask
endmodule
