// normalise: block normalisation: three words shifted by the leading zeros of the largest
// made by fixpath 0.1.0; the light vector of seed 000 (US 6,980,218) in fixed point: a displacement doesn't depend on its length
//   v_bits=16 v_frac_bits=8 norm_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 2 cycles, interval 1 cycle; no tables
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   x: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   y: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   z: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   places: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
// stated bound on each component: 7.63e-6
// stated bound on each count and flag: 0.00e0
module normalise (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [7:-8] v_x, // s16f8
    input  wire signed [7:-8] v_y, // s16f8
    input  wire signed [7:-8] v_z, // s16f8
    output wire valid_out,
    output reg  signed [0:-17] x, // s18f17
    output reg  signed [0:-17] y, // s18f17
    output reg  signed [0:-17] z, // s18f17
    output reg  [3:0] places, // u4f0
    output reg  degenerate // u1f0
);

    // ---- stage 0 ----
    // block
    wire [7:-8] block_n3_neg = -v_x;
    wire [7:-8] block_n3 = v_x[7] ? block_n3_neg : v_x; // u16f8
    wire [15:0] block_n4 = block_n3; // u16f0
    wire [7:-8] block_n5_neg = -v_y;
    wire [7:-8] block_n5 = v_y[7] ? block_n5_neg : v_y; // u16f8
    wire [15:0] block_n6 = block_n5; // u16f0
    wire [7:-8] block_n7_neg = -v_z;
    wire [7:-8] block_n7 = v_z[7] ? block_n7_neg : v_z; // u16f8
    wire [15:0] block_n8 = block_n7; // u16f0
    wire [15:0] block_n9 = block_n4 | block_n6; // u16f0
    wire [15:0] block_n10 = block_n9 | block_n8; // u16f0
    wire [7:-8] block_largest = block_n10; // u16f8
    wire block_n12 = 1'b0; // u1f0
    wire [15:0] block_n13 = block_largest; // u16f0
    wire [7:0] block_n14 = block_n13[15:8]; // u8f0
    wire block_n15 = block_n14 == {7'h0, block_n12}; // u1f0
    wire [7:0] block_n16 = block_n13[7:0]; // u8f0
    wire [7:0] block_n17 = 8'h0; // u8f0
    wire [15:0] block_n18 = {block_n16, block_n17}; // u16f0
    wire [15:0] block_n19 = block_n15 ? block_n18 : block_n13; // u16f0
    wire [3:0] block_n20 = block_n19[15:12]; // u4f0
    wire block_n21 = block_n20 == {3'h0, block_n12}; // u1f0
    wire [11:0] block_n22 = block_n19[11:0]; // u12f0
    wire [3:0] block_n23 = 4'h0; // u4f0
    wire [15:0] block_n24 = {block_n22, block_n23}; // u16f0
    wire [15:0] block_n25 = block_n21 ? block_n24 : block_n19; // u16f0
    wire [1:0] block_n26 = block_n25[15:14]; // u2f0
    wire [13:0] block_n28 = block_n25[13:0]; // u14f0
    wire [1:0] block_n29 = 2'h0; // u2f0
    wire [15:0] block_n30 = {block_n28, block_n29}; // u16f0
    wire [1:0] block_n34 = {block_n15, block_n21}; // u2f0
    wire block_n37 = block_largest == {7'h0, block_n12, 8'h0}; // u1f0
    wire block_n38 = v_x[7]; // u1f0
    wire [15:0] block_n39 = v_x; // u16f0
    wire [16:0] block_n40 = {block_n38, block_n39}; // u17f0
    wire [8:0] block_n42 = block_n40[8:0]; // u9f0
    wire [16:0] block_n43 = {block_n42, block_n17}; // u17f0
    wire block_n59 = v_y[7]; // u1f0
    wire [15:0] block_n60 = v_y; // u16f0
    wire [16:0] block_n61 = {block_n59, block_n60}; // u17f0
    wire [8:0] block_n62 = block_n61[8:0]; // u9f0
    wire [16:0] block_n63 = {block_n62, block_n17}; // u17f0
    wire block_n76 = v_z[7]; // u1f0
    wire [15:0] block_n77 = v_z; // u16f0
    wire [16:0] block_n78 = {block_n76, block_n77}; // u17f0
    wire [8:0] block_n79 = block_n78[8:0]; // u9f0
    wire [16:0] block_n80 = {block_n79, block_n17}; // u17f0

    reg [15:0] block_n25_s1; // u16f0
    reg [1:0] block_n26_s1; // u2f0
    reg [15:0] block_n30_s1; // u16f0
    reg [1:0] block_n34_s1; // u2f0
    reg block_n37_s1; // u1f0
    reg [16:0] block_n40_s1; // u17f0
    reg [16:0] block_n43_s1; // u17f0
    reg [16:0] block_n61_s1; // u17f0
    reg [16:0] block_n63_s1; // u17f0
    reg [16:0] block_n78_s1; // u17f0
    reg [16:0] block_n80_s1; // u17f0
    always @(posedge clk)
        if (ce) begin
            block_n25_s1 <= block_n25;
            block_n26_s1 <= block_n26;
            block_n30_s1 <= block_n30;
            block_n34_s1 <= block_n34;
            block_n37_s1 <= block_n37;
            block_n40_s1 <= block_n40;
            block_n43_s1 <= block_n43;
            block_n61_s1 <= block_n61;
            block_n63_s1 <= block_n63;
            block_n78_s1 <= block_n78;
            block_n80_s1 <= block_n80;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // block
    wire block_n27 = block_n26_s1 == {1'b0, block_n12}; // u1f0
    wire [15:0] block_n31 = block_n27 ? block_n30_s1 : block_n25_s1; // u16f0
    wire block_n32 = block_n31[15]; // u1f0
    wire block_n33 = block_n32 == block_n12; // u1f0
    wire [2:0] block_n35 = {block_n34_s1, block_n27}; // u3f0
    wire [3:0] block_places = {block_n35, block_n33}; // u4f0
    wire block_n41 = block_places[3]; // u1f0
    wire [16:0] block_n44 = block_n41 ? block_n43_s1 : block_n40_s1; // u17f0
    wire block_n45 = block_places[2]; // u1f0
    wire [12:0] block_n46 = block_n44[12:0]; // u13f0
    wire [16:0] block_n47 = {block_n46, block_n23}; // u17f0
    wire [16:0] block_n48 = block_n45 ? block_n47 : block_n44; // u17f0
    wire block_n49 = block_places[1]; // u1f0
    wire [14:0] block_n50 = block_n48[14:0]; // u15f0
    wire [16:0] block_n51 = {block_n50, block_n29}; // u17f0
    wire [16:0] block_n52 = block_n49 ? block_n51 : block_n48; // u17f0
    wire block_n53 = block_places[0]; // u1f0
    wire [15:0] block_n54 = block_n52[15:0]; // u16f0
    wire [16:0] block_n55 = {block_n54, block_n12}; // u17f0
    wire [16:0] block_n56 = block_n53 ? block_n55 : block_n52; // u17f0
    wire signed [16:0] block_n57 = block_n56; // s17f0
    wire signed [0:-16] block_x = block_n57; // s17f16
    wire [16:0] block_n64 = block_n41 ? block_n63_s1 : block_n61_s1; // u17f0
    wire [12:0] block_n65 = block_n64[12:0]; // u13f0
    wire [16:0] block_n66 = {block_n65, block_n23}; // u17f0
    wire [16:0] block_n67 = block_n45 ? block_n66 : block_n64; // u17f0
    wire [14:0] block_n68 = block_n67[14:0]; // u15f0
    wire [16:0] block_n69 = {block_n68, block_n29}; // u17f0
    wire [16:0] block_n70 = block_n49 ? block_n69 : block_n67; // u17f0
    wire [15:0] block_n71 = block_n70[15:0]; // u16f0
    wire [16:0] block_n72 = {block_n71, block_n12}; // u17f0
    wire [16:0] block_n73 = block_n53 ? block_n72 : block_n70; // u17f0
    wire signed [16:0] block_n74 = block_n73; // s17f0
    wire signed [0:-16] block_y = block_n74; // s17f16
    wire [16:0] block_n81 = block_n41 ? block_n80_s1 : block_n78_s1; // u17f0
    wire [12:0] block_n82 = block_n81[12:0]; // u13f0
    wire [16:0] block_n83 = {block_n82, block_n23}; // u17f0
    wire [16:0] block_n84 = block_n45 ? block_n83 : block_n81; // u17f0
    wire [14:0] block_n85 = block_n84[14:0]; // u15f0
    wire [16:0] block_n86 = {block_n85, block_n29}; // u17f0
    wire [16:0] block_n87 = block_n49 ? block_n86 : block_n84; // u17f0
    wire [15:0] block_n88 = block_n87[15:0]; // u16f0
    wire [16:0] block_n89 = {block_n88, block_n12}; // u17f0
    wire [16:0] block_n90 = block_n53 ? block_n89 : block_n87; // u17f0
    wire signed [16:0] block_n91 = block_n90; // s17f0
    wire signed [0:-16] block_z = block_n91; // s17f16
    // (unit)
    wire signed [0:-17] norm_x_wide = {block_x, 1'b0};
    wire signed [0:-17] norm_x = norm_x_wide; // s18f17
    wire signed [0:-17] norm_y_wide = {block_y, 1'b0};
    wire signed [0:-17] norm_y = norm_y_wide; // s18f17
    wire signed [0:-17] norm_z_wide = {block_z, 1'b0};
    wire signed [0:-17] norm_z = norm_z_wide; // s18f17
    wire [3:0] n96 = block_n37_s1 ? {3'h0, block_n12} : block_places; // u4f0

    always @(posedge clk)
        if (ce) begin
            degenerate <= block_n37_s1;
            x <= norm_x;
            y <= norm_y;
            z <= norm_z;
            places <= n96;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;
    assign valid_out = valid_s2;

    // ---- stage 2 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        block_n31[14:0]};
endmodule
