// basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
// made by fixpath 0.1.0; seed 002 (GL_NV_texgen_emboss), section 2.10.4
//   component_bits=16 guard_bits=0 norm_bits=18 dot_frac_bits=20 root_scheme=linear
//   root_addr_bits=9 root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 17 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 2.57e-5 rad, largest seen 9.63e-5 rad at normal_x=8380 normal_y=9641 normal_z=-7349 ct_x=13930 ct_y=3067 ct_z=4821
//   t_dot: mean 3.53e-5, largest seen 9.39e-5 at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
//   t_x: mean 1.77e-5, largest seen 7.84e-5 (1.3 ulp) at normal_x=9018 normal_y=13214 normal_z=12085 ct_x=-15544 ct_y=-6937 ct_z=8164
//   t_y: mean 1.77e-5, largest seen 7.49e-5 (1.2 ulp) at normal_x=-17534 normal_y=-897 normal_z=-9433 ct_x=8013 ct_y=-16499 ct_z=5940
//   t_z: mean 1.78e-5, largest seen 7.66e-5 (1.3 ulp) at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
//   bn_angle: mean 2.32e-5 rad, largest seen 5.60e-5 rad at normal_x=-10642 normal_y=-5666 normal_z=-5953 ct_x=1726 ct_y=-1464 ct_z=13894
//   bn_dot: mean 2.95e-5, largest seen 5.63e-5 at normal_x=-3329 normal_y=13424 normal_z=8156 ct_x=-4182 ct_y=-3328 ct_z=18276
//   bn_x: mean 1.53e-5, largest seen 3.77e-5 (0.6 ulp) at normal_x=-15816 normal_y=-754 normal_z=-9817 ct_x=-2394 ct_y=16948 ct_z=5363
//   bn_y: mean 1.53e-5, largest seen 3.75e-5 (0.6 ulp) at normal_x=16418 normal_y=-5802 normal_z=-2767 ct_x=-7596 ct_y=-14180 ct_z=-5075
//   bn_z: mean 1.54e-5, largest seen 3.67e-5 (0.6 ulp) at normal_x=4888 normal_y=-14943 normal_z=10350 ct_x=-4569 ct_y=10830 ct_z=11114
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152
// stated bound on each binormal: 8.03e-5
// stated bound on each tangent: 3.31e-4
// stated bound on each flag: 0.00e0
// renamed, since a language or another word has the name:
//   bn_x is bn_x_2
//   bn_y is bn_y_2
//   bn_z is bn_z_2
//
// Self-checking testbench of basis. It reads basis_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 247 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes basis_tb.vcd.
module basis_tb;
    localparam LATENCY = 17;
    localparam VECTORS = 247;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [1:-14] port_normal_x;
    reg signed [1:-14] port_normal_y;
    reg signed [1:-14] port_normal_z;
    reg signed [1:-14] port_ct_x;
    reg signed [1:-14] port_ct_y;
    reg signed [1:-14] port_ct_z;
    wire signed [2:-14] port_t_x;
    wire signed [2:-14] port_t_y;
    wire signed [2:-14] port_t_z;
    wire signed [1:-14] port_bn_x;
    wire signed [1:-14] port_bn_y;
    wire signed [1:-14] port_bn_z;
    wire port_degenerate;

    basis dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .normal_x(port_normal_x),
        .normal_y(port_normal_y),
        .normal_z(port_normal_z),
        .ct_x(port_ct_x),
        .ct_y(port_ct_y),
        .ct_z(port_ct_z),
        .t_x(port_t_x),
        .t_y(port_t_y),
        .t_z(port_t_z),
        .bn_x(port_bn_x),
        .bn_y(port_bn_y),
        .bn_z(port_bn_z),
        .degenerate(port_degenerate)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [99:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [1:-14] next_normal_x;
    reg signed [1:-14] next_normal_y;
    reg signed [1:-14] next_normal_z;
    reg signed [1:-14] next_ct_x;
    reg signed [1:-14] next_ct_y;
    reg signed [1:-14] next_ct_z;
    reg signed [2:-14] next_t_x;
    reg signed [2:-14] next_t_y;
    reg signed [2:-14] next_t_z;
    reg signed [1:-14] next_bn_x;
    reg signed [1:-14] next_bn_y;
    reg signed [1:-14] next_bn_z;
    reg next_degenerate;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("basis_tb.vcd");
            $dumpvars(0, basis_tb);
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
            file = $fopen("basis_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: basis_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h ", next_normal_x, next_normal_y, next_normal_z, next_ct_x, next_ct_y, next_ct_z, next_t_x, next_t_y, next_t_z, next_bn_x, next_bn_y, next_bn_z, next_degenerate);
            more = fields == 13;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: basis_vectors.txt is cut short after vector %0d", sent);
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
                if (port_t_x !== expected[LATENCY][99:83]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][99:83], port_t_x);
                end
                if (port_t_y !== expected[LATENCY][82:66]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][82:66], port_t_y);
                end
                if (port_t_z !== expected[LATENCY][65:49]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][65:49], port_t_z);
                end
                if (port_bn_x !== expected[LATENCY][48:33]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d bn_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][48:33], port_bn_x);
                end
                if (port_bn_y !== expected[LATENCY][32:17]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d bn_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][32:17], port_bn_y);
                end
                if (port_bn_z !== expected[LATENCY][16:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d bn_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][16:1], port_bn_z);
                end
                if (port_degenerate !== expected[LATENCY][0:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d degenerate expected %h got %h",
                            number[LATENCY], expected[LATENCY][0:0], port_degenerate);
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
                        expected[0] = {next_t_x, next_t_y, next_t_z, next_bn_x, next_bn_y, next_bn_z, next_degenerate};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 247) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_normal_x <= valid[0] ? next_normal_x : 16'bx;
                port_normal_y <= valid[0] ? next_normal_y : 16'bx;
                port_normal_z <= valid[0] ? next_normal_z : 16'bx;
                port_ct_x <= valid[0] ? next_ct_x : 16'bx;
                port_ct_y <= valid[0] ? next_ct_y : 16'bx;
                port_ct_z <= valid[0] ? next_ct_z : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 247 / 2) begin
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
                $display("mismatch: basis_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
