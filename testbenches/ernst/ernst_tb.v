// ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
// made by fixpath 0.1.0; Ernst et al. 1998, as seed 001 (Lee et al.) counts it in Table 1 and section 4.3
//   normalise=divide divider=non-restoring root=digits frac_bits=16 guard_bits=2 rounding=half-up
//   table_addr_bits=10 scheme=direct recip_addr_bits=auto root_addr_bits=auto highlight=on
//   specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3
//   exponent=32 period_ps=5000 stages=auto rom=block
// latency 33 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 7.10e-5, largest seen 4.39e-3 (287.8 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
//   diffuse: mean 7.90e-6, largest seen 3.38e-5 (2.2 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
//   specular: mean 6.51e-5, largest seen 4.37e-3 (286.6 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
//   dot_l: mean 5.51e-6, largest seen 2.58e-5 (1.7 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
//   dot_h: mean 5.55e-6, largest seen 2.64e-5 (1.7 ulp) at l_x=28436 l_y=58436 l_z=-8465 h_x=56347 h_y=29067 h_z=-16587 n_x=7268 n_y=55465 n_z=-34143 t_x=-16808 t_y=-31594 t_z=-54902 b_x=-62926 b_y=14846 b_z=10722 p_x=17769 p_y=-44293 p_z=44914
//   lt_angle: mean 5.96e-6 rad, largest seen 1.52e-5 rad at l_x=-46104 l_y=2218 l_z=46524 h_x=-34894 h_y=-9840 h_z=54594 n_x=-8835 n_y=57118 n_z=30893 t_x=27988 t_y=31483 t_z=-50204 b_x=-58597 b_y=6425 b_z=-28637 p_x=-41292 p_y=29455 p_z=41501
//   lt_dot: mean 7.58e-6, largest seen 1.60e-5 at l_x=-51507 l_y=24581 l_z=-32215 h_x=-48499 h_y=-39070 h_z=-20406 n_x=-49786 n_y=-42007 n_z=7192 t_x=-40759 t_y=43701 t_z=-26905 b_x=12449 b_y=-24912 b_z=-59324 p_x=18646 p_y=26903 p_z=56776
//   lt_x: mean 3.93e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-15279 l_y=5067 l_z=63528 h_x=29170 h_y=-18014 h_z=55853 n_x=53184 n_y=30871 n_z=22658 t_x=9050 t_y=-47812 t_z=43899 b_x=37209 b_y=-32496 b_z=-43064 p_x=30395 p_y=-14945 p_z=56105
//   lt_y: mean 3.92e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-33544 l_y=8570 l_z=55645 h_x=3237 h_y=45027 h_z=47509 n_x=51579 n_y=35193 n_z=-19899 t_x=-23525 t_y=-107 t_z=-61168 b_x=-32880 b_y=55285 b_z=12549 p_x=35175 p_y=37290 p_z=40831
//   lt_z: mean 3.90e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=60216 l_y=-731 l_z=25854 h_x=28155 h_y=-38009 h_z=45360 n_x=49800 n_y=-42419 n_z=3954 t_x=-7689 t_y=-2967 t_z=65016 b_x=-41903 b_y=-49868 b_z=-7231 p_x=38689 p_y=13334 p_z=51189
//   ht_angle: mean 5.97e-6 rad, largest seen 1.55e-5 rad at l_x=-42413 l_y=5315 l_z=-49678 h_x=-49190 h_y=10077 h_z=-42117 n_x=31825 n_y=43565 n_z=-37205 t_x=52333 t_y=-39424 t_z=-1398 b_x=-23310 b_y=-29031 b_z=-53933 p_x=41501 p_y=24164 p_z=44595
//   ht_dot: mean 7.59e-6, largest seen 1.61e-5 at l_x=39313 l_y=33020 l_z=40732 h_x=45349 h_y=44689 h_z=15535 n_x=-37342 n_y=44334 n_z=30579 t_x=53162 t_y=24386 t_z=29565 b_x=8622 b_y=41651 b_z=-49858 p_x=-25251 p_y=-37777 p_z=47226
//   ht_x: mean 3.92e-6, largest seen 1.07e-5 (0.7 ulp) at l_x=39149 l_y=-824 l_z=-52551 h_x=24132 h_y=-60683 h_z=-5494 n_x=-27035 n_y=-45260 n_z=-38931 t_x=-59525 t_y=17166 t_z=21378 b_x=-4566 b_y=44180 b_z=-48190 p_x=-12132 p_y=43147 p_z=47813
//   ht_y: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=32246 l_y=-33688 l_z=-46046 h_x=26934 h_y=-37639 h_z=-46399 n_x=15761 n_y=17121 n_z=-61265 t_x=59086 t_y=-27325 t_z=7564 b_x=-23568 b_y=-57054 b_z=-22007 p_x=-27119 p_y=36491 p_z=47201
//   ht_z: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=-37898 l_y=-11533 l_z=52209 h_x=-54011 h_y=-33479 h_z=-16030 n_x=-19265 n_y=-61659 n_z=-11046 t_x=-4008 t_y=12746 t_z=-64159 b_x=62512 b_y=-18185 b_z=-7518 p_x=10839 p_y=-28061 p_z=58224
// stated bound on each dot: 7.02e-5
// stated bound on each diffuse: 8.02e-5
// stated bound on each specular: 5.24e-3
// stated bound on each intensity: 5.33e-3
// stated bound on each component: 1.81e-5
// bounds hold for L and H in the texture frame, and N', from 1/2 to 2 long
//
// Self-checking testbench of ernst. It reads ernst_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 270 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes ernst_tb.vcd.
module ernst_tb;
    localparam LATENCY = 33;
    localparam VECTORS = 270;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [1:-16] port_l_x;
    reg signed [1:-16] port_l_y;
    reg signed [1:-16] port_l_z;
    reg signed [1:-16] port_h_x;
    reg signed [1:-16] port_h_y;
    reg signed [1:-16] port_h_z;
    reg signed [1:-16] port_n_x;
    reg signed [1:-16] port_n_y;
    reg signed [1:-16] port_n_z;
    reg signed [1:-16] port_t_x;
    reg signed [1:-16] port_t_y;
    reg signed [1:-16] port_t_z;
    reg signed [1:-16] port_b_x;
    reg signed [1:-16] port_b_y;
    reg signed [1:-16] port_b_z;
    reg signed [1:-16] port_p_x;
    reg signed [1:-16] port_p_y;
    reg signed [1:-16] port_p_z;
    wire [-1:-16] port_intensity;
    wire [-1:-16] port_diffuse;
    wire [-1:-16] port_specular;

    ernst dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .l_x(port_l_x),
        .l_y(port_l_y),
        .l_z(port_l_z),
        .h_x(port_h_x),
        .h_y(port_h_y),
        .h_z(port_h_z),
        .n_x(port_n_x),
        .n_y(port_n_y),
        .n_z(port_n_z),
        .t_x(port_t_x),
        .t_y(port_t_y),
        .t_z(port_t_z),
        .b_x(port_b_x),
        .b_y(port_b_y),
        .b_z(port_b_z),
        .p_x(port_p_x),
        .p_y(port_p_y),
        .p_z(port_p_z),
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
    reg signed [1:-16] next_l_x;
    reg signed [1:-16] next_l_y;
    reg signed [1:-16] next_l_z;
    reg signed [1:-16] next_h_x;
    reg signed [1:-16] next_h_y;
    reg signed [1:-16] next_h_z;
    reg signed [1:-16] next_n_x;
    reg signed [1:-16] next_n_y;
    reg signed [1:-16] next_n_z;
    reg signed [1:-16] next_t_x;
    reg signed [1:-16] next_t_y;
    reg signed [1:-16] next_t_z;
    reg signed [1:-16] next_b_x;
    reg signed [1:-16] next_b_y;
    reg signed [1:-16] next_b_z;
    reg signed [1:-16] next_p_x;
    reg signed [1:-16] next_p_y;
    reg signed [1:-16] next_p_z;
    reg [-1:-16] next_intensity;
    reg [-1:-16] next_diffuse;
    reg [-1:-16] next_specular;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("ernst_tb.vcd");
            $dumpvars(0, ernst_tb);
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
            file = $fopen("ernst_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: ernst_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_l_x, next_l_y, next_l_z, next_h_x, next_h_y, next_h_z, next_n_x, next_n_y, next_n_z, next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_p_x, next_p_y, next_p_z, next_intensity, next_diffuse, next_specular);
            more = fields == 21;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: ernst_vectors.txt is cut short after vector %0d", sent);
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
                port_l_x <= valid[0] ? next_l_x : 18'bx;
                port_l_y <= valid[0] ? next_l_y : 18'bx;
                port_l_z <= valid[0] ? next_l_z : 18'bx;
                port_h_x <= valid[0] ? next_h_x : 18'bx;
                port_h_y <= valid[0] ? next_h_y : 18'bx;
                port_h_z <= valid[0] ? next_h_z : 18'bx;
                port_n_x <= valid[0] ? next_n_x : 18'bx;
                port_n_y <= valid[0] ? next_n_y : 18'bx;
                port_n_z <= valid[0] ? next_n_z : 18'bx;
                port_t_x <= valid[0] ? next_t_x : 18'bx;
                port_t_y <= valid[0] ? next_t_y : 18'bx;
                port_t_z <= valid[0] ? next_t_z : 18'bx;
                port_b_x <= valid[0] ? next_b_x : 18'bx;
                port_b_y <= valid[0] ? next_b_y : 18'bx;
                port_b_z <= valid[0] ? next_b_z : 18'bx;
                port_p_x <= valid[0] ? next_p_x : 18'bx;
                port_p_y <= valid[0] ? next_p_y : 18'bx;
                port_p_z <= valid[0] ? next_p_z : 18'bx;
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
                $display("mismatch: ernst_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
