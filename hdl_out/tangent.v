// tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
// made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
//   frame=smooth mirror=handed basis=orthonormal lights=1 position_int_bits=4
//   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
//   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
//   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
//   stages=auto rom=block
// latency 23 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 7.21e-6 rad, largest seen 2.54e-5 rad at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
//   t_dot: mean 1.01e-5, largest seen 3.06e-5 at p0_x=6054 p0_y=-8713 p0_z=-8201 p1_x=6085 p1_y=-8615 p1_z=-7909 p2_x=5792 p2_y=-8522 p2_z=-8101 uv0_u=4564 uv0_v=5160 uv1_u=2779 uv1_v=4462 uv2_u=3578 uv2_v=3905 normal_x=12043 normal_y=-10167 normal_z=4476 view_x=2660 view_y=-1823 view_z=-11081 light0_x=8046 light0_y=-6155 light0_z=-4370
//   t_x: mean 5.06e-6, largest seen 2.58e-5 (1.7 ulp) at p0_x=-2944 p0_y=-2889 p0_z=-15380 p1_x=-1989 p1_y=-3042 p1_z=-15024 p2_x=35 p2_y=-907 p2_z=-15910 uv0_u=7874 uv0_v=-4729 uv1_u=7659 uv1_v=-5304 uv2_u=7814 uv2_v=-4572 normal_x=-5414 normal_y=14396 normal_z=-5646 view_x=-6397 view_y=-7256 view_z=184 light0_x=9737 light0_y=-6526 light0_z=-23310
//   t_y: mean 5.08e-6, largest seen 2.63e-5 (1.7 ulp) at p0_x=-5717 p0_y=-7520 p0_z=6199 p1_x=-6348 p1_y=-7947 p1_z=6354 p2_x=-5905 p2_y=-7260 p2_z=6487 uv0_u=-5576 uv0_v=-14859 uv1_u=-5475 uv1_v=-15100 uv2_u=-5440 uv2_v=-15020 normal_x=10034 normal_y=-493 normal_z=12942 view_x=13000 view_y=-2147 view_z=4664 light0_x=2385 light0_y=2146 light0_z=-3481
//   t_z: mean 5.08e-6, largest seen 2.65e-5 (1.7 ulp) at p0_x=11563 p0_y=11423 p0_z=-13723 p1_x=11421 p1_y=11299 p1_z=-13637 p2_x=11555 p2_y=11375 p2_z=-13787 uv0_u=-8499 uv0_v=13103 uv1_u=-7478 uv1_v=7491 uv2_u=-5140 uv2_v=11461 normal_x=-15164 normal_y=-4331 normal_z=-4443 view_x=-8107 view_y=1299 view_z=-3290 light0_x=-3604 light0_y=-1965 light0_z=440
//   b_angle: mean 6.61e-6 rad, largest seen 2.02e-5 rad at p0_x=21760 p0_y=-8046 p0_z=-19764 p1_x=14314 p1_y=-6846 p1_z=-24032 p2_x=12189 p2_y=-1901 p2_z=-15526 uv0_u=-22738 uv0_v=-3849 uv1_u=-23752 uv1_v=1069 uv2_u=-9213 uv2_v=2636 normal_x=-12722 normal_y=-9837 normal_z=-3133 view_x=9645 view_y=-6931 view_z=4827 light0_x=9603 light0_y=-8865 light0_z=-8833
//   b_dot: mean 8.71e-6, largest seen 2.37e-5 at p0_x=5680 p0_y=11679 p0_z=-9279 p1_x=5746 p1_y=11714 p1_z=-9304 p2_x=5771 p2_y=11695 p2_z=-9339 uv0_u=10373 uv0_v=-9936 uv1_u=10462 uv1_v=-9889 uv2_u=10455 uv2_v=-9822 normal_x=-13791 normal_y=8267 normal_z=-3145 view_x=4674 view_y=15361 view_z=-4755 light0_x=19009 light0_y=22102 light0_z=-24134
//   b_x: mean 4.44e-6, largest seen 1.88e-5 (1.2 ulp) at p0_x=-1736 p0_y=11116 p0_z=-16007 p1_x=-158 p1_y=11485 p1_z=-16948 p2_x=-1615 p2_y=13286 p2_z=-16701 uv0_u=1006 uv0_v=13794 uv1_u=1018 uv1_v=13841 uv2_u=1173 uv2_v=13774 normal_x=2071 normal_y=16139 normal_z=1917 view_x=1686 view_y=4755 view_z=-5926 light0_x=-2682 light0_y=5065 light0_z=3979
//   b_y: mean 4.43e-6, largest seen 2.10e-5 (1.4 ulp) at p0_x=16361 p0_y=11747 p0_z=-5803 p1_x=17315 p1_y=13651 p1_z=-4641 p2_x=13325 p2_y=13955 p2_z=-4680 uv0_u=-5823 uv0_v=-9319 uv1_u=-5674 uv1_v=-9605 uv2_u=-5470 uv2_v=-9514 normal_x=-222 normal_y=-9338 normal_z=-13460 view_x=16239 view_y=-23962 view_z=-7113 light0_x=-1942 light0_y=2415 light0_z=-9419
//   b_z: mean 4.44e-6, largest seen 1.95e-5 (1.3 ulp) at p0_x=-11834 p0_y=478 p0_z=2468 p1_x=-12147 p1_y=607 p1_z=2446 p2_x=-11996 p2_y=633 p2_z=2585 uv0_u=14968 uv0_v=4654 uv1_u=15202 uv1_v=4821 uv2_u=14888 uv2_v=4438 normal_x=6949 normal_y=-14815 normal_z=819 view_x=1968 view_y=-7156 view_z=-750 light0_x=-14564 light0_y=-2007 light0_z=1544
//   n_angle: mean 0.00e0 rad, largest seen 0.00e0 rad at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_dot: mean 0.00e0, largest seen 0.00e0 at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_x: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_y: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   n_z: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   ts_view_angle: mean 4.65e-5 rad, largest seen 1.84e-3 rad at p0_x=-9855 p0_y=-11563 p0_z=4028 p1_x=-14143 p1_y=-4409 p1_z=482 p2_x=-8004 p2_y=7008 p2_z=-4249 uv0_u=-4218 uv0_v=9266 uv1_u=-4223 uv1_v=9363 uv2_u=-4208 uv2_v=9267 normal_x=-15042 normal_y=-4819 normal_z=-4353 view_x=72 view_y=-168 view_z=98 light0_x=2154 light0_y=-1130 light0_z=-105
//   ts_view_dot: mean 3.01e-5, largest seen 9.03e-5 at p0_x=6141 p0_y=-13767 p0_z=-7992 p1_x=6118 p1_y=-13719 p1_z=-7838 p2_x=6123 p2_y=-13790 p2_z=-7826 uv0_u=7545 uv0_v=-11434 uv1_u=7546 uv1_v=-10295 uv2_u=6797 uv2_v=-11328 normal_x=-403 normal_y=-14238 normal_z=8096 view_x=16190 view_y=26021 view_z=27329 light0_x=-4445 light0_y=5173 light0_z=5980
//   ts_view_x: mean 1.58e-5, largest seen 7.72e-5 (1.3 ulp) at p0_x=-9548 p0_y=7900 p0_z=-11270 p1_x=-9660 p1_y=7935 p1_z=-11194 p2_x=-9357 p2_y=7961 p2_z=-11076 uv0_u=-11107 uv0_v=12419 uv1_u=-11523 uv1_v=11905 uv2_u=-10978 uv2_v=12656 normal_x=-5642 normal_y=12921 normal_z=-8346 view_x=23883 view_y=22119 view_z=16603 light0_x=6062 light0_y=11713 light0_z=2836
//   ts_view_y: mean 1.57e-5, largest seen 6.24e-5 (1.0 ulp) at p0_x=15652 p0_y=10540 p0_z=7166 p1_x=15633 p1_y=10607 p1_z=7228 p2_x=15553 p2_y=10667 p2_z=7290 uv0_u=-1788 uv0_v=-6270 uv1_u=-322 uv1_v=-6844 uv2_u=-1575 uv2_v=-7200 normal_x=-1833 normal_y=16240 normal_z=1159 view_x=-29460 view_y=31001 view_z=3770 light0_x=6127 light0_y=-7450 light0_z=7013
//   ts_view_z: mean 1.52e-5, largest seen 3.05e-5 (0.5 ulp) at p0_x=-302 p0_y=1691 p0_z=-6673 p1_x=-221 p1_y=1773 p1_z=-6705 p2_x=-254 p2_y=1753 p2_z=-6603 uv0_u=7868 uv0_v=821 uv1_u=8711 uv1_v=2841 uv2_u=6860 uv2_v=2720 normal_x=-10163 normal_y=-7193 normal_z=10649 view_x=4532 view_y=-9269 view_z=10375 light0_x=-2930 light0_y=-241 light0_z=2769
//   ts_light0_angle: mean 4.66e-5 rad, largest seen 2.30e-3 rad at p0_x=1272 p0_y=-15486 p0_z=-8368 p1_x=1233 p1_y=-15508 p1_z=-8439 p2_x=1008 p2_y=-15725 p2_z=-7973 uv0_u=-15400 uv0_v=3547 uv1_u=-15342 uv1_v=3546 uv2_u=-15427 uv2_v=3464 normal_x=-13112 normal_y=6323 normal_z=-7519 view_x=12551 view_y=19257 view_z=19235 light0_x=171 light0_y=29 light0_z=72
//   ts_light0_dot: mean 3.01e-5, largest seen 8.52e-5 at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
//   ts_light0_x: mean 1.58e-5, largest seen 7.53e-5 (1.2 ulp) at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
//   ts_light0_y: mean 1.57e-5, largest seen 6.57e-5 (1.1 ulp) at p0_x=15543 p0_y=13758 p0_z=-4075 p1_x=14753 p1_y=14130 p1_z=-3927 p2_x=15086 p2_y=13483 p2_z=-3280 uv0_u=-1025 uv0_v=12037 uv1_u=1063 uv1_v=12449 uv2_u=-1376 uv2_v=6924 normal_x=-3845 normal_y=-15786 normal_z=2110 view_x=-2307 view_y=-1803 view_z=2775 light0_x=-13005 light0_y=25943 light0_z=-29219
//   ts_light0_z: mean 1.52e-5, largest seen 3.05e-5 (0.5 ulp) at p0_x=12149 p0_y=11346 p0_z=-31 p1_x=12282 p1_y=11313 p1_z=-4 p2_x=12253 p2_y=11302 p2_z=-166 uv0_u=-16266 uv0_v=8823 uv1_u=-11398 uv1_v=9264 uv2_u=-14519 uv2_v=5465 normal_x=-2913 normal_y=-16026 normal_z=1769 view_x=-3200 view_y=-5150 view_z=-2933 light0_x=3519 light0_y=12209 light0_z=-5007
//   mirrored: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_uv: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_area: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   parallel: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
// stated bound on each tangent: 2.12e-4
// stated bound on each binormal: 5.74e-5
// stated bound on each normal: 0.00e0
// stated bound on each view: 8.14e-4
// stated bound on each light0: 8.14e-4
// stated bound on each flags: 0.00e0
module tangent (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [4:-11] p0_x, // s16f11
    input  wire signed [4:-11] p0_y, // s16f11
    input  wire signed [4:-11] p0_z, // s16f11
    input  wire signed [4:-11] p1_x, // s16f11
    input  wire signed [4:-11] p1_y, // s16f11
    input  wire signed [4:-11] p1_z, // s16f11
    input  wire signed [4:-11] p2_x, // s16f11
    input  wire signed [4:-11] p2_y, // s16f11
    input  wire signed [4:-11] p2_z, // s16f11
    input  wire signed [2:-13] uv0_u, // s16f13
    input  wire signed [2:-13] uv0_v, // s16f13
    input  wire signed [2:-13] uv1_u, // s16f13
    input  wire signed [2:-13] uv1_v, // s16f13
    input  wire signed [2:-13] uv2_u, // s16f13
    input  wire signed [2:-13] uv2_v, // s16f13
    input  wire signed [1:-14] normal_x, // s16f14
    input  wire signed [1:-14] normal_y, // s16f14
    input  wire signed [1:-14] normal_z, // s16f14
    input  wire signed [1:-14] view_x, // s16f14
    input  wire signed [1:-14] view_y, // s16f14
    input  wire signed [1:-14] view_z, // s16f14
    input  wire signed [1:-14] light0_x, // s16f14
    input  wire signed [1:-14] light0_y, // s16f14
    input  wire signed [1:-14] light0_z, // s16f14
    output wire valid_out,
    output reg  signed [2:-16] t_x, // s19f16
    output reg  signed [2:-16] t_y, // s19f16
    output reg  signed [2:-16] t_z, // s19f16
    output reg  signed [1:-16] b_x, // s18f16
    output reg  signed [1:-16] b_y, // s18f16
    output reg  signed [1:-16] b_z, // s18f16
    output reg  signed [1:-14] n_x, // s16f14
    output reg  signed [1:-14] n_y, // s16f14
    output reg  signed [1:-14] n_z, // s16f14
    output reg  signed [4:-14] ts_view_x, // s19f14
    output reg  signed [4:-14] ts_view_y, // s19f14
    output reg  signed [4:-14] ts_view_z, // s19f14
    output reg  signed [4:-14] ts_light0_x, // s19f14
    output reg  signed [4:-14] ts_light0_y, // s19f14
    output reg  signed [4:-14] ts_light0_z, // s19f14
    output reg  mirrored, // u1f0
    output reg  degenerate, // u1f0
    output reg  zero_uv, // u1f0
    output reg  zero_area, // u1f0
    output reg  parallel // u1f0
);

    // table recip_root: recip_sqrt_base u23f22, recip_sqrt_slope s17f34
    (* rom_style = "block" *)
    reg [39:0] recip_root_rom [0:255];
    initial begin
        recip_root_rom[0] = 40'hffff4502f6; recip_root_rom[1] = 40'hfe053908bc; recip_root_rom[2] = 40'hfc16b70e4a; recip_root_rom[3] = 40'hfa335113a5;
        recip_root_rom[4] = 40'hf85aa118cd; recip_root_rom[5] = 40'hf68c411dc6; recip_root_rom[6] = 40'hf4c7d12291; recip_root_rom[7] = 40'hf30cf92733;
        recip_root_rom[8] = 40'hf15b632bab; recip_root_rom[9] = 40'hefb2bd2ffd; recip_root_rom[10] = 40'hee12bb3429; recip_root_rom[11] = 40'hec7b133833;
        recip_root_rom[12] = 40'heaeb7b3c1a; recip_root_rom[13] = 40'he963b33fe2; recip_root_rom[14] = 40'he7e37b438b; recip_root_rom[15] = 40'he66a934716;
        recip_root_rom[16] = 40'he4f8c34a85; recip_root_rom[17] = 40'he38dd14dda; recip_root_rom[18] = 40'he229875115; recip_root_rom[19] = 40'he0cbb35437;
        recip_root_rom[20] = 40'hdf74235741; recip_root_rom[21] = 40'hde22a95a35; recip_root_rom[22] = 40'hdcd7155d13; recip_root_rom[23] = 40'hdb913b5fdc;
        recip_root_rom[24] = 40'hda50f76290; recip_root_rom[25] = 40'hd916196532; recip_root_rom[26] = 40'hd7e07f67c1; recip_root_rom[27] = 40'hd6b0036a3e;
        recip_root_rom[28] = 40'hd584836caa; recip_root_rom[29] = 40'hd45dd96f06; recip_root_rom[30] = 40'hd33be77151; recip_root_rom[31] = 40'hd21e8b738e;
        recip_root_rom[32] = 40'hd105a775bb; recip_root_rom[33] = 40'hcff11f77da; recip_root_rom[34] = 40'hcee0d579ec; recip_root_rom[35] = 40'hcdd4af7bf0;
        recip_root_rom[36] = 40'hcccc8f7de7; recip_root_rom[37] = 40'hcbc85f7fd2; recip_root_rom[38] = 40'hcac80581b1; recip_root_rom[39] = 40'hc9cb698385;
        recip_root_rom[40] = 40'hc8d273854d; recip_root_rom[41] = 40'hc7dd0f870b; recip_root_rom[42] = 40'hc6eb2588be; recip_root_rom[43] = 40'hc5fca18a67;
        recip_root_rom[44] = 40'hc511718c06; recip_root_rom[45] = 40'hc4297d8d9c; recip_root_rom[46] = 40'hc344b78f28; recip_root_rom[47] = 40'hc2630990ac;
        recip_root_rom[48] = 40'hc184619227; recip_root_rom[49] = 40'hc0a8b1939a; recip_root_rom[50] = 40'hbfcfe79505; recip_root_rom[51] = 40'hbef9f19668;
        recip_root_rom[52] = 40'hbe26c197c3; recip_root_rom[53] = 40'hbd56499917; recip_root_rom[54] = 40'hbc88779a64; recip_root_rom[55] = 40'hbbbd3f9baa;
        recip_root_rom[56] = 40'hbaf4939ce9; recip_root_rom[57] = 40'hba2e679e21; recip_root_rom[58] = 40'hb96aa99f53; recip_root_rom[59] = 40'hb8a951a07f;
        recip_root_rom[60] = 40'hb7ea51a1a5; recip_root_rom[61] = 40'hb72d9ba2c6; recip_root_rom[62] = 40'hb67327a3e0; recip_root_rom[63] = 40'hb5bae9a4f5;
        recip_root_rom[64] = 40'hb504d3a604; recip_root_rom[65] = 40'hb450dba70f; recip_root_rom[66] = 40'hb39efba814; recip_root_rom[67] = 40'hb2ef23a914;
        recip_root_rom[68] = 40'hb2414baa10; recip_root_rom[69] = 40'hb1956bab06; recip_root_rom[70] = 40'hb0eb79abf9; recip_root_rom[71] = 40'hb0436bace6;
        recip_root_rom[72] = 40'haf9d37add0; recip_root_rom[73] = 40'haef8d7aeb5; recip_root_rom[74] = 40'hae5641af96; recip_root_rom[75] = 40'hadb56db073;
        recip_root_rom[76] = 40'had1653b14c; recip_root_rom[77] = 40'hac78ebb221; recip_root_rom[78] = 40'habdd2db2f2; recip_root_rom[79] = 40'hab4313b3c0;
        recip_root_rom[80] = 40'haaaa93b48a; recip_root_rom[81] = 40'haa13a9b551; recip_root_rom[82] = 40'ha97e4bb615; recip_root_rom[83] = 40'ha8ea75b6d5;
        recip_root_rom[84] = 40'ha8581fb792; recip_root_rom[85] = 40'ha7c743b84b; recip_root_rom[86] = 40'ha737dbb902; recip_root_rom[87] = 40'ha6a9dfb9b6;
        recip_root_rom[88] = 40'ha61d4bba66; recip_root_rom[89] = 40'ha59219bb14; recip_root_rom[90] = 40'ha50841bbbf; recip_root_rom[91] = 40'ha47fbfbc68;
        recip_root_rom[92] = 40'ha3f88fbd0d; recip_root_rom[93] = 40'ha372a9bdb0; recip_root_rom[94] = 40'ha2ee09be51; recip_root_rom[95] = 40'ha26aadbeee;
        recip_root_rom[96] = 40'ha1e889bf8a; recip_root_rom[97] = 40'ha1679dc023; recip_root_rom[98] = 40'ha0e7e3c0ba; recip_root_rom[99] = 40'ha06957c14e;
        recip_root_rom[100] = 40'h9febf3c1e0; recip_root_rom[101] = 40'h9f6fb3c270; recip_root_rom[102] = 40'h9ef493c2fe; recip_root_rom[103] = 40'h9e7a8fc389;
        recip_root_rom[104] = 40'h9e01a3c413; recip_root_rom[105] = 40'h9d89c9c49b; recip_root_rom[106] = 40'h9d12ffc520; recip_root_rom[107] = 40'h9c9d3fc5a4;
        recip_root_rom[108] = 40'h9c2887c626; recip_root_rom[109] = 40'h9bb4d3c6a5; recip_root_rom[110] = 40'h9b421dc723; recip_root_rom[111] = 40'h9ad063c7a0;
        recip_root_rom[112] = 40'h9a5fa3c81a; recip_root_rom[113] = 40'h99efd9c893; recip_root_rom[114] = 40'h9980ffc90a; recip_root_rom[115] = 40'h991313c97f;
        recip_root_rom[116] = 40'h98a611c9f3; recip_root_rom[117] = 40'h9839f9ca65; recip_root_rom[118] = 40'h97cec3cad6; recip_root_rom[119] = 40'h97646fcb45;
        recip_root_rom[120] = 40'h96faf9cbb3; recip_root_rom[121] = 40'h96925fcc1f; recip_root_rom[122] = 40'h962a9dcc8a; recip_root_rom[123] = 40'h95c3b1ccf3;
        recip_root_rom[124] = 40'h955d95cd5b; recip_root_rom[125] = 40'h94f84bcdc1; recip_root_rom[126] = 40'h9493cfce26; recip_root_rom[127] = 40'h94301bce8a;
        recip_root_rom[128] = 40'h93cd2fceed; recip_root_rom[129] = 40'h936b09cf4e; recip_root_rom[130] = 40'h9309a5cfae; recip_root_rom[131] = 40'h92a901d00d;
        recip_root_rom[132] = 40'h92491bd06a; recip_root_rom[133] = 40'h91e9efd0c7; recip_root_rom[134] = 40'h918b7dd122; recip_root_rom[135] = 40'h912dc1d17c;
        recip_root_rom[136] = 40'h90d0b9d1d5; recip_root_rom[137] = 40'h907463d22d; recip_root_rom[138] = 40'h9018bdd284; recip_root_rom[139] = 40'h8fbdc5d2d9;
        recip_root_rom[140] = 40'h8f6377d32e; recip_root_rom[141] = 40'h8f09d3d382; recip_root_rom[142] = 40'h8eb0d7d3d4; recip_root_rom[143] = 40'h8e587fd426;
        recip_root_rom[144] = 40'h8e00cbd477; recip_root_rom[145] = 40'h8da9bbd4c6; recip_root_rom[146] = 40'h8d5347d515; recip_root_rom[147] = 40'h8cfd71d563;
        recip_root_rom[148] = 40'h8ca837d5b0; recip_root_rom[149] = 40'h8c5397d5fc; recip_root_rom[150] = 40'h8bff8fd647; recip_root_rom[151] = 40'h8bac1dd691;
        recip_root_rom[152] = 40'h8b593fd6db; recip_root_rom[153] = 40'h8b06f5d723; recip_root_rom[154] = 40'h8ab53bd76b; recip_root_rom[155] = 40'h8a6411d7b2;
        recip_root_rom[156] = 40'h8a1375d7f8; recip_root_rom[157] = 40'h89c367d83d; recip_root_rom[158] = 40'h8973e1d882; recip_root_rom[159] = 40'h8924e5d8c6;
        recip_root_rom[160] = 40'h88d66fd909; recip_root_rom[161] = 40'h888881d94b; recip_root_rom[162] = 40'h883b17d98d; recip_root_rom[163] = 40'h87ee31d9cd;
        recip_root_rom[164] = 40'h87a1cbda0d; recip_root_rom[165] = 40'h8755e7da4d; recip_root_rom[166] = 40'h870a7fda8c; recip_root_rom[167] = 40'h86bf97daca;
        recip_root_rom[168] = 40'h86752bdb07; recip_root_rom[169] = 40'h862b39db44; recip_root_rom[170] = 40'h85e1c1db80; recip_root_rom[171] = 40'h8598c1dbbb;
        recip_root_rom[172] = 40'h855037dbf6; recip_root_rom[173] = 40'h850825dc30; recip_root_rom[174] = 40'h84c085dc6a; recip_root_rom[175] = 40'h847959dca3;
        recip_root_rom[176] = 40'h84329fdcdb; recip_root_rom[177] = 40'h83ec57dd13; recip_root_rom[178] = 40'h83a67ddd4a; recip_root_rom[179] = 40'h836111dd81;
        recip_root_rom[180] = 40'h831c15ddb7; recip_root_rom[181] = 40'h82d783dded; recip_root_rom[182] = 40'h82935dde22; recip_root_rom[183] = 40'h824fa1de56;
        recip_root_rom[184] = 40'h820c4dde8a; recip_root_rom[185] = 40'h81c961debe; recip_root_rom[186] = 40'h8186dddef1; recip_root_rom[187] = 40'h8144bfdf23;
        recip_root_rom[188] = 40'h810305df55; recip_root_rom[189] = 40'h80c1afdf86; recip_root_rom[190] = 40'h8080bddfb7; recip_root_rom[191] = 40'h80402bdfe8;
        recip_root_rom[192] = 40'h7ffffbe018; recip_root_rom[193] = 40'h7fc02be047; recip_root_rom[194] = 40'h7f80b9e077; recip_root_rom[195] = 40'h7f41a7e0a5;
        recip_root_rom[196] = 40'h7f02f1e0d3; recip_root_rom[197] = 40'h7ec499e101; recip_root_rom[198] = 40'h7e869be12e; recip_root_rom[199] = 40'h7e48f7e15b;
        recip_root_rom[200] = 40'h7e0bade188; recip_root_rom[201] = 40'h7dcebde1b4; recip_root_rom[202] = 40'h7d9225e1df; recip_root_rom[203] = 40'h7d55e3e20b;
        recip_root_rom[204] = 40'h7d19f9e235; recip_root_rom[205] = 40'h7cde63e260; recip_root_rom[206] = 40'h7ca323e28a; recip_root_rom[207] = 40'h7c6837e2b3;
        recip_root_rom[208] = 40'h7c2d9de2dd; recip_root_rom[209] = 40'h7bf357e306; recip_root_rom[210] = 40'h7bb961e32e; recip_root_rom[211] = 40'h7b7fbde356;
        recip_root_rom[212] = 40'h7b4669e37e; recip_root_rom[213] = 40'h7b0d67e3a5; recip_root_rom[214] = 40'h7ad4b1e3cc; recip_root_rom[215] = 40'h7a9c49e3f3;
        recip_root_rom[216] = 40'h7a6431e419; recip_root_rom[217] = 40'h7a2c63e440; recip_root_rom[218] = 40'h79f4e1e465; recip_root_rom[219] = 40'h79bdabe48b;
        recip_root_rom[220] = 40'h7986c1e4b0; recip_root_rom[221] = 40'h795021e4d4; recip_root_rom[222] = 40'h7919c9e4f9; recip_root_rom[223] = 40'h78e3bbe51d;
        recip_root_rom[224] = 40'h78adf3e541; recip_root_rom[225] = 40'h787875e564; recip_root_rom[226] = 40'h78433de587; recip_root_rom[227] = 40'h780e4be5aa;
        recip_root_rom[228] = 40'h77d99fe5cc; recip_root_rom[229] = 40'h77a537e5ef; recip_root_rom[230] = 40'h777115e611; recip_root_rom[231] = 40'h773d37e632;
        recip_root_rom[232] = 40'h77099be654; recip_root_rom[233] = 40'h76d643e675; recip_root_rom[234] = 40'h76a32de696; recip_root_rom[235] = 40'h767059e6b6;
        recip_root_rom[236] = 40'h763dc5e6d7; recip_root_rom[237] = 40'h760b73e6f7; recip_root_rom[238] = 40'h75d95fe716; recip_root_rom[239] = 40'h75a78be736;
        recip_root_rom[240] = 40'h7575f7e755; recip_root_rom[241] = 40'h7544a1e774; recip_root_rom[242] = 40'h751389e793; recip_root_rom[243] = 40'h74e2afe7b1;
        recip_root_rom[244] = 40'h74b213e7cf; recip_root_rom[245] = 40'h7481b1e7ed; recip_root_rom[246] = 40'h74518de80b; recip_root_rom[247] = 40'h7421a3e829;
        recip_root_rom[248] = 40'h73f1f3e846; recip_root_rom[249] = 40'h73c27fe863; recip_root_rom[250] = 40'h739345e880; recip_root_rom[251] = 40'h736447e89c;
        recip_root_rom[252] = 40'h73357fe8b9; recip_root_rom[253] = 40'h7306f1e8d5; recip_root_rom[254] = 40'h72d899e8f1; recip_root_rom[255] = 40'h72aa7be90d;
    end

    // ---- stage 0 ----
    // primitive
    wire signed [5:-11] primitive_e1_x = {p1_x[4], p1_x} - {p0_x[4], p0_x}; // s17f11
    wire signed [5:-11] primitive_e1_y = {p1_y[4], p1_y} - {p0_y[4], p0_y}; // s17f11
    wire signed [5:-11] primitive_e1_z = {p1_z[4], p1_z} - {p0_z[4], p0_z}; // s17f11
    wire signed [5:-11] primitive_e2_x = {p2_x[4], p2_x} - {p0_x[4], p0_x}; // s17f11
    wire signed [5:-11] primitive_e2_y = {p2_y[4], p2_y} - {p0_y[4], p0_y}; // s17f11
    wire signed [5:-11] primitive_e2_z = {p2_z[4], p2_z} - {p0_z[4], p0_z}; // s17f11
    wire signed [3:-13] primitive_du1 = {uv1_u[2], uv1_u} - {uv0_u[2], uv0_u}; // s17f13
    wire signed [3:-13] primitive_dv1 = {uv1_v[2], uv1_v} - {uv0_v[2], uv0_v}; // s17f13
    wire signed [3:-13] primitive_du2 = {uv2_u[2], uv2_u} - {uv0_u[2], uv0_u}; // s17f13
    wire signed [3:-13] primitive_dv2 = {uv2_v[2], uv2_v} - {uv0_v[2], uv0_v}; // s17f13
    wire signed [7:-26] primitive_n34 = primitive_du1 * primitive_dv2; // s34f26
    wire signed [7:-26] primitive_n35 = primitive_du2 * primitive_dv1; // s34f26
    wire primitive_n37 = 1'b0; // u1f0
    wire signed [9:-24] primitive_n40 = primitive_dv2 * primitive_e1_x; // s34f24
    wire signed [9:-24] primitive_n41 = primitive_dv1 * primitive_e2_x; // s34f24
    wire signed [9:-24] primitive_n43 = primitive_dv2 * primitive_e1_y; // s34f24
    wire signed [9:-24] primitive_n44 = primitive_dv1 * primitive_e2_y; // s34f24
    wire signed [9:-24] primitive_n46 = primitive_dv2 * primitive_e1_z; // s34f24
    wire signed [9:-24] primitive_n47 = primitive_dv1 * primitive_e2_z; // s34f24
    // primitive.e1_cross_e2
    wire signed [11:-22] primitive_e1_cross_e2_n49 = primitive_e1_y * primitive_e2_z; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n50 = primitive_e1_z * primitive_e2_y; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n52 = primitive_e1_z * primitive_e2_x; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n53 = primitive_e1_x * primitive_e2_z; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n55 = primitive_e1_x * primitive_e2_y; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n56 = primitive_e1_y * primitive_e2_x; // s34f22
    // vertex
    wire [1:-14] vertex_n63_neg = -normal_x;
    wire [1:-14] vertex_n63 = normal_x[1] ? vertex_n63_neg : normal_x; // u16f14
    wire [1:-14] vertex_n64_neg = -normal_y;
    wire [1:-14] vertex_n64 = normal_y[1] ? vertex_n64_neg : normal_y; // u16f14
    wire vertex_along_x = vertex_n64 < vertex_n63; // u1f0
    wire signed [1:-14] vertex_n66 = 16'h0; // s16f14
    wire signed [2:-14] vertex_n67 = -{normal_y[1], normal_y}; // s17f14
    wire signed [2:-14] vertex_n68 = -{normal_z[1], normal_z}; // s17f14
    wire signed [2:-14] vertex_n69 = vertex_along_x ? vertex_n68 : {vertex_n66[1], vertex_n66}; // s17f14
    wire signed [1:-14] vertex_n70 = vertex_along_x ? vertex_n66 : normal_z; // s16f14
    wire signed [2:-14] vertex_n71 = vertex_along_x ? {normal_x[1], normal_x} : vertex_n67; // s17f14
    wire signed [-22:-38] vertex_n88 = vertex_n69; // s17f38
    wire signed [-23:-38] vertex_n90 = vertex_n70; // s16f38
    wire signed [-22:-38] vertex_n92 = vertex_n71; // s17f38
    // vertex.b
    wire [31:0] vertex_b_n107 = 32'h0; // u32f0
    wire [15:0] vertex_b_n113 = 16'h0; // u16f0
    wire [7:0] vertex_b_n119 = 8'h0; // u8f0
    wire [3:0] vertex_b_n125 = 4'h0; // u4f0
    wire [1:0] vertex_b_n131 = 2'h0; // u2f0
    // vertex.b_length
    wire vertex_b_length_n251 = 1'b1; // u1f0
    wire vertex_b_length_n266 = 1'b1; // u1e2
    // vertex.ts_view_n
    wire signed [3:-28] vertex_ts_view_n_n311 = normal_x * view_x; // s32f28
    wire signed [3:-28] vertex_ts_view_n_n312 = normal_y * view_y; // s32f28
    wire signed [3:-28] vertex_ts_view_n_n313 = normal_z * view_z; // s32f28
    // vertex.ts_light0_n
    wire signed [3:-28] vertex_ts_light0_n_n329 = normal_x * light0_x; // s32f28
    wire signed [3:-28] vertex_ts_light0_n_n330 = normal_y * light0_y; // s32f28
    wire signed [3:-28] vertex_ts_light0_n_n331 = normal_z * light0_z; // s32f28

    reg signed [1:-14] normal_x_s1; // s16f14
    reg signed [1:-14] normal_y_s1; // s16f14
    reg signed [1:-14] normal_z_s1; // s16f14
    reg signed [1:-14] view_x_s1; // s16f14
    reg signed [1:-14] view_y_s1; // s16f14
    reg signed [1:-14] view_z_s1; // s16f14
    reg signed [1:-14] light0_x_s1; // s16f14
    reg signed [1:-14] light0_y_s1; // s16f14
    reg signed [1:-14] light0_z_s1; // s16f14
    reg signed [7:-26] primitive_n34_s1; // s34f26
    reg signed [7:-26] primitive_n35_s1; // s34f26
    reg signed [9:-24] primitive_n40_s1; // s34f24
    reg signed [9:-24] primitive_n41_s1; // s34f24
    reg signed [9:-24] primitive_n43_s1; // s34f24
    reg signed [9:-24] primitive_n44_s1; // s34f24
    reg signed [9:-24] primitive_n46_s1; // s34f24
    reg signed [9:-24] primitive_n47_s1; // s34f24
    reg signed [11:-22] primitive_e1_cross_e2_n49_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n50_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n52_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n53_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n55_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n56_s1; // s34f22
    reg signed [-22:-38] vertex_n88_s1; // s17f38
    reg signed [-23:-38] vertex_n90_s1; // s16f38
    reg signed [-22:-38] vertex_n92_s1; // s17f38
    reg signed [3:-28] vertex_ts_view_n_n311_s1; // s32f28
    reg signed [3:-28] vertex_ts_view_n_n312_s1; // s32f28
    reg signed [3:-28] vertex_ts_view_n_n313_s1; // s32f28
    reg signed [3:-28] vertex_ts_light0_n_n329_s1; // s32f28
    reg signed [3:-28] vertex_ts_light0_n_n330_s1; // s32f28
    reg signed [3:-28] vertex_ts_light0_n_n331_s1; // s32f28
    always @(posedge clk)
        if (ce) begin
            normal_x_s1 <= normal_x;
            normal_y_s1 <= normal_y;
            normal_z_s1 <= normal_z;
            view_x_s1 <= view_x;
            view_y_s1 <= view_y;
            view_z_s1 <= view_z;
            light0_x_s1 <= light0_x;
            light0_y_s1 <= light0_y;
            light0_z_s1 <= light0_z;
            primitive_n34_s1 <= primitive_n34;
            primitive_n35_s1 <= primitive_n35;
            primitive_n40_s1 <= primitive_n40;
            primitive_n41_s1 <= primitive_n41;
            primitive_n43_s1 <= primitive_n43;
            primitive_n44_s1 <= primitive_n44;
            primitive_n46_s1 <= primitive_n46;
            primitive_n47_s1 <= primitive_n47;
            primitive_e1_cross_e2_n49_s1 <= primitive_e1_cross_e2_n49;
            primitive_e1_cross_e2_n50_s1 <= primitive_e1_cross_e2_n50;
            primitive_e1_cross_e2_n52_s1 <= primitive_e1_cross_e2_n52;
            primitive_e1_cross_e2_n53_s1 <= primitive_e1_cross_e2_n53;
            primitive_e1_cross_e2_n55_s1 <= primitive_e1_cross_e2_n55;
            primitive_e1_cross_e2_n56_s1 <= primitive_e1_cross_e2_n56;
            vertex_n88_s1 <= vertex_n88;
            vertex_n90_s1 <= vertex_n90;
            vertex_n92_s1 <= vertex_n92;
            vertex_ts_view_n_n311_s1 <= vertex_ts_view_n_n311;
            vertex_ts_view_n_n312_s1 <= vertex_ts_view_n_n312;
            vertex_ts_view_n_n313_s1 <= vertex_ts_view_n_n313;
            vertex_ts_light0_n_n329_s1 <= vertex_ts_light0_n_n329;
            vertex_ts_light0_n_n330_s1 <= vertex_ts_light0_n_n330;
            vertex_ts_light0_n_n331_s1 <= vertex_ts_light0_n_n331;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // primitive
    wire signed [8:-26] primitive_det = {primitive_n34_s1[7], primitive_n34_s1} - {primitive_n35_s1[7], primitive_n35_s1}; // s35f26
    wire primitive_zero_uv = primitive_det == {8'h0, primitive_n37, 26'h0}; // u1f0
    wire primitive_mirrored = primitive_det[8]; // u1f0
    wire signed [10:-24] primitive_t_det_x = {primitive_n40_s1[9], primitive_n40_s1} - {primitive_n41_s1[9], primitive_n41_s1}; // s35f24
    wire signed [10:-24] primitive_t_det_y = {primitive_n43_s1[9], primitive_n43_s1} - {primitive_n44_s1[9], primitive_n44_s1}; // s35f24
    wire signed [10:-24] primitive_t_det_z = {primitive_n46_s1[9], primitive_n46_s1} - {primitive_n47_s1[9], primitive_n47_s1}; // s35f24
    // primitive.e1_cross_e2
    wire signed [12:-22] primitive_e1_cross_e2_n51 = {primitive_e1_cross_e2_n49_s1[11], primitive_e1_cross_e2_n49_s1} - {primitive_e1_cross_e2_n50_s1[11], primitive_e1_cross_e2_n50_s1}; // s35f22
    wire signed [12:-22] primitive_e1_cross_e2_n54 = {primitive_e1_cross_e2_n52_s1[11], primitive_e1_cross_e2_n52_s1} - {primitive_e1_cross_e2_n53_s1[11], primitive_e1_cross_e2_n53_s1}; // s35f22
    wire signed [12:-22] primitive_e1_cross_e2_n57 = {primitive_e1_cross_e2_n55_s1[11], primitive_e1_cross_e2_n55_s1} - {primitive_e1_cross_e2_n56_s1[11], primitive_e1_cross_e2_n56_s1}; // s35f22
    // primitive
    wire primitive_n58 = primitive_e1_cross_e2_n51 == {12'h0, primitive_n37, 22'h0}; // u1f0
    wire primitive_n59 = primitive_e1_cross_e2_n54 == {12'h0, primitive_n37, 22'h0}; // u1f0
    wire primitive_n60 = primitive_e1_cross_e2_n57 == {12'h0, primitive_n37, 22'h0}; // u1f0
    wire primitive_n61 = primitive_n58 & primitive_n59; // u1f0
    wire primitive_zero_area = primitive_n61 & primitive_n60; // u1f0
    // vertex
    wire vertex_n72 = primitive_zero_uv | primitive_zero_area; // u1f0
    // vertex.ts_view_n
    wire signed [4:-28] vertex_ts_view_n_n314 = {vertex_ts_view_n_n311_s1[3], vertex_ts_view_n_n311_s1} + {vertex_ts_view_n_n312_s1[3], vertex_ts_view_n_n312_s1}; // s33f28
    wire signed [5:-28] vertex_ts_view_n_n315 = {vertex_ts_view_n_n314[4], vertex_ts_view_n_n314} + {{2{vertex_ts_view_n_n313_s1[3]}}, vertex_ts_view_n_n313_s1}; // s34f28
    // vertex.ts_light0_n
    wire signed [4:-28] vertex_ts_light0_n_n332 = {vertex_ts_light0_n_n329_s1[3], vertex_ts_light0_n_n329_s1} + {vertex_ts_light0_n_n330_s1[3], vertex_ts_light0_n_n330_s1}; // s33f28
    wire signed [5:-28] vertex_ts_light0_n_n333 = {vertex_ts_light0_n_n332[4], vertex_ts_light0_n_n332} + {{2{vertex_ts_light0_n_n331_s1[3]}}, vertex_ts_light0_n_n331_s1}; // s34f28

    reg signed [1:-14] normal_x_s2; // s16f14
    reg signed [1:-14] normal_y_s2; // s16f14
    reg signed [1:-14] normal_z_s2; // s16f14
    reg signed [1:-14] view_x_s2; // s16f14
    reg signed [1:-14] view_y_s2; // s16f14
    reg signed [1:-14] view_z_s2; // s16f14
    reg signed [1:-14] light0_x_s2; // s16f14
    reg signed [1:-14] light0_y_s2; // s16f14
    reg signed [1:-14] light0_z_s2; // s16f14
    reg primitive_zero_uv_s2; // u1f0
    reg primitive_mirrored_s2; // u1f0
    reg signed [10:-24] primitive_t_det_x_s2; // s35f24
    reg signed [10:-24] primitive_t_det_y_s2; // s35f24
    reg signed [10:-24] primitive_t_det_z_s2; // s35f24
    reg primitive_zero_area_s2; // u1f0
    reg vertex_n72_s2; // u1f0
    reg signed [-22:-38] vertex_n88_s2; // s17f38
    reg signed [-23:-38] vertex_n90_s2; // s16f38
    reg signed [-22:-38] vertex_n92_s2; // s17f38
    reg signed [5:-28] vertex_ts_view_n_n315_s2; // s34f28
    reg signed [5:-28] vertex_ts_light0_n_n333_s2; // s34f28
    always @(posedge clk)
        if (ce) begin
            normal_x_s2 <= normal_x_s1;
            normal_y_s2 <= normal_y_s1;
            normal_z_s2 <= normal_z_s1;
            view_x_s2 <= view_x_s1;
            view_y_s2 <= view_y_s1;
            view_z_s2 <= view_z_s1;
            light0_x_s2 <= light0_x_s1;
            light0_y_s2 <= light0_y_s1;
            light0_z_s2 <= light0_z_s1;
            primitive_zero_uv_s2 <= primitive_zero_uv;
            primitive_mirrored_s2 <= primitive_mirrored;
            primitive_t_det_x_s2 <= primitive_t_det_x;
            primitive_t_det_y_s2 <= primitive_t_det_y;
            primitive_t_det_z_s2 <= primitive_t_det_z;
            primitive_zero_area_s2 <= primitive_zero_area;
            vertex_n72_s2 <= vertex_n72;
            vertex_n88_s2 <= vertex_n88_s1;
            vertex_n90_s2 <= vertex_n90_s1;
            vertex_n92_s2 <= vertex_n92_s1;
            vertex_ts_view_n_n315_s2 <= vertex_ts_view_n_n315;
            vertex_ts_light0_n_n333_s2 <= vertex_ts_light0_n_n333;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // vertex.n_cross_t
    wire signed [12:-38] vertex_n_cross_t_n73 = normal_y_s2 * primitive_t_det_z_s2; // s51f38
    wire signed [12:-38] vertex_n_cross_t_n74 = normal_z_s2 * primitive_t_det_y_s2; // s51f38
    wire signed [12:-38] vertex_n_cross_t_n76 = normal_z_s2 * primitive_t_det_x_s2; // s51f38
    wire signed [12:-38] vertex_n_cross_t_n77 = normal_x_s2 * primitive_t_det_z_s2; // s51f38
    wire signed [12:-38] vertex_n_cross_t_n79 = normal_x_s2 * primitive_t_det_y_s2; // s51f38
    wire signed [12:-38] vertex_n_cross_t_n80 = normal_y_s2 * primitive_t_det_x_s2; // s51f38
    // vertex
    wire signed [6:-28] vertex_ts_view_z_sum = {vertex_ts_view_n_n315_s2[5], vertex_ts_view_n_n315_s2} + 35'h2000;
    wire signed [6:-14] vertex_ts_view_z_cut = vertex_ts_view_z_sum[6:-14];
    wire vertex_ts_view_z_over = ~vertex_ts_view_z_cut[6] & (|vertex_ts_view_z_cut[5:4]);
    wire vertex_ts_view_z_under = vertex_ts_view_z_cut[6] & ~(&vertex_ts_view_z_cut[5:4]);
    wire signed [4:-14] vertex_ts_view_z = vertex_ts_view_z_over ? 19'h3ffff : vertex_ts_view_z_under ? 19'h40000 : vertex_ts_view_z_cut[4:-14]; // s19f14
    wire signed [6:-28] vertex_ts_light0_z_sum = {vertex_ts_light0_n_n333_s2[5], vertex_ts_light0_n_n333_s2} + 35'h2000;
    wire signed [6:-14] vertex_ts_light0_z_cut = vertex_ts_light0_z_sum[6:-14];
    wire vertex_ts_light0_z_over = ~vertex_ts_light0_z_cut[6] & (|vertex_ts_light0_z_cut[5:4]);
    wire vertex_ts_light0_z_under = vertex_ts_light0_z_cut[6] & ~(&vertex_ts_light0_z_cut[5:4]);
    wire signed [4:-14] vertex_ts_light0_z = vertex_ts_light0_z_over ? 19'h3ffff : vertex_ts_light0_z_under ? 19'h40000 : vertex_ts_light0_z_cut[4:-14]; // s19f14

    reg signed [1:-14] normal_x_s3; // s16f14
    reg signed [1:-14] normal_y_s3; // s16f14
    reg signed [1:-14] normal_z_s3; // s16f14
    reg signed [1:-14] view_x_s3; // s16f14
    reg signed [1:-14] view_y_s3; // s16f14
    reg signed [1:-14] view_z_s3; // s16f14
    reg signed [1:-14] light0_x_s3; // s16f14
    reg signed [1:-14] light0_y_s3; // s16f14
    reg signed [1:-14] light0_z_s3; // s16f14
    reg primitive_zero_uv_s3; // u1f0
    reg primitive_mirrored_s3; // u1f0
    reg primitive_zero_area_s3; // u1f0
    reg vertex_n72_s3; // u1f0
    reg signed [12:-38] vertex_n_cross_t_n73_s3; // s51f38
    reg signed [12:-38] vertex_n_cross_t_n74_s3; // s51f38
    reg signed [12:-38] vertex_n_cross_t_n76_s3; // s51f38
    reg signed [12:-38] vertex_n_cross_t_n77_s3; // s51f38
    reg signed [12:-38] vertex_n_cross_t_n79_s3; // s51f38
    reg signed [12:-38] vertex_n_cross_t_n80_s3; // s51f38
    reg signed [-22:-38] vertex_n88_s3; // s17f38
    reg signed [-23:-38] vertex_n90_s3; // s16f38
    reg signed [-22:-38] vertex_n92_s3; // s17f38
    reg signed [4:-14] vertex_ts_view_z_s3; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s3; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s3 <= normal_x_s2;
            normal_y_s3 <= normal_y_s2;
            normal_z_s3 <= normal_z_s2;
            view_x_s3 <= view_x_s2;
            view_y_s3 <= view_y_s2;
            view_z_s3 <= view_z_s2;
            light0_x_s3 <= light0_x_s2;
            light0_y_s3 <= light0_y_s2;
            light0_z_s3 <= light0_z_s2;
            primitive_zero_uv_s3 <= primitive_zero_uv_s2;
            primitive_mirrored_s3 <= primitive_mirrored_s2;
            primitive_zero_area_s3 <= primitive_zero_area_s2;
            vertex_n72_s3 <= vertex_n72_s2;
            vertex_n_cross_t_n73_s3 <= vertex_n_cross_t_n73;
            vertex_n_cross_t_n74_s3 <= vertex_n_cross_t_n74;
            vertex_n_cross_t_n76_s3 <= vertex_n_cross_t_n76;
            vertex_n_cross_t_n77_s3 <= vertex_n_cross_t_n77;
            vertex_n_cross_t_n79_s3 <= vertex_n_cross_t_n79;
            vertex_n_cross_t_n80_s3 <= vertex_n_cross_t_n80;
            vertex_n88_s3 <= vertex_n88_s2;
            vertex_n90_s3 <= vertex_n90_s2;
            vertex_n92_s3 <= vertex_n92_s2;
            vertex_ts_view_z_s3 <= vertex_ts_view_z;
            vertex_ts_light0_z_s3 <= vertex_ts_light0_z;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // vertex.n_cross_t
    wire signed [13:-38] vertex_n_cross_t_n75 = {vertex_n_cross_t_n73_s3[12], vertex_n_cross_t_n73_s3} - {vertex_n_cross_t_n74_s3[12], vertex_n_cross_t_n74_s3}; // s52f38
    wire signed [13:-38] vertex_n_cross_t_n78 = {vertex_n_cross_t_n76_s3[12], vertex_n_cross_t_n76_s3} - {vertex_n_cross_t_n77_s3[12], vertex_n_cross_t_n77_s3}; // s52f38
    wire signed [13:-38] vertex_n_cross_t_n81 = {vertex_n_cross_t_n79_s3[12], vertex_n_cross_t_n79_s3} - {vertex_n_cross_t_n80_s3[12], vertex_n_cross_t_n80_s3}; // s52f38
    // vertex
    wire vertex_n82 = vertex_n_cross_t_n75 == {13'h0, primitive_n37, 38'h0}; // u1f0
    wire vertex_n83 = vertex_n_cross_t_n78 == {13'h0, primitive_n37, 38'h0}; // u1f0
    wire vertex_n84 = vertex_n_cross_t_n81 == {13'h0, primitive_n37, 38'h0}; // u1f0
    wire vertex_n85 = vertex_n82 & vertex_n83; // u1f0

    reg signed [1:-14] normal_x_s4; // s16f14
    reg signed [1:-14] normal_y_s4; // s16f14
    reg signed [1:-14] normal_z_s4; // s16f14
    reg signed [1:-14] view_x_s4; // s16f14
    reg signed [1:-14] view_y_s4; // s16f14
    reg signed [1:-14] view_z_s4; // s16f14
    reg signed [1:-14] light0_x_s4; // s16f14
    reg signed [1:-14] light0_y_s4; // s16f14
    reg signed [1:-14] light0_z_s4; // s16f14
    reg primitive_zero_uv_s4; // u1f0
    reg primitive_mirrored_s4; // u1f0
    reg primitive_zero_area_s4; // u1f0
    reg vertex_n72_s4; // u1f0
    reg signed [13:-38] vertex_n_cross_t_n75_s4; // s52f38
    reg signed [13:-38] vertex_n_cross_t_n78_s4; // s52f38
    reg signed [13:-38] vertex_n_cross_t_n81_s4; // s52f38
    reg vertex_n84_s4; // u1f0
    reg vertex_n85_s4; // u1f0
    reg signed [-22:-38] vertex_n88_s4; // s17f38
    reg signed [-23:-38] vertex_n90_s4; // s16f38
    reg signed [-22:-38] vertex_n92_s4; // s17f38
    reg signed [4:-14] vertex_ts_view_z_s4; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s4; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s4 <= normal_x_s3;
            normal_y_s4 <= normal_y_s3;
            normal_z_s4 <= normal_z_s3;
            view_x_s4 <= view_x_s3;
            view_y_s4 <= view_y_s3;
            view_z_s4 <= view_z_s3;
            light0_x_s4 <= light0_x_s3;
            light0_y_s4 <= light0_y_s3;
            light0_z_s4 <= light0_z_s3;
            primitive_zero_uv_s4 <= primitive_zero_uv_s3;
            primitive_mirrored_s4 <= primitive_mirrored_s3;
            primitive_zero_area_s4 <= primitive_zero_area_s3;
            vertex_n72_s4 <= vertex_n72_s3;
            vertex_n_cross_t_n75_s4 <= vertex_n_cross_t_n75;
            vertex_n_cross_t_n78_s4 <= vertex_n_cross_t_n78;
            vertex_n_cross_t_n81_s4 <= vertex_n_cross_t_n81;
            vertex_n84_s4 <= vertex_n84;
            vertex_n85_s4 <= vertex_n85;
            vertex_n88_s4 <= vertex_n88_s3;
            vertex_n90_s4 <= vertex_n90_s3;
            vertex_n92_s4 <= vertex_n92_s3;
            vertex_ts_view_z_s4 <= vertex_ts_view_z_s3;
            vertex_ts_light0_z_s4 <= vertex_ts_light0_z_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // vertex
    wire vertex_parallel = vertex_n85_s4 & vertex_n84_s4; // u1f0
    wire vertex_degenerate = vertex_n72_s4 | vertex_parallel; // u1f0
    wire signed [13:-38] vertex_n89 = vertex_degenerate ? {{35{vertex_n88_s4[-22]}}, vertex_n88_s4} : vertex_n_cross_t_n75_s4; // s52f38
    wire signed [13:-38] vertex_n91 = vertex_degenerate ? {{36{vertex_n90_s4[-23]}}, vertex_n90_s4} : vertex_n_cross_t_n78_s4; // s52f38
    wire signed [13:-38] vertex_n93 = vertex_degenerate ? {{35{vertex_n92_s4[-22]}}, vertex_n92_s4} : vertex_n_cross_t_n81_s4; // s52f38
    // vertex.b
    wire [13:-38] vertex_b_n94_neg = -vertex_n89;
    wire [13:-38] vertex_b_n94 = vertex_n89[13] ? vertex_b_n94_neg : vertex_n89; // u52f38
    wire [51:0] vertex_b_n95 = vertex_b_n94; // u52f0
    wire [13:-38] vertex_b_n96_neg = -vertex_n91;
    wire [13:-38] vertex_b_n96 = vertex_n91[13] ? vertex_b_n96_neg : vertex_n91; // u52f38
    wire [51:0] vertex_b_n97 = vertex_b_n96; // u52f0
    wire [13:-38] vertex_b_n98_neg = -vertex_n93;
    wire [13:-38] vertex_b_n98 = vertex_n93[13] ? vertex_b_n98_neg : vertex_n93; // u52f38
    wire [51:0] vertex_b_n99 = vertex_b_n98; // u52f0
    wire [51:0] vertex_b_n100 = vertex_b_n95 | vertex_b_n97; // u52f0
    wire [51:0] vertex_b_n101 = vertex_b_n100 | vertex_b_n99; // u52f0
    wire [13:-38] vertex_b_largest = vertex_b_n101; // u52f38
    wire [51:0] vertex_b_n103 = vertex_b_largest; // u52f0
    wire [31:0] vertex_b_n104 = vertex_b_n103[51:20]; // u32f0
    wire [19:0] vertex_b_n106 = vertex_b_n103[19:0]; // u20f0
    wire [51:0] vertex_b_n108 = {vertex_b_n106, vertex_b_n107}; // u52f0
    wire vertex_b_n141 = vertex_n89[13]; // u1f0
    wire [51:0] vertex_b_n142 = vertex_n89; // u52f0
    wire [52:0] vertex_b_n143 = {vertex_b_n141, vertex_b_n142}; // u53f0
    wire [20:0] vertex_b_n145 = vertex_b_n143[20:0]; // u21f0
    wire [52:0] vertex_b_n146 = {vertex_b_n145, vertex_b_n107}; // u53f0
    wire vertex_b_n170 = vertex_n91[13]; // u1f0
    wire [51:0] vertex_b_n171 = vertex_n91; // u52f0
    wire [52:0] vertex_b_n172 = {vertex_b_n170, vertex_b_n171}; // u53f0
    wire [20:0] vertex_b_n173 = vertex_b_n172[20:0]; // u21f0
    wire [52:0] vertex_b_n174 = {vertex_b_n173, vertex_b_n107}; // u53f0
    wire vertex_b_n193 = vertex_n93[13]; // u1f0
    wire [51:0] vertex_b_n194 = vertex_n93; // u52f0
    wire [52:0] vertex_b_n195 = {vertex_b_n193, vertex_b_n194}; // u53f0
    wire [20:0] vertex_b_n196 = vertex_b_n195[20:0]; // u21f0
    wire [52:0] vertex_b_n197 = {vertex_b_n196, vertex_b_n107}; // u53f0
    // vertex
    wire vertex_n288 = vertex_degenerate ^ vertex_b_length_n251; // u1f0
    wire vertex_n289 = primitive_mirrored_s4 & vertex_n288; // u1f0

    reg signed [1:-14] normal_x_s5; // s16f14
    reg signed [1:-14] normal_y_s5; // s16f14
    reg signed [1:-14] normal_z_s5; // s16f14
    reg signed [1:-14] view_x_s5; // s16f14
    reg signed [1:-14] view_y_s5; // s16f14
    reg signed [1:-14] view_z_s5; // s16f14
    reg signed [1:-14] light0_x_s5; // s16f14
    reg signed [1:-14] light0_y_s5; // s16f14
    reg signed [1:-14] light0_z_s5; // s16f14
    reg primitive_zero_uv_s5; // u1f0
    reg primitive_mirrored_s5; // u1f0
    reg primitive_zero_area_s5; // u1f0
    reg vertex_parallel_s5; // u1f0
    reg vertex_degenerate_s5; // u1f0
    reg [51:0] vertex_b_n103_s5; // u52f0
    reg [31:0] vertex_b_n104_s5; // u32f0
    reg [51:0] vertex_b_n108_s5; // u52f0
    reg [52:0] vertex_b_n143_s5; // u53f0
    reg [52:0] vertex_b_n146_s5; // u53f0
    reg [52:0] vertex_b_n172_s5; // u53f0
    reg [52:0] vertex_b_n174_s5; // u53f0
    reg [52:0] vertex_b_n195_s5; // u53f0
    reg [52:0] vertex_b_n197_s5; // u53f0
    reg vertex_n289_s5; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s5; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s5; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s5 <= normal_x_s4;
            normal_y_s5 <= normal_y_s4;
            normal_z_s5 <= normal_z_s4;
            view_x_s5 <= view_x_s4;
            view_y_s5 <= view_y_s4;
            view_z_s5 <= view_z_s4;
            light0_x_s5 <= light0_x_s4;
            light0_y_s5 <= light0_y_s4;
            light0_z_s5 <= light0_z_s4;
            primitive_zero_uv_s5 <= primitive_zero_uv_s4;
            primitive_mirrored_s5 <= primitive_mirrored_s4;
            primitive_zero_area_s5 <= primitive_zero_area_s4;
            vertex_parallel_s5 <= vertex_parallel;
            vertex_degenerate_s5 <= vertex_degenerate;
            vertex_b_n103_s5 <= vertex_b_n103;
            vertex_b_n104_s5 <= vertex_b_n104;
            vertex_b_n108_s5 <= vertex_b_n108;
            vertex_b_n143_s5 <= vertex_b_n143;
            vertex_b_n146_s5 <= vertex_b_n146;
            vertex_b_n172_s5 <= vertex_b_n172;
            vertex_b_n174_s5 <= vertex_b_n174;
            vertex_b_n195_s5 <= vertex_b_n195;
            vertex_b_n197_s5 <= vertex_b_n197;
            vertex_n289_s5 <= vertex_n289;
            vertex_ts_view_z_s5 <= vertex_ts_view_z_s4;
            vertex_ts_light0_z_s5 <= vertex_ts_light0_z_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // vertex.b
    wire vertex_b_n105 = vertex_b_n104_s5 == {31'h0, primitive_n37}; // u1f0
    wire [51:0] vertex_b_n109 = vertex_b_n105 ? vertex_b_n108_s5 : vertex_b_n103_s5; // u52f0
    wire [15:0] vertex_b_n110 = vertex_b_n109[51:36]; // u16f0
    wire vertex_b_n111 = vertex_b_n110 == {15'h0, primitive_n37}; // u1f0
    wire [35:0] vertex_b_n112 = vertex_b_n109[35:0]; // u36f0
    wire [51:0] vertex_b_n114 = {vertex_b_n112, vertex_b_n113}; // u52f0
    wire [51:0] vertex_b_n115 = vertex_b_n111 ? vertex_b_n114 : vertex_b_n109; // u52f0
    wire [7:0] vertex_b_n116 = vertex_b_n115[51:44]; // u8f0
    wire vertex_b_n117 = vertex_b_n116 == {7'h0, primitive_n37}; // u1f0
    wire [43:0] vertex_b_n118 = vertex_b_n115[43:0]; // u44f0
    wire [51:0] vertex_b_n120 = {vertex_b_n118, vertex_b_n119}; // u52f0
    wire [1:0] vertex_b_n136 = {vertex_b_n105, vertex_b_n111}; // u2f0
    wire [2:0] vertex_b_n137 = {vertex_b_n136, vertex_b_n117}; // u3f0

    reg signed [1:-14] normal_x_s6; // s16f14
    reg signed [1:-14] normal_y_s6; // s16f14
    reg signed [1:-14] normal_z_s6; // s16f14
    reg signed [1:-14] view_x_s6; // s16f14
    reg signed [1:-14] view_y_s6; // s16f14
    reg signed [1:-14] view_z_s6; // s16f14
    reg signed [1:-14] light0_x_s6; // s16f14
    reg signed [1:-14] light0_y_s6; // s16f14
    reg signed [1:-14] light0_z_s6; // s16f14
    reg primitive_zero_uv_s6; // u1f0
    reg primitive_mirrored_s6; // u1f0
    reg primitive_zero_area_s6; // u1f0
    reg vertex_parallel_s6; // u1f0
    reg vertex_degenerate_s6; // u1f0
    reg [51:0] vertex_b_n115_s6; // u52f0
    reg vertex_b_n117_s6; // u1f0
    reg [51:0] vertex_b_n120_s6; // u52f0
    reg [2:0] vertex_b_n137_s6; // u3f0
    reg [52:0] vertex_b_n143_s6; // u53f0
    reg [52:0] vertex_b_n146_s6; // u53f0
    reg [52:0] vertex_b_n172_s6; // u53f0
    reg [52:0] vertex_b_n174_s6; // u53f0
    reg [52:0] vertex_b_n195_s6; // u53f0
    reg [52:0] vertex_b_n197_s6; // u53f0
    reg vertex_n289_s6; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s6; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s6; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s6 <= normal_x_s5;
            normal_y_s6 <= normal_y_s5;
            normal_z_s6 <= normal_z_s5;
            view_x_s6 <= view_x_s5;
            view_y_s6 <= view_y_s5;
            view_z_s6 <= view_z_s5;
            light0_x_s6 <= light0_x_s5;
            light0_y_s6 <= light0_y_s5;
            light0_z_s6 <= light0_z_s5;
            primitive_zero_uv_s6 <= primitive_zero_uv_s5;
            primitive_mirrored_s6 <= primitive_mirrored_s5;
            primitive_zero_area_s6 <= primitive_zero_area_s5;
            vertex_parallel_s6 <= vertex_parallel_s5;
            vertex_degenerate_s6 <= vertex_degenerate_s5;
            vertex_b_n115_s6 <= vertex_b_n115;
            vertex_b_n117_s6 <= vertex_b_n117;
            vertex_b_n120_s6 <= vertex_b_n120;
            vertex_b_n137_s6 <= vertex_b_n137;
            vertex_b_n143_s6 <= vertex_b_n143_s5;
            vertex_b_n146_s6 <= vertex_b_n146_s5;
            vertex_b_n172_s6 <= vertex_b_n172_s5;
            vertex_b_n174_s6 <= vertex_b_n174_s5;
            vertex_b_n195_s6 <= vertex_b_n195_s5;
            vertex_b_n197_s6 <= vertex_b_n197_s5;
            vertex_n289_s6 <= vertex_n289_s5;
            vertex_ts_view_z_s6 <= vertex_ts_view_z_s5;
            vertex_ts_light0_z_s6 <= vertex_ts_light0_z_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // vertex.b
    wire [51:0] vertex_b_n121 = vertex_b_n117_s6 ? vertex_b_n120_s6 : vertex_b_n115_s6; // u52f0
    wire [3:0] vertex_b_n122 = vertex_b_n121[51:48]; // u4f0
    wire vertex_b_n123 = vertex_b_n122 == {3'h0, primitive_n37}; // u1f0
    wire [47:0] vertex_b_n124 = vertex_b_n121[47:0]; // u48f0
    wire [51:0] vertex_b_n126 = {vertex_b_n124, vertex_b_n125}; // u52f0
    wire [51:0] vertex_b_n127 = vertex_b_n123 ? vertex_b_n126 : vertex_b_n121; // u52f0
    wire [1:0] vertex_b_n128 = vertex_b_n127[51:50]; // u2f0
    wire vertex_b_n129 = vertex_b_n128 == {1'b0, primitive_n37}; // u1f0
    wire [49:0] vertex_b_n130 = vertex_b_n127[49:0]; // u50f0
    wire [51:0] vertex_b_n132 = {vertex_b_n130, vertex_b_n131}; // u52f0
    wire [51:0] vertex_b_n133 = vertex_b_n129 ? vertex_b_n132 : vertex_b_n127; // u52f0
    wire vertex_b_n134 = vertex_b_n133[51]; // u1f0
    wire vertex_b_n135 = vertex_b_n134 == primitive_n37; // u1f0
    wire [3:0] vertex_b_n138 = {vertex_b_n137_s6, vertex_b_n123}; // u4f0
    wire [4:0] vertex_b_n139 = {vertex_b_n138, vertex_b_n129}; // u5f0
    wire [5:0] vertex_b_places = {vertex_b_n139, vertex_b_n135}; // u6f0
    wire vertex_b_n144 = vertex_b_places[5]; // u1f0
    wire [52:0] vertex_b_n147 = vertex_b_n144 ? vertex_b_n146_s6 : vertex_b_n143_s6; // u53f0
    wire vertex_b_n148 = vertex_b_places[4]; // u1f0
    wire [36:0] vertex_b_n149 = vertex_b_n147[36:0]; // u37f0
    wire [52:0] vertex_b_n150 = {vertex_b_n149, vertex_b_n113}; // u53f0
    wire [52:0] vertex_b_n151 = vertex_b_n148 ? vertex_b_n150 : vertex_b_n147; // u53f0
    wire vertex_b_n152 = vertex_b_places[3]; // u1f0
    wire [44:0] vertex_b_n153 = vertex_b_n151[44:0]; // u45f0
    wire [52:0] vertex_b_n154 = {vertex_b_n153, vertex_b_n119}; // u53f0
    wire vertex_b_n156 = vertex_b_places[2]; // u1f0
    wire vertex_b_n160 = vertex_b_places[1]; // u1f0
    wire vertex_b_n164 = vertex_b_places[0]; // u1f0
    wire [52:0] vertex_b_n175 = vertex_b_n144 ? vertex_b_n174_s6 : vertex_b_n172_s6; // u53f0
    wire [36:0] vertex_b_n176 = vertex_b_n175[36:0]; // u37f0
    wire [52:0] vertex_b_n177 = {vertex_b_n176, vertex_b_n113}; // u53f0
    wire [52:0] vertex_b_n178 = vertex_b_n148 ? vertex_b_n177 : vertex_b_n175; // u53f0
    wire [44:0] vertex_b_n179 = vertex_b_n178[44:0]; // u45f0
    wire [52:0] vertex_b_n180 = {vertex_b_n179, vertex_b_n119}; // u53f0
    wire [52:0] vertex_b_n198 = vertex_b_n144 ? vertex_b_n197_s6 : vertex_b_n195_s6; // u53f0
    wire [36:0] vertex_b_n199 = vertex_b_n198[36:0]; // u37f0
    wire [52:0] vertex_b_n200 = {vertex_b_n199, vertex_b_n113}; // u53f0
    wire [52:0] vertex_b_n201 = vertex_b_n148 ? vertex_b_n200 : vertex_b_n198; // u53f0
    wire [44:0] vertex_b_n202 = vertex_b_n201[44:0]; // u45f0
    wire [52:0] vertex_b_n203 = {vertex_b_n202, vertex_b_n119}; // u53f0

    reg signed [1:-14] normal_x_s7; // s16f14
    reg signed [1:-14] normal_y_s7; // s16f14
    reg signed [1:-14] normal_z_s7; // s16f14
    reg signed [1:-14] view_x_s7; // s16f14
    reg signed [1:-14] view_y_s7; // s16f14
    reg signed [1:-14] view_z_s7; // s16f14
    reg signed [1:-14] light0_x_s7; // s16f14
    reg signed [1:-14] light0_y_s7; // s16f14
    reg signed [1:-14] light0_z_s7; // s16f14
    reg primitive_zero_uv_s7; // u1f0
    reg primitive_mirrored_s7; // u1f0
    reg primitive_zero_area_s7; // u1f0
    reg vertex_parallel_s7; // u1f0
    reg vertex_degenerate_s7; // u1f0
    reg [52:0] vertex_b_n151_s7; // u53f0
    reg vertex_b_n152_s7; // u1f0
    reg [52:0] vertex_b_n154_s7; // u53f0
    reg vertex_b_n156_s7; // u1f0
    reg vertex_b_n160_s7; // u1f0
    reg vertex_b_n164_s7; // u1f0
    reg [52:0] vertex_b_n178_s7; // u53f0
    reg [52:0] vertex_b_n180_s7; // u53f0
    reg [52:0] vertex_b_n201_s7; // u53f0
    reg [52:0] vertex_b_n203_s7; // u53f0
    reg vertex_n289_s7; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s7; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s7; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s7 <= normal_x_s6;
            normal_y_s7 <= normal_y_s6;
            normal_z_s7 <= normal_z_s6;
            view_x_s7 <= view_x_s6;
            view_y_s7 <= view_y_s6;
            view_z_s7 <= view_z_s6;
            light0_x_s7 <= light0_x_s6;
            light0_y_s7 <= light0_y_s6;
            light0_z_s7 <= light0_z_s6;
            primitive_zero_uv_s7 <= primitive_zero_uv_s6;
            primitive_mirrored_s7 <= primitive_mirrored_s6;
            primitive_zero_area_s7 <= primitive_zero_area_s6;
            vertex_parallel_s7 <= vertex_parallel_s6;
            vertex_degenerate_s7 <= vertex_degenerate_s6;
            vertex_b_n151_s7 <= vertex_b_n151;
            vertex_b_n152_s7 <= vertex_b_n152;
            vertex_b_n154_s7 <= vertex_b_n154;
            vertex_b_n156_s7 <= vertex_b_n156;
            vertex_b_n160_s7 <= vertex_b_n160;
            vertex_b_n164_s7 <= vertex_b_n164;
            vertex_b_n178_s7 <= vertex_b_n178;
            vertex_b_n180_s7 <= vertex_b_n180;
            vertex_b_n201_s7 <= vertex_b_n201;
            vertex_b_n203_s7 <= vertex_b_n203;
            vertex_n289_s7 <= vertex_n289_s6;
            vertex_ts_view_z_s7 <= vertex_ts_view_z_s6;
            vertex_ts_light0_z_s7 <= vertex_ts_light0_z_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // vertex.b
    wire [52:0] vertex_b_n155 = vertex_b_n152_s7 ? vertex_b_n154_s7 : vertex_b_n151_s7; // u53f0
    wire [48:0] vertex_b_n157 = vertex_b_n155[48:0]; // u49f0
    wire [52:0] vertex_b_n158 = {vertex_b_n157, vertex_b_n125}; // u53f0
    wire [52:0] vertex_b_n159 = vertex_b_n156_s7 ? vertex_b_n158 : vertex_b_n155; // u53f0
    wire [50:0] vertex_b_n161 = vertex_b_n159[50:0]; // u51f0
    wire [52:0] vertex_b_n162 = {vertex_b_n161, vertex_b_n131}; // u53f0
    wire [52:0] vertex_b_n163 = vertex_b_n160_s7 ? vertex_b_n162 : vertex_b_n159; // u53f0
    wire [51:0] vertex_b_n165 = vertex_b_n163[51:0]; // u52f0
    wire [52:0] vertex_b_n166 = {vertex_b_n165, primitive_n37}; // u53f0
    wire [52:0] vertex_b_n167 = vertex_b_n164_s7 ? vertex_b_n166 : vertex_b_n163; // u53f0
    wire signed [52:0] vertex_b_n168 = vertex_b_n167; // s53f0
    wire signed [0:-52] vertex_b_x = vertex_b_n168; // s53f52
    wire [52:0] vertex_b_n181 = vertex_b_n152_s7 ? vertex_b_n180_s7 : vertex_b_n178_s7; // u53f0
    wire [48:0] vertex_b_n182 = vertex_b_n181[48:0]; // u49f0
    wire [52:0] vertex_b_n183 = {vertex_b_n182, vertex_b_n125}; // u53f0
    wire [52:0] vertex_b_n184 = vertex_b_n156_s7 ? vertex_b_n183 : vertex_b_n181; // u53f0
    wire [50:0] vertex_b_n185 = vertex_b_n184[50:0]; // u51f0
    wire [52:0] vertex_b_n186 = {vertex_b_n185, vertex_b_n131}; // u53f0
    wire [52:0] vertex_b_n187 = vertex_b_n160_s7 ? vertex_b_n186 : vertex_b_n184; // u53f0
    wire [51:0] vertex_b_n188 = vertex_b_n187[51:0]; // u52f0
    wire [52:0] vertex_b_n189 = {vertex_b_n188, primitive_n37}; // u53f0
    wire [52:0] vertex_b_n190 = vertex_b_n164_s7 ? vertex_b_n189 : vertex_b_n187; // u53f0
    wire signed [52:0] vertex_b_n191 = vertex_b_n190; // s53f0
    wire signed [0:-52] vertex_b_y = vertex_b_n191; // s53f52
    wire [52:0] vertex_b_n204 = vertex_b_n152_s7 ? vertex_b_n203_s7 : vertex_b_n201_s7; // u53f0
    wire [48:0] vertex_b_n205 = vertex_b_n204[48:0]; // u49f0
    wire [52:0] vertex_b_n206 = {vertex_b_n205, vertex_b_n125}; // u53f0
    wire [52:0] vertex_b_n207 = vertex_b_n156_s7 ? vertex_b_n206 : vertex_b_n204; // u53f0
    wire [50:0] vertex_b_n208 = vertex_b_n207[50:0]; // u51f0
    wire [52:0] vertex_b_n209 = {vertex_b_n208, vertex_b_n131}; // u53f0
    wire [52:0] vertex_b_n210 = vertex_b_n160_s7 ? vertex_b_n209 : vertex_b_n207; // u53f0
    wire [51:0] vertex_b_n211 = vertex_b_n210[51:0]; // u52f0
    wire [52:0] vertex_b_n212 = {vertex_b_n211, primitive_n37}; // u53f0
    wire [52:0] vertex_b_n213 = vertex_b_n164_s7 ? vertex_b_n212 : vertex_b_n210; // u53f0
    wire signed [52:0] vertex_b_n214 = vertex_b_n213; // s53f0
    wire signed [0:-52] vertex_b_z = vertex_b_n214; // s53f52
    // vertex
    wire signed [1:-52] vertex_b_norm_x_sum = {vertex_b_x[0], vertex_b_x} + 54'h400000000;
    wire signed [1:-17] vertex_b_norm_x_cut = vertex_b_norm_x_sum[1:-17];
    wire vertex_b_norm_x_over = ~vertex_b_norm_x_cut[1] & (|vertex_b_norm_x_cut[0]);
    wire signed [0:-17] vertex_b_norm_x = vertex_b_norm_x_over ? 18'h1ffff : vertex_b_norm_x_cut[0:-17]; // s18f17
    wire signed [1:-52] vertex_b_norm_y_sum = {vertex_b_y[0], vertex_b_y} + 54'h400000000;
    wire signed [1:-17] vertex_b_norm_y_cut = vertex_b_norm_y_sum[1:-17];
    wire vertex_b_norm_y_over = ~vertex_b_norm_y_cut[1] & (|vertex_b_norm_y_cut[0]);
    wire signed [0:-17] vertex_b_norm_y = vertex_b_norm_y_over ? 18'h1ffff : vertex_b_norm_y_cut[0:-17]; // s18f17
    wire signed [1:-52] vertex_b_norm_z_sum = {vertex_b_z[0], vertex_b_z} + 54'h400000000;
    wire signed [1:-17] vertex_b_norm_z_cut = vertex_b_norm_z_sum[1:-17];
    wire vertex_b_norm_z_over = ~vertex_b_norm_z_cut[1] & (|vertex_b_norm_z_cut[0]);
    wire signed [0:-17] vertex_b_norm_z = vertex_b_norm_z_over ? 18'h1ffff : vertex_b_norm_z_cut[0:-17]; // s18f17

    reg signed [1:-14] normal_x_s8; // s16f14
    reg signed [1:-14] normal_y_s8; // s16f14
    reg signed [1:-14] normal_z_s8; // s16f14
    reg signed [1:-14] view_x_s8; // s16f14
    reg signed [1:-14] view_y_s8; // s16f14
    reg signed [1:-14] view_z_s8; // s16f14
    reg signed [1:-14] light0_x_s8; // s16f14
    reg signed [1:-14] light0_y_s8; // s16f14
    reg signed [1:-14] light0_z_s8; // s16f14
    reg primitive_zero_uv_s8; // u1f0
    reg primitive_mirrored_s8; // u1f0
    reg primitive_zero_area_s8; // u1f0
    reg vertex_parallel_s8; // u1f0
    reg vertex_degenerate_s8; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s8; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s8; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s8; // s18f17
    reg vertex_n289_s8; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s8; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s8; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s8 <= normal_x_s7;
            normal_y_s8 <= normal_y_s7;
            normal_z_s8 <= normal_z_s7;
            view_x_s8 <= view_x_s7;
            view_y_s8 <= view_y_s7;
            view_z_s8 <= view_z_s7;
            light0_x_s8 <= light0_x_s7;
            light0_y_s8 <= light0_y_s7;
            light0_z_s8 <= light0_z_s7;
            primitive_zero_uv_s8 <= primitive_zero_uv_s7;
            primitive_mirrored_s8 <= primitive_mirrored_s7;
            primitive_zero_area_s8 <= primitive_zero_area_s7;
            vertex_parallel_s8 <= vertex_parallel_s7;
            vertex_degenerate_s8 <= vertex_degenerate_s7;
            vertex_b_norm_x_s8 <= vertex_b_norm_x;
            vertex_b_norm_y_s8 <= vertex_b_norm_y;
            vertex_b_norm_z_s8 <= vertex_b_norm_z;
            vertex_n289_s8 <= vertex_n289_s7;
            vertex_ts_view_z_s8 <= vertex_ts_view_z_s7;
            vertex_ts_light0_z_s8 <= vertex_ts_light0_z_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // vertex.b_square
    wire signed [1:-34] vertex_b_square_n219 = vertex_b_norm_x_s8 * vertex_b_norm_x_s8; // s36f34
    wire signed [1:-34] vertex_b_square_n220 = vertex_b_norm_y_s8 * vertex_b_norm_y_s8; // s36f34
    wire signed [1:-34] vertex_b_square_n221 = vertex_b_norm_z_s8 * vertex_b_norm_z_s8; // s36f34

    reg signed [1:-14] normal_x_s9; // s16f14
    reg signed [1:-14] normal_y_s9; // s16f14
    reg signed [1:-14] normal_z_s9; // s16f14
    reg signed [1:-14] view_x_s9; // s16f14
    reg signed [1:-14] view_y_s9; // s16f14
    reg signed [1:-14] view_z_s9; // s16f14
    reg signed [1:-14] light0_x_s9; // s16f14
    reg signed [1:-14] light0_y_s9; // s16f14
    reg signed [1:-14] light0_z_s9; // s16f14
    reg primitive_zero_uv_s9; // u1f0
    reg primitive_mirrored_s9; // u1f0
    reg primitive_zero_area_s9; // u1f0
    reg vertex_parallel_s9; // u1f0
    reg vertex_degenerate_s9; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s9; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s9; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s9; // s18f17
    reg signed [1:-34] vertex_b_square_n219_s9; // s36f34
    reg signed [1:-34] vertex_b_square_n220_s9; // s36f34
    reg signed [1:-34] vertex_b_square_n221_s9; // s36f34
    reg vertex_n289_s9; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s9; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s9; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s9 <= normal_x_s8;
            normal_y_s9 <= normal_y_s8;
            normal_z_s9 <= normal_z_s8;
            view_x_s9 <= view_x_s8;
            view_y_s9 <= view_y_s8;
            view_z_s9 <= view_z_s8;
            light0_x_s9 <= light0_x_s8;
            light0_y_s9 <= light0_y_s8;
            light0_z_s9 <= light0_z_s8;
            primitive_zero_uv_s9 <= primitive_zero_uv_s8;
            primitive_mirrored_s9 <= primitive_mirrored_s8;
            primitive_zero_area_s9 <= primitive_zero_area_s8;
            vertex_parallel_s9 <= vertex_parallel_s8;
            vertex_degenerate_s9 <= vertex_degenerate_s8;
            vertex_b_norm_x_s9 <= vertex_b_norm_x_s8;
            vertex_b_norm_y_s9 <= vertex_b_norm_y_s8;
            vertex_b_norm_z_s9 <= vertex_b_norm_z_s8;
            vertex_b_square_n219_s9 <= vertex_b_square_n219;
            vertex_b_square_n220_s9 <= vertex_b_square_n220;
            vertex_b_square_n221_s9 <= vertex_b_square_n221;
            vertex_n289_s9 <= vertex_n289_s8;
            vertex_ts_view_z_s9 <= vertex_ts_view_z_s8;
            vertex_ts_light0_z_s9 <= vertex_ts_light0_z_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // vertex.b_square
    wire signed [2:-34] vertex_b_square_n222 = {vertex_b_square_n219_s9[1], vertex_b_square_n219_s9} + {vertex_b_square_n220_s9[1], vertex_b_square_n220_s9}; // s37f34
    wire signed [3:-34] vertex_b_square_n223 = {vertex_b_square_n222[2], vertex_b_square_n222} + {{2{vertex_b_square_n221_s9[1]}}, vertex_b_square_n221_s9}; // s38f34

    reg signed [1:-14] normal_x_s10; // s16f14
    reg signed [1:-14] normal_y_s10; // s16f14
    reg signed [1:-14] normal_z_s10; // s16f14
    reg signed [1:-14] view_x_s10; // s16f14
    reg signed [1:-14] view_y_s10; // s16f14
    reg signed [1:-14] view_z_s10; // s16f14
    reg signed [1:-14] light0_x_s10; // s16f14
    reg signed [1:-14] light0_y_s10; // s16f14
    reg signed [1:-14] light0_z_s10; // s16f14
    reg primitive_zero_uv_s10; // u1f0
    reg primitive_mirrored_s10; // u1f0
    reg primitive_zero_area_s10; // u1f0
    reg vertex_parallel_s10; // u1f0
    reg vertex_degenerate_s10; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s10; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s10; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s10; // s18f17
    reg signed [3:-34] vertex_b_square_n223_s10; // s38f34
    reg vertex_n289_s10; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s10; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s10; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s10 <= normal_x_s9;
            normal_y_s10 <= normal_y_s9;
            normal_z_s10 <= normal_z_s9;
            view_x_s10 <= view_x_s9;
            view_y_s10 <= view_y_s9;
            view_z_s10 <= view_z_s9;
            light0_x_s10 <= light0_x_s9;
            light0_y_s10 <= light0_y_s9;
            light0_z_s10 <= light0_z_s9;
            primitive_zero_uv_s10 <= primitive_zero_uv_s9;
            primitive_mirrored_s10 <= primitive_mirrored_s9;
            primitive_zero_area_s10 <= primitive_zero_area_s9;
            vertex_parallel_s10 <= vertex_parallel_s9;
            vertex_degenerate_s10 <= vertex_degenerate_s9;
            vertex_b_norm_x_s10 <= vertex_b_norm_x_s9;
            vertex_b_norm_y_s10 <= vertex_b_norm_y_s9;
            vertex_b_norm_z_s10 <= vertex_b_norm_z_s9;
            vertex_b_square_n223_s10 <= vertex_b_square_n223;
            vertex_n289_s10 <= vertex_n289_s9;
            vertex_ts_view_z_s10 <= vertex_ts_view_z_s9;
            vertex_ts_light0_z_s10 <= vertex_ts_light0_z_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // vertex
    wire signed [4:-34] vertex_b_length_square_sum = {vertex_b_square_n223_s10[3], vertex_b_square_n223_s10} + 39'h2000;
    wire signed [4:-20] vertex_b_length_square_cut = vertex_b_length_square_sum[4:-20];
    wire vertex_b_length_square_over = ~vertex_b_length_square_cut[4] & (|vertex_b_length_square_cut[3:2]);
    wire vertex_b_length_square_under = vertex_b_length_square_cut[4];
    wire [1:-20] vertex_b_length_square = vertex_b_length_square_over ? 22'h3fffff : vertex_b_length_square_under ? 22'h0 : vertex_b_length_square_cut[1:-20]; // u22f20
    // vertex.b_length
    wire [21:0] vertex_b_length_n225 = vertex_b_length_square; // u22f0
    wire [21:0] vertex_b_length_n226 = vertex_b_length_n225; // u22f0
    wire [15:0] vertex_b_length_n227 = vertex_b_length_n226[21:6]; // u16f0
    wire vertex_b_length_n228 = vertex_b_length_n227 == {15'h0, primitive_n37}; // u1f0
    wire [5:0] vertex_b_length_n229 = vertex_b_length_n226[5:0]; // u6f0
    wire [21:0] vertex_b_length_n230 = {vertex_b_length_n229, vertex_b_n113}; // u22f0
    wire [21:0] vertex_b_length_n231 = vertex_b_length_n228 ? vertex_b_length_n230 : vertex_b_length_n226; // u22f0
    wire [7:0] vertex_b_length_n232 = vertex_b_length_n231[21:14]; // u8f0
    wire vertex_b_length_n233 = vertex_b_length_n232 == {7'h0, primitive_n37}; // u1f0
    wire [13:0] vertex_b_length_n234 = vertex_b_length_n231[13:0]; // u14f0
    wire [21:0] vertex_b_length_n235 = {vertex_b_length_n234, vertex_b_n119}; // u22f0
    wire [1:0] vertex_b_length_n247 = {vertex_b_length_n228, vertex_b_length_n233}; // u2f0
    wire vertex_b_length_n267 = vertex_b_length_square == {1'b0, primitive_n37, 20'h0}; // u1f0

    reg signed [1:-14] normal_x_s11; // s16f14
    reg signed [1:-14] normal_y_s11; // s16f14
    reg signed [1:-14] normal_z_s11; // s16f14
    reg signed [1:-14] view_x_s11; // s16f14
    reg signed [1:-14] view_y_s11; // s16f14
    reg signed [1:-14] view_z_s11; // s16f14
    reg signed [1:-14] light0_x_s11; // s16f14
    reg signed [1:-14] light0_y_s11; // s16f14
    reg signed [1:-14] light0_z_s11; // s16f14
    reg primitive_zero_uv_s11; // u1f0
    reg primitive_mirrored_s11; // u1f0
    reg primitive_zero_area_s11; // u1f0
    reg vertex_parallel_s11; // u1f0
    reg vertex_degenerate_s11; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s11; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s11; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s11; // s18f17
    reg [21:0] vertex_b_length_n231_s11; // u22f0
    reg vertex_b_length_n233_s11; // u1f0
    reg [21:0] vertex_b_length_n235_s11; // u22f0
    reg [1:0] vertex_b_length_n247_s11; // u2f0
    reg vertex_b_length_n267_s11; // u1f0
    reg vertex_n289_s11; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s11; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s11; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s11 <= normal_x_s10;
            normal_y_s11 <= normal_y_s10;
            normal_z_s11 <= normal_z_s10;
            view_x_s11 <= view_x_s10;
            view_y_s11 <= view_y_s10;
            view_z_s11 <= view_z_s10;
            light0_x_s11 <= light0_x_s10;
            light0_y_s11 <= light0_y_s10;
            light0_z_s11 <= light0_z_s10;
            primitive_zero_uv_s11 <= primitive_zero_uv_s10;
            primitive_mirrored_s11 <= primitive_mirrored_s10;
            primitive_zero_area_s11 <= primitive_zero_area_s10;
            vertex_parallel_s11 <= vertex_parallel_s10;
            vertex_degenerate_s11 <= vertex_degenerate_s10;
            vertex_b_norm_x_s11 <= vertex_b_norm_x_s10;
            vertex_b_norm_y_s11 <= vertex_b_norm_y_s10;
            vertex_b_norm_z_s11 <= vertex_b_norm_z_s10;
            vertex_b_length_n231_s11 <= vertex_b_length_n231;
            vertex_b_length_n233_s11 <= vertex_b_length_n233;
            vertex_b_length_n235_s11 <= vertex_b_length_n235;
            vertex_b_length_n247_s11 <= vertex_b_length_n247;
            vertex_b_length_n267_s11 <= vertex_b_length_n267;
            vertex_n289_s11 <= vertex_n289_s10;
            vertex_ts_view_z_s11 <= vertex_ts_view_z_s10;
            vertex_ts_light0_z_s11 <= vertex_ts_light0_z_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // vertex.b_length
    wire [21:0] vertex_b_length_n236 = vertex_b_length_n233_s11 ? vertex_b_length_n235_s11 : vertex_b_length_n231_s11; // u22f0
    wire [3:0] vertex_b_length_n237 = vertex_b_length_n236[21:18]; // u4f0
    wire vertex_b_length_n238 = vertex_b_length_n237 == {3'h0, primitive_n37}; // u1f0
    wire [17:0] vertex_b_length_n239 = vertex_b_length_n236[17:0]; // u18f0
    wire [21:0] vertex_b_length_n240 = {vertex_b_length_n239, vertex_b_n125}; // u22f0
    wire [21:0] vertex_b_length_n241 = vertex_b_length_n238 ? vertex_b_length_n240 : vertex_b_length_n236; // u22f0
    wire [1:0] vertex_b_length_n242 = vertex_b_length_n241[21:20]; // u2f0
    wire vertex_b_length_n243 = vertex_b_length_n242 == {1'b0, primitive_n37}; // u1f0
    wire [19:0] vertex_b_length_n244 = vertex_b_length_n241[19:0]; // u20f0
    wire [21:0] vertex_b_length_n245 = {vertex_b_length_n244, vertex_b_n131}; // u22f0
    wire [21:0] vertex_b_length_n246 = vertex_b_length_n243 ? vertex_b_length_n245 : vertex_b_length_n241; // u22f0
    wire [2:0] vertex_b_length_n248 = {vertex_b_length_n247_s11, vertex_b_length_n238}; // u3f0
    wire [3:0] vertex_b_length_n249 = {vertex_b_length_n248, vertex_b_length_n243}; // u4f0
    wire [1:0] vertex_b_length_n250 = vertex_b_length_n246[21:20]; // u2f0
    wire signed [2:0] vertex_b_length_n252 = {1'b0, vertex_b_length_n250} - {2'h0, vertex_b_length_n251}; // s3f0
    wire [1:0] vertex_b_length_n253 = vertex_b_length_n252[1:0]; // u2f0
    wire [17:0] vertex_b_length_n254 = vertex_b_length_n246[19:2]; // u18f0
    wire [19:0] vertex_b_length_n255 = {vertex_b_length_n253, vertex_b_length_n254}; // u20f0
    wire [-1:-20] vertex_b_length_n256 = vertex_b_length_n255; // u20f20
    // vertex.b_length.recip_root
    wire [7:0] vertex_b_length_recip_root_n257 = vertex_b_length_n256[-1:-8]; // u8f0
    wire [11:0] vertex_b_length_recip_root_n260 = vertex_b_length_n256[-9:-20]; // u12f0

    reg signed [1:-14] normal_x_s12; // s16f14
    reg signed [1:-14] normal_y_s12; // s16f14
    reg signed [1:-14] normal_z_s12; // s16f14
    reg signed [1:-14] view_x_s12; // s16f14
    reg signed [1:-14] view_y_s12; // s16f14
    reg signed [1:-14] view_z_s12; // s16f14
    reg signed [1:-14] light0_x_s12; // s16f14
    reg signed [1:-14] light0_y_s12; // s16f14
    reg signed [1:-14] light0_z_s12; // s16f14
    reg primitive_zero_uv_s12; // u1f0
    reg primitive_mirrored_s12; // u1f0
    reg primitive_zero_area_s12; // u1f0
    reg vertex_parallel_s12; // u1f0
    reg vertex_degenerate_s12; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s12; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s12; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s12; // s18f17
    reg [3:0] vertex_b_length_n249_s12; // u4f0
    reg [39:0] recip_root_row;
    reg [11:0] vertex_b_length_recip_root_n260_s12; // u12f0
    reg vertex_b_length_n267_s12; // u1f0
    reg vertex_n289_s12; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s12; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s12; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s12 <= normal_x_s11;
            normal_y_s12 <= normal_y_s11;
            normal_z_s12 <= normal_z_s11;
            view_x_s12 <= view_x_s11;
            view_y_s12 <= view_y_s11;
            view_z_s12 <= view_z_s11;
            light0_x_s12 <= light0_x_s11;
            light0_y_s12 <= light0_y_s11;
            light0_z_s12 <= light0_z_s11;
            primitive_zero_uv_s12 <= primitive_zero_uv_s11;
            primitive_mirrored_s12 <= primitive_mirrored_s11;
            primitive_zero_area_s12 <= primitive_zero_area_s11;
            vertex_parallel_s12 <= vertex_parallel_s11;
            vertex_degenerate_s12 <= vertex_degenerate_s11;
            vertex_b_norm_x_s12 <= vertex_b_norm_x_s11;
            vertex_b_norm_y_s12 <= vertex_b_norm_y_s11;
            vertex_b_norm_z_s12 <= vertex_b_norm_z_s11;
            vertex_b_length_n249_s12 <= vertex_b_length_n249;
            recip_root_row <= recip_root_rom[vertex_b_length_recip_root_n257];
            vertex_b_length_recip_root_n260_s12 <= vertex_b_length_recip_root_n260;
            vertex_b_length_n267_s12 <= vertex_b_length_n267_s11;
            vertex_n289_s12 <= vertex_n289_s11;
            vertex_ts_view_z_s12 <= vertex_ts_view_z_s11;
            vertex_ts_light0_z_s12 <= vertex_ts_light0_z_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // vertex.b_length.recip_root
    wire [0:-22] vertex_b_length_recip_root_n258 = recip_root_row[39:17]; // u23f22
    wire signed [-18:-34] vertex_b_length_recip_root_n259 = recip_root_row[16:0]; // s17f34

    reg signed [1:-14] normal_x_s13; // s16f14
    reg signed [1:-14] normal_y_s13; // s16f14
    reg signed [1:-14] normal_z_s13; // s16f14
    reg signed [1:-14] view_x_s13; // s16f14
    reg signed [1:-14] view_y_s13; // s16f14
    reg signed [1:-14] view_z_s13; // s16f14
    reg signed [1:-14] light0_x_s13; // s16f14
    reg signed [1:-14] light0_y_s13; // s16f14
    reg signed [1:-14] light0_z_s13; // s16f14
    reg primitive_zero_uv_s13; // u1f0
    reg primitive_mirrored_s13; // u1f0
    reg primitive_zero_area_s13; // u1f0
    reg vertex_parallel_s13; // u1f0
    reg vertex_degenerate_s13; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s13; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s13; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s13; // s18f17
    reg [3:0] vertex_b_length_n249_s13; // u4f0
    reg [0:-22] vertex_b_length_recip_root_n258_s13; // u23f22
    reg signed [-18:-34] vertex_b_length_recip_root_n259_s13; // s17f34
    reg [11:0] vertex_b_length_recip_root_n260_s13; // u12f0
    reg vertex_b_length_n267_s13; // u1f0
    reg vertex_n289_s13; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s13; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s13; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s13 <= normal_x_s12;
            normal_y_s13 <= normal_y_s12;
            normal_z_s13 <= normal_z_s12;
            view_x_s13 <= view_x_s12;
            view_y_s13 <= view_y_s12;
            view_z_s13 <= view_z_s12;
            light0_x_s13 <= light0_x_s12;
            light0_y_s13 <= light0_y_s12;
            light0_z_s13 <= light0_z_s12;
            primitive_zero_uv_s13 <= primitive_zero_uv_s12;
            primitive_mirrored_s13 <= primitive_mirrored_s12;
            primitive_zero_area_s13 <= primitive_zero_area_s12;
            vertex_parallel_s13 <= vertex_parallel_s12;
            vertex_degenerate_s13 <= vertex_degenerate_s12;
            vertex_b_norm_x_s13 <= vertex_b_norm_x_s12;
            vertex_b_norm_y_s13 <= vertex_b_norm_y_s12;
            vertex_b_norm_z_s13 <= vertex_b_norm_z_s12;
            vertex_b_length_n249_s13 <= vertex_b_length_n249_s12;
            vertex_b_length_recip_root_n258_s13 <= vertex_b_length_recip_root_n258;
            vertex_b_length_recip_root_n259_s13 <= vertex_b_length_recip_root_n259;
            vertex_b_length_recip_root_n260_s13 <= vertex_b_length_recip_root_n260_s12;
            vertex_b_length_n267_s13 <= vertex_b_length_n267_s12;
            vertex_n289_s13 <= vertex_n289_s12;
            vertex_ts_view_z_s13 <= vertex_ts_view_z_s12;
            vertex_ts_light0_z_s13 <= vertex_ts_light0_z_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // vertex.b_length.recip_root
    wire signed [-6:-34] vertex_b_length_recip_root_n261 = vertex_b_length_recip_root_n259_s13 * $signed({1'b0, vertex_b_length_recip_root_n260_s13}); // s29f34
    wire signed [2:-34] vertex_b_length_recip_root_n262 = {2'h0, vertex_b_length_recip_root_n258_s13, 12'h0} + {{8{vertex_b_length_recip_root_n261[-6]}}, vertex_b_length_recip_root_n261}; // s37f34

    reg signed [1:-14] normal_x_s14; // s16f14
    reg signed [1:-14] normal_y_s14; // s16f14
    reg signed [1:-14] normal_z_s14; // s16f14
    reg signed [1:-14] view_x_s14; // s16f14
    reg signed [1:-14] view_y_s14; // s16f14
    reg signed [1:-14] view_z_s14; // s16f14
    reg signed [1:-14] light0_x_s14; // s16f14
    reg signed [1:-14] light0_y_s14; // s16f14
    reg signed [1:-14] light0_z_s14; // s16f14
    reg primitive_zero_uv_s14; // u1f0
    reg primitive_mirrored_s14; // u1f0
    reg primitive_zero_area_s14; // u1f0
    reg vertex_parallel_s14; // u1f0
    reg vertex_degenerate_s14; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s14; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s14; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s14; // s18f17
    reg [3:0] vertex_b_length_n249_s14; // u4f0
    reg signed [2:-34] vertex_b_length_recip_root_n262_s14; // s37f34
    reg vertex_b_length_n267_s14; // u1f0
    reg vertex_n289_s14; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s14; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s14; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s14 <= normal_x_s13;
            normal_y_s14 <= normal_y_s13;
            normal_z_s14 <= normal_z_s13;
            view_x_s14 <= view_x_s13;
            view_y_s14 <= view_y_s13;
            view_z_s14 <= view_z_s13;
            light0_x_s14 <= light0_x_s13;
            light0_y_s14 <= light0_y_s13;
            light0_z_s14 <= light0_z_s13;
            primitive_zero_uv_s14 <= primitive_zero_uv_s13;
            primitive_mirrored_s14 <= primitive_mirrored_s13;
            primitive_zero_area_s14 <= primitive_zero_area_s13;
            vertex_parallel_s14 <= vertex_parallel_s13;
            vertex_degenerate_s14 <= vertex_degenerate_s13;
            vertex_b_norm_x_s14 <= vertex_b_norm_x_s13;
            vertex_b_norm_y_s14 <= vertex_b_norm_y_s13;
            vertex_b_norm_z_s14 <= vertex_b_norm_z_s13;
            vertex_b_length_n249_s14 <= vertex_b_length_n249_s13;
            vertex_b_length_recip_root_n262_s14 <= vertex_b_length_recip_root_n262;
            vertex_b_length_n267_s14 <= vertex_b_length_n267_s13;
            vertex_n289_s14 <= vertex_n289_s13;
            vertex_ts_view_z_s14 <= vertex_ts_view_z_s13;
            vertex_ts_light0_z_s14 <= vertex_ts_light0_z_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // vertex.b_length.recip_root
    wire signed [3:-34] vertex_b_length_recip_root_n263_sum = {vertex_b_length_recip_root_n262_s14[2], vertex_b_length_recip_root_n262_s14} + 38'h2000;
    wire signed [3:-20] vertex_b_length_recip_root_n263_cut = vertex_b_length_recip_root_n263_sum[3:-20];
    wire vertex_b_length_recip_root_n263_over = ~vertex_b_length_recip_root_n263_cut[3] & (|vertex_b_length_recip_root_n263_cut[2]);
    wire vertex_b_length_recip_root_n263_under = vertex_b_length_recip_root_n263_cut[3];
    wire [1:-20] vertex_b_length_recip_root_n263 = vertex_b_length_recip_root_n263_over ? 22'h3fffff : vertex_b_length_recip_root_n263_under ? 22'h0 : vertex_b_length_recip_root_n263_cut[1:-20]; // u22f20
    // vertex.b_length
    wire vertex_b_length_n264_past = 4'hb < vertex_b_length_n249_s14;
    wire [3:0] vertex_b_length_n264_count = vertex_b_length_n264_past ? 4'hb : vertex_b_length_n249_s14;
    wire [12:-20] vertex_b_length_n264 = {11'h0, vertex_b_length_recip_root_n263} << vertex_b_length_n264_count; // u33f20
    wire [11:-21] vertex_b_length_n265 = vertex_b_length_n264; // u33f21
    wire [11:-21] vertex_b_length_n268 = vertex_b_length_n267_s14 ? {9'h0, vertex_b_length_n266, 23'h0} : vertex_b_length_n265; // u33f21

    reg signed [1:-14] normal_x_s15; // s16f14
    reg signed [1:-14] normal_y_s15; // s16f14
    reg signed [1:-14] normal_z_s15; // s16f14
    reg signed [1:-14] view_x_s15; // s16f14
    reg signed [1:-14] view_y_s15; // s16f14
    reg signed [1:-14] view_z_s15; // s16f14
    reg signed [1:-14] light0_x_s15; // s16f14
    reg signed [1:-14] light0_y_s15; // s16f14
    reg signed [1:-14] light0_z_s15; // s16f14
    reg primitive_zero_uv_s15; // u1f0
    reg primitive_mirrored_s15; // u1f0
    reg primitive_zero_area_s15; // u1f0
    reg vertex_parallel_s15; // u1f0
    reg vertex_degenerate_s15; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s15; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s15; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s15; // s18f17
    reg [11:-21] vertex_b_length_n268_s15; // u33f21
    reg vertex_n289_s15; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s15; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s15; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s15 <= normal_x_s14;
            normal_y_s15 <= normal_y_s14;
            normal_z_s15 <= normal_z_s14;
            view_x_s15 <= view_x_s14;
            view_y_s15 <= view_y_s14;
            view_z_s15 <= view_z_s14;
            light0_x_s15 <= light0_x_s14;
            light0_y_s15 <= light0_y_s14;
            light0_z_s15 <= light0_z_s14;
            primitive_zero_uv_s15 <= primitive_zero_uv_s14;
            primitive_mirrored_s15 <= primitive_mirrored_s14;
            primitive_zero_area_s15 <= primitive_zero_area_s14;
            vertex_parallel_s15 <= vertex_parallel_s14;
            vertex_degenerate_s15 <= vertex_degenerate_s14;
            vertex_b_norm_x_s15 <= vertex_b_norm_x_s14;
            vertex_b_norm_y_s15 <= vertex_b_norm_y_s14;
            vertex_b_norm_z_s15 <= vertex_b_norm_z_s14;
            vertex_b_length_n268_s15 <= vertex_b_length_n268;
            vertex_n289_s15 <= vertex_n289_s14;
            vertex_ts_view_z_s15 <= vertex_ts_view_z_s14;
            vertex_ts_light0_z_s15 <= vertex_ts_light0_z_s14;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // vertex.b_length
    wire [12:-21] vertex_b_length_b_length_sum = {1'b0, vertex_b_length_n268_s15} + 34'h4;
    wire [12:-18] vertex_b_length_b_length_cut = vertex_b_length_b_length_sum[12:-18];
    wire vertex_b_length_b_length_over = |vertex_b_length_b_length_cut[12:2];
    wire [1:-18] vertex_b_length_b_length = vertex_b_length_b_length_over ? 20'hfffff : vertex_b_length_b_length_cut[1:-18]; // u20f18

    reg signed [1:-14] normal_x_s16; // s16f14
    reg signed [1:-14] normal_y_s16; // s16f14
    reg signed [1:-14] normal_z_s16; // s16f14
    reg signed [1:-14] view_x_s16; // s16f14
    reg signed [1:-14] view_y_s16; // s16f14
    reg signed [1:-14] view_z_s16; // s16f14
    reg signed [1:-14] light0_x_s16; // s16f14
    reg signed [1:-14] light0_y_s16; // s16f14
    reg signed [1:-14] light0_z_s16; // s16f14
    reg primitive_zero_uv_s16; // u1f0
    reg primitive_mirrored_s16; // u1f0
    reg primitive_zero_area_s16; // u1f0
    reg vertex_parallel_s16; // u1f0
    reg vertex_degenerate_s16; // u1f0
    reg signed [0:-17] vertex_b_norm_x_s16; // s18f17
    reg signed [0:-17] vertex_b_norm_y_s16; // s18f17
    reg signed [0:-17] vertex_b_norm_z_s16; // s18f17
    reg [1:-18] vertex_b_length_b_length_s16; // u20f18
    reg vertex_n289_s16; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s16; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s16; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s16 <= normal_x_s15;
            normal_y_s16 <= normal_y_s15;
            normal_z_s16 <= normal_z_s15;
            view_x_s16 <= view_x_s15;
            view_y_s16 <= view_y_s15;
            view_z_s16 <= view_z_s15;
            light0_x_s16 <= light0_x_s15;
            light0_y_s16 <= light0_y_s15;
            light0_z_s16 <= light0_z_s15;
            primitive_zero_uv_s16 <= primitive_zero_uv_s15;
            primitive_mirrored_s16 <= primitive_mirrored_s15;
            primitive_zero_area_s16 <= primitive_zero_area_s15;
            vertex_parallel_s16 <= vertex_parallel_s15;
            vertex_degenerate_s16 <= vertex_degenerate_s15;
            vertex_b_norm_x_s16 <= vertex_b_norm_x_s15;
            vertex_b_norm_y_s16 <= vertex_b_norm_y_s15;
            vertex_b_norm_z_s16 <= vertex_b_norm_z_s15;
            vertex_b_length_b_length_s16 <= vertex_b_length_b_length;
            vertex_n289_s16 <= vertex_n289_s15;
            vertex_ts_view_z_s16 <= vertex_ts_view_z_s15;
            vertex_ts_light0_z_s16 <= vertex_ts_light0_z_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // vertex
    wire signed [2:-35] vertex_n270 = vertex_b_norm_x_s16 * $signed({1'b0, vertex_b_length_b_length_s16}); // s38f35
    wire signed [2:-35] vertex_n272 = vertex_b_norm_y_s16 * $signed({1'b0, vertex_b_length_b_length_s16}); // s38f35
    wire signed [2:-35] vertex_n274 = vertex_b_norm_z_s16 * $signed({1'b0, vertex_b_length_b_length_s16}); // s38f35

    reg signed [1:-14] normal_x_s17; // s16f14
    reg signed [1:-14] normal_y_s17; // s16f14
    reg signed [1:-14] normal_z_s17; // s16f14
    reg signed [1:-14] view_x_s17; // s16f14
    reg signed [1:-14] view_y_s17; // s16f14
    reg signed [1:-14] view_z_s17; // s16f14
    reg signed [1:-14] light0_x_s17; // s16f14
    reg signed [1:-14] light0_y_s17; // s16f14
    reg signed [1:-14] light0_z_s17; // s16f14
    reg primitive_zero_uv_s17; // u1f0
    reg primitive_mirrored_s17; // u1f0
    reg primitive_zero_area_s17; // u1f0
    reg vertex_parallel_s17; // u1f0
    reg vertex_degenerate_s17; // u1f0
    reg signed [2:-35] vertex_n270_s17; // s38f35
    reg signed [2:-35] vertex_n272_s17; // s38f35
    reg signed [2:-35] vertex_n274_s17; // s38f35
    reg vertex_n289_s17; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s17; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s17; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s17 <= normal_x_s16;
            normal_y_s17 <= normal_y_s16;
            normal_z_s17 <= normal_z_s16;
            view_x_s17 <= view_x_s16;
            view_y_s17 <= view_y_s16;
            view_z_s17 <= view_z_s16;
            light0_x_s17 <= light0_x_s16;
            light0_y_s17 <= light0_y_s16;
            light0_z_s17 <= light0_z_s16;
            primitive_zero_uv_s17 <= primitive_zero_uv_s16;
            primitive_mirrored_s17 <= primitive_mirrored_s16;
            primitive_zero_area_s17 <= primitive_zero_area_s16;
            vertex_parallel_s17 <= vertex_parallel_s16;
            vertex_degenerate_s17 <= vertex_degenerate_s16;
            vertex_n270_s17 <= vertex_n270;
            vertex_n272_s17 <= vertex_n272;
            vertex_n274_s17 <= vertex_n274;
            vertex_n289_s17 <= vertex_n289_s16;
            vertex_ts_view_z_s17 <= vertex_ts_view_z_s16;
            vertex_ts_light0_z_s17 <= vertex_ts_light0_z_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // vertex
    wire signed [3:-35] vertex_b_unit_x_sum = {vertex_n270_s17[2], vertex_n270_s17} + 39'h40000;
    wire signed [3:-16] vertex_b_unit_x_cut = vertex_b_unit_x_sum[3:-16];
    wire vertex_b_unit_x_over = ~vertex_b_unit_x_cut[3] & (|vertex_b_unit_x_cut[2:1]);
    wire vertex_b_unit_x_under = vertex_b_unit_x_cut[3] & ~(&vertex_b_unit_x_cut[2:1]);
    wire signed [1:-16] vertex_b_unit_x = vertex_b_unit_x_over ? 18'h1ffff : vertex_b_unit_x_under ? 18'h20000 : vertex_b_unit_x_cut[1:-16]; // s18f16
    wire signed [3:-35] vertex_b_unit_y_sum = {vertex_n272_s17[2], vertex_n272_s17} + 39'h40000;
    wire signed [3:-16] vertex_b_unit_y_cut = vertex_b_unit_y_sum[3:-16];
    wire vertex_b_unit_y_over = ~vertex_b_unit_y_cut[3] & (|vertex_b_unit_y_cut[2:1]);
    wire vertex_b_unit_y_under = vertex_b_unit_y_cut[3] & ~(&vertex_b_unit_y_cut[2:1]);
    wire signed [1:-16] vertex_b_unit_y = vertex_b_unit_y_over ? 18'h1ffff : vertex_b_unit_y_under ? 18'h20000 : vertex_b_unit_y_cut[1:-16]; // s18f16
    wire signed [3:-35] vertex_b_unit_z_sum = {vertex_n274_s17[2], vertex_n274_s17} + 39'h40000;
    wire signed [3:-16] vertex_b_unit_z_cut = vertex_b_unit_z_sum[3:-16];
    wire vertex_b_unit_z_over = ~vertex_b_unit_z_cut[3] & (|vertex_b_unit_z_cut[2:1]);
    wire vertex_b_unit_z_under = vertex_b_unit_z_cut[3] & ~(&vertex_b_unit_z_cut[2:1]);
    wire signed [1:-16] vertex_b_unit_z = vertex_b_unit_z_over ? 18'h1ffff : vertex_b_unit_z_under ? 18'h20000 : vertex_b_unit_z_cut[1:-16]; // s18f16

    reg signed [1:-14] normal_x_s18; // s16f14
    reg signed [1:-14] normal_y_s18; // s16f14
    reg signed [1:-14] normal_z_s18; // s16f14
    reg signed [1:-14] view_x_s18; // s16f14
    reg signed [1:-14] view_y_s18; // s16f14
    reg signed [1:-14] view_z_s18; // s16f14
    reg signed [1:-14] light0_x_s18; // s16f14
    reg signed [1:-14] light0_y_s18; // s16f14
    reg signed [1:-14] light0_z_s18; // s16f14
    reg primitive_zero_uv_s18; // u1f0
    reg primitive_mirrored_s18; // u1f0
    reg primitive_zero_area_s18; // u1f0
    reg vertex_parallel_s18; // u1f0
    reg vertex_degenerate_s18; // u1f0
    reg signed [1:-16] vertex_b_unit_x_s18; // s18f16
    reg signed [1:-16] vertex_b_unit_y_s18; // s18f16
    reg signed [1:-16] vertex_b_unit_z_s18; // s18f16
    reg vertex_n289_s18; // u1f0
    reg signed [4:-14] vertex_ts_view_z_s18; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s18; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s18 <= normal_x_s17;
            normal_y_s18 <= normal_y_s17;
            normal_z_s18 <= normal_z_s17;
            view_x_s18 <= view_x_s17;
            view_y_s18 <= view_y_s17;
            view_z_s18 <= view_z_s17;
            light0_x_s18 <= light0_x_s17;
            light0_y_s18 <= light0_y_s17;
            light0_z_s18 <= light0_z_s17;
            primitive_zero_uv_s18 <= primitive_zero_uv_s17;
            primitive_mirrored_s18 <= primitive_mirrored_s17;
            primitive_zero_area_s18 <= primitive_zero_area_s17;
            vertex_parallel_s18 <= vertex_parallel_s17;
            vertex_degenerate_s18 <= vertex_degenerate_s17;
            vertex_b_unit_x_s18 <= vertex_b_unit_x;
            vertex_b_unit_y_s18 <= vertex_b_unit_y;
            vertex_b_unit_z_s18 <= vertex_b_unit_z;
            vertex_n289_s18 <= vertex_n289_s17;
            vertex_ts_view_z_s18 <= vertex_ts_view_z_s17;
            vertex_ts_light0_z_s18 <= vertex_ts_light0_z_s17;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // vertex.b_cross_n
    wire signed [3:-30] vertex_b_cross_n_n276 = vertex_b_unit_y_s18 * normal_z_s18; // s34f30
    wire signed [3:-30] vertex_b_cross_n_n277 = vertex_b_unit_z_s18 * normal_y_s18; // s34f30
    wire signed [3:-30] vertex_b_cross_n_n279 = vertex_b_unit_z_s18 * normal_x_s18; // s34f30
    wire signed [3:-30] vertex_b_cross_n_n280 = vertex_b_unit_x_s18 * normal_z_s18; // s34f30
    wire signed [3:-30] vertex_b_cross_n_n282 = vertex_b_unit_x_s18 * normal_y_s18; // s34f30
    wire signed [3:-30] vertex_b_cross_n_n283 = vertex_b_unit_y_s18 * normal_x_s18; // s34f30
    // vertex.ts_view_b
    wire signed [3:-30] vertex_ts_view_b_n305 = vertex_b_unit_x_s18 * view_x_s18; // s34f30
    wire signed [3:-30] vertex_ts_view_b_n306 = vertex_b_unit_y_s18 * view_y_s18; // s34f30
    wire signed [3:-30] vertex_ts_view_b_n307 = vertex_b_unit_z_s18 * view_z_s18; // s34f30
    // vertex.ts_light0_b
    wire signed [3:-30] vertex_ts_light0_b_n323 = vertex_b_unit_x_s18 * light0_x_s18; // s34f30
    wire signed [3:-30] vertex_ts_light0_b_n324 = vertex_b_unit_y_s18 * light0_y_s18; // s34f30
    wire signed [3:-30] vertex_ts_light0_b_n325 = vertex_b_unit_z_s18 * light0_z_s18; // s34f30

    reg signed [1:-14] normal_x_s19; // s16f14
    reg signed [1:-14] normal_y_s19; // s16f14
    reg signed [1:-14] normal_z_s19; // s16f14
    reg signed [1:-14] view_x_s19; // s16f14
    reg signed [1:-14] view_y_s19; // s16f14
    reg signed [1:-14] view_z_s19; // s16f14
    reg signed [1:-14] light0_x_s19; // s16f14
    reg signed [1:-14] light0_y_s19; // s16f14
    reg signed [1:-14] light0_z_s19; // s16f14
    reg primitive_zero_uv_s19; // u1f0
    reg primitive_mirrored_s19; // u1f0
    reg primitive_zero_area_s19; // u1f0
    reg vertex_parallel_s19; // u1f0
    reg vertex_degenerate_s19; // u1f0
    reg signed [1:-16] vertex_b_unit_x_s19; // s18f16
    reg signed [1:-16] vertex_b_unit_y_s19; // s18f16
    reg signed [1:-16] vertex_b_unit_z_s19; // s18f16
    reg signed [3:-30] vertex_b_cross_n_n276_s19; // s34f30
    reg signed [3:-30] vertex_b_cross_n_n277_s19; // s34f30
    reg signed [3:-30] vertex_b_cross_n_n279_s19; // s34f30
    reg signed [3:-30] vertex_b_cross_n_n280_s19; // s34f30
    reg signed [3:-30] vertex_b_cross_n_n282_s19; // s34f30
    reg signed [3:-30] vertex_b_cross_n_n283_s19; // s34f30
    reg vertex_n289_s19; // u1f0
    reg signed [3:-30] vertex_ts_view_b_n305_s19; // s34f30
    reg signed [3:-30] vertex_ts_view_b_n306_s19; // s34f30
    reg signed [3:-30] vertex_ts_view_b_n307_s19; // s34f30
    reg signed [4:-14] vertex_ts_view_z_s19; // s19f14
    reg signed [3:-30] vertex_ts_light0_b_n323_s19; // s34f30
    reg signed [3:-30] vertex_ts_light0_b_n324_s19; // s34f30
    reg signed [3:-30] vertex_ts_light0_b_n325_s19; // s34f30
    reg signed [4:-14] vertex_ts_light0_z_s19; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s19 <= normal_x_s18;
            normal_y_s19 <= normal_y_s18;
            normal_z_s19 <= normal_z_s18;
            view_x_s19 <= view_x_s18;
            view_y_s19 <= view_y_s18;
            view_z_s19 <= view_z_s18;
            light0_x_s19 <= light0_x_s18;
            light0_y_s19 <= light0_y_s18;
            light0_z_s19 <= light0_z_s18;
            primitive_zero_uv_s19 <= primitive_zero_uv_s18;
            primitive_mirrored_s19 <= primitive_mirrored_s18;
            primitive_zero_area_s19 <= primitive_zero_area_s18;
            vertex_parallel_s19 <= vertex_parallel_s18;
            vertex_degenerate_s19 <= vertex_degenerate_s18;
            vertex_b_unit_x_s19 <= vertex_b_unit_x_s18;
            vertex_b_unit_y_s19 <= vertex_b_unit_y_s18;
            vertex_b_unit_z_s19 <= vertex_b_unit_z_s18;
            vertex_b_cross_n_n276_s19 <= vertex_b_cross_n_n276;
            vertex_b_cross_n_n277_s19 <= vertex_b_cross_n_n277;
            vertex_b_cross_n_n279_s19 <= vertex_b_cross_n_n279;
            vertex_b_cross_n_n280_s19 <= vertex_b_cross_n_n280;
            vertex_b_cross_n_n282_s19 <= vertex_b_cross_n_n282;
            vertex_b_cross_n_n283_s19 <= vertex_b_cross_n_n283;
            vertex_n289_s19 <= vertex_n289_s18;
            vertex_ts_view_b_n305_s19 <= vertex_ts_view_b_n305;
            vertex_ts_view_b_n306_s19 <= vertex_ts_view_b_n306;
            vertex_ts_view_b_n307_s19 <= vertex_ts_view_b_n307;
            vertex_ts_view_z_s19 <= vertex_ts_view_z_s18;
            vertex_ts_light0_b_n323_s19 <= vertex_ts_light0_b_n323;
            vertex_ts_light0_b_n324_s19 <= vertex_ts_light0_b_n324;
            vertex_ts_light0_b_n325_s19 <= vertex_ts_light0_b_n325;
            vertex_ts_light0_z_s19 <= vertex_ts_light0_z_s18;
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // vertex.b_cross_n
    wire signed [4:-30] vertex_b_cross_n_n278 = {vertex_b_cross_n_n276_s19[3], vertex_b_cross_n_n276_s19} - {vertex_b_cross_n_n277_s19[3], vertex_b_cross_n_n277_s19}; // s35f30
    wire signed [4:-30] vertex_b_cross_n_n281 = {vertex_b_cross_n_n279_s19[3], vertex_b_cross_n_n279_s19} - {vertex_b_cross_n_n280_s19[3], vertex_b_cross_n_n280_s19}; // s35f30
    wire signed [4:-30] vertex_b_cross_n_n284 = {vertex_b_cross_n_n282_s19[3], vertex_b_cross_n_n282_s19} - {vertex_b_cross_n_n283_s19[3], vertex_b_cross_n_n283_s19}; // s35f30
    // vertex
    wire signed [5:-30] vertex_n285_sum = {vertex_b_cross_n_n278[4], vertex_b_cross_n_n278} + 36'h2000;
    wire signed [5:-16] vertex_n285_cut = vertex_n285_sum[5:-16];
    wire vertex_n285_over = ~vertex_n285_cut[5] & (|vertex_n285_cut[4:2]);
    wire vertex_n285_under = vertex_n285_cut[5] & ~(&vertex_n285_cut[4:2]);
    wire signed [2:-16] vertex_n285 = vertex_n285_over ? 19'h3ffff : vertex_n285_under ? 19'h40000 : vertex_n285_cut[2:-16]; // s19f16
    wire signed [5:-30] vertex_n286_sum = {vertex_b_cross_n_n281[4], vertex_b_cross_n_n281} + 36'h2000;
    wire signed [5:-16] vertex_n286_cut = vertex_n286_sum[5:-16];
    wire vertex_n286_over = ~vertex_n286_cut[5] & (|vertex_n286_cut[4:2]);
    wire vertex_n286_under = vertex_n286_cut[5] & ~(&vertex_n286_cut[4:2]);
    wire signed [2:-16] vertex_n286 = vertex_n286_over ? 19'h3ffff : vertex_n286_under ? 19'h40000 : vertex_n286_cut[2:-16]; // s19f16
    wire signed [5:-30] vertex_n287_sum = {vertex_b_cross_n_n284[4], vertex_b_cross_n_n284} + 36'h2000;
    wire signed [5:-16] vertex_n287_cut = vertex_n287_sum[5:-16];
    wire vertex_n287_over = ~vertex_n287_cut[5] & (|vertex_n287_cut[4:2]);
    wire vertex_n287_under = vertex_n287_cut[5] & ~(&vertex_n287_cut[4:2]);
    wire signed [2:-16] vertex_n287 = vertex_n287_over ? 19'h3ffff : vertex_n287_under ? 19'h40000 : vertex_n287_cut[2:-16]; // s19f16
    wire signed [3:-16] vertex_n290 = -{vertex_n285[2], vertex_n285}; // s20f16
    wire signed [3:-16] vertex_n293 = -{vertex_n286[2], vertex_n286}; // s20f16
    wire signed [3:-16] vertex_n296 = -{vertex_n287[2], vertex_n287}; // s20f16
    // vertex.ts_view_b
    wire signed [4:-30] vertex_ts_view_b_n308 = {vertex_ts_view_b_n305_s19[3], vertex_ts_view_b_n305_s19} + {vertex_ts_view_b_n306_s19[3], vertex_ts_view_b_n306_s19}; // s35f30
    wire signed [5:-30] vertex_ts_view_b_n309 = {vertex_ts_view_b_n308[4], vertex_ts_view_b_n308} + {{2{vertex_ts_view_b_n307_s19[3]}}, vertex_ts_view_b_n307_s19}; // s36f30
    // vertex.ts_light0_b
    wire signed [4:-30] vertex_ts_light0_b_n326 = {vertex_ts_light0_b_n323_s19[3], vertex_ts_light0_b_n323_s19} + {vertex_ts_light0_b_n324_s19[3], vertex_ts_light0_b_n324_s19}; // s35f30
    wire signed [5:-30] vertex_ts_light0_b_n327 = {vertex_ts_light0_b_n326[4], vertex_ts_light0_b_n326} + {{2{vertex_ts_light0_b_n325_s19[3]}}, vertex_ts_light0_b_n325_s19}; // s36f30

    reg signed [1:-14] normal_x_s20; // s16f14
    reg signed [1:-14] normal_y_s20; // s16f14
    reg signed [1:-14] normal_z_s20; // s16f14
    reg signed [1:-14] view_x_s20; // s16f14
    reg signed [1:-14] view_y_s20; // s16f14
    reg signed [1:-14] view_z_s20; // s16f14
    reg signed [1:-14] light0_x_s20; // s16f14
    reg signed [1:-14] light0_y_s20; // s16f14
    reg signed [1:-14] light0_z_s20; // s16f14
    reg primitive_zero_uv_s20; // u1f0
    reg primitive_mirrored_s20; // u1f0
    reg primitive_zero_area_s20; // u1f0
    reg vertex_parallel_s20; // u1f0
    reg vertex_degenerate_s20; // u1f0
    reg signed [1:-16] vertex_b_unit_x_s20; // s18f16
    reg signed [1:-16] vertex_b_unit_y_s20; // s18f16
    reg signed [1:-16] vertex_b_unit_z_s20; // s18f16
    reg signed [2:-16] vertex_n285_s20; // s19f16
    reg signed [2:-16] vertex_n286_s20; // s19f16
    reg signed [2:-16] vertex_n287_s20; // s19f16
    reg vertex_n289_s20; // u1f0
    reg signed [3:-16] vertex_n290_s20; // s20f16
    reg signed [3:-16] vertex_n293_s20; // s20f16
    reg signed [3:-16] vertex_n296_s20; // s20f16
    reg signed [5:-30] vertex_ts_view_b_n309_s20; // s36f30
    reg signed [4:-14] vertex_ts_view_z_s20; // s19f14
    reg signed [5:-30] vertex_ts_light0_b_n327_s20; // s36f30
    reg signed [4:-14] vertex_ts_light0_z_s20; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s20 <= normal_x_s19;
            normal_y_s20 <= normal_y_s19;
            normal_z_s20 <= normal_z_s19;
            view_x_s20 <= view_x_s19;
            view_y_s20 <= view_y_s19;
            view_z_s20 <= view_z_s19;
            light0_x_s20 <= light0_x_s19;
            light0_y_s20 <= light0_y_s19;
            light0_z_s20 <= light0_z_s19;
            primitive_zero_uv_s20 <= primitive_zero_uv_s19;
            primitive_mirrored_s20 <= primitive_mirrored_s19;
            primitive_zero_area_s20 <= primitive_zero_area_s19;
            vertex_parallel_s20 <= vertex_parallel_s19;
            vertex_degenerate_s20 <= vertex_degenerate_s19;
            vertex_b_unit_x_s20 <= vertex_b_unit_x_s19;
            vertex_b_unit_y_s20 <= vertex_b_unit_y_s19;
            vertex_b_unit_z_s20 <= vertex_b_unit_z_s19;
            vertex_n285_s20 <= vertex_n285;
            vertex_n286_s20 <= vertex_n286;
            vertex_n287_s20 <= vertex_n287;
            vertex_n289_s20 <= vertex_n289_s19;
            vertex_n290_s20 <= vertex_n290;
            vertex_n293_s20 <= vertex_n293;
            vertex_n296_s20 <= vertex_n296;
            vertex_ts_view_b_n309_s20 <= vertex_ts_view_b_n309;
            vertex_ts_view_z_s20 <= vertex_ts_view_z_s19;
            vertex_ts_light0_b_n327_s20 <= vertex_ts_light0_b_n327;
            vertex_ts_light0_z_s20 <= vertex_ts_light0_z_s19;
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // vertex
    wire signed [3:-16] vertex_n291 = vertex_n289_s20 ? vertex_n290_s20 : {vertex_n285_s20[2], vertex_n285_s20}; // s20f16
    wire vertex_n292_over = ~vertex_n291[3] & (|vertex_n291[2]);
    wire vertex_n292_under = vertex_n291[3] & ~(&vertex_n291[2]);
    wire signed [2:-16] vertex_n292 = vertex_n292_over ? 19'h3ffff : vertex_n292_under ? 19'h40000 : vertex_n291[2:-16]; // s19f16
    wire signed [3:-16] vertex_n294 = vertex_n289_s20 ? vertex_n293_s20 : {vertex_n286_s20[2], vertex_n286_s20}; // s20f16
    wire vertex_n295_over = ~vertex_n294[3] & (|vertex_n294[2]);
    wire vertex_n295_under = vertex_n294[3] & ~(&vertex_n294[2]);
    wire signed [2:-16] vertex_n295 = vertex_n295_over ? 19'h3ffff : vertex_n295_under ? 19'h40000 : vertex_n294[2:-16]; // s19f16
    wire signed [3:-16] vertex_n297 = vertex_n289_s20 ? vertex_n296_s20 : {vertex_n287_s20[2], vertex_n287_s20}; // s20f16
    wire vertex_n298_over = ~vertex_n297[3] & (|vertex_n297[2]);
    wire vertex_n298_under = vertex_n297[3] & ~(&vertex_n297[2]);
    wire signed [2:-16] vertex_n298 = vertex_n298_over ? 19'h3ffff : vertex_n298_under ? 19'h40000 : vertex_n297[2:-16]; // s19f16
    // vertex.ts_view_t
    wire signed [4:-30] vertex_ts_view_t_n299 = vertex_n292 * view_x_s20; // s35f30
    wire signed [4:-30] vertex_ts_view_t_n300 = vertex_n295 * view_y_s20; // s35f30
    wire signed [4:-30] vertex_ts_view_t_n301 = vertex_n298 * view_z_s20; // s35f30
    // vertex
    wire signed [6:-30] vertex_ts_view_y_sum = {vertex_ts_view_b_n309_s20[5], vertex_ts_view_b_n309_s20} + 37'h8000;
    wire signed [6:-14] vertex_ts_view_y_cut = vertex_ts_view_y_sum[6:-14];
    wire vertex_ts_view_y_over = ~vertex_ts_view_y_cut[6] & (|vertex_ts_view_y_cut[5:4]);
    wire vertex_ts_view_y_under = vertex_ts_view_y_cut[6] & ~(&vertex_ts_view_y_cut[5:4]);
    wire signed [4:-14] vertex_ts_view_y = vertex_ts_view_y_over ? 19'h3ffff : vertex_ts_view_y_under ? 19'h40000 : vertex_ts_view_y_cut[4:-14]; // s19f14
    // vertex.ts_light0_t
    wire signed [4:-30] vertex_ts_light0_t_n317 = vertex_n292 * light0_x_s20; // s35f30
    wire signed [4:-30] vertex_ts_light0_t_n318 = vertex_n295 * light0_y_s20; // s35f30
    wire signed [4:-30] vertex_ts_light0_t_n319 = vertex_n298 * light0_z_s20; // s35f30
    // vertex
    wire signed [6:-30] vertex_ts_light0_y_sum = {vertex_ts_light0_b_n327_s20[5], vertex_ts_light0_b_n327_s20} + 37'h8000;
    wire signed [6:-14] vertex_ts_light0_y_cut = vertex_ts_light0_y_sum[6:-14];
    wire vertex_ts_light0_y_over = ~vertex_ts_light0_y_cut[6] & (|vertex_ts_light0_y_cut[5:4]);
    wire vertex_ts_light0_y_under = vertex_ts_light0_y_cut[6] & ~(&vertex_ts_light0_y_cut[5:4]);
    wire signed [4:-14] vertex_ts_light0_y = vertex_ts_light0_y_over ? 19'h3ffff : vertex_ts_light0_y_under ? 19'h40000 : vertex_ts_light0_y_cut[4:-14]; // s19f14

    reg signed [1:-14] normal_x_s21; // s16f14
    reg signed [1:-14] normal_y_s21; // s16f14
    reg signed [1:-14] normal_z_s21; // s16f14
    reg primitive_zero_uv_s21; // u1f0
    reg primitive_mirrored_s21; // u1f0
    reg primitive_zero_area_s21; // u1f0
    reg vertex_parallel_s21; // u1f0
    reg vertex_degenerate_s21; // u1f0
    reg signed [1:-16] vertex_b_unit_x_s21; // s18f16
    reg signed [1:-16] vertex_b_unit_y_s21; // s18f16
    reg signed [1:-16] vertex_b_unit_z_s21; // s18f16
    reg signed [2:-16] vertex_n292_s21; // s19f16
    reg signed [2:-16] vertex_n295_s21; // s19f16
    reg signed [2:-16] vertex_n298_s21; // s19f16
    reg signed [4:-30] vertex_ts_view_t_n299_s21; // s35f30
    reg signed [4:-30] vertex_ts_view_t_n300_s21; // s35f30
    reg signed [4:-30] vertex_ts_view_t_n301_s21; // s35f30
    reg signed [4:-14] vertex_ts_view_y_s21; // s19f14
    reg signed [4:-14] vertex_ts_view_z_s21; // s19f14
    reg signed [4:-30] vertex_ts_light0_t_n317_s21; // s35f30
    reg signed [4:-30] vertex_ts_light0_t_n318_s21; // s35f30
    reg signed [4:-30] vertex_ts_light0_t_n319_s21; // s35f30
    reg signed [4:-14] vertex_ts_light0_y_s21; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s21; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s21 <= normal_x_s20;
            normal_y_s21 <= normal_y_s20;
            normal_z_s21 <= normal_z_s20;
            primitive_zero_uv_s21 <= primitive_zero_uv_s20;
            primitive_mirrored_s21 <= primitive_mirrored_s20;
            primitive_zero_area_s21 <= primitive_zero_area_s20;
            vertex_parallel_s21 <= vertex_parallel_s20;
            vertex_degenerate_s21 <= vertex_degenerate_s20;
            vertex_b_unit_x_s21 <= vertex_b_unit_x_s20;
            vertex_b_unit_y_s21 <= vertex_b_unit_y_s20;
            vertex_b_unit_z_s21 <= vertex_b_unit_z_s20;
            vertex_n292_s21 <= vertex_n292;
            vertex_n295_s21 <= vertex_n295;
            vertex_n298_s21 <= vertex_n298;
            vertex_ts_view_t_n299_s21 <= vertex_ts_view_t_n299;
            vertex_ts_view_t_n300_s21 <= vertex_ts_view_t_n300;
            vertex_ts_view_t_n301_s21 <= vertex_ts_view_t_n301;
            vertex_ts_view_y_s21 <= vertex_ts_view_y;
            vertex_ts_view_z_s21 <= vertex_ts_view_z_s20;
            vertex_ts_light0_t_n317_s21 <= vertex_ts_light0_t_n317;
            vertex_ts_light0_t_n318_s21 <= vertex_ts_light0_t_n318;
            vertex_ts_light0_t_n319_s21 <= vertex_ts_light0_t_n319;
            vertex_ts_light0_y_s21 <= vertex_ts_light0_y;
            vertex_ts_light0_z_s21 <= vertex_ts_light0_z_s20;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;

    // ---- stage 21 ----
    // vertex.ts_view_t
    wire signed [5:-30] vertex_ts_view_t_n302 = {vertex_ts_view_t_n299_s21[4], vertex_ts_view_t_n299_s21} + {vertex_ts_view_t_n300_s21[4], vertex_ts_view_t_n300_s21}; // s36f30
    wire signed [6:-30] vertex_ts_view_t_n303 = {vertex_ts_view_t_n302[5], vertex_ts_view_t_n302} + {{2{vertex_ts_view_t_n301_s21[4]}}, vertex_ts_view_t_n301_s21}; // s37f30
    // vertex.ts_light0_t
    wire signed [5:-30] vertex_ts_light0_t_n320 = {vertex_ts_light0_t_n317_s21[4], vertex_ts_light0_t_n317_s21} + {vertex_ts_light0_t_n318_s21[4], vertex_ts_light0_t_n318_s21}; // s36f30
    wire signed [6:-30] vertex_ts_light0_t_n321 = {vertex_ts_light0_t_n320[5], vertex_ts_light0_t_n320} + {{2{vertex_ts_light0_t_n319_s21[4]}}, vertex_ts_light0_t_n319_s21}; // s37f30

    reg signed [1:-14] normal_x_s22; // s16f14
    reg signed [1:-14] normal_y_s22; // s16f14
    reg signed [1:-14] normal_z_s22; // s16f14
    reg primitive_zero_uv_s22; // u1f0
    reg primitive_mirrored_s22; // u1f0
    reg primitive_zero_area_s22; // u1f0
    reg vertex_parallel_s22; // u1f0
    reg vertex_degenerate_s22; // u1f0
    reg signed [1:-16] vertex_b_unit_x_s22; // s18f16
    reg signed [1:-16] vertex_b_unit_y_s22; // s18f16
    reg signed [1:-16] vertex_b_unit_z_s22; // s18f16
    reg signed [2:-16] vertex_n292_s22; // s19f16
    reg signed [2:-16] vertex_n295_s22; // s19f16
    reg signed [2:-16] vertex_n298_s22; // s19f16
    reg signed [6:-30] vertex_ts_view_t_n303_s22; // s37f30
    reg signed [4:-14] vertex_ts_view_y_s22; // s19f14
    reg signed [4:-14] vertex_ts_view_z_s22; // s19f14
    reg signed [6:-30] vertex_ts_light0_t_n321_s22; // s37f30
    reg signed [4:-14] vertex_ts_light0_y_s22; // s19f14
    reg signed [4:-14] vertex_ts_light0_z_s22; // s19f14
    always @(posedge clk)
        if (ce) begin
            normal_x_s22 <= normal_x_s21;
            normal_y_s22 <= normal_y_s21;
            normal_z_s22 <= normal_z_s21;
            primitive_zero_uv_s22 <= primitive_zero_uv_s21;
            primitive_mirrored_s22 <= primitive_mirrored_s21;
            primitive_zero_area_s22 <= primitive_zero_area_s21;
            vertex_parallel_s22 <= vertex_parallel_s21;
            vertex_degenerate_s22 <= vertex_degenerate_s21;
            vertex_b_unit_x_s22 <= vertex_b_unit_x_s21;
            vertex_b_unit_y_s22 <= vertex_b_unit_y_s21;
            vertex_b_unit_z_s22 <= vertex_b_unit_z_s21;
            vertex_n292_s22 <= vertex_n292_s21;
            vertex_n295_s22 <= vertex_n295_s21;
            vertex_n298_s22 <= vertex_n298_s21;
            vertex_ts_view_t_n303_s22 <= vertex_ts_view_t_n303;
            vertex_ts_view_y_s22 <= vertex_ts_view_y_s21;
            vertex_ts_view_z_s22 <= vertex_ts_view_z_s21;
            vertex_ts_light0_t_n321_s22 <= vertex_ts_light0_t_n321;
            vertex_ts_light0_y_s22 <= vertex_ts_light0_y_s21;
            vertex_ts_light0_z_s22 <= vertex_ts_light0_z_s21;
        end
    reg valid_s22;
    always @(posedge clk)
        if (rst) valid_s22 <= 1'b0;
        else if (ce) valid_s22 <= valid_s21;

    // ---- stage 22 ----
    // vertex
    wire signed [7:-30] vertex_ts_view_x_sum = {vertex_ts_view_t_n303_s22[6], vertex_ts_view_t_n303_s22} + 38'h8000;
    wire signed [7:-14] vertex_ts_view_x_cut = vertex_ts_view_x_sum[7:-14];
    wire vertex_ts_view_x_over = ~vertex_ts_view_x_cut[7] & (|vertex_ts_view_x_cut[6:4]);
    wire vertex_ts_view_x_under = vertex_ts_view_x_cut[7] & ~(&vertex_ts_view_x_cut[6:4]);
    wire signed [4:-14] vertex_ts_view_x = vertex_ts_view_x_over ? 19'h3ffff : vertex_ts_view_x_under ? 19'h40000 : vertex_ts_view_x_cut[4:-14]; // s19f14
    wire signed [7:-30] vertex_ts_light0_x_sum = {vertex_ts_light0_t_n321_s22[6], vertex_ts_light0_t_n321_s22} + 38'h8000;
    wire signed [7:-14] vertex_ts_light0_x_cut = vertex_ts_light0_x_sum[7:-14];
    wire vertex_ts_light0_x_over = ~vertex_ts_light0_x_cut[7] & (|vertex_ts_light0_x_cut[6:4]);
    wire vertex_ts_light0_x_under = vertex_ts_light0_x_cut[7] & ~(&vertex_ts_light0_x_cut[6:4]);
    wire signed [4:-14] vertex_ts_light0_x = vertex_ts_light0_x_over ? 19'h3ffff : vertex_ts_light0_x_under ? 19'h40000 : vertex_ts_light0_x_cut[4:-14]; // s19f14

    always @(posedge clk)
        if (ce) begin
            n_x <= normal_x_s22;
            n_y <= normal_y_s22;
            n_z <= normal_z_s22;
            zero_uv <= primitive_zero_uv_s22;
            mirrored <= primitive_mirrored_s22;
            zero_area <= primitive_zero_area_s22;
            parallel <= vertex_parallel_s22;
            degenerate <= vertex_degenerate_s22;
            b_x <= vertex_b_unit_x_s22;
            b_y <= vertex_b_unit_y_s22;
            b_z <= vertex_b_unit_z_s22;
            t_x <= vertex_n292_s22;
            t_y <= vertex_n295_s22;
            t_z <= vertex_n298_s22;
            ts_view_x <= vertex_ts_view_x;
            ts_view_y <= vertex_ts_view_y_s22;
            ts_view_z <= vertex_ts_view_z_s22;
            ts_light0_x <= vertex_ts_light0_x;
            ts_light0_y <= vertex_ts_light0_y_s22;
            ts_light0_z <= vertex_ts_light0_z_s22;
        end
    reg valid_s23;
    always @(posedge clk)
        if (rst) valid_s23 <= 1'b0;
        else if (ce) valid_s23 <= valid_s22;
    assign valid_out = valid_s23;

    // ---- stage 23 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        vertex_ts_view_z_sum[-15:-28],
        vertex_ts_light0_z_sum[-15:-28],
        vertex_b_n133[50:0],
        vertex_b_norm_x_sum[-18:-52],
        vertex_b_norm_y_sum[-18:-52],
        vertex_b_norm_z_sum[-18:-52],
        vertex_b_length_square_sum[-21:-34],
        vertex_b_length_n246[1:0],
        vertex_b_length_n252[2],
        vertex_b_length_recip_root_n263_sum[-21:-34],
        vertex_b_length_b_length_sum[-19:-21],
        vertex_b_unit_x_sum[-17:-35],
        vertex_b_unit_y_sum[-17:-35],
        vertex_b_unit_z_sum[-17:-35],
        vertex_n285_sum[-17:-30],
        vertex_n286_sum[-17:-30],
        vertex_n287_sum[-17:-30],
        vertex_ts_view_y_sum[-15:-30],
        vertex_ts_light0_y_sum[-15:-30],
        vertex_ts_view_x_sum[-15:-30],
        vertex_ts_light0_x_sum[-15:-30]};
endmodule
