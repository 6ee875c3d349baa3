// rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
// made by fixpath 0.1.0; the inverse square root unit of seed 000 (US 6,980,218, FIG. 8)
//   input_bits=20 input_frac_bits=18 root_int_bits=9 root_scheme=newton root_addr_bits=7
//   root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 10 cycles, interval 1 cycle; tables read on the clock
// errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   r_relative: mean 1.31e-5, largest seen 9.11e-5 over the result, at a=4
//   r_scaled: mean 1.23e-5, largest seen 9.11e-5 over the result, or 1 where it is less, at a=4
//   r: mean 1.52e-3, largest seen 4.66e-2 (12223.0 ulp) at a=1
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at a=155754
// stated bound on each relative (over the result): 3.78e-4
// stated bound on each scaled (over the result, or 1 where it is less): 3.76e-4
// stated bound on each absolute: 1.91e-1
// stated bound on each flag: 0.00e0
module rsqrt_newton (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [1:-18] a, // u20f18
    output wire valid_out,
    output reg  [8:-18] r, // u27f18
    output reg  degenerate // u1f0
);

    // table recip_root: recip_sqrt u12f10
    (* rom_style = "block" *)
    reg [11:0] recip_root_rom [0:127];
    initial begin
        recip_root_rom[0] = 12'h7f0; recip_root_rom[1] = 12'h7d2; recip_root_rom[2] = 12'h7b5; recip_root_rom[3] = 12'h799;
        recip_root_rom[4] = 12'h77e; recip_root_rom[5] = 12'h764; recip_root_rom[6] = 12'h74b; recip_root_rom[7] = 12'h733;
        recip_root_rom[8] = 12'h71d; recip_root_rom[9] = 12'h706; recip_root_rom[10] = 12'h6f1; recip_root_rom[11] = 12'h6dd;
        recip_root_rom[12] = 12'h6c9; recip_root_rom[13] = 12'h6b6; recip_root_rom[14] = 12'h6a3; recip_root_rom[15] = 12'h691;
        recip_root_rom[16] = 12'h680; recip_root_rom[17] = 12'h66f; recip_root_rom[18] = 12'h65e; recip_root_rom[19] = 12'h64e;
        recip_root_rom[20] = 12'h63f; recip_root_rom[21] = 12'h630; recip_root_rom[22] = 12'h621; recip_root_rom[23] = 12'h613;
        recip_root_rom[24] = 12'h605; recip_root_rom[25] = 12'h5f8; recip_root_rom[26] = 12'h5eb; recip_root_rom[27] = 12'h5de;
        recip_root_rom[28] = 12'h5d1; recip_root_rom[29] = 12'h5c5; recip_root_rom[30] = 12'h5b9; recip_root_rom[31] = 12'h5ae;
        recip_root_rom[32] = 12'h5a3; recip_root_rom[33] = 12'h598; recip_root_rom[34] = 12'h58d; recip_root_rom[35] = 12'h582;
        recip_root_rom[36] = 12'h578; recip_root_rom[37] = 12'h56e; recip_root_rom[38] = 12'h564; recip_root_rom[39] = 12'h55a;
        recip_root_rom[40] = 12'h551; recip_root_rom[41] = 12'h547; recip_root_rom[42] = 12'h53e; recip_root_rom[43] = 12'h535;
        recip_root_rom[44] = 12'h52d; recip_root_rom[45] = 12'h524; recip_root_rom[46] = 12'h51c; recip_root_rom[47] = 12'h513;
        recip_root_rom[48] = 12'h50b; recip_root_rom[49] = 12'h503; recip_root_rom[50] = 12'h4fc; recip_root_rom[51] = 12'h4f4;
        recip_root_rom[52] = 12'h4ec; recip_root_rom[53] = 12'h4e5; recip_root_rom[54] = 12'h4de; recip_root_rom[55] = 12'h4d7;
        recip_root_rom[56] = 12'h4d0; recip_root_rom[57] = 12'h4c9; recip_root_rom[58] = 12'h4c2; recip_root_rom[59] = 12'h4bb;
        recip_root_rom[60] = 12'h4b5; recip_root_rom[61] = 12'h4ae; recip_root_rom[62] = 12'h4a8; recip_root_rom[63] = 12'h4a2;
        recip_root_rom[64] = 12'h49b; recip_root_rom[65] = 12'h495; recip_root_rom[66] = 12'h48f; recip_root_rom[67] = 12'h489;
        recip_root_rom[68] = 12'h484; recip_root_rom[69] = 12'h47e; recip_root_rom[70] = 12'h478; recip_root_rom[71] = 12'h473;
        recip_root_rom[72] = 12'h46d; recip_root_rom[73] = 12'h468; recip_root_rom[74] = 12'h463; recip_root_rom[75] = 12'h45d;
        recip_root_rom[76] = 12'h458; recip_root_rom[77] = 12'h453; recip_root_rom[78] = 12'h44e; recip_root_rom[79] = 12'h449;
        recip_root_rom[80] = 12'h444; recip_root_rom[81] = 12'h43f; recip_root_rom[82] = 12'h43b; recip_root_rom[83] = 12'h436;
        recip_root_rom[84] = 12'h431; recip_root_rom[85] = 12'h42d; recip_root_rom[86] = 12'h428; recip_root_rom[87] = 12'h424;
        recip_root_rom[88] = 12'h41f; recip_root_rom[89] = 12'h41b; recip_root_rom[90] = 12'h417; recip_root_rom[91] = 12'h412;
        recip_root_rom[92] = 12'h40e; recip_root_rom[93] = 12'h40a; recip_root_rom[94] = 12'h406; recip_root_rom[95] = 12'h402;
        recip_root_rom[96] = 12'h3fe; recip_root_rom[97] = 12'h3fa; recip_root_rom[98] = 12'h3f6; recip_root_rom[99] = 12'h3f2;
        recip_root_rom[100] = 12'h3ee; recip_root_rom[101] = 12'h3eb; recip_root_rom[102] = 12'h3e7; recip_root_rom[103] = 12'h3e3;
        recip_root_rom[104] = 12'h3e0; recip_root_rom[105] = 12'h3dc; recip_root_rom[106] = 12'h3d8; recip_root_rom[107] = 12'h3d5;
        recip_root_rom[108] = 12'h3d1; recip_root_rom[109] = 12'h3ce; recip_root_rom[110] = 12'h3cb; recip_root_rom[111] = 12'h3c7;
        recip_root_rom[112] = 12'h3c4; recip_root_rom[113] = 12'h3c0; recip_root_rom[114] = 12'h3bd; recip_root_rom[115] = 12'h3ba;
        recip_root_rom[116] = 12'h3b7; recip_root_rom[117] = 12'h3b4; recip_root_rom[118] = 12'h3b0; recip_root_rom[119] = 12'h3ad;
        recip_root_rom[120] = 12'h3aa; recip_root_rom[121] = 12'h3a7; recip_root_rom[122] = 12'h3a4; recip_root_rom[123] = 12'h3a1;
        recip_root_rom[124] = 12'h39e; recip_root_rom[125] = 12'h39b; recip_root_rom[126] = 12'h398; recip_root_rom[127] = 12'h395;
    end

    // ---- stage 0 ----
    // reciprocal_root
    wire [19:0] reciprocal_root_n1 = a; // u20f0
    wire reciprocal_root_n2 = 1'b0; // u1f0
    wire [19:0] reciprocal_root_n3 = reciprocal_root_n1; // u20f0
    wire [15:0] reciprocal_root_n4 = reciprocal_root_n3[19:4]; // u16f0
    wire reciprocal_root_n5 = reciprocal_root_n4 == {15'h0, reciprocal_root_n2}; // u1f0
    wire [3:0] reciprocal_root_n6 = reciprocal_root_n3[3:0]; // u4f0
    wire [15:0] reciprocal_root_n7 = 16'h0; // u16f0
    wire [19:0] reciprocal_root_n8 = {reciprocal_root_n6, reciprocal_root_n7}; // u20f0
    wire [19:0] reciprocal_root_n9 = reciprocal_root_n5 ? reciprocal_root_n8 : reciprocal_root_n3; // u20f0
    wire [7:0] reciprocal_root_n10 = reciprocal_root_n9[19:12]; // u8f0
    wire reciprocal_root_n11 = reciprocal_root_n10 == {7'h0, reciprocal_root_n2}; // u1f0
    wire [11:0] reciprocal_root_n12 = reciprocal_root_n9[11:0]; // u12f0
    wire [7:0] reciprocal_root_n13 = 8'h0; // u8f0
    wire [19:0] reciprocal_root_n14 = {reciprocal_root_n12, reciprocal_root_n13}; // u20f0
    wire [19:0] reciprocal_root_n15 = reciprocal_root_n11 ? reciprocal_root_n14 : reciprocal_root_n9; // u20f0
    wire [3:0] reciprocal_root_n16 = reciprocal_root_n15[19:16]; // u4f0
    wire reciprocal_root_n17 = reciprocal_root_n16 == {3'h0, reciprocal_root_n2}; // u1f0
    wire [15:0] reciprocal_root_n18 = reciprocal_root_n15[15:0]; // u16f0
    wire [3:0] reciprocal_root_n19 = 4'h0; // u4f0
    wire [19:0] reciprocal_root_n20 = {reciprocal_root_n18, reciprocal_root_n19}; // u20f0
    wire [19:0] reciprocal_root_n21 = reciprocal_root_n17 ? reciprocal_root_n20 : reciprocal_root_n15; // u20f0
    wire [1:0] reciprocal_root_n22 = reciprocal_root_n21[19:18]; // u2f0
    wire [17:0] reciprocal_root_n24 = reciprocal_root_n21[17:0]; // u18f0
    wire [1:0] reciprocal_root_n25 = 2'h0; // u2f0
    wire [19:0] reciprocal_root_n26 = {reciprocal_root_n24, reciprocal_root_n25}; // u20f0
    wire [1:0] reciprocal_root_n28 = {reciprocal_root_n5, reciprocal_root_n11}; // u2f0
    wire [2:0] reciprocal_root_n29 = {reciprocal_root_n28, reciprocal_root_n17}; // u3f0
    wire reciprocal_root_n32 = 1'b1; // u1f0
    wire [1:0] reciprocal_root_n45 = 2'h3; // u2f0
    wire reciprocal_root_n53 = 1'b1; // u1e9
    wire reciprocal_root_n54 = a == {1'b0, reciprocal_root_n2, 18'h0}; // u1f0

    reg [19:0] reciprocal_root_n21_s1; // u20f0
    reg [1:0] reciprocal_root_n22_s1; // u2f0
    reg [19:0] reciprocal_root_n26_s1; // u20f0
    reg [2:0] reciprocal_root_n29_s1; // u3f0
    reg reciprocal_root_n54_s1; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n21_s1 <= reciprocal_root_n21;
            reciprocal_root_n22_s1 <= reciprocal_root_n22;
            reciprocal_root_n26_s1 <= reciprocal_root_n26;
            reciprocal_root_n29_s1 <= reciprocal_root_n29;
            reciprocal_root_n54_s1 <= reciprocal_root_n54;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // reciprocal_root
    wire reciprocal_root_n23 = reciprocal_root_n22_s1 == {1'b0, reciprocal_root_n2}; // u1f0
    wire [19:0] reciprocal_root_n27 = reciprocal_root_n23 ? reciprocal_root_n26_s1 : reciprocal_root_n21_s1; // u20f0
    wire [3:0] reciprocal_root_n30 = {reciprocal_root_n29_s1, reciprocal_root_n23}; // u4f0
    wire [1:0] reciprocal_root_n31 = reciprocal_root_n27[19:18]; // u2f0
    wire signed [2:0] reciprocal_root_n33 = {1'b0, reciprocal_root_n31} - {2'h0, reciprocal_root_n32}; // s3f0
    wire [1:0] reciprocal_root_n34 = reciprocal_root_n33[1:0]; // u2f0
    wire [17:0] reciprocal_root_n35 = reciprocal_root_n27[17:0]; // u18f0
    wire [19:0] reciprocal_root_n36 = reciprocal_root_n27; // u20f0
    wire [-1:-20] reciprocal_root_n37 = reciprocal_root_n36; // u20f20
    wire [19:0] reciprocal_root_n38 = {reciprocal_root_n34, reciprocal_root_n35}; // u20f0
    wire [-1:-20] reciprocal_root_n39 = reciprocal_root_n38; // u20f20
    // reciprocal_root.recip_root
    wire [6:0] reciprocal_root_recip_root_n40 = reciprocal_root_n39[-1:-7]; // u7f0

    reg [3:0] reciprocal_root_n30_s2; // u4f0
    reg [-1:-20] reciprocal_root_n37_s2; // u20f20
    reg [11:0] recip_root_row;
    reg reciprocal_root_n54_s2; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s2 <= reciprocal_root_n30;
            reciprocal_root_n37_s2 <= reciprocal_root_n37;
            recip_root_row <= recip_root_rom[reciprocal_root_recip_root_n40];
            reciprocal_root_n54_s2 <= reciprocal_root_n54_s1;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // reciprocal_root.recip_root
    wire [1:-10] reciprocal_root_recip_root_n41 = recip_root_row; // u12f10

    reg [3:0] reciprocal_root_n30_s3; // u4f0
    reg [-1:-20] reciprocal_root_n37_s3; // u20f20
    reg [1:-10] reciprocal_root_recip_root_n41_s3; // u12f10
    reg reciprocal_root_n54_s3; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s3 <= reciprocal_root_n30_s2;
            reciprocal_root_n37_s3 <= reciprocal_root_n37_s2;
            reciprocal_root_recip_root_n41_s3 <= reciprocal_root_recip_root_n41;
            reciprocal_root_n54_s3 <= reciprocal_root_n54_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // reciprocal_root
    wire [1:-30] reciprocal_root_n42 = reciprocal_root_n37_s3 * reciprocal_root_recip_root_n41_s3; // u32f30

    reg [3:0] reciprocal_root_n30_s4; // u4f0
    reg [1:-10] reciprocal_root_recip_root_n41_s4; // u12f10
    reg [1:-30] reciprocal_root_n42_s4; // u32f30
    reg reciprocal_root_n54_s4; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s4 <= reciprocal_root_n30_s3;
            reciprocal_root_recip_root_n41_s4 <= reciprocal_root_recip_root_n41_s3;
            reciprocal_root_n42_s4 <= reciprocal_root_n42;
            reciprocal_root_n54_s4 <= reciprocal_root_n54_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // reciprocal_root
    wire [2:-30] reciprocal_root_n43_sum = {1'b0, reciprocal_root_n42_s4} + 33'h200;
    wire [2:-20] reciprocal_root_n43_cut = reciprocal_root_n43_sum[2:-20];
    wire reciprocal_root_n43_over = |reciprocal_root_n43_cut[2];
    wire [1:-20] reciprocal_root_n43 = reciprocal_root_n43_over ? 22'h3fffff : reciprocal_root_n43_cut[1:-20]; // u22f20

    reg [3:0] reciprocal_root_n30_s5; // u4f0
    reg [1:-10] reciprocal_root_recip_root_n41_s5; // u12f10
    reg [1:-20] reciprocal_root_n43_s5; // u22f20
    reg reciprocal_root_n54_s5; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s5 <= reciprocal_root_n30_s4;
            reciprocal_root_recip_root_n41_s5 <= reciprocal_root_recip_root_n41_s4;
            reciprocal_root_n43_s5 <= reciprocal_root_n43;
            reciprocal_root_n54_s5 <= reciprocal_root_n54_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // reciprocal_root
    wire [3:-30] reciprocal_root_n44 = reciprocal_root_n43_s5 * reciprocal_root_recip_root_n41_s5; // u34f30

    reg [3:0] reciprocal_root_n30_s6; // u4f0
    reg [1:-10] reciprocal_root_recip_root_n41_s6; // u12f10
    reg [3:-30] reciprocal_root_n44_s6; // u34f30
    reg reciprocal_root_n54_s6; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s6 <= reciprocal_root_n30_s5;
            reciprocal_root_recip_root_n41_s6 <= reciprocal_root_recip_root_n41_s5;
            reciprocal_root_n44_s6 <= reciprocal_root_n44;
            reciprocal_root_n54_s6 <= reciprocal_root_n54_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // reciprocal_root
    wire signed [4:-30] reciprocal_root_n46 = {3'h0, reciprocal_root_n45, 30'h0} - {1'b0, reciprocal_root_n44_s6}; // s35f30
    wire signed [5:-30] reciprocal_root_n47_sum = {reciprocal_root_n46[4], reciprocal_root_n46} + 36'h200;
    wire signed [5:-20] reciprocal_root_n47_cut = reciprocal_root_n47_sum[5:-20];
    wire reciprocal_root_n47_over = ~reciprocal_root_n47_cut[5] & (|reciprocal_root_n47_cut[4:2]);
    wire reciprocal_root_n47_under = reciprocal_root_n47_cut[5];
    wire [1:-20] reciprocal_root_n47 = reciprocal_root_n47_over ? 22'h3fffff : reciprocal_root_n47_under ? 22'h0 : reciprocal_root_n47_cut[1:-20]; // u22f20

    reg [3:0] reciprocal_root_n30_s7; // u4f0
    reg [1:-10] reciprocal_root_recip_root_n41_s7; // u12f10
    reg [1:-20] reciprocal_root_n47_s7; // u22f20
    reg reciprocal_root_n54_s7; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s7 <= reciprocal_root_n30_s6;
            reciprocal_root_recip_root_n41_s7 <= reciprocal_root_recip_root_n41_s6;
            reciprocal_root_n47_s7 <= reciprocal_root_n47;
            reciprocal_root_n54_s7 <= reciprocal_root_n54_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // reciprocal_root
    wire [3:-30] reciprocal_root_n48 = reciprocal_root_recip_root_n41_s7 * reciprocal_root_n47_s7; // u34f30
    wire [2:-31] reciprocal_root_n49 = reciprocal_root_n48; // u34f31

    reg [3:0] reciprocal_root_n30_s8; // u4f0
    reg [2:-31] reciprocal_root_n49_s8; // u34f31
    reg reciprocal_root_n54_s8; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s8 <= reciprocal_root_n30_s7;
            reciprocal_root_n49_s8 <= reciprocal_root_n49;
            reciprocal_root_n54_s8 <= reciprocal_root_n54_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // reciprocal_root
    wire [3:-31] reciprocal_root_n50_sum = {1'b0, reciprocal_root_n49_s8} + 35'h400;
    wire [3:-20] reciprocal_root_n50_cut = reciprocal_root_n50_sum[3:-20];
    wire reciprocal_root_n50_over = |reciprocal_root_n50_cut[3:2];
    wire [1:-20] reciprocal_root_n50 = reciprocal_root_n50_over ? 22'h3fffff : reciprocal_root_n50_cut[1:-20]; // u22f20
    wire reciprocal_root_n51_past = 4'ha < reciprocal_root_n30_s8;
    wire [3:0] reciprocal_root_n51_count = reciprocal_root_n51_past ? 4'ha : reciprocal_root_n30_s8;
    wire [11:-20] reciprocal_root_n51 = {10'h0, reciprocal_root_n50} << reciprocal_root_n51_count; // u32f20
    wire [10:-21] reciprocal_root_n52 = reciprocal_root_n51; // u32f21
    wire [10:-21] reciprocal_root_n55 = reciprocal_root_n54_s8 ? {1'b0, reciprocal_root_n53, 30'h0} : reciprocal_root_n52; // u32f21

    reg reciprocal_root_n54_s9; // u1f0
    reg [10:-21] reciprocal_root_n55_s9; // u32f21
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n54_s9 <= reciprocal_root_n54_s8;
            reciprocal_root_n55_s9 <= reciprocal_root_n55;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // reciprocal_root
    wire [11:-21] reciprocal_root_n56_sum = {1'b0, reciprocal_root_n55_s9} + 33'h4;
    wire [11:-18] reciprocal_root_n56_cut = reciprocal_root_n56_sum[11:-18];
    wire reciprocal_root_n56_over = |reciprocal_root_n56_cut[11:9];
    wire [8:-18] reciprocal_root_n56 = reciprocal_root_n56_over ? 27'h7ffffff : reciprocal_root_n56_cut[8:-18]; // u27f18
    // (unit)
    wire [8:-18] n57 = reciprocal_root_n54_s9 ? {8'h0, reciprocal_root_n2, 18'h0} : reciprocal_root_n56; // u27f18

    always @(posedge clk)
        if (ce) begin
            degenerate <= reciprocal_root_n54_s9;
            r <= n57;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;
    assign valid_out = valid_s10;

    // ---- stage 10 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        reciprocal_root_n33[2],
        reciprocal_root_n39[-8:-20],
        reciprocal_root_n43_sum[-21:-30],
        reciprocal_root_n47_sum[-21:-30],
        reciprocal_root_n50_sum[-21:-31],
        reciprocal_root_n56_sum[-19:-21]};
endmodule
