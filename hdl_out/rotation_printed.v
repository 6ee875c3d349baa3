// rotation: turns a direction in polar form into the frame of a surface normal
// made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
//   variant=printed output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
//   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
//   stages=auto rom=block
// latency 10 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   angle: mean 1.49e0 rad, largest seen 3.14e0 rad at phi_a=15344 theta_a=12973 phi_n=15490 theta_n=26226
//   dot: mean 1.28e0, largest seen 2.00e0 at phi_a=15344 theta_a=12973 phi_n=15490 theta_n=26226
//   x: mean 7.73e-1, largest seen 2.00e0 at phi_a=37985 theta_a=3793 phi_n=38551 theta_n=19699
//   y: mean 5.55e-1, largest seen 1.99e0 at phi_a=65309 theta_a=16773 phi_n=16202 theta_n=27589
//   z: mean 5.94e-1, largest seen 1.99e0 at phi_a=29194 theta_a=9772 phi_n=60747 theta_n=22698
// no bound is stated: asin, 1/sin and 1/cos have infinite slopes, which no word length bounds; each table's own error is stated
module rotation_printed (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [-1:-16] phi_a, // u16f16
    input  wire [-1:-16] theta_a, // u16f16
    input  wire [-1:-16] phi_n, // u16f16
    input  wire [-1:-16] theta_n, // u16f16
    output wire valid_out,
    output reg  [-1:-16] phi, // u16f16
    output reg  [-1:-16] theta // u16f16
);

    // table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom [0:1023];
    initial $readmemh("rotation_printed_sincos.hex", sincos_rom);

    // table asin: asin s18f18
    (* rom_style = "block" *)
    reg [17:0] asin_rom [0:1023];
    initial $readmemh("rotation_printed_asin.hex", asin_rom);

    // table recip_sin: half_recip_sin s27f18
    (* rom_style = "block" *)
    reg [26:0] recip_sin_rom [0:1023];
    initial $readmemh("rotation_printed_recip_sin.hex", recip_sin_rom);

    // table recip_cos: half_recip_cos s27f18
    (* rom_style = "block" *)
    reg [26:0] recip_cos_rom [0:1023];
    initial $readmemh("rotation_printed_recip_cos.hex", recip_cos_rom);

    // table atan: atan s18f18
    (* rom_style = "block" *)
    reg [17:0] atan_rom [0:1023];
    initial $readmemh("rotation_printed_atan.hex", atan_rom);

    // table prop: prop s20f18
    (* rom_style = "block" *)
    reg [19:0] prop_rom [0:1023];
    initial $readmemh("rotation_printed_prop.hex", prop_rom);

    // ---- stage 0 ----
    // angles
    wire signed [0:-16] angles_delta_exact = {1'b0, phi_a} - {1'b0, phi_n}; // s17f16
    wire signed [1:-16] angles_n5 = {2'h0, theta_a} + {angles_delta_exact[0], angles_delta_exact}; // s18f16
    wire signed [0:-17] angles_n6 = angles_n5; // s18f17
    wire signed [1:-16] angles_n7 = {2'h0, theta_a} - {angles_delta_exact[0], angles_delta_exact}; // s18f16
    wire signed [0:-17] angles_n8 = angles_n7; // s18f17
    wire [-1:-17] angles_ang_x = angles_n6[-1:-17]; // u17f17
    wire [-1:-17] angles_ang_y = angles_n8[-1:-17]; // u17f17
    // sincos
    wire [9:0] sincos_n11 = angles_ang_x[-1:-10]; // u10f0
    wire [9:0] sincos_n14 = angles_ang_y[-1:-10]; // u10f0
    // (unit)
    wire [-1:-18] n34 = 18'h20000; // u18f18
    wire n41 = 1'b1; // u1f2

    reg [-1:-16] theta_n_s1; // u16f16
    reg [39:0] sincos_row;
    reg [39:0] sincos_row_2;
    always @(posedge clk)
        if (ce) begin
            theta_n_s1 <= theta_n;
            sincos_row <= sincos_rom[sincos_n11];
            sincos_row_2 <= sincos_rom[sincos_n14];
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // sincos
    wire signed [1:-18] sincos_sin_x = sincos_row[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_x = sincos_row[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_y = sincos_row_2[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_y = sincos_row_2[19:0]; // s20f18
    // (unit)
    wire signed [2:-18] n17 = {sincos_sin_x[1], sincos_sin_x} + {sincos_sin_y[1], sincos_sin_y}; // s21f18
    wire signed [1:-19] n18 = n17; // s21f19
    wire signed [2:-18] y_double = {sincos_cos_y[1], sincos_cos_y} - {sincos_cos_x[1], sincos_cos_x}; // s21f18

    reg [-1:-16] theta_n_s2; // u16f16
    reg signed [1:-19] n18_s2; // s21f19
    reg signed [2:-18] y_double_s2; // s21f18
    always @(posedge clk)
        if (ce) begin
            theta_n_s2 <= theta_n_s1;
            n18_s2 <= n18;
            y_double_s2 <= y_double;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    wire signed [2:-19] sin_theta_x_sum = {n18_s2[1], n18_s2} + 22'h1;
    wire signed [2:-18] sin_theta_x_cut = sin_theta_x_sum[2:-18];
    wire sin_theta_x_over = ~sin_theta_x_cut[2] & (|sin_theta_x_cut[1:0]);
    wire sin_theta_x_under = sin_theta_x_cut[2] & ~(&sin_theta_x_cut[1:0]);
    wire signed [0:-18] sin_theta_x = sin_theta_x_over ? 19'h3ffff : sin_theta_x_under ? 19'h40000 : sin_theta_x_cut[0:-18]; // s19f18
    // asin
    wire [9:0] asin_n20 = sin_theta_x[0:-9]; // u10f0

    reg [-1:-16] theta_n_s3; // u16f16
    reg [17:0] asin_row;
    reg signed [2:-18] y_double_s3; // s21f18
    always @(posedge clk)
        if (ce) begin
            theta_n_s3 <= theta_n_s2;
            asin_row <= asin_rom[asin_n20];
            y_double_s3 <= y_double_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // asin
    wire signed [-1:-18] asin_theta_x = asin_row; // s18f18
    // (unit)
    wire signed [1:-18] z_exact = {{2{asin_theta_x[-1]}}, asin_theta_x} - {2'h0, theta_n_s3, 2'h0}; // s20f18
    wire signed [-1:-18] ang_z = z_exact[-1:-18]; // s18f18
    // recip_sin
    wire [9:0] recip_sin_n25 = ang_z[-1:-10]; // u10f0
    // (unit)
    wire n33 = ang_z[-1]; // u1f0
    wire signed [2:-18] n42 = {4'h0, n41, 16'h0} - {z_exact[1], z_exact}; // s21f18

    reg signed [1:-18] z_exact_s4; // s20f18
    reg signed [2:-18] y_double_s4; // s21f18
    reg [26:0] recip_sin_row;
    reg [26:0] recip_cos_row;
    reg n33_s4; // u1f0
    reg signed [2:-18] n42_s4; // s21f18
    always @(posedge clk)
        if (ce) begin
            z_exact_s4 <= z_exact;
            y_double_s4 <= y_double_s3;
            recip_sin_row <= recip_sin_rom[recip_sin_n25];
            recip_cos_row <= recip_cos_rom[recip_sin_n25];
            n33_s4 <= n33;
            n42_s4 <= n42;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // recip_sin
    wire signed [8:-18] recip_sin_half_recip_sin = recip_sin_row; // s27f18
    // recip_cos
    wire signed [8:-18] recip_cos_half_recip_cos = recip_cos_row; // s27f18

    reg signed [1:-18] z_exact_s5; // s20f18
    reg signed [2:-18] y_double_s5; // s21f18
    reg signed [8:-18] recip_sin_half_recip_sin_s5; // s27f18
    reg signed [8:-18] recip_cos_half_recip_cos_s5; // s27f18
    reg n33_s5; // u1f0
    reg signed [2:-18] n42_s5; // s21f18
    always @(posedge clk)
        if (ce) begin
            z_exact_s5 <= z_exact_s4;
            y_double_s5 <= y_double_s4;
            recip_sin_half_recip_sin_s5 <= recip_sin_half_recip_sin;
            recip_cos_half_recip_cos_s5 <= recip_cos_half_recip_cos;
            n33_s5 <= n33_s4;
            n42_s5 <= n42_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    wire signed [11:-36] n28 = y_double_s5 * recip_sin_half_recip_sin_s5; // s48f36
    wire signed [11:-36] n37 = y_double_s5 * recip_cos_half_recip_cos_s5; // s48f36

    reg signed [1:-18] z_exact_s6; // s20f18
    reg signed [11:-36] n28_s6; // s48f36
    reg n33_s6; // u1f0
    reg signed [11:-36] n37_s6; // s48f36
    reg signed [2:-18] n42_s6; // s21f18
    always @(posedge clk)
        if (ce) begin
            z_exact_s6 <= z_exact_s5;
            n28_s6 <= n28;
            n33_s6 <= n33_s5;
            n37_s6 <= n37;
            n42_s6 <= n42_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    wire signed [12:-36] tan_phi_sum = {n28_s6[11], n28_s6} + 49'h20000;
    wire signed [12:-18] tan_phi_cut = tan_phi_sum[12:-18];
    wire tan_phi_over = ~tan_phi_cut[12] & (|tan_phi_cut[11:4]);
    wire tan_phi_under = tan_phi_cut[12] & ~(&tan_phi_cut[11:4]);
    wire signed [4:-18] tan_phi = tan_phi_over ? 23'h3fffff : tan_phi_under ? 23'h400000 : tan_phi_cut[4:-18]; // s23f18
    // atan
    wire [9:0] atan_n30 = tan_phi[4:-5]; // u10f0
    // (unit)
    wire signed [12:-36] y_k_sum = {n37_s6[11], n37_s6} + 49'h20000;
    wire signed [12:-18] y_k_cut = y_k_sum[12:-18];
    wire y_k_over = ~y_k_cut[12] & (|y_k_cut[11:0]);
    wire y_k_under = y_k_cut[12] & ~(&y_k_cut[11:0]);
    wire signed [0:-18] y_k = y_k_over ? 19'h3ffff : y_k_under ? 19'h40000 : y_k_cut[0:-18]; // s19f18
    // prop
    wire [9:0] prop_n39 = y_k[0:-9]; // u10f0

    reg signed [1:-18] z_exact_s7; // s20f18
    reg [17:0] atan_row;
    reg n33_s7; // u1f0
    reg [19:0] prop_row;
    reg signed [2:-18] n42_s7; // s21f18
    always @(posedge clk)
        if (ce) begin
            z_exact_s7 <= z_exact_s6;
            atan_row <= atan_rom[atan_n30];
            n33_s7 <= n33_s6;
            prop_row <= prop_rom[prop_n39];
            n42_s7 <= n42_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // atan
    wire signed [-1:-18] atan_n31 = atan_row; // s18f18
    // (unit)
    wire [-1:-18] n32 = atan_n31; // u18f18
    wire [-1:-18] n35 = n32 ^ n34; // u18f18
    wire [-1:-18] n36 = n33_s7 ? n35 : n32; // u18f18
    // prop
    wire signed [1:-18] prop_theta_prop = prop_row; // s20f18
    // (unit)
    wire [0:-18] n45_sum = {1'b0, n36} + 19'h2;
    wire [0:-16] n45_cut = n45_sum[0:-16];
    wire [0:-16] n45 = n45_cut; // u17f16
    wire [-1:-16] phi_next = n45[-1:-16]; // u16f16

    reg signed [1:-18] z_exact_s8; // s20f18
    reg signed [1:-18] prop_theta_prop_s8; // s20f18
    reg signed [2:-18] n42_s8; // s21f18
    reg [-1:-16] phi_next_s8; // u16f16
    always @(posedge clk)
        if (ce) begin
            z_exact_s8 <= z_exact_s7;
            prop_theta_prop_s8 <= prop_theta_prop;
            n42_s8 <= n42_s7;
            phi_next_s8 <= phi_next;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    wire signed [4:-36] n43 = n42_s8 * prop_theta_prop_s8; // s41f36

    reg signed [1:-18] z_exact_s9; // s20f18
    reg signed [4:-36] n43_s9; // s41f36
    reg [-1:-16] phi_next_s9; // u16f16
    always @(posedge clk)
        if (ce) begin
            z_exact_s9 <= z_exact_s8;
            n43_s9 <= n43;
            phi_next_s9 <= phi_next_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    wire signed [5:-36] n44 = {{4{z_exact_s9[1]}}, z_exact_s9, 18'h0} + {n43_s9[4], n43_s9}; // s42f36
    wire signed [6:-36] n47_sum = {n44[5], n44} + 43'h80000;
    wire signed [6:-16] n47_cut = n47_sum[6:-16];
    wire signed [6:-16] n47 = n47_cut; // s23f16
    wire [-1:-16] theta_next = n47[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            phi <= phi_next_s9;
            theta <= theta_next;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;
    assign valid_out = valid_s10;

    // ---- stage 10 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        angles_n6[0],
        angles_n8[0],
        angles_ang_x[-11:-17],
        angles_ang_y[-11:-17],
        sin_theta_x[-10:-18],
        sin_theta_x_sum[-19],
        ang_z[-11:-18],
        tan_phi[-6:-18],
        tan_phi_sum[-19:-36],
        y_k[-10:-18],
        y_k_sum[-19:-36],
        n45[0],
        n45_sum[-17:-18],
        n47[6:0],
        n47_sum[-17:-36]};
endmodule
