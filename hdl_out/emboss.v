// emboss: texture coordinates displaced by the direction of a light, for embossing
// made by fixpath 0.1.0; US 6,980,218; US 7,307,640; GL_NV_texgen_emboss
//   setting=gx frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
//   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
//   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
//   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
//   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
//   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
//   rom=block
// latency 14 cycles, interval 1 cycle; tables read on the clock
// errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   ds_texels: mean 5.15e-4 texel, largest seen 4.51e-3 texel at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   ds_relative: mean 2.03e-6, largest seen 1.43e-5 over the vector's length times its factor, each at least 1/4, at m0_x=4132 m0_y=-131 m0_z=429 m1_x=133 m1_y=4154 m1_z=-11 m2_x=-428 m2_y=25 m2_z=4134 tangent_x=-10615 tangent_y=137 tangent_z=12480 binormal_x=-202 binormal_y=16379 binormal_z=-351 light_x=26912091 light_y=-19929090 light_z=-1678718 vertex_x=27451608 vertex_y=-19638454 vertex_z=-1458906 s0=-3142235 t0=-300807
//   ds: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   dt_texels: mean 5.17e-4 texel, largest seen 5.30e-3 texel at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   dt_relative: mean 2.03e-6, largest seen 1.55e-5 over the vector's length times its factor, each at least 1/4, at m0_x=1817 m0_y=-3955 m0_z=169 m1_x=460 m1_y=27 m1_z=-4332 m2_x=3932 m2_y=1825 m2_z=429 tangent_x=6988 tangent_y=-14240 tangent_z=4101 binormal_x=-170 binormal_y=4457 binormal_z=15765 light_x=-9167663 light_y=7142069 light_z=-10596957 vertex_x=-8884124 vertex_y=7444365 vertex_z=-9525055 s0=2333965 t0=3659718
//   dt: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   s1: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
//   t1: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at m0_x=4674 m0_y=5079 m0_z=-2162 m1_x=-3514 m1_y=4923 m1_z=3966 m2_x=-4257 m2_y=1512 m2_z=-5648 tangent_x=-2894 tangent_y=-19246 tangent_z=1152 binormal_x=-2531 binormal_y=7271 binormal_z=-13448 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897
// stated bound on each relative displacement (relative to the vector's length times its factor, each at least 1/4): 5.21e-5
// stated bound on each displacement: 1.15e-3
// stated bound on each displacement in texels: 2.93e-1
// stated bound on each coordinate: 1.15e-3
// stated bound on each flag and what is passed: 0.00e0
module emboss (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [2:-13] m0_x, // s16f13
    input  wire signed [2:-13] m0_y, // s16f13
    input  wire signed [2:-13] m0_z, // s16f13
    input  wire signed [2:-13] m1_x, // s16f13
    input  wire signed [2:-13] m1_y, // s16f13
    input  wire signed [2:-13] m1_z, // s16f13
    input  wire signed [2:-13] m2_x, // s16f13
    input  wire signed [2:-13] m2_y, // s16f13
    input  wire signed [2:-13] m2_z, // s16f13
    input  wire signed [1:-14] tangent_x, // s16f14
    input  wire signed [1:-14] tangent_y, // s16f14
    input  wire signed [1:-14] tangent_z, // s16f14
    input  wire signed [1:-14] binormal_x, // s16f14
    input  wire signed [1:-14] binormal_y, // s16f14
    input  wire signed [1:-14] binormal_z, // s16f14
    input  wire signed [12:-15] light_x, // s28f15
    input  wire signed [12:-15] light_y, // s28f15
    input  wire signed [12:-15] light_z, // s28f15
    input  wire signed [12:-15] vertex_x, // s28f15
    input  wire signed [12:-15] vertex_y, // s28f15
    input  wire signed [12:-15] vertex_z, // s28f15
    input  wire signed [6:-18] s0, // s25f18
    input  wire signed [6:-18] t0, // s25f18
    output wire valid_out,
    output reg  signed [8:-18] ds, // s27f18
    output reg  signed [8:-18] dt, // s27f18
    output reg  signed [6:-18] s1, // s25f18
    output reg  signed [6:-18] t1, // s25f18
    output reg  degenerate // u1f0
);

    // table recip_root: recip_sqrt_base u23f22, recip_sqrt_slope s16f33
    (* rom_style = "block" *)
    reg [38:0] recip_root_rom [0:511];
    initial begin
        recip_root_rom[0] = 39'h7fffe880bf; recip_root_rom[1] = 39'h7f80a88237; recip_root_rom[2] = 39'h7f02df83a9; recip_root_rom[3] = 39'h7e86898513;
        recip_root_rom[4] = 39'h7e0b9c8677; recip_root_rom[5] = 39'h7d921387d4; recip_root_rom[6] = 39'h7d19e8892a; recip_root_rom[7] = 39'h7ca3128a7a;
        recip_root_rom[8] = 39'h7c2d8d8bc4; recip_root_rom[9] = 39'h7bb9528d08; recip_root_rom[10] = 39'h7b465a8e47; recip_root_rom[11] = 39'h7ad4a18f7f;
        recip_root_rom[12] = 39'h7a642090b2; recip_root_rom[13] = 39'h79f4d391df; recip_root_rom[14] = 39'h7986b29308; recip_root_rom[15] = 39'h7919bb942b;
        recip_root_rom[16] = 39'h78ade69549; recip_root_rom[17] = 39'h78432f9662; recip_root_rom[18] = 39'h77d9929776; recip_root_rom[19] = 39'h7771089886;
        recip_root_rom[20] = 39'h77098f9991; recip_root_rom[21] = 39'h76a3209a98; recip_root_rom[22] = 39'h763db89b9a; recip_root_rom[23] = 39'h75d9539c98;
        recip_root_rom[24] = 39'h7575eb9d92; recip_root_rom[25] = 39'h75137e9e88; recip_root_rom[26] = 39'h74b2069f7a; recip_root_rom[27] = 39'h745180a068;
        recip_root_rom[28] = 39'h73f1e8a152; recip_root_rom[29] = 39'h73933aa239; recip_root_rom[30] = 39'h733573a31b; recip_root_rom[31] = 39'h72d88fa3fb;
        recip_root_rom[32] = 39'h727c8aa4d6; recip_root_rom[33] = 39'h722160a5af; recip_root_rom[34] = 39'h71c70fa684; recip_root_rom[35] = 39'h716d93a756;
        recip_root_rom[36] = 39'h7114eaa824; recip_root_rom[37] = 39'h70bd0ea8f0; recip_root_rom[38] = 39'h7065fea9b9; recip_root_rom[39] = 39'h700fb7aa7e;
        recip_root_rom[40] = 39'h6fba35ab41; recip_root_rom[41] = 39'h6f6576ac00; recip_root_rom[42] = 39'h6f1177acbd; recip_root_rom[43] = 39'h6ebe34ad77;
        recip_root_rom[44] = 39'h6e6babae2f; recip_root_rom[45] = 39'h6e19daaee4; recip_root_rom[46] = 39'h6dc8beaf96; recip_root_rom[47] = 39'h6d7854b046;
        recip_root_rom[48] = 39'h6d289ab0f3; recip_root_rom[49] = 39'h6cd98db19e; recip_root_rom[50] = 39'h6c8b2bb246; recip_root_rom[51] = 39'h6c3d71b2ec;
        recip_root_rom[52] = 39'h6bf05db390; recip_root_rom[53] = 39'h6ba3edb431; recip_root_rom[54] = 39'h6b581eb4d1; recip_root_rom[55] = 39'h6b0cefb56e;
        recip_root_rom[56] = 39'h6ac25db609; recip_root_rom[57] = 39'h6a7866b6a2; recip_root_rom[58] = 39'h6a2f08b738; recip_root_rom[59] = 39'h69e640b7cd;
        recip_root_rom[60] = 39'h699e0eb860; recip_root_rom[61] = 39'h69566eb8f1; recip_root_rom[62] = 39'h690f5fb980; recip_root_rom[63] = 39'h68c8e0ba0d;
        recip_root_rom[64] = 39'h6882edba99; recip_root_rom[65] = 39'h683d86bb22; recip_root_rom[66] = 39'h67f8a8bbaa; recip_root_rom[67] = 39'h67b453bc30;
        recip_root_rom[68] = 39'h677083bcb4; recip_root_rom[69] = 39'h672d37bd37; recip_root_rom[70] = 39'h66ea6fbdb8; recip_root_rom[71] = 39'h66a827be38;
        recip_root_rom[72] = 39'h66665fbeb5; recip_root_rom[73] = 39'h662514bf32; recip_root_rom[74] = 39'h65e446bfac; recip_root_rom[75] = 39'h65a3f2c026;
        recip_root_rom[76] = 39'h656419c09d; recip_root_rom[77] = 39'h6524b6c114; recip_root_rom[78] = 39'h64e5c9c189; recip_root_rom[79] = 39'h64a752c1fc;
        recip_root_rom[80] = 39'h64694fc26e; recip_root_rom[81] = 39'h642bbdc2df; recip_root_rom[82] = 39'h63ee9cc34e; recip_root_rom[83] = 39'h63b1eac3bc;
        recip_root_rom[84] = 39'h6375a6c429; recip_root_rom[85] = 39'h6339cfc495; recip_root_rom[86] = 39'h62fe64c4ff; recip_root_rom[87] = 39'h62c363c568;
        recip_root_rom[88] = 39'h6288cbc5d0; recip_root_rom[89] = 39'h624e9bc636; recip_root_rom[90] = 39'h6214d1c69c; recip_root_rom[91] = 39'h61db6dc700;
        recip_root_rom[92] = 39'h61a26dc763; recip_root_rom[93] = 39'h6169d0c7c5; recip_root_rom[94] = 39'h613196c826; recip_root_rom[95] = 39'h60f9bcc886;
        recip_root_rom[96] = 39'h60c242c8e5; recip_root_rom[97] = 39'h608b26c943; recip_root_rom[98] = 39'h605469c99f; recip_root_rom[99] = 39'h601e08c9fb;
        recip_root_rom[100] = 39'h5fe803ca56; recip_root_rom[101] = 39'h5fb259caaf; recip_root_rom[102] = 39'h5f7d08cb08; recip_root_rom[103] = 39'h5f4810cb60;
        recip_root_rom[104] = 39'h5f1370cbb7; recip_root_rom[105] = 39'h5edf27cc0c; recip_root_rom[106] = 39'h5eab34cc61; recip_root_rom[107] = 39'h5e7795ccb6;
        recip_root_rom[108] = 39'h5e444acd09; recip_root_rom[109] = 39'h5e1153cd5b; recip_root_rom[110] = 39'h5ddeaecdad; recip_root_rom[111] = 39'h5dac5bcdfd;
        recip_root_rom[112] = 39'h5d7a58ce4d; recip_root_rom[113] = 39'h5d48a5ce9c; recip_root_rom[114] = 39'h5d1741ceea; recip_root_rom[115] = 39'h5ce62bcf37;
        recip_root_rom[116] = 39'h5cb562cf84; recip_root_rom[117] = 39'h5c84e6cfd0; recip_root_rom[118] = 39'h5c54b6d01b; recip_root_rom[119] = 39'h5c24d0d065;
        recip_root_rom[120] = 39'h5bf536d0ae; recip_root_rom[121] = 39'h5bc5e4d0f7; recip_root_rom[122] = 39'h5b96dbd13f; recip_root_rom[123] = 39'h5b681ad186;
        recip_root_rom[124] = 39'h5b39a0d1cd; recip_root_rom[125] = 39'h5b0b6dd213; recip_root_rom[126] = 39'h5add81d258; recip_root_rom[127] = 39'h5aafd9d29d;
        recip_root_rom[128] = 39'h5a8275d2e1; recip_root_rom[129] = 39'h5a5556d324; recip_root_rom[130] = 39'h5a287ad366; recip_root_rom[131] = 39'h59fbe1d3a8;
        recip_root_rom[132] = 39'h59cf89d3ea; recip_root_rom[133] = 39'h59a373d42a; recip_root_rom[134] = 39'h59779dd46a; recip_root_rom[135] = 39'h594c07d4aa;
        recip_root_rom[136] = 39'h5920b1d4e9; recip_root_rom[137] = 39'h58f59ad527; recip_root_rom[138] = 39'h58cac1d565; recip_root_rom[139] = 39'h58a025d5a2;
        recip_root_rom[140] = 39'h5875c7d5de; recip_root_rom[141] = 39'h584ba6d61a; recip_root_rom[142] = 39'h5821c0d656; recip_root_rom[143] = 39'h57f815d691;
        recip_root_rom[144] = 39'h57cea6d6cb; recip_root_rom[145] = 39'h57a571d705; recip_root_rom[146] = 39'h577c76d73e; recip_root_rom[147] = 39'h5753b4d777;
        recip_root_rom[148] = 39'h572b2ad7af; recip_root_rom[149] = 39'h5702d9d7e7; recip_root_rom[150] = 39'h56dac0d81e; recip_root_rom[151] = 39'h56b2ded855;
        recip_root_rom[152] = 39'h568b33d88b; recip_root_rom[153] = 39'h5663bed8c1; recip_root_rom[154] = 39'h563c7fd8f6; recip_root_rom[155] = 39'h561575d92b;
        recip_root_rom[156] = 39'h55eea0d95f; recip_root_rom[157] = 39'h55c7ffd993; recip_root_rom[158] = 39'h55a192d9c7; recip_root_rom[159] = 39'h557b58d9fa;
        recip_root_rom[160] = 39'h555552da2c; recip_root_rom[161] = 39'h552f7fda5e; recip_root_rom[162] = 39'h5509ddda90; recip_root_rom[163] = 39'h54e46ddac1;
        recip_root_rom[164] = 39'h54bf2edaf2; recip_root_rom[165] = 39'h549a20db23; recip_root_rom[166] = 39'h547543db53; recip_root_rom[167] = 39'h545096db82;
        recip_root_rom[168] = 39'h542c18dbb1; recip_root_rom[169] = 39'h5407c9dbe0; recip_root_rom[170] = 39'h53e3a9dc0f; recip_root_rom[171] = 39'h53bfb8dc3d;
        recip_root_rom[172] = 39'h539bf5dc6a; recip_root_rom[173] = 39'h53785fdc98; recip_root_rom[174] = 39'h5354f7dcc5; recip_root_rom[175] = 39'h5331bcdcf1;
        recip_root_rom[176] = 39'h530eaddd1d; recip_root_rom[177] = 39'h52ebcadd49; recip_root_rom[178] = 39'h52c913dd75; recip_root_rom[179] = 39'h52a688dda0;
        recip_root_rom[180] = 39'h528428ddca; recip_root_rom[181] = 39'h5261f2ddf5; recip_root_rom[182] = 39'h523fe7de1f; recip_root_rom[183] = 39'h521e06de49;
        recip_root_rom[184] = 39'h51fc4fde72; recip_root_rom[185] = 39'h51dac1de9b; recip_root_rom[186] = 39'h51b95cdec4; recip_root_rom[187] = 39'h519820deec;
        recip_root_rom[188] = 39'h51770cdf14; recip_root_rom[189] = 39'h515621df3c; recip_root_rom[190] = 39'h51355ddf64; recip_root_rom[191] = 39'h5114c0df8b;
        recip_root_rom[192] = 39'h50f44bdfb2; recip_root_rom[193] = 39'h50d3fddfd8; recip_root_rom[194] = 39'h50b3d5dffe; recip_root_rom[195] = 39'h5093d4e024;
        recip_root_rom[196] = 39'h5073f8e04a; recip_root_rom[197] = 39'h505442e06f; recip_root_rom[198] = 39'h5034b1e095; recip_root_rom[199] = 39'h501546e0b9;
        recip_root_rom[200] = 39'h4ff600e0de; recip_root_rom[201] = 39'h4fd6dee102; recip_root_rom[202] = 39'h4fb7e0e126; recip_root_rom[203] = 39'h4f9906e14a;
        recip_root_rom[204] = 39'h4f7a50e16d; recip_root_rom[205] = 39'h4f5bbde190; recip_root_rom[206] = 39'h4f3d4ee1b3; recip_root_rom[207] = 39'h4f1f01e1d6;
        recip_root_rom[208] = 39'h4f00d7e1f8; recip_root_rom[209] = 39'h4ee2cfe21b; recip_root_rom[210] = 39'h4ec4ebe23c; recip_root_rom[211] = 39'h4ea727e25e;
        recip_root_rom[212] = 39'h4e8985e280; recip_root_rom[213] = 39'h4e6c04e2a1; recip_root_rom[214] = 39'h4e4ea5e2c2; recip_root_rom[215] = 39'h4e3167e2e2;
        recip_root_rom[216] = 39'h4e1449e303; recip_root_rom[217] = 39'h4df74ce323; recip_root_rom[218] = 39'h4dda6ee343; recip_root_rom[219] = 39'h4dbdb1e363;
        recip_root_rom[220] = 39'h4da114e382; recip_root_rom[221] = 39'h4d8496e3a1; recip_root_rom[222] = 39'h4d6838e3c0; recip_root_rom[223] = 39'h4d4bf8e3df;
        recip_root_rom[224] = 39'h4d2fd7e3fe; recip_root_rom[225] = 39'h4d13d5e41c; recip_root_rom[226] = 39'h4cf7f2e43a; recip_root_rom[227] = 39'h4cdc2ce458;
        recip_root_rom[228] = 39'h4cc084e476; recip_root_rom[229] = 39'h4ca4fae494; recip_root_rom[230] = 39'h4c898ee4b1; recip_root_rom[231] = 39'h4c6e40e4ce;
        recip_root_rom[232] = 39'h4c530ee4eb; recip_root_rom[233] = 39'h4c37f9e508; recip_root_rom[234] = 39'h4c1d01e525; recip_root_rom[235] = 39'h4c0225e541;
        recip_root_rom[236] = 39'h4be766e55d; recip_root_rom[237] = 39'h4bccc3e579; recip_root_rom[238] = 39'h4bb23ce595; recip_root_rom[239] = 39'h4b97d1e5b0;
        recip_root_rom[240] = 39'h4b7d81e5cc; recip_root_rom[241] = 39'h4b634de5e7; recip_root_rom[242] = 39'h4b4934e602; recip_root_rom[243] = 39'h4b2f36e61d;
        recip_root_rom[244] = 39'h4b1553e638; recip_root_rom[245] = 39'h4afb8be652; recip_root_rom[246] = 39'h4ae1dde66c; recip_root_rom[247] = 39'h4ac849e686;
        recip_root_rom[248] = 39'h4aaed0e6a0; recip_root_rom[249] = 39'h4a9570e6ba; recip_root_rom[250] = 39'h4a7c2ae6d4; recip_root_rom[251] = 39'h4a62fee6ed;
        recip_root_rom[252] = 39'h4a49ebe707; recip_root_rom[253] = 39'h4a30f2e720; recip_root_rom[254] = 39'h4a1811e739; recip_root_rom[255] = 39'h49ff4ae751;
        recip_root_rom[256] = 39'h49e69ce76a; recip_root_rom[257] = 39'h49ce06e783; recip_root_rom[258] = 39'h49b588e79b; recip_root_rom[259] = 39'h499d23e7b3;
        recip_root_rom[260] = 39'h4984d6e7cb; recip_root_rom[261] = 39'h496ca1e7e3; recip_root_rom[262] = 39'h495484e7fb; recip_root_rom[263] = 39'h493c7fe812;
        recip_root_rom[264] = 39'h492491e82a; recip_root_rom[265] = 39'h490cbae841; recip_root_rom[266] = 39'h48f4fbe858; recip_root_rom[267] = 39'h48dd53e86f;
        recip_root_rom[268] = 39'h48c5c2e886; recip_root_rom[269] = 39'h48ae48e89c; recip_root_rom[270] = 39'h4896e4e8b3; recip_root_rom[271] = 39'h487f97e8c9;
        recip_root_rom[272] = 39'h486860e8df; recip_root_rom[273] = 39'h48513fe8f6; recip_root_rom[274] = 39'h483a35e90c; recip_root_rom[275] = 39'h482341e921;
        recip_root_rom[276] = 39'h480c62e937; recip_root_rom[277] = 39'h47f599e94d; recip_root_rom[278] = 39'h47dee6e962; recip_root_rom[279] = 39'h47c848e977;
        recip_root_rom[280] = 39'h47b1bfe98d; recip_root_rom[281] = 39'h479b4be9a2; recip_root_rom[282] = 39'h4784ede9b6; recip_root_rom[283] = 39'h476ea4e9cb;
        recip_root_rom[284] = 39'h47586fe9e0; recip_root_rom[285] = 39'h47424fe9f4; recip_root_rom[286] = 39'h472c43ea09; recip_root_rom[287] = 39'h47164cea1d;
        recip_root_rom[288] = 39'h470069ea31; recip_root_rom[289] = 39'h46ea9bea45; recip_root_rom[290] = 39'h46d4e0ea59; recip_root_rom[291] = 39'h46bf39ea6d;
        recip_root_rom[292] = 39'h46a9a6ea81; recip_root_rom[293] = 39'h469427ea94; recip_root_rom[294] = 39'h467ebbeaa8; recip_root_rom[295] = 39'h466963eabb;
        recip_root_rom[296] = 39'h46541feace; recip_root_rom[297] = 39'h463eedeae2; recip_root_rom[298] = 39'h4629ceeaf5; recip_root_rom[299] = 39'h4614c3eb07;
        recip_root_rom[300] = 39'h45ffcaeb1a; recip_root_rom[301] = 39'h45eae4eb2d; recip_root_rom[302] = 39'h45d612eb3f; recip_root_rom[303] = 39'h45c151eb52;
        recip_root_rom[304] = 39'h45aca3eb64; recip_root_rom[305] = 39'h459807eb76; recip_root_rom[306] = 39'h45837deb89; recip_root_rom[307] = 39'h456f06eb9b;
        recip_root_rom[308] = 39'h455aa1ebad; recip_root_rom[309] = 39'h45464eebbe; recip_root_rom[310] = 39'h45320cebd0; recip_root_rom[311] = 39'h451ddcebe2;
        recip_root_rom[312] = 39'h4509beebf3; recip_root_rom[313] = 39'h44f5b1ec05; recip_root_rom[314] = 39'h44e1b6ec16; recip_root_rom[315] = 39'h44cdccec27;
        recip_root_rom[316] = 39'h44b9f3ec38; recip_root_rom[317] = 39'h44a62cec49; recip_root_rom[318] = 39'h449275ec5a; recip_root_rom[319] = 39'h447ecfec6b;
        recip_root_rom[320] = 39'h446b3bec7c; recip_root_rom[321] = 39'h4457b6ec8d; recip_root_rom[322] = 39'h444443ec9d; recip_root_rom[323] = 39'h4430e0ecae;
        recip_root_rom[324] = 39'h441d8eecbe; recip_root_rom[325] = 39'h440a4decce; recip_root_rom[326] = 39'h43f71becdf; recip_root_rom[327] = 39'h43e3f9ecef;
        recip_root_rom[328] = 39'h43d0e8ecff; recip_root_rom[329] = 39'h43bde7ed0f; recip_root_rom[330] = 39'h43aaf5ed1f; recip_root_rom[331] = 39'h439814ed2e;
        recip_root_rom[332] = 39'h438542ed3e; recip_root_rom[333] = 39'h437280ed4e; recip_root_rom[334] = 39'h435fceed5d; recip_root_rom[335] = 39'h434d2bed6d;
        recip_root_rom[336] = 39'h433a98ed7c; recip_root_rom[337] = 39'h432814ed8b; recip_root_rom[338] = 39'h43159fed9a; recip_root_rom[339] = 39'h43033aeda9;
        recip_root_rom[340] = 39'h42f0e3edb8; recip_root_rom[341] = 39'h42de9cedc7; recip_root_rom[342] = 39'h42cc63edd6; recip_root_rom[343] = 39'h42ba39ede5;
        recip_root_rom[344] = 39'h42a81eedf4; recip_root_rom[345] = 39'h429612ee02; recip_root_rom[346] = 39'h428414ee11; recip_root_rom[347] = 39'h427226ee1f;
        recip_root_rom[348] = 39'h426045ee2e; recip_root_rom[349] = 39'h424e73ee3c; recip_root_rom[350] = 39'h423cafee4a; recip_root_rom[351] = 39'h422af9ee59;
        recip_root_rom[352] = 39'h421952ee67; recip_root_rom[353] = 39'h4207b8ee75; recip_root_rom[354] = 39'h41f62dee83; recip_root_rom[355] = 39'h41e4b0ee91;
        recip_root_rom[356] = 39'h41d341ee9e; recip_root_rom[357] = 39'h41c1dfeeac; recip_root_rom[358] = 39'h41b08beeba; recip_root_rom[359] = 39'h419f45eec7;
        recip_root_rom[360] = 39'h418e0ceed5; recip_root_rom[361] = 39'h417ce1eee2; recip_root_rom[362] = 39'h416bc3eef0; recip_root_rom[363] = 39'h415ab3eefd;
        recip_root_rom[364] = 39'h4149b0ef0a; recip_root_rom[365] = 39'h4138baef18; recip_root_rom[366] = 39'h4127d2ef25; recip_root_rom[367] = 39'h4116f7ef32;
        recip_root_rom[368] = 39'h410628ef3f; recip_root_rom[369] = 39'h40f567ef4c; recip_root_rom[370] = 39'h40e4b3ef58; recip_root_rom[371] = 39'h40d40bef65;
        recip_root_rom[372] = 39'h40c370ef72; recip_root_rom[373] = 39'h40b2e2ef7f; recip_root_rom[374] = 39'h40a261ef8b; recip_root_rom[375] = 39'h4091ecef98;
        recip_root_rom[376] = 39'h408185efa4; recip_root_rom[377] = 39'h407129efb1; recip_root_rom[378] = 39'h4060d9efbd; recip_root_rom[379] = 39'h405097efc9;
        recip_root_rom[380] = 39'h404060efd6; recip_root_rom[381] = 39'h403035efe2; recip_root_rom[382] = 39'h402017efee; recip_root_rom[383] = 39'h401005effa;
        recip_root_rom[384] = 39'h3ffffff006; recip_root_rom[385] = 39'h3ff005f012; recip_root_rom[386] = 39'h3fe017f01e; recip_root_rom[387] = 39'h3fd035f02a;
        recip_root_rom[388] = 39'h3fc05ff035; recip_root_rom[389] = 39'h3fb094f041; recip_root_rom[390] = 39'h3fa0d5f04d; recip_root_rom[391] = 39'h3f9122f058;
        recip_root_rom[392] = 39'h3f817af064; recip_root_rom[393] = 39'h3f71dff06f; recip_root_rom[394] = 39'h3f624ef07b; recip_root_rom[395] = 39'h3f52c9f086;
        recip_root_rom[396] = 39'h3f434ff092; recip_root_rom[397] = 39'h3f33e0f09d; recip_root_rom[398] = 39'h3f247df0a8; recip_root_rom[399] = 39'h3f1525f0b3;
        recip_root_rom[400] = 39'h3f05d9f0be; recip_root_rom[401] = 39'h3ef697f0c9; recip_root_rom[402] = 39'h3ee760f0d4; recip_root_rom[403] = 39'h3ed835f0df;
        recip_root_rom[404] = 39'h3ec914f0ea; recip_root_rom[405] = 39'h3eb9fef0f5; recip_root_rom[406] = 39'h3eaaf3f100; recip_root_rom[407] = 39'h3e9bf3f10b;
        recip_root_rom[408] = 39'h3e8cfef115; recip_root_rom[409] = 39'h3e7e13f120; recip_root_rom[410] = 39'h3e6f33f12b; recip_root_rom[411] = 39'h3e605ef135;
        recip_root_rom[412] = 39'h3e5193f140; recip_root_rom[413] = 39'h3e42d2f14a; recip_root_rom[414] = 39'h3e341cf155; recip_root_rom[415] = 39'h3e2571f15f;
        recip_root_rom[416] = 39'h3e16d0f169; recip_root_rom[417] = 39'h3e0839f173; recip_root_rom[418] = 39'h3df9acf17e; recip_root_rom[419] = 39'h3deb2af188;
        recip_root_rom[420] = 39'h3ddcb2f192; recip_root_rom[421] = 39'h3dce44f19c; recip_root_rom[422] = 39'h3dbfe0f1a6; recip_root_rom[423] = 39'h3db186f1b0;
        recip_root_rom[424] = 39'h3da336f1ba; recip_root_rom[425] = 39'h3d94f0f1c4; recip_root_rom[426] = 39'h3d86b4f1ce; recip_root_rom[427] = 39'h3d7882f1d8;
        recip_root_rom[428] = 39'h3d6a5af1e1; recip_root_rom[429] = 39'h3d5c3bf1eb; recip_root_rom[430] = 39'h3d4e26f1f5; recip_root_rom[431] = 39'h3d401bf1fe;
        recip_root_rom[432] = 39'h3d3219f208; recip_root_rom[433] = 39'h3d2421f212; recip_root_rom[434] = 39'h3d1633f21b; recip_root_rom[435] = 39'h3d084ef224;
        recip_root_rom[436] = 39'h3cfa72f22e; recip_root_rom[437] = 39'h3ceca0f237; recip_root_rom[438] = 39'h3cded7f241; recip_root_rom[439] = 39'h3cd118f24a;
        recip_root_rom[440] = 39'h3cc362f253; recip_root_rom[441] = 39'h3cb5b5f25c; recip_root_rom[442] = 39'h3ca811f266; recip_root_rom[443] = 39'h3c9a77f26f;
        recip_root_rom[444] = 39'h3c8ce6f278; recip_root_rom[445] = 39'h3c7f5ef281; recip_root_rom[446] = 39'h3c71def28a; recip_root_rom[447] = 39'h3c6468f293;
        recip_root_rom[448] = 39'h3c56fbf29c; recip_root_rom[449] = 39'h3c4997f2a5; recip_root_rom[450] = 39'h3c3c3cf2ae; recip_root_rom[451] = 39'h3c2eeaf2b6;
        recip_root_rom[452] = 39'h3c21a0f2bf; recip_root_rom[453] = 39'h3c145ff2c8; recip_root_rom[454] = 39'h3c0727f2d1; recip_root_rom[455] = 39'h3bf9f8f2d9;
        recip_root_rom[456] = 39'h3becd1f2e2; recip_root_rom[457] = 39'h3bdfb2f2eb; recip_root_rom[458] = 39'h3bd29df2f3; recip_root_rom[459] = 39'h3bc590f2fc;
        recip_root_rom[460] = 39'h3bb88cf304; recip_root_rom[461] = 39'h3bab90f30d; recip_root_rom[462] = 39'h3b9e9df315; recip_root_rom[463] = 39'h3b91b2f31d;
        recip_root_rom[464] = 39'h3b84cff326; recip_root_rom[465] = 39'h3b77f5f32e; recip_root_rom[466] = 39'h3b6b23f336; recip_root_rom[467] = 39'h3b5e59f33f;
        recip_root_rom[468] = 39'h3b5198f347; recip_root_rom[469] = 39'h3b44def34f; recip_root_rom[470] = 39'h3b382df357; recip_root_rom[471] = 39'h3b2b85f35f;
        recip_root_rom[472] = 39'h3b1ee4f367; recip_root_rom[473] = 39'h3b124bf36f; recip_root_rom[474] = 39'h3b05baf377; recip_root_rom[475] = 39'h3af932f37f;
        recip_root_rom[476] = 39'h3aecb1f387; recip_root_rom[477] = 39'h3ae038f38f; recip_root_rom[478] = 39'h3ad3c7f397; recip_root_rom[479] = 39'h3ac75ef39f;
        recip_root_rom[480] = 39'h3abafdf3a7; recip_root_rom[481] = 39'h3aaea4f3ae; recip_root_rom[482] = 39'h3aa252f3b6; recip_root_rom[483] = 39'h3a9608f3be;
        recip_root_rom[484] = 39'h3a89c6f3c6; recip_root_rom[485] = 39'h3a7d8cf3cd; recip_root_rom[486] = 39'h3a7159f3d5; recip_root_rom[487] = 39'h3a652ef3dc;
        recip_root_rom[488] = 39'h3a590af3e4; recip_root_rom[489] = 39'h3a4ceef3ec; recip_root_rom[490] = 39'h3a40d9f3f3; recip_root_rom[491] = 39'h3a34cdf3fa;
        recip_root_rom[492] = 39'h3a28c7f402; recip_root_rom[493] = 39'h3a1cc9f409; recip_root_rom[494] = 39'h3a10d2f411; recip_root_rom[495] = 39'h3a04e3f418;
        recip_root_rom[496] = 39'h39f8fbf41f; recip_root_rom[497] = 39'h39ed1af427; recip_root_rom[498] = 39'h39e141f42e; recip_root_rom[499] = 39'h39d56ff435;
        recip_root_rom[500] = 39'h39c9a4f43c; recip_root_rom[501] = 39'h39bde0f444; recip_root_rom[502] = 39'h39b224f44b; recip_root_rom[503] = 39'h39a66ef452;
        recip_root_rom[504] = 39'h399ac0f459; recip_root_rom[505] = 39'h398f19f460; recip_root_rom[506] = 39'h398379f467; recip_root_rom[507] = 39'h3977e0f46e;
        recip_root_rom[508] = 39'h396c4ef475; recip_root_rom[509] = 39'h3960c3f47c; recip_root_rom[510] = 39'h39553ff483; recip_root_rom[511] = 39'h3949c1f48a;
    end

    // ---- stage 0 ----
    // t_x
    wire signed [4:-27] t_x_n23 = m0_x * tangent_x; // s32f27
    wire signed [4:-27] t_x_n24 = m0_y * tangent_y; // s32f27
    wire signed [4:-27] t_x_n25 = m0_z * tangent_z; // s32f27
    // t_y
    wire signed [4:-27] t_y_n28 = m1_x * tangent_x; // s32f27
    wire signed [4:-27] t_y_n29 = m1_y * tangent_y; // s32f27
    wire signed [4:-27] t_y_n30 = m1_z * tangent_z; // s32f27
    // t_z
    wire signed [4:-27] t_z_n33 = m2_x * tangent_x; // s32f27
    wire signed [4:-27] t_z_n34 = m2_y * tangent_y; // s32f27
    wire signed [4:-27] t_z_n35 = m2_z * tangent_z; // s32f27
    // b_x
    wire signed [4:-27] b_x_n41 = m0_x * binormal_x; // s32f27
    wire signed [4:-27] b_x_n42 = m0_y * binormal_y; // s32f27
    wire signed [4:-27] b_x_n43 = m0_z * binormal_z; // s32f27
    // b_y
    wire signed [4:-27] b_y_n46 = m1_x * binormal_x; // s32f27
    wire signed [4:-27] b_y_n47 = m1_y * binormal_y; // s32f27
    wire signed [4:-27] b_y_n48 = m1_z * binormal_z; // s32f27
    // b_z
    wire signed [4:-27] b_z_n51 = m2_x * binormal_x; // s32f27
    wire signed [4:-27] b_z_n52 = m2_y * binormal_y; // s32f27
    wire signed [4:-27] b_z_n53 = m2_z * binormal_z; // s32f27
    // (unit)
    wire signed [13:-15] l_x = {light_x[12], light_x} - {vertex_x[12], vertex_x}; // s29f15
    wire signed [13:-15] l_y = {light_y[12], light_y} - {vertex_y[12], vertex_y}; // s29f15
    wire signed [13:-15] l_z = {light_z[12], light_z} - {vertex_z[12], vertex_z}; // s29f15
    // l_block
    wire [13:-15] l_block_n62_neg = -l_x;
    wire [13:-15] l_block_n62 = l_x[13] ? l_block_n62_neg : l_x; // u29f15
    wire [28:0] l_block_n63 = l_block_n62; // u29f0
    wire [13:-15] l_block_n64_neg = -l_y;
    wire [13:-15] l_block_n64 = l_y[13] ? l_block_n64_neg : l_y; // u29f15
    wire [28:0] l_block_n65 = l_block_n64; // u29f0
    wire [13:-15] l_block_n66_neg = -l_z;
    wire [13:-15] l_block_n66 = l_z[13] ? l_block_n66_neg : l_z; // u29f15
    wire [28:0] l_block_n67 = l_block_n66; // u29f0
    wire [28:0] l_block_n68 = l_block_n63 | l_block_n65; // u29f0
    wire [28:0] l_block_n69 = l_block_n68 | l_block_n67; // u29f0
    wire [13:-15] l_block_largest = l_block_n69; // u29f15
    wire l_block_n71 = 1'b0; // u1f0
    wire [28:0] l_block_n72 = l_block_largest; // u29f0
    wire [15:0] l_block_n73 = l_block_n72[28:13]; // u16f0
    wire [12:0] l_block_n75 = l_block_n72[12:0]; // u13f0
    wire [15:0] l_block_n76 = 16'h0; // u16f0
    wire [28:0] l_block_n77 = {l_block_n75, l_block_n76}; // u29f0
    wire [7:0] l_block_n82 = 8'h0; // u8f0
    wire [3:0] l_block_n88 = 4'h0; // u4f0
    wire [1:0] l_block_n94 = 2'h0; // u2f0
    wire l_block_n104 = l_x[13]; // u1f0
    wire [28:0] l_block_n105 = l_x; // u29f0
    wire [29:0] l_block_n106 = {l_block_n104, l_block_n105}; // u30f0
    wire [13:0] l_block_n108 = l_block_n106[13:0]; // u14f0
    wire [29:0] l_block_n109 = {l_block_n108, l_block_n76}; // u30f0
    wire l_block_n129 = l_y[13]; // u1f0
    wire [28:0] l_block_n130 = l_y; // u29f0
    wire [29:0] l_block_n131 = {l_block_n129, l_block_n130}; // u30f0
    wire [13:0] l_block_n132 = l_block_n131[13:0]; // u14f0
    wire [29:0] l_block_n133 = {l_block_n132, l_block_n76}; // u30f0
    wire l_block_n149 = l_z[13]; // u1f0
    wire [28:0] l_block_n150 = l_z; // u29f0
    wire [29:0] l_block_n151 = {l_block_n149, l_block_n150}; // u30f0
    wire [13:0] l_block_n152 = l_block_n151[13:0]; // u14f0
    wire [29:0] l_block_n153 = {l_block_n152, l_block_n76}; // u30f0
    // reciprocal_length
    wire reciprocal_length_n210 = 1'b1; // u1f0
    wire reciprocal_length_n225 = 1'b1; // u1e2

    reg signed [6:-18] s0_s1; // s25f18
    reg signed [6:-18] t0_s1; // s25f18
    reg signed [4:-27] t_x_n23_s1; // s32f27
    reg signed [4:-27] t_x_n24_s1; // s32f27
    reg signed [4:-27] t_x_n25_s1; // s32f27
    reg signed [4:-27] t_y_n28_s1; // s32f27
    reg signed [4:-27] t_y_n29_s1; // s32f27
    reg signed [4:-27] t_y_n30_s1; // s32f27
    reg signed [4:-27] t_z_n33_s1; // s32f27
    reg signed [4:-27] t_z_n34_s1; // s32f27
    reg signed [4:-27] t_z_n35_s1; // s32f27
    reg signed [4:-27] b_x_n41_s1; // s32f27
    reg signed [4:-27] b_x_n42_s1; // s32f27
    reg signed [4:-27] b_x_n43_s1; // s32f27
    reg signed [4:-27] b_y_n46_s1; // s32f27
    reg signed [4:-27] b_y_n47_s1; // s32f27
    reg signed [4:-27] b_y_n48_s1; // s32f27
    reg signed [4:-27] b_z_n51_s1; // s32f27
    reg signed [4:-27] b_z_n52_s1; // s32f27
    reg signed [4:-27] b_z_n53_s1; // s32f27
    reg [13:-15] l_block_largest_s1; // u29f15
    reg [28:0] l_block_n72_s1; // u29f0
    reg [15:0] l_block_n73_s1; // u16f0
    reg [28:0] l_block_n77_s1; // u29f0
    reg [29:0] l_block_n106_s1; // u30f0
    reg [29:0] l_block_n109_s1; // u30f0
    reg [29:0] l_block_n131_s1; // u30f0
    reg [29:0] l_block_n133_s1; // u30f0
    reg [29:0] l_block_n151_s1; // u30f0
    reg [29:0] l_block_n153_s1; // u30f0
    always @(posedge clk)
        if (ce) begin
            s0_s1 <= s0;
            t0_s1 <= t0;
            t_x_n23_s1 <= t_x_n23;
            t_x_n24_s1 <= t_x_n24;
            t_x_n25_s1 <= t_x_n25;
            t_y_n28_s1 <= t_y_n28;
            t_y_n29_s1 <= t_y_n29;
            t_y_n30_s1 <= t_y_n30;
            t_z_n33_s1 <= t_z_n33;
            t_z_n34_s1 <= t_z_n34;
            t_z_n35_s1 <= t_z_n35;
            b_x_n41_s1 <= b_x_n41;
            b_x_n42_s1 <= b_x_n42;
            b_x_n43_s1 <= b_x_n43;
            b_y_n46_s1 <= b_y_n46;
            b_y_n47_s1 <= b_y_n47;
            b_y_n48_s1 <= b_y_n48;
            b_z_n51_s1 <= b_z_n51;
            b_z_n52_s1 <= b_z_n52;
            b_z_n53_s1 <= b_z_n53;
            l_block_largest_s1 <= l_block_largest;
            l_block_n72_s1 <= l_block_n72;
            l_block_n73_s1 <= l_block_n73;
            l_block_n77_s1 <= l_block_n77;
            l_block_n106_s1 <= l_block_n106;
            l_block_n109_s1 <= l_block_n109;
            l_block_n131_s1 <= l_block_n131;
            l_block_n133_s1 <= l_block_n133;
            l_block_n151_s1 <= l_block_n151;
            l_block_n153_s1 <= l_block_n153;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // t_x
    wire signed [5:-27] t_x_n26 = {t_x_n23_s1[4], t_x_n23_s1} + {t_x_n24_s1[4], t_x_n24_s1}; // s33f27
    wire signed [6:-27] t_x_n27 = {t_x_n26[5], t_x_n26} + {{2{t_x_n25_s1[4]}}, t_x_n25_s1}; // s34f27
    // t_y
    wire signed [5:-27] t_y_n31 = {t_y_n28_s1[4], t_y_n28_s1} + {t_y_n29_s1[4], t_y_n29_s1}; // s33f27
    wire signed [6:-27] t_y_n32 = {t_y_n31[5], t_y_n31} + {{2{t_y_n30_s1[4]}}, t_y_n30_s1}; // s34f27
    // t_z
    wire signed [5:-27] t_z_n36 = {t_z_n33_s1[4], t_z_n33_s1} + {t_z_n34_s1[4], t_z_n34_s1}; // s33f27
    wire signed [6:-27] t_z_n37 = {t_z_n36[5], t_z_n36} + {{2{t_z_n35_s1[4]}}, t_z_n35_s1}; // s34f27
    // (unit)
    wire signed [7:-27] t_eye_x_sum = {t_x_n27[6], t_x_n27} + 35'h100;
    wire signed [7:-18] t_eye_x_cut = t_eye_x_sum[7:-18];
    wire signed [7:-18] t_eye_x = t_eye_x_cut; // s26f18
    wire signed [7:-27] t_eye_y_sum = {t_y_n32[6], t_y_n32} + 35'h100;
    wire signed [7:-18] t_eye_y_cut = t_eye_y_sum[7:-18];
    wire signed [7:-18] t_eye_y = t_eye_y_cut; // s26f18
    wire signed [7:-27] t_eye_z_sum = {t_z_n37[6], t_z_n37} + 35'h100;
    wire signed [7:-18] t_eye_z_cut = t_eye_z_sum[7:-18];
    wire signed [7:-18] t_eye_z = t_eye_z_cut; // s26f18
    // b_x
    wire signed [5:-27] b_x_n44 = {b_x_n41_s1[4], b_x_n41_s1} + {b_x_n42_s1[4], b_x_n42_s1}; // s33f27
    wire signed [6:-27] b_x_n45 = {b_x_n44[5], b_x_n44} + {{2{b_x_n43_s1[4]}}, b_x_n43_s1}; // s34f27
    // b_y
    wire signed [5:-27] b_y_n49 = {b_y_n46_s1[4], b_y_n46_s1} + {b_y_n47_s1[4], b_y_n47_s1}; // s33f27
    wire signed [6:-27] b_y_n50 = {b_y_n49[5], b_y_n49} + {{2{b_y_n48_s1[4]}}, b_y_n48_s1}; // s34f27
    // b_z
    wire signed [5:-27] b_z_n54 = {b_z_n51_s1[4], b_z_n51_s1} + {b_z_n52_s1[4], b_z_n52_s1}; // s33f27
    wire signed [6:-27] b_z_n55 = {b_z_n54[5], b_z_n54} + {{2{b_z_n53_s1[4]}}, b_z_n53_s1}; // s34f27
    // (unit)
    wire signed [7:-27] b_eye_x_sum = {b_x_n45[6], b_x_n45} + 35'h100;
    wire signed [7:-18] b_eye_x_cut = b_eye_x_sum[7:-18];
    wire signed [7:-18] b_eye_x = b_eye_x_cut; // s26f18
    wire signed [7:-27] b_eye_y_sum = {b_y_n50[6], b_y_n50} + 35'h100;
    wire signed [7:-18] b_eye_y_cut = b_eye_y_sum[7:-18];
    wire signed [7:-18] b_eye_y = b_eye_y_cut; // s26f18
    wire signed [7:-27] b_eye_z_sum = {b_z_n55[6], b_z_n55} + 35'h100;
    wire signed [7:-18] b_eye_z_cut = b_eye_z_sum[7:-18];
    wire signed [7:-18] b_eye_z = b_eye_z_cut; // s26f18
    // l_block
    wire l_block_n74 = l_block_n73_s1 == {15'h0, l_block_n71}; // u1f0
    wire [28:0] l_block_n78 = l_block_n74 ? l_block_n77_s1 : l_block_n72_s1; // u29f0
    wire [7:0] l_block_n79 = l_block_n78[28:21]; // u8f0
    wire l_block_n80 = l_block_n79 == {7'h0, l_block_n71}; // u1f0
    wire [20:0] l_block_n81 = l_block_n78[20:0]; // u21f0
    wire [28:0] l_block_n83 = {l_block_n81, l_block_n82}; // u29f0
    wire [28:0] l_block_n84 = l_block_n80 ? l_block_n83 : l_block_n78; // u29f0
    wire [3:0] l_block_n85 = l_block_n84[28:25]; // u4f0
    wire l_block_n86 = l_block_n85 == {3'h0, l_block_n71}; // u1f0
    wire [24:0] l_block_n87 = l_block_n84[24:0]; // u25f0
    wire [28:0] l_block_n89 = {l_block_n87, l_block_n88}; // u29f0
    wire [28:0] l_block_n90 = l_block_n86 ? l_block_n89 : l_block_n84; // u29f0
    wire [1:0] l_block_n91 = l_block_n90[28:27]; // u2f0
    wire [26:0] l_block_n93 = l_block_n90[26:0]; // u27f0
    wire [28:0] l_block_n95 = {l_block_n93, l_block_n94}; // u29f0
    wire [1:0] l_block_n99 = {l_block_n74, l_block_n80}; // u2f0
    wire [2:0] l_block_n100 = {l_block_n99, l_block_n86}; // u3f0
    wire l_block_n103 = l_block_largest_s1 == {13'h0, l_block_n71, 15'h0}; // u1f0

    reg signed [6:-18] s0_s2; // s25f18
    reg signed [6:-18] t0_s2; // s25f18
    reg signed [7:-18] t_eye_x_s2; // s26f18
    reg signed [7:-18] t_eye_y_s2; // s26f18
    reg signed [7:-18] t_eye_z_s2; // s26f18
    reg signed [7:-18] b_eye_x_s2; // s26f18
    reg signed [7:-18] b_eye_y_s2; // s26f18
    reg signed [7:-18] b_eye_z_s2; // s26f18
    reg [28:0] l_block_n90_s2; // u29f0
    reg [1:0] l_block_n91_s2; // u2f0
    reg [28:0] l_block_n95_s2; // u29f0
    reg [2:0] l_block_n100_s2; // u3f0
    reg l_block_n103_s2; // u1f0
    reg [29:0] l_block_n106_s2; // u30f0
    reg [29:0] l_block_n109_s2; // u30f0
    reg [29:0] l_block_n131_s2; // u30f0
    reg [29:0] l_block_n133_s2; // u30f0
    reg [29:0] l_block_n151_s2; // u30f0
    reg [29:0] l_block_n153_s2; // u30f0
    always @(posedge clk)
        if (ce) begin
            s0_s2 <= s0_s1;
            t0_s2 <= t0_s1;
            t_eye_x_s2 <= t_eye_x;
            t_eye_y_s2 <= t_eye_y;
            t_eye_z_s2 <= t_eye_z;
            b_eye_x_s2 <= b_eye_x;
            b_eye_y_s2 <= b_eye_y;
            b_eye_z_s2 <= b_eye_z;
            l_block_n90_s2 <= l_block_n90;
            l_block_n91_s2 <= l_block_n91;
            l_block_n95_s2 <= l_block_n95;
            l_block_n100_s2 <= l_block_n100;
            l_block_n103_s2 <= l_block_n103;
            l_block_n106_s2 <= l_block_n106_s1;
            l_block_n109_s2 <= l_block_n109_s1;
            l_block_n131_s2 <= l_block_n131_s1;
            l_block_n133_s2 <= l_block_n133_s1;
            l_block_n151_s2 <= l_block_n151_s1;
            l_block_n153_s2 <= l_block_n153_s1;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // l_block
    wire l_block_n92 = l_block_n91_s2 == {1'b0, l_block_n71}; // u1f0
    wire [28:0] l_block_n96 = l_block_n92 ? l_block_n95_s2 : l_block_n90_s2; // u29f0
    wire l_block_n97 = l_block_n96[28]; // u1f0
    wire l_block_n98 = l_block_n97 == l_block_n71; // u1f0
    wire [3:0] l_block_n101 = {l_block_n100_s2, l_block_n92}; // u4f0
    wire [4:0] l_block_places = {l_block_n101, l_block_n98}; // u5f0
    wire l_block_n107 = l_block_places[4]; // u1f0
    wire [29:0] l_block_n110 = l_block_n107 ? l_block_n109_s2 : l_block_n106_s2; // u30f0
    wire l_block_n111 = l_block_places[3]; // u1f0
    wire [21:0] l_block_n112 = l_block_n110[21:0]; // u22f0
    wire [29:0] l_block_n113 = {l_block_n112, l_block_n82}; // u30f0
    wire [29:0] l_block_n114 = l_block_n111 ? l_block_n113 : l_block_n110; // u30f0
    wire l_block_n115 = l_block_places[2]; // u1f0
    wire [25:0] l_block_n116 = l_block_n114[25:0]; // u26f0
    wire [29:0] l_block_n117 = {l_block_n116, l_block_n88}; // u30f0
    wire [29:0] l_block_n118 = l_block_n115 ? l_block_n117 : l_block_n114; // u30f0
    wire l_block_n119 = l_block_places[1]; // u1f0
    wire [27:0] l_block_n120 = l_block_n118[27:0]; // u28f0
    wire [29:0] l_block_n121 = {l_block_n120, l_block_n94}; // u30f0
    wire [29:0] l_block_n122 = l_block_n119 ? l_block_n121 : l_block_n118; // u30f0
    wire l_block_n123 = l_block_places[0]; // u1f0
    wire [28:0] l_block_n124 = l_block_n122[28:0]; // u29f0
    wire [29:0] l_block_n125 = {l_block_n124, l_block_n71}; // u30f0
    wire [29:0] l_block_n126 = l_block_n123 ? l_block_n125 : l_block_n122; // u30f0
    wire signed [29:0] l_block_n127 = l_block_n126; // s30f0
    wire signed [0:-29] l_block_x = l_block_n127; // s30f29
    wire [29:0] l_block_n134 = l_block_n107 ? l_block_n133_s2 : l_block_n131_s2; // u30f0
    wire [21:0] l_block_n135 = l_block_n134[21:0]; // u22f0
    wire [29:0] l_block_n136 = {l_block_n135, l_block_n82}; // u30f0
    wire [29:0] l_block_n137 = l_block_n111 ? l_block_n136 : l_block_n134; // u30f0
    wire [25:0] l_block_n138 = l_block_n137[25:0]; // u26f0
    wire [29:0] l_block_n139 = {l_block_n138, l_block_n88}; // u30f0
    wire [29:0] l_block_n140 = l_block_n115 ? l_block_n139 : l_block_n137; // u30f0
    wire [27:0] l_block_n141 = l_block_n140[27:0]; // u28f0
    wire [29:0] l_block_n142 = {l_block_n141, l_block_n94}; // u30f0
    wire [29:0] l_block_n143 = l_block_n119 ? l_block_n142 : l_block_n140; // u30f0
    wire [28:0] l_block_n144 = l_block_n143[28:0]; // u29f0
    wire [29:0] l_block_n145 = {l_block_n144, l_block_n71}; // u30f0
    wire [29:0] l_block_n146 = l_block_n123 ? l_block_n145 : l_block_n143; // u30f0
    wire signed [29:0] l_block_n147 = l_block_n146; // s30f0
    wire signed [0:-29] l_block_y = l_block_n147; // s30f29
    wire [29:0] l_block_n154 = l_block_n107 ? l_block_n153_s2 : l_block_n151_s2; // u30f0
    wire [21:0] l_block_n155 = l_block_n154[21:0]; // u22f0
    wire [29:0] l_block_n156 = {l_block_n155, l_block_n82}; // u30f0
    wire [29:0] l_block_n157 = l_block_n111 ? l_block_n156 : l_block_n154; // u30f0
    wire [25:0] l_block_n158 = l_block_n157[25:0]; // u26f0
    wire [29:0] l_block_n159 = {l_block_n158, l_block_n88}; // u30f0
    wire [29:0] l_block_n160 = l_block_n115 ? l_block_n159 : l_block_n157; // u30f0
    wire [27:0] l_block_n161 = l_block_n160[27:0]; // u28f0
    wire [29:0] l_block_n162 = {l_block_n161, l_block_n94}; // u30f0
    wire [29:0] l_block_n163 = l_block_n119 ? l_block_n162 : l_block_n160; // u30f0
    wire [28:0] l_block_n164 = l_block_n163[28:0]; // u29f0
    wire [29:0] l_block_n165 = {l_block_n164, l_block_n71}; // u30f0
    wire [29:0] l_block_n166 = l_block_n123 ? l_block_n165 : l_block_n163; // u30f0
    wire signed [29:0] l_block_n167 = l_block_n166; // s30f0
    wire signed [0:-29] l_block_z = l_block_n167; // s30f29

    reg signed [6:-18] s0_s3; // s25f18
    reg signed [6:-18] t0_s3; // s25f18
    reg signed [7:-18] t_eye_x_s3; // s26f18
    reg signed [7:-18] t_eye_y_s3; // s26f18
    reg signed [7:-18] t_eye_z_s3; // s26f18
    reg signed [7:-18] b_eye_x_s3; // s26f18
    reg signed [7:-18] b_eye_y_s3; // s26f18
    reg signed [7:-18] b_eye_z_s3; // s26f18
    reg l_block_n103_s3; // u1f0
    reg signed [0:-29] l_block_x_s3; // s30f29
    reg signed [0:-29] l_block_y_s3; // s30f29
    reg signed [0:-29] l_block_z_s3; // s30f29
    always @(posedge clk)
        if (ce) begin
            s0_s3 <= s0_s2;
            t0_s3 <= t0_s2;
            t_eye_x_s3 <= t_eye_x_s2;
            t_eye_y_s3 <= t_eye_y_s2;
            t_eye_z_s3 <= t_eye_z_s2;
            b_eye_x_s3 <= b_eye_x_s2;
            b_eye_y_s3 <= b_eye_y_s2;
            b_eye_z_s3 <= b_eye_z_s2;
            l_block_n103_s3 <= l_block_n103_s2;
            l_block_x_s3 <= l_block_x;
            l_block_y_s3 <= l_block_y;
            l_block_z_s3 <= l_block_z;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    wire signed [1:-29] l_norm_x_sum = {l_block_x_s3[0], l_block_x_s3} + 31'h800;
    wire signed [1:-17] l_norm_x_cut = l_norm_x_sum[1:-17];
    wire l_norm_x_over = ~l_norm_x_cut[1] & (|l_norm_x_cut[0]);
    wire signed [0:-17] l_norm_x = l_norm_x_over ? 18'h1ffff : l_norm_x_cut[0:-17]; // s18f17
    wire signed [1:-29] l_norm_y_sum = {l_block_y_s3[0], l_block_y_s3} + 31'h800;
    wire signed [1:-17] l_norm_y_cut = l_norm_y_sum[1:-17];
    wire l_norm_y_over = ~l_norm_y_cut[1] & (|l_norm_y_cut[0]);
    wire signed [0:-17] l_norm_y = l_norm_y_over ? 18'h1ffff : l_norm_y_cut[0:-17]; // s18f17
    wire signed [1:-29] l_norm_z_sum = {l_block_z_s3[0], l_block_z_s3} + 31'h800;
    wire signed [1:-17] l_norm_z_cut = l_norm_z_sum[1:-17];
    wire l_norm_z_over = ~l_norm_z_cut[1] & (|l_norm_z_cut[0]);
    wire signed [0:-17] l_norm_z = l_norm_z_over ? 18'h1ffff : l_norm_z_cut[0:-17]; // s18f17

    reg signed [6:-18] s0_s4; // s25f18
    reg signed [6:-18] t0_s4; // s25f18
    reg signed [7:-18] t_eye_x_s4; // s26f18
    reg signed [7:-18] t_eye_y_s4; // s26f18
    reg signed [7:-18] t_eye_z_s4; // s26f18
    reg signed [7:-18] b_eye_x_s4; // s26f18
    reg signed [7:-18] b_eye_y_s4; // s26f18
    reg signed [7:-18] b_eye_z_s4; // s26f18
    reg l_block_n103_s4; // u1f0
    reg signed [0:-17] l_norm_x_s4; // s18f17
    reg signed [0:-17] l_norm_y_s4; // s18f17
    reg signed [0:-17] l_norm_z_s4; // s18f17
    always @(posedge clk)
        if (ce) begin
            s0_s4 <= s0_s3;
            t0_s4 <= t0_s3;
            t_eye_x_s4 <= t_eye_x_s3;
            t_eye_y_s4 <= t_eye_y_s3;
            t_eye_z_s4 <= t_eye_z_s3;
            b_eye_x_s4 <= b_eye_x_s3;
            b_eye_y_s4 <= b_eye_y_s3;
            b_eye_z_s4 <= b_eye_z_s3;
            l_block_n103_s4 <= l_block_n103_s3;
            l_norm_x_s4 <= l_norm_x;
            l_norm_y_s4 <= l_norm_y;
            l_norm_z_s4 <= l_norm_z;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // t_dot_l
    wire signed [8:-35] t_dot_l_n172 = t_eye_x_s4 * l_norm_x_s4; // s44f35
    wire signed [8:-35] t_dot_l_n173 = t_eye_y_s4 * l_norm_y_s4; // s44f35
    wire signed [8:-35] t_dot_l_n174 = t_eye_z_s4 * l_norm_z_s4; // s44f35
    // l_dot_l
    wire signed [1:-34] l_dot_l_n178 = l_norm_x_s4 * l_norm_x_s4; // s36f34
    wire signed [1:-34] l_dot_l_n179 = l_norm_y_s4 * l_norm_y_s4; // s36f34
    wire signed [1:-34] l_dot_l_n180 = l_norm_z_s4 * l_norm_z_s4; // s36f34
    // b_dot_l
    wire signed [8:-35] b_dot_l_n229 = b_eye_x_s4 * l_norm_x_s4; // s44f35
    wire signed [8:-35] b_dot_l_n230 = b_eye_y_s4 * l_norm_y_s4; // s44f35
    wire signed [8:-35] b_dot_l_n231 = b_eye_z_s4 * l_norm_z_s4; // s44f35

    reg signed [6:-18] s0_s5; // s25f18
    reg signed [6:-18] t0_s5; // s25f18
    reg l_block_n103_s5; // u1f0
    reg signed [8:-35] t_dot_l_n172_s5; // s44f35
    reg signed [8:-35] t_dot_l_n173_s5; // s44f35
    reg signed [8:-35] t_dot_l_n174_s5; // s44f35
    reg signed [1:-34] l_dot_l_n178_s5; // s36f34
    reg signed [1:-34] l_dot_l_n179_s5; // s36f34
    reg signed [1:-34] l_dot_l_n180_s5; // s36f34
    reg signed [8:-35] b_dot_l_n229_s5; // s44f35
    reg signed [8:-35] b_dot_l_n230_s5; // s44f35
    reg signed [8:-35] b_dot_l_n231_s5; // s44f35
    always @(posedge clk)
        if (ce) begin
            s0_s5 <= s0_s4;
            t0_s5 <= t0_s4;
            l_block_n103_s5 <= l_block_n103_s4;
            t_dot_l_n172_s5 <= t_dot_l_n172;
            t_dot_l_n173_s5 <= t_dot_l_n173;
            t_dot_l_n174_s5 <= t_dot_l_n174;
            l_dot_l_n178_s5 <= l_dot_l_n178;
            l_dot_l_n179_s5 <= l_dot_l_n179;
            l_dot_l_n180_s5 <= l_dot_l_n180;
            b_dot_l_n229_s5 <= b_dot_l_n229;
            b_dot_l_n230_s5 <= b_dot_l_n230;
            b_dot_l_n231_s5 <= b_dot_l_n231;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // t_dot_l
    wire signed [9:-35] t_dot_l_n175 = {t_dot_l_n172_s5[8], t_dot_l_n172_s5} + {t_dot_l_n173_s5[8], t_dot_l_n173_s5}; // s45f35
    wire signed [10:-35] t_dot_l_n176 = {t_dot_l_n175[9], t_dot_l_n175} + {{2{t_dot_l_n174_s5[8]}}, t_dot_l_n174_s5}; // s46f35
    // l_dot_l
    wire signed [2:-34] l_dot_l_n181 = {l_dot_l_n178_s5[1], l_dot_l_n178_s5} + {l_dot_l_n179_s5[1], l_dot_l_n179_s5}; // s37f34
    wire signed [3:-34] l_dot_l_n182 = {l_dot_l_n181[2], l_dot_l_n181} + {{2{l_dot_l_n180_s5[1]}}, l_dot_l_n180_s5}; // s38f34
    // b_dot_l
    wire signed [9:-35] b_dot_l_n232 = {b_dot_l_n229_s5[8], b_dot_l_n229_s5} + {b_dot_l_n230_s5[8], b_dot_l_n230_s5}; // s45f35
    wire signed [10:-35] b_dot_l_n233 = {b_dot_l_n232[9], b_dot_l_n232} + {{2{b_dot_l_n231_s5[8]}}, b_dot_l_n231_s5}; // s46f35

    reg signed [6:-18] s0_s6; // s25f18
    reg signed [6:-18] t0_s6; // s25f18
    reg l_block_n103_s6; // u1f0
    reg signed [10:-35] t_dot_l_n176_s6; // s46f35
    reg signed [3:-34] l_dot_l_n182_s6; // s38f34
    reg signed [10:-35] b_dot_l_n233_s6; // s46f35
    always @(posedge clk)
        if (ce) begin
            s0_s6 <= s0_s5;
            t0_s6 <= t0_s5;
            l_block_n103_s6 <= l_block_n103_s5;
            t_dot_l_n176_s6 <= t_dot_l_n176;
            l_dot_l_n182_s6 <= l_dot_l_n182;
            b_dot_l_n233_s6 <= b_dot_l_n233;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    wire signed [11:-35] t_l_sum = {t_dot_l_n176_s6[10], t_dot_l_n176_s6} + 47'h4000;
    wire signed [11:-20] t_l_cut = t_l_sum[11:-20];
    wire signed [11:-20] t_l = t_l_cut; // s32f20
    wire signed [4:-34] reciprocal_length_square_sum = {l_dot_l_n182_s6[3], l_dot_l_n182_s6} + 39'h2000;
    wire signed [4:-20] reciprocal_length_square_cut = reciprocal_length_square_sum[4:-20];
    wire reciprocal_length_square_over = ~reciprocal_length_square_cut[4] & (|reciprocal_length_square_cut[3:2]);
    wire reciprocal_length_square_under = reciprocal_length_square_cut[4];
    wire [1:-20] reciprocal_length_square = reciprocal_length_square_over ? 22'h3fffff : reciprocal_length_square_under ? 22'h0 : reciprocal_length_square_cut[1:-20]; // u22f20
    // reciprocal_length
    wire [21:0] reciprocal_length_n184 = reciprocal_length_square; // u22f0
    wire [21:0] reciprocal_length_n185 = reciprocal_length_n184; // u22f0
    wire [15:0] reciprocal_length_n186 = reciprocal_length_n185[21:6]; // u16f0
    wire reciprocal_length_n187 = reciprocal_length_n186 == {15'h0, l_block_n71}; // u1f0
    wire [5:0] reciprocal_length_n188 = reciprocal_length_n185[5:0]; // u6f0
    wire [21:0] reciprocal_length_n189 = {reciprocal_length_n188, l_block_n76}; // u22f0
    wire [21:0] reciprocal_length_n190 = reciprocal_length_n187 ? reciprocal_length_n189 : reciprocal_length_n185; // u22f0
    wire [7:0] reciprocal_length_n191 = reciprocal_length_n190[21:14]; // u8f0
    wire reciprocal_length_n192 = reciprocal_length_n191 == {7'h0, l_block_n71}; // u1f0
    wire [13:0] reciprocal_length_n193 = reciprocal_length_n190[13:0]; // u14f0
    wire [21:0] reciprocal_length_n194 = {reciprocal_length_n193, l_block_n82}; // u22f0
    wire [1:0] reciprocal_length_n206 = {reciprocal_length_n187, reciprocal_length_n192}; // u2f0
    wire reciprocal_length_n226 = reciprocal_length_square == {1'b0, l_block_n71, 20'h0}; // u1f0
    // (unit)
    wire signed [11:-35] b_l_sum = {b_dot_l_n233_s6[10], b_dot_l_n233_s6} + 47'h4000;
    wire signed [11:-20] b_l_cut = b_l_sum[11:-20];
    wire signed [11:-20] b_l = b_l_cut; // s32f20

    reg signed [6:-18] s0_s7; // s25f18
    reg signed [6:-18] t0_s7; // s25f18
    reg l_block_n103_s7; // u1f0
    reg signed [11:-20] t_l_s7; // s32f20
    reg [21:0] reciprocal_length_n190_s7; // u22f0
    reg reciprocal_length_n192_s7; // u1f0
    reg [21:0] reciprocal_length_n194_s7; // u22f0
    reg [1:0] reciprocal_length_n206_s7; // u2f0
    reg reciprocal_length_n226_s7; // u1f0
    reg signed [11:-20] b_l_s7; // s32f20
    always @(posedge clk)
        if (ce) begin
            s0_s7 <= s0_s6;
            t0_s7 <= t0_s6;
            l_block_n103_s7 <= l_block_n103_s6;
            t_l_s7 <= t_l;
            reciprocal_length_n190_s7 <= reciprocal_length_n190;
            reciprocal_length_n192_s7 <= reciprocal_length_n192;
            reciprocal_length_n194_s7 <= reciprocal_length_n194;
            reciprocal_length_n206_s7 <= reciprocal_length_n206;
            reciprocal_length_n226_s7 <= reciprocal_length_n226;
            b_l_s7 <= b_l;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // reciprocal_length
    wire [21:0] reciprocal_length_n195 = reciprocal_length_n192_s7 ? reciprocal_length_n194_s7 : reciprocal_length_n190_s7; // u22f0
    wire [3:0] reciprocal_length_n196 = reciprocal_length_n195[21:18]; // u4f0
    wire reciprocal_length_n197 = reciprocal_length_n196 == {3'h0, l_block_n71}; // u1f0
    wire [17:0] reciprocal_length_n198 = reciprocal_length_n195[17:0]; // u18f0
    wire [21:0] reciprocal_length_n199 = {reciprocal_length_n198, l_block_n88}; // u22f0
    wire [21:0] reciprocal_length_n200 = reciprocal_length_n197 ? reciprocal_length_n199 : reciprocal_length_n195; // u22f0
    wire [1:0] reciprocal_length_n201 = reciprocal_length_n200[21:20]; // u2f0
    wire reciprocal_length_n202 = reciprocal_length_n201 == {1'b0, l_block_n71}; // u1f0
    wire [19:0] reciprocal_length_n203 = reciprocal_length_n200[19:0]; // u20f0
    wire [21:0] reciprocal_length_n204 = {reciprocal_length_n203, l_block_n94}; // u22f0
    wire [21:0] reciprocal_length_n205 = reciprocal_length_n202 ? reciprocal_length_n204 : reciprocal_length_n200; // u22f0
    wire [2:0] reciprocal_length_n207 = {reciprocal_length_n206_s7, reciprocal_length_n197}; // u3f0
    wire [3:0] reciprocal_length_n208 = {reciprocal_length_n207, reciprocal_length_n202}; // u4f0
    wire [1:0] reciprocal_length_n209 = reciprocal_length_n205[21:20]; // u2f0
    wire signed [2:0] reciprocal_length_n211 = {1'b0, reciprocal_length_n209} - {2'h0, reciprocal_length_n210}; // s3f0
    wire [1:0] reciprocal_length_n212 = reciprocal_length_n211[1:0]; // u2f0
    wire [17:0] reciprocal_length_n213 = reciprocal_length_n205[19:2]; // u18f0
    wire [19:0] reciprocal_length_n214 = {reciprocal_length_n212, reciprocal_length_n213}; // u20f0
    wire [-1:-20] reciprocal_length_n215 = reciprocal_length_n214; // u20f20
    // reciprocal_length.recip_root
    wire [8:0] reciprocal_length_recip_root_n216 = reciprocal_length_n215[-1:-9]; // u9f0
    wire [10:0] reciprocal_length_recip_root_n219 = reciprocal_length_n215[-10:-20]; // u11f0

    reg signed [6:-18] s0_s8; // s25f18
    reg signed [6:-18] t0_s8; // s25f18
    reg l_block_n103_s8; // u1f0
    reg signed [11:-20] t_l_s8; // s32f20
    reg [3:0] reciprocal_length_n208_s8; // u4f0
    reg [38:0] recip_root_row;
    reg [10:0] reciprocal_length_recip_root_n219_s8; // u11f0
    reg reciprocal_length_n226_s8; // u1f0
    reg signed [11:-20] b_l_s8; // s32f20
    always @(posedge clk)
        if (ce) begin
            s0_s8 <= s0_s7;
            t0_s8 <= t0_s7;
            l_block_n103_s8 <= l_block_n103_s7;
            t_l_s8 <= t_l_s7;
            reciprocal_length_n208_s8 <= reciprocal_length_n208;
            recip_root_row <= recip_root_rom[reciprocal_length_recip_root_n216];
            reciprocal_length_recip_root_n219_s8 <= reciprocal_length_recip_root_n219;
            reciprocal_length_n226_s8 <= reciprocal_length_n226_s7;
            b_l_s8 <= b_l_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // reciprocal_length.recip_root
    wire [0:-22] reciprocal_length_recip_root_n217 = recip_root_row[38:16]; // u23f22
    wire signed [-18:-33] reciprocal_length_recip_root_n218 = recip_root_row[15:0]; // s16f33

    reg signed [6:-18] s0_s9; // s25f18
    reg signed [6:-18] t0_s9; // s25f18
    reg l_block_n103_s9; // u1f0
    reg signed [11:-20] t_l_s9; // s32f20
    reg [3:0] reciprocal_length_n208_s9; // u4f0
    reg [0:-22] reciprocal_length_recip_root_n217_s9; // u23f22
    reg signed [-18:-33] reciprocal_length_recip_root_n218_s9; // s16f33
    reg [10:0] reciprocal_length_recip_root_n219_s9; // u11f0
    reg reciprocal_length_n226_s9; // u1f0
    reg signed [11:-20] b_l_s9; // s32f20
    always @(posedge clk)
        if (ce) begin
            s0_s9 <= s0_s8;
            t0_s9 <= t0_s8;
            l_block_n103_s9 <= l_block_n103_s8;
            t_l_s9 <= t_l_s8;
            reciprocal_length_n208_s9 <= reciprocal_length_n208_s8;
            reciprocal_length_recip_root_n217_s9 <= reciprocal_length_recip_root_n217;
            reciprocal_length_recip_root_n218_s9 <= reciprocal_length_recip_root_n218;
            reciprocal_length_recip_root_n219_s9 <= reciprocal_length_recip_root_n219_s8;
            reciprocal_length_n226_s9 <= reciprocal_length_n226_s8;
            b_l_s9 <= b_l_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // reciprocal_length.recip_root
    wire signed [-7:-33] reciprocal_length_recip_root_n220 = reciprocal_length_recip_root_n218_s9 * $signed({1'b0, reciprocal_length_recip_root_n219_s9}); // s27f33
    wire signed [2:-33] reciprocal_length_recip_root_n221 = {2'h0, reciprocal_length_recip_root_n217_s9, 11'h0} + {{9{reciprocal_length_recip_root_n220[-7]}}, reciprocal_length_recip_root_n220}; // s36f33

    reg signed [6:-18] s0_s10; // s25f18
    reg signed [6:-18] t0_s10; // s25f18
    reg l_block_n103_s10; // u1f0
    reg signed [11:-20] t_l_s10; // s32f20
    reg [3:0] reciprocal_length_n208_s10; // u4f0
    reg signed [2:-33] reciprocal_length_recip_root_n221_s10; // s36f33
    reg reciprocal_length_n226_s10; // u1f0
    reg signed [11:-20] b_l_s10; // s32f20
    always @(posedge clk)
        if (ce) begin
            s0_s10 <= s0_s9;
            t0_s10 <= t0_s9;
            l_block_n103_s10 <= l_block_n103_s9;
            t_l_s10 <= t_l_s9;
            reciprocal_length_n208_s10 <= reciprocal_length_n208_s9;
            reciprocal_length_recip_root_n221_s10 <= reciprocal_length_recip_root_n221;
            reciprocal_length_n226_s10 <= reciprocal_length_n226_s9;
            b_l_s10 <= b_l_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // reciprocal_length.recip_root
    wire signed [3:-33] reciprocal_length_recip_root_n222_sum = {reciprocal_length_recip_root_n221_s10[2], reciprocal_length_recip_root_n221_s10} + 37'h1000;
    wire signed [3:-20] reciprocal_length_recip_root_n222_cut = reciprocal_length_recip_root_n222_sum[3:-20];
    wire reciprocal_length_recip_root_n222_over = ~reciprocal_length_recip_root_n222_cut[3] & (|reciprocal_length_recip_root_n222_cut[2]);
    wire reciprocal_length_recip_root_n222_under = reciprocal_length_recip_root_n222_cut[3];
    wire [1:-20] reciprocal_length_recip_root_n222 = reciprocal_length_recip_root_n222_over ? 22'h3fffff : reciprocal_length_recip_root_n222_under ? 22'h0 : reciprocal_length_recip_root_n222_cut[1:-20]; // u22f20
    // reciprocal_length
    wire reciprocal_length_n223_past = 4'hb < reciprocal_length_n208_s10;
    wire [3:0] reciprocal_length_n223_count = reciprocal_length_n223_past ? 4'hb : reciprocal_length_n208_s10;
    wire [12:-20] reciprocal_length_n223 = {11'h0, reciprocal_length_recip_root_n222} << reciprocal_length_n223_count; // u33f20
    wire [11:-21] reciprocal_length_n224 = reciprocal_length_n223; // u33f21
    wire [11:-21] reciprocal_length_n227 = reciprocal_length_n226_s10 ? {9'h0, reciprocal_length_n225, 23'h0} : reciprocal_length_n224; // u33f21

    reg signed [6:-18] s0_s11; // s25f18
    reg signed [6:-18] t0_s11; // s25f18
    reg l_block_n103_s11; // u1f0
    reg signed [11:-20] t_l_s11; // s32f20
    reg [11:-21] reciprocal_length_n227_s11; // u33f21
    reg signed [11:-20] b_l_s11; // s32f20
    always @(posedge clk)
        if (ce) begin
            s0_s11 <= s0_s10;
            t0_s11 <= t0_s10;
            l_block_n103_s11 <= l_block_n103_s10;
            t_l_s11 <= t_l_s10;
            reciprocal_length_n227_s11 <= reciprocal_length_n227;
            b_l_s11 <= b_l_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // reciprocal_length
    wire [12:-21] reciprocal_length_reciprocal_length_sum = {1'b0, reciprocal_length_n227_s11} + 34'h4;
    wire [12:-18] reciprocal_length_reciprocal_length_cut = reciprocal_length_reciprocal_length_sum[12:-18];
    wire reciprocal_length_reciprocal_length_over = |reciprocal_length_reciprocal_length_cut[12:2];
    wire [1:-18] reciprocal_length_reciprocal_length = reciprocal_length_reciprocal_length_over ? 20'hfffff : reciprocal_length_reciprocal_length_cut[1:-18]; // u20f18

    reg signed [6:-18] s0_s12; // s25f18
    reg signed [6:-18] t0_s12; // s25f18
    reg l_block_n103_s12; // u1f0
    reg signed [11:-20] t_l_s12; // s32f20
    reg [1:-18] reciprocal_length_reciprocal_length_s12; // u20f18
    reg signed [11:-20] b_l_s12; // s32f20
    always @(posedge clk)
        if (ce) begin
            s0_s12 <= s0_s11;
            t0_s12 <= t0_s11;
            l_block_n103_s12 <= l_block_n103_s11;
            t_l_s12 <= t_l_s11;
            reciprocal_length_reciprocal_length_s12 <= reciprocal_length_reciprocal_length;
            b_l_s12 <= b_l_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    wire signed [13:-38] ds_product = t_l_s12 * $signed({1'b0, reciprocal_length_reciprocal_length_s12}); // s52f38
    wire signed [13:-38] dt_product = b_l_s12 * $signed({1'b0, reciprocal_length_reciprocal_length_s12}); // s52f38

    reg signed [6:-18] s0_s13; // s25f18
    reg signed [6:-18] t0_s13; // s25f18
    reg l_block_n103_s13; // u1f0
    reg signed [13:-38] ds_product_s13; // s52f38
    reg signed [13:-38] dt_product_s13; // s52f38
    always @(posedge clk)
        if (ce) begin
            s0_s13 <= s0_s12;
            t0_s13 <= t0_s12;
            l_block_n103_s13 <= l_block_n103_s12;
            ds_product_s13 <= ds_product;
            dt_product_s13 <= dt_product;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    wire signed [14:-38] ds_next_sum = {ds_product_s13[13], ds_product_s13} + 53'h80000;
    wire signed [14:-18] ds_next_cut = ds_next_sum[14:-18];
    wire ds_next_over = ~ds_next_cut[14] & (|ds_next_cut[13:8]);
    wire ds_next_under = ds_next_cut[14] & ~(&ds_next_cut[13:8]);
    wire signed [8:-18] ds_next = ds_next_over ? 27'h3ffffff : ds_next_under ? 27'h4000000 : ds_next_cut[8:-18]; // s27f18
    wire signed [9:-18] s1_sum = {{3{s0_s13[6]}}, s0_s13} + {ds_next[8], ds_next}; // s28f18
    wire s1_next_over = ~s1_sum[9] & (|s1_sum[8:6]);
    wire s1_next_under = s1_sum[9] & ~(&s1_sum[8:6]);
    wire signed [6:-18] s1_next = s1_next_over ? 25'hffffff : s1_next_under ? 25'h1000000 : s1_sum[6:-18]; // s25f18
    wire signed [14:-38] dt_next_sum = {dt_product_s13[13], dt_product_s13} + 53'h80000;
    wire signed [14:-18] dt_next_cut = dt_next_sum[14:-18];
    wire dt_next_over = ~dt_next_cut[14] & (|dt_next_cut[13:8]);
    wire dt_next_under = dt_next_cut[14] & ~(&dt_next_cut[13:8]);
    wire signed [8:-18] dt_next = dt_next_over ? 27'h3ffffff : dt_next_under ? 27'h4000000 : dt_next_cut[8:-18]; // s27f18
    wire signed [9:-18] t1_sum = {{3{t0_s13[6]}}, t0_s13} + {dt_next[8], dt_next}; // s28f18
    wire t1_next_over = ~t1_sum[9] & (|t1_sum[8:6]);
    wire t1_next_under = t1_sum[9] & ~(&t1_sum[8:6]);
    wire signed [6:-18] t1_next = t1_next_over ? 25'hffffff : t1_next_under ? 25'h1000000 : t1_sum[6:-18]; // s25f18

    always @(posedge clk)
        if (ce) begin
            degenerate <= l_block_n103_s13;
            ds <= ds_next;
            s1 <= s1_next;
            dt <= dt_next;
            t1 <= t1_next;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;
    assign valid_out = valid_s14;

    // ---- stage 14 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        t_eye_x_sum[-19:-27],
        t_eye_y_sum[-19:-27],
        t_eye_z_sum[-19:-27],
        b_eye_x_sum[-19:-27],
        b_eye_y_sum[-19:-27],
        b_eye_z_sum[-19:-27],
        l_block_n96[27:0],
        l_norm_x_sum[-18:-29],
        l_norm_y_sum[-18:-29],
        l_norm_z_sum[-18:-29],
        t_l_sum[-21:-35],
        reciprocal_length_square_sum[-21:-34],
        b_l_sum[-21:-35],
        reciprocal_length_n205[1:0],
        reciprocal_length_n211[2],
        reciprocal_length_recip_root_n222_sum[-21:-33],
        reciprocal_length_reciprocal_length_sum[-19:-21],
        ds_next_sum[-19:-38],
        dt_next_sum[-19:-38]};
endmodule
