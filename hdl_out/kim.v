// kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
// made by fixpath 0.1.0; Kim et al. 2001: eqs (3), (4) of seed 001 (Lee et al.); the set-up is a reconstruction
//   conversion=table angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
//   guard_bits=2 rounding=half-up sincos_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
//   cordic_iterations=auto highlight=on diffuse_addr_bits=10 specular_addr_bits=10
//   light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3 exponent=32
//   period_ps=5000 stages=auto rom=block
// latency 30 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 6.91e-4, largest seen 1.28e-2 (836.5 ulp) at phi_l=12249 theta_l=10042 phi_h=25129 theta_h=12990 phi_n=27856 theta_n=18250 psi=18706 phi_p=19124 theta_p=3769
//   diffuse: mean 5.92e-4, largest seen 7.09e-3 (464.8 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
//   specular: mean 1.54e-4, largest seen 1.15e-2 (756.4 ulp) at phi_l=46792 theta_l=23943 phi_h=48621 theta_h=15295 phi_n=56540 theta_n=7516 psi=771 phi_p=53306 theta_p=8323
//   dot_l: mean 1.94e-3, largest seen 1.17e-2 (766.0 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
//   dot_h: mean 1.93e-3, largest seen 1.09e-2 (713.0 ulp) at phi_l=60553 theta_l=18372 phi_h=64636 theta_h=22235 phi_n=8005 theta_n=19253 psi=1559 phi_p=20130 theta_p=8069
//   lt_angle: mean 2.77e-3 rad, largest seen 7.77e-3 rad at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
//   lt_dot: mean 2.77e-3, largest seen 7.77e-3 at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
//   lt_x: mean 1.43e-3, largest seen 7.31e-3 at phi_l=3004 theta_l=11455 phi_h=6745 theta_h=15411 phi_n=16385 theta_n=5769 psi=61008 phi_p=44796 theta_p=5705
//   lt_y: mean 1.26e-3, largest seen 6.21e-3 at phi_l=58622 theta_l=14345 phi_h=63015 theta_h=26871 phi_n=27904 theta_n=24597 psi=39862 phi_p=34182 theta_p=8142
//   lt_z: mean 1.47e-3, largest seen 6.89e-3 at phi_l=46077 theta_l=10290 phi_h=47299 theta_h=13859 phi_n=55937 theta_n=20227 psi=54458 phi_p=65410 theta_p=4451
//   ht_angle: mean 2.77e-3 rad, largest seen 7.83e-3 rad at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
//   ht_dot: mean 2.77e-3, largest seen 7.83e-3 at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
//   ht_x: mean 1.43e-3, largest seen 6.94e-3 at phi_l=60765 theta_l=22077 phi_h=12545 theta_h=23229 phi_n=26302 theta_n=28297 psi=58283 phi_p=51185 theta_p=7747
//   ht_y: mean 1.26e-3, largest seen 5.92e-3 at phi_l=17506 theta_l=13432 phi_h=12930 theta_h=16780 phi_n=13695 theta_n=13345 psi=2824 phi_p=40130 theta_p=3617
//   ht_z: mean 1.46e-3, largest seen 6.74e-3 at phi_l=15954 theta_l=3967 phi_h=34558 theta_h=10628 phi_n=23439 theta_n=21371 psi=29040 phi_p=61493 theta_p=6921
// stated bound on each dot: 8.61e-2
// stated bound on each diffuse: 5.20e-2
// stated bound on each specular: 2.88e-1
// stated bound on each intensity: 3.40e-1
// stated bound on the angle: 7.10e-2 rad
module kim (
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
    initial $readmemh("kim_sincos.hex", sincos_rom);

    // table recip: recip u20f18
    (* rom_style = "block" *)
    reg [19:0] recip_rom [0:1023];
    initial $readmemh("kim_recip.hex", recip_rom);

    // table atan: atan u19f18, secant u19f18
    (* rom_style = "block" *)
    reg [37:0] atan_rom [0:1023];
    initial $readmemh("kim_atan.hex", atan_rom);

    // table diffuse: light u16f16
    (* rom_style = "block" *)
    reg [15:0] diffuse_rom [0:1023];
    initial $readmemh("kim_diffuse.hex", diffuse_rom);

    // table specular: light u16f16
    (* rom_style = "block" *)
    reg [15:0] specular_rom [0:1023];
    initial $readmemh("kim_specular.hex", specular_rom);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_2 [0:1023];
    initial $readmemh("kim_sincos.hex", sincos_rom_2);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_3 [0:1023];
    initial $readmemh("kim_sincos.hex", sincos_rom_3);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_4 [0:1023];
    initial $readmemh("kim_sincos.hex", sincos_rom_4);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_5 [0:1023];
    initial $readmemh("kim_sincos.hex", sincos_rom_5);

    // a copy of table recip: recip u20f18
    (* rom_style = "block" *)
    reg [19:0] recip_rom_2 [0:1023];
    initial $readmemh("kim_recip.hex", recip_rom_2);

    // a copy of table atan: atan u19f18, secant u19f18
    (* rom_style = "block" *)
    reg [37:0] atan_rom_2 [0:1023];
    initial $readmemh("kim_atan.hex", atan_rom_2);

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_6 [0:1023];
    initial $readmemh("kim_sincos.hex", sincos_rom_6);

    // ---- stage 0 ----
    // setup.frame.sincos
    wire [9:0] setup_frame_sincos_n9 = phi_n[-1:-10]; // u10f0
    wire [9:0] setup_frame_sincos_n12 = theta_n[-1:-10]; // u10f0
    // setup.light.sincos
    wire [9:0] setup_light_sincos_n23 = phi_l[-1:-10]; // u10f0
    wire [9:0] setup_light_sincos_n26 = theta_l[-1:-10]; // u10f0
    // setup.light.azimuth
    wire [0:-18] setup_light_azimuth_n69 = 19'h10000; // u19f18
    wire [0:-18] setup_light_azimuth_n73 = 19'h20000; // u19f18
    // setup.half.sincos
    wire [9:0] setup_half_sincos_n115 = phi_h[-1:-10]; // u10f0
    wire [9:0] setup_half_sincos_n118 = theta_h[-1:-10]; // u10f0
    // setup
    wire [0:-16] setup_n205 = {1'b0, phi_p} + {1'b0, psi}; // u17f16
    wire [-1:-16] setup_phi_p = setup_n205[-1:-16]; // u16f16
    // dot_l.sincos
    wire [9:0] dot_l_sincos_n214 = theta_p[-1:-10]; // u10f0
    // (unit)
    wire n236 = 1'b0; // u1f0
    wire [-1:-16] n245 = 16'hb333; // u16f16
    wire [-1:-16] n246 = 16'h199a; // u16f16
    wire [-1:-16] n257 = 16'h4ccd; // u16f16
    wire [-1:-16] n258 = 16'h0; // u16f16

    reg [39:0] sincos_row;
    reg [39:0] sincos_row_2;
    reg [39:0] sincos_row_3;
    reg [39:0] sincos_row_4;
    reg [39:0] sincos_row_5;
    reg [39:0] sincos_row_6;
    reg [-1:-16] setup_phi_p_s1; // u16f16
    reg [39:0] sincos_row_7;
    always @(posedge clk)
        if (ce) begin
            sincos_row <= sincos_rom[setup_frame_sincos_n9];
            sincos_row_2 <= sincos_rom[setup_frame_sincos_n12];
            sincos_row_3 <= sincos_rom_2[setup_light_sincos_n23];
            sincos_row_4 <= sincos_rom_2[setup_light_sincos_n26];
            sincos_row_5 <= sincos_rom_3[setup_half_sincos_n115];
            sincos_row_6 <= sincos_rom_3[setup_half_sincos_n118];
            setup_phi_p_s1 <= setup_phi_p;
            sincos_row_7 <= sincos_rom_4[dot_l_sincos_n214];
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // setup.frame.sincos
    wire signed [1:-18] setup_frame_sincos_n10 = sincos_row[39:20]; // s20f18
    wire signed [1:-18] setup_frame_sincos_n11 = sincos_row[19:0]; // s20f18
    wire signed [1:-18] setup_frame_sincos_n13 = sincos_row_2[39:20]; // s20f18
    wire signed [1:-18] setup_frame_sincos_n14 = sincos_row_2[19:0]; // s20f18
    // setup.light.sincos
    wire signed [1:-18] setup_light_sincos_n24 = sincos_row_3[39:20]; // s20f18
    wire signed [1:-18] setup_light_sincos_n25 = sincos_row_3[19:0]; // s20f18
    wire signed [1:-18] setup_light_sincos_n27 = sincos_row_4[39:20]; // s20f18
    wire signed [1:-18] setup_light_sincos_n28 = sincos_row_4[19:0]; // s20f18
    // setup.half.sincos
    wire signed [1:-18] setup_half_sincos_n116 = sincos_row_5[39:20]; // s20f18
    wire signed [1:-18] setup_half_sincos_n117 = sincos_row_5[19:0]; // s20f18
    wire signed [1:-18] setup_half_sincos_n119 = sincos_row_6[39:20]; // s20f18
    wire signed [1:-18] setup_half_sincos_n120 = sincos_row_6[19:0]; // s20f18
    // dot_l.sincos
    wire signed [1:-18] dot_l_sincos_n215 = sincos_row_7[39:20]; // s20f18
    wire signed [1:-18] dot_l_sincos_n216 = sincos_row_7[19:0]; // s20f18

    reg signed [1:-18] setup_frame_sincos_n10_s2; // s20f18
    reg signed [1:-18] setup_frame_sincos_n11_s2; // s20f18
    reg signed [1:-18] setup_frame_sincos_n13_s2; // s20f18
    reg signed [1:-18] setup_frame_sincos_n14_s2; // s20f18
    reg signed [1:-18] setup_light_sincos_n24_s2; // s20f18
    reg signed [1:-18] setup_light_sincos_n25_s2; // s20f18
    reg signed [1:-18] setup_light_sincos_n27_s2; // s20f18
    reg signed [1:-18] setup_light_sincos_n28_s2; // s20f18
    reg signed [1:-18] setup_half_sincos_n116_s2; // s20f18
    reg signed [1:-18] setup_half_sincos_n117_s2; // s20f18
    reg signed [1:-18] setup_half_sincos_n119_s2; // s20f18
    reg signed [1:-18] setup_half_sincos_n120_s2; // s20f18
    reg [-1:-16] setup_phi_p_s2; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s2; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s2; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_frame_sincos_n10_s2 <= setup_frame_sincos_n10;
            setup_frame_sincos_n11_s2 <= setup_frame_sincos_n11;
            setup_frame_sincos_n13_s2 <= setup_frame_sincos_n13;
            setup_frame_sincos_n14_s2 <= setup_frame_sincos_n14;
            setup_light_sincos_n24_s2 <= setup_light_sincos_n24;
            setup_light_sincos_n25_s2 <= setup_light_sincos_n25;
            setup_light_sincos_n27_s2 <= setup_light_sincos_n27;
            setup_light_sincos_n28_s2 <= setup_light_sincos_n28;
            setup_half_sincos_n116_s2 <= setup_half_sincos_n116;
            setup_half_sincos_n117_s2 <= setup_half_sincos_n117;
            setup_half_sincos_n119_s2 <= setup_half_sincos_n119;
            setup_half_sincos_n120_s2 <= setup_half_sincos_n120;
            setup_phi_p_s2 <= setup_phi_p_s1;
            dot_l_sincos_n215_s2 <= dot_l_sincos_n215;
            dot_l_sincos_n216_s2 <= dot_l_sincos_n216;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // setup.frame
    wire signed [3:-36] setup_frame_n15 = setup_frame_sincos_n14_s2 * setup_frame_sincos_n11_s2; // s40f36
    wire signed [3:-36] setup_frame_n17 = setup_frame_sincos_n14_s2 * setup_frame_sincos_n10_s2; // s40f36
    wire signed [3:-36] setup_frame_n19 = setup_frame_sincos_n13_s2 * setup_frame_sincos_n11_s2; // s40f36
    wire signed [3:-36] setup_frame_n21 = setup_frame_sincos_n13_s2 * setup_frame_sincos_n10_s2; // s40f36
    // setup.light
    wire signed [3:-36] setup_light_n29 = setup_light_sincos_n27_s2 * setup_light_sincos_n25_s2; // s40f36
    wire signed [3:-36] setup_light_n31 = setup_light_sincos_n27_s2 * setup_light_sincos_n24_s2; // s40f36
    wire signed [3:-36] setup_light_n35 = setup_frame_sincos_n13_s2 * setup_light_sincos_n28_s2; // s40f36
    wire signed [3:-36] setup_light_n40 = setup_frame_sincos_n14_s2 * setup_light_sincos_n28_s2; // s40f36
    // setup.half
    wire signed [3:-36] setup_half_n121 = setup_half_sincos_n119_s2 * setup_half_sincos_n117_s2; // s40f36
    wire signed [3:-36] setup_half_n123 = setup_half_sincos_n119_s2 * setup_half_sincos_n116_s2; // s40f36
    wire signed [3:-36] setup_half_n127 = setup_frame_sincos_n13_s2 * setup_half_sincos_n120_s2; // s40f36
    wire signed [3:-36] setup_half_n132 = setup_frame_sincos_n14_s2 * setup_half_sincos_n120_s2; // s40f36

    reg signed [1:-18] setup_frame_sincos_n10_s3; // s20f18
    reg signed [1:-18] setup_frame_sincos_n11_s3; // s20f18
    reg signed [3:-36] setup_frame_n15_s3; // s40f36
    reg signed [3:-36] setup_frame_n17_s3; // s40f36
    reg signed [3:-36] setup_frame_n19_s3; // s40f36
    reg signed [3:-36] setup_frame_n21_s3; // s40f36
    reg signed [3:-36] setup_light_n29_s3; // s40f36
    reg signed [3:-36] setup_light_n31_s3; // s40f36
    reg signed [3:-36] setup_light_n35_s3; // s40f36
    reg signed [3:-36] setup_light_n40_s3; // s40f36
    reg signed [3:-36] setup_half_n121_s3; // s40f36
    reg signed [3:-36] setup_half_n123_s3; // s40f36
    reg signed [3:-36] setup_half_n127_s3; // s40f36
    reg signed [3:-36] setup_half_n132_s3; // s40f36
    reg [-1:-16] setup_phi_p_s3; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s3; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s3; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_frame_sincos_n10_s3 <= setup_frame_sincos_n10_s2;
            setup_frame_sincos_n11_s3 <= setup_frame_sincos_n11_s2;
            setup_frame_n15_s3 <= setup_frame_n15;
            setup_frame_n17_s3 <= setup_frame_n17;
            setup_frame_n19_s3 <= setup_frame_n19;
            setup_frame_n21_s3 <= setup_frame_n21;
            setup_light_n29_s3 <= setup_light_n29;
            setup_light_n31_s3 <= setup_light_n31;
            setup_light_n35_s3 <= setup_light_n35;
            setup_light_n40_s3 <= setup_light_n40;
            setup_half_n121_s3 <= setup_half_n121;
            setup_half_n123_s3 <= setup_half_n123;
            setup_half_n127_s3 <= setup_half_n127;
            setup_half_n132_s3 <= setup_half_n132;
            setup_phi_p_s3 <= setup_phi_p_s2;
            dot_l_sincos_n215_s3 <= dot_l_sincos_n215_s2;
            dot_l_sincos_n216_s3 <= dot_l_sincos_n216_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // setup.frame
    wire signed [4:-36] setup_frame_t_x_sum = {setup_frame_n15_s3[3], setup_frame_n15_s3} + 41'h20000;
    wire signed [4:-18] setup_frame_t_x_cut = setup_frame_t_x_sum[4:-18];
    wire setup_frame_t_x_over = ~setup_frame_t_x_cut[4] & (|setup_frame_t_x_cut[3:1]);
    wire setup_frame_t_x_under = setup_frame_t_x_cut[4] & ~(&setup_frame_t_x_cut[3:1]);
    wire signed [1:-18] setup_frame_t_x = setup_frame_t_x_over ? 20'h7ffff : setup_frame_t_x_under ? 20'h80000 : setup_frame_t_x_cut[1:-18]; // s20f18
    wire signed [4:-36] setup_frame_t_y_sum = {setup_frame_n17_s3[3], setup_frame_n17_s3} + 41'h20000;
    wire signed [4:-18] setup_frame_t_y_cut = setup_frame_t_y_sum[4:-18];
    wire setup_frame_t_y_over = ~setup_frame_t_y_cut[4] & (|setup_frame_t_y_cut[3:1]);
    wire setup_frame_t_y_under = setup_frame_t_y_cut[4] & ~(&setup_frame_t_y_cut[3:1]);
    wire signed [1:-18] setup_frame_t_y = setup_frame_t_y_over ? 20'h7ffff : setup_frame_t_y_under ? 20'h80000 : setup_frame_t_y_cut[1:-18]; // s20f18
    wire signed [4:-36] setup_frame_n_x_sum = {setup_frame_n19_s3[3], setup_frame_n19_s3} + 41'h20000;
    wire signed [4:-18] setup_frame_n_x_cut = setup_frame_n_x_sum[4:-18];
    wire setup_frame_n_x_over = ~setup_frame_n_x_cut[4] & (|setup_frame_n_x_cut[3:1]);
    wire setup_frame_n_x_under = setup_frame_n_x_cut[4] & ~(&setup_frame_n_x_cut[3:1]);
    wire signed [1:-18] setup_frame_n_x = setup_frame_n_x_over ? 20'h7ffff : setup_frame_n_x_under ? 20'h80000 : setup_frame_n_x_cut[1:-18]; // s20f18
    wire signed [4:-36] setup_frame_n_y_sum = {setup_frame_n21_s3[3], setup_frame_n21_s3} + 41'h20000;
    wire signed [4:-18] setup_frame_n_y_cut = setup_frame_n_y_sum[4:-18];
    wire setup_frame_n_y_over = ~setup_frame_n_y_cut[4] & (|setup_frame_n_y_cut[3:1]);
    wire setup_frame_n_y_under = setup_frame_n_y_cut[4] & ~(&setup_frame_n_y_cut[3:1]);
    wire signed [1:-18] setup_frame_n_y = setup_frame_n_y_over ? 20'h7ffff : setup_frame_n_y_under ? 20'h80000 : setup_frame_n_y_cut[1:-18]; // s20f18
    // setup.light
    wire signed [4:-36] setup_light_world_x_sum = {setup_light_n29_s3[3], setup_light_n29_s3} + 41'h20000;
    wire signed [4:-18] setup_light_world_x_cut = setup_light_world_x_sum[4:-18];
    wire setup_light_world_x_over = ~setup_light_world_x_cut[4] & (|setup_light_world_x_cut[3:1]);
    wire setup_light_world_x_under = setup_light_world_x_cut[4] & ~(&setup_light_world_x_cut[3:1]);
    wire signed [1:-18] setup_light_world_x = setup_light_world_x_over ? 20'h7ffff : setup_light_world_x_under ? 20'h80000 : setup_light_world_x_cut[1:-18]; // s20f18
    wire signed [4:-36] setup_light_world_y_sum = {setup_light_n31_s3[3], setup_light_n31_s3} + 41'h20000;
    wire signed [4:-18] setup_light_world_y_cut = setup_light_world_y_sum[4:-18];
    wire setup_light_world_y_over = ~setup_light_world_y_cut[4] & (|setup_light_world_y_cut[3:1]);
    wire setup_light_world_y_under = setup_light_world_y_cut[4] & ~(&setup_light_world_y_cut[3:1]);
    wire signed [1:-18] setup_light_world_y = setup_light_world_y_over ? 20'h7ffff : setup_light_world_y_under ? 20'h80000 : setup_light_world_y_cut[1:-18]; // s20f18
    // setup.half
    wire signed [4:-36] setup_half_world_x_sum = {setup_half_n121_s3[3], setup_half_n121_s3} + 41'h20000;
    wire signed [4:-18] setup_half_world_x_cut = setup_half_world_x_sum[4:-18];
    wire setup_half_world_x_over = ~setup_half_world_x_cut[4] & (|setup_half_world_x_cut[3:1]);
    wire setup_half_world_x_under = setup_half_world_x_cut[4] & ~(&setup_half_world_x_cut[3:1]);
    wire signed [1:-18] setup_half_world_x = setup_half_world_x_over ? 20'h7ffff : setup_half_world_x_under ? 20'h80000 : setup_half_world_x_cut[1:-18]; // s20f18
    wire signed [4:-36] setup_half_world_y_sum = {setup_half_n123_s3[3], setup_half_n123_s3} + 41'h20000;
    wire signed [4:-18] setup_half_world_y_cut = setup_half_world_y_sum[4:-18];
    wire setup_half_world_y_over = ~setup_half_world_y_cut[4] & (|setup_half_world_y_cut[3:1]);
    wire setup_half_world_y_under = setup_half_world_y_cut[4] & ~(&setup_half_world_y_cut[3:1]);
    wire signed [1:-18] setup_half_world_y = setup_half_world_y_over ? 20'h7ffff : setup_half_world_y_under ? 20'h80000 : setup_half_world_y_cut[1:-18]; // s20f18

    reg signed [1:-18] setup_frame_sincos_n10_s4; // s20f18
    reg signed [1:-18] setup_frame_sincos_n11_s4; // s20f18
    reg signed [1:-18] setup_frame_t_x_s4; // s20f18
    reg signed [1:-18] setup_frame_t_y_s4; // s20f18
    reg signed [1:-18] setup_frame_n_x_s4; // s20f18
    reg signed [1:-18] setup_frame_n_y_s4; // s20f18
    reg signed [1:-18] setup_light_world_x_s4; // s20f18
    reg signed [1:-18] setup_light_world_y_s4; // s20f18
    reg signed [3:-36] setup_light_n35_s4; // s40f36
    reg signed [3:-36] setup_light_n40_s4; // s40f36
    reg signed [1:-18] setup_half_world_x_s4; // s20f18
    reg signed [1:-18] setup_half_world_y_s4; // s20f18
    reg signed [3:-36] setup_half_n127_s4; // s40f36
    reg signed [3:-36] setup_half_n132_s4; // s40f36
    reg [-1:-16] setup_phi_p_s4; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s4; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s4; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_frame_sincos_n10_s4 <= setup_frame_sincos_n10_s3;
            setup_frame_sincos_n11_s4 <= setup_frame_sincos_n11_s3;
            setup_frame_t_x_s4 <= setup_frame_t_x;
            setup_frame_t_y_s4 <= setup_frame_t_y;
            setup_frame_n_x_s4 <= setup_frame_n_x;
            setup_frame_n_y_s4 <= setup_frame_n_y;
            setup_light_world_x_s4 <= setup_light_world_x;
            setup_light_world_y_s4 <= setup_light_world_y;
            setup_light_n35_s4 <= setup_light_n35_s3;
            setup_light_n40_s4 <= setup_light_n40_s3;
            setup_half_world_x_s4 <= setup_half_world_x;
            setup_half_world_y_s4 <= setup_half_world_y;
            setup_half_n127_s4 <= setup_half_n127_s3;
            setup_half_n132_s4 <= setup_half_n132_s3;
            setup_phi_p_s4 <= setup_phi_p_s3;
            dot_l_sincos_n215_s4 <= dot_l_sincos_n215_s3;
            dot_l_sincos_n216_s4 <= dot_l_sincos_n216_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // setup.light
    wire signed [3:-36] setup_light_n33 = setup_frame_t_x_s4 * setup_light_world_x_s4; // s40f36
    wire signed [3:-36] setup_light_n34 = setup_frame_t_y_s4 * setup_light_world_y_s4; // s40f36
    wire signed [3:-36] setup_light_n36 = setup_frame_sincos_n10_s4 * setup_light_world_x_s4; // s40f36
    wire signed [3:-36] setup_light_n37 = setup_frame_sincos_n11_s4 * setup_light_world_y_s4; // s40f36
    wire signed [3:-36] setup_light_n38 = setup_frame_n_x_s4 * setup_light_world_x_s4; // s40f36
    wire signed [3:-36] setup_light_n39 = setup_frame_n_y_s4 * setup_light_world_y_s4; // s40f36
    // setup.half
    wire signed [3:-36] setup_half_n125 = setup_frame_t_x_s4 * setup_half_world_x_s4; // s40f36
    wire signed [3:-36] setup_half_n126 = setup_frame_t_y_s4 * setup_half_world_y_s4; // s40f36
    wire signed [3:-36] setup_half_n128 = setup_frame_sincos_n10_s4 * setup_half_world_x_s4; // s40f36
    wire signed [3:-36] setup_half_n129 = setup_frame_sincos_n11_s4 * setup_half_world_y_s4; // s40f36
    wire signed [3:-36] setup_half_n130 = setup_frame_n_x_s4 * setup_half_world_x_s4; // s40f36
    wire signed [3:-36] setup_half_n131 = setup_frame_n_y_s4 * setup_half_world_y_s4; // s40f36

    reg signed [3:-36] setup_light_n33_s5; // s40f36
    reg signed [3:-36] setup_light_n34_s5; // s40f36
    reg signed [3:-36] setup_light_n35_s5; // s40f36
    reg signed [3:-36] setup_light_n36_s5; // s40f36
    reg signed [3:-36] setup_light_n37_s5; // s40f36
    reg signed [3:-36] setup_light_n38_s5; // s40f36
    reg signed [3:-36] setup_light_n39_s5; // s40f36
    reg signed [3:-36] setup_light_n40_s5; // s40f36
    reg signed [3:-36] setup_half_n125_s5; // s40f36
    reg signed [3:-36] setup_half_n126_s5; // s40f36
    reg signed [3:-36] setup_half_n127_s5; // s40f36
    reg signed [3:-36] setup_half_n128_s5; // s40f36
    reg signed [3:-36] setup_half_n129_s5; // s40f36
    reg signed [3:-36] setup_half_n130_s5; // s40f36
    reg signed [3:-36] setup_half_n131_s5; // s40f36
    reg signed [3:-36] setup_half_n132_s5; // s40f36
    reg [-1:-16] setup_phi_p_s5; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s5; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s5; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_n33_s5 <= setup_light_n33;
            setup_light_n34_s5 <= setup_light_n34;
            setup_light_n35_s5 <= setup_light_n35_s4;
            setup_light_n36_s5 <= setup_light_n36;
            setup_light_n37_s5 <= setup_light_n37;
            setup_light_n38_s5 <= setup_light_n38;
            setup_light_n39_s5 <= setup_light_n39;
            setup_light_n40_s5 <= setup_light_n40_s4;
            setup_half_n125_s5 <= setup_half_n125;
            setup_half_n126_s5 <= setup_half_n126;
            setup_half_n127_s5 <= setup_half_n127_s4;
            setup_half_n128_s5 <= setup_half_n128;
            setup_half_n129_s5 <= setup_half_n129;
            setup_half_n130_s5 <= setup_half_n130;
            setup_half_n131_s5 <= setup_half_n131;
            setup_half_n132_s5 <= setup_half_n132_s4;
            setup_phi_p_s5 <= setup_phi_p_s4;
            dot_l_sincos_n215_s5 <= dot_l_sincos_n215_s4;
            dot_l_sincos_n216_s5 <= dot_l_sincos_n216_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // setup.light
    wire signed [4:-36] setup_light_n41 = {setup_light_n33_s5[3], setup_light_n33_s5} + {setup_light_n34_s5[3], setup_light_n34_s5}; // s41f36
    wire signed [5:-36] setup_light_n42 = {setup_light_n41[4], setup_light_n41} - {{2{setup_light_n35_s5[3]}}, setup_light_n35_s5}; // s42f36
    wire signed [4:-36] setup_light_n43 = {setup_light_n37_s5[3], setup_light_n37_s5} - {setup_light_n36_s5[3], setup_light_n36_s5}; // s41f36
    wire signed [4:-36] setup_light_n44 = {setup_light_n38_s5[3], setup_light_n38_s5} + {setup_light_n39_s5[3], setup_light_n39_s5}; // s41f36
    wire signed [5:-36] setup_light_n45 = {setup_light_n44[4], setup_light_n44} + {{2{setup_light_n40_s5[3]}}, setup_light_n40_s5}; // s42f36
    wire signed [5:-36] setup_light_y_sum = {setup_light_n43[4], setup_light_n43} + 42'h20000;
    wire signed [5:-18] setup_light_y_cut = setup_light_y_sum[5:-18];
    wire setup_light_y_over = ~setup_light_y_cut[5] & (|setup_light_y_cut[4:1]);
    wire setup_light_y_under = setup_light_y_cut[5] & ~(&setup_light_y_cut[4:1]);
    wire signed [1:-18] setup_light_y = setup_light_y_over ? 20'h7ffff : setup_light_y_under ? 20'h80000 : setup_light_y_cut[1:-18]; // s20f18
    // setup.light.azimuth
    wire [1:-18] setup_light_azimuth_n50_neg = -setup_light_y;
    wire [1:-18] setup_light_azimuth_n50 = setup_light_y[1] ? setup_light_azimuth_n50_neg : setup_light_y; // u20f18
    wire setup_light_azimuth_n76 = setup_light_y[1]; // u1f0
    // setup.half
    wire signed [4:-36] setup_half_n133 = {setup_half_n125_s5[3], setup_half_n125_s5} + {setup_half_n126_s5[3], setup_half_n126_s5}; // s41f36
    wire signed [5:-36] setup_half_n134 = {setup_half_n133[4], setup_half_n133} - {{2{setup_half_n127_s5[3]}}, setup_half_n127_s5}; // s42f36
    wire signed [4:-36] setup_half_n135 = {setup_half_n129_s5[3], setup_half_n129_s5} - {setup_half_n128_s5[3], setup_half_n128_s5}; // s41f36
    wire signed [4:-36] setup_half_n136 = {setup_half_n130_s5[3], setup_half_n130_s5} + {setup_half_n131_s5[3], setup_half_n131_s5}; // s41f36
    wire signed [5:-36] setup_half_n137 = {setup_half_n136[4], setup_half_n136} + {{2{setup_half_n132_s5[3]}}, setup_half_n132_s5}; // s42f36
    wire signed [5:-36] setup_half_y_sum = {setup_half_n135[4], setup_half_n135} + 42'h20000;
    wire signed [5:-18] setup_half_y_cut = setup_half_y_sum[5:-18];
    wire setup_half_y_over = ~setup_half_y_cut[5] & (|setup_half_y_cut[4:1]);
    wire setup_half_y_under = setup_half_y_cut[5] & ~(&setup_half_y_cut[4:1]);
    wire signed [1:-18] setup_half_y = setup_half_y_over ? 20'h7ffff : setup_half_y_under ? 20'h80000 : setup_half_y_cut[1:-18]; // s20f18
    // setup.half.azimuth
    wire [1:-18] setup_half_azimuth_n142_neg = -setup_half_y;
    wire [1:-18] setup_half_azimuth_n142 = setup_half_y[1] ? setup_half_azimuth_n142_neg : setup_half_y; // u20f18
    wire setup_half_azimuth_n166 = setup_half_y[1]; // u1f0

    reg signed [5:-36] setup_light_n42_s6; // s42f36
    reg signed [5:-36] setup_light_n45_s6; // s42f36
    reg [1:-18] setup_light_azimuth_n50_s6; // u20f18
    reg setup_light_azimuth_n76_s6; // u1f0
    reg signed [5:-36] setup_half_n134_s6; // s42f36
    reg signed [5:-36] setup_half_n137_s6; // s42f36
    reg [1:-18] setup_half_azimuth_n142_s6; // u20f18
    reg setup_half_azimuth_n166_s6; // u1f0
    reg [-1:-16] setup_phi_p_s6; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s6; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s6; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_n42_s6 <= setup_light_n42;
            setup_light_n45_s6 <= setup_light_n45;
            setup_light_azimuth_n50_s6 <= setup_light_azimuth_n50;
            setup_light_azimuth_n76_s6 <= setup_light_azimuth_n76;
            setup_half_n134_s6 <= setup_half_n134;
            setup_half_n137_s6 <= setup_half_n137;
            setup_half_azimuth_n142_s6 <= setup_half_azimuth_n142;
            setup_half_azimuth_n166_s6 <= setup_half_azimuth_n166;
            setup_phi_p_s6 <= setup_phi_p_s5;
            dot_l_sincos_n215_s6 <= dot_l_sincos_n215_s5;
            dot_l_sincos_n216_s6 <= dot_l_sincos_n216_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // setup.light
    wire signed [6:-36] setup_light_x_sum = {setup_light_n42_s6[5], setup_light_n42_s6} + 43'h20000;
    wire signed [6:-18] setup_light_x_cut = setup_light_x_sum[6:-18];
    wire setup_light_x_over = ~setup_light_x_cut[6] & (|setup_light_x_cut[5:1]);
    wire setup_light_x_under = setup_light_x_cut[6] & ~(&setup_light_x_cut[5:1]);
    wire signed [1:-18] setup_light_x = setup_light_x_over ? 20'h7ffff : setup_light_x_under ? 20'h80000 : setup_light_x_cut[1:-18]; // s20f18
    wire signed [6:-36] setup_light_z_sum = {setup_light_n45_s6[5], setup_light_n45_s6} + 43'h20000;
    wire signed [6:-18] setup_light_z_cut = setup_light_z_sum[6:-18];
    wire setup_light_z_over = ~setup_light_z_cut[6] & (|setup_light_z_cut[5:1]);
    wire setup_light_z_under = setup_light_z_cut[6] & ~(&setup_light_z_cut[5:1]);
    wire signed [1:-18] setup_light_z = setup_light_z_over ? 20'h7ffff : setup_light_z_under ? 20'h80000 : setup_light_z_cut[1:-18]; // s20f18
    // setup.light.azimuth
    wire [1:-18] setup_light_azimuth_n49_neg = -setup_light_x;
    wire [1:-18] setup_light_azimuth_n49 = setup_light_x[1] ? setup_light_azimuth_n49_neg : setup_light_x; // u20f18
    wire setup_light_azimuth_n51 = setup_light_azimuth_n49 < setup_light_azimuth_n50_s6; // u1f0
    wire [1:-18] setup_light_azimuth_n52 = setup_light_azimuth_n51 ? setup_light_azimuth_n50_s6 : setup_light_azimuth_n49; // u20f18
    wire [1:-18] setup_light_azimuth_n53 = setup_light_azimuth_n51 ? setup_light_azimuth_n49 : setup_light_azimuth_n50_s6; // u20f18
    wire setup_light_azimuth_n72 = setup_light_x[1]; // u1f0
    // setup.light.polar_angle
    wire [1:-18] setup_light_polar_angle_n83_neg = -setup_light_z;
    wire [1:-18] setup_light_polar_angle_n83 = setup_light_z[1] ? setup_light_polar_angle_n83_neg : setup_light_z; // u20f18
    wire setup_light_polar_angle_n104 = setup_light_z[1]; // u1f0
    // setup.half
    wire signed [6:-36] setup_half_x_sum = {setup_half_n134_s6[5], setup_half_n134_s6} + 43'h20000;
    wire signed [6:-18] setup_half_x_cut = setup_half_x_sum[6:-18];
    wire setup_half_x_over = ~setup_half_x_cut[6] & (|setup_half_x_cut[5:1]);
    wire setup_half_x_under = setup_half_x_cut[6] & ~(&setup_half_x_cut[5:1]);
    wire signed [1:-18] setup_half_x = setup_half_x_over ? 20'h7ffff : setup_half_x_under ? 20'h80000 : setup_half_x_cut[1:-18]; // s20f18
    wire signed [6:-36] setup_half_z_sum = {setup_half_n137_s6[5], setup_half_n137_s6} + 43'h20000;
    wire signed [6:-18] setup_half_z_cut = setup_half_z_sum[6:-18];
    wire setup_half_z_over = ~setup_half_z_cut[6] & (|setup_half_z_cut[5:1]);
    wire setup_half_z_under = setup_half_z_cut[6] & ~(&setup_half_z_cut[5:1]);
    wire signed [1:-18] setup_half_z = setup_half_z_over ? 20'h7ffff : setup_half_z_under ? 20'h80000 : setup_half_z_cut[1:-18]; // s20f18
    // setup.half.azimuth
    wire [1:-18] setup_half_azimuth_n141_neg = -setup_half_x;
    wire [1:-18] setup_half_azimuth_n141 = setup_half_x[1] ? setup_half_azimuth_n141_neg : setup_half_x; // u20f18
    wire setup_half_azimuth_n143 = setup_half_azimuth_n141 < setup_half_azimuth_n142_s6; // u1f0
    wire [1:-18] setup_half_azimuth_n144 = setup_half_azimuth_n143 ? setup_half_azimuth_n142_s6 : setup_half_azimuth_n141; // u20f18
    wire [1:-18] setup_half_azimuth_n145 = setup_half_azimuth_n143 ? setup_half_azimuth_n141 : setup_half_azimuth_n142_s6; // u20f18
    wire setup_half_azimuth_n163 = setup_half_x[1]; // u1f0
    // setup.half.polar_angle
    wire [1:-18] setup_half_polar_angle_n173_neg = -setup_half_z;
    wire [1:-18] setup_half_polar_angle_n173 = setup_half_z[1] ? setup_half_polar_angle_n173_neg : setup_half_z; // u20f18
    wire setup_half_polar_angle_n194 = setup_half_z[1]; // u1f0

    reg setup_light_azimuth_n51_s7; // u1f0
    reg [1:-18] setup_light_azimuth_n52_s7; // u20f18
    reg [1:-18] setup_light_azimuth_n53_s7; // u20f18
    reg setup_light_azimuth_n72_s7; // u1f0
    reg setup_light_azimuth_n76_s7; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s7; // u20f18
    reg setup_light_polar_angle_n104_s7; // u1f0
    reg setup_half_azimuth_n143_s7; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s7; // u20f18
    reg [1:-18] setup_half_azimuth_n145_s7; // u20f18
    reg setup_half_azimuth_n163_s7; // u1f0
    reg setup_half_azimuth_n166_s7; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s7; // u20f18
    reg setup_half_polar_angle_n194_s7; // u1f0
    reg [-1:-16] setup_phi_p_s7; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s7; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s7; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n51_s7 <= setup_light_azimuth_n51;
            setup_light_azimuth_n52_s7 <= setup_light_azimuth_n52;
            setup_light_azimuth_n53_s7 <= setup_light_azimuth_n53;
            setup_light_azimuth_n72_s7 <= setup_light_azimuth_n72;
            setup_light_azimuth_n76_s7 <= setup_light_azimuth_n76_s6;
            setup_light_polar_angle_n83_s7 <= setup_light_polar_angle_n83;
            setup_light_polar_angle_n104_s7 <= setup_light_polar_angle_n104;
            setup_half_azimuth_n143_s7 <= setup_half_azimuth_n143;
            setup_half_azimuth_n144_s7 <= setup_half_azimuth_n144;
            setup_half_azimuth_n145_s7 <= setup_half_azimuth_n145;
            setup_half_azimuth_n163_s7 <= setup_half_azimuth_n163;
            setup_half_azimuth_n166_s7 <= setup_half_azimuth_n166_s6;
            setup_half_polar_angle_n173_s7 <= setup_half_polar_angle_n173;
            setup_half_polar_angle_n194_s7 <= setup_half_polar_angle_n194;
            setup_phi_p_s7 <= setup_phi_p_s6;
            dot_l_sincos_n215_s7 <= dot_l_sincos_n215_s6;
            dot_l_sincos_n216_s7 <= dot_l_sincos_n216_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // setup.light.azimuth
    wire [31:0] setup_light_azimuth_n54_padded = {setup_light_azimuth_n52_s7, 12'hfff};
    wire setup_light_azimuth_n54_skip16 = setup_light_azimuth_n54_padded[31:16] == 16'h0;
    wire [15:0] setup_light_azimuth_n54_part16 = setup_light_azimuth_n54_skip16 ? setup_light_azimuth_n54_padded[15:0] : setup_light_azimuth_n54_padded[31:16];
    wire setup_light_azimuth_n54_skip8 = setup_light_azimuth_n54_part16[15:8] == 8'h0;
    wire [7:0] setup_light_azimuth_n54_part8 = setup_light_azimuth_n54_skip8 ? setup_light_azimuth_n54_part16[7:0] : setup_light_azimuth_n54_part16[15:8];
    wire setup_light_azimuth_n54_skip4 = setup_light_azimuth_n54_part8[7:4] == 4'h0;
    wire [3:0] setup_light_azimuth_n54_part4 = setup_light_azimuth_n54_skip4 ? setup_light_azimuth_n54_part8[3:0] : setup_light_azimuth_n54_part8[7:4];
    wire setup_light_azimuth_n54_skip2 = setup_light_azimuth_n54_part4[3:2] == 2'h0;
    wire [1:0] setup_light_azimuth_n54_part2 = setup_light_azimuth_n54_skip2 ? setup_light_azimuth_n54_part4[1:0] : setup_light_azimuth_n54_part4[3:2];
    wire setup_light_azimuth_n54_skip1 = setup_light_azimuth_n54_part2[1] == 1'b0;
    wire [4:0] setup_light_azimuth_n54 = {setup_light_azimuth_n54_skip16, setup_light_azimuth_n54_skip8, setup_light_azimuth_n54_skip4, setup_light_azimuth_n54_skip2, setup_light_azimuth_n54_skip1}; // u5f0
    wire setup_light_azimuth_n55_past = 5'h14 < setup_light_azimuth_n54;
    wire [4:0] setup_light_azimuth_n55_count = setup_light_azimuth_n55_past ? 5'h14 : setup_light_azimuth_n54;
    wire [21:-18] setup_light_azimuth_n55 = {20'h0, setup_light_azimuth_n52_s7} << setup_light_azimuth_n55_count; // u40f18
    wire [19:0] setup_light_azimuth_n56 = setup_light_azimuth_n55[1:-18]; // u20f0
    wire setup_light_azimuth_n57_past = 5'h14 < setup_light_azimuth_n54;
    wire [4:0] setup_light_azimuth_n57_count = setup_light_azimuth_n57_past ? 5'h14 : setup_light_azimuth_n54;
    wire [21:-18] setup_light_azimuth_n57 = {20'h0, setup_light_azimuth_n53_s7} << setup_light_azimuth_n57_count; // u40f18
    wire [19:0] setup_light_azimuth_n58 = setup_light_azimuth_n57[1:-18]; // u20f0
    wire [18:0] setup_light_azimuth_n59 = setup_light_azimuth_n56[18:0]; // u19f0
    wire [-2:-20] setup_light_azimuth_n60 = setup_light_azimuth_n59; // u19f20
    // setup.light.azimuth.recip
    wire [9:0] setup_light_azimuth_recip_n61 = setup_light_azimuth_n60[-2:-11]; // u10f0
    // setup.light.azimuth
    wire [-1:-20] setup_light_azimuth_n63 = setup_light_azimuth_n58; // u20f20
    // setup.half.azimuth
    wire [31:0] setup_half_azimuth_n146_padded = {setup_half_azimuth_n144_s7, 12'hfff};
    wire setup_half_azimuth_n146_skip16 = setup_half_azimuth_n146_padded[31:16] == 16'h0;
    wire [15:0] setup_half_azimuth_n146_part16 = setup_half_azimuth_n146_skip16 ? setup_half_azimuth_n146_padded[15:0] : setup_half_azimuth_n146_padded[31:16];
    wire setup_half_azimuth_n146_skip8 = setup_half_azimuth_n146_part16[15:8] == 8'h0;
    wire [7:0] setup_half_azimuth_n146_part8 = setup_half_azimuth_n146_skip8 ? setup_half_azimuth_n146_part16[7:0] : setup_half_azimuth_n146_part16[15:8];
    wire setup_half_azimuth_n146_skip4 = setup_half_azimuth_n146_part8[7:4] == 4'h0;
    wire [3:0] setup_half_azimuth_n146_part4 = setup_half_azimuth_n146_skip4 ? setup_half_azimuth_n146_part8[3:0] : setup_half_azimuth_n146_part8[7:4];
    wire setup_half_azimuth_n146_skip2 = setup_half_azimuth_n146_part4[3:2] == 2'h0;
    wire [1:0] setup_half_azimuth_n146_part2 = setup_half_azimuth_n146_skip2 ? setup_half_azimuth_n146_part4[1:0] : setup_half_azimuth_n146_part4[3:2];
    wire setup_half_azimuth_n146_skip1 = setup_half_azimuth_n146_part2[1] == 1'b0;
    wire [4:0] setup_half_azimuth_n146 = {setup_half_azimuth_n146_skip16, setup_half_azimuth_n146_skip8, setup_half_azimuth_n146_skip4, setup_half_azimuth_n146_skip2, setup_half_azimuth_n146_skip1}; // u5f0
    wire setup_half_azimuth_n147_past = 5'h14 < setup_half_azimuth_n146;
    wire [4:0] setup_half_azimuth_n147_count = setup_half_azimuth_n147_past ? 5'h14 : setup_half_azimuth_n146;
    wire [21:-18] setup_half_azimuth_n147 = {20'h0, setup_half_azimuth_n144_s7} << setup_half_azimuth_n147_count; // u40f18
    wire [19:0] setup_half_azimuth_n148 = setup_half_azimuth_n147[1:-18]; // u20f0
    wire setup_half_azimuth_n149_past = 5'h14 < setup_half_azimuth_n146;
    wire [4:0] setup_half_azimuth_n149_count = setup_half_azimuth_n149_past ? 5'h14 : setup_half_azimuth_n146;
    wire [21:-18] setup_half_azimuth_n149 = {20'h0, setup_half_azimuth_n145_s7} << setup_half_azimuth_n149_count; // u40f18
    wire [19:0] setup_half_azimuth_n150 = setup_half_azimuth_n149[1:-18]; // u20f0
    wire [18:0] setup_half_azimuth_n151 = setup_half_azimuth_n148[18:0]; // u19f0
    wire [-2:-20] setup_half_azimuth_n152 = setup_half_azimuth_n151; // u19f20
    // setup.half.azimuth.recip
    wire [9:0] setup_half_azimuth_recip_n153 = setup_half_azimuth_n152[-2:-11]; // u10f0
    // setup.half.azimuth
    wire [-1:-20] setup_half_azimuth_n155 = setup_half_azimuth_n150; // u20f20

    reg setup_light_azimuth_n51_s8; // u1f0
    reg [1:-18] setup_light_azimuth_n52_s8; // u20f18
    reg [9:0] setup_light_azimuth_recip_n61_s8; // u10f0
    reg [-1:-20] setup_light_azimuth_n63_s8; // u20f20
    reg setup_light_azimuth_n72_s8; // u1f0
    reg setup_light_azimuth_n76_s8; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s8; // u20f18
    reg setup_light_polar_angle_n104_s8; // u1f0
    reg setup_half_azimuth_n143_s8; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s8; // u20f18
    reg [9:0] setup_half_azimuth_recip_n153_s8; // u10f0
    reg [-1:-20] setup_half_azimuth_n155_s8; // u20f20
    reg setup_half_azimuth_n163_s8; // u1f0
    reg setup_half_azimuth_n166_s8; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s8; // u20f18
    reg setup_half_polar_angle_n194_s8; // u1f0
    reg [-1:-16] setup_phi_p_s8; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s8; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s8; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n51_s8 <= setup_light_azimuth_n51_s7;
            setup_light_azimuth_n52_s8 <= setup_light_azimuth_n52_s7;
            setup_light_azimuth_recip_n61_s8 <= setup_light_azimuth_recip_n61;
            setup_light_azimuth_n63_s8 <= setup_light_azimuth_n63;
            setup_light_azimuth_n72_s8 <= setup_light_azimuth_n72_s7;
            setup_light_azimuth_n76_s8 <= setup_light_azimuth_n76_s7;
            setup_light_polar_angle_n83_s8 <= setup_light_polar_angle_n83_s7;
            setup_light_polar_angle_n104_s8 <= setup_light_polar_angle_n104_s7;
            setup_half_azimuth_n143_s8 <= setup_half_azimuth_n143_s7;
            setup_half_azimuth_n144_s8 <= setup_half_azimuth_n144_s7;
            setup_half_azimuth_recip_n153_s8 <= setup_half_azimuth_recip_n153;
            setup_half_azimuth_n155_s8 <= setup_half_azimuth_n155;
            setup_half_azimuth_n163_s8 <= setup_half_azimuth_n163_s7;
            setup_half_azimuth_n166_s8 <= setup_half_azimuth_n166_s7;
            setup_half_polar_angle_n173_s8 <= setup_half_polar_angle_n173_s7;
            setup_half_polar_angle_n194_s8 <= setup_half_polar_angle_n194_s7;
            setup_phi_p_s8 <= setup_phi_p_s7;
            dot_l_sincos_n215_s8 <= dot_l_sincos_n215_s7;
            dot_l_sincos_n216_s8 <= dot_l_sincos_n216_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----

    reg setup_light_azimuth_n51_s9; // u1f0
    reg [1:-18] setup_light_azimuth_n52_s9; // u20f18
    reg [19:0] recip_row;
    reg [-1:-20] setup_light_azimuth_n63_s9; // u20f20
    reg setup_light_azimuth_n72_s9; // u1f0
    reg setup_light_azimuth_n76_s9; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s9; // u20f18
    reg setup_light_polar_angle_n104_s9; // u1f0
    reg setup_half_azimuth_n143_s9; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s9; // u20f18
    reg [19:0] recip_row_2;
    reg [-1:-20] setup_half_azimuth_n155_s9; // u20f20
    reg setup_half_azimuth_n163_s9; // u1f0
    reg setup_half_azimuth_n166_s9; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s9; // u20f18
    reg setup_half_polar_angle_n194_s9; // u1f0
    reg [-1:-16] setup_phi_p_s9; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s9; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s9; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n51_s9 <= setup_light_azimuth_n51_s8;
            setup_light_azimuth_n52_s9 <= setup_light_azimuth_n52_s8;
            recip_row <= recip_rom[setup_light_azimuth_recip_n61_s8];
            setup_light_azimuth_n63_s9 <= setup_light_azimuth_n63_s8;
            setup_light_azimuth_n72_s9 <= setup_light_azimuth_n72_s8;
            setup_light_azimuth_n76_s9 <= setup_light_azimuth_n76_s8;
            setup_light_polar_angle_n83_s9 <= setup_light_polar_angle_n83_s8;
            setup_light_polar_angle_n104_s9 <= setup_light_polar_angle_n104_s8;
            setup_half_azimuth_n143_s9 <= setup_half_azimuth_n143_s8;
            setup_half_azimuth_n144_s9 <= setup_half_azimuth_n144_s8;
            recip_row_2 <= recip_rom[setup_half_azimuth_recip_n153_s8];
            setup_half_azimuth_n155_s9 <= setup_half_azimuth_n155_s8;
            setup_half_azimuth_n163_s9 <= setup_half_azimuth_n163_s8;
            setup_half_azimuth_n166_s9 <= setup_half_azimuth_n166_s8;
            setup_half_polar_angle_n173_s9 <= setup_half_polar_angle_n173_s8;
            setup_half_polar_angle_n194_s9 <= setup_half_polar_angle_n194_s8;
            setup_phi_p_s9 <= setup_phi_p_s8;
            dot_l_sincos_n215_s9 <= dot_l_sincos_n215_s8;
            dot_l_sincos_n216_s9 <= dot_l_sincos_n216_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // setup.light.azimuth.recip
    wire [1:-18] setup_light_azimuth_recip_n62 = recip_row; // u20f18
    // setup.half.azimuth.recip
    wire [1:-18] setup_half_azimuth_recip_n154 = recip_row_2; // u20f18

    reg setup_light_azimuth_n51_s10; // u1f0
    reg [1:-18] setup_light_azimuth_n52_s10; // u20f18
    reg [1:-18] setup_light_azimuth_recip_n62_s10; // u20f18
    reg [-1:-20] setup_light_azimuth_n63_s10; // u20f20
    reg setup_light_azimuth_n72_s10; // u1f0
    reg setup_light_azimuth_n76_s10; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s10; // u20f18
    reg setup_light_polar_angle_n104_s10; // u1f0
    reg setup_half_azimuth_n143_s10; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s10; // u20f18
    reg [1:-18] setup_half_azimuth_recip_n154_s10; // u20f18
    reg [-1:-20] setup_half_azimuth_n155_s10; // u20f20
    reg setup_half_azimuth_n163_s10; // u1f0
    reg setup_half_azimuth_n166_s10; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s10; // u20f18
    reg setup_half_polar_angle_n194_s10; // u1f0
    reg [-1:-16] setup_phi_p_s10; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s10; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s10; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n51_s10 <= setup_light_azimuth_n51_s9;
            setup_light_azimuth_n52_s10 <= setup_light_azimuth_n52_s9;
            setup_light_azimuth_recip_n62_s10 <= setup_light_azimuth_recip_n62;
            setup_light_azimuth_n63_s10 <= setup_light_azimuth_n63_s9;
            setup_light_azimuth_n72_s10 <= setup_light_azimuth_n72_s9;
            setup_light_azimuth_n76_s10 <= setup_light_azimuth_n76_s9;
            setup_light_polar_angle_n83_s10 <= setup_light_polar_angle_n83_s9;
            setup_light_polar_angle_n104_s10 <= setup_light_polar_angle_n104_s9;
            setup_half_azimuth_n143_s10 <= setup_half_azimuth_n143_s9;
            setup_half_azimuth_n144_s10 <= setup_half_azimuth_n144_s9;
            setup_half_azimuth_recip_n154_s10 <= setup_half_azimuth_recip_n154;
            setup_half_azimuth_n155_s10 <= setup_half_azimuth_n155_s9;
            setup_half_azimuth_n163_s10 <= setup_half_azimuth_n163_s9;
            setup_half_azimuth_n166_s10 <= setup_half_azimuth_n166_s9;
            setup_half_polar_angle_n173_s10 <= setup_half_polar_angle_n173_s9;
            setup_half_polar_angle_n194_s10 <= setup_half_polar_angle_n194_s9;
            setup_phi_p_s10 <= setup_phi_p_s9;
            dot_l_sincos_n215_s10 <= dot_l_sincos_n215_s9;
            dot_l_sincos_n216_s10 <= dot_l_sincos_n216_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // setup.light.azimuth
    wire [1:-38] setup_light_azimuth_n64 = setup_light_azimuth_n63_s10 * setup_light_azimuth_recip_n62_s10; // u40f38
    // setup.half.azimuth
    wire [1:-38] setup_half_azimuth_n156 = setup_half_azimuth_n155_s10 * setup_half_azimuth_recip_n154_s10; // u40f38

    reg setup_light_azimuth_n51_s11; // u1f0
    reg [1:-18] setup_light_azimuth_n52_s11; // u20f18
    reg [1:-38] setup_light_azimuth_n64_s11; // u40f38
    reg setup_light_azimuth_n72_s11; // u1f0
    reg setup_light_azimuth_n76_s11; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s11; // u20f18
    reg setup_light_polar_angle_n104_s11; // u1f0
    reg setup_half_azimuth_n143_s11; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s11; // u20f18
    reg [1:-38] setup_half_azimuth_n156_s11; // u40f38
    reg setup_half_azimuth_n163_s11; // u1f0
    reg setup_half_azimuth_n166_s11; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s11; // u20f18
    reg setup_half_polar_angle_n194_s11; // u1f0
    reg [-1:-16] setup_phi_p_s11; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s11; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s11; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n51_s11 <= setup_light_azimuth_n51_s10;
            setup_light_azimuth_n52_s11 <= setup_light_azimuth_n52_s10;
            setup_light_azimuth_n64_s11 <= setup_light_azimuth_n64;
            setup_light_azimuth_n72_s11 <= setup_light_azimuth_n72_s10;
            setup_light_azimuth_n76_s11 <= setup_light_azimuth_n76_s10;
            setup_light_polar_angle_n83_s11 <= setup_light_polar_angle_n83_s10;
            setup_light_polar_angle_n104_s11 <= setup_light_polar_angle_n104_s10;
            setup_half_azimuth_n143_s11 <= setup_half_azimuth_n143_s10;
            setup_half_azimuth_n144_s11 <= setup_half_azimuth_n144_s10;
            setup_half_azimuth_n156_s11 <= setup_half_azimuth_n156;
            setup_half_azimuth_n163_s11 <= setup_half_azimuth_n163_s10;
            setup_half_azimuth_n166_s11 <= setup_half_azimuth_n166_s10;
            setup_half_polar_angle_n173_s11 <= setup_half_polar_angle_n173_s10;
            setup_half_polar_angle_n194_s11 <= setup_half_polar_angle_n194_s10;
            setup_phi_p_s11 <= setup_phi_p_s10;
            dot_l_sincos_n215_s11 <= dot_l_sincos_n215_s10;
            dot_l_sincos_n216_s11 <= dot_l_sincos_n216_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // setup.light.azimuth
    wire [2:-38] setup_light_azimuth_ratio_sum = {1'b0, setup_light_azimuth_n64_s11} + 41'h80000;
    wire [2:-18] setup_light_azimuth_ratio_cut = setup_light_azimuth_ratio_sum[2:-18];
    wire setup_light_azimuth_ratio_over = |setup_light_azimuth_ratio_cut[2:0];
    wire [-1:-18] setup_light_azimuth_ratio = setup_light_azimuth_ratio_over ? 18'h3ffff : setup_light_azimuth_ratio_cut[-1:-18]; // u18f18
    // setup.light.azimuth.atan
    wire [9:0] setup_light_azimuth_atan_n66 = setup_light_azimuth_ratio[-1:-10]; // u10f0
    // setup.half.azimuth
    wire [2:-38] setup_half_azimuth_ratio_sum = {1'b0, setup_half_azimuth_n156_s11} + 41'h80000;
    wire [2:-18] setup_half_azimuth_ratio_cut = setup_half_azimuth_ratio_sum[2:-18];
    wire setup_half_azimuth_ratio_over = |setup_half_azimuth_ratio_cut[2:0];
    wire [-1:-18] setup_half_azimuth_ratio = setup_half_azimuth_ratio_over ? 18'h3ffff : setup_half_azimuth_ratio_cut[-1:-18]; // u18f18
    // setup.half.azimuth.atan
    wire [9:0] setup_half_azimuth_atan_n158 = setup_half_azimuth_ratio[-1:-10]; // u10f0

    reg setup_light_azimuth_n51_s12; // u1f0
    reg [1:-18] setup_light_azimuth_n52_s12; // u20f18
    reg [37:0] atan_row;
    reg setup_light_azimuth_n72_s12; // u1f0
    reg setup_light_azimuth_n76_s12; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s12; // u20f18
    reg setup_light_polar_angle_n104_s12; // u1f0
    reg setup_half_azimuth_n143_s12; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s12; // u20f18
    reg [37:0] atan_row_2;
    reg setup_half_azimuth_n163_s12; // u1f0
    reg setup_half_azimuth_n166_s12; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s12; // u20f18
    reg setup_half_polar_angle_n194_s12; // u1f0
    reg [-1:-16] setup_phi_p_s12; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s12; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s12; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n51_s12 <= setup_light_azimuth_n51_s11;
            setup_light_azimuth_n52_s12 <= setup_light_azimuth_n52_s11;
            atan_row <= atan_rom[setup_light_azimuth_atan_n66];
            setup_light_azimuth_n72_s12 <= setup_light_azimuth_n72_s11;
            setup_light_azimuth_n76_s12 <= setup_light_azimuth_n76_s11;
            setup_light_polar_angle_n83_s12 <= setup_light_polar_angle_n83_s11;
            setup_light_polar_angle_n104_s12 <= setup_light_polar_angle_n104_s11;
            setup_half_azimuth_n143_s12 <= setup_half_azimuth_n143_s11;
            setup_half_azimuth_n144_s12 <= setup_half_azimuth_n144_s11;
            atan_row_2 <= atan_rom[setup_half_azimuth_atan_n158];
            setup_half_azimuth_n163_s12 <= setup_half_azimuth_n163_s11;
            setup_half_azimuth_n166_s12 <= setup_half_azimuth_n166_s11;
            setup_half_polar_angle_n173_s12 <= setup_half_polar_angle_n173_s11;
            setup_half_polar_angle_n194_s12 <= setup_half_polar_angle_n194_s11;
            setup_phi_p_s12 <= setup_phi_p_s11;
            dot_l_sincos_n215_s12 <= dot_l_sincos_n215_s11;
            dot_l_sincos_n216_s12 <= dot_l_sincos_n216_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // setup.light.azimuth.atan
    wire [0:-18] setup_light_azimuth_atan_n67 = atan_row[37:19]; // u19f18
    wire [0:-18] setup_light_azimuth_atan_n68 = atan_row[18:0]; // u19f18
    // setup.light.azimuth
    wire signed [1:-18] setup_light_azimuth_n70 = {1'b0, setup_light_azimuth_n69} - {1'b0, setup_light_azimuth_atan_n67}; // s20f18
    wire signed [1:-18] setup_light_azimuth_n71 = setup_light_azimuth_n51_s12 ? setup_light_azimuth_n70 : {1'b0, setup_light_azimuth_atan_n67}; // s20f18
    // setup.half.azimuth.atan
    wire [0:-18] setup_half_azimuth_atan_n159 = atan_row_2[37:19]; // u19f18
    wire [0:-18] setup_half_azimuth_atan_n160 = atan_row_2[18:0]; // u19f18
    // setup.half.azimuth
    wire signed [1:-18] setup_half_azimuth_n161 = {1'b0, setup_light_azimuth_n69} - {1'b0, setup_half_azimuth_atan_n159}; // s20f18
    wire signed [1:-18] setup_half_azimuth_n162 = setup_half_azimuth_n143_s12 ? setup_half_azimuth_n161 : {1'b0, setup_half_azimuth_atan_n159}; // s20f18

    reg [1:-18] setup_light_azimuth_n52_s13; // u20f18
    reg [0:-18] setup_light_azimuth_atan_n68_s13; // u19f18
    reg signed [1:-18] setup_light_azimuth_n71_s13; // s20f18
    reg setup_light_azimuth_n72_s13; // u1f0
    reg setup_light_azimuth_n76_s13; // u1f0
    reg [1:-18] setup_light_polar_angle_n83_s13; // u20f18
    reg setup_light_polar_angle_n104_s13; // u1f0
    reg [1:-18] setup_half_azimuth_n144_s13; // u20f18
    reg [0:-18] setup_half_azimuth_atan_n160_s13; // u19f18
    reg signed [1:-18] setup_half_azimuth_n162_s13; // s20f18
    reg setup_half_azimuth_n163_s13; // u1f0
    reg setup_half_azimuth_n166_s13; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s13; // u20f18
    reg setup_half_polar_angle_n194_s13; // u1f0
    reg [-1:-16] setup_phi_p_s13; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s13; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s13; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n52_s13 <= setup_light_azimuth_n52_s12;
            setup_light_azimuth_atan_n68_s13 <= setup_light_azimuth_atan_n68;
            setup_light_azimuth_n71_s13 <= setup_light_azimuth_n71;
            setup_light_azimuth_n72_s13 <= setup_light_azimuth_n72_s12;
            setup_light_azimuth_n76_s13 <= setup_light_azimuth_n76_s12;
            setup_light_polar_angle_n83_s13 <= setup_light_polar_angle_n83_s12;
            setup_light_polar_angle_n104_s13 <= setup_light_polar_angle_n104_s12;
            setup_half_azimuth_n144_s13 <= setup_half_azimuth_n144_s12;
            setup_half_azimuth_atan_n160_s13 <= setup_half_azimuth_atan_n160;
            setup_half_azimuth_n162_s13 <= setup_half_azimuth_n162;
            setup_half_azimuth_n163_s13 <= setup_half_azimuth_n163_s12;
            setup_half_azimuth_n166_s13 <= setup_half_azimuth_n166_s12;
            setup_half_polar_angle_n173_s13 <= setup_half_polar_angle_n173_s12;
            setup_half_polar_angle_n194_s13 <= setup_half_polar_angle_n194_s12;
            setup_phi_p_s13 <= setup_phi_p_s12;
            dot_l_sincos_n215_s13 <= dot_l_sincos_n215_s12;
            dot_l_sincos_n216_s13 <= dot_l_sincos_n216_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // setup.light.azimuth
    wire signed [2:-18] setup_light_azimuth_n74 = {2'h0, setup_light_azimuth_n73} - {setup_light_azimuth_n71_s13[1], setup_light_azimuth_n71_s13}; // s21f18
    wire signed [2:-18] setup_light_azimuth_n75 = setup_light_azimuth_n72_s13 ? setup_light_azimuth_n74 : {setup_light_azimuth_n71_s13[1], setup_light_azimuth_n71_s13}; // s21f18
    wire signed [3:-18] setup_light_azimuth_n77 = -{setup_light_azimuth_n75[2], setup_light_azimuth_n75}; // s22f18
    wire signed [3:-18] setup_light_azimuth_n78 = setup_light_azimuth_n76_s13 ? setup_light_azimuth_n77 : {setup_light_azimuth_n75[2], setup_light_azimuth_n75}; // s22f18
    wire [-1:-18] setup_light_azimuth_n79 = setup_light_azimuth_n78[-1:-18]; // u18f18
    wire [2:-36] setup_light_azimuth_n80 = setup_light_azimuth_n52_s13 * setup_light_azimuth_atan_n68_s13; // u39f36
    // setup.light
    wire [0:-18] setup_light_n111_sum = {1'b0, setup_light_azimuth_n79} + 19'h2;
    wire [0:-16] setup_light_n111_cut = setup_light_n111_sum[0:-16];
    wire [0:-16] setup_light_n111 = setup_light_n111_cut; // u17f16
    wire [-1:-16] setup_light_phi = setup_light_n111[-1:-16]; // u16f16
    // setup.half.azimuth
    wire signed [2:-18] setup_half_azimuth_n164 = {2'h0, setup_light_azimuth_n73} - {setup_half_azimuth_n162_s13[1], setup_half_azimuth_n162_s13}; // s21f18
    wire signed [2:-18] setup_half_azimuth_n165 = setup_half_azimuth_n163_s13 ? setup_half_azimuth_n164 : {setup_half_azimuth_n162_s13[1], setup_half_azimuth_n162_s13}; // s21f18
    wire signed [3:-18] setup_half_azimuth_n167 = -{setup_half_azimuth_n165[2], setup_half_azimuth_n165}; // s22f18
    wire signed [3:-18] setup_half_azimuth_n168 = setup_half_azimuth_n166_s13 ? setup_half_azimuth_n167 : {setup_half_azimuth_n165[2], setup_half_azimuth_n165}; // s22f18
    wire [-1:-18] setup_half_azimuth_n169 = setup_half_azimuth_n168[-1:-18]; // u18f18
    wire [2:-36] setup_half_azimuth_n170 = setup_half_azimuth_n144_s13 * setup_half_azimuth_atan_n160_s13; // u39f36
    // setup.half
    wire [0:-18] setup_half_n201_sum = {1'b0, setup_half_azimuth_n169} + 19'h2;
    wire [0:-16] setup_half_n201_cut = setup_half_n201_sum[0:-16];
    wire [0:-16] setup_half_n201 = setup_half_n201_cut; // u17f16
    wire [-1:-16] setup_half_phi = setup_half_n201[-1:-16]; // u16f16

    reg [2:-36] setup_light_azimuth_n80_s14; // u39f36
    reg [1:-18] setup_light_polar_angle_n83_s14; // u20f18
    reg setup_light_polar_angle_n104_s14; // u1f0
    reg [-1:-16] setup_light_phi_s14; // u16f16
    reg [2:-36] setup_half_azimuth_n170_s14; // u39f36
    reg [1:-18] setup_half_polar_angle_n173_s14; // u20f18
    reg setup_half_polar_angle_n194_s14; // u1f0
    reg [-1:-16] setup_half_phi_s14; // u16f16
    reg [-1:-16] setup_phi_p_s14; // u16f16
    reg signed [1:-18] dot_l_sincos_n215_s14; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s14; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_azimuth_n80_s14 <= setup_light_azimuth_n80;
            setup_light_polar_angle_n83_s14 <= setup_light_polar_angle_n83_s13;
            setup_light_polar_angle_n104_s14 <= setup_light_polar_angle_n104_s13;
            setup_light_phi_s14 <= setup_light_phi;
            setup_half_azimuth_n170_s14 <= setup_half_azimuth_n170;
            setup_half_polar_angle_n173_s14 <= setup_half_polar_angle_n173_s13;
            setup_half_polar_angle_n194_s14 <= setup_half_polar_angle_n194_s13;
            setup_half_phi_s14 <= setup_half_phi;
            setup_phi_p_s14 <= setup_phi_p_s13;
            dot_l_sincos_n215_s14 <= dot_l_sincos_n215_s13;
            dot_l_sincos_n216_s14 <= dot_l_sincos_n216_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // setup.light.azimuth
    wire [3:-36] setup_light_azimuth_n81_sum = {1'b0, setup_light_azimuth_n80_s14} + 40'h20000;
    wire [3:-18] setup_light_azimuth_n81_cut = setup_light_azimuth_n81_sum[3:-18];
    wire setup_light_azimuth_n81_over = |setup_light_azimuth_n81_cut[3:2];
    wire signed [2:-18] setup_light_azimuth_n81 = setup_light_azimuth_n81_over ? 21'hfffff : setup_light_azimuth_n81_cut[2:-18]; // s21f18
    // setup.light
    wire setup_light_n82_over = ~setup_light_azimuth_n81[2] & (|setup_light_azimuth_n81[1]);
    wire setup_light_n82_under = setup_light_azimuth_n81[2] & ~(&setup_light_azimuth_n81[1]);
    wire signed [1:-18] setup_light_n82 = setup_light_n82_over ? 20'h7ffff : setup_light_n82_under ? 20'h80000 : setup_light_azimuth_n81[1:-18]; // s20f18
    // setup.light.polar_angle
    wire [1:-18] setup_light_polar_angle_n84_neg = -setup_light_n82;
    wire [1:-18] setup_light_polar_angle_n84 = setup_light_n82[1] ? setup_light_polar_angle_n84_neg : setup_light_n82; // u20f18
    wire setup_light_polar_angle_n107 = setup_light_n82[1]; // u1f0
    // setup.half.azimuth
    wire [3:-36] setup_half_azimuth_n171_sum = {1'b0, setup_half_azimuth_n170_s14} + 40'h20000;
    wire [3:-18] setup_half_azimuth_n171_cut = setup_half_azimuth_n171_sum[3:-18];
    wire setup_half_azimuth_n171_over = |setup_half_azimuth_n171_cut[3:2];
    wire signed [2:-18] setup_half_azimuth_n171 = setup_half_azimuth_n171_over ? 21'hfffff : setup_half_azimuth_n171_cut[2:-18]; // s21f18
    // setup.half
    wire setup_half_n172_over = ~setup_half_azimuth_n171[2] & (|setup_half_azimuth_n171[1]);
    wire setup_half_n172_under = setup_half_azimuth_n171[2] & ~(&setup_half_azimuth_n171[1]);
    wire signed [1:-18] setup_half_n172 = setup_half_n172_over ? 20'h7ffff : setup_half_n172_under ? 20'h80000 : setup_half_azimuth_n171[1:-18]; // s20f18
    // setup.half.polar_angle
    wire [1:-18] setup_half_polar_angle_n174_neg = -setup_half_n172;
    wire [1:-18] setup_half_polar_angle_n174 = setup_half_n172[1] ? setup_half_polar_angle_n174_neg : setup_half_n172; // u20f18
    wire setup_half_polar_angle_n197 = setup_half_n172[1]; // u1f0
    // dot_l
    wire signed [0:-16] dot_l_n207 = {1'b0, setup_light_phi_s14} - {1'b0, setup_phi_p_s14}; // s17f16
    wire [-1:-16] dot_l_delta = dot_l_n207[-1:-16]; // u16f16
    // dot_l.sincos
    wire [9:0] dot_l_sincos_n209 = dot_l_delta[-1:-10]; // u10f0
    // dot_h
    wire signed [0:-16] dot_h_n223 = {1'b0, setup_half_phi_s14} - {1'b0, setup_phi_p_s14}; // s17f16
    wire [-1:-16] dot_h_delta = dot_h_n223[-1:-16]; // u16f16
    // dot_h.sincos
    wire [9:0] dot_h_sincos_n225 = dot_h_delta[-1:-10]; // u10f0

    reg [1:-18] setup_light_polar_angle_n83_s15; // u20f18
    reg [1:-18] setup_light_polar_angle_n84_s15; // u20f18
    reg setup_light_polar_angle_n104_s15; // u1f0
    reg setup_light_polar_angle_n107_s15; // u1f0
    reg [1:-18] setup_half_polar_angle_n173_s15; // u20f18
    reg [1:-18] setup_half_polar_angle_n174_s15; // u20f18
    reg setup_half_polar_angle_n194_s15; // u1f0
    reg setup_half_polar_angle_n197_s15; // u1f0
    reg [39:0] sincos_row_8;
    reg signed [1:-18] dot_l_sincos_n215_s15; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s15; // s20f18
    reg [39:0] sincos_row_9;
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n83_s15 <= setup_light_polar_angle_n83_s14;
            setup_light_polar_angle_n84_s15 <= setup_light_polar_angle_n84;
            setup_light_polar_angle_n104_s15 <= setup_light_polar_angle_n104_s14;
            setup_light_polar_angle_n107_s15 <= setup_light_polar_angle_n107;
            setup_half_polar_angle_n173_s15 <= setup_half_polar_angle_n173_s14;
            setup_half_polar_angle_n174_s15 <= setup_half_polar_angle_n174;
            setup_half_polar_angle_n194_s15 <= setup_half_polar_angle_n194_s14;
            setup_half_polar_angle_n197_s15 <= setup_half_polar_angle_n197;
            sincos_row_8 <= sincos_rom_4[dot_l_sincos_n209];
            dot_l_sincos_n215_s15 <= dot_l_sincos_n215_s14;
            dot_l_sincos_n216_s15 <= dot_l_sincos_n216_s14;
            sincos_row_9 <= sincos_rom_5[dot_h_sincos_n225];
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // setup.light.polar_angle
    wire setup_light_polar_angle_n85 = setup_light_polar_angle_n83_s15 < setup_light_polar_angle_n84_s15; // u1f0
    wire [1:-18] setup_light_polar_angle_n86 = setup_light_polar_angle_n85 ? setup_light_polar_angle_n84_s15 : setup_light_polar_angle_n83_s15; // u20f18
    wire [1:-18] setup_light_polar_angle_n87 = setup_light_polar_angle_n85 ? setup_light_polar_angle_n83_s15 : setup_light_polar_angle_n84_s15; // u20f18
    wire [31:0] setup_light_polar_angle_n88_padded = {setup_light_polar_angle_n86, 12'hfff};
    wire setup_light_polar_angle_n88_skip16 = setup_light_polar_angle_n88_padded[31:16] == 16'h0;
    wire [15:0] setup_light_polar_angle_n88_part16 = setup_light_polar_angle_n88_skip16 ? setup_light_polar_angle_n88_padded[15:0] : setup_light_polar_angle_n88_padded[31:16];
    wire setup_light_polar_angle_n88_skip8 = setup_light_polar_angle_n88_part16[15:8] == 8'h0;
    wire [7:0] setup_light_polar_angle_n88_part8 = setup_light_polar_angle_n88_skip8 ? setup_light_polar_angle_n88_part16[7:0] : setup_light_polar_angle_n88_part16[15:8];
    wire setup_light_polar_angle_n88_skip4 = setup_light_polar_angle_n88_part8[7:4] == 4'h0;
    wire [3:0] setup_light_polar_angle_n88_part4 = setup_light_polar_angle_n88_skip4 ? setup_light_polar_angle_n88_part8[3:0] : setup_light_polar_angle_n88_part8[7:4];
    wire setup_light_polar_angle_n88_skip2 = setup_light_polar_angle_n88_part4[3:2] == 2'h0;
    wire [1:0] setup_light_polar_angle_n88_part2 = setup_light_polar_angle_n88_skip2 ? setup_light_polar_angle_n88_part4[1:0] : setup_light_polar_angle_n88_part4[3:2];
    wire setup_light_polar_angle_n88_skip1 = setup_light_polar_angle_n88_part2[1] == 1'b0;
    wire [4:0] setup_light_polar_angle_n88 = {setup_light_polar_angle_n88_skip16, setup_light_polar_angle_n88_skip8, setup_light_polar_angle_n88_skip4, setup_light_polar_angle_n88_skip2, setup_light_polar_angle_n88_skip1}; // u5f0
    // setup.half.polar_angle
    wire setup_half_polar_angle_n175 = setup_half_polar_angle_n173_s15 < setup_half_polar_angle_n174_s15; // u1f0
    wire [1:-18] setup_half_polar_angle_n176 = setup_half_polar_angle_n175 ? setup_half_polar_angle_n174_s15 : setup_half_polar_angle_n173_s15; // u20f18
    wire [1:-18] setup_half_polar_angle_n177 = setup_half_polar_angle_n175 ? setup_half_polar_angle_n173_s15 : setup_half_polar_angle_n174_s15; // u20f18
    wire [31:0] setup_half_polar_angle_n178_padded = {setup_half_polar_angle_n176, 12'hfff};
    wire setup_half_polar_angle_n178_skip16 = setup_half_polar_angle_n178_padded[31:16] == 16'h0;
    wire [15:0] setup_half_polar_angle_n178_part16 = setup_half_polar_angle_n178_skip16 ? setup_half_polar_angle_n178_padded[15:0] : setup_half_polar_angle_n178_padded[31:16];
    wire setup_half_polar_angle_n178_skip8 = setup_half_polar_angle_n178_part16[15:8] == 8'h0;
    wire [7:0] setup_half_polar_angle_n178_part8 = setup_half_polar_angle_n178_skip8 ? setup_half_polar_angle_n178_part16[7:0] : setup_half_polar_angle_n178_part16[15:8];
    wire setup_half_polar_angle_n178_skip4 = setup_half_polar_angle_n178_part8[7:4] == 4'h0;
    wire [3:0] setup_half_polar_angle_n178_part4 = setup_half_polar_angle_n178_skip4 ? setup_half_polar_angle_n178_part8[3:0] : setup_half_polar_angle_n178_part8[7:4];
    wire setup_half_polar_angle_n178_skip2 = setup_half_polar_angle_n178_part4[3:2] == 2'h0;
    wire [1:0] setup_half_polar_angle_n178_part2 = setup_half_polar_angle_n178_skip2 ? setup_half_polar_angle_n178_part4[1:0] : setup_half_polar_angle_n178_part4[3:2];
    wire setup_half_polar_angle_n178_skip1 = setup_half_polar_angle_n178_part2[1] == 1'b0;
    wire [4:0] setup_half_polar_angle_n178 = {setup_half_polar_angle_n178_skip16, setup_half_polar_angle_n178_skip8, setup_half_polar_angle_n178_skip4, setup_half_polar_angle_n178_skip2, setup_half_polar_angle_n178_skip1}; // u5f0
    // dot_l.sincos
    wire signed [1:-18] dot_l_sincos_n210 = sincos_row_8[19:0]; // s20f18
    // dot_h.sincos
    wire signed [1:-18] dot_h_sincos_n226 = sincos_row_9[19:0]; // s20f18

    reg setup_light_polar_angle_n85_s16; // u1f0
    reg [1:-18] setup_light_polar_angle_n86_s16; // u20f18
    reg [1:-18] setup_light_polar_angle_n87_s16; // u20f18
    reg [4:0] setup_light_polar_angle_n88_s16; // u5f0
    reg setup_light_polar_angle_n104_s16; // u1f0
    reg setup_light_polar_angle_n107_s16; // u1f0
    reg setup_half_polar_angle_n175_s16; // u1f0
    reg [1:-18] setup_half_polar_angle_n176_s16; // u20f18
    reg [1:-18] setup_half_polar_angle_n177_s16; // u20f18
    reg [4:0] setup_half_polar_angle_n178_s16; // u5f0
    reg setup_half_polar_angle_n194_s16; // u1f0
    reg setup_half_polar_angle_n197_s16; // u1f0
    reg signed [1:-18] dot_l_sincos_n210_s16; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s16; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s16; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s16; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n85_s16 <= setup_light_polar_angle_n85;
            setup_light_polar_angle_n86_s16 <= setup_light_polar_angle_n86;
            setup_light_polar_angle_n87_s16 <= setup_light_polar_angle_n87;
            setup_light_polar_angle_n88_s16 <= setup_light_polar_angle_n88;
            setup_light_polar_angle_n104_s16 <= setup_light_polar_angle_n104_s15;
            setup_light_polar_angle_n107_s16 <= setup_light_polar_angle_n107_s15;
            setup_half_polar_angle_n175_s16 <= setup_half_polar_angle_n175;
            setup_half_polar_angle_n176_s16 <= setup_half_polar_angle_n176;
            setup_half_polar_angle_n177_s16 <= setup_half_polar_angle_n177;
            setup_half_polar_angle_n178_s16 <= setup_half_polar_angle_n178;
            setup_half_polar_angle_n194_s16 <= setup_half_polar_angle_n194_s15;
            setup_half_polar_angle_n197_s16 <= setup_half_polar_angle_n197_s15;
            dot_l_sincos_n210_s16 <= dot_l_sincos_n210;
            dot_l_sincos_n215_s16 <= dot_l_sincos_n215_s15;
            dot_l_sincos_n216_s16 <= dot_l_sincos_n216_s15;
            dot_h_sincos_n226_s16 <= dot_h_sincos_n226;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // setup.light.polar_angle
    wire setup_light_polar_angle_n89_past = 5'h14 < setup_light_polar_angle_n88_s16;
    wire [4:0] setup_light_polar_angle_n89_count = setup_light_polar_angle_n89_past ? 5'h14 : setup_light_polar_angle_n88_s16;
    wire [21:-18] setup_light_polar_angle_n89 = {20'h0, setup_light_polar_angle_n86_s16} << setup_light_polar_angle_n89_count; // u40f18
    wire [19:0] setup_light_polar_angle_n90 = setup_light_polar_angle_n89[1:-18]; // u20f0
    wire setup_light_polar_angle_n91_past = 5'h14 < setup_light_polar_angle_n88_s16;
    wire [4:0] setup_light_polar_angle_n91_count = setup_light_polar_angle_n91_past ? 5'h14 : setup_light_polar_angle_n88_s16;
    wire [21:-18] setup_light_polar_angle_n91 = {20'h0, setup_light_polar_angle_n87_s16} << setup_light_polar_angle_n91_count; // u40f18
    wire [19:0] setup_light_polar_angle_n92 = setup_light_polar_angle_n91[1:-18]; // u20f0
    wire [18:0] setup_light_polar_angle_n93 = setup_light_polar_angle_n90[18:0]; // u19f0
    wire [-2:-20] setup_light_polar_angle_n94 = setup_light_polar_angle_n93; // u19f20
    // setup.light.polar_angle.recip
    wire [9:0] setup_light_polar_angle_recip_n95 = setup_light_polar_angle_n94[-2:-11]; // u10f0
    // setup.light.polar_angle
    wire [-1:-20] setup_light_polar_angle_n97 = setup_light_polar_angle_n92; // u20f20
    // setup.half.polar_angle
    wire setup_half_polar_angle_n179_past = 5'h14 < setup_half_polar_angle_n178_s16;
    wire [4:0] setup_half_polar_angle_n179_count = setup_half_polar_angle_n179_past ? 5'h14 : setup_half_polar_angle_n178_s16;
    wire [21:-18] setup_half_polar_angle_n179 = {20'h0, setup_half_polar_angle_n176_s16} << setup_half_polar_angle_n179_count; // u40f18
    wire [19:0] setup_half_polar_angle_n180 = setup_half_polar_angle_n179[1:-18]; // u20f0
    wire setup_half_polar_angle_n181_past = 5'h14 < setup_half_polar_angle_n178_s16;
    wire [4:0] setup_half_polar_angle_n181_count = setup_half_polar_angle_n181_past ? 5'h14 : setup_half_polar_angle_n178_s16;
    wire [21:-18] setup_half_polar_angle_n181 = {20'h0, setup_half_polar_angle_n177_s16} << setup_half_polar_angle_n181_count; // u40f18
    wire [19:0] setup_half_polar_angle_n182 = setup_half_polar_angle_n181[1:-18]; // u20f0
    wire [18:0] setup_half_polar_angle_n183 = setup_half_polar_angle_n180[18:0]; // u19f0
    wire [-2:-20] setup_half_polar_angle_n184 = setup_half_polar_angle_n183; // u19f20
    // setup.half.polar_angle.recip
    wire [9:0] setup_half_polar_angle_recip_n185 = setup_half_polar_angle_n184[-2:-11]; // u10f0
    // setup.half.polar_angle
    wire [-1:-20] setup_half_polar_angle_n187 = setup_half_polar_angle_n182; // u20f20

    reg setup_light_polar_angle_n85_s17; // u1f0
    reg [19:0] recip_row_3;
    reg [-1:-20] setup_light_polar_angle_n97_s17; // u20f20
    reg setup_light_polar_angle_n104_s17; // u1f0
    reg setup_light_polar_angle_n107_s17; // u1f0
    reg setup_half_polar_angle_n175_s17; // u1f0
    reg [19:0] recip_row_4;
    reg [-1:-20] setup_half_polar_angle_n187_s17; // u20f20
    reg setup_half_polar_angle_n194_s17; // u1f0
    reg setup_half_polar_angle_n197_s17; // u1f0
    reg signed [1:-18] dot_l_sincos_n210_s17; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s17; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s17; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s17; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n85_s17 <= setup_light_polar_angle_n85_s16;
            recip_row_3 <= recip_rom_2[setup_light_polar_angle_recip_n95];
            setup_light_polar_angle_n97_s17 <= setup_light_polar_angle_n97;
            setup_light_polar_angle_n104_s17 <= setup_light_polar_angle_n104_s16;
            setup_light_polar_angle_n107_s17 <= setup_light_polar_angle_n107_s16;
            setup_half_polar_angle_n175_s17 <= setup_half_polar_angle_n175_s16;
            recip_row_4 <= recip_rom_2[setup_half_polar_angle_recip_n185];
            setup_half_polar_angle_n187_s17 <= setup_half_polar_angle_n187;
            setup_half_polar_angle_n194_s17 <= setup_half_polar_angle_n194_s16;
            setup_half_polar_angle_n197_s17 <= setup_half_polar_angle_n197_s16;
            dot_l_sincos_n210_s17 <= dot_l_sincos_n210_s16;
            dot_l_sincos_n215_s17 <= dot_l_sincos_n215_s16;
            dot_l_sincos_n216_s17 <= dot_l_sincos_n216_s16;
            dot_h_sincos_n226_s17 <= dot_h_sincos_n226_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // setup.light.polar_angle.recip
    wire [1:-18] setup_light_polar_angle_recip_n96 = recip_row_3; // u20f18
    // setup.half.polar_angle.recip
    wire [1:-18] setup_half_polar_angle_recip_n186 = recip_row_4; // u20f18

    reg setup_light_polar_angle_n85_s18; // u1f0
    reg [1:-18] setup_light_polar_angle_recip_n96_s18; // u20f18
    reg [-1:-20] setup_light_polar_angle_n97_s18; // u20f20
    reg setup_light_polar_angle_n104_s18; // u1f0
    reg setup_light_polar_angle_n107_s18; // u1f0
    reg setup_half_polar_angle_n175_s18; // u1f0
    reg [1:-18] setup_half_polar_angle_recip_n186_s18; // u20f18
    reg [-1:-20] setup_half_polar_angle_n187_s18; // u20f20
    reg setup_half_polar_angle_n194_s18; // u1f0
    reg setup_half_polar_angle_n197_s18; // u1f0
    reg signed [1:-18] dot_l_sincos_n210_s18; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s18; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s18; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s18; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n85_s18 <= setup_light_polar_angle_n85_s17;
            setup_light_polar_angle_recip_n96_s18 <= setup_light_polar_angle_recip_n96;
            setup_light_polar_angle_n97_s18 <= setup_light_polar_angle_n97_s17;
            setup_light_polar_angle_n104_s18 <= setup_light_polar_angle_n104_s17;
            setup_light_polar_angle_n107_s18 <= setup_light_polar_angle_n107_s17;
            setup_half_polar_angle_n175_s18 <= setup_half_polar_angle_n175_s17;
            setup_half_polar_angle_recip_n186_s18 <= setup_half_polar_angle_recip_n186;
            setup_half_polar_angle_n187_s18 <= setup_half_polar_angle_n187_s17;
            setup_half_polar_angle_n194_s18 <= setup_half_polar_angle_n194_s17;
            setup_half_polar_angle_n197_s18 <= setup_half_polar_angle_n197_s17;
            dot_l_sincos_n210_s18 <= dot_l_sincos_n210_s17;
            dot_l_sincos_n215_s18 <= dot_l_sincos_n215_s17;
            dot_l_sincos_n216_s18 <= dot_l_sincos_n216_s17;
            dot_h_sincos_n226_s18 <= dot_h_sincos_n226_s17;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // setup.light.polar_angle
    wire [1:-38] setup_light_polar_angle_n98 = setup_light_polar_angle_n97_s18 * setup_light_polar_angle_recip_n96_s18; // u40f38
    // setup.half.polar_angle
    wire [1:-38] setup_half_polar_angle_n188 = setup_half_polar_angle_n187_s18 * setup_half_polar_angle_recip_n186_s18; // u40f38

    reg setup_light_polar_angle_n85_s19; // u1f0
    reg [1:-38] setup_light_polar_angle_n98_s19; // u40f38
    reg setup_light_polar_angle_n104_s19; // u1f0
    reg setup_light_polar_angle_n107_s19; // u1f0
    reg setup_half_polar_angle_n175_s19; // u1f0
    reg [1:-38] setup_half_polar_angle_n188_s19; // u40f38
    reg setup_half_polar_angle_n194_s19; // u1f0
    reg setup_half_polar_angle_n197_s19; // u1f0
    reg signed [1:-18] dot_l_sincos_n210_s19; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s19; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s19; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s19; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n85_s19 <= setup_light_polar_angle_n85_s18;
            setup_light_polar_angle_n98_s19 <= setup_light_polar_angle_n98;
            setup_light_polar_angle_n104_s19 <= setup_light_polar_angle_n104_s18;
            setup_light_polar_angle_n107_s19 <= setup_light_polar_angle_n107_s18;
            setup_half_polar_angle_n175_s19 <= setup_half_polar_angle_n175_s18;
            setup_half_polar_angle_n188_s19 <= setup_half_polar_angle_n188;
            setup_half_polar_angle_n194_s19 <= setup_half_polar_angle_n194_s18;
            setup_half_polar_angle_n197_s19 <= setup_half_polar_angle_n197_s18;
            dot_l_sincos_n210_s19 <= dot_l_sincos_n210_s18;
            dot_l_sincos_n215_s19 <= dot_l_sincos_n215_s18;
            dot_l_sincos_n216_s19 <= dot_l_sincos_n216_s18;
            dot_h_sincos_n226_s19 <= dot_h_sincos_n226_s18;
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // setup.light.polar_angle
    wire [2:-38] setup_light_polar_angle_ratio_sum = {1'b0, setup_light_polar_angle_n98_s19} + 41'h80000;
    wire [2:-18] setup_light_polar_angle_ratio_cut = setup_light_polar_angle_ratio_sum[2:-18];
    wire setup_light_polar_angle_ratio_over = |setup_light_polar_angle_ratio_cut[2:0];
    wire [-1:-18] setup_light_polar_angle_ratio = setup_light_polar_angle_ratio_over ? 18'h3ffff : setup_light_polar_angle_ratio_cut[-1:-18]; // u18f18
    // setup.light.polar_angle.atan
    wire [9:0] setup_light_polar_angle_atan_n100 = setup_light_polar_angle_ratio[-1:-10]; // u10f0
    // setup.half.polar_angle
    wire [2:-38] setup_half_polar_angle_ratio_sum = {1'b0, setup_half_polar_angle_n188_s19} + 41'h80000;
    wire [2:-18] setup_half_polar_angle_ratio_cut = setup_half_polar_angle_ratio_sum[2:-18];
    wire setup_half_polar_angle_ratio_over = |setup_half_polar_angle_ratio_cut[2:0];
    wire [-1:-18] setup_half_polar_angle_ratio = setup_half_polar_angle_ratio_over ? 18'h3ffff : setup_half_polar_angle_ratio_cut[-1:-18]; // u18f18
    // setup.half.polar_angle.atan
    wire [9:0] setup_half_polar_angle_atan_n190 = setup_half_polar_angle_ratio[-1:-10]; // u10f0

    reg setup_light_polar_angle_n85_s20; // u1f0
    reg [37:0] atan_row_3;
    reg setup_light_polar_angle_n104_s20; // u1f0
    reg setup_light_polar_angle_n107_s20; // u1f0
    reg setup_half_polar_angle_n175_s20; // u1f0
    reg [37:0] atan_row_4;
    reg setup_half_polar_angle_n194_s20; // u1f0
    reg setup_half_polar_angle_n197_s20; // u1f0
    reg signed [1:-18] dot_l_sincos_n210_s20; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s20; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s20; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s20; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n85_s20 <= setup_light_polar_angle_n85_s19;
            atan_row_3 <= atan_rom_2[setup_light_polar_angle_atan_n100];
            setup_light_polar_angle_n104_s20 <= setup_light_polar_angle_n104_s19;
            setup_light_polar_angle_n107_s20 <= setup_light_polar_angle_n107_s19;
            setup_half_polar_angle_n175_s20 <= setup_half_polar_angle_n175_s19;
            atan_row_4 <= atan_rom_2[setup_half_polar_angle_atan_n190];
            setup_half_polar_angle_n194_s20 <= setup_half_polar_angle_n194_s19;
            setup_half_polar_angle_n197_s20 <= setup_half_polar_angle_n197_s19;
            dot_l_sincos_n210_s20 <= dot_l_sincos_n210_s19;
            dot_l_sincos_n215_s20 <= dot_l_sincos_n215_s19;
            dot_l_sincos_n216_s20 <= dot_l_sincos_n216_s19;
            dot_h_sincos_n226_s20 <= dot_h_sincos_n226_s19;
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // setup.light.polar_angle.atan
    wire [0:-18] setup_light_polar_angle_atan_n101 = atan_row_3[37:19]; // u19f18
    // setup.light.polar_angle
    wire signed [1:-18] setup_light_polar_angle_n102 = {1'b0, setup_light_azimuth_n69} - {1'b0, setup_light_polar_angle_atan_n101}; // s20f18
    wire signed [1:-18] setup_light_polar_angle_n103 = setup_light_polar_angle_n85_s20 ? setup_light_polar_angle_n102 : {1'b0, setup_light_polar_angle_atan_n101}; // s20f18
    // setup.half.polar_angle.atan
    wire [0:-18] setup_half_polar_angle_atan_n191 = atan_row_4[37:19]; // u19f18
    // setup.half.polar_angle
    wire signed [1:-18] setup_half_polar_angle_n192 = {1'b0, setup_light_azimuth_n69} - {1'b0, setup_half_polar_angle_atan_n191}; // s20f18
    wire signed [1:-18] setup_half_polar_angle_n193 = setup_half_polar_angle_n175_s20 ? setup_half_polar_angle_n192 : {1'b0, setup_half_polar_angle_atan_n191}; // s20f18

    reg signed [1:-18] setup_light_polar_angle_n103_s21; // s20f18
    reg setup_light_polar_angle_n104_s21; // u1f0
    reg setup_light_polar_angle_n107_s21; // u1f0
    reg signed [1:-18] setup_half_polar_angle_n193_s21; // s20f18
    reg setup_half_polar_angle_n194_s21; // u1f0
    reg setup_half_polar_angle_n197_s21; // u1f0
    reg signed [1:-18] dot_l_sincos_n210_s21; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s21; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s21; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s21; // s20f18
    always @(posedge clk)
        if (ce) begin
            setup_light_polar_angle_n103_s21 <= setup_light_polar_angle_n103;
            setup_light_polar_angle_n104_s21 <= setup_light_polar_angle_n104_s20;
            setup_light_polar_angle_n107_s21 <= setup_light_polar_angle_n107_s20;
            setup_half_polar_angle_n193_s21 <= setup_half_polar_angle_n193;
            setup_half_polar_angle_n194_s21 <= setup_half_polar_angle_n194_s20;
            setup_half_polar_angle_n197_s21 <= setup_half_polar_angle_n197_s20;
            dot_l_sincos_n210_s21 <= dot_l_sincos_n210_s20;
            dot_l_sincos_n215_s21 <= dot_l_sincos_n215_s20;
            dot_l_sincos_n216_s21 <= dot_l_sincos_n216_s20;
            dot_h_sincos_n226_s21 <= dot_h_sincos_n226_s20;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;

    // ---- stage 21 ----
    // setup.light.polar_angle
    wire signed [2:-18] setup_light_polar_angle_n105 = {2'h0, setup_light_azimuth_n73} - {setup_light_polar_angle_n103_s21[1], setup_light_polar_angle_n103_s21}; // s21f18
    wire signed [2:-18] setup_light_polar_angle_n106 = setup_light_polar_angle_n104_s21 ? setup_light_polar_angle_n105 : {setup_light_polar_angle_n103_s21[1], setup_light_polar_angle_n103_s21}; // s21f18
    wire signed [3:-18] setup_light_polar_angle_n108 = -{setup_light_polar_angle_n106[2], setup_light_polar_angle_n106}; // s22f18
    wire signed [3:-18] setup_light_polar_angle_n109 = setup_light_polar_angle_n107_s21 ? setup_light_polar_angle_n108 : {setup_light_polar_angle_n106[2], setup_light_polar_angle_n106}; // s22f18
    wire [-1:-18] setup_light_polar_angle_n110 = setup_light_polar_angle_n109[-1:-18]; // u18f18
    // setup.light
    wire [0:-18] setup_light_n113_sum = {1'b0, setup_light_polar_angle_n110} + 19'h2;
    wire [0:-16] setup_light_n113_cut = setup_light_n113_sum[0:-16];
    wire [0:-16] setup_light_n113 = setup_light_n113_cut; // u17f16
    wire [-1:-16] setup_light_theta = setup_light_n113[-1:-16]; // u16f16
    // setup.half.polar_angle
    wire signed [2:-18] setup_half_polar_angle_n195 = {2'h0, setup_light_azimuth_n73} - {setup_half_polar_angle_n193_s21[1], setup_half_polar_angle_n193_s21}; // s21f18
    wire signed [2:-18] setup_half_polar_angle_n196 = setup_half_polar_angle_n194_s21 ? setup_half_polar_angle_n195 : {setup_half_polar_angle_n193_s21[1], setup_half_polar_angle_n193_s21}; // s21f18
    wire signed [3:-18] setup_half_polar_angle_n198 = -{setup_half_polar_angle_n196[2], setup_half_polar_angle_n196}; // s22f18
    wire signed [3:-18] setup_half_polar_angle_n199 = setup_half_polar_angle_n197_s21 ? setup_half_polar_angle_n198 : {setup_half_polar_angle_n196[2], setup_half_polar_angle_n196}; // s22f18
    wire [-1:-18] setup_half_polar_angle_n200 = setup_half_polar_angle_n199[-1:-18]; // u18f18
    // setup.half
    wire [0:-18] setup_half_n203_sum = {1'b0, setup_half_polar_angle_n200} + 19'h2;
    wire [0:-16] setup_half_n203_cut = setup_half_n203_sum[0:-16];
    wire [0:-16] setup_half_n203 = setup_half_n203_cut; // u17f16
    wire [-1:-16] setup_half_theta = setup_half_n203[-1:-16]; // u16f16
    // dot_l.sincos
    wire [9:0] dot_l_sincos_n211 = setup_light_theta[-1:-10]; // u10f0
    // dot_h.sincos
    wire [9:0] dot_h_sincos_n227 = setup_half_theta[-1:-10]; // u10f0

    reg signed [1:-18] dot_l_sincos_n210_s22; // s20f18
    reg [9:0] dot_l_sincos_n211_s22; // u10f0
    reg signed [1:-18] dot_l_sincos_n215_s22; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s22; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s22; // s20f18
    reg [9:0] dot_h_sincos_n227_s22; // u10f0
    always @(posedge clk)
        if (ce) begin
            dot_l_sincos_n210_s22 <= dot_l_sincos_n210_s21;
            dot_l_sincos_n211_s22 <= dot_l_sincos_n211;
            dot_l_sincos_n215_s22 <= dot_l_sincos_n215_s21;
            dot_l_sincos_n216_s22 <= dot_l_sincos_n216_s21;
            dot_h_sincos_n226_s22 <= dot_h_sincos_n226_s21;
            dot_h_sincos_n227_s22 <= dot_h_sincos_n227;
        end
    reg valid_s22;
    always @(posedge clk)
        if (rst) valid_s22 <= 1'b0;
        else if (ce) valid_s22 <= valid_s21;

    // ---- stage 22 ----

    reg signed [1:-18] dot_l_sincos_n210_s23; // s20f18
    reg [39:0] sincos_row_10;
    reg signed [1:-18] dot_l_sincos_n215_s23; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s23; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s23; // s20f18
    reg [39:0] sincos_row_11;
    always @(posedge clk)
        if (ce) begin
            dot_l_sincos_n210_s23 <= dot_l_sincos_n210_s22;
            sincos_row_10 <= sincos_rom_5[dot_l_sincos_n211_s22];
            dot_l_sincos_n215_s23 <= dot_l_sincos_n215_s22;
            dot_l_sincos_n216_s23 <= dot_l_sincos_n216_s22;
            dot_h_sincos_n226_s23 <= dot_h_sincos_n226_s22;
            sincos_row_11 <= sincos_rom_6[dot_h_sincos_n227_s22];
        end
    reg valid_s23;
    always @(posedge clk)
        if (rst) valid_s23 <= 1'b0;
        else if (ce) valid_s23 <= valid_s22;

    // ---- stage 23 ----
    // dot_l.sincos
    wire signed [1:-18] dot_l_sincos_n212 = sincos_row_10[39:20]; // s20f18
    wire signed [1:-18] dot_l_sincos_n213 = sincos_row_10[19:0]; // s20f18
    // dot_h.sincos
    wire signed [1:-18] dot_h_sincos_n228 = sincos_row_11[39:20]; // s20f18
    wire signed [1:-18] dot_h_sincos_n229 = sincos_row_11[19:0]; // s20f18

    reg signed [1:-18] dot_l_sincos_n210_s24; // s20f18
    reg signed [1:-18] dot_l_sincos_n212_s24; // s20f18
    reg signed [1:-18] dot_l_sincos_n213_s24; // s20f18
    reg signed [1:-18] dot_l_sincos_n215_s24; // s20f18
    reg signed [1:-18] dot_l_sincos_n216_s24; // s20f18
    reg signed [1:-18] dot_h_sincos_n226_s24; // s20f18
    reg signed [1:-18] dot_h_sincos_n228_s24; // s20f18
    reg signed [1:-18] dot_h_sincos_n229_s24; // s20f18
    always @(posedge clk)
        if (ce) begin
            dot_l_sincos_n210_s24 <= dot_l_sincos_n210_s23;
            dot_l_sincos_n212_s24 <= dot_l_sincos_n212;
            dot_l_sincos_n213_s24 <= dot_l_sincos_n213;
            dot_l_sincos_n215_s24 <= dot_l_sincos_n215_s23;
            dot_l_sincos_n216_s24 <= dot_l_sincos_n216_s23;
            dot_h_sincos_n226_s24 <= dot_h_sincos_n226_s23;
            dot_h_sincos_n228_s24 <= dot_h_sincos_n228;
            dot_h_sincos_n229_s24 <= dot_h_sincos_n229;
        end
    reg valid_s24;
    always @(posedge clk)
        if (rst) valid_s24 <= 1'b0;
        else if (ce) valid_s24 <= valid_s23;

    // ---- stage 24 ----
    // dot_l
    wire signed [3:-36] dot_l_n217 = dot_l_sincos_n213_s24 * dot_l_sincos_n216_s24; // s40f36
    wire signed [3:-36] dot_l_n218 = dot_l_sincos_n212_s24 * dot_l_sincos_n215_s24; // s40f36
    // dot_h
    wire signed [3:-36] dot_h_n230 = dot_h_sincos_n229_s24 * dot_l_sincos_n216_s24; // s40f36
    wire signed [3:-36] dot_h_n231 = dot_h_sincos_n228_s24 * dot_l_sincos_n215_s24; // s40f36

    reg signed [1:-18] dot_l_sincos_n210_s25; // s20f18
    reg signed [3:-36] dot_l_n217_s25; // s40f36
    reg signed [3:-36] dot_l_n218_s25; // s40f36
    reg signed [1:-18] dot_h_sincos_n226_s25; // s20f18
    reg signed [3:-36] dot_h_n230_s25; // s40f36
    reg signed [3:-36] dot_h_n231_s25; // s40f36
    always @(posedge clk)
        if (ce) begin
            dot_l_sincos_n210_s25 <= dot_l_sincos_n210_s24;
            dot_l_n217_s25 <= dot_l_n217;
            dot_l_n218_s25 <= dot_l_n218;
            dot_h_sincos_n226_s25 <= dot_h_sincos_n226_s24;
            dot_h_n230_s25 <= dot_h_n230;
            dot_h_n231_s25 <= dot_h_n231;
        end
    reg valid_s25;
    always @(posedge clk)
        if (rst) valid_s25 <= 1'b0;
        else if (ce) valid_s25 <= valid_s24;

    // ---- stage 25 ----
    // dot_l
    wire signed [4:-36] dot_l_n219_sum = {dot_l_n218_s25[3], dot_l_n218_s25} + 41'h20000;
    wire signed [4:-18] dot_l_n219_cut = dot_l_n219_sum[4:-18];
    wire dot_l_n219_over = ~dot_l_n219_cut[4] & (|dot_l_n219_cut[3:2]);
    wire dot_l_n219_under = dot_l_n219_cut[4] & ~(&dot_l_n219_cut[3:2]);
    wire signed [2:-18] dot_l_n219 = dot_l_n219_over ? 21'hfffff : dot_l_n219_under ? 21'h100000 : dot_l_n219_cut[2:-18]; // s21f18
    // dot_h
    wire signed [4:-36] dot_h_n232_sum = {dot_h_n231_s25[3], dot_h_n231_s25} + 41'h20000;
    wire signed [4:-18] dot_h_n232_cut = dot_h_n232_sum[4:-18];
    wire dot_h_n232_over = ~dot_h_n232_cut[4] & (|dot_h_n232_cut[3:2]);
    wire dot_h_n232_under = dot_h_n232_cut[4] & ~(&dot_h_n232_cut[3:2]);
    wire signed [2:-18] dot_h_n232 = dot_h_n232_over ? 21'hfffff : dot_h_n232_under ? 21'h100000 : dot_h_n232_cut[2:-18]; // s21f18

    reg signed [1:-18] dot_l_sincos_n210_s26; // s20f18
    reg signed [3:-36] dot_l_n217_s26; // s40f36
    reg signed [2:-18] dot_l_n219_s26; // s21f18
    reg signed [1:-18] dot_h_sincos_n226_s26; // s20f18
    reg signed [3:-36] dot_h_n230_s26; // s40f36
    reg signed [2:-18] dot_h_n232_s26; // s21f18
    always @(posedge clk)
        if (ce) begin
            dot_l_sincos_n210_s26 <= dot_l_sincos_n210_s25;
            dot_l_n217_s26 <= dot_l_n217_s25;
            dot_l_n219_s26 <= dot_l_n219;
            dot_h_sincos_n226_s26 <= dot_h_sincos_n226_s25;
            dot_h_n230_s26 <= dot_h_n230_s25;
            dot_h_n232_s26 <= dot_h_n232;
        end
    reg valid_s26;
    always @(posedge clk)
        if (rst) valid_s26 <= 1'b0;
        else if (ce) valid_s26 <= valid_s25;

    // ---- stage 26 ----
    // dot_l
    wire signed [4:-36] dot_l_n220 = dot_l_n219_s26 * dot_l_sincos_n210_s26; // s41f36
    // dot_h
    wire signed [4:-36] dot_h_n233 = dot_h_n232_s26 * dot_h_sincos_n226_s26; // s41f36

    reg signed [3:-36] dot_l_n217_s27; // s40f36
    reg signed [4:-36] dot_l_n220_s27; // s41f36
    reg signed [3:-36] dot_h_n230_s27; // s40f36
    reg signed [4:-36] dot_h_n233_s27; // s41f36
    always @(posedge clk)
        if (ce) begin
            dot_l_n217_s27 <= dot_l_n217_s26;
            dot_l_n220_s27 <= dot_l_n220;
            dot_h_n230_s27 <= dot_h_n230_s26;
            dot_h_n233_s27 <= dot_h_n233;
        end
    reg valid_s27;
    always @(posedge clk)
        if (rst) valid_s27 <= 1'b0;
        else if (ce) valid_s27 <= valid_s26;

    // ---- stage 27 ----
    // dot_l
    wire signed [5:-36] dot_l_n221 = {{2{dot_l_n217_s27[3]}}, dot_l_n217_s27} + {dot_l_n220_s27[4], dot_l_n220_s27}; // s42f36
    // (unit)
    wire signed [6:-36] dot_l_sum = {dot_l_n221[5], dot_l_n221} + 43'h80000;
    wire signed [6:-16] dot_l_cut = dot_l_sum[6:-16];
    wire dot_l_over = ~dot_l_cut[6] & (|dot_l_cut[5:1]);
    wire dot_l_under = dot_l_cut[6] & ~(&dot_l_cut[5:1]);
    wire signed [1:-16] dot_l = dot_l_over ? 18'h1ffff : dot_l_under ? 18'h20000 : dot_l_cut[1:-16]; // s18f16
    // dot_h
    wire signed [5:-36] dot_h_n234 = {{2{dot_h_n230_s27[3]}}, dot_h_n230_s27} + {dot_h_n233_s27[4], dot_h_n233_s27}; // s42f36
    // (unit)
    wire signed [6:-36] dot_h_sum = {dot_h_n234[5], dot_h_n234} + 43'h80000;
    wire signed [6:-16] dot_h_cut = dot_h_sum[6:-16];
    wire dot_h_over = ~dot_h_cut[6] & (|dot_h_cut[5:1]);
    wire dot_h_under = dot_h_cut[6] & ~(&dot_h_cut[5:1]);
    wire signed [1:-16] dot_h = dot_h_over ? 18'h1ffff : dot_h_under ? 18'h20000 : dot_h_cut[1:-16]; // s18f16
    wire n237 = dot_l[1]; // u1f0
    wire signed [1:-16] n238 = n237 ? {1'b0, n236, 16'h0} : dot_l; // s18f16
    wire diffuse_index_under = n238[1];
    wire [0:-16] diffuse_index = diffuse_index_under ? 17'h0 : n238[0:-16]; // u17f16
    wire n240 = diffuse_index[0]; // u1f0
    wire [15:0] n241 = diffuse_index[-1:-16]; // u16f0
    wire [-1:-16] n242 = n241; // u16f16
    // diffuse
    wire [9:0] diffuse_n243 = n242[-1:-10]; // u10f0
    // (unit)
    wire n249 = dot_h[1]; // u1f0
    wire signed [1:-16] n250 = n249 ? {1'b0, n236, 16'h0} : dot_h; // s18f16
    wire specular_index_under = n250[1];
    wire [0:-16] specular_index = specular_index_under ? 17'h0 : n250[0:-16]; // u17f16
    wire n252 = specular_index[0]; // u1f0
    wire [15:0] n253 = specular_index[-1:-16]; // u16f0
    wire [-1:-16] n254 = n253; // u16f16
    // specular
    wire [9:0] specular_n255 = n254[-1:-10]; // u10f0

    reg n237_s28; // u1f0
    reg n240_s28; // u1f0
    reg [9:0] diffuse_n243_s28; // u10f0
    reg n249_s28; // u1f0
    reg n252_s28; // u1f0
    reg [9:0] specular_n255_s28; // u10f0
    always @(posedge clk)
        if (ce) begin
            n237_s28 <= n237;
            n240_s28 <= n240;
            diffuse_n243_s28 <= diffuse_n243;
            n249_s28 <= n249;
            n252_s28 <= n252;
            specular_n255_s28 <= specular_n255;
        end
    reg valid_s28;
    always @(posedge clk)
        if (rst) valid_s28 <= 1'b0;
        else if (ce) valid_s28 <= valid_s27;

    // ---- stage 28 ----

    reg n237_s29; // u1f0
    reg n240_s29; // u1f0
    reg [15:0] diffuse_row;
    reg n249_s29; // u1f0
    reg n252_s29; // u1f0
    reg [15:0] specular_row;
    always @(posedge clk)
        if (ce) begin
            n237_s29 <= n237_s28;
            n240_s29 <= n240_s28;
            diffuse_row <= diffuse_rom[diffuse_n243_s28];
            n249_s29 <= n249_s28;
            n252_s29 <= n252_s28;
            specular_row <= specular_rom[specular_n255_s28];
        end
    reg valid_s29;
    always @(posedge clk)
        if (rst) valid_s29 <= 1'b0;
        else if (ce) valid_s29 <= valid_s28;

    // ---- stage 29 ----
    // diffuse
    wire [-1:-16] diffuse_n244 = diffuse_row; // u16f16
    // (unit)
    wire [-1:-16] n247 = n240_s29 ? n245 : diffuse_n244; // u16f16
    wire [-1:-16] diffuse_next = n237_s29 ? n246 : n247; // u16f16
    // specular
    wire [-1:-16] specular_n256 = specular_row; // u16f16
    // (unit)
    wire [-1:-16] n259 = n252_s29 ? n257 : specular_n256; // u16f16
    wire [-1:-16] specular_next = n249_s29 ? n258 : n259; // u16f16
    wire [0:-16] n261 = {1'b0, diffuse_next} + {1'b0, specular_next}; // u17f16
    wire intensity_next_over = |n261[0];
    wire [-1:-16] intensity_next = intensity_next_over ? 16'hffff : n261[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            diffuse <= diffuse_next;
            specular <= specular_next;
            intensity <= intensity_next;
        end
    reg valid_s30;
    always @(posedge clk)
        if (rst) valid_s30 <= 1'b0;
        else if (ce) valid_s30 <= valid_s29;
    assign valid_out = valid_s30;

    // ---- stage 30 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        phi_l[-11:-16],
        theta_l[-11:-16],
        phi_h[-11:-16],
        theta_h[-11:-16],
        phi_n[-11:-16],
        theta_n[-11:-16],
        theta_p[-11:-16],
        setup_n205[0],
        setup_frame_t_x_sum[-19:-36],
        setup_frame_t_y_sum[-19:-36],
        setup_frame_n_x_sum[-19:-36],
        setup_frame_n_y_sum[-19:-36],
        setup_light_world_x_sum[-19:-36],
        setup_light_world_y_sum[-19:-36],
        setup_half_world_x_sum[-19:-36],
        setup_half_world_y_sum[-19:-36],
        setup_light_y_sum[-19:-36],
        setup_half_y_sum[-19:-36],
        setup_light_x_sum[-19:-36],
        setup_light_z_sum[-19:-36],
        setup_half_x_sum[-19:-36],
        setup_half_z_sum[-19:-36],
        setup_light_azimuth_n54_part2[0],
        setup_light_azimuth_n55[21:2],
        setup_light_azimuth_n56[19],
        setup_light_azimuth_n57[21:2],
        setup_light_azimuth_n60[-12:-20],
        setup_half_azimuth_n146_part2[0],
        setup_half_azimuth_n147[21:2],
        setup_half_azimuth_n148[19],
        setup_half_azimuth_n149[21:2],
        setup_half_azimuth_n152[-12:-20],
        setup_light_azimuth_ratio[-11:-18],
        setup_light_azimuth_ratio_sum[-19:-38],
        setup_half_azimuth_ratio[-11:-18],
        setup_half_azimuth_ratio_sum[-19:-38],
        setup_light_azimuth_n78[3:0],
        setup_light_n111[0],
        setup_light_n111_sum[-17:-18],
        setup_half_azimuth_n168[3:0],
        setup_half_n201[0],
        setup_half_n201_sum[-17:-18],
        setup_light_azimuth_n81_sum[-19:-36],
        setup_half_azimuth_n171_sum[-19:-36],
        dot_l_n207[0],
        dot_l_delta[-11:-16],
        dot_h_n223[0],
        dot_h_delta[-11:-16],
        sincos_row_8[39:20],
        sincos_row_9[39:20],
        setup_light_polar_angle_n88_part2[0],
        setup_half_polar_angle_n178_part2[0],
        setup_light_polar_angle_n89[21:2],
        setup_light_polar_angle_n90[19],
        setup_light_polar_angle_n91[21:2],
        setup_light_polar_angle_n94[-12:-20],
        setup_half_polar_angle_n179[21:2],
        setup_half_polar_angle_n180[19],
        setup_half_polar_angle_n181[21:2],
        setup_half_polar_angle_n184[-12:-20],
        setup_light_polar_angle_ratio[-11:-18],
        setup_light_polar_angle_ratio_sum[-19:-38],
        setup_half_polar_angle_ratio[-11:-18],
        setup_half_polar_angle_ratio_sum[-19:-38],
        atan_row_3[18:0],
        atan_row_4[18:0],
        setup_light_polar_angle_n109[3:0],
        setup_light_n113[0],
        setup_light_n113_sum[-17:-18],
        setup_light_theta[-11:-16],
        setup_half_polar_angle_n199[3:0],
        setup_half_n203[0],
        setup_half_n203_sum[-17:-18],
        setup_half_theta[-11:-16],
        dot_l_n219_sum[-19:-36],
        dot_h_n232_sum[-19:-36],
        dot_l_sum[-17:-36],
        dot_h_sum[-17:-36],
        n242[-11:-16],
        n254[-11:-16]};
endmodule
