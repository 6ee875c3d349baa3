// emboss: texture coordinates displaced by the direction of a light, for embossing
// made by fixpath 0.1.0; seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)
//   setting=nv frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
//   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
//   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
//   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
//   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
//   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
//   rom=block
// latency 25 cycles, interval 1 cycle; tables read on the clock
// errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   ds_texels: mean 8.34e-4 texel, largest seen 6.81e-3 texel at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   ds_relative: mean 2.65e-6, largest seen 1.57e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=16750 normal_y=-6938 normal_z=100 ct_x=370 ct_y=-1703 ct_z=18454 light_x=-21858093 light_y=11862104 light_z=22208289 vertex_x=-20247618 vertex_y=12204548 vertex_z=17798660 s0=2324101 t0=-917458 q0=289204 r0=140514
//   ds: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   dt_texels: mean 7.78e-4 texel, largest seen 6.34e-3 texel at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   dt_relative: mean 2.48e-6, largest seen 1.69e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=539 normal_y=10101 normal_z=11796 ct_x=-4134 ct_y=-13685 ct_z=9001 light_x=-16348031 light_y=19544902 light_z=11919376 vertex_x=-16890033 vertex_y=19483858 vertex_z=11791741 s0=601665 t0=-1430898 q0=258948 r0=-148469
//   dt: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   s1: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   t1: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
//   q1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
//   r1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
// stated bound on each relative displacement (over the vector's length times its factor, each 1/4 where it is less): 1.09e-4
// stated bound on each displacement: 1.32e-2
// stated bound on each displacement in texels: 3.38e0
// stated bound on each coordinate: 1.32e-2
// stated bound on each flag and what is passed: 0.00e0
//
// Self-checking testbench of emboss_nv. It reads emboss_nv_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 299 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes emboss_nv_tb.vcd.
module emboss_nv_tb;
    localparam LATENCY = 25;
    localparam VECTORS = 299;
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
    reg signed [12:-15] port_light_x;
    reg signed [12:-15] port_light_y;
    reg signed [12:-15] port_light_z;
    reg signed [12:-15] port_vertex_x;
    reg signed [12:-15] port_vertex_y;
    reg signed [12:-15] port_vertex_z;
    reg signed [6:-18] port_s0;
    reg signed [6:-18] port_t0;
    reg signed [6:-18] port_q0;
    reg signed [6:-18] port_r0;
    wire signed [11:-18] port_ds;
    wire signed [15:-18] port_dt;
    wire signed [6:-18] port_s1;
    wire signed [6:-18] port_t1;
    wire port_degenerate;
    wire signed [6:-18] port_q1;
    wire signed [6:-18] port_r1;

    emboss_nv dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .normal_x(port_normal_x),
        .normal_y(port_normal_y),
        .normal_z(port_normal_z),
        .ct_x(port_ct_x),
        .ct_y(port_ct_y),
        .ct_z(port_ct_z),
        .light_x(port_light_x),
        .light_y(port_light_y),
        .light_z(port_light_z),
        .vertex_x(port_vertex_x),
        .vertex_y(port_vertex_y),
        .vertex_z(port_vertex_z),
        .s0(port_s0),
        .t0(port_t0),
        .q0(port_q0),
        .r0(port_r0),
        .ds(port_ds),
        .dt(port_dt),
        .s1(port_s1),
        .t1(port_t1),
        .degenerate(port_degenerate),
        .q1(port_q1),
        .r1(port_r1)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [164:0] expected [0:LATENCY];
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
    reg signed [12:-15] next_light_x;
    reg signed [12:-15] next_light_y;
    reg signed [12:-15] next_light_z;
    reg signed [12:-15] next_vertex_x;
    reg signed [12:-15] next_vertex_y;
    reg signed [12:-15] next_vertex_z;
    reg signed [6:-18] next_s0;
    reg signed [6:-18] next_t0;
    reg signed [6:-18] next_q0;
    reg signed [6:-18] next_r0;
    reg signed [11:-18] next_ds;
    reg signed [15:-18] next_dt;
    reg signed [6:-18] next_s1;
    reg signed [6:-18] next_t1;
    reg next_degenerate;
    reg signed [6:-18] next_q1;
    reg signed [6:-18] next_r1;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("emboss_nv_tb.vcd");
            $dumpvars(0, emboss_nv_tb);
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
            file = $fopen("emboss_nv_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: emboss_nv_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_normal_x, next_normal_y, next_normal_z, next_ct_x, next_ct_y, next_ct_z, next_light_x, next_light_y, next_light_z, next_vertex_x, next_vertex_y, next_vertex_z, next_s0, next_t0, next_q0, next_r0, next_ds, next_dt, next_s1, next_t1, next_degenerate, next_q1, next_r1);
            more = fields == 23;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: emboss_nv_vectors.txt is cut short after vector %0d", sent);
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
                if (port_ds !== expected[LATENCY][164:135]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ds expected %h got %h",
                            number[LATENCY], expected[LATENCY][164:135], port_ds);
                end
                if (port_dt !== expected[LATENCY][134:101]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d dt expected %h got %h",
                            number[LATENCY], expected[LATENCY][134:101], port_dt);
                end
                if (port_s1 !== expected[LATENCY][100:76]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d s1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][100:76], port_s1);
                end
                if (port_t1 !== expected[LATENCY][75:51]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][75:51], port_t1);
                end
                if (port_degenerate !== expected[LATENCY][50:50]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d degenerate expected %h got %h",
                            number[LATENCY], expected[LATENCY][50:50], port_degenerate);
                end
                if (port_q1 !== expected[LATENCY][49:25]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d q1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][49:25], port_q1);
                end
                if (port_r1 !== expected[LATENCY][24:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d r1 expected %h got %h",
                            number[LATENCY], expected[LATENCY][24:0], port_r1);
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
                        expected[0] = {next_ds, next_dt, next_s1, next_t1, next_degenerate, next_q1, next_r1};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 299) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_normal_x <= valid[0] ? next_normal_x : 16'bx;
                port_normal_y <= valid[0] ? next_normal_y : 16'bx;
                port_normal_z <= valid[0] ? next_normal_z : 16'bx;
                port_ct_x <= valid[0] ? next_ct_x : 16'bx;
                port_ct_y <= valid[0] ? next_ct_y : 16'bx;
                port_ct_z <= valid[0] ? next_ct_z : 16'bx;
                port_light_x <= valid[0] ? next_light_x : 28'bx;
                port_light_y <= valid[0] ? next_light_y : 28'bx;
                port_light_z <= valid[0] ? next_light_z : 28'bx;
                port_vertex_x <= valid[0] ? next_vertex_x : 28'bx;
                port_vertex_y <= valid[0] ? next_vertex_y : 28'bx;
                port_vertex_z <= valid[0] ? next_vertex_z : 28'bx;
                port_s0 <= valid[0] ? next_s0 : 25'bx;
                port_t0 <= valid[0] ? next_t0 : 25'bx;
                port_q0 <= valid[0] ? next_q0 : 25'bx;
                port_r0 <= valid[0] ? next_r0 : 25'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 299 / 2) begin
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
                $display("mismatch: emboss_nv_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
