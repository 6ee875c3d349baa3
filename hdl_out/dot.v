// dot: dot product of three: exact products and sums, one rounding
// made by fixpath 0.1.0; the vector dot units of seed 000 (US 6,980,218, FIG. 8), in formats of any width
//   v_bits=16 v_frac_bits=14 w_bits=16 w_frac_bits=14 out_bits=24 out_frac_bits=18
//   overflow=saturate rounding=half-up period_ps=5000 stages=auto rom=block
// latency 3 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   dot_product: mean 9.56e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-62 v_y=-9 v_z=-2277 w_x=-2863 w_y=-7 w_z=13
// stated bound on each result: 1.91e-6
module dot (
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
    output reg  signed [5:-18] dot_product // s24f18
);

    // ---- stage 0 ----
    // v_dot_w
    wire signed [3:-28] v_dot_w_n6 = v_x * w_x; // s32f28
    wire signed [3:-28] v_dot_w_n7 = v_y * w_y; // s32f28
    wire signed [3:-28] v_dot_w_n8 = v_z * w_z; // s32f28

    reg signed [3:-28] v_dot_w_n6_s1; // s32f28
    reg signed [3:-28] v_dot_w_n7_s1; // s32f28
    reg signed [3:-28] v_dot_w_n8_s1; // s32f28
    always @(posedge clk)
        if (ce) begin
            v_dot_w_n6_s1 <= v_dot_w_n6;
            v_dot_w_n7_s1 <= v_dot_w_n7;
            v_dot_w_n8_s1 <= v_dot_w_n8;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // v_dot_w
    wire signed [4:-28] v_dot_w_n9 = {v_dot_w_n6_s1[3], v_dot_w_n6_s1} + {v_dot_w_n7_s1[3], v_dot_w_n7_s1}; // s33f28
    wire signed [5:-28] v_dot_w_n10 = {v_dot_w_n9[4], v_dot_w_n9} + {{2{v_dot_w_n8_s1[3]}}, v_dot_w_n8_s1}; // s34f28

    reg signed [5:-28] v_dot_w_n10_s2; // s34f28
    always @(posedge clk)
        if (ce) begin
            v_dot_w_n10_s2 <= v_dot_w_n10;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    wire signed [6:-28] n11_sum = {v_dot_w_n10_s2[5], v_dot_w_n10_s2} + 35'h200;
    wire signed [6:-18] n11_cut = n11_sum[6:-18];
    wire n11_over = ~n11_cut[6] & (|n11_cut[5]);
    wire signed [5:-18] n11 = n11_over ? 24'h7fffff : n11_cut[5:-18]; // s24f18

    always @(posedge clk)
        if (ce) begin
            dot_product <= n11;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;
    assign valid_out = valid_s3;

    // ---- stage 3 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        n11_sum[-19:-28]};
endmodule
