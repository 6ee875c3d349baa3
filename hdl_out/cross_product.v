// cross_product: cross product: six exact products, three differences, one rounding each
// made by fixpath 0.1.0; seed 002 (GL_NV_texgen_emboss): B = N x CT, T = BN x N; in formats of any width
//   v_bits=16 v_frac_bits=14 w_bits=16 w_frac_bits=14 out_bits=24 out_frac_bits=18
//   overflow=saturate rounding=half-up period_ps=5000 stages=auto rom=block
// latency 2 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   x: mean 9.48e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=20649 v_y=-26028 v_z=2820 w_x=-23798 w_y=-24668 w_z=-11884
//   y: mean 9.45e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-21854 v_y=9541 v_z=17626 w_x=-14940 w_y=-27950 w_z=-11372
//   z: mean 9.46e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-23936 v_y=12028 v_z=-25780 w_x=-29216 w_y=23561 w_z=-20909
// stated bound on each result: 1.91e-6
module cross_product (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [1:-14] v_x, // s16f14
    input  wire signed [1:-14] v_y, // s16f14
    input  wire signed [1:-14] v_z, // s16f14
    input  wire signed [1:-14] w_x, // s16f14
    input  wire signed [1:-14] w_y, // s16f14
    input  wire signed [1:-14] w_z, // s16f14
    output wire valid_out,
    output reg  signed [5:-18] x, // s24f18
    output reg  signed [5:-18] y, // s24f18
    output reg  signed [5:-18] z // s24f18
);

    // ---- stage 0 ----
    // products
    wire signed [3:-28] products_n6 = v_y * w_z; // s32f28
    wire signed [3:-28] products_n7 = v_z * w_y; // s32f28
    wire signed [3:-28] products_n9 = v_z * w_x; // s32f28
    wire signed [3:-28] products_n10 = v_x * w_z; // s32f28
    wire signed [3:-28] products_n12 = v_x * w_y; // s32f28
    wire signed [3:-28] products_n13 = v_y * w_x; // s32f28

    reg signed [3:-28] products_n6_s1; // s32f28
    reg signed [3:-28] products_n7_s1; // s32f28
    reg signed [3:-28] products_n9_s1; // s32f28
    reg signed [3:-28] products_n10_s1; // s32f28
    reg signed [3:-28] products_n12_s1; // s32f28
    reg signed [3:-28] products_n13_s1; // s32f28
    always @(posedge clk)
        if (ce) begin
            products_n6_s1 <= products_n6;
            products_n7_s1 <= products_n7;
            products_n9_s1 <= products_n9;
            products_n10_s1 <= products_n10;
            products_n12_s1 <= products_n12;
            products_n13_s1 <= products_n13;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // products
    wire signed [4:-28] products_n8 = {products_n6_s1[3], products_n6_s1} - {products_n7_s1[3], products_n7_s1}; // s33f28
    wire signed [4:-28] products_n11 = {products_n9_s1[3], products_n9_s1} - {products_n10_s1[3], products_n10_s1}; // s33f28
    wire signed [4:-28] products_n14 = {products_n12_s1[3], products_n12_s1} - {products_n13_s1[3], products_n13_s1}; // s33f28
    // (unit)
    wire signed [5:-28] n15_sum = {products_n8[4], products_n8} + 34'h200;
    wire signed [5:-18] n15_cut = n15_sum[5:-18];
    wire signed [5:-18] n15 = n15_cut; // s24f18
    wire signed [5:-28] n16_sum = {products_n11[4], products_n11} + 34'h200;
    wire signed [5:-18] n16_cut = n16_sum[5:-18];
    wire signed [5:-18] n16 = n16_cut; // s24f18
    wire signed [5:-28] n17_sum = {products_n14[4], products_n14} + 34'h200;
    wire signed [5:-18] n17_cut = n17_sum[5:-18];
    wire signed [5:-18] n17 = n17_cut; // s24f18

    always @(posedge clk)
        if (ce) begin
            x <= n15;
            y <= n16;
            z <= n17;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;
    assign valid_out = valid_s2;

    // ---- stage 2 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        n15_sum[-19:-28],
        n16_sum[-19:-28],
        n17_sum[-19:-28]};
endmodule
