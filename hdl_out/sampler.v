// sampler: texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped
// made by fixpath 0.1.0; seed 000 (US 6,980,218), texture look-ups of the emboss; texel centres as in OpenGL
//   filter=bilinear address_s=wrap address_t=wrap int_bits=4 frac_bits=20 log2_width=9
//   log2_height=9 fraction_bits=8 period_ps=5000 stages=auto rom=block
// latency 1 cycle, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   i0: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   i1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   a: mean 1.71e-3, largest seen 3.42e-3 (0.9 ulp) at s=-3629073 t=8031806
//   j0: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   j1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
//   b: mean 1.71e-3, largest seen 3.42e-3 (0.9 ulp) at s=4664360 t=-2354817
// stated bound on each texel: 0.00e0
// stated bound on each fraction: 3.42e-3
module sampler (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [4:-20] s, // s25f20
    input  wire signed [4:-20] t, // s25f20
    output wire valid_out,
    output reg  [8:0] i0, // u9f0
    output reg  [8:0] i1, // u9f0
    output reg  [-1:-8] a, // u8f8
    output reg  [8:0] j0, // u9f0
    output reg  [8:0] j1, // u9f0
    output reg  [-1:-8] b // u8f8
);

    // ---- stage 0 ----
    // u
    wire signed [13:-11] u_n2 = s; // s25f11
    wire u_n3 = 1'b1; // u1f1
    wire signed [14:-11] u_n4 = {u_n2[13], u_n2} - {15'h0, u_n3, 10'h0}; // s26f11
    wire signed [14:0] u_n5_cut = u_n4[14:0];
    wire signed [14:0] u_n5 = u_n5_cut; // s15f0
    wire u_n6 = 1'b1; // u1f0
    wire signed [15:0] u_n7 = {u_n5[14], u_n5} + {15'h0, u_n6}; // s16f0
    wire signed [14:-8] u_position_cut = u_n4[14:-8];
    wire signed [14:-8] u_position = u_position_cut; // s23f8
    wire [-1:-8] u_a = u_position[-1:-8]; // u8f8
    wire [8:0] u_i0 = u_n5[8:0]; // u9f0
    wire [8:0] u_i1 = u_n7[8:0]; // u9f0
    // v
    wire signed [13:-11] v_n12 = t; // s25f11
    wire signed [14:-11] v_n13 = {v_n12[13], v_n12} - {15'h0, u_n3, 10'h0}; // s26f11
    wire signed [14:0] v_n14_cut = v_n13[14:0];
    wire signed [14:0] v_n14 = v_n14_cut; // s15f0
    wire signed [15:0] v_n15 = {v_n14[14], v_n14} + {15'h0, u_n6}; // s16f0
    wire signed [14:-8] v_position_cut = v_n13[14:-8];
    wire signed [14:-8] v_position = v_position_cut; // s23f8
    wire [-1:-8] v_b = v_position[-1:-8]; // u8f8
    wire [8:0] v_j0 = v_n14[8:0]; // u9f0
    wire [8:0] v_j1 = v_n15[8:0]; // u9f0

    always @(posedge clk)
        if (ce) begin
            a <= u_a;
            i0 <= u_i0;
            i1 <= u_i1;
            b <= v_b;
            j0 <= v_j0;
            j1 <= v_j1;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;
    assign valid_out = valid_s1;

    // ---- stage 1 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        u_n4[-9:-11],
        u_n7[15:9],
        u_position[14:0],
        v_n13[-9:-11],
        v_n15[15:9],
        v_position[14:0]};
endmodule
