// combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
// made by fixpath 0.1.0; seed 000 (US 6,980,218), the texture combination of the emboss; seed 003 has the same text
//   filter=bilinear lights=1 difference=undisplaced-displaced channel_bits=8 fraction_bits=8
//   guard_bits=4 gain_log2=0 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 4 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   out_r: mean 1.94e-1, largest seen 5.91e-1 (0.6 ulp) at h_00=188 h_10=50 h_01=155 h_11=31 h_a=110 h_b=236 d0_00=43 d0_10=113 d0_01=189 d0_11=244 d0_a=153 d0_b=59 r=146 g=32 b=19
//   out_g: mean 1.95e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
//   out_b: mean 1.94e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
// stated bound on each channel: 6.25e-1
module combine (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [7:0] h_00, // u8f0
    input  wire [7:0] h_10, // u8f0
    input  wire [7:0] h_01, // u8f0
    input  wire [7:0] h_11, // u8f0
    input  wire [-1:-8] h_a, // u8f8
    input  wire [-1:-8] h_b, // u8f8
    input  wire [7:0] d0_00, // u8f0
    input  wire [7:0] d0_10, // u8f0
    input  wire [7:0] d0_01, // u8f0
    input  wire [7:0] d0_11, // u8f0
    input  wire [-1:-8] d0_a, // u8f8
    input  wire [-1:-8] d0_b, // u8f8
    input  wire [7:0] r, // u8f0
    input  wire [7:0] g, // u8f0
    input  wire [7:0] b, // u8f0
    output wire valid_out,
    output reg  [7:0] out_r, // u8f0
    output reg  [7:0] out_g, // u8f0
    output reg  [7:0] out_b // u8f0
);

    // ---- stage 0 ----
    // h
    wire signed [8:0] h_n15 = {1'b0, h_10} - {1'b0, h_00}; // s9f0
    wire signed [8:-8] h_n16 = h_n15 * $signed({1'b0, h_a}); // s17f8
    wire signed [9:-8] h_n17 = {2'h0, h_00, 8'h0} + {h_n16[8], h_n16}; // s18f8
    wire signed [8:0] h_n19 = {1'b0, h_11} - {1'b0, h_01}; // s9f0
    wire signed [8:-8] h_n20 = h_n19 * $signed({1'b0, h_a}); // s17f8
    wire signed [9:-8] h_n21 = {2'h0, h_01, 8'h0} + {h_n20[8], h_n20}; // s18f8
    // d0
    wire signed [8:0] d0_n27 = {1'b0, d0_10} - {1'b0, d0_00}; // s9f0
    wire signed [8:-8] d0_n28 = d0_n27 * $signed({1'b0, d0_a}); // s17f8
    wire signed [9:-8] d0_n29 = {2'h0, d0_00, 8'h0} + {d0_n28[8], d0_n28}; // s18f8
    wire signed [8:0] d0_n31 = {1'b0, d0_11} - {1'b0, d0_01}; // s9f0
    wire signed [8:-8] d0_n32 = d0_n31 * $signed({1'b0, d0_a}); // s17f8
    wire signed [9:-8] d0_n33 = {2'h0, d0_01, 8'h0} + {d0_n32[8], d0_n32}; // s18f8
    // (unit)
    wire [7:0] n40 = 8'hff; // u8f0
    wire n43 = 1'b0; // u1f0

    reg [-1:-8] h_b_s1; // u8f8
    reg [-1:-8] d0_b_s1; // u8f8
    reg [7:0] r_s1; // u8f0
    reg [7:0] g_s1; // u8f0
    reg [7:0] b_s1; // u8f0
    reg signed [9:-8] h_n17_s1; // s18f8
    reg signed [9:-8] h_n21_s1; // s18f8
    reg signed [9:-8] d0_n29_s1; // s18f8
    reg signed [9:-8] d0_n33_s1; // s18f8
    always @(posedge clk)
        if (ce) begin
            h_b_s1 <= h_b;
            d0_b_s1 <= d0_b;
            r_s1 <= r;
            g_s1 <= g;
            b_s1 <= b;
            h_n17_s1 <= h_n17;
            h_n21_s1 <= h_n21;
            d0_n29_s1 <= d0_n29;
            d0_n33_s1 <= d0_n33;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // h
    wire signed [10:-8] h_n18_sum = {h_n17_s1[9], h_n17_s1} + 19'h8;
    wire signed [10:-4] h_n18_cut = h_n18_sum[10:-4];
    wire [7:-4] h_n18 = h_n18_cut[7:-4]; // u12f4
    wire signed [10:-8] h_n22_sum = {h_n21_s1[9], h_n21_s1} + 19'h8;
    wire signed [10:-4] h_n22_cut = h_n22_sum[10:-4];
    wire [7:-4] h_n22 = h_n22_cut[7:-4]; // u12f4
    wire signed [8:-4] h_n23 = {1'b0, h_n22} - {1'b0, h_n18}; // s13f4
    wire signed [8:-12] h_n24 = h_n23 * $signed({1'b0, h_b_s1}); // s21f12
    // d0
    wire signed [10:-8] d0_n30_sum = {d0_n29_s1[9], d0_n29_s1} + 19'h8;
    wire signed [10:-4] d0_n30_cut = d0_n30_sum[10:-4];
    wire [7:-4] d0_n30 = d0_n30_cut[7:-4]; // u12f4
    wire signed [10:-8] d0_n34_sum = {d0_n33_s1[9], d0_n33_s1} + 19'h8;
    wire signed [10:-4] d0_n34_cut = d0_n34_sum[10:-4];
    wire [7:-4] d0_n34 = d0_n34_cut[7:-4]; // u12f4
    wire signed [8:-4] d0_n35 = {1'b0, d0_n34} - {1'b0, d0_n30}; // s13f4
    wire signed [8:-12] d0_n36 = d0_n35 * $signed({1'b0, d0_b_s1}); // s21f12

    reg [7:0] r_s2; // u8f0
    reg [7:0] g_s2; // u8f0
    reg [7:0] b_s2; // u8f0
    reg [7:-4] h_n18_s2; // u12f4
    reg signed [8:-12] h_n24_s2; // s21f12
    reg [7:-4] d0_n30_s2; // u12f4
    reg signed [8:-12] d0_n36_s2; // s21f12
    always @(posedge clk)
        if (ce) begin
            r_s2 <= r_s1;
            g_s2 <= g_s1;
            b_s2 <= b_s1;
            h_n18_s2 <= h_n18;
            h_n24_s2 <= h_n24;
            d0_n30_s2 <= d0_n30;
            d0_n36_s2 <= d0_n36;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // h
    wire signed [9:-12] h_n25 = {2'h0, h_n18_s2, 8'h0} + {h_n24_s2[8], h_n24_s2}; // s22f12
    wire signed [10:-12] h_height_sum = {h_n25[9], h_n25} + 23'h80;
    wire signed [10:-4] h_height_cut = h_height_sum[10:-4];
    wire [7:-4] h_height = h_height_cut[7:-4]; // u12f4
    // d0
    wire signed [9:-12] d0_n37 = {2'h0, d0_n30_s2, 8'h0} + {d0_n36_s2[8], d0_n36_s2}; // s22f12
    wire signed [10:-12] d0_height_sum = {d0_n37[9], d0_n37} + 23'h80;
    wire signed [10:-4] d0_height_cut = d0_height_sum[10:-4];
    wire [7:-4] d0_height = d0_height_cut[7:-4]; // u12f4
    // (unit)
    wire signed [8:-4] relief = {1'b0, h_height} - {1'b0, d0_height}; // s13f4
    wire signed [9:-4] n41 = {2'h0, r_s2, 4'h0} + {relief[8], relief}; // s14f4
    wire signed [9:-4] n49 = {2'h0, g_s2, 4'h0} + {relief[8], relief}; // s14f4
    wire signed [9:-4] n56 = {2'h0, b_s2, 4'h0} + {relief[8], relief}; // s14f4

    reg signed [9:-4] n41_s3; // s14f4
    reg signed [9:-4] n49_s3; // s14f4
    reg signed [9:-4] n56_s3; // s14f4
    always @(posedge clk)
        if (ce) begin
            n41_s3 <= n41;
            n49_s3 <= n49;
            n56_s3 <= n56;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    wire signed [10:-4] n42_sum = {n41_s3[9], n41_s3} + 15'h8;
    wire signed [10:0] n42_cut = n42_sum[10:0];
    wire signed [10:0] n42 = n42_cut; // s11f0
    wire n44 = $signed({3'h0, n40}) < n42; // u1f0
    wire n45 = n42[10]; // u1f0
    wire signed [10:0] n46 = n44 ? {3'h0, n40} : n42; // s11f0
    wire signed [10:0] n47 = n45 ? {10'h0, n43} : n46; // s11f0
    wire [7:0] out_r_next = n47[7:0]; // u8f0
    wire signed [10:-4] n50_sum = {n49_s3[9], n49_s3} + 15'h8;
    wire signed [10:0] n50_cut = n50_sum[10:0];
    wire signed [10:0] n50 = n50_cut; // s11f0
    wire n51 = $signed({3'h0, n40}) < n50; // u1f0
    wire n52 = n50[10]; // u1f0
    wire signed [10:0] n53 = n51 ? {3'h0, n40} : n50; // s11f0
    wire signed [10:0] n54 = n52 ? {10'h0, n43} : n53; // s11f0
    wire [7:0] out_g_next = n54[7:0]; // u8f0
    wire signed [10:-4] n57_sum = {n56_s3[9], n56_s3} + 15'h8;
    wire signed [10:0] n57_cut = n57_sum[10:0];
    wire signed [10:0] n57 = n57_cut; // s11f0
    wire n58 = $signed({3'h0, n40}) < n57; // u1f0
    wire n59 = n57[10]; // u1f0
    wire signed [10:0] n60 = n58 ? {3'h0, n40} : n57; // s11f0
    wire signed [10:0] n61 = n59 ? {10'h0, n43} : n60; // s11f0
    wire [7:0] out_b_next = n61[7:0]; // u8f0

    always @(posedge clk)
        if (ce) begin
            out_r <= out_r_next;
            out_g <= out_g_next;
            out_b <= out_b_next;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;
    assign valid_out = valid_s4;

    // ---- stage 4 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        h_n18_sum[-5:-8],
        h_n18_cut[10:8],
        h_n22_sum[-5:-8],
        h_n22_cut[10:8],
        d0_n30_sum[-5:-8],
        d0_n30_cut[10:8],
        d0_n34_sum[-5:-8],
        d0_n34_cut[10:8],
        h_height_sum[-5:-12],
        h_height_cut[10:8],
        d0_height_sum[-5:-12],
        d0_height_cut[10:8],
        n42_sum[-1:-4],
        n47[10:8],
        n50_sum[-1:-4],
        n54[10:8],
        n57_sum[-1:-4],
        n61[10:8]};
endmodule
