// kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
// made by fixpath 0.1.0; Kugler 1998 (IMEM), as seed 001 (Lee et al.) describes it; largely a reconstruction
//   conversion=table tilt_addr_bits=14 map_angle_bits=8 map_addr_bits=12 angle_bits=16
//   table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up
//   recip_addr_bits=auto atan_addr_bits=auto cordic_iterations=auto highlight=on light_bits=16
//   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 21 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 1.64e-2, largest seen 3.21e-1 (21034.8 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
//   diffuse: mean 1.43e-2, largest seen 1.61e-1 (10548.1 ulp) at n_x=64337 n_y=68 n_z=-12481 psi=46469 phi_p=59889 theta_p=8345 phi_l=60553 theta_l=24577 phi_h=60753 theta_h=28326
//   specular: mean 3.33e-3, largest seen 2.10e-1 (13738.9 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
//   pw_angle: mean 6.11e-2 rad, largest seen 1.66e-1 rad at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
//   pw_dot: mean 6.11e-2, largest seen 1.66e-1 at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
//   pw_x: mean 2.72e-2, largest seen 1.50e-1 at n_x=-40953 n_y=22153 n_z=46120 psi=61767 phi_p=36536 theta_p=8148 phi_l=60944 theta_l=4014 phi_h=33548 theta_h=9549
//   pw_y: mean 2.71e-2, largest seen 1.47e-1 at n_x=13068 n_y=52261 n_z=-37322 psi=50906 phi_p=20746 theta_p=8211 phi_l=13848 theta_l=18740 phi_h=19374 theta_h=27605
//   pw_z: mean 3.70e-2, largest seen 1.56e-1 at n_x=58525 n_y=-14807 n_z=25506 psi=44588 phi_p=12702 theta_p=8159 phi_l=49639 theta_l=20508 phi_h=63118 theta_h=22796
//   pl_angle: mean 8.82e-2 rad, largest seen 2.91e-1 rad at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
//   pl_dot: mean 8.82e-2, largest seen 2.90e-1 at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
//   pl_x: mean 4.70e-2, largest seen 2.78e-1 at n_x=36200 n_y=-53003 n_z=-13238 psi=14755 phi_p=47780 theta_p=7407 phi_l=57722 theta_l=28642 phi_h=58499 theta_h=19711
//   pl_y: mean 3.86e-2, largest seen 1.99e-1 at n_x=1054 n_y=243 n_z=65527 psi=4485 phi_p=44708 theta_p=8256 phi_l=16693 theta_l=28786 phi_h=40236 theta_h=23869
//   pl_z: mean 4.65e-2, largest seen 2.53e-1 at n_x=-21222 n_y=60550 n_z=-13354 psi=8628 phi_p=51032 theta_p=3342 phi_l=50666 theta_l=26736 phi_h=12630 theta_h=28946
//   ph_angle: mean 8.83e-2 rad, largest seen 2.92e-1 rad at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
//   ph_dot: mean 8.83e-2, largest seen 2.91e-1 at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
//   ph_x: mean 4.70e-2, largest seen 2.42e-1 at n_x=40289 n_y=36933 n_z=-36161 psi=5281 phi_p=51702 theta_p=5800 phi_l=12406 theta_l=11093 phi_h=11666 theta_h=24712
//   ph_y: mean 3.87e-2, largest seen 1.90e-1 at n_x=18685 n_y=41876 n_z=-46821 psi=56218 phi_p=58881 theta_p=9312 phi_l=60146 theta_l=20332 phi_h=65052 theta_h=17648
//   ph_z: mean 4.67e-2, largest seen 2.45e-1 at n_x=63088 n_y=-17640 n_z=1940 psi=34649 phi_p=1283 theta_p=7197 phi_l=57191 theta_l=29307 phi_h=60648 theta_h=22533
// no bound is stated: near a pole, a cell of a map has azimuths of the whole turn in it: no cell size bounds the light
//
// Self-checking testbench of kugler. It reads kugler_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 270 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes kugler_tb.vcd.
module kugler_tb;
    localparam LATENCY = 21;
    localparam VECTORS = 270;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [1:-16] port_n_x;
    reg signed [1:-16] port_n_y;
    reg signed [1:-16] port_n_z;
    reg [-1:-16] port_psi;
    reg [-1:-16] port_phi_p;
    reg [-1:-16] port_theta_p;
    reg [-1:-16] port_phi_l;
    reg [-1:-16] port_theta_l;
    reg [-1:-16] port_phi_h;
    reg [-1:-16] port_theta_h;
    wire [-1:-16] port_intensity;
    wire [-1:-16] port_diffuse;
    wire [-1:-16] port_specular;

    kugler dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .n_x(port_n_x),
        .n_y(port_n_y),
        .n_z(port_n_z),
        .psi(port_psi),
        .phi_p(port_phi_p),
        .theta_p(port_theta_p),
        .phi_l(port_phi_l),
        .theta_l(port_theta_l),
        .phi_h(port_phi_h),
        .theta_h(port_theta_h),
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
    reg signed [1:-16] next_n_x;
    reg signed [1:-16] next_n_y;
    reg signed [1:-16] next_n_z;
    reg [-1:-16] next_psi;
    reg [-1:-16] next_phi_p;
    reg [-1:-16] next_theta_p;
    reg [-1:-16] next_phi_l;
    reg [-1:-16] next_theta_l;
    reg [-1:-16] next_phi_h;
    reg [-1:-16] next_theta_h;
    reg [-1:-16] next_intensity;
    reg [-1:-16] next_diffuse;
    reg [-1:-16] next_specular;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("kugler_tb.vcd");
            $dumpvars(0, kugler_tb);
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
            file = $fopen("kugler_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: kugler_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h ", next_n_x, next_n_y, next_n_z, next_psi, next_phi_p, next_theta_p, next_phi_l, next_theta_l, next_phi_h, next_theta_h, next_intensity, next_diffuse, next_specular);
            more = fields == 13;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: kugler_vectors.txt is cut short after vector %0d", sent);
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
                port_n_x <= valid[0] ? next_n_x : 18'bx;
                port_n_y <= valid[0] ? next_n_y : 18'bx;
                port_n_z <= valid[0] ? next_n_z : 18'bx;
                port_psi <= valid[0] ? next_psi : 16'bx;
                port_phi_p <= valid[0] ? next_phi_p : 16'bx;
                port_theta_p <= valid[0] ? next_theta_p : 16'bx;
                port_phi_l <= valid[0] ? next_phi_l : 16'bx;
                port_theta_l <= valid[0] ? next_theta_l : 16'bx;
                port_phi_h <= valid[0] ? next_phi_h : 16'bx;
                port_theta_h <= valid[0] ? next_theta_h : 16'bx;
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
                $display("mismatch: kugler_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
