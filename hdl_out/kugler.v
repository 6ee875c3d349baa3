// kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
// made by fixpath 0.1.0; Kugler 1998 (IMEM), as seed 001 (Lee et al.) describes it; largely a reconstruction
//   conversion=table tilt_addr_bits=14 map_angle_bits=8 map_addr_bits=12 angle_bits=16
//   table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up
//   recip_addr_bits=auto atan_addr_bits=auto cordic_iterations=auto highlight=on light_bits=16
//   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 21 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 1.64e-2, largest seen 3.21e-1 (21034.8 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
//   diffuse: mean 1.43e-2, largest seen 1.61e-1 (10548.1 ulp) at n_x=64337 n_y=68 n_z=-12481 psi=46469 phi_p=59889 theta_p=8345 phi_l=60553 theta_l=24577 phi_h=60753 theta_h=28326
//   specular: mean 3.33e-3, largest seen 2.10e-1 (13738.9 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
//   pw_angle: mean 6.11e-2 rad, largest seen 1.66e-1 rad at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
//   pw_dot: mean 6.11e-2, largest seen 1.66e-1 at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
//   pw_x: mean 2.72e-2, largest seen 1.50e-1 at n_x=-40953 n_y=22153 n_z=46120 psi=61767 phi_p=36536 theta_p=8148 phi_l=60944 theta_l=4014 phi_h=33548 theta_h=9549
//   pw_y: mean 2.71e-2, largest seen 1.47e-1 at n_x=13068 n_y=52261 n_z=-37322 psi=50906 phi_p=20746 theta_p=8211 phi_l=13848 theta_l=18740 phi_h=19374 theta_h=27605
//   pw_z: mean 3.70e-2, largest seen 1.56e-1 at n_x=58525 n_y=-14807 n_z=25506 psi=44588 phi_p=12702 theta_p=8159 phi_l=49639 theta_l=20508 phi_h=63118 theta_h=22796
//   pl_angle: mean 8.82e-2 rad, largest seen 2.91e-1 rad at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
//   pl_dot: mean 8.82e-2, largest seen 2.90e-1 at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
//   pl_x: mean 4.70e-2, largest seen 2.78e-1 at n_x=36200 n_y=-53003 n_z=-13238 psi=14755 phi_p=47780 theta_p=7407 phi_l=57722 theta_l=28642 phi_h=58499 theta_h=19711
//   pl_y: mean 3.86e-2, largest seen 1.99e-1 at n_x=1054 n_y=243 n_z=65527 psi=4485 phi_p=44708 theta_p=8256 phi_l=16693 theta_l=28786 phi_h=40236 theta_h=23869
//   pl_z: mean 4.65e-2, largest seen 2.53e-1 at n_x=-21222 n_y=60550 n_z=-13354 psi=8628 phi_p=51032 theta_p=3342 phi_l=50666 theta_l=26736 phi_h=12630 theta_h=28946
//   ph_angle: mean 8.83e-2 rad, largest seen 2.92e-1 rad at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
//   ph_dot: mean 8.83e-2, largest seen 2.91e-1 at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
//   ph_x: mean 4.70e-2, largest seen 2.42e-1 at n_x=40289 n_y=36933 n_z=-36161 psi=5281 phi_p=51702 theta_p=5800 phi_l=12406 theta_l=11093 phi_h=11666 theta_h=24712
//   ph_y: mean 3.87e-2, largest seen 1.90e-1 at n_x=18685 n_y=41876 n_z=-46821 psi=56218 phi_p=58881 theta_p=9312 phi_l=60146 theta_l=20332 phi_h=65052 theta_h=17648
//   ph_z: mean 4.67e-2, largest seen 2.45e-1 at n_x=63088 n_y=-17640 n_z=1940 psi=34649 phi_p=1283 theta_p=7197 phi_l=57191 theta_l=29307 phi_h=60648 theta_h=22533
// no bound is stated: near a pole, a cell of a map has azimuths of the whole turn in it: no cell size bounds the light
module kugler (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [1:-16] n_x, // s18f16
    input  wire signed [1:-16] n_y, // s18f16
    input  wire signed [1:-16] n_z, // s18f16
    input  wire [-1:-16] psi, // u16f16
    input  wire [-1:-16] phi_p, // u16f16
    input  wire [-1:-16] theta_p, // u16f16
    input  wire [-1:-16] phi_l, // u16f16
    input  wire [-1:-16] theta_l, // u16f16
    input  wire [-1:-16] phi_h, // u16f16
    input  wire [-1:-16] theta_h, // u16f16
    output wire valid_out,
    output reg  [-1:-16] intensity, // u16f16
    output reg  [-1:-16] diffuse, // u16f16
    output reg  [-1:-16] specular // u16f16
);

    // table recip: recip u20f18
    (* rom_style = "block" *)
    reg [19:0] recip_rom [0:1023];
    initial $readmemh("kugler_recip.hex", recip_rom);

    // table atan: atan u19f18, secant u19f18
    (* rom_style = "block" *)
    reg [37:0] atan_rom [0:1023];
    initial $readmemh("kugler_atan.hex", atan_rom);

    // table tilt_map: phi u8f8, theta u8f9
    (* rom_style = "block" *)
    reg [15:0] tilt_map_rom [0:16383];
    initial $readmemh("kugler_tilt_map.hex", tilt_map_rom);

    // table diffuse_map: light u16f16
    (* rom_style = "block" *)
    reg [15:0] diffuse_map_rom [0:4095];
    initial $readmemh("kugler_diffuse_map.hex", diffuse_map_rom);

    // table specular_map: light u16f16
    (* rom_style = "block" *)
    reg [15:0] specular_map_rom [0:4095];
    initial $readmemh("kugler_specular_map.hex", specular_map_rom);

    // a copy of table tilt_map: phi u8f8, theta u8f9
    (* rom_style = "block" *)
    reg [15:0] tilt_map_rom_2 [0:16383];
    initial $readmemh("kugler_tilt_map.hex", tilt_map_rom_2);

    // ---- stage 0 ----
    // setup
    wire signed [1:-18] setup_n10_wide = {n_x, 2'h0};
    wire signed [1:-18] setup_n10 = setup_n10_wide; // s20f18
    wire signed [1:-18] setup_n11_wide = {n_y, 2'h0};
    wire signed [1:-18] setup_n11 = setup_n11_wide; // s20f18
    wire signed [1:-18] setup_n12_wide = {n_z, 2'h0};
    wire signed [1:-18] setup_n12 = setup_n12_wide; // s20f18
    // setup.normal.azimuth
    wire [1:-18] setup_normal_azimuth_n13_neg = -setup_n10;
    wire [1:-18] setup_normal_azimuth_n13 = setup_n10[1] ? setup_normal_azimuth_n13_neg : setup_n10; // u20f18
    wire [1:-18] setup_normal_azimuth_n14_neg = -setup_n11;
    wire [1:-18] setup_normal_azimuth_n14 = setup_n11[1] ? setup_normal_azimuth_n14_neg : setup_n11; // u20f18
    wire setup_normal_azimuth_n15 = setup_normal_azimuth_n13 < setup_normal_azimuth_n14; // u1f0
    wire [1:-18] setup_normal_azimuth_n16 = setup_normal_azimuth_n15 ? setup_normal_azimuth_n14 : setup_normal_azimuth_n13; // u20f18
    wire [1:-18] setup_normal_azimuth_n17 = setup_normal_azimuth_n15 ? setup_normal_azimuth_n13 : setup_normal_azimuth_n14; // u20f18
    wire [0:-18] setup_normal_azimuth_n33 = 19'h10000; // u19f18
    wire setup_normal_azimuth_n36 = setup_n10[1]; // u1f0
    wire [0:-18] setup_normal_azimuth_n37 = 19'h20000; // u19f18
    wire setup_normal_azimuth_n40 = setup_n11[1]; // u1f0
    // setup.normal.polar_angle
    wire [1:-18] setup_normal_polar_angle_n47_neg = -setup_n12;
    wire [1:-18] setup_normal_polar_angle_n47 = setup_n12[1] ? setup_normal_polar_angle_n47_neg : setup_n12; // u20f18
    wire setup_normal_polar_angle_n68 = setup_n12[1]; // u1f0
    // setup
    wire [0:-16] setup_n79 = {1'b0, phi_p} + {1'b0, psi}; // u17f16
    wire [-1:-16] setup_phi_texture = setup_n79[-1:-16]; // u16f16
    wire [4:0] setup_n81 = setup_phi_texture[-1:-5]; // u5f0
    wire [-1:-6] setup_n82_cut = theta_p[-1:-6];
    wire setup_n82_over = |setup_n82_cut[-1];
    wire [-2:-6] setup_n82 = setup_n82_over ? 5'h1f : setup_n82_cut[-2:-6]; // u5f6
    wire [4:0] setup_n83 = setup_n82; // u5f0
    wire [9:0] setup_n86 = {setup_n81, setup_n83}; // u10f0
    // light
    wire [-1:-16] light_n94 = 16'h8000; // u16f16
    wire [-1:-5] light_n99_cut = theta_l[-1:-5];
    wire light_n99_over = |light_n99_cut[-1];
    wire [-2:-5] light_n99 = light_n99_over ? 4'hf : light_n99_cut[-2:-5]; // u4f5
    wire [3:0] light_n100 = light_n99; // u4f0
    wire [-1:-8] light_n105 = 8'h80; // u8f8
    // half
    wire [-1:-5] half_n116_cut = theta_h[-1:-5];
    wire half_n116_over = |half_n116_cut[-1];
    wire [-2:-5] half_n116 = half_n116_over ? 4'hf : half_n116_cut[-2:-5]; // u4f5
    wire [3:0] half_n117 = half_n116; // u4f0

    reg [-1:-16] phi_l_s1; // u16f16
    reg [-1:-16] phi_h_s1; // u16f16
    reg setup_normal_azimuth_n15_s1; // u1f0
    reg [1:-18] setup_normal_azimuth_n16_s1; // u20f18
    reg [1:-18] setup_normal_azimuth_n17_s1; // u20f18
    reg setup_normal_azimuth_n36_s1; // u1f0
    reg setup_normal_azimuth_n40_s1; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s1; // u20f18
    reg setup_normal_polar_angle_n68_s1; // u1f0
    reg [9:0] setup_n86_s1; // u10f0
    reg [3:0] light_n100_s1; // u4f0
    reg [3:0] half_n117_s1; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s1 <= phi_l;
            phi_h_s1 <= phi_h;
            setup_normal_azimuth_n15_s1 <= setup_normal_azimuth_n15;
            setup_normal_azimuth_n16_s1 <= setup_normal_azimuth_n16;
            setup_normal_azimuth_n17_s1 <= setup_normal_azimuth_n17;
            setup_normal_azimuth_n36_s1 <= setup_normal_azimuth_n36;
            setup_normal_azimuth_n40_s1 <= setup_normal_azimuth_n40;
            setup_normal_polar_angle_n47_s1 <= setup_normal_polar_angle_n47;
            setup_normal_polar_angle_n68_s1 <= setup_normal_polar_angle_n68;
            setup_n86_s1 <= setup_n86;
            light_n100_s1 <= light_n100;
            half_n117_s1 <= half_n117;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // setup.normal.azimuth
    wire [31:0] setup_normal_azimuth_n18_padded = {setup_normal_azimuth_n16_s1, 12'hfff};
    wire setup_normal_azimuth_n18_skip16 = setup_normal_azimuth_n18_padded[31:16] == 16'h0;
    wire [15:0] setup_normal_azimuth_n18_part16 = setup_normal_azimuth_n18_skip16 ? setup_normal_azimuth_n18_padded[15:0] : setup_normal_azimuth_n18_padded[31:16];
    wire setup_normal_azimuth_n18_skip8 = setup_normal_azimuth_n18_part16[15:8] == 8'h0;
    wire [7:0] setup_normal_azimuth_n18_part8 = setup_normal_azimuth_n18_skip8 ? setup_normal_azimuth_n18_part16[7:0] : setup_normal_azimuth_n18_part16[15:8];
    wire setup_normal_azimuth_n18_skip4 = setup_normal_azimuth_n18_part8[7:4] == 4'h0;
    wire [3:0] setup_normal_azimuth_n18_part4 = setup_normal_azimuth_n18_skip4 ? setup_normal_azimuth_n18_part8[3:0] : setup_normal_azimuth_n18_part8[7:4];
    wire setup_normal_azimuth_n18_skip2 = setup_normal_azimuth_n18_part4[3:2] == 2'h0;
    wire [1:0] setup_normal_azimuth_n18_part2 = setup_normal_azimuth_n18_skip2 ? setup_normal_azimuth_n18_part4[1:0] : setup_normal_azimuth_n18_part4[3:2];
    wire setup_normal_azimuth_n18_skip1 = setup_normal_azimuth_n18_part2[1] == 1'b0;
    wire [4:0] setup_normal_azimuth_n18 = {setup_normal_azimuth_n18_skip16, setup_normal_azimuth_n18_skip8, setup_normal_azimuth_n18_skip4, setup_normal_azimuth_n18_skip2, setup_normal_azimuth_n18_skip1}; // u5f0
    wire setup_normal_azimuth_n19_past = 5'h14 < setup_normal_azimuth_n18;
    wire [4:0] setup_normal_azimuth_n19_count = setup_normal_azimuth_n19_past ? 5'h14 : setup_normal_azimuth_n18;
    wire [21:-18] setup_normal_azimuth_n19 = {20'h0, setup_normal_azimuth_n16_s1} << setup_normal_azimuth_n19_count; // u40f18
    wire [19:0] setup_normal_azimuth_n20 = setup_normal_azimuth_n19[1:-18]; // u20f0
    wire setup_normal_azimuth_n21_past = 5'h14 < setup_normal_azimuth_n18;
    wire [4:0] setup_normal_azimuth_n21_count = setup_normal_azimuth_n21_past ? 5'h14 : setup_normal_azimuth_n18;
    wire [21:-18] setup_normal_azimuth_n21 = {20'h0, setup_normal_azimuth_n17_s1} << setup_normal_azimuth_n21_count; // u40f18
    wire [19:0] setup_normal_azimuth_n22 = setup_normal_azimuth_n21[1:-18]; // u20f0
    wire [18:0] setup_normal_azimuth_n23 = setup_normal_azimuth_n20[18:0]; // u19f0
    wire [-2:-20] setup_normal_azimuth_n24 = setup_normal_azimuth_n23; // u19f20
    // setup.normal.azimuth.recip
    wire [9:0] setup_normal_azimuth_recip_n25 = setup_normal_azimuth_n24[-2:-11]; // u10f0
    // setup.normal.azimuth
    wire [-1:-20] setup_normal_azimuth_n27 = setup_normal_azimuth_n22; // u20f20

    reg [-1:-16] phi_l_s2; // u16f16
    reg [-1:-16] phi_h_s2; // u16f16
    reg setup_normal_azimuth_n15_s2; // u1f0
    reg [1:-18] setup_normal_azimuth_n16_s2; // u20f18
    reg [9:0] setup_normal_azimuth_recip_n25_s2; // u10f0
    reg [-1:-20] setup_normal_azimuth_n27_s2; // u20f20
    reg setup_normal_azimuth_n36_s2; // u1f0
    reg setup_normal_azimuth_n40_s2; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s2; // u20f18
    reg setup_normal_polar_angle_n68_s2; // u1f0
    reg [9:0] setup_n86_s2; // u10f0
    reg [3:0] light_n100_s2; // u4f0
    reg [3:0] half_n117_s2; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s2 <= phi_l_s1;
            phi_h_s2 <= phi_h_s1;
            setup_normal_azimuth_n15_s2 <= setup_normal_azimuth_n15_s1;
            setup_normal_azimuth_n16_s2 <= setup_normal_azimuth_n16_s1;
            setup_normal_azimuth_recip_n25_s2 <= setup_normal_azimuth_recip_n25;
            setup_normal_azimuth_n27_s2 <= setup_normal_azimuth_n27;
            setup_normal_azimuth_n36_s2 <= setup_normal_azimuth_n36_s1;
            setup_normal_azimuth_n40_s2 <= setup_normal_azimuth_n40_s1;
            setup_normal_polar_angle_n47_s2 <= setup_normal_polar_angle_n47_s1;
            setup_normal_polar_angle_n68_s2 <= setup_normal_polar_angle_n68_s1;
            setup_n86_s2 <= setup_n86_s1;
            light_n100_s2 <= light_n100_s1;
            half_n117_s2 <= half_n117_s1;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----

    reg [-1:-16] phi_l_s3; // u16f16
    reg [-1:-16] phi_h_s3; // u16f16
    reg setup_normal_azimuth_n15_s3; // u1f0
    reg [1:-18] setup_normal_azimuth_n16_s3; // u20f18
    reg [19:0] recip_row;
    reg [-1:-20] setup_normal_azimuth_n27_s3; // u20f20
    reg setup_normal_azimuth_n36_s3; // u1f0
    reg setup_normal_azimuth_n40_s3; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s3; // u20f18
    reg setup_normal_polar_angle_n68_s3; // u1f0
    reg [9:0] setup_n86_s3; // u10f0
    reg [3:0] light_n100_s3; // u4f0
    reg [3:0] half_n117_s3; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s3 <= phi_l_s2;
            phi_h_s3 <= phi_h_s2;
            setup_normal_azimuth_n15_s3 <= setup_normal_azimuth_n15_s2;
            setup_normal_azimuth_n16_s3 <= setup_normal_azimuth_n16_s2;
            recip_row <= recip_rom[setup_normal_azimuth_recip_n25_s2];
            setup_normal_azimuth_n27_s3 <= setup_normal_azimuth_n27_s2;
            setup_normal_azimuth_n36_s3 <= setup_normal_azimuth_n36_s2;
            setup_normal_azimuth_n40_s3 <= setup_normal_azimuth_n40_s2;
            setup_normal_polar_angle_n47_s3 <= setup_normal_polar_angle_n47_s2;
            setup_normal_polar_angle_n68_s3 <= setup_normal_polar_angle_n68_s2;
            setup_n86_s3 <= setup_n86_s2;
            light_n100_s3 <= light_n100_s2;
            half_n117_s3 <= half_n117_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // setup.normal.azimuth.recip
    wire [1:-18] setup_normal_azimuth_recip_n26 = recip_row; // u20f18

    reg [-1:-16] phi_l_s4; // u16f16
    reg [-1:-16] phi_h_s4; // u16f16
    reg setup_normal_azimuth_n15_s4; // u1f0
    reg [1:-18] setup_normal_azimuth_n16_s4; // u20f18
    reg [1:-18] setup_normal_azimuth_recip_n26_s4; // u20f18
    reg [-1:-20] setup_normal_azimuth_n27_s4; // u20f20
    reg setup_normal_azimuth_n36_s4; // u1f0
    reg setup_normal_azimuth_n40_s4; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s4; // u20f18
    reg setup_normal_polar_angle_n68_s4; // u1f0
    reg [9:0] setup_n86_s4; // u10f0
    reg [3:0] light_n100_s4; // u4f0
    reg [3:0] half_n117_s4; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s4 <= phi_l_s3;
            phi_h_s4 <= phi_h_s3;
            setup_normal_azimuth_n15_s4 <= setup_normal_azimuth_n15_s3;
            setup_normal_azimuth_n16_s4 <= setup_normal_azimuth_n16_s3;
            setup_normal_azimuth_recip_n26_s4 <= setup_normal_azimuth_recip_n26;
            setup_normal_azimuth_n27_s4 <= setup_normal_azimuth_n27_s3;
            setup_normal_azimuth_n36_s4 <= setup_normal_azimuth_n36_s3;
            setup_normal_azimuth_n40_s4 <= setup_normal_azimuth_n40_s3;
            setup_normal_polar_angle_n47_s4 <= setup_normal_polar_angle_n47_s3;
            setup_normal_polar_angle_n68_s4 <= setup_normal_polar_angle_n68_s3;
            setup_n86_s4 <= setup_n86_s3;
            light_n100_s4 <= light_n100_s3;
            half_n117_s4 <= half_n117_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // setup.normal.azimuth
    wire [1:-38] setup_normal_azimuth_n28 = setup_normal_azimuth_n27_s4 * setup_normal_azimuth_recip_n26_s4; // u40f38

    reg [-1:-16] phi_l_s5; // u16f16
    reg [-1:-16] phi_h_s5; // u16f16
    reg setup_normal_azimuth_n15_s5; // u1f0
    reg [1:-18] setup_normal_azimuth_n16_s5; // u20f18
    reg [1:-38] setup_normal_azimuth_n28_s5; // u40f38
    reg setup_normal_azimuth_n36_s5; // u1f0
    reg setup_normal_azimuth_n40_s5; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s5; // u20f18
    reg setup_normal_polar_angle_n68_s5; // u1f0
    reg [9:0] setup_n86_s5; // u10f0
    reg [3:0] light_n100_s5; // u4f0
    reg [3:0] half_n117_s5; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s5 <= phi_l_s4;
            phi_h_s5 <= phi_h_s4;
            setup_normal_azimuth_n15_s5 <= setup_normal_azimuth_n15_s4;
            setup_normal_azimuth_n16_s5 <= setup_normal_azimuth_n16_s4;
            setup_normal_azimuth_n28_s5 <= setup_normal_azimuth_n28;
            setup_normal_azimuth_n36_s5 <= setup_normal_azimuth_n36_s4;
            setup_normal_azimuth_n40_s5 <= setup_normal_azimuth_n40_s4;
            setup_normal_polar_angle_n47_s5 <= setup_normal_polar_angle_n47_s4;
            setup_normal_polar_angle_n68_s5 <= setup_normal_polar_angle_n68_s4;
            setup_n86_s5 <= setup_n86_s4;
            light_n100_s5 <= light_n100_s4;
            half_n117_s5 <= half_n117_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // setup.normal.azimuth
    wire [2:-38] setup_normal_azimuth_ratio_sum = {1'b0, setup_normal_azimuth_n28_s5} + 41'h80000;
    wire [2:-18] setup_normal_azimuth_ratio_cut = setup_normal_azimuth_ratio_sum[2:-18];
    wire setup_normal_azimuth_ratio_over = |setup_normal_azimuth_ratio_cut[2:0];
    wire [-1:-18] setup_normal_azimuth_ratio = setup_normal_azimuth_ratio_over ? 18'h3ffff : setup_normal_azimuth_ratio_cut[-1:-18]; // u18f18
    // setup.normal.azimuth.atan
    wire [9:0] setup_normal_azimuth_atan_n30 = setup_normal_azimuth_ratio[-1:-10]; // u10f0

    reg [-1:-16] phi_l_s6; // u16f16
    reg [-1:-16] phi_h_s6; // u16f16
    reg setup_normal_azimuth_n15_s6; // u1f0
    reg [1:-18] setup_normal_azimuth_n16_s6; // u20f18
    reg [37:0] atan_row;
    reg setup_normal_azimuth_n36_s6; // u1f0
    reg setup_normal_azimuth_n40_s6; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s6; // u20f18
    reg setup_normal_polar_angle_n68_s6; // u1f0
    reg [9:0] setup_n86_s6; // u10f0
    reg [3:0] light_n100_s6; // u4f0
    reg [3:0] half_n117_s6; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s6 <= phi_l_s5;
            phi_h_s6 <= phi_h_s5;
            setup_normal_azimuth_n15_s6 <= setup_normal_azimuth_n15_s5;
            setup_normal_azimuth_n16_s6 <= setup_normal_azimuth_n16_s5;
            atan_row <= atan_rom[setup_normal_azimuth_atan_n30];
            setup_normal_azimuth_n36_s6 <= setup_normal_azimuth_n36_s5;
            setup_normal_azimuth_n40_s6 <= setup_normal_azimuth_n40_s5;
            setup_normal_polar_angle_n47_s6 <= setup_normal_polar_angle_n47_s5;
            setup_normal_polar_angle_n68_s6 <= setup_normal_polar_angle_n68_s5;
            setup_n86_s6 <= setup_n86_s5;
            light_n100_s6 <= light_n100_s5;
            half_n117_s6 <= half_n117_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // setup.normal.azimuth.atan
    wire [0:-18] setup_normal_azimuth_atan_n31 = atan_row[37:19]; // u19f18
    wire [0:-18] setup_normal_azimuth_atan_n32 = atan_row[18:0]; // u19f18
    // setup.normal.azimuth
    wire signed [1:-18] setup_normal_azimuth_n34 = {1'b0, setup_normal_azimuth_n33} - {1'b0, setup_normal_azimuth_atan_n31}; // s20f18
    wire signed [1:-18] setup_normal_azimuth_n35 = setup_normal_azimuth_n15_s6 ? setup_normal_azimuth_n34 : {1'b0, setup_normal_azimuth_atan_n31}; // s20f18

    reg [-1:-16] phi_l_s7; // u16f16
    reg [-1:-16] phi_h_s7; // u16f16
    reg [1:-18] setup_normal_azimuth_n16_s7; // u20f18
    reg [0:-18] setup_normal_azimuth_atan_n32_s7; // u19f18
    reg signed [1:-18] setup_normal_azimuth_n35_s7; // s20f18
    reg setup_normal_azimuth_n36_s7; // u1f0
    reg setup_normal_azimuth_n40_s7; // u1f0
    reg [1:-18] setup_normal_polar_angle_n47_s7; // u20f18
    reg setup_normal_polar_angle_n68_s7; // u1f0
    reg [9:0] setup_n86_s7; // u10f0
    reg [3:0] light_n100_s7; // u4f0
    reg [3:0] half_n117_s7; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s7 <= phi_l_s6;
            phi_h_s7 <= phi_h_s6;
            setup_normal_azimuth_n16_s7 <= setup_normal_azimuth_n16_s6;
            setup_normal_azimuth_atan_n32_s7 <= setup_normal_azimuth_atan_n32;
            setup_normal_azimuth_n35_s7 <= setup_normal_azimuth_n35;
            setup_normal_azimuth_n36_s7 <= setup_normal_azimuth_n36_s6;
            setup_normal_azimuth_n40_s7 <= setup_normal_azimuth_n40_s6;
            setup_normal_polar_angle_n47_s7 <= setup_normal_polar_angle_n47_s6;
            setup_normal_polar_angle_n68_s7 <= setup_normal_polar_angle_n68_s6;
            setup_n86_s7 <= setup_n86_s6;
            light_n100_s7 <= light_n100_s6;
            half_n117_s7 <= half_n117_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // setup.normal.azimuth
    wire signed [2:-18] setup_normal_azimuth_n38 = {2'h0, setup_normal_azimuth_n37} - {setup_normal_azimuth_n35_s7[1], setup_normal_azimuth_n35_s7}; // s21f18
    wire signed [2:-18] setup_normal_azimuth_n39 = setup_normal_azimuth_n36_s7 ? setup_normal_azimuth_n38 : {setup_normal_azimuth_n35_s7[1], setup_normal_azimuth_n35_s7}; // s21f18
    wire signed [3:-18] setup_normal_azimuth_n41 = -{setup_normal_azimuth_n39[2], setup_normal_azimuth_n39}; // s22f18
    wire signed [3:-18] setup_normal_azimuth_n42 = setup_normal_azimuth_n40_s7 ? setup_normal_azimuth_n41 : {setup_normal_azimuth_n39[2], setup_normal_azimuth_n39}; // s22f18
    wire [-1:-18] setup_normal_azimuth_n43 = setup_normal_azimuth_n42[-1:-18]; // u18f18
    wire [2:-36] setup_normal_azimuth_n44 = setup_normal_azimuth_n16_s7 * setup_normal_azimuth_atan_n32_s7; // u39f36
    // setup.normal
    wire [0:-18] setup_normal_n75_sum = {1'b0, setup_normal_azimuth_n43} + 19'h2;
    wire [0:-16] setup_normal_n75_cut = setup_normal_n75_sum[0:-16];
    wire [0:-16] setup_normal_n75 = setup_normal_n75_cut; // u17f16
    wire [-1:-16] setup_normal_phi = setup_normal_n75[-1:-16]; // u16f16

    reg [-1:-16] phi_l_s8; // u16f16
    reg [-1:-16] phi_h_s8; // u16f16
    reg [2:-36] setup_normal_azimuth_n44_s8; // u39f36
    reg [1:-18] setup_normal_polar_angle_n47_s8; // u20f18
    reg setup_normal_polar_angle_n68_s8; // u1f0
    reg [-1:-16] setup_normal_phi_s8; // u16f16
    reg [9:0] setup_n86_s8; // u10f0
    reg [3:0] light_n100_s8; // u4f0
    reg [3:0] half_n117_s8; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s8 <= phi_l_s7;
            phi_h_s8 <= phi_h_s7;
            setup_normal_azimuth_n44_s8 <= setup_normal_azimuth_n44;
            setup_normal_polar_angle_n47_s8 <= setup_normal_polar_angle_n47_s7;
            setup_normal_polar_angle_n68_s8 <= setup_normal_polar_angle_n68_s7;
            setup_normal_phi_s8 <= setup_normal_phi;
            setup_n86_s8 <= setup_n86_s7;
            light_n100_s8 <= light_n100_s7;
            half_n117_s8 <= half_n117_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // setup.normal.azimuth
    wire [3:-36] setup_normal_azimuth_n45_sum = {1'b0, setup_normal_azimuth_n44_s8} + 40'h20000;
    wire [3:-18] setup_normal_azimuth_n45_cut = setup_normal_azimuth_n45_sum[3:-18];
    wire setup_normal_azimuth_n45_over = |setup_normal_azimuth_n45_cut[3:2];
    wire signed [2:-18] setup_normal_azimuth_n45 = setup_normal_azimuth_n45_over ? 21'hfffff : setup_normal_azimuth_n45_cut[2:-18]; // s21f18
    // setup.normal
    wire setup_normal_n46_over = ~setup_normal_azimuth_n45[2] & (|setup_normal_azimuth_n45[1]);
    wire setup_normal_n46_under = setup_normal_azimuth_n45[2] & ~(&setup_normal_azimuth_n45[1]);
    wire signed [1:-18] setup_normal_n46 = setup_normal_n46_over ? 20'h7ffff : setup_normal_n46_under ? 20'h80000 : setup_normal_azimuth_n45[1:-18]; // s20f18
    // setup.normal.polar_angle
    wire [1:-18] setup_normal_polar_angle_n48_neg = -setup_normal_n46;
    wire [1:-18] setup_normal_polar_angle_n48 = setup_normal_n46[1] ? setup_normal_polar_angle_n48_neg : setup_normal_n46; // u20f18
    wire setup_normal_polar_angle_n71 = setup_normal_n46[1]; // u1f0

    reg [-1:-16] phi_l_s9; // u16f16
    reg [-1:-16] phi_h_s9; // u16f16
    reg [1:-18] setup_normal_polar_angle_n47_s9; // u20f18
    reg [1:-18] setup_normal_polar_angle_n48_s9; // u20f18
    reg setup_normal_polar_angle_n68_s9; // u1f0
    reg setup_normal_polar_angle_n71_s9; // u1f0
    reg [-1:-16] setup_normal_phi_s9; // u16f16
    reg [9:0] setup_n86_s9; // u10f0
    reg [3:0] light_n100_s9; // u4f0
    reg [3:0] half_n117_s9; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s9 <= phi_l_s8;
            phi_h_s9 <= phi_h_s8;
            setup_normal_polar_angle_n47_s9 <= setup_normal_polar_angle_n47_s8;
            setup_normal_polar_angle_n48_s9 <= setup_normal_polar_angle_n48;
            setup_normal_polar_angle_n68_s9 <= setup_normal_polar_angle_n68_s8;
            setup_normal_polar_angle_n71_s9 <= setup_normal_polar_angle_n71;
            setup_normal_phi_s9 <= setup_normal_phi_s8;
            setup_n86_s9 <= setup_n86_s8;
            light_n100_s9 <= light_n100_s8;
            half_n117_s9 <= half_n117_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // setup.normal.polar_angle
    wire setup_normal_polar_angle_n49 = setup_normal_polar_angle_n47_s9 < setup_normal_polar_angle_n48_s9; // u1f0
    wire [1:-18] setup_normal_polar_angle_n50 = setup_normal_polar_angle_n49 ? setup_normal_polar_angle_n48_s9 : setup_normal_polar_angle_n47_s9; // u20f18
    wire [1:-18] setup_normal_polar_angle_n51 = setup_normal_polar_angle_n49 ? setup_normal_polar_angle_n47_s9 : setup_normal_polar_angle_n48_s9; // u20f18
    wire [31:0] setup_normal_polar_angle_n52_padded = {setup_normal_polar_angle_n50, 12'hfff};
    wire setup_normal_polar_angle_n52_skip16 = setup_normal_polar_angle_n52_padded[31:16] == 16'h0;
    wire [15:0] setup_normal_polar_angle_n52_part16 = setup_normal_polar_angle_n52_skip16 ? setup_normal_polar_angle_n52_padded[15:0] : setup_normal_polar_angle_n52_padded[31:16];
    wire setup_normal_polar_angle_n52_skip8 = setup_normal_polar_angle_n52_part16[15:8] == 8'h0;
    wire [7:0] setup_normal_polar_angle_n52_part8 = setup_normal_polar_angle_n52_skip8 ? setup_normal_polar_angle_n52_part16[7:0] : setup_normal_polar_angle_n52_part16[15:8];
    wire setup_normal_polar_angle_n52_skip4 = setup_normal_polar_angle_n52_part8[7:4] == 4'h0;
    wire [3:0] setup_normal_polar_angle_n52_part4 = setup_normal_polar_angle_n52_skip4 ? setup_normal_polar_angle_n52_part8[3:0] : setup_normal_polar_angle_n52_part8[7:4];
    wire setup_normal_polar_angle_n52_skip2 = setup_normal_polar_angle_n52_part4[3:2] == 2'h0;
    wire [1:0] setup_normal_polar_angle_n52_part2 = setup_normal_polar_angle_n52_skip2 ? setup_normal_polar_angle_n52_part4[1:0] : setup_normal_polar_angle_n52_part4[3:2];
    wire setup_normal_polar_angle_n52_skip1 = setup_normal_polar_angle_n52_part2[1] == 1'b0;
    wire [4:0] setup_normal_polar_angle_n52 = {setup_normal_polar_angle_n52_skip16, setup_normal_polar_angle_n52_skip8, setup_normal_polar_angle_n52_skip4, setup_normal_polar_angle_n52_skip2, setup_normal_polar_angle_n52_skip1}; // u5f0

    reg [-1:-16] phi_l_s10; // u16f16
    reg [-1:-16] phi_h_s10; // u16f16
    reg setup_normal_polar_angle_n49_s10; // u1f0
    reg [1:-18] setup_normal_polar_angle_n50_s10; // u20f18
    reg [1:-18] setup_normal_polar_angle_n51_s10; // u20f18
    reg [4:0] setup_normal_polar_angle_n52_s10; // u5f0
    reg setup_normal_polar_angle_n68_s10; // u1f0
    reg setup_normal_polar_angle_n71_s10; // u1f0
    reg [-1:-16] setup_normal_phi_s10; // u16f16
    reg [9:0] setup_n86_s10; // u10f0
    reg [3:0] light_n100_s10; // u4f0
    reg [3:0] half_n117_s10; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s10 <= phi_l_s9;
            phi_h_s10 <= phi_h_s9;
            setup_normal_polar_angle_n49_s10 <= setup_normal_polar_angle_n49;
            setup_normal_polar_angle_n50_s10 <= setup_normal_polar_angle_n50;
            setup_normal_polar_angle_n51_s10 <= setup_normal_polar_angle_n51;
            setup_normal_polar_angle_n52_s10 <= setup_normal_polar_angle_n52;
            setup_normal_polar_angle_n68_s10 <= setup_normal_polar_angle_n68_s9;
            setup_normal_polar_angle_n71_s10 <= setup_normal_polar_angle_n71_s9;
            setup_normal_phi_s10 <= setup_normal_phi_s9;
            setup_n86_s10 <= setup_n86_s9;
            light_n100_s10 <= light_n100_s9;
            half_n117_s10 <= half_n117_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // setup.normal.polar_angle
    wire setup_normal_polar_angle_n53_past = 5'h14 < setup_normal_polar_angle_n52_s10;
    wire [4:0] setup_normal_polar_angle_n53_count = setup_normal_polar_angle_n53_past ? 5'h14 : setup_normal_polar_angle_n52_s10;
    wire [21:-18] setup_normal_polar_angle_n53 = {20'h0, setup_normal_polar_angle_n50_s10} << setup_normal_polar_angle_n53_count; // u40f18
    wire [19:0] setup_normal_polar_angle_n54 = setup_normal_polar_angle_n53[1:-18]; // u20f0
    wire setup_normal_polar_angle_n55_past = 5'h14 < setup_normal_polar_angle_n52_s10;
    wire [4:0] setup_normal_polar_angle_n55_count = setup_normal_polar_angle_n55_past ? 5'h14 : setup_normal_polar_angle_n52_s10;
    wire [21:-18] setup_normal_polar_angle_n55 = {20'h0, setup_normal_polar_angle_n51_s10} << setup_normal_polar_angle_n55_count; // u40f18
    wire [19:0] setup_normal_polar_angle_n56 = setup_normal_polar_angle_n55[1:-18]; // u20f0
    wire [18:0] setup_normal_polar_angle_n57 = setup_normal_polar_angle_n54[18:0]; // u19f0
    wire [-2:-20] setup_normal_polar_angle_n58 = setup_normal_polar_angle_n57; // u19f20
    // setup.normal.polar_angle.recip
    wire [9:0] setup_normal_polar_angle_recip_n59 = setup_normal_polar_angle_n58[-2:-11]; // u10f0
    // setup.normal.polar_angle
    wire [-1:-20] setup_normal_polar_angle_n61 = setup_normal_polar_angle_n56; // u20f20

    reg [-1:-16] phi_l_s11; // u16f16
    reg [-1:-16] phi_h_s11; // u16f16
    reg setup_normal_polar_angle_n49_s11; // u1f0
    reg [19:0] recip_row_2;
    reg [-1:-20] setup_normal_polar_angle_n61_s11; // u20f20
    reg setup_normal_polar_angle_n68_s11; // u1f0
    reg setup_normal_polar_angle_n71_s11; // u1f0
    reg [-1:-16] setup_normal_phi_s11; // u16f16
    reg [9:0] setup_n86_s11; // u10f0
    reg [3:0] light_n100_s11; // u4f0
    reg [3:0] half_n117_s11; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s11 <= phi_l_s10;
            phi_h_s11 <= phi_h_s10;
            setup_normal_polar_angle_n49_s11 <= setup_normal_polar_angle_n49_s10;
            recip_row_2 <= recip_rom[setup_normal_polar_angle_recip_n59];
            setup_normal_polar_angle_n61_s11 <= setup_normal_polar_angle_n61;
            setup_normal_polar_angle_n68_s11 <= setup_normal_polar_angle_n68_s10;
            setup_normal_polar_angle_n71_s11 <= setup_normal_polar_angle_n71_s10;
            setup_normal_phi_s11 <= setup_normal_phi_s10;
            setup_n86_s11 <= setup_n86_s10;
            light_n100_s11 <= light_n100_s10;
            half_n117_s11 <= half_n117_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // setup.normal.polar_angle.recip
    wire [1:-18] setup_normal_polar_angle_recip_n60 = recip_row_2; // u20f18

    reg [-1:-16] phi_l_s12; // u16f16
    reg [-1:-16] phi_h_s12; // u16f16
    reg setup_normal_polar_angle_n49_s12; // u1f0
    reg [1:-18] setup_normal_polar_angle_recip_n60_s12; // u20f18
    reg [-1:-20] setup_normal_polar_angle_n61_s12; // u20f20
    reg setup_normal_polar_angle_n68_s12; // u1f0
    reg setup_normal_polar_angle_n71_s12; // u1f0
    reg [-1:-16] setup_normal_phi_s12; // u16f16
    reg [9:0] setup_n86_s12; // u10f0
    reg [3:0] light_n100_s12; // u4f0
    reg [3:0] half_n117_s12; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s12 <= phi_l_s11;
            phi_h_s12 <= phi_h_s11;
            setup_normal_polar_angle_n49_s12 <= setup_normal_polar_angle_n49_s11;
            setup_normal_polar_angle_recip_n60_s12 <= setup_normal_polar_angle_recip_n60;
            setup_normal_polar_angle_n61_s12 <= setup_normal_polar_angle_n61_s11;
            setup_normal_polar_angle_n68_s12 <= setup_normal_polar_angle_n68_s11;
            setup_normal_polar_angle_n71_s12 <= setup_normal_polar_angle_n71_s11;
            setup_normal_phi_s12 <= setup_normal_phi_s11;
            setup_n86_s12 <= setup_n86_s11;
            light_n100_s12 <= light_n100_s11;
            half_n117_s12 <= half_n117_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // setup.normal.polar_angle
    wire [1:-38] setup_normal_polar_angle_n62 = setup_normal_polar_angle_n61_s12 * setup_normal_polar_angle_recip_n60_s12; // u40f38

    reg [-1:-16] phi_l_s13; // u16f16
    reg [-1:-16] phi_h_s13; // u16f16
    reg setup_normal_polar_angle_n49_s13; // u1f0
    reg [1:-38] setup_normal_polar_angle_n62_s13; // u40f38
    reg setup_normal_polar_angle_n68_s13; // u1f0
    reg setup_normal_polar_angle_n71_s13; // u1f0
    reg [-1:-16] setup_normal_phi_s13; // u16f16
    reg [9:0] setup_n86_s13; // u10f0
    reg [3:0] light_n100_s13; // u4f0
    reg [3:0] half_n117_s13; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s13 <= phi_l_s12;
            phi_h_s13 <= phi_h_s12;
            setup_normal_polar_angle_n49_s13 <= setup_normal_polar_angle_n49_s12;
            setup_normal_polar_angle_n62_s13 <= setup_normal_polar_angle_n62;
            setup_normal_polar_angle_n68_s13 <= setup_normal_polar_angle_n68_s12;
            setup_normal_polar_angle_n71_s13 <= setup_normal_polar_angle_n71_s12;
            setup_normal_phi_s13 <= setup_normal_phi_s12;
            setup_n86_s13 <= setup_n86_s12;
            light_n100_s13 <= light_n100_s12;
            half_n117_s13 <= half_n117_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // setup.normal.polar_angle
    wire [2:-38] setup_normal_polar_angle_ratio_sum = {1'b0, setup_normal_polar_angle_n62_s13} + 41'h80000;
    wire [2:-18] setup_normal_polar_angle_ratio_cut = setup_normal_polar_angle_ratio_sum[2:-18];
    wire setup_normal_polar_angle_ratio_over = |setup_normal_polar_angle_ratio_cut[2:0];
    wire [-1:-18] setup_normal_polar_angle_ratio = setup_normal_polar_angle_ratio_over ? 18'h3ffff : setup_normal_polar_angle_ratio_cut[-1:-18]; // u18f18
    // setup.normal.polar_angle.atan
    wire [9:0] setup_normal_polar_angle_atan_n64 = setup_normal_polar_angle_ratio[-1:-10]; // u10f0

    reg [-1:-16] phi_l_s14; // u16f16
    reg [-1:-16] phi_h_s14; // u16f16
    reg setup_normal_polar_angle_n49_s14; // u1f0
    reg [37:0] atan_row_2;
    reg setup_normal_polar_angle_n68_s14; // u1f0
    reg setup_normal_polar_angle_n71_s14; // u1f0
    reg [-1:-16] setup_normal_phi_s14; // u16f16
    reg [9:0] setup_n86_s14; // u10f0
    reg [3:0] light_n100_s14; // u4f0
    reg [3:0] half_n117_s14; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s14 <= phi_l_s13;
            phi_h_s14 <= phi_h_s13;
            setup_normal_polar_angle_n49_s14 <= setup_normal_polar_angle_n49_s13;
            atan_row_2 <= atan_rom[setup_normal_polar_angle_atan_n64];
            setup_normal_polar_angle_n68_s14 <= setup_normal_polar_angle_n68_s13;
            setup_normal_polar_angle_n71_s14 <= setup_normal_polar_angle_n71_s13;
            setup_normal_phi_s14 <= setup_normal_phi_s13;
            setup_n86_s14 <= setup_n86_s13;
            light_n100_s14 <= light_n100_s13;
            half_n117_s14 <= half_n117_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // setup.normal.polar_angle.atan
    wire [0:-18] setup_normal_polar_angle_atan_n65 = atan_row_2[37:19]; // u19f18
    // setup.normal.polar_angle
    wire signed [1:-18] setup_normal_polar_angle_n66 = {1'b0, setup_normal_azimuth_n33} - {1'b0, setup_normal_polar_angle_atan_n65}; // s20f18
    wire signed [1:-18] setup_normal_polar_angle_n67 = setup_normal_polar_angle_n49_s14 ? setup_normal_polar_angle_n66 : {1'b0, setup_normal_polar_angle_atan_n65}; // s20f18

    reg [-1:-16] phi_l_s15; // u16f16
    reg [-1:-16] phi_h_s15; // u16f16
    reg signed [1:-18] setup_normal_polar_angle_n67_s15; // s20f18
    reg setup_normal_polar_angle_n68_s15; // u1f0
    reg setup_normal_polar_angle_n71_s15; // u1f0
    reg [-1:-16] setup_normal_phi_s15; // u16f16
    reg [9:0] setup_n86_s15; // u10f0
    reg [3:0] light_n100_s15; // u4f0
    reg [3:0] half_n117_s15; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s15 <= phi_l_s14;
            phi_h_s15 <= phi_h_s14;
            setup_normal_polar_angle_n67_s15 <= setup_normal_polar_angle_n67;
            setup_normal_polar_angle_n68_s15 <= setup_normal_polar_angle_n68_s14;
            setup_normal_polar_angle_n71_s15 <= setup_normal_polar_angle_n71_s14;
            setup_normal_phi_s15 <= setup_normal_phi_s14;
            setup_n86_s15 <= setup_n86_s14;
            light_n100_s15 <= light_n100_s14;
            half_n117_s15 <= half_n117_s14;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // setup.normal.polar_angle
    wire signed [2:-18] setup_normal_polar_angle_n69 = {2'h0, setup_normal_azimuth_n37} - {setup_normal_polar_angle_n67_s15[1], setup_normal_polar_angle_n67_s15}; // s21f18
    wire signed [2:-18] setup_normal_polar_angle_n70 = setup_normal_polar_angle_n68_s15 ? setup_normal_polar_angle_n69 : {setup_normal_polar_angle_n67_s15[1], setup_normal_polar_angle_n67_s15}; // s21f18
    wire signed [3:-18] setup_normal_polar_angle_n72 = -{setup_normal_polar_angle_n70[2], setup_normal_polar_angle_n70}; // s22f18
    wire signed [3:-18] setup_normal_polar_angle_n73 = setup_normal_polar_angle_n71_s15 ? setup_normal_polar_angle_n72 : {setup_normal_polar_angle_n70[2], setup_normal_polar_angle_n70}; // s22f18
    wire [-1:-18] setup_normal_polar_angle_n74 = setup_normal_polar_angle_n73[-1:-18]; // u18f18
    // setup.normal
    wire [0:-18] setup_normal_n77_sum = {1'b0, setup_normal_polar_angle_n74} + 19'h2;
    wire [0:-16] setup_normal_n77_cut = setup_normal_n77_sum[0:-16];
    wire [0:-16] setup_normal_n77 = setup_normal_n77_cut; // u17f16
    wire [-1:-16] setup_normal_theta = setup_normal_n77[-1:-16]; // u16f16

    reg [-1:-16] phi_l_s16; // u16f16
    reg [-1:-16] phi_h_s16; // u16f16
    reg [-1:-16] setup_normal_phi_s16; // u16f16
    reg [-1:-16] setup_normal_theta_s16; // u16f16
    reg [9:0] setup_n86_s16; // u10f0
    reg [3:0] light_n100_s16; // u4f0
    reg [3:0] half_n117_s16; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s16 <= phi_l_s15;
            phi_h_s16 <= phi_h_s15;
            setup_normal_phi_s16 <= setup_normal_phi_s15;
            setup_normal_theta_s16 <= setup_normal_theta;
            setup_n86_s16 <= setup_n86_s15;
            light_n100_s16 <= light_n100_s15;
            half_n117_s16 <= half_n117_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // setup
    wire [-1:-5] setup_n84_cut = setup_normal_theta_s16[-1:-5];
    wire setup_n84_over = |setup_n84_cut[-1];
    wire [-2:-5] setup_n84 = setup_n84_over ? 4'hf : setup_n84_cut[-2:-5]; // u4f5
    wire [3:0] setup_n85 = setup_n84; // u4f0
    wire [13:0] setup_n87 = {setup_n86_s16, setup_n85}; // u14f0

    reg [-1:-16] phi_l_s17; // u16f16
    reg [-1:-16] phi_h_s17; // u16f16
    reg [-1:-16] setup_normal_phi_s17; // u16f16
    reg [15:0] tilt_map_row;
    reg [3:0] light_n100_s17; // u4f0
    reg [3:0] half_n117_s17; // u4f0
    always @(posedge clk)
        if (ce) begin
            phi_l_s17 <= phi_l_s16;
            phi_h_s17 <= phi_h_s16;
            setup_normal_phi_s17 <= setup_normal_phi_s16;
            tilt_map_row <= tilt_map_rom[setup_n87];
            light_n100_s17 <= light_n100_s16;
            half_n117_s17 <= half_n117_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // setup
    wire [-1:-8] setup_n88 = tilt_map_row[15:8]; // u8f8
    wire [-2:-9] setup_theta = tilt_map_row[7:0]; // u8f9
    wire [0:-16] setup_n90 = {1'b0, setup_n88, 8'h0} + {1'b0, setup_normal_phi_s17}; // u17f16
    wire [-1:-16] setup_phi = setup_n90[-1:-16]; // u16f16
    // light
    wire signed [0:-16] light_n92 = {1'b0, setup_phi} - {1'b0, phi_l_s17}; // s17f16
    wire [-1:-16] light_delta = light_n92[-1:-16]; // u16f16
    wire [-1:-16] light_n95 = light_delta ^ light_n94; // u16f16
    wire [4:0] light_n96 = light_n95[-1:-5]; // u5f0
    wire [-2:-6] light_n97_cut = setup_theta[-2:-6];
    wire [-2:-6] light_n97 = light_n97_cut; // u5f6
    wire [4:0] light_n98 = light_n97; // u5f0
    wire [9:0] light_n101 = {light_n96, light_n98}; // u10f0
    wire [13:0] light_n102 = {light_n101, light_n100_s17}; // u14f0
    // half
    wire signed [0:-16] half_n112 = {1'b0, setup_phi} - {1'b0, phi_h_s17}; // s17f16
    wire [-1:-16] half_delta = half_n112[-1:-16]; // u16f16
    wire [-1:-16] half_n114 = half_delta ^ light_n94; // u16f16
    wire [4:0] half_n115 = half_n114[-1:-5]; // u5f0
    wire [9:0] half_n118 = {half_n115, light_n98}; // u10f0
    wire [13:0] half_n119 = {half_n118, half_n117_s17}; // u14f0

    reg [13:0] light_n102_s18; // u14f0
    reg [13:0] half_n119_s18; // u14f0
    always @(posedge clk)
        if (ce) begin
            light_n102_s18 <= light_n102;
            half_n119_s18 <= half_n119;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----

    reg [15:0] tilt_map_row_2;
    reg [15:0] tilt_map_row_3;
    always @(posedge clk)
        if (ce) begin
            tilt_map_row_2 <= tilt_map_rom[light_n102_s18];
            tilt_map_row_3 <= tilt_map_rom_2[half_n119_s18];
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // light
    wire [-1:-8] light_n103 = tilt_map_row_2[15:8]; // u8f8
    wire [-2:-9] light_theta = tilt_map_row_2[7:0]; // u8f9
    wire [-1:-8] light_phi = light_n103 ^ light_n105; // u8f8
    wire [5:0] light_n107 = light_phi[-1:-6]; // u6f0
    wire [-2:-7] light_n108_cut = light_theta[-2:-7];
    wire [-2:-7] light_n108 = light_n108_cut; // u6f7
    wire [5:0] light_n109 = light_n108; // u6f0
    wire [11:0] light_n110 = {light_n107, light_n109}; // u12f0
    // half
    wire [-1:-8] half_n120 = tilt_map_row_3[15:8]; // u8f8
    wire [-2:-9] half_theta = tilt_map_row_3[7:0]; // u8f9
    wire [-1:-8] half_phi = half_n120 ^ light_n105; // u8f8
    wire [5:0] half_n123 = half_phi[-1:-6]; // u6f0
    wire [-2:-7] half_n124_cut = half_theta[-2:-7];
    wire [-2:-7] half_n124 = half_n124_cut; // u6f7
    wire [5:0] half_n125 = half_n124; // u6f0
    wire [11:0] half_n126 = {half_n123, half_n125}; // u12f0

    reg [15:0] diffuse_map_row;
    reg [15:0] specular_map_row;
    always @(posedge clk)
        if (ce) begin
            diffuse_map_row <= diffuse_map_rom[light_n110];
            specular_map_row <= specular_map_rom[half_n126];
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // light
    wire [-1:-16] light_diffuse = diffuse_map_row; // u16f16
    // half
    wire [-1:-16] half_specular = specular_map_row; // u16f16
    // (unit)
    wire [0:-16] n128 = {1'b0, light_diffuse} + {1'b0, half_specular}; // u17f16
    wire intensity_next_over = |n128[0];
    wire [-1:-16] intensity_next = intensity_next_over ? 16'hffff : n128[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            diffuse <= light_diffuse;
            specular <= half_specular;
            intensity <= intensity_next;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;
    assign valid_out = valid_s21;

    // ---- stage 21 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        theta_p[-7:-16],
        theta_l[-6:-16],
        theta_h[-6:-16],
        setup_n79[0],
        setup_phi_texture[-6:-16],
        setup_normal_azimuth_n18_part2[0],
        setup_normal_azimuth_n19[21:2],
        setup_normal_azimuth_n20[19],
        setup_normal_azimuth_n21[21:2],
        setup_normal_azimuth_n24[-12:-20],
        setup_normal_azimuth_ratio[-11:-18],
        setup_normal_azimuth_ratio_sum[-19:-38],
        setup_normal_azimuth_n42[3:0],
        setup_normal_n75[0],
        setup_normal_n75_sum[-17:-18],
        setup_normal_azimuth_n45_sum[-19:-36],
        setup_normal_polar_angle_n52_part2[0],
        setup_normal_polar_angle_n53[21:2],
        setup_normal_polar_angle_n54[19],
        setup_normal_polar_angle_n55[21:2],
        setup_normal_polar_angle_n58[-12:-20],
        setup_normal_polar_angle_ratio[-11:-18],
        setup_normal_polar_angle_ratio_sum[-19:-38],
        atan_row_2[18:0],
        setup_normal_polar_angle_n73[3:0],
        setup_normal_n77[0],
        setup_normal_n77_sum[-17:-18],
        setup_normal_theta_s16[-6:-16],
        setup_theta[-7:-9],
        setup_n90[0],
        light_n92[0],
        light_n95[-6:-16],
        half_n112[0],
        half_n114[-6:-16],
        light_theta[-8:-9],
        light_phi[-7:-8],
        half_theta[-8:-9],
        half_phi[-7:-8]};
endmodule
