// bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
// made by fixpath 0.1.0; seed 001 (Lee et al.), Fig. 8; the turn psi and the exact pipelines are this project's
//   pipeline=exact-polar conversion=table angle_bits=16 table_addr_bits=10 scheme=direct
//   quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   cos_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
//   highlight=on diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16
//   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 24 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 4.50e-4, largest seen 8.09e-3 (529.9 ulp) at phi_l=54099 theta_l=21061 phi_h=60333 theta_h=25870 phi_n=4085 theta_n=24243 psi=15789 phi_p=37530 theta_p=7850
//   diffuse: mean 3.83e-4, largest seen 4.02e-3 (263.2 ulp) at phi_l=44654 theta_l=8576 phi_h=60159 theta_h=5510 phi_n=58665 theta_n=10045 psi=11801 phi_p=60790 theta_p=4186
//   specular: mean 1.09e-4, largest seen 7.98e-3 (522.8 ulp) at phi_l=40708 theta_l=14134 phi_h=34659 theta_h=13276 phi_n=35527 theta_n=15280 psi=31916 phi_p=11259 theta_p=2671
//   dot_l: mean 1.24e-3, largest seen 6.37e-3 (417.4 ulp) at phi_l=61704 theta_l=22170 phi_h=4275 theta_h=14080 phi_n=20110 theta_n=22175 psi=22018 phi_p=55143 theta_p=8416
//   dot_h: mean 1.25e-3, largest seen 6.38e-3 (417.8 ulp) at phi_l=40990 theta_l=19166 phi_h=52190 theta_h=15291 phi_n=57641 theta_n=20094 psi=62778 phi_p=9870 theta_p=8515
//   lt_angle: mean 1.43e-3 rad, largest seen 4.45e-3 rad at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
//   lt_dot: mean 1.43e-3, largest seen 4.45e-3 at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
//   lt_x: mean 7.74e-4, largest seen 4.05e-3 at phi_l=6884 theta_l=16156 phi_h=11810 theta_h=14024 phi_n=5223 theta_n=13921 psi=46897 phi_p=28640 theta_p=7461
//   lt_y: mean 6.21e-4, largest seen 3.10e-3 at phi_l=40221 theta_l=13057 phi_h=11896 theta_h=1741 phi_n=6618 theta_n=8346 psi=32754 phi_p=13032 theta_p=5385
//   lt_z: mean 7.41e-4, largest seen 4.08e-3 at phi_l=55938 theta_l=23167 phi_h=56369 theta_h=21833 phi_n=7227 theta_n=16515 psi=2242 phi_p=14438 theta_p=4655
//   ht_angle: mean 1.43e-3 rad, largest seen 5.28e-3 rad at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
//   ht_dot: mean 1.43e-3, largest seen 5.28e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
//   ht_x: mean 7.83e-4, largest seen 4.09e-3 at phi_l=31111 theta_l=19790 phi_h=29735 theta_h=16324 phi_n=29676 theta_n=17022 psi=22911 phi_p=3532 theta_p=8126
//   ht_y: mean 6.21e-4, largest seen 3.21e-3 at phi_l=15384 theta_l=20283 phi_h=16010 theta_h=30916 phi_n=33483 theta_n=20732 psi=60970 phi_p=20741 theta_p=7238
//   ht_z: mean 7.39e-4, largest seen 4.45e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
// stated bound on each dot: 2.73e-2
// stated bound on each diffuse: 1.67e-2
// stated bound on each specular: 1.81e-1
// stated bound on each intensity: 1.97e-1
// stated bound on the angle: 1.82e-2 rad
module bump (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [-1:-16] phi_l, // u16f16
    input  wire [-1:-16] theta_l, // u16f16
    input  wire [-1:-16] phi_h, // u16f16
    input  wire [-1:-16] theta_h, // u16f16
    input  wire [-1:-16] phi_n, // u16f16
    input  wire [-1:-16] theta_n, // u16f16
    input  wire [-1:-16] psi, // u16f16
    input  wire [-1:-16] phi_p, // u16f16
    input  wire [-1:-16] theta_p, // u16f16
    output wire valid_out,
    output reg  [-1:-16] intensity, // u16f16
    output reg  [-1:-16] diffuse, // u16f16
    output reg  [-1:-16] specular // u16f16
);

    // table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom);

    // table recip: recip u20f18
    (* rom_style = "block" *)
    reg [19:0] recip_rom [0:1023];
    initial $readmemh("bump_recip.hex", recip_rom);

    // table atan: atan u19f18, secant u19f18
    (* rom_style = "block" *)
    reg [37:0] atan_rom [0:1023];
    initial $readmemh("bump_atan.hex", atan_rom);

    // table cos: cos s20f18
    (* rom_style = "block" *)
    reg [19:0] cos_rom [0:1023];
    initial $readmemh("bump_cos.hex", cos_rom);

    // table diffuse: light u16f16
    (* rom_style = "block" *)
    reg [15:0] diffuse_rom [0:1023];
    initial $readmemh("bump_diffuse.hex", diffuse_rom);

    // table specular: light u16f16
    (* rom_style = "block" *)
    reg [15:0] specular_rom [0:1023];
    initial $readmemh("bump_specular.hex", specular_rom);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_2 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_2);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_3 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_3);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_4 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_4);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_5 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_5);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_6 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_6);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_7 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_7);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_8 [0:1023];
    initial $readmemh("bump_sincos.hex", sincos_rom_8);

    // a copy of table recip: recip u20f18
    (* rom_style = "block" *)
    reg [19:0] recip_rom_2 [0:1023];
    initial $readmemh("bump_recip.hex", recip_rom_2);

    // a copy of table atan: atan u19f18, secant u19f18
    (* rom_style = "block" *)
    reg [37:0] atan_rom_2 [0:1023];
    initial $readmemh("bump_atan.hex", atan_rom_2);

    // a copy of table cos: cos s20f18
    (* rom_style = "block" *)
    reg [19:0] cos_rom_2 [0:1023];
    initial $readmemh("bump_cos.hex", cos_rom_2);

    // a copy of table cos: cos s20f18
    (* rom_style = "block" *)
    reg [19:0] cos_rom_3 [0:1023];
    initial $readmemh("bump_cos.hex", cos_rom_3);

    // ---- stage 0 ----
    // light.angles
    wire signed [0:-16] light_angles_n9 = {1'b0, phi_l} - {1'b0, phi_n}; // s17f16
    wire [-1:-16] light_angles_delta = light_angles_n9[-1:-16]; // u16f16
    wire [0:-16] light_angles_n11 = {1'b0, theta_l} + {1'b0, light_angles_delta}; // u17f16
    wire [-1:-16] light_angles_ang_x = light_angles_n11[-1:-16]; // u16f16
    wire signed [0:-16] light_angles_n13 = {1'b0, theta_l} - {1'b0, light_angles_delta}; // s17f16
    wire [-1:-16] light_angles_ang_y = light_angles_n13[-1:-16]; // u16f16
    wire [0:-16] light_angles_n15 = {1'b0, light_angles_ang_x} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] light_angles_x_plus_n = light_angles_n15[-1:-16]; // u16f16
    wire signed [0:-16] light_angles_n17 = {1'b0, light_angles_ang_x} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] light_angles_x_minus_n = light_angles_n17[-1:-16]; // u16f16
    wire [0:-16] light_angles_n19 = {1'b0, light_angles_ang_y} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] light_angles_y_plus_n = light_angles_n19[-1:-16]; // u16f16
    wire signed [0:-16] light_angles_n21 = {1'b0, light_angles_ang_y} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] light_angles_y_minus_n = light_angles_n21[-1:-16]; // u16f16
    wire [0:-16] light_angles_n23 = {1'b0, theta_l} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] light_angles_a_plus_n = light_angles_n23[-1:-16]; // u16f16
    wire signed [0:-16] light_angles_n25 = {1'b0, theta_l} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] light_angles_a_minus_n = light_angles_n25[-1:-16]; // u16f16
    // light.sincos
    wire [9:0] light_sincos_n27 = light_angles_ang_y[-1:-10]; // u10f0
    wire [9:0] light_sincos_n29 = light_angles_ang_x[-1:-10]; // u10f0
    wire [9:0] light_sincos_n31 = light_angles_x_plus_n[-1:-10]; // u10f0
    wire [9:0] light_sincos_n34 = light_angles_x_minus_n[-1:-10]; // u10f0
    wire [9:0] light_sincos_n37 = light_angles_y_plus_n[-1:-10]; // u10f0
    wire [9:0] light_sincos_n40 = light_angles_y_minus_n[-1:-10]; // u10f0
    wire [9:0] light_sincos_n43 = light_angles_a_plus_n[-1:-10]; // u10f0
    wire [9:0] light_sincos_n46 = light_angles_a_minus_n[-1:-10]; // u10f0
    // light.azimuth
    wire [0:-18] light_azimuth_n88 = 19'h10000; // u19f18
    wire [0:-18] light_azimuth_n92 = 19'h20000; // u19f18
    // half.angles
    wire signed [0:-16] half_angles_n134 = {1'b0, phi_h} - {1'b0, phi_n}; // s17f16
    wire [-1:-16] half_angles_delta = half_angles_n134[-1:-16]; // u16f16
    wire [0:-16] half_angles_n136 = {1'b0, theta_h} + {1'b0, half_angles_delta}; // u17f16
    wire [-1:-16] half_angles_ang_x = half_angles_n136[-1:-16]; // u16f16
    wire signed [0:-16] half_angles_n138 = {1'b0, theta_h} - {1'b0, half_angles_delta}; // s17f16
    wire [-1:-16] half_angles_ang_y = half_angles_n138[-1:-16]; // u16f16
    wire [0:-16] half_angles_n140 = {1'b0, half_angles_ang_x} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] half_angles_x_plus_n = half_angles_n140[-1:-16]; // u16f16
    wire signed [0:-16] half_angles_n142 = {1'b0, half_angles_ang_x} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] half_angles_x_minus_n = half_angles_n142[-1:-16]; // u16f16
    wire [0:-16] half_angles_n144 = {1'b0, half_angles_ang_y} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] half_angles_y_plus_n = half_angles_n144[-1:-16]; // u16f16
    wire signed [0:-16] half_angles_n146 = {1'b0, half_angles_ang_y} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] half_angles_y_minus_n = half_angles_n146[-1:-16]; // u16f16
    wire [0:-16] half_angles_n148 = {1'b0, theta_h} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] half_angles_a_plus_n = half_angles_n148[-1:-16]; // u16f16
    wire signed [0:-16] half_angles_n150 = {1'b0, theta_h} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] half_angles_a_minus_n = half_angles_n150[-1:-16]; // u16f16
    // half.sincos
    wire [9:0] half_sincos_n152 = half_angles_ang_y[-1:-10]; // u10f0
    wire [9:0] half_sincos_n154 = half_angles_ang_x[-1:-10]; // u10f0
    wire [9:0] half_sincos_n156 = half_angles_x_plus_n[-1:-10]; // u10f0
    wire [9:0] half_sincos_n159 = half_angles_x_minus_n[-1:-10]; // u10f0
    wire [9:0] half_sincos_n162 = half_angles_y_plus_n[-1:-10]; // u10f0
    wire [9:0] half_sincos_n165 = half_angles_y_minus_n[-1:-10]; // u10f0
    wire [9:0] half_sincos_n168 = half_angles_a_plus_n[-1:-10]; // u10f0
    wire [9:0] half_sincos_n171 = half_angles_a_minus_n[-1:-10]; // u10f0
    // bump
    wire [0:-16] bump_n257 = {1'b0, phi_p} + {1'b0, psi}; // u17f16
    wire [-1:-16] bump_phi = bump_n257[-1:-16]; // u16f16
    // (unit)
    wire n297 = 1'b0; // u1f0
    wire [-1:-16] n306 = 16'hb333; // u16f16
    wire [-1:-16] n307 = 16'h199a; // u16f16
    wire [-1:-16] n318 = 16'h4ccd; // u16f16
    wire [-1:-16] n319 = 16'h0; // u16f16

    reg [-1:-16] theta_p_s1; // u16f16
    reg [39:0] sincos_row;
    reg [39:0] sincos_row_2;
    reg [39:0] sincos_row_3;
    reg [39:0] sincos_row_4;
    reg [39:0] sincos_row_5;
    reg [39:0] sincos_row_6;
    reg [39:0] sincos_row_7;
    reg [39:0] sincos_row_8;
    reg [39:0] sincos_row_9;
    reg [39:0] sincos_row_10;
    reg [39:0] sincos_row_11;
    reg [39:0] sincos_row_12;
    reg [39:0] sincos_row_13;
    reg [39:0] sincos_row_14;
    reg [39:0] sincos_row_15;
    reg [39:0] sincos_row_16;
    reg [-1:-16] bump_phi_s1; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s1 <= theta_p;
            sincos_row <= sincos_rom[light_sincos_n27];
            sincos_row_2 <= sincos_rom[light_sincos_n29];
            sincos_row_3 <= sincos_rom_2[light_sincos_n31];
            sincos_row_4 <= sincos_rom_2[light_sincos_n34];
            sincos_row_5 <= sincos_rom_3[light_sincos_n37];
            sincos_row_6 <= sincos_rom_3[light_sincos_n40];
            sincos_row_7 <= sincos_rom_4[light_sincos_n43];
            sincos_row_8 <= sincos_rom_4[light_sincos_n46];
            sincos_row_9 <= sincos_rom_5[half_sincos_n152];
            sincos_row_10 <= sincos_rom_5[half_sincos_n154];
            sincos_row_11 <= sincos_rom_6[half_sincos_n156];
            sincos_row_12 <= sincos_rom_6[half_sincos_n159];
            sincos_row_13 <= sincos_rom_7[half_sincos_n162];
            sincos_row_14 <= sincos_rom_7[half_sincos_n165];
            sincos_row_15 <= sincos_rom_8[half_sincos_n168];
            sincos_row_16 <= sincos_rom_8[half_sincos_n171];
            bump_phi_s1 <= bump_phi;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // light.sincos
    wire signed [1:-18] light_sincos_cos_y = sincos_row[19:0]; // s20f18
    wire signed [1:-18] light_sincos_cos_x = sincos_row_2[19:0]; // s20f18
    wire signed [1:-18] light_sincos_sin_xpn = sincos_row_3[39:20]; // s20f18
    wire signed [1:-18] light_sincos_cos_xpn = sincos_row_3[19:0]; // s20f18
    wire signed [1:-18] light_sincos_sin_xmn = sincos_row_4[39:20]; // s20f18
    wire signed [1:-18] light_sincos_cos_xmn = sincos_row_4[19:0]; // s20f18
    wire signed [1:-18] light_sincos_sin_ypn = sincos_row_5[39:20]; // s20f18
    wire signed [1:-18] light_sincos_cos_ypn = sincos_row_5[19:0]; // s20f18
    wire signed [1:-18] light_sincos_sin_ymn = sincos_row_6[39:20]; // s20f18
    wire signed [1:-18] light_sincos_cos_ymn = sincos_row_6[19:0]; // s20f18
    wire signed [1:-18] light_sincos_sin_apn = sincos_row_7[39:20]; // s20f18
    wire signed [1:-18] light_sincos_cos_apn = sincos_row_7[19:0]; // s20f18
    wire signed [1:-18] light_sincos_sin_amn = sincos_row_8[39:20]; // s20f18
    wire signed [1:-18] light_sincos_cos_amn = sincos_row_8[19:0]; // s20f18
    // light.sums
    wire signed [2:-18] light_sums_n49 = {light_sincos_sin_xpn[1], light_sincos_sin_xpn} + {light_sincos_sin_xmn[1], light_sincos_sin_xmn}; // s21f18
    wire signed [2:-18] light_sums_n50 = {light_sincos_sin_ypn[1], light_sincos_sin_ypn} + {light_sincos_sin_ymn[1], light_sincos_sin_ymn}; // s21f18
    wire signed [3:-18] light_sums_n51 = {light_sums_n49[2], light_sums_n49} + {light_sums_n50[2], light_sums_n50}; // s22f18
    wire signed [1:-20] light_sums_n52 = light_sums_n51; // s22f20
    wire signed [2:-18] light_sums_n53 = {light_sincos_sin_apn[1], light_sincos_sin_apn} - {light_sincos_sin_amn[1], light_sincos_sin_amn}; // s21f18
    wire signed [1:-19] light_sums_n54 = light_sums_n53; // s21f19
    wire signed [2:-18] light_sums_n56 = {light_sincos_cos_y[1], light_sincos_cos_y} - {light_sincos_cos_x[1], light_sincos_cos_x}; // s21f18
    wire signed [1:-19] light_sums_y_sum = light_sums_n56; // s21f19
    wire signed [2:-18] light_sums_n58 = {light_sincos_cos_xmn[1], light_sincos_cos_xmn} - {light_sincos_cos_xpn[1], light_sincos_cos_xpn}; // s21f18
    wire signed [2:-18] light_sums_n59 = {light_sincos_cos_ymn[1], light_sincos_cos_ymn} - {light_sincos_cos_ypn[1], light_sincos_cos_ypn}; // s21f18
    wire signed [3:-18] light_sums_n60 = {light_sums_n58[2], light_sums_n58} + {light_sums_n59[2], light_sums_n59}; // s22f18
    wire signed [1:-20] light_sums_n61 = light_sums_n60; // s22f20
    wire signed [2:-18] light_sums_n62 = {light_sincos_cos_apn[1], light_sincos_cos_apn} + {light_sincos_cos_amn[1], light_sincos_cos_amn}; // s21f18
    wire signed [1:-19] light_sums_n63 = light_sums_n62; // s21f19
    // half.sincos
    wire signed [1:-18] half_sincos_cos_y = sincos_row_9[19:0]; // s20f18
    wire signed [1:-18] half_sincos_cos_x = sincos_row_10[19:0]; // s20f18
    wire signed [1:-18] half_sincos_sin_xpn = sincos_row_11[39:20]; // s20f18
    wire signed [1:-18] half_sincos_cos_xpn = sincos_row_11[19:0]; // s20f18
    wire signed [1:-18] half_sincos_sin_xmn = sincos_row_12[39:20]; // s20f18
    wire signed [1:-18] half_sincos_cos_xmn = sincos_row_12[19:0]; // s20f18
    wire signed [1:-18] half_sincos_sin_ypn = sincos_row_13[39:20]; // s20f18
    wire signed [1:-18] half_sincos_cos_ypn = sincos_row_13[19:0]; // s20f18
    wire signed [1:-18] half_sincos_sin_ymn = sincos_row_14[39:20]; // s20f18
    wire signed [1:-18] half_sincos_cos_ymn = sincos_row_14[19:0]; // s20f18
    wire signed [1:-18] half_sincos_sin_apn = sincos_row_15[39:20]; // s20f18
    wire signed [1:-18] half_sincos_cos_apn = sincos_row_15[19:0]; // s20f18
    wire signed [1:-18] half_sincos_sin_amn = sincos_row_16[39:20]; // s20f18
    wire signed [1:-18] half_sincos_cos_amn = sincos_row_16[19:0]; // s20f18
    // half.sums
    wire signed [2:-18] half_sums_n174 = {half_sincos_sin_xpn[1], half_sincos_sin_xpn} + {half_sincos_sin_xmn[1], half_sincos_sin_xmn}; // s21f18
    wire signed [2:-18] half_sums_n175 = {half_sincos_sin_ypn[1], half_sincos_sin_ypn} + {half_sincos_sin_ymn[1], half_sincos_sin_ymn}; // s21f18
    wire signed [3:-18] half_sums_n176 = {half_sums_n174[2], half_sums_n174} + {half_sums_n175[2], half_sums_n175}; // s22f18
    wire signed [1:-20] half_sums_n177 = half_sums_n176; // s22f20
    wire signed [2:-18] half_sums_n178 = {half_sincos_sin_apn[1], half_sincos_sin_apn} - {half_sincos_sin_amn[1], half_sincos_sin_amn}; // s21f18
    wire signed [1:-19] half_sums_n179 = half_sums_n178; // s21f19
    wire signed [2:-18] half_sums_n181 = {half_sincos_cos_y[1], half_sincos_cos_y} - {half_sincos_cos_x[1], half_sincos_cos_x}; // s21f18
    wire signed [1:-19] half_sums_y_sum = half_sums_n181; // s21f19
    wire signed [2:-18] half_sums_n183 = {half_sincos_cos_xmn[1], half_sincos_cos_xmn} - {half_sincos_cos_xpn[1], half_sincos_cos_xpn}; // s21f18
    wire signed [2:-18] half_sums_n184 = {half_sincos_cos_ymn[1], half_sincos_cos_ymn} - {half_sincos_cos_ypn[1], half_sincos_cos_ypn}; // s21f18
    wire signed [3:-18] half_sums_n185 = {half_sums_n183[2], half_sums_n183} + {half_sums_n184[2], half_sums_n184}; // s22f18
    wire signed [1:-20] half_sums_n186 = half_sums_n185; // s22f20
    wire signed [2:-18] half_sums_n187 = {half_sincos_cos_apn[1], half_sincos_cos_apn} + {half_sincos_cos_amn[1], half_sincos_cos_amn}; // s21f18
    wire signed [1:-19] half_sums_n188 = half_sums_n187; // s21f19

    reg [-1:-16] theta_p_s2; // u16f16
    reg signed [1:-20] light_sums_n52_s2; // s22f20
    reg signed [1:-19] light_sums_n54_s2; // s21f19
    reg signed [1:-19] light_sums_y_sum_s2; // s21f19
    reg signed [1:-20] light_sums_n61_s2; // s22f20
    reg signed [1:-19] light_sums_n63_s2; // s21f19
    reg signed [1:-20] half_sums_n177_s2; // s22f20
    reg signed [1:-19] half_sums_n179_s2; // s21f19
    reg signed [1:-19] half_sums_y_sum_s2; // s21f19
    reg signed [1:-20] half_sums_n186_s2; // s22f20
    reg signed [1:-19] half_sums_n188_s2; // s21f19
    reg [-1:-16] bump_phi_s2; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s2 <= theta_p_s1;
            light_sums_n52_s2 <= light_sums_n52;
            light_sums_n54_s2 <= light_sums_n54;
            light_sums_y_sum_s2 <= light_sums_y_sum;
            light_sums_n61_s2 <= light_sums_n61;
            light_sums_n63_s2 <= light_sums_n63;
            half_sums_n177_s2 <= half_sums_n177;
            half_sums_n179_s2 <= half_sums_n179;
            half_sums_y_sum_s2 <= half_sums_y_sum;
            half_sums_n186_s2 <= half_sums_n186;
            half_sums_n188_s2 <= half_sums_n188;
            bump_phi_s2 <= bump_phi_s1;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // light.sums
    wire signed [2:-20] light_sums_x_sum = {light_sums_n52_s2[1], light_sums_n52_s2} - {light_sums_n54_s2[1], light_sums_n54_s2, 1'b0}; // s23f20
    wire signed [2:-20] light_sums_z_sum = {light_sums_n61_s2[1], light_sums_n61_s2} + {light_sums_n63_s2[1], light_sums_n63_s2, 1'b0}; // s23f20
    // light
    wire signed [3:-20] light_x_sum = {light_sums_x_sum[2], light_sums_x_sum} + 24'h2;
    wire signed [3:-18] light_x_cut = light_x_sum[3:-18];
    wire light_x_over = ~light_x_cut[3] & (|light_x_cut[2:1]);
    wire light_x_under = light_x_cut[3] & ~(&light_x_cut[2:1]);
    wire signed [1:-18] light_x = light_x_over ? 20'h7ffff : light_x_under ? 20'h80000 : light_x_cut[1:-18]; // s20f18
    wire signed [2:-19] light_y_sum = {light_sums_y_sum_s2[1], light_sums_y_sum_s2} + 22'h1;
    wire signed [2:-18] light_y_cut = light_y_sum[2:-18];
    wire light_y_over = ~light_y_cut[2] & (|light_y_cut[1]);
    wire signed [1:-18] light_y = light_y_over ? 20'h7ffff : light_y_cut[1:-18]; // s20f18
    wire signed [3:-20] light_z_sum = {light_sums_z_sum[2], light_sums_z_sum} + 24'h2;
    wire signed [3:-18] light_z_cut = light_z_sum[3:-18];
    wire light_z_over = ~light_z_cut[3] & (|light_z_cut[2:1]);
    wire light_z_under = light_z_cut[3] & ~(&light_z_cut[2:1]);
    wire signed [1:-18] light_z = light_z_over ? 20'h7ffff : light_z_under ? 20'h80000 : light_z_cut[1:-18]; // s20f18
    // light.azimuth
    wire [1:-18] light_azimuth_n68_neg = -light_x;
    wire [1:-18] light_azimuth_n68 = light_x[1] ? light_azimuth_n68_neg : light_x; // u20f18
    wire [1:-18] light_azimuth_n69_neg = -light_y;
    wire [1:-18] light_azimuth_n69 = light_y[1] ? light_azimuth_n69_neg : light_y; // u20f18
    wire light_azimuth_n91 = light_x[1]; // u1f0
    wire light_azimuth_n95 = light_y[1]; // u1f0
    // light.polar_angle
    wire [1:-18] light_polar_angle_n102_neg = -light_z;
    wire [1:-18] light_polar_angle_n102 = light_z[1] ? light_polar_angle_n102_neg : light_z; // u20f18
    wire light_polar_angle_n123 = light_z[1]; // u1f0
    // half.sums
    wire signed [2:-20] half_sums_x_sum = {half_sums_n177_s2[1], half_sums_n177_s2} - {half_sums_n179_s2[1], half_sums_n179_s2, 1'b0}; // s23f20
    wire signed [2:-20] half_sums_z_sum = {half_sums_n186_s2[1], half_sums_n186_s2} + {half_sums_n188_s2[1], half_sums_n188_s2, 1'b0}; // s23f20
    // half
    wire signed [3:-20] half_x_sum = {half_sums_x_sum[2], half_sums_x_sum} + 24'h2;
    wire signed [3:-18] half_x_cut = half_x_sum[3:-18];
    wire half_x_over = ~half_x_cut[3] & (|half_x_cut[2:1]);
    wire half_x_under = half_x_cut[3] & ~(&half_x_cut[2:1]);
    wire signed [1:-18] half_x = half_x_over ? 20'h7ffff : half_x_under ? 20'h80000 : half_x_cut[1:-18]; // s20f18
    wire signed [2:-19] half_y_sum = {half_sums_y_sum_s2[1], half_sums_y_sum_s2} + 22'h1;
    wire signed [2:-18] half_y_cut = half_y_sum[2:-18];
    wire half_y_over = ~half_y_cut[2] & (|half_y_cut[1]);
    wire signed [1:-18] half_y = half_y_over ? 20'h7ffff : half_y_cut[1:-18]; // s20f18
    wire signed [3:-20] half_z_sum = {half_sums_z_sum[2], half_sums_z_sum} + 24'h2;
    wire signed [3:-18] half_z_cut = half_z_sum[3:-18];
    wire half_z_over = ~half_z_cut[3] & (|half_z_cut[2:1]);
    wire half_z_under = half_z_cut[3] & ~(&half_z_cut[2:1]);
    wire signed [1:-18] half_z = half_z_over ? 20'h7ffff : half_z_under ? 20'h80000 : half_z_cut[1:-18]; // s20f18
    // half.azimuth
    wire [1:-18] half_azimuth_n193_neg = -half_x;
    wire [1:-18] half_azimuth_n193 = half_x[1] ? half_azimuth_n193_neg : half_x; // u20f18
    wire [1:-18] half_azimuth_n194_neg = -half_y;
    wire [1:-18] half_azimuth_n194 = half_y[1] ? half_azimuth_n194_neg : half_y; // u20f18
    wire half_azimuth_n215 = half_x[1]; // u1f0
    wire half_azimuth_n218 = half_y[1]; // u1f0
    // half.polar_angle
    wire [1:-18] half_polar_angle_n225_neg = -half_z;
    wire [1:-18] half_polar_angle_n225 = half_z[1] ? half_polar_angle_n225_neg : half_z; // u20f18
    wire half_polar_angle_n246 = half_z[1]; // u1f0

    reg [-1:-16] theta_p_s3; // u16f16
    reg [1:-18] light_azimuth_n68_s3; // u20f18
    reg [1:-18] light_azimuth_n69_s3; // u20f18
    reg light_azimuth_n91_s3; // u1f0
    reg light_azimuth_n95_s3; // u1f0
    reg [1:-18] light_polar_angle_n102_s3; // u20f18
    reg light_polar_angle_n123_s3; // u1f0
    reg [1:-18] half_azimuth_n193_s3; // u20f18
    reg [1:-18] half_azimuth_n194_s3; // u20f18
    reg half_azimuth_n215_s3; // u1f0
    reg half_azimuth_n218_s3; // u1f0
    reg [1:-18] half_polar_angle_n225_s3; // u20f18
    reg half_polar_angle_n246_s3; // u1f0
    reg [-1:-16] bump_phi_s3; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s3 <= theta_p_s2;
            light_azimuth_n68_s3 <= light_azimuth_n68;
            light_azimuth_n69_s3 <= light_azimuth_n69;
            light_azimuth_n91_s3 <= light_azimuth_n91;
            light_azimuth_n95_s3 <= light_azimuth_n95;
            light_polar_angle_n102_s3 <= light_polar_angle_n102;
            light_polar_angle_n123_s3 <= light_polar_angle_n123;
            half_azimuth_n193_s3 <= half_azimuth_n193;
            half_azimuth_n194_s3 <= half_azimuth_n194;
            half_azimuth_n215_s3 <= half_azimuth_n215;
            half_azimuth_n218_s3 <= half_azimuth_n218;
            half_polar_angle_n225_s3 <= half_polar_angle_n225;
            half_polar_angle_n246_s3 <= half_polar_angle_n246;
            bump_phi_s3 <= bump_phi_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // light.azimuth
    wire light_azimuth_n70 = light_azimuth_n68_s3 < light_azimuth_n69_s3; // u1f0
    wire [1:-18] light_azimuth_n71 = light_azimuth_n70 ? light_azimuth_n69_s3 : light_azimuth_n68_s3; // u20f18
    wire [1:-18] light_azimuth_n72 = light_azimuth_n70 ? light_azimuth_n68_s3 : light_azimuth_n69_s3; // u20f18
    wire [31:0] light_azimuth_n73_padded = {light_azimuth_n71, 12'hfff};
    wire light_azimuth_n73_skip16 = light_azimuth_n73_padded[31:16] == 16'h0;
    wire [15:0] light_azimuth_n73_part16 = light_azimuth_n73_skip16 ? light_azimuth_n73_padded[15:0] : light_azimuth_n73_padded[31:16];
    wire light_azimuth_n73_skip8 = light_azimuth_n73_part16[15:8] == 8'h0;
    wire [7:0] light_azimuth_n73_part8 = light_azimuth_n73_skip8 ? light_azimuth_n73_part16[7:0] : light_azimuth_n73_part16[15:8];
    wire light_azimuth_n73_skip4 = light_azimuth_n73_part8[7:4] == 4'h0;
    wire [3:0] light_azimuth_n73_part4 = light_azimuth_n73_skip4 ? light_azimuth_n73_part8[3:0] : light_azimuth_n73_part8[7:4];
    wire light_azimuth_n73_skip2 = light_azimuth_n73_part4[3:2] == 2'h0;
    wire [1:0] light_azimuth_n73_part2 = light_azimuth_n73_skip2 ? light_azimuth_n73_part4[1:0] : light_azimuth_n73_part4[3:2];
    wire light_azimuth_n73_skip1 = light_azimuth_n73_part2[1] == 1'b0;
    wire [4:0] light_azimuth_n73 = {light_azimuth_n73_skip16, light_azimuth_n73_skip8, light_azimuth_n73_skip4, light_azimuth_n73_skip2, light_azimuth_n73_skip1}; // u5f0
    // half.azimuth
    wire half_azimuth_n195 = half_azimuth_n193_s3 < half_azimuth_n194_s3; // u1f0
    wire [1:-18] half_azimuth_n196 = half_azimuth_n195 ? half_azimuth_n194_s3 : half_azimuth_n193_s3; // u20f18
    wire [1:-18] half_azimuth_n197 = half_azimuth_n195 ? half_azimuth_n193_s3 : half_azimuth_n194_s3; // u20f18
    wire [31:0] half_azimuth_n198_padded = {half_azimuth_n196, 12'hfff};
    wire half_azimuth_n198_skip16 = half_azimuth_n198_padded[31:16] == 16'h0;
    wire [15:0] half_azimuth_n198_part16 = half_azimuth_n198_skip16 ? half_azimuth_n198_padded[15:0] : half_azimuth_n198_padded[31:16];
    wire half_azimuth_n198_skip8 = half_azimuth_n198_part16[15:8] == 8'h0;
    wire [7:0] half_azimuth_n198_part8 = half_azimuth_n198_skip8 ? half_azimuth_n198_part16[7:0] : half_azimuth_n198_part16[15:8];
    wire half_azimuth_n198_skip4 = half_azimuth_n198_part8[7:4] == 4'h0;
    wire [3:0] half_azimuth_n198_part4 = half_azimuth_n198_skip4 ? half_azimuth_n198_part8[3:0] : half_azimuth_n198_part8[7:4];
    wire half_azimuth_n198_skip2 = half_azimuth_n198_part4[3:2] == 2'h0;
    wire [1:0] half_azimuth_n198_part2 = half_azimuth_n198_skip2 ? half_azimuth_n198_part4[1:0] : half_azimuth_n198_part4[3:2];
    wire half_azimuth_n198_skip1 = half_azimuth_n198_part2[1] == 1'b0;
    wire [4:0] half_azimuth_n198 = {half_azimuth_n198_skip16, half_azimuth_n198_skip8, half_azimuth_n198_skip4, half_azimuth_n198_skip2, half_azimuth_n198_skip1}; // u5f0

    reg [-1:-16] theta_p_s4; // u16f16
    reg light_azimuth_n70_s4; // u1f0
    reg [1:-18] light_azimuth_n71_s4; // u20f18
    reg [1:-18] light_azimuth_n72_s4; // u20f18
    reg [4:0] light_azimuth_n73_s4; // u5f0
    reg light_azimuth_n91_s4; // u1f0
    reg light_azimuth_n95_s4; // u1f0
    reg [1:-18] light_polar_angle_n102_s4; // u20f18
    reg light_polar_angle_n123_s4; // u1f0
    reg half_azimuth_n195_s4; // u1f0
    reg [1:-18] half_azimuth_n196_s4; // u20f18
    reg [1:-18] half_azimuth_n197_s4; // u20f18
    reg [4:0] half_azimuth_n198_s4; // u5f0
    reg half_azimuth_n215_s4; // u1f0
    reg half_azimuth_n218_s4; // u1f0
    reg [1:-18] half_polar_angle_n225_s4; // u20f18
    reg half_polar_angle_n246_s4; // u1f0
    reg [-1:-16] bump_phi_s4; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s4 <= theta_p_s3;
            light_azimuth_n70_s4 <= light_azimuth_n70;
            light_azimuth_n71_s4 <= light_azimuth_n71;
            light_azimuth_n72_s4 <= light_azimuth_n72;
            light_azimuth_n73_s4 <= light_azimuth_n73;
            light_azimuth_n91_s4 <= light_azimuth_n91_s3;
            light_azimuth_n95_s4 <= light_azimuth_n95_s3;
            light_polar_angle_n102_s4 <= light_polar_angle_n102_s3;
            light_polar_angle_n123_s4 <= light_polar_angle_n123_s3;
            half_azimuth_n195_s4 <= half_azimuth_n195;
            half_azimuth_n196_s4 <= half_azimuth_n196;
            half_azimuth_n197_s4 <= half_azimuth_n197;
            half_azimuth_n198_s4 <= half_azimuth_n198;
            half_azimuth_n215_s4 <= half_azimuth_n215_s3;
            half_azimuth_n218_s4 <= half_azimuth_n218_s3;
            half_polar_angle_n225_s4 <= half_polar_angle_n225_s3;
            half_polar_angle_n246_s4 <= half_polar_angle_n246_s3;
            bump_phi_s4 <= bump_phi_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // light.azimuth
    wire light_azimuth_n74_past = 5'h14 < light_azimuth_n73_s4;
    wire [4:0] light_azimuth_n74_count = light_azimuth_n74_past ? 5'h14 : light_azimuth_n73_s4;
    wire [21:-18] light_azimuth_n74 = {20'h0, light_azimuth_n71_s4} << light_azimuth_n74_count; // u40f18
    wire [19:0] light_azimuth_n75 = light_azimuth_n74[1:-18]; // u20f0
    wire light_azimuth_n76_past = 5'h14 < light_azimuth_n73_s4;
    wire [4:0] light_azimuth_n76_count = light_azimuth_n76_past ? 5'h14 : light_azimuth_n73_s4;
    wire [21:-18] light_azimuth_n76 = {20'h0, light_azimuth_n72_s4} << light_azimuth_n76_count; // u40f18
    wire [19:0] light_azimuth_n77 = light_azimuth_n76[1:-18]; // u20f0
    wire [18:0] light_azimuth_n78 = light_azimuth_n75[18:0]; // u19f0
    wire [-2:-20] light_azimuth_n79 = light_azimuth_n78; // u19f20
    // light.azimuth.recip
    wire [9:0] light_azimuth_recip_n80 = light_azimuth_n79[-2:-11]; // u10f0
    // light.azimuth
    wire [-1:-20] light_azimuth_n82 = light_azimuth_n77; // u20f20
    // half.azimuth
    wire half_azimuth_n199_past = 5'h14 < half_azimuth_n198_s4;
    wire [4:0] half_azimuth_n199_count = half_azimuth_n199_past ? 5'h14 : half_azimuth_n198_s4;
    wire [21:-18] half_azimuth_n199 = {20'h0, half_azimuth_n196_s4} << half_azimuth_n199_count; // u40f18
    wire [19:0] half_azimuth_n200 = half_azimuth_n199[1:-18]; // u20f0
    wire half_azimuth_n201_past = 5'h14 < half_azimuth_n198_s4;
    wire [4:0] half_azimuth_n201_count = half_azimuth_n201_past ? 5'h14 : half_azimuth_n198_s4;
    wire [21:-18] half_azimuth_n201 = {20'h0, half_azimuth_n197_s4} << half_azimuth_n201_count; // u40f18
    wire [19:0] half_azimuth_n202 = half_azimuth_n201[1:-18]; // u20f0
    wire [18:0] half_azimuth_n203 = half_azimuth_n200[18:0]; // u19f0
    wire [-2:-20] half_azimuth_n204 = half_azimuth_n203; // u19f20
    // half.azimuth.recip
    wire [9:0] half_azimuth_recip_n205 = half_azimuth_n204[-2:-11]; // u10f0
    // half.azimuth
    wire [-1:-20] half_azimuth_n207 = half_azimuth_n202; // u20f20

    reg [-1:-16] theta_p_s5; // u16f16
    reg light_azimuth_n70_s5; // u1f0
    reg [1:-18] light_azimuth_n71_s5; // u20f18
    reg [19:0] recip_row;
    reg [-1:-20] light_azimuth_n82_s5; // u20f20
    reg light_azimuth_n91_s5; // u1f0
    reg light_azimuth_n95_s5; // u1f0
    reg [1:-18] light_polar_angle_n102_s5; // u20f18
    reg light_polar_angle_n123_s5; // u1f0
    reg half_azimuth_n195_s5; // u1f0
    reg [1:-18] half_azimuth_n196_s5; // u20f18
    reg [19:0] recip_row_2;
    reg [-1:-20] half_azimuth_n207_s5; // u20f20
    reg half_azimuth_n215_s5; // u1f0
    reg half_azimuth_n218_s5; // u1f0
    reg [1:-18] half_polar_angle_n225_s5; // u20f18
    reg half_polar_angle_n246_s5; // u1f0
    reg [-1:-16] bump_phi_s5; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s5 <= theta_p_s4;
            light_azimuth_n70_s5 <= light_azimuth_n70_s4;
            light_azimuth_n71_s5 <= light_azimuth_n71_s4;
            recip_row <= recip_rom[light_azimuth_recip_n80];
            light_azimuth_n82_s5 <= light_azimuth_n82;
            light_azimuth_n91_s5 <= light_azimuth_n91_s4;
            light_azimuth_n95_s5 <= light_azimuth_n95_s4;
            light_polar_angle_n102_s5 <= light_polar_angle_n102_s4;
            light_polar_angle_n123_s5 <= light_polar_angle_n123_s4;
            half_azimuth_n195_s5 <= half_azimuth_n195_s4;
            half_azimuth_n196_s5 <= half_azimuth_n196_s4;
            recip_row_2 <= recip_rom[half_azimuth_recip_n205];
            half_azimuth_n207_s5 <= half_azimuth_n207;
            half_azimuth_n215_s5 <= half_azimuth_n215_s4;
            half_azimuth_n218_s5 <= half_azimuth_n218_s4;
            half_polar_angle_n225_s5 <= half_polar_angle_n225_s4;
            half_polar_angle_n246_s5 <= half_polar_angle_n246_s4;
            bump_phi_s5 <= bump_phi_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // light.azimuth.recip
    wire [1:-18] light_azimuth_recip_n81 = recip_row; // u20f18
    // half.azimuth.recip
    wire [1:-18] half_azimuth_recip_n206 = recip_row_2; // u20f18

    reg [-1:-16] theta_p_s6; // u16f16
    reg light_azimuth_n70_s6; // u1f0
    reg [1:-18] light_azimuth_n71_s6; // u20f18
    reg [1:-18] light_azimuth_recip_n81_s6; // u20f18
    reg [-1:-20] light_azimuth_n82_s6; // u20f20
    reg light_azimuth_n91_s6; // u1f0
    reg light_azimuth_n95_s6; // u1f0
    reg [1:-18] light_polar_angle_n102_s6; // u20f18
    reg light_polar_angle_n123_s6; // u1f0
    reg half_azimuth_n195_s6; // u1f0
    reg [1:-18] half_azimuth_n196_s6; // u20f18
    reg [1:-18] half_azimuth_recip_n206_s6; // u20f18
    reg [-1:-20] half_azimuth_n207_s6; // u20f20
    reg half_azimuth_n215_s6; // u1f0
    reg half_azimuth_n218_s6; // u1f0
    reg [1:-18] half_polar_angle_n225_s6; // u20f18
    reg half_polar_angle_n246_s6; // u1f0
    reg [-1:-16] bump_phi_s6; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s6 <= theta_p_s5;
            light_azimuth_n70_s6 <= light_azimuth_n70_s5;
            light_azimuth_n71_s6 <= light_azimuth_n71_s5;
            light_azimuth_recip_n81_s6 <= light_azimuth_recip_n81;
            light_azimuth_n82_s6 <= light_azimuth_n82_s5;
            light_azimuth_n91_s6 <= light_azimuth_n91_s5;
            light_azimuth_n95_s6 <= light_azimuth_n95_s5;
            light_polar_angle_n102_s6 <= light_polar_angle_n102_s5;
            light_polar_angle_n123_s6 <= light_polar_angle_n123_s5;
            half_azimuth_n195_s6 <= half_azimuth_n195_s5;
            half_azimuth_n196_s6 <= half_azimuth_n196_s5;
            half_azimuth_recip_n206_s6 <= half_azimuth_recip_n206;
            half_azimuth_n207_s6 <= half_azimuth_n207_s5;
            half_azimuth_n215_s6 <= half_azimuth_n215_s5;
            half_azimuth_n218_s6 <= half_azimuth_n218_s5;
            half_polar_angle_n225_s6 <= half_polar_angle_n225_s5;
            half_polar_angle_n246_s6 <= half_polar_angle_n246_s5;
            bump_phi_s6 <= bump_phi_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // light.azimuth
    wire [1:-38] light_azimuth_n83 = light_azimuth_n82_s6 * light_azimuth_recip_n81_s6; // u40f38
    // half.azimuth
    wire [1:-38] half_azimuth_n208 = half_azimuth_n207_s6 * half_azimuth_recip_n206_s6; // u40f38

    reg [-1:-16] theta_p_s7; // u16f16
    reg light_azimuth_n70_s7; // u1f0
    reg [1:-18] light_azimuth_n71_s7; // u20f18
    reg [1:-38] light_azimuth_n83_s7; // u40f38
    reg light_azimuth_n91_s7; // u1f0
    reg light_azimuth_n95_s7; // u1f0
    reg [1:-18] light_polar_angle_n102_s7; // u20f18
    reg light_polar_angle_n123_s7; // u1f0
    reg half_azimuth_n195_s7; // u1f0
    reg [1:-18] half_azimuth_n196_s7; // u20f18
    reg [1:-38] half_azimuth_n208_s7; // u40f38
    reg half_azimuth_n215_s7; // u1f0
    reg half_azimuth_n218_s7; // u1f0
    reg [1:-18] half_polar_angle_n225_s7; // u20f18
    reg half_polar_angle_n246_s7; // u1f0
    reg [-1:-16] bump_phi_s7; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s7 <= theta_p_s6;
            light_azimuth_n70_s7 <= light_azimuth_n70_s6;
            light_azimuth_n71_s7 <= light_azimuth_n71_s6;
            light_azimuth_n83_s7 <= light_azimuth_n83;
            light_azimuth_n91_s7 <= light_azimuth_n91_s6;
            light_azimuth_n95_s7 <= light_azimuth_n95_s6;
            light_polar_angle_n102_s7 <= light_polar_angle_n102_s6;
            light_polar_angle_n123_s7 <= light_polar_angle_n123_s6;
            half_azimuth_n195_s7 <= half_azimuth_n195_s6;
            half_azimuth_n196_s7 <= half_azimuth_n196_s6;
            half_azimuth_n208_s7 <= half_azimuth_n208;
            half_azimuth_n215_s7 <= half_azimuth_n215_s6;
            half_azimuth_n218_s7 <= half_azimuth_n218_s6;
            half_polar_angle_n225_s7 <= half_polar_angle_n225_s6;
            half_polar_angle_n246_s7 <= half_polar_angle_n246_s6;
            bump_phi_s7 <= bump_phi_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // light.azimuth
    wire [2:-38] light_azimuth_ratio_sum = {1'b0, light_azimuth_n83_s7} + 41'h80000;
    wire [2:-18] light_azimuth_ratio_cut = light_azimuth_ratio_sum[2:-18];
    wire light_azimuth_ratio_over = |light_azimuth_ratio_cut[2:0];
    wire [-1:-18] light_azimuth_ratio = light_azimuth_ratio_over ? 18'h3ffff : light_azimuth_ratio_cut[-1:-18]; // u18f18
    // light.azimuth.atan
    wire [9:0] light_azimuth_atan_n85 = light_azimuth_ratio[-1:-10]; // u10f0
    // half.azimuth
    wire [2:-38] half_azimuth_ratio_sum = {1'b0, half_azimuth_n208_s7} + 41'h80000;
    wire [2:-18] half_azimuth_ratio_cut = half_azimuth_ratio_sum[2:-18];
    wire half_azimuth_ratio_over = |half_azimuth_ratio_cut[2:0];
    wire [-1:-18] half_azimuth_ratio = half_azimuth_ratio_over ? 18'h3ffff : half_azimuth_ratio_cut[-1:-18]; // u18f18
    // half.azimuth.atan
    wire [9:0] half_azimuth_atan_n210 = half_azimuth_ratio[-1:-10]; // u10f0

    reg [-1:-16] theta_p_s8; // u16f16
    reg light_azimuth_n70_s8; // u1f0
    reg [1:-18] light_azimuth_n71_s8; // u20f18
    reg [37:0] atan_row;
    reg light_azimuth_n91_s8; // u1f0
    reg light_azimuth_n95_s8; // u1f0
    reg [1:-18] light_polar_angle_n102_s8; // u20f18
    reg light_polar_angle_n123_s8; // u1f0
    reg half_azimuth_n195_s8; // u1f0
    reg [1:-18] half_azimuth_n196_s8; // u20f18
    reg [37:0] atan_row_2;
    reg half_azimuth_n215_s8; // u1f0
    reg half_azimuth_n218_s8; // u1f0
    reg [1:-18] half_polar_angle_n225_s8; // u20f18
    reg half_polar_angle_n246_s8; // u1f0
    reg [-1:-16] bump_phi_s8; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s8 <= theta_p_s7;
            light_azimuth_n70_s8 <= light_azimuth_n70_s7;
            light_azimuth_n71_s8 <= light_azimuth_n71_s7;
            atan_row <= atan_rom[light_azimuth_atan_n85];
            light_azimuth_n91_s8 <= light_azimuth_n91_s7;
            light_azimuth_n95_s8 <= light_azimuth_n95_s7;
            light_polar_angle_n102_s8 <= light_polar_angle_n102_s7;
            light_polar_angle_n123_s8 <= light_polar_angle_n123_s7;
            half_azimuth_n195_s8 <= half_azimuth_n195_s7;
            half_azimuth_n196_s8 <= half_azimuth_n196_s7;
            atan_row_2 <= atan_rom[half_azimuth_atan_n210];
            half_azimuth_n215_s8 <= half_azimuth_n215_s7;
            half_azimuth_n218_s8 <= half_azimuth_n218_s7;
            half_polar_angle_n225_s8 <= half_polar_angle_n225_s7;
            half_polar_angle_n246_s8 <= half_polar_angle_n246_s7;
            bump_phi_s8 <= bump_phi_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // light.azimuth.atan
    wire [0:-18] light_azimuth_atan_n86 = atan_row[37:19]; // u19f18
    wire [0:-18] light_azimuth_atan_n87 = atan_row[18:0]; // u19f18
    // light.azimuth
    wire signed [1:-18] light_azimuth_n89 = {1'b0, light_azimuth_n88} - {1'b0, light_azimuth_atan_n86}; // s20f18
    wire signed [1:-18] light_azimuth_n90 = light_azimuth_n70_s8 ? light_azimuth_n89 : {1'b0, light_azimuth_atan_n86}; // s20f18
    // half.azimuth.atan
    wire [0:-18] half_azimuth_atan_n211 = atan_row_2[37:19]; // u19f18
    wire [0:-18] half_azimuth_atan_n212 = atan_row_2[18:0]; // u19f18
    // half.azimuth
    wire signed [1:-18] half_azimuth_n213 = {1'b0, light_azimuth_n88} - {1'b0, half_azimuth_atan_n211}; // s20f18
    wire signed [1:-18] half_azimuth_n214 = half_azimuth_n195_s8 ? half_azimuth_n213 : {1'b0, half_azimuth_atan_n211}; // s20f18

    reg [-1:-16] theta_p_s9; // u16f16
    reg [1:-18] light_azimuth_n71_s9; // u20f18
    reg [0:-18] light_azimuth_atan_n87_s9; // u19f18
    reg signed [1:-18] light_azimuth_n90_s9; // s20f18
    reg light_azimuth_n91_s9; // u1f0
    reg light_azimuth_n95_s9; // u1f0
    reg [1:-18] light_polar_angle_n102_s9; // u20f18
    reg light_polar_angle_n123_s9; // u1f0
    reg [1:-18] half_azimuth_n196_s9; // u20f18
    reg [0:-18] half_azimuth_atan_n212_s9; // u19f18
    reg signed [1:-18] half_azimuth_n214_s9; // s20f18
    reg half_azimuth_n215_s9; // u1f0
    reg half_azimuth_n218_s9; // u1f0
    reg [1:-18] half_polar_angle_n225_s9; // u20f18
    reg half_polar_angle_n246_s9; // u1f0
    reg [-1:-16] bump_phi_s9; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s9 <= theta_p_s8;
            light_azimuth_n71_s9 <= light_azimuth_n71_s8;
            light_azimuth_atan_n87_s9 <= light_azimuth_atan_n87;
            light_azimuth_n90_s9 <= light_azimuth_n90;
            light_azimuth_n91_s9 <= light_azimuth_n91_s8;
            light_azimuth_n95_s9 <= light_azimuth_n95_s8;
            light_polar_angle_n102_s9 <= light_polar_angle_n102_s8;
            light_polar_angle_n123_s9 <= light_polar_angle_n123_s8;
            half_azimuth_n196_s9 <= half_azimuth_n196_s8;
            half_azimuth_atan_n212_s9 <= half_azimuth_atan_n212;
            half_azimuth_n214_s9 <= half_azimuth_n214;
            half_azimuth_n215_s9 <= half_azimuth_n215_s8;
            half_azimuth_n218_s9 <= half_azimuth_n218_s8;
            half_polar_angle_n225_s9 <= half_polar_angle_n225_s8;
            half_polar_angle_n246_s9 <= half_polar_angle_n246_s8;
            bump_phi_s9 <= bump_phi_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // light.azimuth
    wire signed [2:-18] light_azimuth_n93 = {2'h0, light_azimuth_n92} - {light_azimuth_n90_s9[1], light_azimuth_n90_s9}; // s21f18
    wire signed [2:-18] light_azimuth_n94 = light_azimuth_n91_s9 ? light_azimuth_n93 : {light_azimuth_n90_s9[1], light_azimuth_n90_s9}; // s21f18
    wire signed [3:-18] light_azimuth_n96 = -{light_azimuth_n94[2], light_azimuth_n94}; // s22f18
    wire signed [3:-18] light_azimuth_n97 = light_azimuth_n95_s9 ? light_azimuth_n96 : {light_azimuth_n94[2], light_azimuth_n94}; // s22f18
    wire [-1:-18] light_azimuth_n98 = light_azimuth_n97[-1:-18]; // u18f18
    wire [2:-36] light_azimuth_n99 = light_azimuth_n71_s9 * light_azimuth_atan_n87_s9; // u39f36
    // light
    wire [0:-18] light_n130_sum = {1'b0, light_azimuth_n98} + 19'h2;
    wire [0:-16] light_n130_cut = light_n130_sum[0:-16];
    wire [0:-16] light_n130 = light_n130_cut; // u17f16
    wire [-1:-16] light_phi = light_n130[-1:-16]; // u16f16
    // half.azimuth
    wire signed [2:-18] half_azimuth_n216 = {2'h0, light_azimuth_n92} - {half_azimuth_n214_s9[1], half_azimuth_n214_s9}; // s21f18
    wire signed [2:-18] half_azimuth_n217 = half_azimuth_n215_s9 ? half_azimuth_n216 : {half_azimuth_n214_s9[1], half_azimuth_n214_s9}; // s21f18
    wire signed [3:-18] half_azimuth_n219 = -{half_azimuth_n217[2], half_azimuth_n217}; // s22f18
    wire signed [3:-18] half_azimuth_n220 = half_azimuth_n218_s9 ? half_azimuth_n219 : {half_azimuth_n217[2], half_azimuth_n217}; // s22f18
    wire [-1:-18] half_azimuth_n221 = half_azimuth_n220[-1:-18]; // u18f18
    wire [2:-36] half_azimuth_n222 = half_azimuth_n196_s9 * half_azimuth_atan_n212_s9; // u39f36
    // half
    wire [0:-18] half_n253_sum = {1'b0, half_azimuth_n221} + 19'h2;
    wire [0:-16] half_n253_cut = half_n253_sum[0:-16];
    wire [0:-16] half_n253 = half_n253_cut; // u17f16
    wire [-1:-16] half_phi = half_n253[-1:-16]; // u16f16

    reg [-1:-16] theta_p_s10; // u16f16
    reg [2:-36] light_azimuth_n99_s10; // u39f36
    reg [1:-18] light_polar_angle_n102_s10; // u20f18
    reg light_polar_angle_n123_s10; // u1f0
    reg [-1:-16] light_phi_s10; // u16f16
    reg [2:-36] half_azimuth_n222_s10; // u39f36
    reg [1:-18] half_polar_angle_n225_s10; // u20f18
    reg half_polar_angle_n246_s10; // u1f0
    reg [-1:-16] half_phi_s10; // u16f16
    reg [-1:-16] bump_phi_s10; // u16f16
    always @(posedge clk)
        if (ce) begin
            theta_p_s10 <= theta_p_s9;
            light_azimuth_n99_s10 <= light_azimuth_n99;
            light_polar_angle_n102_s10 <= light_polar_angle_n102_s9;
            light_polar_angle_n123_s10 <= light_polar_angle_n123_s9;
            light_phi_s10 <= light_phi;
            half_azimuth_n222_s10 <= half_azimuth_n222;
            half_polar_angle_n225_s10 <= half_polar_angle_n225_s9;
            half_polar_angle_n246_s10 <= half_polar_angle_n246_s9;
            half_phi_s10 <= half_phi;
            bump_phi_s10 <= bump_phi_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // light.azimuth
    wire [3:-36] light_azimuth_n100_sum = {1'b0, light_azimuth_n99_s10} + 40'h20000;
    wire [3:-18] light_azimuth_n100_cut = light_azimuth_n100_sum[3:-18];
    wire light_azimuth_n100_over = |light_azimuth_n100_cut[3:2];
    wire signed [2:-18] light_azimuth_n100 = light_azimuth_n100_over ? 21'hfffff : light_azimuth_n100_cut[2:-18]; // s21f18
    // light
    wire light_n101_over = ~light_azimuth_n100[2] & (|light_azimuth_n100[1]);
    wire light_n101_under = light_azimuth_n100[2] & ~(&light_azimuth_n100[1]);
    wire signed [1:-18] light_n101 = light_n101_over ? 20'h7ffff : light_n101_under ? 20'h80000 : light_azimuth_n100[1:-18]; // s20f18
    // light.polar_angle
    wire [1:-18] light_polar_angle_n103_neg = -light_n101;
    wire [1:-18] light_polar_angle_n103 = light_n101[1] ? light_polar_angle_n103_neg : light_n101; // u20f18
    wire light_polar_angle_n126 = light_n101[1]; // u1f0
    // half.azimuth
    wire [3:-36] half_azimuth_n223_sum = {1'b0, half_azimuth_n222_s10} + 40'h20000;
    wire [3:-18] half_azimuth_n223_cut = half_azimuth_n223_sum[3:-18];
    wire half_azimuth_n223_over = |half_azimuth_n223_cut[3:2];
    wire signed [2:-18] half_azimuth_n223 = half_azimuth_n223_over ? 21'hfffff : half_azimuth_n223_cut[2:-18]; // s21f18
    // half
    wire half_n224_over = ~half_azimuth_n223[2] & (|half_azimuth_n223[1]);
    wire half_n224_under = half_azimuth_n223[2] & ~(&half_azimuth_n223[1]);
    wire signed [1:-18] half_n224 = half_n224_over ? 20'h7ffff : half_n224_under ? 20'h80000 : half_azimuth_n223[1:-18]; // s20f18
    // half.polar_angle
    wire [1:-18] half_polar_angle_n226_neg = -half_n224;
    wire [1:-18] half_polar_angle_n226 = half_n224[1] ? half_polar_angle_n226_neg : half_n224; // u20f18
    wire half_polar_angle_n249 = half_n224[1]; // u1f0
    // dot_l
    wire signed [0:-16] dot_l_n259 = {1'b0, light_phi_s10} - {1'b0, bump_phi_s10}; // s17f16
    wire [-1:-16] dot_l_delta = dot_l_n259[-1:-16]; // u16f16
    // dot_l.cos
    wire [9:0] dot_l_cos_n269 = dot_l_delta[-1:-10]; // u10f0
    // dot_h
    wire signed [0:-16] dot_h_n278 = {1'b0, half_phi_s10} - {1'b0, bump_phi_s10}; // s17f16
    wire [-1:-16] dot_h_delta = dot_h_n278[-1:-16]; // u16f16
    // dot_h.cos
    wire [9:0] dot_h_cos_n288 = dot_h_delta[-1:-10]; // u10f0

    reg [-1:-16] theta_p_s11; // u16f16
    reg [1:-18] light_polar_angle_n102_s11; // u20f18
    reg [1:-18] light_polar_angle_n103_s11; // u20f18
    reg light_polar_angle_n123_s11; // u1f0
    reg light_polar_angle_n126_s11; // u1f0
    reg [1:-18] half_polar_angle_n225_s11; // u20f18
    reg [1:-18] half_polar_angle_n226_s11; // u20f18
    reg half_polar_angle_n246_s11; // u1f0
    reg half_polar_angle_n249_s11; // u1f0
    reg [19:0] cos_row;
    reg [19:0] cos_row_2;
    always @(posedge clk)
        if (ce) begin
            theta_p_s11 <= theta_p_s10;
            light_polar_angle_n102_s11 <= light_polar_angle_n102_s10;
            light_polar_angle_n103_s11 <= light_polar_angle_n103;
            light_polar_angle_n123_s11 <= light_polar_angle_n123_s10;
            light_polar_angle_n126_s11 <= light_polar_angle_n126;
            half_polar_angle_n225_s11 <= half_polar_angle_n225_s10;
            half_polar_angle_n226_s11 <= half_polar_angle_n226;
            half_polar_angle_n246_s11 <= half_polar_angle_n246_s10;
            half_polar_angle_n249_s11 <= half_polar_angle_n249;
            cos_row <= cos_rom[dot_l_cos_n269];
            cos_row_2 <= cos_rom[dot_h_cos_n288];
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // light.polar_angle
    wire light_polar_angle_n104 = light_polar_angle_n102_s11 < light_polar_angle_n103_s11; // u1f0
    wire [1:-18] light_polar_angle_n105 = light_polar_angle_n104 ? light_polar_angle_n103_s11 : light_polar_angle_n102_s11; // u20f18
    wire [1:-18] light_polar_angle_n106 = light_polar_angle_n104 ? light_polar_angle_n102_s11 : light_polar_angle_n103_s11; // u20f18
    wire [31:0] light_polar_angle_n107_padded = {light_polar_angle_n105, 12'hfff};
    wire light_polar_angle_n107_skip16 = light_polar_angle_n107_padded[31:16] == 16'h0;
    wire [15:0] light_polar_angle_n107_part16 = light_polar_angle_n107_skip16 ? light_polar_angle_n107_padded[15:0] : light_polar_angle_n107_padded[31:16];
    wire light_polar_angle_n107_skip8 = light_polar_angle_n107_part16[15:8] == 8'h0;
    wire [7:0] light_polar_angle_n107_part8 = light_polar_angle_n107_skip8 ? light_polar_angle_n107_part16[7:0] : light_polar_angle_n107_part16[15:8];
    wire light_polar_angle_n107_skip4 = light_polar_angle_n107_part8[7:4] == 4'h0;
    wire [3:0] light_polar_angle_n107_part4 = light_polar_angle_n107_skip4 ? light_polar_angle_n107_part8[3:0] : light_polar_angle_n107_part8[7:4];
    wire light_polar_angle_n107_skip2 = light_polar_angle_n107_part4[3:2] == 2'h0;
    wire [1:0] light_polar_angle_n107_part2 = light_polar_angle_n107_skip2 ? light_polar_angle_n107_part4[1:0] : light_polar_angle_n107_part4[3:2];
    wire light_polar_angle_n107_skip1 = light_polar_angle_n107_part2[1] == 1'b0;
    wire [4:0] light_polar_angle_n107 = {light_polar_angle_n107_skip16, light_polar_angle_n107_skip8, light_polar_angle_n107_skip4, light_polar_angle_n107_skip2, light_polar_angle_n107_skip1}; // u5f0
    // half.polar_angle
    wire half_polar_angle_n227 = half_polar_angle_n225_s11 < half_polar_angle_n226_s11; // u1f0
    wire [1:-18] half_polar_angle_n228 = half_polar_angle_n227 ? half_polar_angle_n226_s11 : half_polar_angle_n225_s11; // u20f18
    wire [1:-18] half_polar_angle_n229 = half_polar_angle_n227 ? half_polar_angle_n225_s11 : half_polar_angle_n226_s11; // u20f18
    wire [31:0] half_polar_angle_n230_padded = {half_polar_angle_n228, 12'hfff};
    wire half_polar_angle_n230_skip16 = half_polar_angle_n230_padded[31:16] == 16'h0;
    wire [15:0] half_polar_angle_n230_part16 = half_polar_angle_n230_skip16 ? half_polar_angle_n230_padded[15:0] : half_polar_angle_n230_padded[31:16];
    wire half_polar_angle_n230_skip8 = half_polar_angle_n230_part16[15:8] == 8'h0;
    wire [7:0] half_polar_angle_n230_part8 = half_polar_angle_n230_skip8 ? half_polar_angle_n230_part16[7:0] : half_polar_angle_n230_part16[15:8];
    wire half_polar_angle_n230_skip4 = half_polar_angle_n230_part8[7:4] == 4'h0;
    wire [3:0] half_polar_angle_n230_part4 = half_polar_angle_n230_skip4 ? half_polar_angle_n230_part8[3:0] : half_polar_angle_n230_part8[7:4];
    wire half_polar_angle_n230_skip2 = half_polar_angle_n230_part4[3:2] == 2'h0;
    wire [1:0] half_polar_angle_n230_part2 = half_polar_angle_n230_skip2 ? half_polar_angle_n230_part4[1:0] : half_polar_angle_n230_part4[3:2];
    wire half_polar_angle_n230_skip1 = half_polar_angle_n230_part2[1] == 1'b0;
    wire [4:0] half_polar_angle_n230 = {half_polar_angle_n230_skip16, half_polar_angle_n230_skip8, half_polar_angle_n230_skip4, half_polar_angle_n230_skip2, half_polar_angle_n230_skip1}; // u5f0
    // dot_l.cos
    wire signed [1:-18] dot_l_cos_cos_delta = cos_row; // s20f18
    // dot_h.cos
    wire signed [1:-18] dot_h_cos_cos_delta = cos_row_2; // s20f18

    reg [-1:-16] theta_p_s12; // u16f16
    reg light_polar_angle_n104_s12; // u1f0
    reg [1:-18] light_polar_angle_n105_s12; // u20f18
    reg [1:-18] light_polar_angle_n106_s12; // u20f18
    reg [4:0] light_polar_angle_n107_s12; // u5f0
    reg light_polar_angle_n123_s12; // u1f0
    reg light_polar_angle_n126_s12; // u1f0
    reg half_polar_angle_n227_s12; // u1f0
    reg [1:-18] half_polar_angle_n228_s12; // u20f18
    reg [1:-18] half_polar_angle_n229_s12; // u20f18
    reg [4:0] half_polar_angle_n230_s12; // u5f0
    reg half_polar_angle_n246_s12; // u1f0
    reg half_polar_angle_n249_s12; // u1f0
    reg signed [1:-18] dot_l_cos_cos_delta_s12; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s12; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s12 <= theta_p_s11;
            light_polar_angle_n104_s12 <= light_polar_angle_n104;
            light_polar_angle_n105_s12 <= light_polar_angle_n105;
            light_polar_angle_n106_s12 <= light_polar_angle_n106;
            light_polar_angle_n107_s12 <= light_polar_angle_n107;
            light_polar_angle_n123_s12 <= light_polar_angle_n123_s11;
            light_polar_angle_n126_s12 <= light_polar_angle_n126_s11;
            half_polar_angle_n227_s12 <= half_polar_angle_n227;
            half_polar_angle_n228_s12 <= half_polar_angle_n228;
            half_polar_angle_n229_s12 <= half_polar_angle_n229;
            half_polar_angle_n230_s12 <= half_polar_angle_n230;
            half_polar_angle_n246_s12 <= half_polar_angle_n246_s11;
            half_polar_angle_n249_s12 <= half_polar_angle_n249_s11;
            dot_l_cos_cos_delta_s12 <= dot_l_cos_cos_delta;
            dot_h_cos_cos_delta_s12 <= dot_h_cos_cos_delta;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // light.polar_angle
    wire light_polar_angle_n108_past = 5'h14 < light_polar_angle_n107_s12;
    wire [4:0] light_polar_angle_n108_count = light_polar_angle_n108_past ? 5'h14 : light_polar_angle_n107_s12;
    wire [21:-18] light_polar_angle_n108 = {20'h0, light_polar_angle_n105_s12} << light_polar_angle_n108_count; // u40f18
    wire [19:0] light_polar_angle_n109 = light_polar_angle_n108[1:-18]; // u20f0
    wire light_polar_angle_n110_past = 5'h14 < light_polar_angle_n107_s12;
    wire [4:0] light_polar_angle_n110_count = light_polar_angle_n110_past ? 5'h14 : light_polar_angle_n107_s12;
    wire [21:-18] light_polar_angle_n110 = {20'h0, light_polar_angle_n106_s12} << light_polar_angle_n110_count; // u40f18
    wire [19:0] light_polar_angle_n111 = light_polar_angle_n110[1:-18]; // u20f0
    wire [18:0] light_polar_angle_n112 = light_polar_angle_n109[18:0]; // u19f0
    wire [-2:-20] light_polar_angle_n113 = light_polar_angle_n112; // u19f20
    // light.polar_angle.recip
    wire [9:0] light_polar_angle_recip_n114 = light_polar_angle_n113[-2:-11]; // u10f0
    // light.polar_angle
    wire [-1:-20] light_polar_angle_n116 = light_polar_angle_n111; // u20f20
    // half.polar_angle
    wire half_polar_angle_n231_past = 5'h14 < half_polar_angle_n230_s12;
    wire [4:0] half_polar_angle_n231_count = half_polar_angle_n231_past ? 5'h14 : half_polar_angle_n230_s12;
    wire [21:-18] half_polar_angle_n231 = {20'h0, half_polar_angle_n228_s12} << half_polar_angle_n231_count; // u40f18
    wire [19:0] half_polar_angle_n232 = half_polar_angle_n231[1:-18]; // u20f0
    wire half_polar_angle_n233_past = 5'h14 < half_polar_angle_n230_s12;
    wire [4:0] half_polar_angle_n233_count = half_polar_angle_n233_past ? 5'h14 : half_polar_angle_n230_s12;
    wire [21:-18] half_polar_angle_n233 = {20'h0, half_polar_angle_n229_s12} << half_polar_angle_n233_count; // u40f18
    wire [19:0] half_polar_angle_n234 = half_polar_angle_n233[1:-18]; // u20f0
    wire [18:0] half_polar_angle_n235 = half_polar_angle_n232[18:0]; // u19f0
    wire [-2:-20] half_polar_angle_n236 = half_polar_angle_n235; // u19f20
    // half.polar_angle.recip
    wire [9:0] half_polar_angle_recip_n237 = half_polar_angle_n236[-2:-11]; // u10f0
    // half.polar_angle
    wire [-1:-20] half_polar_angle_n239 = half_polar_angle_n234; // u20f20

    reg [-1:-16] theta_p_s13; // u16f16
    reg light_polar_angle_n104_s13; // u1f0
    reg [19:0] recip_row_3;
    reg [-1:-20] light_polar_angle_n116_s13; // u20f20
    reg light_polar_angle_n123_s13; // u1f0
    reg light_polar_angle_n126_s13; // u1f0
    reg half_polar_angle_n227_s13; // u1f0
    reg [19:0] recip_row_4;
    reg [-1:-20] half_polar_angle_n239_s13; // u20f20
    reg half_polar_angle_n246_s13; // u1f0
    reg half_polar_angle_n249_s13; // u1f0
    reg signed [1:-18] dot_l_cos_cos_delta_s13; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s13; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s13 <= theta_p_s12;
            light_polar_angle_n104_s13 <= light_polar_angle_n104_s12;
            recip_row_3 <= recip_rom_2[light_polar_angle_recip_n114];
            light_polar_angle_n116_s13 <= light_polar_angle_n116;
            light_polar_angle_n123_s13 <= light_polar_angle_n123_s12;
            light_polar_angle_n126_s13 <= light_polar_angle_n126_s12;
            half_polar_angle_n227_s13 <= half_polar_angle_n227_s12;
            recip_row_4 <= recip_rom_2[half_polar_angle_recip_n237];
            half_polar_angle_n239_s13 <= half_polar_angle_n239;
            half_polar_angle_n246_s13 <= half_polar_angle_n246_s12;
            half_polar_angle_n249_s13 <= half_polar_angle_n249_s12;
            dot_l_cos_cos_delta_s13 <= dot_l_cos_cos_delta_s12;
            dot_h_cos_cos_delta_s13 <= dot_h_cos_cos_delta_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // light.polar_angle.recip
    wire [1:-18] light_polar_angle_recip_n115 = recip_row_3; // u20f18
    // half.polar_angle.recip
    wire [1:-18] half_polar_angle_recip_n238 = recip_row_4; // u20f18

    reg [-1:-16] theta_p_s14; // u16f16
    reg light_polar_angle_n104_s14; // u1f0
    reg [1:-18] light_polar_angle_recip_n115_s14; // u20f18
    reg [-1:-20] light_polar_angle_n116_s14; // u20f20
    reg light_polar_angle_n123_s14; // u1f0
    reg light_polar_angle_n126_s14; // u1f0
    reg half_polar_angle_n227_s14; // u1f0
    reg [1:-18] half_polar_angle_recip_n238_s14; // u20f18
    reg [-1:-20] half_polar_angle_n239_s14; // u20f20
    reg half_polar_angle_n246_s14; // u1f0
    reg half_polar_angle_n249_s14; // u1f0
    reg signed [1:-18] dot_l_cos_cos_delta_s14; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s14; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s14 <= theta_p_s13;
            light_polar_angle_n104_s14 <= light_polar_angle_n104_s13;
            light_polar_angle_recip_n115_s14 <= light_polar_angle_recip_n115;
            light_polar_angle_n116_s14 <= light_polar_angle_n116_s13;
            light_polar_angle_n123_s14 <= light_polar_angle_n123_s13;
            light_polar_angle_n126_s14 <= light_polar_angle_n126_s13;
            half_polar_angle_n227_s14 <= half_polar_angle_n227_s13;
            half_polar_angle_recip_n238_s14 <= half_polar_angle_recip_n238;
            half_polar_angle_n239_s14 <= half_polar_angle_n239_s13;
            half_polar_angle_n246_s14 <= half_polar_angle_n246_s13;
            half_polar_angle_n249_s14 <= half_polar_angle_n249_s13;
            dot_l_cos_cos_delta_s14 <= dot_l_cos_cos_delta_s13;
            dot_h_cos_cos_delta_s14 <= dot_h_cos_cos_delta_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // light.polar_angle
    wire [1:-38] light_polar_angle_n117 = light_polar_angle_n116_s14 * light_polar_angle_recip_n115_s14; // u40f38
    // half.polar_angle
    wire [1:-38] half_polar_angle_n240 = half_polar_angle_n239_s14 * half_polar_angle_recip_n238_s14; // u40f38

    reg [-1:-16] theta_p_s15; // u16f16
    reg light_polar_angle_n104_s15; // u1f0
    reg [1:-38] light_polar_angle_n117_s15; // u40f38
    reg light_polar_angle_n123_s15; // u1f0
    reg light_polar_angle_n126_s15; // u1f0
    reg half_polar_angle_n227_s15; // u1f0
    reg [1:-38] half_polar_angle_n240_s15; // u40f38
    reg half_polar_angle_n246_s15; // u1f0
    reg half_polar_angle_n249_s15; // u1f0
    reg signed [1:-18] dot_l_cos_cos_delta_s15; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s15; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s15 <= theta_p_s14;
            light_polar_angle_n104_s15 <= light_polar_angle_n104_s14;
            light_polar_angle_n117_s15 <= light_polar_angle_n117;
            light_polar_angle_n123_s15 <= light_polar_angle_n123_s14;
            light_polar_angle_n126_s15 <= light_polar_angle_n126_s14;
            half_polar_angle_n227_s15 <= half_polar_angle_n227_s14;
            half_polar_angle_n240_s15 <= half_polar_angle_n240;
            half_polar_angle_n246_s15 <= half_polar_angle_n246_s14;
            half_polar_angle_n249_s15 <= half_polar_angle_n249_s14;
            dot_l_cos_cos_delta_s15 <= dot_l_cos_cos_delta_s14;
            dot_h_cos_cos_delta_s15 <= dot_h_cos_cos_delta_s14;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // light.polar_angle
    wire [2:-38] light_polar_angle_ratio_sum = {1'b0, light_polar_angle_n117_s15} + 41'h80000;
    wire [2:-18] light_polar_angle_ratio_cut = light_polar_angle_ratio_sum[2:-18];
    wire light_polar_angle_ratio_over = |light_polar_angle_ratio_cut[2:0];
    wire [-1:-18] light_polar_angle_ratio = light_polar_angle_ratio_over ? 18'h3ffff : light_polar_angle_ratio_cut[-1:-18]; // u18f18
    // light.polar_angle.atan
    wire [9:0] light_polar_angle_atan_n119 = light_polar_angle_ratio[-1:-10]; // u10f0
    // half.polar_angle
    wire [2:-38] half_polar_angle_ratio_sum = {1'b0, half_polar_angle_n240_s15} + 41'h80000;
    wire [2:-18] half_polar_angle_ratio_cut = half_polar_angle_ratio_sum[2:-18];
    wire half_polar_angle_ratio_over = |half_polar_angle_ratio_cut[2:0];
    wire [-1:-18] half_polar_angle_ratio = half_polar_angle_ratio_over ? 18'h3ffff : half_polar_angle_ratio_cut[-1:-18]; // u18f18
    // half.polar_angle.atan
    wire [9:0] half_polar_angle_atan_n242 = half_polar_angle_ratio[-1:-10]; // u10f0

    reg [-1:-16] theta_p_s16; // u16f16
    reg light_polar_angle_n104_s16; // u1f0
    reg [37:0] atan_row_3;
    reg light_polar_angle_n123_s16; // u1f0
    reg light_polar_angle_n126_s16; // u1f0
    reg half_polar_angle_n227_s16; // u1f0
    reg [37:0] atan_row_4;
    reg half_polar_angle_n246_s16; // u1f0
    reg half_polar_angle_n249_s16; // u1f0
    reg signed [1:-18] dot_l_cos_cos_delta_s16; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s16; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s16 <= theta_p_s15;
            light_polar_angle_n104_s16 <= light_polar_angle_n104_s15;
            atan_row_3 <= atan_rom_2[light_polar_angle_atan_n119];
            light_polar_angle_n123_s16 <= light_polar_angle_n123_s15;
            light_polar_angle_n126_s16 <= light_polar_angle_n126_s15;
            half_polar_angle_n227_s16 <= half_polar_angle_n227_s15;
            atan_row_4 <= atan_rom_2[half_polar_angle_atan_n242];
            half_polar_angle_n246_s16 <= half_polar_angle_n246_s15;
            half_polar_angle_n249_s16 <= half_polar_angle_n249_s15;
            dot_l_cos_cos_delta_s16 <= dot_l_cos_cos_delta_s15;
            dot_h_cos_cos_delta_s16 <= dot_h_cos_cos_delta_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // light.polar_angle.atan
    wire [0:-18] light_polar_angle_atan_n120 = atan_row_3[37:19]; // u19f18
    // light.polar_angle
    wire signed [1:-18] light_polar_angle_n121 = {1'b0, light_azimuth_n88} - {1'b0, light_polar_angle_atan_n120}; // s20f18
    wire signed [1:-18] light_polar_angle_n122 = light_polar_angle_n104_s16 ? light_polar_angle_n121 : {1'b0, light_polar_angle_atan_n120}; // s20f18
    // half.polar_angle.atan
    wire [0:-18] half_polar_angle_atan_n243 = atan_row_4[37:19]; // u19f18
    // half.polar_angle
    wire signed [1:-18] half_polar_angle_n244 = {1'b0, light_azimuth_n88} - {1'b0, half_polar_angle_atan_n243}; // s20f18
    wire signed [1:-18] half_polar_angle_n245 = half_polar_angle_n227_s16 ? half_polar_angle_n244 : {1'b0, half_polar_angle_atan_n243}; // s20f18

    reg [-1:-16] theta_p_s17; // u16f16
    reg signed [1:-18] light_polar_angle_n122_s17; // s20f18
    reg light_polar_angle_n123_s17; // u1f0
    reg light_polar_angle_n126_s17; // u1f0
    reg signed [1:-18] half_polar_angle_n245_s17; // s20f18
    reg half_polar_angle_n246_s17; // u1f0
    reg half_polar_angle_n249_s17; // u1f0
    reg signed [1:-18] dot_l_cos_cos_delta_s17; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s17; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s17 <= theta_p_s16;
            light_polar_angle_n122_s17 <= light_polar_angle_n122;
            light_polar_angle_n123_s17 <= light_polar_angle_n123_s16;
            light_polar_angle_n126_s17 <= light_polar_angle_n126_s16;
            half_polar_angle_n245_s17 <= half_polar_angle_n245;
            half_polar_angle_n246_s17 <= half_polar_angle_n246_s16;
            half_polar_angle_n249_s17 <= half_polar_angle_n249_s16;
            dot_l_cos_cos_delta_s17 <= dot_l_cos_cos_delta_s16;
            dot_h_cos_cos_delta_s17 <= dot_h_cos_cos_delta_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // light.polar_angle
    wire signed [2:-18] light_polar_angle_n124 = {2'h0, light_azimuth_n92} - {light_polar_angle_n122_s17[1], light_polar_angle_n122_s17}; // s21f18
    wire signed [2:-18] light_polar_angle_n125 = light_polar_angle_n123_s17 ? light_polar_angle_n124 : {light_polar_angle_n122_s17[1], light_polar_angle_n122_s17}; // s21f18
    wire signed [3:-18] light_polar_angle_n127 = -{light_polar_angle_n125[2], light_polar_angle_n125}; // s22f18
    wire signed [3:-18] light_polar_angle_n128 = light_polar_angle_n126_s17 ? light_polar_angle_n127 : {light_polar_angle_n125[2], light_polar_angle_n125}; // s22f18
    wire [-1:-18] light_polar_angle_n129 = light_polar_angle_n128[-1:-18]; // u18f18
    // light
    wire [0:-18] light_n132_sum = {1'b0, light_polar_angle_n129} + 19'h2;
    wire [0:-16] light_n132_cut = light_n132_sum[0:-16];
    wire [0:-16] light_n132 = light_n132_cut; // u17f16
    wire [-1:-16] light_theta = light_n132[-1:-16]; // u16f16
    // half.polar_angle
    wire signed [2:-18] half_polar_angle_n247 = {2'h0, light_azimuth_n92} - {half_polar_angle_n245_s17[1], half_polar_angle_n245_s17}; // s21f18
    wire signed [2:-18] half_polar_angle_n248 = half_polar_angle_n246_s17 ? half_polar_angle_n247 : {half_polar_angle_n245_s17[1], half_polar_angle_n245_s17}; // s21f18
    wire signed [3:-18] half_polar_angle_n250 = -{half_polar_angle_n248[2], half_polar_angle_n248}; // s22f18
    wire signed [3:-18] half_polar_angle_n251 = half_polar_angle_n249_s17 ? half_polar_angle_n250 : {half_polar_angle_n248[2], half_polar_angle_n248}; // s22f18
    wire [-1:-18] half_polar_angle_n252 = half_polar_angle_n251[-1:-18]; // u18f18
    // half
    wire [0:-18] half_n255_sum = {1'b0, half_polar_angle_n252} + 19'h2;
    wire [0:-16] half_n255_cut = half_n255_sum[0:-16];
    wire [0:-16] half_n255 = half_n255_cut; // u17f16
    wire [-1:-16] half_theta = half_n255[-1:-16]; // u16f16

    reg [-1:-16] theta_p_s18; // u16f16
    reg [-1:-16] light_theta_s18; // u16f16
    reg [-1:-16] half_theta_s18; // u16f16
    reg signed [1:-18] dot_l_cos_cos_delta_s18; // s20f18
    reg signed [1:-18] dot_h_cos_cos_delta_s18; // s20f18
    always @(posedge clk)
        if (ce) begin
            theta_p_s18 <= theta_p_s17;
            light_theta_s18 <= light_theta;
            half_theta_s18 <= half_theta;
            dot_l_cos_cos_delta_s18 <= dot_l_cos_cos_delta_s17;
            dot_h_cos_cos_delta_s18 <= dot_h_cos_cos_delta_s17;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // dot_l
    wire [0:-16] dot_l_n261 = {1'b0, light_theta_s18} + {1'b0, theta_p_s18}; // u17f16
    wire [-1:-16] dot_l_sum = dot_l_n261[-1:-16]; // u16f16
    wire signed [0:-16] dot_l_n263 = {1'b0, light_theta_s18} - {1'b0, theta_p_s18}; // s17f16
    wire [-1:-16] dot_l_difference = dot_l_n263[-1:-16]; // u16f16
    // dot_l.cos
    wire [9:0] dot_l_cos_n265 = dot_l_sum[-1:-10]; // u10f0
    wire [9:0] dot_l_cos_n267 = dot_l_difference[-1:-10]; // u10f0
    // dot_h
    wire [0:-16] dot_h_n280 = {1'b0, half_theta_s18} + {1'b0, theta_p_s18}; // u17f16
    wire [-1:-16] dot_h_sum = dot_h_n280[-1:-16]; // u16f16
    wire signed [0:-16] dot_h_n282 = {1'b0, half_theta_s18} - {1'b0, theta_p_s18}; // s17f16
    wire [-1:-16] dot_h_difference = dot_h_n282[-1:-16]; // u16f16
    // dot_h.cos
    wire [9:0] dot_h_cos_n284 = dot_h_sum[-1:-10]; // u10f0
    wire [9:0] dot_h_cos_n286 = dot_h_difference[-1:-10]; // u10f0

    reg [19:0] cos_row_3;
    reg [19:0] cos_row_4;
    reg signed [1:-18] dot_l_cos_cos_delta_s19; // s20f18
    reg [19:0] cos_row_5;
    reg [19:0] cos_row_6;
    reg signed [1:-18] dot_h_cos_cos_delta_s19; // s20f18
    always @(posedge clk)
        if (ce) begin
            cos_row_3 <= cos_rom_2[dot_l_cos_n265];
            cos_row_4 <= cos_rom_2[dot_l_cos_n267];
            dot_l_cos_cos_delta_s19 <= dot_l_cos_cos_delta_s18;
            cos_row_5 <= cos_rom_3[dot_h_cos_n284];
            cos_row_6 <= cos_rom_3[dot_h_cos_n286];
            dot_h_cos_cos_delta_s19 <= dot_h_cos_cos_delta_s18;
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // dot_l.cos
    wire signed [1:-18] dot_l_cos_cos_sum = cos_row_3; // s20f18
    wire signed [1:-18] dot_l_cos_cos_difference = cos_row_4; // s20f18
    // dot_l
    wire signed [2:-18] dot_l_n271 = {dot_l_cos_cos_sum[1], dot_l_cos_cos_sum} + {dot_l_cos_cos_difference[1], dot_l_cos_cos_difference}; // s21f18
    wire signed [1:-19] dot_l_n272 = dot_l_n271; // s21f19
    wire signed [2:-18] dot_l_n273 = {dot_l_cos_cos_difference[1], dot_l_cos_cos_difference} - {dot_l_cos_cos_sum[1], dot_l_cos_cos_sum}; // s21f18
    wire signed [1:-19] dot_l_n274 = dot_l_n273; // s21f19
    // dot_h.cos
    wire signed [1:-18] dot_h_cos_cos_sum = cos_row_5; // s20f18
    wire signed [1:-18] dot_h_cos_cos_difference = cos_row_6; // s20f18
    // dot_h
    wire signed [2:-18] dot_h_n290 = {dot_h_cos_cos_sum[1], dot_h_cos_cos_sum} + {dot_h_cos_cos_difference[1], dot_h_cos_cos_difference}; // s21f18
    wire signed [1:-19] dot_h_n291 = dot_h_n290; // s21f19
    wire signed [2:-18] dot_h_n292 = {dot_h_cos_cos_difference[1], dot_h_cos_cos_difference} - {dot_h_cos_cos_sum[1], dot_h_cos_cos_sum}; // s21f18
    wire signed [1:-19] dot_h_n293 = dot_h_n292; // s21f19

    reg signed [1:-18] dot_l_cos_cos_delta_s20; // s20f18
    reg signed [1:-19] dot_l_n272_s20; // s21f19
    reg signed [1:-19] dot_l_n274_s20; // s21f19
    reg signed [1:-18] dot_h_cos_cos_delta_s20; // s20f18
    reg signed [1:-19] dot_h_n291_s20; // s21f19
    reg signed [1:-19] dot_h_n293_s20; // s21f19
    always @(posedge clk)
        if (ce) begin
            dot_l_cos_cos_delta_s20 <= dot_l_cos_cos_delta_s19;
            dot_l_n272_s20 <= dot_l_n272;
            dot_l_n274_s20 <= dot_l_n274;
            dot_h_cos_cos_delta_s20 <= dot_h_cos_cos_delta_s19;
            dot_h_n291_s20 <= dot_h_n291;
            dot_h_n293_s20 <= dot_h_n293;
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // dot_l
    wire signed [3:-37] dot_l_n275 = dot_l_n274_s20 * dot_l_cos_cos_delta_s20; // s41f37
    // dot_h
    wire signed [3:-37] dot_h_n294 = dot_h_n293_s20 * dot_h_cos_cos_delta_s20; // s41f37

    reg signed [1:-19] dot_l_n272_s21; // s21f19
    reg signed [3:-37] dot_l_n275_s21; // s41f37
    reg signed [1:-19] dot_h_n291_s21; // s21f19
    reg signed [3:-37] dot_h_n294_s21; // s41f37
    always @(posedge clk)
        if (ce) begin
            dot_l_n272_s21 <= dot_l_n272_s20;
            dot_l_n275_s21 <= dot_l_n275;
            dot_h_n291_s21 <= dot_h_n291_s20;
            dot_h_n294_s21 <= dot_h_n294;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;

    // ---- stage 21 ----
    // dot_l
    wire signed [4:-37] dot_l_n276 = {{3{dot_l_n272_s21[1]}}, dot_l_n272_s21, 18'h0} + {dot_l_n275_s21[3], dot_l_n275_s21}; // s42f37
    // (unit)
    wire signed [5:-37] dot_l_sum_2 = {dot_l_n276[4], dot_l_n276} + 43'h100000;
    wire signed [5:-16] dot_l_cut = dot_l_sum_2[5:-16];
    wire dot_l_over = ~dot_l_cut[5] & (|dot_l_cut[4:1]);
    wire dot_l_under = dot_l_cut[5] & ~(&dot_l_cut[4:1]);
    wire signed [1:-16] dot_l = dot_l_over ? 18'h1ffff : dot_l_under ? 18'h20000 : dot_l_cut[1:-16]; // s18f16
    // dot_h
    wire signed [4:-37] dot_h_n295 = {{3{dot_h_n291_s21[1]}}, dot_h_n291_s21, 18'h0} + {dot_h_n294_s21[3], dot_h_n294_s21}; // s42f37
    // (unit)
    wire signed [5:-37] dot_h_sum_2 = {dot_h_n295[4], dot_h_n295} + 43'h100000;
    wire signed [5:-16] dot_h_cut = dot_h_sum_2[5:-16];
    wire dot_h_over = ~dot_h_cut[5] & (|dot_h_cut[4:1]);
    wire dot_h_under = dot_h_cut[5] & ~(&dot_h_cut[4:1]);
    wire signed [1:-16] dot_h = dot_h_over ? 18'h1ffff : dot_h_under ? 18'h20000 : dot_h_cut[1:-16]; // s18f16
    wire n298 = dot_l[1]; // u1f0
    wire signed [1:-16] n299 = n298 ? {1'b0, n297, 16'h0} : dot_l; // s18f16
    wire diffuse_index_under = n299[1];
    wire [0:-16] diffuse_index = diffuse_index_under ? 17'h0 : n299[0:-16]; // u17f16
    wire n301 = diffuse_index[0]; // u1f0
    wire [15:0] n302 = diffuse_index[-1:-16]; // u16f0
    wire [-1:-16] n303 = n302; // u16f16
    // diffuse
    wire [9:0] diffuse_n304 = n303[-1:-10]; // u10f0
    // (unit)
    wire n310 = dot_h[1]; // u1f0
    wire signed [1:-16] n311 = n310 ? {1'b0, n297, 16'h0} : dot_h; // s18f16
    wire specular_index_under = n311[1];
    wire [0:-16] specular_index = specular_index_under ? 17'h0 : n311[0:-16]; // u17f16
    wire n313 = specular_index[0]; // u1f0
    wire [15:0] n314 = specular_index[-1:-16]; // u16f0
    wire [-1:-16] n315 = n314; // u16f16
    // specular
    wire [9:0] specular_n316 = n315[-1:-10]; // u10f0

    reg n298_s22; // u1f0
    reg n301_s22; // u1f0
    reg [9:0] diffuse_n304_s22; // u10f0
    reg n310_s22; // u1f0
    reg n313_s22; // u1f0
    reg [9:0] specular_n316_s22; // u10f0
    always @(posedge clk)
        if (ce) begin
            n298_s22 <= n298;
            n301_s22 <= n301;
            diffuse_n304_s22 <= diffuse_n304;
            n310_s22 <= n310;
            n313_s22 <= n313;
            specular_n316_s22 <= specular_n316;
        end
    reg valid_s22;
    always @(posedge clk)
        if (rst) valid_s22 <= 1'b0;
        else if (ce) valid_s22 <= valid_s21;

    // ---- stage 22 ----

    reg n298_s23; // u1f0
    reg n301_s23; // u1f0
    reg [15:0] diffuse_row;
    reg n310_s23; // u1f0
    reg n313_s23; // u1f0
    reg [15:0] specular_row;
    always @(posedge clk)
        if (ce) begin
            n298_s23 <= n298_s22;
            n301_s23 <= n301_s22;
            diffuse_row <= diffuse_rom[diffuse_n304_s22];
            n310_s23 <= n310_s22;
            n313_s23 <= n313_s22;
            specular_row <= specular_rom[specular_n316_s22];
        end
    reg valid_s23;
    always @(posedge clk)
        if (rst) valid_s23 <= 1'b0;
        else if (ce) valid_s23 <= valid_s22;

    // ---- stage 23 ----
    // diffuse
    wire [-1:-16] diffuse_n305 = diffuse_row; // u16f16
    // (unit)
    wire [-1:-16] n308 = n301_s23 ? n306 : diffuse_n305; // u16f16
    wire [-1:-16] diffuse_next = n298_s23 ? n307 : n308; // u16f16
    // specular
    wire [-1:-16] specular_n317 = specular_row; // u16f16
    // (unit)
    wire [-1:-16] n320 = n313_s23 ? n318 : specular_n317; // u16f16
    wire [-1:-16] specular_next = n310_s23 ? n319 : n320; // u16f16
    wire [0:-16] n322 = {1'b0, diffuse_next} + {1'b0, specular_next}; // u17f16
    wire intensity_next_over = |n322[0];
    wire [-1:-16] intensity_next = intensity_next_over ? 16'hffff : n322[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            diffuse <= diffuse_next;
            specular <= specular_next;
            intensity <= intensity_next;
        end
    reg valid_s24;
    always @(posedge clk)
        if (rst) valid_s24 <= 1'b0;
        else if (ce) valid_s24 <= valid_s23;
    assign valid_out = valid_s24;

    // ---- stage 24 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        light_angles_n9[0],
        light_angles_n11[0],
        light_angles_n13[0],
        light_angles_n15[0],
        light_angles_x_plus_n[-11:-16],
        light_angles_n17[0],
        light_angles_x_minus_n[-11:-16],
        light_angles_n19[0],
        light_angles_y_plus_n[-11:-16],
        light_angles_n21[0],
        light_angles_y_minus_n[-11:-16],
        light_angles_n23[0],
        light_angles_a_plus_n[-11:-16],
        light_angles_n25[0],
        light_angles_a_minus_n[-11:-16],
        half_angles_n134[0],
        half_angles_n136[0],
        half_angles_n138[0],
        half_angles_n140[0],
        half_angles_x_plus_n[-11:-16],
        half_angles_n142[0],
        half_angles_x_minus_n[-11:-16],
        half_angles_n144[0],
        half_angles_y_plus_n[-11:-16],
        half_angles_n146[0],
        half_angles_y_minus_n[-11:-16],
        half_angles_n148[0],
        half_angles_a_plus_n[-11:-16],
        half_angles_n150[0],
        half_angles_a_minus_n[-11:-16],
        bump_n257[0],
        sincos_row[39:20],
        sincos_row_2[39:20],
        sincos_row_9[39:20],
        sincos_row_10[39:20],
        light_x_sum[-19:-20],
        light_y_sum[-19],
        light_z_sum[-19:-20],
        half_x_sum[-19:-20],
        half_y_sum[-19],
        half_z_sum[-19:-20],
        light_azimuth_n73_part2[0],
        half_azimuth_n198_part2[0],
        light_azimuth_n74[21:2],
        light_azimuth_n75[19],
        light_azimuth_n76[21:2],
        light_azimuth_n79[-12:-20],
        half_azimuth_n199[21:2],
        half_azimuth_n200[19],
        half_azimuth_n201[21:2],
        half_azimuth_n204[-12:-20],
        light_azimuth_ratio[-11:-18],
        light_azimuth_ratio_sum[-19:-38],
        half_azimuth_ratio[-11:-18],
        half_azimuth_ratio_sum[-19:-38],
        light_azimuth_n97[3:0],
        light_n130[0],
        light_n130_sum[-17:-18],
        half_azimuth_n220[3:0],
        half_n253[0],
        half_n253_sum[-17:-18],
        light_azimuth_n100_sum[-19:-36],
        half_azimuth_n223_sum[-19:-36],
        dot_l_n259[0],
        dot_l_delta[-11:-16],
        dot_h_n278[0],
        dot_h_delta[-11:-16],
        light_polar_angle_n107_part2[0],
        half_polar_angle_n230_part2[0],
        light_polar_angle_n108[21:2],
        light_polar_angle_n109[19],
        light_polar_angle_n110[21:2],
        light_polar_angle_n113[-12:-20],
        half_polar_angle_n231[21:2],
        half_polar_angle_n232[19],
        half_polar_angle_n233[21:2],
        half_polar_angle_n236[-12:-20],
        light_polar_angle_ratio[-11:-18],
        light_polar_angle_ratio_sum[-19:-38],
        half_polar_angle_ratio[-11:-18],
        half_polar_angle_ratio_sum[-19:-38],
        atan_row_3[18:0],
        atan_row_4[18:0],
        light_polar_angle_n128[3:0],
        light_n132[0],
        light_n132_sum[-17:-18],
        half_polar_angle_n251[3:0],
        half_n255[0],
        half_n255_sum[-17:-18],
        dot_l_n261[0],
        dot_l_sum[-11:-16],
        dot_l_n263[0],
        dot_l_difference[-11:-16],
        dot_h_n280[0],
        dot_h_sum[-11:-16],
        dot_h_n282[0],
        dot_h_difference[-11:-16],
        dot_l_sum_2[-17:-37],
        dot_h_sum_2[-17:-37],
        n303[-11:-16],
        n315[-11:-16]};
endmodule
