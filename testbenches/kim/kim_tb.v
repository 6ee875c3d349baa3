// kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
// made by fixpath 0.1.0; Kim et al. 2001: eqs (3), (4) of seed 001 (Lee et al.); the set-up is a reconstruction
//   conversion=table angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
//   guard_bits=2 rounding=half-up sincos_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
//   cordic_iterations=auto highlight=on diffuse_addr_bits=10 specular_addr_bits=10
//   light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3 exponent=32
//   period_ps=5000 stages=auto rom=block
// latency 30 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 6.91e-4, largest seen 1.28e-2 (836.5 ulp) at phi_l=12249 theta_l=10042 phi_h=25129 theta_h=12990 phi_n=27856 theta_n=18250 psi=18706 phi_p=19124 theta_p=3769
//   diffuse: mean 5.92e-4, largest seen 7.09e-3 (464.8 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
//   specular: mean 1.54e-4, largest seen 1.15e-2 (756.4 ulp) at phi_l=46792 theta_l=23943 phi_h=48621 theta_h=15295 phi_n=56540 theta_n=7516 psi=771 phi_p=53306 theta_p=8323
//   dot_l: mean 1.94e-3, largest seen 1.17e-2 (766.0 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
//   dot_h: mean 1.93e-3, largest seen 1.09e-2 (713.0 ulp) at phi_l=60553 theta_l=18372 phi_h=64636 theta_h=22235 phi_n=8005 theta_n=19253 psi=1559 phi_p=20130 theta_p=8069
//   lt_angle: mean 2.77e-3 rad, largest seen 7.77e-3 rad at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
//   lt_dot: mean 2.77e-3, largest seen 7.77e-3 at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
//   lt_x: mean 1.43e-3, largest seen 7.31e-3 at phi_l=3004 theta_l=11455 phi_h=6745 theta_h=15411 phi_n=16385 theta_n=5769 psi=61008 phi_p=44796 theta_p=5705
//   lt_y: mean 1.26e-3, largest seen 6.21e-3 at phi_l=58622 theta_l=14345 phi_h=63015 theta_h=26871 phi_n=27904 theta_n=24597 psi=39862 phi_p=34182 theta_p=8142
//   lt_z: mean 1.47e-3, largest seen 6.89e-3 at phi_l=46077 theta_l=10290 phi_h=47299 theta_h=13859 phi_n=55937 theta_n=20227 psi=54458 phi_p=65410 theta_p=4451
//   ht_angle: mean 2.77e-3 rad, largest seen 7.83e-3 rad at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
//   ht_dot: mean 2.77e-3, largest seen 7.83e-3 at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
//   ht_x: mean 1.43e-3, largest seen 6.94e-3 at phi_l=60765 theta_l=22077 phi_h=12545 theta_h=23229 phi_n=26302 theta_n=28297 psi=58283 phi_p=51185 theta_p=7747
//   ht_y: mean 1.26e-3, largest seen 5.92e-3 at phi_l=17506 theta_l=13432 phi_h=12930 theta_h=16780 phi_n=13695 theta_n=13345 psi=2824 phi_p=40130 theta_p=3617
//   ht_z: mean 1.46e-3, largest seen 6.74e-3 at phi_l=15954 theta_l=3967 phi_h=34558 theta_h=10628 phi_n=23439 theta_n=21371 psi=29040 phi_p=61493 theta_p=6921
// stated bound on each dot: 8.61e-2
// stated bound on each diffuse: 5.20e-2
// stated bound on each specular: 2.88e-1
// stated bound on each intensity: 3.40e-1
// stated bound on the angle: 7.10e-2 rad
//
// Self-checking testbench of kim. It reads kim_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 270 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes kim_tb.vcd.
module kim_tb;
    localparam LATENCY = 30;
    localparam VECTORS = 270;
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

    kim dut (
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
            $dumpfile("kim_tb.vcd");
            $dumpvars(0, kim_tb);
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
            file = $fopen("kim_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: kim_vectors.txt can't be read");
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
                $display("mismatch: kim_vectors.txt is cut short after vector %0d", sent);
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
                        if (stalls && sent == 270) more = 1'b0;
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
            if (stalls && !reset_done && sent == 270 / 2) begin
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
                $display("mismatch: kim_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
