// emboss: texture coordinates displaced by the direction of a light, for embossing
// made by fixpath 0.1.0; US 6,980,218; US 7,307,640; GL_NV_texgen_emboss
//   setting=gx frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
//   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
//   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
//   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
//   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
//   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
//   rom=block
// latency 14 cycles, interval 1 cycle; tables read on the clock
// errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   ds_texels: mean 5.15e-4 texel, largest seen 4.51e-3 texel at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   ds_relative: mean 2.03e-6, largest seen 1.43e-5 over the vector's length times its factor, each at least 1/4, at m0_x=4132 m0_y=-131 m0_z=429 m1_x=133 m1_y=4154 m1_z=-11 m2_x=-428 m2_y=25 m2_z=4134 tangent_x=-10615 tangent_y=137 tangent_z=12480 binormal_x=-202 binormal_y=16379 binormal_z=-351 light_x=26912091 light_y=-19929090 light_z=-1678718 vertex_x=27451608 vertex_y=-19638454 vertex_z=-1458906 s0=-3142235 t0=-300807
//   ds: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   dt_texels: mean 5.17e-4 texel, largest seen 5.30e-3 texel at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   dt_relative: mean 2.03e-6, largest seen 1.55e-5 over the vector's length times its factor, each at least 1/4, at m0_x=1817 m0_y=-3955 m0_z=169 m1_x=460 m1_y=27 m1_z=-4332 m2_x=3932 m2_y=1825 m2_z=429 tangent_x=6988 tangent_y=-14240 tangent_z=4101 binormal_x=-170 binormal_y=4457 binormal_z=15765 light_x=-9167663 light_y=7142069 light_z=-10596957 vertex_x=-8884124 vertex_y=7444365 vertex_z=-9525055 s0=2333965 t0=3659718
//   dt: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   s1: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   t1: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at m0_x=4674 m0_y=5079 m0_z=-2162 m1_x=-3514 m1_y=4923 m1_z=3966 m2_x=-4257 m2_y=1512 m2_z=-5648 tangent_x=-2894 tangent_y=-19246 tangent_z=1152 binormal_x=-2531 binormal_y=7271 binormal_z=-13448 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897
// stated bound on each relative displacement (relative to the vector's length times its factor, each at least 1/4): 5.21e-5
// stated bound on each displacement: 1.15e-3
// stated bound on each displacement in texels: 2.93e-1
// stated bound on each coordinate: 1.15e-3
// stated bound on each flag and what is passed: 0.00e0
//
// Self-checking testbench of emboss.
// Each line of emboss_vectors.txt holds the input words and then the
// expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
// per cycle. The second pass sends the first 303 again with stalls and gaps,
// with a reset in mid-stream. Every bit of every output and the latency are compared.
// The last line says PASS or FAIL; a failure ends with a nonzero status.
// With +vcd the testbench writes emboss_tb.vcd.
module emboss_tb;
    localparam LATENCY = 14;
    localparam VECTORS = 303;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // The prefix port_ keeps the ports' names apart from the names used here.
    reg signed [2:-13] port_m0_x;
    reg signed [2:-13] port_m0_y;
    reg signed [2:-13] port_m0_z;
    reg signed [2:-13] port_m1_x;
    reg signed [2:-13] port_m1_y;
    reg signed [2:-13] port_m1_z;
    reg signed [2:-13] port_m2_x;
    reg signed [2:-13] port_m2_y;
    reg signed [2:-13] port_m2_z;
    reg signed [1:-14] port_tangent_x;
    reg signed [1:-14] port_tangent_y;
    reg signed [1:-14] port_tangent_z;
    reg signed [1:-14] port_binormal_x;
    reg signed [1:-14] port_binormal_y;
    reg signed [1:-14] port_binormal_z;
    reg signed [12:-15] port_light_x;
    reg signed [12:-15] port_light_y;
    reg signed [12:-15] port_light_z;
    reg signed [12:-15] port_vertex_x;
    reg signed [12:-15] port_vertex_y;
    reg signed [12:-15] port_vertex_z;
    reg signed [6:-18] port_s0;
    reg signed [6:-18] port_t0;
    wire signed [8:-18] port_ds;
    wire signed [8:-18] port_dt;
    wire signed [6:-18] port_s1;
    wire signed [6:-18] port_t1;
    wire port_degenerate;

    emboss dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .m0_x(port_m0_x),
        .m0_y(port_m0_y),
        .m0_z(port_m0_z),
        .m1_x(port_m1_x),
        .m1_y(port_m1_y),
        .m1_z(port_m1_z),
        .m2_x(port_m2_x),
        .m2_y(port_m2_y),
        .m2_z(port_m2_z),
        .tangent_x(port_tangent_x),
        .tangent_y(port_tangent_y),
        .tangent_z(port_tangent_z),
        .binormal_x(port_binormal_x),
        .binormal_y(port_binormal_y),
        .binormal_z(port_binormal_z),
        .light_x(port_light_x),
        .light_y(port_light_y),
        .light_z(port_light_z),
        .vertex_x(port_vertex_x),
        .vertex_y(port_vertex_y),
        .vertex_z(port_vertex_z),
        .s0(port_s0),
        .t0(port_t0),
        .ds(port_ds),
        .dt(port_dt),
        .s1(port_s1),
        .t1(port_t1),
        .degenerate(port_degenerate)
    );

    // Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
    reg [104:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [2:-13] next_m0_x;
    reg signed [2:-13] next_m0_y;
    reg signed [2:-13] next_m0_z;
    reg signed [2:-13] next_m1_x;
    reg signed [2:-13] next_m1_y;
    reg signed [2:-13] next_m1_z;
    reg signed [2:-13] next_m2_x;
    reg signed [2:-13] next_m2_y;
    reg signed [2:-13] next_m2_z;
    reg signed [1:-14] next_tangent_x;
    reg signed [1:-14] next_tangent_y;
    reg signed [1:-14] next_tangent_z;
    reg signed [1:-14] next_binormal_x;
    reg signed [1:-14] next_binormal_y;
    reg signed [1:-14] next_binormal_z;
    reg signed [12:-15] next_light_x;
    reg signed [12:-15] next_light_y;
    reg signed [12:-15] next_light_z;
    reg signed [12:-15] next_vertex_x;
    reg signed [12:-15] next_vertex_y;
    reg signed [12:-15] next_vertex_z;
    reg signed [6:-18] next_s0;
    reg signed [6:-18] next_t0;
    reg signed [8:-18] next_ds;
    reg signed [8:-18] next_dt;
    reg signed [6:-18] next_s1;
    reg signed [6:-18] next_t1;
    reg next_degenerate;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("emboss_tb.vcd");
            $dumpvars(0, emboss_tb);
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
            file = $fopen("emboss_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: emboss_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_m0_x, next_m0_y, next_m0_z, next_m1_x, next_m1_y, next_m1_z, next_m2_x, next_m2_y, next_m2_z, next_tangent_x, next_tangent_y, next_tangent_z, next_binormal_x, next_binormal_y, next_binormal_z, next_light_x, next_light_y, next_light_z, next_vertex_x, next_vertex_y, next_vertex_z, next_s0, next_t0, next_ds, next_dt, next_s1, next_t1, next_degenerate);
            more = fields == 28;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: emboss_vectors.txt is cut short after vector %0d", sent);
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
            // Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if (ce && valid[LATENCY]) begin
                if (port_ds !== expected[LATENCY][104:78]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ds expected %h got %h",
                            number[LATENCY], expected[LATENCY][104:78], port_ds);
                end
                if (port_dt !== expected[LATENCY][77:51]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d dt expected %h got %h",
                            number[LATENCY], expected[LATENCY][77:51], port_dt);
                end
                if (port_s1 !== expected[LATENCY][50:26]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d s1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][50:26], port_s1);
                end
                if (port_t1 !== expected[LATENCY][25:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][25:1], port_t1);
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

    // Sets the inputs after this edge. They don't change while the pipeline is stalled.
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
                        expected[0] = {next_ds, next_dt, next_s1, next_t1, next_degenerate};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 303) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_m0_x <= valid[0] ? next_m0_x : 16'bx;
                port_m0_y <= valid[0] ? next_m0_y : 16'bx;
                port_m0_z <= valid[0] ? next_m0_z : 16'bx;
                port_m1_x <= valid[0] ? next_m1_x : 16'bx;
                port_m1_y <= valid[0] ? next_m1_y : 16'bx;
                port_m1_z <= valid[0] ? next_m1_z : 16'bx;
                port_m2_x <= valid[0] ? next_m2_x : 16'bx;
                port_m2_y <= valid[0] ? next_m2_y : 16'bx;
                port_m2_z <= valid[0] ? next_m2_z : 16'bx;
                port_tangent_x <= valid[0] ? next_tangent_x : 16'bx;
                port_tangent_y <= valid[0] ? next_tangent_y : 16'bx;
                port_tangent_z <= valid[0] ? next_tangent_z : 16'bx;
                port_binormal_x <= valid[0] ? next_binormal_x : 16'bx;
                port_binormal_y <= valid[0] ? next_binormal_y : 16'bx;
                port_binormal_z <= valid[0] ? next_binormal_z : 16'bx;
                port_light_x <= valid[0] ? next_light_x : 28'bx;
                port_light_y <= valid[0] ? next_light_y : 28'bx;
                port_light_z <= valid[0] ? next_light_z : 28'bx;
                port_vertex_x <= valid[0] ? next_vertex_x : 28'bx;
                port_vertex_y <= valid[0] ? next_vertex_y : 28'bx;
                port_vertex_z <= valid[0] ? next_vertex_z : 28'bx;
                port_s0 <= valid[0] ? next_s0 : 25'bx;
                port_t0 <= valid[0] ? next_t0 : 25'bx;
            end
            // A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if (stalls && !reset_done && sent == 303 / 2) begin
                rst <= 1'b1;
                ce <= 1'b0;
                reset_done = 1'b1;
            end
        end
    endtask

    always @(posedge clk) begin
        check;
        if (rst && stalls) begin
            // Words in flight are lost. The word that hasn't entered yet isn't.
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
                $display("mismatch: emboss_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
