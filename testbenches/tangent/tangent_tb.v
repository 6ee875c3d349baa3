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
//
// Self-checking testbench of tangent. It reads tangent_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 344 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes tangent_tb.vcd.
module tangent_tb;
    localparam LATENCY = 23;
    localparam VECTORS = 344;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [4:-11] port_p0_x;
    reg signed [4:-11] port_p0_y;
    reg signed [4:-11] port_p0_z;
    reg signed [4:-11] port_p1_x;
    reg signed [4:-11] port_p1_y;
    reg signed [4:-11] port_p1_z;
    reg signed [4:-11] port_p2_x;
    reg signed [4:-11] port_p2_y;
    reg signed [4:-11] port_p2_z;
    reg signed [2:-13] port_uv0_u;
    reg signed [2:-13] port_uv0_v;
    reg signed [2:-13] port_uv1_u;
    reg signed [2:-13] port_uv1_v;
    reg signed [2:-13] port_uv2_u;
    reg signed [2:-13] port_uv2_v;
    reg signed [1:-14] port_normal_x;
    reg signed [1:-14] port_normal_y;
    reg signed [1:-14] port_normal_z;
    reg signed [1:-14] port_view_x;
    reg signed [1:-14] port_view_y;
    reg signed [1:-14] port_view_z;
    reg signed [1:-14] port_light0_x;
    reg signed [1:-14] port_light0_y;
    reg signed [1:-14] port_light0_z;
    wire signed [2:-16] port_t_x;
    wire signed [2:-16] port_t_y;
    wire signed [2:-16] port_t_z;
    wire signed [1:-16] port_b_x;
    wire signed [1:-16] port_b_y;
    wire signed [1:-16] port_b_z;
    wire signed [1:-14] port_n_x;
    wire signed [1:-14] port_n_y;
    wire signed [1:-14] port_n_z;
    wire signed [4:-14] port_ts_view_x;
    wire signed [4:-14] port_ts_view_y;
    wire signed [4:-14] port_ts_view_z;
    wire signed [4:-14] port_ts_light0_x;
    wire signed [4:-14] port_ts_light0_y;
    wire signed [4:-14] port_ts_light0_z;
    wire port_mirrored;
    wire port_degenerate;
    wire port_zero_uv;
    wire port_zero_area;
    wire port_parallel;

    tangent dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .p0_x(port_p0_x),
        .p0_y(port_p0_y),
        .p0_z(port_p0_z),
        .p1_x(port_p1_x),
        .p1_y(port_p1_y),
        .p1_z(port_p1_z),
        .p2_x(port_p2_x),
        .p2_y(port_p2_y),
        .p2_z(port_p2_z),
        .uv0_u(port_uv0_u),
        .uv0_v(port_uv0_v),
        .uv1_u(port_uv1_u),
        .uv1_v(port_uv1_v),
        .uv2_u(port_uv2_u),
        .uv2_v(port_uv2_v),
        .normal_x(port_normal_x),
        .normal_y(port_normal_y),
        .normal_z(port_normal_z),
        .view_x(port_view_x),
        .view_y(port_view_y),
        .view_z(port_view_z),
        .light0_x(port_light0_x),
        .light0_y(port_light0_y),
        .light0_z(port_light0_z),
        .t_x(port_t_x),
        .t_y(port_t_y),
        .t_z(port_t_z),
        .b_x(port_b_x),
        .b_y(port_b_y),
        .b_z(port_b_z),
        .n_x(port_n_x),
        .n_y(port_n_y),
        .n_z(port_n_z),
        .ts_view_x(port_ts_view_x),
        .ts_view_y(port_ts_view_y),
        .ts_view_z(port_ts_view_z),
        .ts_light0_x(port_ts_light0_x),
        .ts_light0_y(port_ts_light0_y),
        .ts_light0_z(port_ts_light0_z),
        .mirrored(port_mirrored),
        .degenerate(port_degenerate),
        .zero_uv(port_zero_uv),
        .zero_area(port_zero_area),
        .parallel(port_parallel)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [277:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [4:-11] next_p0_x;
    reg signed [4:-11] next_p0_y;
    reg signed [4:-11] next_p0_z;
    reg signed [4:-11] next_p1_x;
    reg signed [4:-11] next_p1_y;
    reg signed [4:-11] next_p1_z;
    reg signed [4:-11] next_p2_x;
    reg signed [4:-11] next_p2_y;
    reg signed [4:-11] next_p2_z;
    reg signed [2:-13] next_uv0_u;
    reg signed [2:-13] next_uv0_v;
    reg signed [2:-13] next_uv1_u;
    reg signed [2:-13] next_uv1_v;
    reg signed [2:-13] next_uv2_u;
    reg signed [2:-13] next_uv2_v;
    reg signed [1:-14] next_normal_x;
    reg signed [1:-14] next_normal_y;
    reg signed [1:-14] next_normal_z;
    reg signed [1:-14] next_view_x;
    reg signed [1:-14] next_view_y;
    reg signed [1:-14] next_view_z;
    reg signed [1:-14] next_light0_x;
    reg signed [1:-14] next_light0_y;
    reg signed [1:-14] next_light0_z;
    reg signed [2:-16] next_t_x;
    reg signed [2:-16] next_t_y;
    reg signed [2:-16] next_t_z;
    reg signed [1:-16] next_b_x;
    reg signed [1:-16] next_b_y;
    reg signed [1:-16] next_b_z;
    reg signed [1:-14] next_n_x;
    reg signed [1:-14] next_n_y;
    reg signed [1:-14] next_n_z;
    reg signed [4:-14] next_ts_view_x;
    reg signed [4:-14] next_ts_view_y;
    reg signed [4:-14] next_ts_view_z;
    reg signed [4:-14] next_ts_light0_x;
    reg signed [4:-14] next_ts_light0_y;
    reg signed [4:-14] next_ts_light0_z;
    reg next_mirrored;
    reg next_degenerate;
    reg next_zero_uv;
    reg next_zero_area;
    reg next_parallel;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("tangent_tb.vcd");
            $dumpvars(0, tangent_tb);
        end
        lfsr = 32'h2545f491;
        mismatches = 0;
        passed = 0;
        stalls = 1'b0;
        started = 1'b0; // nothing is known before the first edge under reset
        for (i = 0; i <= LATENCY; i = i + 1) valid[i] = 1'b0;
        open_vectors;
    end

    task finish_failed;
        begin
`ifdef __ICARUS__
            $finish_and_return(1);
`else
            $fatal(0);
`endif
        end
    endtask

    task open_vectors;
        begin
            sent = 0;
            checked = 0;
            more = 1'b1;
            reset_done = 1'b0;
            file = $fopen("tangent_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: tangent_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_p0_x, next_p0_y, next_p0_z, next_p1_x, next_p1_y, next_p1_z, next_p2_x, next_p2_y, next_p2_z, next_uv0_u, next_uv0_v, next_uv1_u, next_uv1_v, next_uv2_u, next_uv2_v, next_normal_x, next_normal_y, next_normal_z, next_view_x, next_view_y, next_view_z, next_light0_x, next_light0_y, next_light0_z, next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_n_x, next_n_y, next_n_z, next_ts_view_x, next_ts_view_y, next_ts_view_z, next_ts_light0_x, next_ts_light0_y, next_ts_light0_z, next_mirrored, next_degenerate, next_zero_uv, next_zero_area, next_parallel);
            more = fields == 44;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: tangent_vectors.txt is cut short after vector %0d", sent);
            end
        end
    endtask

    task check;
        begin
            if (started && valid_out !== valid[LATENCY]) begin
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    $display("mismatch: vector %0d valid_out expected %b got %b", checked, valid[LATENCY], valid_out);
            end
            // Each word counts once: in the cycle after which the pipeline moves on.
            if (ce && valid[LATENCY]) begin
                if (port_t_x !== expected[LATENCY][277:259]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][277:259], port_t_x);
                end
                if (port_t_y !== expected[LATENCY][258:240]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][258:240], port_t_y);
                end
                if (port_t_z !== expected[LATENCY][239:221]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][239:221], port_t_z);
                end
                if (port_b_x !== expected[LATENCY][220:203]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][220:203], port_b_x);
                end
                if (port_b_y !== expected[LATENCY][202:185]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][202:185], port_b_y);
                end
                if (port_b_z !== expected[LATENCY][184:167]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][184:167], port_b_z);
                end
                if (port_n_x !== expected[LATENCY][166:151]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][166:151], port_n_x);
                end
                if (port_n_y !== expected[LATENCY][150:135]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][150:135], port_n_y);
                end
                if (port_n_z !== expected[LATENCY][134:119]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][134:119], port_n_z);
                end
                if (port_ts_view_x !== expected[LATENCY][118:100]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][118:100], port_ts_view_x);
                end
                if (port_ts_view_y !== expected[LATENCY][99:81]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][99:81], port_ts_view_y);
                end
                if (port_ts_view_z !== expected[LATENCY][80:62]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][80:62], port_ts_view_z);
                end
                if (port_ts_light0_x !== expected[LATENCY][61:43]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][61:43], port_ts_light0_x);
                end
                if (port_ts_light0_y !== expected[LATENCY][42:24]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][42:24], port_ts_light0_y);
                end
                if (port_ts_light0_z !== expected[LATENCY][23:5]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][23:5], port_ts_light0_z);
                end
                if (port_mirrored !== expected[LATENCY][4:4]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d mirrored expected %h got %h",
                            number[LATENCY], expected[LATENCY][4:4], port_mirrored);
                end
                if (port_degenerate !== expected[LATENCY][3:3]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d degenerate expected %h got %h",
                            number[LATENCY], expected[LATENCY][3:3], port_degenerate);
                end
                if (port_zero_uv !== expected[LATENCY][2:2]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d zero_uv expected %h got %h",
                            number[LATENCY], expected[LATENCY][2:2], port_zero_uv);
                end
                if (port_zero_area !== expected[LATENCY][1:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d zero_area expected %h got %h",
                            number[LATENCY], expected[LATENCY][1:1], port_zero_area);
                end
                if (port_parallel !== expected[LATENCY][0:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d parallel expected %h got %h",
                            number[LATENCY], expected[LATENCY][0:0], port_parallel);
                end
                checked = checked + 1;
            end
        end
    endtask

    task move_on;
        begin
            for (i = LATENCY; i > 0; i = i - 1) begin
                if (rst) valid[i] = 1'b0;
                else if (ce) valid[i] = valid[i - 1];
                if (ce) expected[i] = expected[i - 1];
                if (ce) number[i] = number[i - 1];
            end
        end
    endtask

    // What goes in after this edge: words stay where the pipeline stood still.
    task drive;
        begin
            lfsr = {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
            rst <= 1'b0;
            ce <= !(stalls && lfsr[2:0] == 3'd0);
            if (ce) begin
                valid[0] = 1'b0;
                if (more && !(stalls && lfsr[5:3] == 3'd0)) begin
                    read_vector;
                    if (more) begin
                        valid[0] = 1'b1;
                        expected[0] = {next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_n_x, next_n_y, next_n_z, next_ts_view_x, next_ts_view_y, next_ts_view_z, next_ts_light0_x, next_ts_light0_y, next_ts_light0_z, next_mirrored, next_degenerate, next_zero_uv, next_zero_area, next_parallel};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 344) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_p0_x <= valid[0] ? next_p0_x : 16'bx;
                port_p0_y <= valid[0] ? next_p0_y : 16'bx;
                port_p0_z <= valid[0] ? next_p0_z : 16'bx;
                port_p1_x <= valid[0] ? next_p1_x : 16'bx;
                port_p1_y <= valid[0] ? next_p1_y : 16'bx;
                port_p1_z <= valid[0] ? next_p1_z : 16'bx;
                port_p2_x <= valid[0] ? next_p2_x : 16'bx;
                port_p2_y <= valid[0] ? next_p2_y : 16'bx;
                port_p2_z <= valid[0] ? next_p2_z : 16'bx;
                port_uv0_u <= valid[0] ? next_uv0_u : 16'bx;
                port_uv0_v <= valid[0] ? next_uv0_v : 16'bx;
                port_uv1_u <= valid[0] ? next_uv1_u : 16'bx;
                port_uv1_v <= valid[0] ? next_uv1_v : 16'bx;
                port_uv2_u <= valid[0] ? next_uv2_u : 16'bx;
                port_uv2_v <= valid[0] ? next_uv2_v : 16'bx;
                port_normal_x <= valid[0] ? next_normal_x : 16'bx;
                port_normal_y <= valid[0] ? next_normal_y : 16'bx;
                port_normal_z <= valid[0] ? next_normal_z : 16'bx;
                port_view_x <= valid[0] ? next_view_x : 16'bx;
                port_view_y <= valid[0] ? next_view_y : 16'bx;
                port_view_z <= valid[0] ? next_view_z : 16'bx;
                port_light0_x <= valid[0] ? next_light0_x : 16'bx;
                port_light0_y <= valid[0] ? next_light0_y : 16'bx;
                port_light0_z <= valid[0] ? next_light0_z : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 344 / 2) begin
                rst <= 1'b1;
                ce <= 1'b0;
                reset_done = 1'b1;
            end
        end
    endtask

    always @(posedge clk) begin
        check;
        if (rst && stalls) begin
            // Forgotten, but for what hasn't gone in yet.
            for (i = 1; i <= LATENCY; i = i + 1) if (valid[i]) checked = checked + 1;
        end
        move_on;
        drive;
        started = 1'b1;
        if (!more && checked == sent) begin
            $fclose(file);
            if (!stalls) begin
                passed = checked;
                stalls = 1'b1;
                open_vectors;
            end else finish;
        end
    end

    task finish;
        begin
            if (passed != VECTORS)
                $display("mismatch: tangent_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
            if (mismatches == 0 && passed == VECTORS) begin
                $display("PASS %0d vectors", passed);
                $finish(0);
            end else begin
                $display("FAIL %0d mismatches in %0d vectors", mismatches, passed);
                finish_failed;
            end
        end
    endtask
endmodule
