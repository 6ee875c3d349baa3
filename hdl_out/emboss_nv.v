// emboss: texture coordinates displaced by the direction of a light, for embossing
// made by fixpath 0.1.0; seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)
//   setting=nv frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
//   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
//   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
//   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
//   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
//   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
//   rom=block
// latency 25 cycles, interval 1 cycle; tables read on the clock
// errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   ds_texels: mean 8.34e-4 texel, largest seen 6.81e-3 texel at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   ds_relative: mean 2.65e-6, largest seen 1.57e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=16750 normal_y=-6938 normal_z=100 ct_x=370 ct_y=-1703 ct_z=18454 light_x=-21858093 light_y=11862104 light_z=22208289 vertex_x=-20247618 vertex_y=12204548 vertex_z=17798660 s0=2324101 t0=-917458 q0=289204 r0=140514
//   ds: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   dt_texels: mean 7.78e-4 texel, largest seen 6.34e-3 texel at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   dt_relative: mean 2.48e-6, largest seen 1.69e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=539 normal_y=10101 normal_z=11796 ct_x=-4134 ct_y=-13685 ct_z=9001 light_x=-16348031 light_y=19544902 light_z=11919376 vertex_x=-16890033 vertex_y=19483858 vertex_z=11791741 s0=601665 t0=-1430898 q0=258948 r0=-148469
//   dt: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   s1: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
//   t1: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
//   q1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
//   r1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
// stated bound on each relative displacement (over the vector's length times its factor, each 1/4 where it is less): 1.09e-4
// stated bound on each displacement: 1.32e-2
// stated bound on each displacement in texels: 3.38e0
// stated bound on each coordinate: 1.32e-2
// stated bound on each flag and what is passed: 0.00e0
module emboss_nv (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [1:-14] normal_x, // s16f14
    input  wire signed [1:-14] normal_y, // s16f14
    input  wire signed [1:-14] normal_z, // s16f14
    input  wire signed [1:-14] ct_x, // s16f14
    input  wire signed [1:-14] ct_y, // s16f14
    input  wire signed [1:-14] ct_z, // s16f14
    input  wire signed [12:-15] light_x, // s28f15
    input  wire signed [12:-15] light_y, // s28f15
    input  wire signed [12:-15] light_z, // s28f15
    input  wire signed [12:-15] vertex_x, // s28f15
    input  wire signed [12:-15] vertex_y, // s28f15
    input  wire signed [12:-15] vertex_z, // s28f15
    input  wire signed [6:-18] s0, // s25f18
    input  wire signed [6:-18] t0, // s25f18
    input  wire signed [6:-18] q0, // s25f18
    input  wire signed [6:-18] r0, // s25f18
    output wire valid_out,
    output reg  signed [11:-18] ds, // s30f18
    output reg  signed [15:-18] dt, // s34f18
    output reg  signed [6:-18] s1, // s25f18
    output reg  signed [6:-18] t1, // s25f18
    output reg  degenerate, // u1f0
    output reg  signed [6:-18] q1, // s25f18
    output reg  signed [6:-18] r1 // s25f18
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
    // n_cross_ct
    wire signed [3:-28] n_cross_ct_n16 = normal_y * ct_z; // s32f28
    wire signed [3:-28] n_cross_ct_n17 = normal_z * ct_y; // s32f28
    wire signed [3:-28] n_cross_ct_n19 = normal_z * ct_x; // s32f28
    wire signed [3:-28] n_cross_ct_n20 = normal_x * ct_z; // s32f28
    wire signed [3:-28] n_cross_ct_n22 = normal_x * ct_y; // s32f28
    wire signed [3:-28] n_cross_ct_n23 = normal_y * ct_x; // s32f28
    // bn
    wire bn_n34 = 1'b0; // u1f0
    wire [31:0] bn_n39 = 32'h0; // u32f0
    wire [15:0] bn_n45 = 16'h0; // u16f0
    wire [7:0] bn_n51 = 8'h0; // u8f0
    wire [3:0] bn_n57 = 4'h0; // u4f0
    wire [1:0] bn_n63 = 2'h0; // u2f0
    // bn_length
    wire bn_length_n184 = 1'b1; // u1f0
    wire bn_length_n199 = 1'b1; // u1e2
    // (unit)
    wire signed [13:-15] l_x = {light_x[12], light_x} - {vertex_x[12], vertex_x}; // s29f15
    wire signed [13:-15] l_y = {light_y[12], light_y} - {vertex_y[12], vertex_y}; // s29f15
    wire signed [13:-15] l_z = {light_z[12], light_z} - {vertex_z[12], vertex_z}; // s29f15
    // l_block
    wire [13:-15] l_block_n224_neg = -l_x;
    wire [13:-15] l_block_n224 = l_x[13] ? l_block_n224_neg : l_x; // u29f15
    wire [28:0] l_block_n225 = l_block_n224; // u29f0
    wire [13:-15] l_block_n226_neg = -l_y;
    wire [13:-15] l_block_n226 = l_y[13] ? l_block_n226_neg : l_y; // u29f15
    wire [28:0] l_block_n227 = l_block_n226; // u29f0
    wire [13:-15] l_block_n228_neg = -l_z;
    wire [13:-15] l_block_n228 = l_z[13] ? l_block_n228_neg : l_z; // u29f15
    wire [28:0] l_block_n229 = l_block_n228; // u29f0
    wire [28:0] l_block_n230 = l_block_n225 | l_block_n227; // u29f0
    wire [28:0] l_block_n231 = l_block_n230 | l_block_n229; // u29f0
    wire [13:-15] l_block_largest = l_block_n231; // u29f15
    wire [28:0] l_block_n233 = l_block_largest; // u29f0
    wire [15:0] l_block_n234 = l_block_n233[28:13]; // u16f0
    wire [12:0] l_block_n236 = l_block_n233[12:0]; // u13f0
    wire [28:0] l_block_n237 = {l_block_n236, bn_n45}; // u29f0
    wire l_block_n261 = l_x[13]; // u1f0
    wire [28:0] l_block_n262 = l_x; // u29f0
    wire [29:0] l_block_n263 = {l_block_n261, l_block_n262}; // u30f0
    wire [13:0] l_block_n265 = l_block_n263[13:0]; // u14f0
    wire [29:0] l_block_n266 = {l_block_n265, bn_n45}; // u30f0
    wire l_block_n286 = l_y[13]; // u1f0
    wire [28:0] l_block_n287 = l_y; // u29f0
    wire [29:0] l_block_n288 = {l_block_n286, l_block_n287}; // u30f0
    wire [13:0] l_block_n289 = l_block_n288[13:0]; // u14f0
    wire [29:0] l_block_n290 = {l_block_n289, bn_n45}; // u30f0
    wire l_block_n306 = l_z[13]; // u1f0
    wire [28:0] l_block_n307 = l_z; // u29f0
    wire [29:0] l_block_n308 = {l_block_n306, l_block_n307}; // u30f0
    wire [13:0] l_block_n309 = l_block_n308[13:0]; // u14f0
    wire [29:0] l_block_n310 = {l_block_n309, bn_n45}; // u30f0
    // (unit)
    wire signed [1:-20] n392 = 22'h100000; // s22f20
    wire signed [8:-38] n393 = n392 * q0; // s47f38

    reg signed [1:-14] normal_x_s1; // s16f14
    reg signed [1:-14] normal_y_s1; // s16f14
    reg signed [1:-14] normal_z_s1; // s16f14
    reg signed [6:-18] s0_s1; // s25f18
    reg signed [6:-18] t0_s1; // s25f18
    reg signed [6:-18] q0_s1; // s25f18
    reg signed [6:-18] r0_s1; // s25f18
    reg signed [3:-28] n_cross_ct_n16_s1; // s32f28
    reg signed [3:-28] n_cross_ct_n17_s1; // s32f28
    reg signed [3:-28] n_cross_ct_n19_s1; // s32f28
    reg signed [3:-28] n_cross_ct_n20_s1; // s32f28
    reg signed [3:-28] n_cross_ct_n22_s1; // s32f28
    reg signed [3:-28] n_cross_ct_n23_s1; // s32f28
    reg [13:-15] l_block_largest_s1; // u29f15
    reg [28:0] l_block_n233_s1; // u29f0
    reg [15:0] l_block_n234_s1; // u16f0
    reg [28:0] l_block_n237_s1; // u29f0
    reg [29:0] l_block_n263_s1; // u30f0
    reg [29:0] l_block_n266_s1; // u30f0
    reg [29:0] l_block_n288_s1; // u30f0
    reg [29:0] l_block_n290_s1; // u30f0
    reg [29:0] l_block_n308_s1; // u30f0
    reg [29:0] l_block_n310_s1; // u30f0
    reg signed [8:-38] n393_s1; // s47f38
    always @(posedge clk)
        if (ce) begin
            normal_x_s1 <= normal_x;
            normal_y_s1 <= normal_y;
            normal_z_s1 <= normal_z;
            s0_s1 <= s0;
            t0_s1 <= t0;
            q0_s1 <= q0;
            r0_s1 <= r0;
            n_cross_ct_n16_s1 <= n_cross_ct_n16;
            n_cross_ct_n17_s1 <= n_cross_ct_n17;
            n_cross_ct_n19_s1 <= n_cross_ct_n19;
            n_cross_ct_n20_s1 <= n_cross_ct_n20;
            n_cross_ct_n22_s1 <= n_cross_ct_n22;
            n_cross_ct_n23_s1 <= n_cross_ct_n23;
            l_block_largest_s1 <= l_block_largest;
            l_block_n233_s1 <= l_block_n233;
            l_block_n234_s1 <= l_block_n234;
            l_block_n237_s1 <= l_block_n237;
            l_block_n263_s1 <= l_block_n263;
            l_block_n266_s1 <= l_block_n266;
            l_block_n288_s1 <= l_block_n288;
            l_block_n290_s1 <= l_block_n290;
            l_block_n308_s1 <= l_block_n308;
            l_block_n310_s1 <= l_block_n310;
            n393_s1 <= n393;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // n_cross_ct
    wire signed [4:-28] n_cross_ct_n18 = {n_cross_ct_n16_s1[3], n_cross_ct_n16_s1} - {n_cross_ct_n17_s1[3], n_cross_ct_n17_s1}; // s33f28
    wire signed [4:-28] n_cross_ct_n21 = {n_cross_ct_n19_s1[3], n_cross_ct_n19_s1} - {n_cross_ct_n20_s1[3], n_cross_ct_n20_s1}; // s33f28
    wire signed [4:-28] n_cross_ct_n24 = {n_cross_ct_n22_s1[3], n_cross_ct_n22_s1} - {n_cross_ct_n23_s1[3], n_cross_ct_n23_s1}; // s33f28
    // bn
    wire [4:-28] bn_n25_neg = -n_cross_ct_n18;
    wire [4:-28] bn_n25 = n_cross_ct_n18[4] ? bn_n25_neg : n_cross_ct_n18; // u33f28
    wire [32:0] bn_n26 = bn_n25; // u33f0
    wire [4:-28] bn_n27_neg = -n_cross_ct_n21;
    wire [4:-28] bn_n27 = n_cross_ct_n21[4] ? bn_n27_neg : n_cross_ct_n21; // u33f28
    wire [32:0] bn_n28 = bn_n27; // u33f0
    wire [4:-28] bn_n29_neg = -n_cross_ct_n24;
    wire [4:-28] bn_n29 = n_cross_ct_n24[4] ? bn_n29_neg : n_cross_ct_n24; // u33f28
    wire [32:0] bn_n30 = bn_n29; // u33f0
    wire [32:0] bn_n31 = bn_n26 | bn_n28; // u33f0
    wire [32:0] bn_n32 = bn_n31 | bn_n30; // u33f0
    wire [4:-28] bn_largest = bn_n32; // u33f28
    wire [32:0] bn_n35 = bn_largest; // u33f0
    wire [31:0] bn_n36 = bn_n35[32:1]; // u32f0
    wire bn_n38 = bn_n35[0]; // u1f0
    wire [32:0] bn_n40 = {bn_n38, bn_n39}; // u33f0
    wire bn_n74 = n_cross_ct_n18[4]; // u1f0
    wire [32:0] bn_n75 = n_cross_ct_n18; // u33f0
    wire [33:0] bn_n76 = {bn_n74, bn_n75}; // u34f0
    wire [1:0] bn_n78 = bn_n76[1:0]; // u2f0
    wire [33:0] bn_n79 = {bn_n78, bn_n39}; // u34f0
    wire bn_n103 = n_cross_ct_n21[4]; // u1f0
    wire [32:0] bn_n104 = n_cross_ct_n21; // u33f0
    wire [33:0] bn_n105 = {bn_n103, bn_n104}; // u34f0
    wire [1:0] bn_n106 = bn_n105[1:0]; // u2f0
    wire [33:0] bn_n107 = {bn_n106, bn_n39}; // u34f0
    wire bn_n126 = n_cross_ct_n24[4]; // u1f0
    wire [32:0] bn_n127 = n_cross_ct_n24; // u33f0
    wire [33:0] bn_n128 = {bn_n126, bn_n127}; // u34f0
    wire [1:0] bn_n129 = bn_n128[1:0]; // u2f0
    wire [33:0] bn_n130 = {bn_n129, bn_n39}; // u34f0
    // l_block
    wire l_block_n235 = l_block_n234_s1 == {15'h0, bn_n34}; // u1f0
    wire [28:0] l_block_n238 = l_block_n235 ? l_block_n237_s1 : l_block_n233_s1; // u29f0
    wire [7:0] l_block_n239 = l_block_n238[28:21]; // u8f0
    wire l_block_n240 = l_block_n239 == {7'h0, bn_n34}; // u1f0
    wire [20:0] l_block_n241 = l_block_n238[20:0]; // u21f0
    wire [28:0] l_block_n242 = {l_block_n241, bn_n51}; // u29f0
    wire [28:0] l_block_n243 = l_block_n240 ? l_block_n242 : l_block_n238; // u29f0
    wire [3:0] l_block_n244 = l_block_n243[28:25]; // u4f0
    wire l_block_n245 = l_block_n244 == {3'h0, bn_n34}; // u1f0
    wire [24:0] l_block_n246 = l_block_n243[24:0]; // u25f0
    wire [28:0] l_block_n247 = {l_block_n246, bn_n57}; // u29f0
    wire [28:0] l_block_n248 = l_block_n245 ? l_block_n247 : l_block_n243; // u29f0
    wire [1:0] l_block_n249 = l_block_n248[28:27]; // u2f0
    wire [26:0] l_block_n251 = l_block_n248[26:0]; // u27f0
    wire [28:0] l_block_n252 = {l_block_n251, bn_n63}; // u29f0
    wire [1:0] l_block_n256 = {l_block_n235, l_block_n240}; // u2f0
    wire [2:0] l_block_n257 = {l_block_n256, l_block_n245}; // u3f0
    wire l_block_n260 = l_block_largest_s1 == {13'h0, bn_n34, 15'h0}; // u1f0
    // (unit)
    wire signed [9:-38] ks_q_sum = {n393_s1[8], n393_s1} + 48'h20000;
    wire signed [9:-20] ks_q_cut = ks_q_sum[9:-20];
    wire signed [9:-20] ks_q = ks_q_cut; // s30f20

    reg signed [1:-14] normal_x_s2; // s16f14
    reg signed [1:-14] normal_y_s2; // s16f14
    reg signed [1:-14] normal_z_s2; // s16f14
    reg signed [6:-18] s0_s2; // s25f18
    reg signed [6:-18] t0_s2; // s25f18
    reg signed [6:-18] q0_s2; // s25f18
    reg signed [6:-18] r0_s2; // s25f18
    reg [4:-28] bn_largest_s2; // u33f28
    reg [32:0] bn_n35_s2; // u33f0
    reg [31:0] bn_n36_s2; // u32f0
    reg [32:0] bn_n40_s2; // u33f0
    reg [33:0] bn_n76_s2; // u34f0
    reg [33:0] bn_n79_s2; // u34f0
    reg [33:0] bn_n105_s2; // u34f0
    reg [33:0] bn_n107_s2; // u34f0
    reg [33:0] bn_n128_s2; // u34f0
    reg [33:0] bn_n130_s2; // u34f0
    reg [28:0] l_block_n248_s2; // u29f0
    reg [1:0] l_block_n249_s2; // u2f0
    reg [28:0] l_block_n252_s2; // u29f0
    reg [2:0] l_block_n257_s2; // u3f0
    reg l_block_n260_s2; // u1f0
    reg [29:0] l_block_n263_s2; // u30f0
    reg [29:0] l_block_n266_s2; // u30f0
    reg [29:0] l_block_n288_s2; // u30f0
    reg [29:0] l_block_n290_s2; // u30f0
    reg [29:0] l_block_n308_s2; // u30f0
    reg [29:0] l_block_n310_s2; // u30f0
    reg signed [9:-20] ks_q_s2; // s30f20
    always @(posedge clk)
        if (ce) begin
            normal_x_s2 <= normal_x_s1;
            normal_y_s2 <= normal_y_s1;
            normal_z_s2 <= normal_z_s1;
            s0_s2 <= s0_s1;
            t0_s2 <= t0_s1;
            q0_s2 <= q0_s1;
            r0_s2 <= r0_s1;
            bn_largest_s2 <= bn_largest;
            bn_n35_s2 <= bn_n35;
            bn_n36_s2 <= bn_n36;
            bn_n40_s2 <= bn_n40;
            bn_n76_s2 <= bn_n76;
            bn_n79_s2 <= bn_n79;
            bn_n105_s2 <= bn_n105;
            bn_n107_s2 <= bn_n107;
            bn_n128_s2 <= bn_n128;
            bn_n130_s2 <= bn_n130;
            l_block_n248_s2 <= l_block_n248;
            l_block_n249_s2 <= l_block_n249;
            l_block_n252_s2 <= l_block_n252;
            l_block_n257_s2 <= l_block_n257;
            l_block_n260_s2 <= l_block_n260;
            l_block_n263_s2 <= l_block_n263_s1;
            l_block_n266_s2 <= l_block_n266_s1;
            l_block_n288_s2 <= l_block_n288_s1;
            l_block_n290_s2 <= l_block_n290_s1;
            l_block_n308_s2 <= l_block_n308_s1;
            l_block_n310_s2 <= l_block_n310_s1;
            ks_q_s2 <= ks_q;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // bn
    wire bn_n37 = bn_n36_s2 == {31'h0, bn_n34}; // u1f0
    wire [32:0] bn_n41 = bn_n37 ? bn_n40_s2 : bn_n35_s2; // u33f0
    wire [15:0] bn_n42 = bn_n41[32:17]; // u16f0
    wire bn_n43 = bn_n42 == {15'h0, bn_n34}; // u1f0
    wire [16:0] bn_n44 = bn_n41[16:0]; // u17f0
    wire [32:0] bn_n46 = {bn_n44, bn_n45}; // u33f0
    wire [32:0] bn_n47 = bn_n43 ? bn_n46 : bn_n41; // u33f0
    wire [7:0] bn_n48 = bn_n47[32:25]; // u8f0
    wire bn_n49 = bn_n48 == {7'h0, bn_n34}; // u1f0
    wire [24:0] bn_n50 = bn_n47[24:0]; // u25f0
    wire [32:0] bn_n52 = {bn_n50, bn_n51}; // u33f0
    wire [1:0] bn_n68 = {bn_n37, bn_n43}; // u2f0
    wire [2:0] bn_n69 = {bn_n68, bn_n49}; // u3f0
    wire bn_n73 = bn_largest_s2 == {4'h0, bn_n34, 28'h0}; // u1f0
    // l_block
    wire l_block_n250 = l_block_n249_s2 == {1'b0, bn_n34}; // u1f0
    wire [28:0] l_block_n253 = l_block_n250 ? l_block_n252_s2 : l_block_n248_s2; // u29f0
    wire l_block_n254 = l_block_n253[28]; // u1f0
    wire l_block_n255 = l_block_n254 == bn_n34; // u1f0
    wire [3:0] l_block_n258 = {l_block_n257_s2, l_block_n250}; // u4f0
    wire [4:0] l_block_places = {l_block_n258, l_block_n255}; // u5f0
    wire l_block_n264 = l_block_places[4]; // u1f0
    wire [29:0] l_block_n267 = l_block_n264 ? l_block_n266_s2 : l_block_n263_s2; // u30f0
    wire l_block_n268 = l_block_places[3]; // u1f0
    wire [21:0] l_block_n269 = l_block_n267[21:0]; // u22f0
    wire [29:0] l_block_n270 = {l_block_n269, bn_n51}; // u30f0
    wire [29:0] l_block_n271 = l_block_n268 ? l_block_n270 : l_block_n267; // u30f0
    wire l_block_n272 = l_block_places[2]; // u1f0
    wire [25:0] l_block_n273 = l_block_n271[25:0]; // u26f0
    wire [29:0] l_block_n274 = {l_block_n273, bn_n57}; // u30f0
    wire [29:0] l_block_n275 = l_block_n272 ? l_block_n274 : l_block_n271; // u30f0
    wire l_block_n276 = l_block_places[1]; // u1f0
    wire [27:0] l_block_n277 = l_block_n275[27:0]; // u28f0
    wire [29:0] l_block_n278 = {l_block_n277, bn_n63}; // u30f0
    wire [29:0] l_block_n279 = l_block_n276 ? l_block_n278 : l_block_n275; // u30f0
    wire l_block_n280 = l_block_places[0]; // u1f0
    wire [28:0] l_block_n281 = l_block_n279[28:0]; // u29f0
    wire [29:0] l_block_n282 = {l_block_n281, bn_n34}; // u30f0
    wire [29:0] l_block_n283 = l_block_n280 ? l_block_n282 : l_block_n279; // u30f0
    wire signed [29:0] l_block_n284 = l_block_n283; // s30f0
    wire signed [0:-29] l_block_x = l_block_n284; // s30f29
    wire [29:0] l_block_n291 = l_block_n264 ? l_block_n290_s2 : l_block_n288_s2; // u30f0
    wire [21:0] l_block_n292 = l_block_n291[21:0]; // u22f0
    wire [29:0] l_block_n293 = {l_block_n292, bn_n51}; // u30f0
    wire [29:0] l_block_n294 = l_block_n268 ? l_block_n293 : l_block_n291; // u30f0
    wire [25:0] l_block_n295 = l_block_n294[25:0]; // u26f0
    wire [29:0] l_block_n296 = {l_block_n295, bn_n57}; // u30f0
    wire [29:0] l_block_n297 = l_block_n272 ? l_block_n296 : l_block_n294; // u30f0
    wire [27:0] l_block_n298 = l_block_n297[27:0]; // u28f0
    wire [29:0] l_block_n299 = {l_block_n298, bn_n63}; // u30f0
    wire [29:0] l_block_n300 = l_block_n276 ? l_block_n299 : l_block_n297; // u30f0
    wire [28:0] l_block_n301 = l_block_n300[28:0]; // u29f0
    wire [29:0] l_block_n302 = {l_block_n301, bn_n34}; // u30f0
    wire [29:0] l_block_n303 = l_block_n280 ? l_block_n302 : l_block_n300; // u30f0
    wire signed [29:0] l_block_n304 = l_block_n303; // s30f0
    wire signed [0:-29] l_block_y = l_block_n304; // s30f29
    wire [29:0] l_block_n311 = l_block_n264 ? l_block_n310_s2 : l_block_n308_s2; // u30f0
    wire [21:0] l_block_n312 = l_block_n311[21:0]; // u22f0
    wire [29:0] l_block_n313 = {l_block_n312, bn_n51}; // u30f0
    wire [29:0] l_block_n314 = l_block_n268 ? l_block_n313 : l_block_n311; // u30f0
    wire [25:0] l_block_n315 = l_block_n314[25:0]; // u26f0
    wire [29:0] l_block_n316 = {l_block_n315, bn_n57}; // u30f0
    wire [29:0] l_block_n317 = l_block_n272 ? l_block_n316 : l_block_n314; // u30f0
    wire [27:0] l_block_n318 = l_block_n317[27:0]; // u28f0
    wire [29:0] l_block_n319 = {l_block_n318, bn_n63}; // u30f0
    wire [29:0] l_block_n320 = l_block_n276 ? l_block_n319 : l_block_n317; // u30f0
    wire [28:0] l_block_n321 = l_block_n320[28:0]; // u29f0
    wire [29:0] l_block_n322 = {l_block_n321, bn_n34}; // u30f0
    wire [29:0] l_block_n323 = l_block_n280 ? l_block_n322 : l_block_n320; // u30f0
    wire signed [29:0] l_block_n324 = l_block_n323; // s30f0
    wire signed [0:-29] l_block_z = l_block_n324; // s30f29
    // (unit)
    wire n406 = l_block_n260_s2 | bn_n73; // u1f0

    reg signed [1:-14] normal_x_s3; // s16f14
    reg signed [1:-14] normal_y_s3; // s16f14
    reg signed [1:-14] normal_z_s3; // s16f14
    reg signed [6:-18] s0_s3; // s25f18
    reg signed [6:-18] t0_s3; // s25f18
    reg signed [6:-18] q0_s3; // s25f18
    reg signed [6:-18] r0_s3; // s25f18
    reg [32:0] bn_n47_s3; // u33f0
    reg bn_n49_s3; // u1f0
    reg [32:0] bn_n52_s3; // u33f0
    reg [2:0] bn_n69_s3; // u3f0
    reg [33:0] bn_n76_s3; // u34f0
    reg [33:0] bn_n79_s3; // u34f0
    reg [33:0] bn_n105_s3; // u34f0
    reg [33:0] bn_n107_s3; // u34f0
    reg [33:0] bn_n128_s3; // u34f0
    reg [33:0] bn_n130_s3; // u34f0
    reg signed [0:-29] l_block_x_s3; // s30f29
    reg signed [0:-29] l_block_y_s3; // s30f29
    reg signed [0:-29] l_block_z_s3; // s30f29
    reg signed [9:-20] ks_q_s3; // s30f20
    reg n406_s3; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s3 <= normal_x_s2;
            normal_y_s3 <= normal_y_s2;
            normal_z_s3 <= normal_z_s2;
            s0_s3 <= s0_s2;
            t0_s3 <= t0_s2;
            q0_s3 <= q0_s2;
            r0_s3 <= r0_s2;
            bn_n47_s3 <= bn_n47;
            bn_n49_s3 <= bn_n49;
            bn_n52_s3 <= bn_n52;
            bn_n69_s3 <= bn_n69;
            bn_n76_s3 <= bn_n76_s2;
            bn_n79_s3 <= bn_n79_s2;
            bn_n105_s3 <= bn_n105_s2;
            bn_n107_s3 <= bn_n107_s2;
            bn_n128_s3 <= bn_n128_s2;
            bn_n130_s3 <= bn_n130_s2;
            l_block_x_s3 <= l_block_x;
            l_block_y_s3 <= l_block_y;
            l_block_z_s3 <= l_block_z;
            ks_q_s3 <= ks_q_s2;
            n406_s3 <= n406;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // bn
    wire [32:0] bn_n53 = bn_n49_s3 ? bn_n52_s3 : bn_n47_s3; // u33f0
    wire [3:0] bn_n54 = bn_n53[32:29]; // u4f0
    wire bn_n55 = bn_n54 == {3'h0, bn_n34}; // u1f0
    wire [28:0] bn_n56 = bn_n53[28:0]; // u29f0
    wire [32:0] bn_n58 = {bn_n56, bn_n57}; // u33f0
    wire [32:0] bn_n59 = bn_n55 ? bn_n58 : bn_n53; // u33f0
    wire [1:0] bn_n60 = bn_n59[32:31]; // u2f0
    wire bn_n61 = bn_n60 == {1'b0, bn_n34}; // u1f0
    wire [30:0] bn_n62 = bn_n59[30:0]; // u31f0
    wire [32:0] bn_n64 = {bn_n62, bn_n63}; // u33f0
    wire [32:0] bn_n65 = bn_n61 ? bn_n64 : bn_n59; // u33f0
    wire bn_n66 = bn_n65[32]; // u1f0
    wire bn_n67 = bn_n66 == bn_n34; // u1f0
    wire [3:0] bn_n70 = {bn_n69_s3, bn_n55}; // u4f0
    wire [4:0] bn_n71 = {bn_n70, bn_n61}; // u5f0
    wire [5:0] bn_places = {bn_n71, bn_n67}; // u6f0
    wire bn_n77 = bn_places[5]; // u1f0
    wire [33:0] bn_n80 = bn_n77 ? bn_n79_s3 : bn_n76_s3; // u34f0
    wire bn_n81 = bn_places[4]; // u1f0
    wire [17:0] bn_n82 = bn_n80[17:0]; // u18f0
    wire [33:0] bn_n83 = {bn_n82, bn_n45}; // u34f0
    wire [33:0] bn_n84 = bn_n81 ? bn_n83 : bn_n80; // u34f0
    wire bn_n85 = bn_places[3]; // u1f0
    wire [25:0] bn_n86 = bn_n84[25:0]; // u26f0
    wire [33:0] bn_n87 = {bn_n86, bn_n51}; // u34f0
    wire bn_n89 = bn_places[2]; // u1f0
    wire bn_n93 = bn_places[1]; // u1f0
    wire bn_n97 = bn_places[0]; // u1f0
    wire [33:0] bn_n108 = bn_n77 ? bn_n107_s3 : bn_n105_s3; // u34f0
    wire [17:0] bn_n109 = bn_n108[17:0]; // u18f0
    wire [33:0] bn_n110 = {bn_n109, bn_n45}; // u34f0
    wire [33:0] bn_n111 = bn_n81 ? bn_n110 : bn_n108; // u34f0
    wire [25:0] bn_n112 = bn_n111[25:0]; // u26f0
    wire [33:0] bn_n113 = {bn_n112, bn_n51}; // u34f0
    wire [33:0] bn_n131 = bn_n77 ? bn_n130_s3 : bn_n128_s3; // u34f0
    wire [17:0] bn_n132 = bn_n131[17:0]; // u18f0
    wire [33:0] bn_n133 = {bn_n132, bn_n45}; // u34f0
    wire [33:0] bn_n134 = bn_n81 ? bn_n133 : bn_n131; // u34f0
    wire [25:0] bn_n135 = bn_n134[25:0]; // u26f0
    wire [33:0] bn_n136 = {bn_n135, bn_n51}; // u34f0
    // (unit)
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

    reg signed [1:-14] normal_x_s4; // s16f14
    reg signed [1:-14] normal_y_s4; // s16f14
    reg signed [1:-14] normal_z_s4; // s16f14
    reg signed [6:-18] s0_s4; // s25f18
    reg signed [6:-18] t0_s4; // s25f18
    reg signed [6:-18] q0_s4; // s25f18
    reg signed [6:-18] r0_s4; // s25f18
    reg [33:0] bn_n84_s4; // u34f0
    reg bn_n85_s4; // u1f0
    reg [33:0] bn_n87_s4; // u34f0
    reg bn_n89_s4; // u1f0
    reg bn_n93_s4; // u1f0
    reg bn_n97_s4; // u1f0
    reg [33:0] bn_n111_s4; // u34f0
    reg [33:0] bn_n113_s4; // u34f0
    reg [33:0] bn_n134_s4; // u34f0
    reg [33:0] bn_n136_s4; // u34f0
    reg signed [0:-17] l_norm_x_s4; // s18f17
    reg signed [0:-17] l_norm_y_s4; // s18f17
    reg signed [0:-17] l_norm_z_s4; // s18f17
    reg signed [9:-20] ks_q_s4; // s30f20
    reg n406_s4; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s4 <= normal_x_s3;
            normal_y_s4 <= normal_y_s3;
            normal_z_s4 <= normal_z_s3;
            s0_s4 <= s0_s3;
            t0_s4 <= t0_s3;
            q0_s4 <= q0_s3;
            r0_s4 <= r0_s3;
            bn_n84_s4 <= bn_n84;
            bn_n85_s4 <= bn_n85;
            bn_n87_s4 <= bn_n87;
            bn_n89_s4 <= bn_n89;
            bn_n93_s4 <= bn_n93;
            bn_n97_s4 <= bn_n97;
            bn_n111_s4 <= bn_n111;
            bn_n113_s4 <= bn_n113;
            bn_n134_s4 <= bn_n134;
            bn_n136_s4 <= bn_n136;
            l_norm_x_s4 <= l_norm_x;
            l_norm_y_s4 <= l_norm_y;
            l_norm_z_s4 <= l_norm_z;
            ks_q_s4 <= ks_q_s3;
            n406_s4 <= n406_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // bn
    wire [33:0] bn_n88 = bn_n85_s4 ? bn_n87_s4 : bn_n84_s4; // u34f0
    wire [29:0] bn_n90 = bn_n88[29:0]; // u30f0
    wire [33:0] bn_n91 = {bn_n90, bn_n57}; // u34f0
    wire [33:0] bn_n92 = bn_n89_s4 ? bn_n91 : bn_n88; // u34f0
    wire [31:0] bn_n94 = bn_n92[31:0]; // u32f0
    wire [33:0] bn_n95 = {bn_n94, bn_n63}; // u34f0
    wire [33:0] bn_n96 = bn_n93_s4 ? bn_n95 : bn_n92; // u34f0
    wire [32:0] bn_n98 = bn_n96[32:0]; // u33f0
    wire [33:0] bn_n99 = {bn_n98, bn_n34}; // u34f0
    wire [33:0] bn_n100 = bn_n97_s4 ? bn_n99 : bn_n96; // u34f0
    wire signed [33:0] bn_n101 = bn_n100; // s34f0
    wire signed [0:-33] bn_x = bn_n101; // s34f33
    wire [33:0] bn_n114 = bn_n85_s4 ? bn_n113_s4 : bn_n111_s4; // u34f0
    wire [29:0] bn_n115 = bn_n114[29:0]; // u30f0
    wire [33:0] bn_n116 = {bn_n115, bn_n57}; // u34f0
    wire [33:0] bn_n117 = bn_n89_s4 ? bn_n116 : bn_n114; // u34f0
    wire [31:0] bn_n118 = bn_n117[31:0]; // u32f0
    wire [33:0] bn_n119 = {bn_n118, bn_n63}; // u34f0
    wire [33:0] bn_n120 = bn_n93_s4 ? bn_n119 : bn_n117; // u34f0
    wire [32:0] bn_n121 = bn_n120[32:0]; // u33f0
    wire [33:0] bn_n122 = {bn_n121, bn_n34}; // u34f0
    wire [33:0] bn_n123 = bn_n97_s4 ? bn_n122 : bn_n120; // u34f0
    wire signed [33:0] bn_n124 = bn_n123; // s34f0
    wire signed [0:-33] bn_y = bn_n124; // s34f33
    wire [33:0] bn_n137 = bn_n85_s4 ? bn_n136_s4 : bn_n134_s4; // u34f0
    wire [29:0] bn_n138 = bn_n137[29:0]; // u30f0
    wire [33:0] bn_n139 = {bn_n138, bn_n57}; // u34f0
    wire [33:0] bn_n140 = bn_n89_s4 ? bn_n139 : bn_n137; // u34f0
    wire [31:0] bn_n141 = bn_n140[31:0]; // u32f0
    wire [33:0] bn_n142 = {bn_n141, bn_n63}; // u34f0
    wire [33:0] bn_n143 = bn_n93_s4 ? bn_n142 : bn_n140; // u34f0
    wire [32:0] bn_n144 = bn_n143[32:0]; // u33f0
    wire [33:0] bn_n145 = {bn_n144, bn_n34}; // u34f0
    wire [33:0] bn_n146 = bn_n97_s4 ? bn_n145 : bn_n143; // u34f0
    wire signed [33:0] bn_n147 = bn_n146; // s34f0
    wire signed [0:-33] bn_z = bn_n147; // s34f33
    // (unit)
    wire signed [1:-33] bn_norm_x_sum = {bn_x[0], bn_x} + 35'h8000;
    wire signed [1:-17] bn_norm_x_cut = bn_norm_x_sum[1:-17];
    wire bn_norm_x_over = ~bn_norm_x_cut[1] & (|bn_norm_x_cut[0]);
    wire signed [0:-17] bn_norm_x = bn_norm_x_over ? 18'h1ffff : bn_norm_x_cut[0:-17]; // s18f17
    wire signed [1:-33] bn_norm_y_sum = {bn_y[0], bn_y} + 35'h8000;
    wire signed [1:-17] bn_norm_y_cut = bn_norm_y_sum[1:-17];
    wire bn_norm_y_over = ~bn_norm_y_cut[1] & (|bn_norm_y_cut[0]);
    wire signed [0:-17] bn_norm_y = bn_norm_y_over ? 18'h1ffff : bn_norm_y_cut[0:-17]; // s18f17
    wire signed [1:-33] bn_norm_z_sum = {bn_z[0], bn_z} + 35'h8000;
    wire signed [1:-17] bn_norm_z_cut = bn_norm_z_sum[1:-17];
    wire bn_norm_z_over = ~bn_norm_z_cut[1] & (|bn_norm_z_cut[0]);
    wire signed [0:-17] bn_norm_z = bn_norm_z_over ? 18'h1ffff : bn_norm_z_cut[0:-17]; // s18f17
    // l_dot_l
    wire signed [1:-34] l_dot_l_n335 = l_norm_x_s4 * l_norm_x_s4; // s36f34
    wire signed [1:-34] l_dot_l_n336 = l_norm_y_s4 * l_norm_y_s4; // s36f34
    wire signed [1:-34] l_dot_l_n337 = l_norm_z_s4 * l_norm_z_s4; // s36f34

    reg signed [1:-14] normal_x_s5; // s16f14
    reg signed [1:-14] normal_y_s5; // s16f14
    reg signed [1:-14] normal_z_s5; // s16f14
    reg signed [6:-18] s0_s5; // s25f18
    reg signed [6:-18] t0_s5; // s25f18
    reg signed [6:-18] q0_s5; // s25f18
    reg signed [6:-18] r0_s5; // s25f18
    reg signed [0:-17] bn_norm_x_s5; // s18f17
    reg signed [0:-17] bn_norm_y_s5; // s18f17
    reg signed [0:-17] bn_norm_z_s5; // s18f17
    reg signed [0:-17] l_norm_x_s5; // s18f17
    reg signed [0:-17] l_norm_y_s5; // s18f17
    reg signed [0:-17] l_norm_z_s5; // s18f17
    reg signed [1:-34] l_dot_l_n335_s5; // s36f34
    reg signed [1:-34] l_dot_l_n336_s5; // s36f34
    reg signed [1:-34] l_dot_l_n337_s5; // s36f34
    reg signed [9:-20] ks_q_s5; // s30f20
    reg n406_s5; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s5 <= normal_x_s4;
            normal_y_s5 <= normal_y_s4;
            normal_z_s5 <= normal_z_s4;
            s0_s5 <= s0_s4;
            t0_s5 <= t0_s4;
            q0_s5 <= q0_s4;
            r0_s5 <= r0_s4;
            bn_norm_x_s5 <= bn_norm_x;
            bn_norm_y_s5 <= bn_norm_y;
            bn_norm_z_s5 <= bn_norm_z;
            l_norm_x_s5 <= l_norm_x_s4;
            l_norm_y_s5 <= l_norm_y_s4;
            l_norm_z_s5 <= l_norm_z_s4;
            l_dot_l_n335_s5 <= l_dot_l_n335;
            l_dot_l_n336_s5 <= l_dot_l_n336;
            l_dot_l_n337_s5 <= l_dot_l_n337;
            ks_q_s5 <= ks_q_s4;
            n406_s5 <= n406_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // bn_square
    wire signed [1:-34] bn_square_n152 = bn_norm_x_s5 * bn_norm_x_s5; // s36f34
    wire signed [1:-34] bn_square_n153 = bn_norm_y_s5 * bn_norm_y_s5; // s36f34
    wire signed [1:-34] bn_square_n154 = bn_norm_z_s5 * bn_norm_z_s5; // s36f34
    // l_dot_l
    wire signed [2:-34] l_dot_l_n338 = {l_dot_l_n335_s5[1], l_dot_l_n335_s5} + {l_dot_l_n336_s5[1], l_dot_l_n336_s5}; // s37f34
    wire signed [3:-34] l_dot_l_n339 = {l_dot_l_n338[2], l_dot_l_n338} + {{2{l_dot_l_n337_s5[1]}}, l_dot_l_n337_s5}; // s38f34

    reg signed [1:-14] normal_x_s6; // s16f14
    reg signed [1:-14] normal_y_s6; // s16f14
    reg signed [1:-14] normal_z_s6; // s16f14
    reg signed [6:-18] s0_s6; // s25f18
    reg signed [6:-18] t0_s6; // s25f18
    reg signed [6:-18] q0_s6; // s25f18
    reg signed [6:-18] r0_s6; // s25f18
    reg signed [0:-17] bn_norm_x_s6; // s18f17
    reg signed [0:-17] bn_norm_y_s6; // s18f17
    reg signed [0:-17] bn_norm_z_s6; // s18f17
    reg signed [1:-34] bn_square_n152_s6; // s36f34
    reg signed [1:-34] bn_square_n153_s6; // s36f34
    reg signed [1:-34] bn_square_n154_s6; // s36f34
    reg signed [0:-17] l_norm_x_s6; // s18f17
    reg signed [0:-17] l_norm_y_s6; // s18f17
    reg signed [0:-17] l_norm_z_s6; // s18f17
    reg signed [3:-34] l_dot_l_n339_s6; // s38f34
    reg signed [9:-20] ks_q_s6; // s30f20
    reg n406_s6; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s6 <= normal_x_s5;
            normal_y_s6 <= normal_y_s5;
            normal_z_s6 <= normal_z_s5;
            s0_s6 <= s0_s5;
            t0_s6 <= t0_s5;
            q0_s6 <= q0_s5;
            r0_s6 <= r0_s5;
            bn_norm_x_s6 <= bn_norm_x_s5;
            bn_norm_y_s6 <= bn_norm_y_s5;
            bn_norm_z_s6 <= bn_norm_z_s5;
            bn_square_n152_s6 <= bn_square_n152;
            bn_square_n153_s6 <= bn_square_n153;
            bn_square_n154_s6 <= bn_square_n154;
            l_norm_x_s6 <= l_norm_x_s5;
            l_norm_y_s6 <= l_norm_y_s5;
            l_norm_z_s6 <= l_norm_z_s5;
            l_dot_l_n339_s6 <= l_dot_l_n339;
            ks_q_s6 <= ks_q_s5;
            n406_s6 <= n406_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // bn_square
    wire signed [2:-34] bn_square_n155 = {bn_square_n152_s6[1], bn_square_n152_s6} + {bn_square_n153_s6[1], bn_square_n153_s6}; // s37f34
    wire signed [3:-34] bn_square_n156 = {bn_square_n155[2], bn_square_n155} + {{2{bn_square_n154_s6[1]}}, bn_square_n154_s6}; // s38f34
    // (unit)
    wire signed [4:-34] reciprocal_length_square_sum = {l_dot_l_n339_s6[3], l_dot_l_n339_s6} + 39'h2000;
    wire signed [4:-20] reciprocal_length_square_cut = reciprocal_length_square_sum[4:-20];
    wire reciprocal_length_square_over = ~reciprocal_length_square_cut[4] & (|reciprocal_length_square_cut[3:2]);
    wire reciprocal_length_square_under = reciprocal_length_square_cut[4];
    wire [1:-20] reciprocal_length_square = reciprocal_length_square_over ? 22'h3fffff : reciprocal_length_square_under ? 22'h0 : reciprocal_length_square_cut[1:-20]; // u22f20
    // reciprocal_length
    wire [21:0] reciprocal_length_n341 = reciprocal_length_square; // u22f0
    wire [21:0] reciprocal_length_n342 = reciprocal_length_n341; // u22f0
    wire [15:0] reciprocal_length_n343 = reciprocal_length_n342[21:6]; // u16f0
    wire reciprocal_length_n344 = reciprocal_length_n343 == {15'h0, bn_n34}; // u1f0
    wire [5:0] reciprocal_length_n345 = reciprocal_length_n342[5:0]; // u6f0
    wire [21:0] reciprocal_length_n346 = {reciprocal_length_n345, bn_n45}; // u22f0
    wire [21:0] reciprocal_length_n347 = reciprocal_length_n344 ? reciprocal_length_n346 : reciprocal_length_n342; // u22f0
    wire [7:0] reciprocal_length_n348 = reciprocal_length_n347[21:14]; // u8f0
    wire reciprocal_length_n349 = reciprocal_length_n348 == {7'h0, bn_n34}; // u1f0
    wire [13:0] reciprocal_length_n350 = reciprocal_length_n347[13:0]; // u14f0
    wire [21:0] reciprocal_length_n351 = {reciprocal_length_n350, bn_n51}; // u22f0
    wire [1:0] reciprocal_length_n363 = {reciprocal_length_n344, reciprocal_length_n349}; // u2f0
    wire reciprocal_length_n381 = reciprocal_length_square == {1'b0, bn_n34, 20'h0}; // u1f0

    reg signed [1:-14] normal_x_s7; // s16f14
    reg signed [1:-14] normal_y_s7; // s16f14
    reg signed [1:-14] normal_z_s7; // s16f14
    reg signed [6:-18] s0_s7; // s25f18
    reg signed [6:-18] t0_s7; // s25f18
    reg signed [6:-18] q0_s7; // s25f18
    reg signed [6:-18] r0_s7; // s25f18
    reg signed [0:-17] bn_norm_x_s7; // s18f17
    reg signed [0:-17] bn_norm_y_s7; // s18f17
    reg signed [0:-17] bn_norm_z_s7; // s18f17
    reg signed [3:-34] bn_square_n156_s7; // s38f34
    reg signed [0:-17] l_norm_x_s7; // s18f17
    reg signed [0:-17] l_norm_y_s7; // s18f17
    reg signed [0:-17] l_norm_z_s7; // s18f17
    reg [21:0] reciprocal_length_n347_s7; // u22f0
    reg reciprocal_length_n349_s7; // u1f0
    reg [21:0] reciprocal_length_n351_s7; // u22f0
    reg [1:0] reciprocal_length_n363_s7; // u2f0
    reg reciprocal_length_n381_s7; // u1f0
    reg signed [9:-20] ks_q_s7; // s30f20
    reg n406_s7; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s7 <= normal_x_s6;
            normal_y_s7 <= normal_y_s6;
            normal_z_s7 <= normal_z_s6;
            s0_s7 <= s0_s6;
            t0_s7 <= t0_s6;
            q0_s7 <= q0_s6;
            r0_s7 <= r0_s6;
            bn_norm_x_s7 <= bn_norm_x_s6;
            bn_norm_y_s7 <= bn_norm_y_s6;
            bn_norm_z_s7 <= bn_norm_z_s6;
            bn_square_n156_s7 <= bn_square_n156;
            l_norm_x_s7 <= l_norm_x_s6;
            l_norm_y_s7 <= l_norm_y_s6;
            l_norm_z_s7 <= l_norm_z_s6;
            reciprocal_length_n347_s7 <= reciprocal_length_n347;
            reciprocal_length_n349_s7 <= reciprocal_length_n349;
            reciprocal_length_n351_s7 <= reciprocal_length_n351;
            reciprocal_length_n363_s7 <= reciprocal_length_n363;
            reciprocal_length_n381_s7 <= reciprocal_length_n381;
            ks_q_s7 <= ks_q_s6;
            n406_s7 <= n406_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    wire signed [4:-34] bn_length_square_sum = {bn_square_n156_s7[3], bn_square_n156_s7} + 39'h2000;
    wire signed [4:-20] bn_length_square_cut = bn_length_square_sum[4:-20];
    wire bn_length_square_over = ~bn_length_square_cut[4] & (|bn_length_square_cut[3:2]);
    wire bn_length_square_under = bn_length_square_cut[4];
    wire [1:-20] bn_length_square = bn_length_square_over ? 22'h3fffff : bn_length_square_under ? 22'h0 : bn_length_square_cut[1:-20]; // u22f20
    // bn_length
    wire [21:0] bn_length_n158 = bn_length_square; // u22f0
    wire [21:0] bn_length_n159 = bn_length_n158; // u22f0
    wire [15:0] bn_length_n160 = bn_length_n159[21:6]; // u16f0
    wire bn_length_n161 = bn_length_n160 == {15'h0, bn_n34}; // u1f0
    wire [5:0] bn_length_n162 = bn_length_n159[5:0]; // u6f0
    wire [21:0] bn_length_n163 = {bn_length_n162, bn_n45}; // u22f0
    wire [21:0] bn_length_n164 = bn_length_n161 ? bn_length_n163 : bn_length_n159; // u22f0
    wire [7:0] bn_length_n165 = bn_length_n164[21:14]; // u8f0
    wire bn_length_n166 = bn_length_n165 == {7'h0, bn_n34}; // u1f0
    wire [13:0] bn_length_n167 = bn_length_n164[13:0]; // u14f0
    wire [21:0] bn_length_n168 = {bn_length_n167, bn_n51}; // u22f0
    wire [1:0] bn_length_n180 = {bn_length_n161, bn_length_n166}; // u2f0
    wire bn_length_n200 = bn_length_square == {1'b0, bn_n34, 20'h0}; // u1f0
    // reciprocal_length
    wire [21:0] reciprocal_length_n352 = reciprocal_length_n349_s7 ? reciprocal_length_n351_s7 : reciprocal_length_n347_s7; // u22f0
    wire [3:0] reciprocal_length_n353 = reciprocal_length_n352[21:18]; // u4f0
    wire reciprocal_length_n354 = reciprocal_length_n353 == {3'h0, bn_n34}; // u1f0
    wire [17:0] reciprocal_length_n355 = reciprocal_length_n352[17:0]; // u18f0
    wire [21:0] reciprocal_length_n356 = {reciprocal_length_n355, bn_n57}; // u22f0
    wire [21:0] reciprocal_length_n357 = reciprocal_length_n354 ? reciprocal_length_n356 : reciprocal_length_n352; // u22f0
    wire [1:0] reciprocal_length_n358 = reciprocal_length_n357[21:20]; // u2f0
    wire reciprocal_length_n359 = reciprocal_length_n358 == {1'b0, bn_n34}; // u1f0
    wire [19:0] reciprocal_length_n360 = reciprocal_length_n357[19:0]; // u20f0
    wire [21:0] reciprocal_length_n361 = {reciprocal_length_n360, bn_n63}; // u22f0
    wire [21:0] reciprocal_length_n362 = reciprocal_length_n359 ? reciprocal_length_n361 : reciprocal_length_n357; // u22f0
    wire [2:0] reciprocal_length_n364 = {reciprocal_length_n363_s7, reciprocal_length_n354}; // u3f0
    wire [3:0] reciprocal_length_n365 = {reciprocal_length_n364, reciprocal_length_n359}; // u4f0
    wire [1:0] reciprocal_length_n366 = reciprocal_length_n362[21:20]; // u2f0
    wire signed [2:0] reciprocal_length_n367 = {1'b0, reciprocal_length_n366} - {2'h0, bn_length_n184}; // s3f0
    wire [1:0] reciprocal_length_n368 = reciprocal_length_n367[1:0]; // u2f0
    wire [17:0] reciprocal_length_n369 = reciprocal_length_n362[19:2]; // u18f0
    wire [19:0] reciprocal_length_n370 = {reciprocal_length_n368, reciprocal_length_n369}; // u20f0
    wire [-1:-20] reciprocal_length_n371 = reciprocal_length_n370; // u20f20
    // reciprocal_length.recip_root
    wire [8:0] reciprocal_length_recip_root_n372 = reciprocal_length_n371[-1:-9]; // u9f0
    wire [10:0] reciprocal_length_recip_root_n375 = reciprocal_length_n371[-10:-20]; // u11f0

    reg signed [1:-14] normal_x_s8; // s16f14
    reg signed [1:-14] normal_y_s8; // s16f14
    reg signed [1:-14] normal_z_s8; // s16f14
    reg signed [6:-18] s0_s8; // s25f18
    reg signed [6:-18] t0_s8; // s25f18
    reg signed [6:-18] q0_s8; // s25f18
    reg signed [6:-18] r0_s8; // s25f18
    reg signed [0:-17] bn_norm_x_s8; // s18f17
    reg signed [0:-17] bn_norm_y_s8; // s18f17
    reg signed [0:-17] bn_norm_z_s8; // s18f17
    reg [21:0] bn_length_n164_s8; // u22f0
    reg bn_length_n166_s8; // u1f0
    reg [21:0] bn_length_n168_s8; // u22f0
    reg [1:0] bn_length_n180_s8; // u2f0
    reg bn_length_n200_s8; // u1f0
    reg signed [0:-17] l_norm_x_s8; // s18f17
    reg signed [0:-17] l_norm_y_s8; // s18f17
    reg signed [0:-17] l_norm_z_s8; // s18f17
    reg [3:0] reciprocal_length_n365_s8; // u4f0
    reg [38:0] recip_root_row;
    reg [10:0] reciprocal_length_recip_root_n375_s8; // u11f0
    reg reciprocal_length_n381_s8; // u1f0
    reg signed [9:-20] ks_q_s8; // s30f20
    reg n406_s8; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s8 <= normal_x_s7;
            normal_y_s8 <= normal_y_s7;
            normal_z_s8 <= normal_z_s7;
            s0_s8 <= s0_s7;
            t0_s8 <= t0_s7;
            q0_s8 <= q0_s7;
            r0_s8 <= r0_s7;
            bn_norm_x_s8 <= bn_norm_x_s7;
            bn_norm_y_s8 <= bn_norm_y_s7;
            bn_norm_z_s8 <= bn_norm_z_s7;
            bn_length_n164_s8 <= bn_length_n164;
            bn_length_n166_s8 <= bn_length_n166;
            bn_length_n168_s8 <= bn_length_n168;
            bn_length_n180_s8 <= bn_length_n180;
            bn_length_n200_s8 <= bn_length_n200;
            l_norm_x_s8 <= l_norm_x_s7;
            l_norm_y_s8 <= l_norm_y_s7;
            l_norm_z_s8 <= l_norm_z_s7;
            reciprocal_length_n365_s8 <= reciprocal_length_n365;
            recip_root_row <= recip_root_rom[reciprocal_length_recip_root_n372];
            reciprocal_length_recip_root_n375_s8 <= reciprocal_length_recip_root_n375;
            reciprocal_length_n381_s8 <= reciprocal_length_n381_s7;
            ks_q_s8 <= ks_q_s7;
            n406_s8 <= n406_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // bn_length
    wire [21:0] bn_length_n169 = bn_length_n166_s8 ? bn_length_n168_s8 : bn_length_n164_s8; // u22f0
    wire [3:0] bn_length_n170 = bn_length_n169[21:18]; // u4f0
    wire bn_length_n171 = bn_length_n170 == {3'h0, bn_n34}; // u1f0
    wire [17:0] bn_length_n172 = bn_length_n169[17:0]; // u18f0
    wire [21:0] bn_length_n173 = {bn_length_n172, bn_n57}; // u22f0
    wire [21:0] bn_length_n174 = bn_length_n171 ? bn_length_n173 : bn_length_n169; // u22f0
    wire [1:0] bn_length_n175 = bn_length_n174[21:20]; // u2f0
    wire bn_length_n176 = bn_length_n175 == {1'b0, bn_n34}; // u1f0
    wire [19:0] bn_length_n177 = bn_length_n174[19:0]; // u20f0
    wire [21:0] bn_length_n178 = {bn_length_n177, bn_n63}; // u22f0
    wire [21:0] bn_length_n179 = bn_length_n176 ? bn_length_n178 : bn_length_n174; // u22f0
    wire [2:0] bn_length_n181 = {bn_length_n180_s8, bn_length_n171}; // u3f0
    wire [3:0] bn_length_n182 = {bn_length_n181, bn_length_n176}; // u4f0
    wire [1:0] bn_length_n183 = bn_length_n179[21:20]; // u2f0
    wire signed [2:0] bn_length_n185 = {1'b0, bn_length_n183} - {2'h0, bn_length_n184}; // s3f0
    wire [1:0] bn_length_n186 = bn_length_n185[1:0]; // u2f0
    wire [17:0] bn_length_n187 = bn_length_n179[19:2]; // u18f0
    wire [19:0] bn_length_n188 = {bn_length_n186, bn_length_n187}; // u20f0
    wire [-1:-20] bn_length_n189 = bn_length_n188; // u20f20
    // bn_length.recip_root
    wire [8:0] bn_length_recip_root_n190 = bn_length_n189[-1:-9]; // u9f0
    wire [10:0] bn_length_recip_root_n193 = bn_length_n189[-10:-20]; // u11f0
    // reciprocal_length.recip_root
    wire [0:-22] reciprocal_length_recip_root_n373 = recip_root_row[38:16]; // u23f22
    wire signed [-18:-33] reciprocal_length_recip_root_n374 = recip_root_row[15:0]; // s16f33

    reg signed [1:-14] normal_x_s9; // s16f14
    reg signed [1:-14] normal_y_s9; // s16f14
    reg signed [1:-14] normal_z_s9; // s16f14
    reg signed [6:-18] s0_s9; // s25f18
    reg signed [6:-18] t0_s9; // s25f18
    reg signed [6:-18] q0_s9; // s25f18
    reg signed [6:-18] r0_s9; // s25f18
    reg signed [0:-17] bn_norm_x_s9; // s18f17
    reg signed [0:-17] bn_norm_y_s9; // s18f17
    reg signed [0:-17] bn_norm_z_s9; // s18f17
    reg [3:0] bn_length_n182_s9; // u4f0
    reg [38:0] recip_root_row_2;
    reg [10:0] bn_length_recip_root_n193_s9; // u11f0
    reg bn_length_n200_s9; // u1f0
    reg signed [0:-17] l_norm_x_s9; // s18f17
    reg signed [0:-17] l_norm_y_s9; // s18f17
    reg signed [0:-17] l_norm_z_s9; // s18f17
    reg [3:0] reciprocal_length_n365_s9; // u4f0
    reg [0:-22] reciprocal_length_recip_root_n373_s9; // u23f22
    reg signed [-18:-33] reciprocal_length_recip_root_n374_s9; // s16f33
    reg [10:0] reciprocal_length_recip_root_n375_s9; // u11f0
    reg reciprocal_length_n381_s9; // u1f0
    reg signed [9:-20] ks_q_s9; // s30f20
    reg n406_s9; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s9 <= normal_x_s8;
            normal_y_s9 <= normal_y_s8;
            normal_z_s9 <= normal_z_s8;
            s0_s9 <= s0_s8;
            t0_s9 <= t0_s8;
            q0_s9 <= q0_s8;
            r0_s9 <= r0_s8;
            bn_norm_x_s9 <= bn_norm_x_s8;
            bn_norm_y_s9 <= bn_norm_y_s8;
            bn_norm_z_s9 <= bn_norm_z_s8;
            bn_length_n182_s9 <= bn_length_n182;
            recip_root_row_2 <= recip_root_rom[bn_length_recip_root_n190];
            bn_length_recip_root_n193_s9 <= bn_length_recip_root_n193;
            bn_length_n200_s9 <= bn_length_n200_s8;
            l_norm_x_s9 <= l_norm_x_s8;
            l_norm_y_s9 <= l_norm_y_s8;
            l_norm_z_s9 <= l_norm_z_s8;
            reciprocal_length_n365_s9 <= reciprocal_length_n365_s8;
            reciprocal_length_recip_root_n373_s9 <= reciprocal_length_recip_root_n373;
            reciprocal_length_recip_root_n374_s9 <= reciprocal_length_recip_root_n374;
            reciprocal_length_recip_root_n375_s9 <= reciprocal_length_recip_root_n375_s8;
            reciprocal_length_n381_s9 <= reciprocal_length_n381_s8;
            ks_q_s9 <= ks_q_s8;
            n406_s9 <= n406_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // bn_length.recip_root
    wire [0:-22] bn_length_recip_root_n191 = recip_root_row_2[38:16]; // u23f22
    wire signed [-18:-33] bn_length_recip_root_n192 = recip_root_row_2[15:0]; // s16f33
    // reciprocal_length.recip_root
    wire signed [-7:-33] reciprocal_length_recip_root_n376 = reciprocal_length_recip_root_n374_s9 * $signed({1'b0, reciprocal_length_recip_root_n375_s9}); // s27f33
    wire signed [2:-33] reciprocal_length_recip_root_n377 = {2'h0, reciprocal_length_recip_root_n373_s9, 11'h0} + {{9{reciprocal_length_recip_root_n376[-7]}}, reciprocal_length_recip_root_n376}; // s36f33

    reg signed [1:-14] normal_x_s10; // s16f14
    reg signed [1:-14] normal_y_s10; // s16f14
    reg signed [1:-14] normal_z_s10; // s16f14
    reg signed [6:-18] s0_s10; // s25f18
    reg signed [6:-18] t0_s10; // s25f18
    reg signed [6:-18] q0_s10; // s25f18
    reg signed [6:-18] r0_s10; // s25f18
    reg signed [0:-17] bn_norm_x_s10; // s18f17
    reg signed [0:-17] bn_norm_y_s10; // s18f17
    reg signed [0:-17] bn_norm_z_s10; // s18f17
    reg [3:0] bn_length_n182_s10; // u4f0
    reg [0:-22] bn_length_recip_root_n191_s10; // u23f22
    reg signed [-18:-33] bn_length_recip_root_n192_s10; // s16f33
    reg [10:0] bn_length_recip_root_n193_s10; // u11f0
    reg bn_length_n200_s10; // u1f0
    reg signed [0:-17] l_norm_x_s10; // s18f17
    reg signed [0:-17] l_norm_y_s10; // s18f17
    reg signed [0:-17] l_norm_z_s10; // s18f17
    reg [3:0] reciprocal_length_n365_s10; // u4f0
    reg signed [2:-33] reciprocal_length_recip_root_n377_s10; // s36f33
    reg reciprocal_length_n381_s10; // u1f0
    reg signed [9:-20] ks_q_s10; // s30f20
    reg n406_s10; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s10 <= normal_x_s9;
            normal_y_s10 <= normal_y_s9;
            normal_z_s10 <= normal_z_s9;
            s0_s10 <= s0_s9;
            t0_s10 <= t0_s9;
            q0_s10 <= q0_s9;
            r0_s10 <= r0_s9;
            bn_norm_x_s10 <= bn_norm_x_s9;
            bn_norm_y_s10 <= bn_norm_y_s9;
            bn_norm_z_s10 <= bn_norm_z_s9;
            bn_length_n182_s10 <= bn_length_n182_s9;
            bn_length_recip_root_n191_s10 <= bn_length_recip_root_n191;
            bn_length_recip_root_n192_s10 <= bn_length_recip_root_n192;
            bn_length_recip_root_n193_s10 <= bn_length_recip_root_n193_s9;
            bn_length_n200_s10 <= bn_length_n200_s9;
            l_norm_x_s10 <= l_norm_x_s9;
            l_norm_y_s10 <= l_norm_y_s9;
            l_norm_z_s10 <= l_norm_z_s9;
            reciprocal_length_n365_s10 <= reciprocal_length_n365_s9;
            reciprocal_length_recip_root_n377_s10 <= reciprocal_length_recip_root_n377;
            reciprocal_length_n381_s10 <= reciprocal_length_n381_s9;
            ks_q_s10 <= ks_q_s9;
            n406_s10 <= n406_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // bn_length.recip_root
    wire signed [-7:-33] bn_length_recip_root_n194 = bn_length_recip_root_n192_s10 * $signed({1'b0, bn_length_recip_root_n193_s10}); // s27f33
    wire signed [2:-33] bn_length_recip_root_n195 = {2'h0, bn_length_recip_root_n191_s10, 11'h0} + {{9{bn_length_recip_root_n194[-7]}}, bn_length_recip_root_n194}; // s36f33
    // reciprocal_length.recip_root
    wire signed [3:-33] reciprocal_length_recip_root_n378_sum = {reciprocal_length_recip_root_n377_s10[2], reciprocal_length_recip_root_n377_s10} + 37'h1000;
    wire signed [3:-20] reciprocal_length_recip_root_n378_cut = reciprocal_length_recip_root_n378_sum[3:-20];
    wire reciprocal_length_recip_root_n378_over = ~reciprocal_length_recip_root_n378_cut[3] & (|reciprocal_length_recip_root_n378_cut[2]);
    wire reciprocal_length_recip_root_n378_under = reciprocal_length_recip_root_n378_cut[3];
    wire [1:-20] reciprocal_length_recip_root_n378 = reciprocal_length_recip_root_n378_over ? 22'h3fffff : reciprocal_length_recip_root_n378_under ? 22'h0 : reciprocal_length_recip_root_n378_cut[1:-20]; // u22f20
    // reciprocal_length
    wire reciprocal_length_n379_past = 4'hb < reciprocal_length_n365_s10;
    wire [3:0] reciprocal_length_n379_count = reciprocal_length_n379_past ? 4'hb : reciprocal_length_n365_s10;
    wire [12:-20] reciprocal_length_n379 = {11'h0, reciprocal_length_recip_root_n378} << reciprocal_length_n379_count; // u33f20
    wire [11:-21] reciprocal_length_n380 = reciprocal_length_n379; // u33f21
    wire [11:-21] reciprocal_length_n382 = reciprocal_length_n381_s10 ? {9'h0, bn_length_n199, 23'h0} : reciprocal_length_n380; // u33f21

    reg signed [1:-14] normal_x_s11; // s16f14
    reg signed [1:-14] normal_y_s11; // s16f14
    reg signed [1:-14] normal_z_s11; // s16f14
    reg signed [6:-18] s0_s11; // s25f18
    reg signed [6:-18] t0_s11; // s25f18
    reg signed [6:-18] q0_s11; // s25f18
    reg signed [6:-18] r0_s11; // s25f18
    reg signed [0:-17] bn_norm_x_s11; // s18f17
    reg signed [0:-17] bn_norm_y_s11; // s18f17
    reg signed [0:-17] bn_norm_z_s11; // s18f17
    reg [3:0] bn_length_n182_s11; // u4f0
    reg signed [2:-33] bn_length_recip_root_n195_s11; // s36f33
    reg bn_length_n200_s11; // u1f0
    reg signed [0:-17] l_norm_x_s11; // s18f17
    reg signed [0:-17] l_norm_y_s11; // s18f17
    reg signed [0:-17] l_norm_z_s11; // s18f17
    reg [11:-21] reciprocal_length_n382_s11; // u33f21
    reg signed [9:-20] ks_q_s11; // s30f20
    reg n406_s11; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s11 <= normal_x_s10;
            normal_y_s11 <= normal_y_s10;
            normal_z_s11 <= normal_z_s10;
            s0_s11 <= s0_s10;
            t0_s11 <= t0_s10;
            q0_s11 <= q0_s10;
            r0_s11 <= r0_s10;
            bn_norm_x_s11 <= bn_norm_x_s10;
            bn_norm_y_s11 <= bn_norm_y_s10;
            bn_norm_z_s11 <= bn_norm_z_s10;
            bn_length_n182_s11 <= bn_length_n182_s10;
            bn_length_recip_root_n195_s11 <= bn_length_recip_root_n195;
            bn_length_n200_s11 <= bn_length_n200_s10;
            l_norm_x_s11 <= l_norm_x_s10;
            l_norm_y_s11 <= l_norm_y_s10;
            l_norm_z_s11 <= l_norm_z_s10;
            reciprocal_length_n382_s11 <= reciprocal_length_n382;
            ks_q_s11 <= ks_q_s10;
            n406_s11 <= n406_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // bn_length.recip_root
    wire signed [3:-33] bn_length_recip_root_n196_sum = {bn_length_recip_root_n195_s11[2], bn_length_recip_root_n195_s11} + 37'h1000;
    wire signed [3:-20] bn_length_recip_root_n196_cut = bn_length_recip_root_n196_sum[3:-20];
    wire bn_length_recip_root_n196_over = ~bn_length_recip_root_n196_cut[3] & (|bn_length_recip_root_n196_cut[2]);
    wire bn_length_recip_root_n196_under = bn_length_recip_root_n196_cut[3];
    wire [1:-20] bn_length_recip_root_n196 = bn_length_recip_root_n196_over ? 22'h3fffff : bn_length_recip_root_n196_under ? 22'h0 : bn_length_recip_root_n196_cut[1:-20]; // u22f20
    // bn_length
    wire bn_length_n197_past = 4'hb < bn_length_n182_s11;
    wire [3:0] bn_length_n197_count = bn_length_n197_past ? 4'hb : bn_length_n182_s11;
    wire [12:-20] bn_length_n197 = {11'h0, bn_length_recip_root_n196} << bn_length_n197_count; // u33f20
    wire [11:-21] bn_length_n198 = bn_length_n197; // u33f21
    wire [11:-21] bn_length_n201 = bn_length_n200_s11 ? {9'h0, bn_length_n199, 23'h0} : bn_length_n198; // u33f21
    // reciprocal_length
    wire [12:-21] reciprocal_length_reciprocal_length_sum = {1'b0, reciprocal_length_n382_s11} + 34'h4;
    wire [12:-18] reciprocal_length_reciprocal_length_cut = reciprocal_length_reciprocal_length_sum[12:-18];
    wire reciprocal_length_reciprocal_length_over = |reciprocal_length_reciprocal_length_cut[12:2];
    wire [1:-18] reciprocal_length_reciprocal_length = reciprocal_length_reciprocal_length_over ? 20'hfffff : reciprocal_length_reciprocal_length_cut[1:-18]; // u20f18

    reg signed [1:-14] normal_x_s12; // s16f14
    reg signed [1:-14] normal_y_s12; // s16f14
    reg signed [1:-14] normal_z_s12; // s16f14
    reg signed [6:-18] s0_s12; // s25f18
    reg signed [6:-18] t0_s12; // s25f18
    reg signed [6:-18] q0_s12; // s25f18
    reg signed [6:-18] r0_s12; // s25f18
    reg signed [0:-17] bn_norm_x_s12; // s18f17
    reg signed [0:-17] bn_norm_y_s12; // s18f17
    reg signed [0:-17] bn_norm_z_s12; // s18f17
    reg [11:-21] bn_length_n201_s12; // u33f21
    reg signed [0:-17] l_norm_x_s12; // s18f17
    reg signed [0:-17] l_norm_y_s12; // s18f17
    reg signed [0:-17] l_norm_z_s12; // s18f17
    reg [1:-18] reciprocal_length_reciprocal_length_s12; // u20f18
    reg signed [9:-20] ks_q_s12; // s30f20
    reg n406_s12; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s12 <= normal_x_s11;
            normal_y_s12 <= normal_y_s11;
            normal_z_s12 <= normal_z_s11;
            s0_s12 <= s0_s11;
            t0_s12 <= t0_s11;
            q0_s12 <= q0_s11;
            r0_s12 <= r0_s11;
            bn_norm_x_s12 <= bn_norm_x_s11;
            bn_norm_y_s12 <= bn_norm_y_s11;
            bn_norm_z_s12 <= bn_norm_z_s11;
            bn_length_n201_s12 <= bn_length_n201;
            l_norm_x_s12 <= l_norm_x_s11;
            l_norm_y_s12 <= l_norm_y_s11;
            l_norm_z_s12 <= l_norm_z_s11;
            reciprocal_length_reciprocal_length_s12 <= reciprocal_length_reciprocal_length;
            ks_q_s12 <= ks_q_s11;
            n406_s12 <= n406_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // bn_length
    wire [12:-21] bn_length_bn_length_sum = {1'b0, bn_length_n201_s12} + 34'h4;
    wire [12:-18] bn_length_bn_length_cut = bn_length_bn_length_sum[12:-18];
    wire bn_length_bn_length_over = |bn_length_bn_length_cut[12:2];
    wire [1:-18] bn_length_bn_length = bn_length_bn_length_over ? 20'hfffff : bn_length_bn_length_cut[1:-18]; // u20f18

    reg signed [1:-14] normal_x_s13; // s16f14
    reg signed [1:-14] normal_y_s13; // s16f14
    reg signed [1:-14] normal_z_s13; // s16f14
    reg signed [6:-18] s0_s13; // s25f18
    reg signed [6:-18] t0_s13; // s25f18
    reg signed [6:-18] q0_s13; // s25f18
    reg signed [6:-18] r0_s13; // s25f18
    reg signed [0:-17] bn_norm_x_s13; // s18f17
    reg signed [0:-17] bn_norm_y_s13; // s18f17
    reg signed [0:-17] bn_norm_z_s13; // s18f17
    reg [1:-18] bn_length_bn_length_s13; // u20f18
    reg signed [0:-17] l_norm_x_s13; // s18f17
    reg signed [0:-17] l_norm_y_s13; // s18f17
    reg signed [0:-17] l_norm_z_s13; // s18f17
    reg [1:-18] reciprocal_length_reciprocal_length_s13; // u20f18
    reg signed [9:-20] ks_q_s13; // s30f20
    reg n406_s13; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s13 <= normal_x_s12;
            normal_y_s13 <= normal_y_s12;
            normal_z_s13 <= normal_z_s12;
            s0_s13 <= s0_s12;
            t0_s13 <= t0_s12;
            q0_s13 <= q0_s12;
            r0_s13 <= r0_s12;
            bn_norm_x_s13 <= bn_norm_x_s12;
            bn_norm_y_s13 <= bn_norm_y_s12;
            bn_norm_z_s13 <= bn_norm_z_s12;
            bn_length_bn_length_s13 <= bn_length_bn_length;
            l_norm_x_s13 <= l_norm_x_s12;
            l_norm_y_s13 <= l_norm_y_s12;
            l_norm_z_s13 <= l_norm_z_s12;
            reciprocal_length_reciprocal_length_s13 <= reciprocal_length_reciprocal_length_s12;
            ks_q_s13 <= ks_q_s12;
            n406_s13 <= n406_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    wire signed [2:-35] n203 = bn_norm_x_s13 * $signed({1'b0, bn_length_bn_length_s13}); // s38f35
    wire signed [2:-35] n205 = bn_norm_y_s13 * $signed({1'b0, bn_length_bn_length_s13}); // s38f35
    wire signed [2:-35] n207 = bn_norm_z_s13 * $signed({1'b0, bn_length_bn_length_s13}); // s38f35

    reg signed [1:-14] normal_x_s14; // s16f14
    reg signed [1:-14] normal_y_s14; // s16f14
    reg signed [1:-14] normal_z_s14; // s16f14
    reg signed [6:-18] s0_s14; // s25f18
    reg signed [6:-18] t0_s14; // s25f18
    reg signed [6:-18] q0_s14; // s25f18
    reg signed [6:-18] r0_s14; // s25f18
    reg signed [2:-35] n203_s14; // s38f35
    reg signed [2:-35] n205_s14; // s38f35
    reg signed [2:-35] n207_s14; // s38f35
    reg signed [0:-17] l_norm_x_s14; // s18f17
    reg signed [0:-17] l_norm_y_s14; // s18f17
    reg signed [0:-17] l_norm_z_s14; // s18f17
    reg [1:-18] reciprocal_length_reciprocal_length_s14; // u20f18
    reg signed [9:-20] ks_q_s14; // s30f20
    reg n406_s14; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s14 <= normal_x_s13;
            normal_y_s14 <= normal_y_s13;
            normal_z_s14 <= normal_z_s13;
            s0_s14 <= s0_s13;
            t0_s14 <= t0_s13;
            q0_s14 <= q0_s13;
            r0_s14 <= r0_s13;
            n203_s14 <= n203;
            n205_s14 <= n205;
            n207_s14 <= n207;
            l_norm_x_s14 <= l_norm_x_s13;
            l_norm_y_s14 <= l_norm_y_s13;
            l_norm_z_s14 <= l_norm_z_s13;
            reciprocal_length_reciprocal_length_s14 <= reciprocal_length_reciprocal_length_s13;
            ks_q_s14 <= ks_q_s13;
            n406_s14 <= n406_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    wire signed [3:-35] bn_unit_x_sum = {n203_s14[2], n203_s14} + 39'h10000;
    wire signed [3:-18] bn_unit_x_cut = bn_unit_x_sum[3:-18];
    wire bn_unit_x_over = ~bn_unit_x_cut[3] & (|bn_unit_x_cut[2:1]);
    wire bn_unit_x_under = bn_unit_x_cut[3] & ~(&bn_unit_x_cut[2:1]);
    wire signed [1:-18] bn_unit_x = bn_unit_x_over ? 20'h7ffff : bn_unit_x_under ? 20'h80000 : bn_unit_x_cut[1:-18]; // s20f18
    wire signed [3:-35] bn_unit_y_sum = {n205_s14[2], n205_s14} + 39'h10000;
    wire signed [3:-18] bn_unit_y_cut = bn_unit_y_sum[3:-18];
    wire bn_unit_y_over = ~bn_unit_y_cut[3] & (|bn_unit_y_cut[2:1]);
    wire bn_unit_y_under = bn_unit_y_cut[3] & ~(&bn_unit_y_cut[2:1]);
    wire signed [1:-18] bn_unit_y = bn_unit_y_over ? 20'h7ffff : bn_unit_y_under ? 20'h80000 : bn_unit_y_cut[1:-18]; // s20f18
    wire signed [3:-35] bn_unit_z_sum = {n207_s14[2], n207_s14} + 39'h10000;
    wire signed [3:-18] bn_unit_z_cut = bn_unit_z_sum[3:-18];
    wire bn_unit_z_over = ~bn_unit_z_cut[3] & (|bn_unit_z_cut[2:1]);
    wire bn_unit_z_under = bn_unit_z_cut[3] & ~(&bn_unit_z_cut[2:1]);
    wire signed [1:-18] bn_unit_z = bn_unit_z_over ? 20'h7ffff : bn_unit_z_under ? 20'h80000 : bn_unit_z_cut[1:-18]; // s20f18

    reg signed [1:-14] normal_x_s15; // s16f14
    reg signed [1:-14] normal_y_s15; // s16f14
    reg signed [1:-14] normal_z_s15; // s16f14
    reg signed [6:-18] s0_s15; // s25f18
    reg signed [6:-18] t0_s15; // s25f18
    reg signed [6:-18] q0_s15; // s25f18
    reg signed [6:-18] r0_s15; // s25f18
    reg signed [1:-18] bn_unit_x_s15; // s20f18
    reg signed [1:-18] bn_unit_y_s15; // s20f18
    reg signed [1:-18] bn_unit_z_s15; // s20f18
    reg signed [0:-17] l_norm_x_s15; // s18f17
    reg signed [0:-17] l_norm_y_s15; // s18f17
    reg signed [0:-17] l_norm_z_s15; // s18f17
    reg [1:-18] reciprocal_length_reciprocal_length_s15; // u20f18
    reg signed [9:-20] ks_q_s15; // s30f20
    reg n406_s15; // u1f0
    always @(posedge clk)
        if (ce) begin
            normal_x_s15 <= normal_x_s14;
            normal_y_s15 <= normal_y_s14;
            normal_z_s15 <= normal_z_s14;
            s0_s15 <= s0_s14;
            t0_s15 <= t0_s14;
            q0_s15 <= q0_s14;
            r0_s15 <= r0_s14;
            bn_unit_x_s15 <= bn_unit_x;
            bn_unit_y_s15 <= bn_unit_y;
            bn_unit_z_s15 <= bn_unit_z;
            l_norm_x_s15 <= l_norm_x_s14;
            l_norm_y_s15 <= l_norm_y_s14;
            l_norm_z_s15 <= l_norm_z_s14;
            reciprocal_length_reciprocal_length_s15 <= reciprocal_length_reciprocal_length_s14;
            ks_q_s15 <= ks_q_s14;
            n406_s15 <= n406_s14;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // bn_cross_n
    wire signed [3:-32] bn_cross_n_n209 = bn_unit_y_s15 * normal_z_s15; // s36f32
    wire signed [3:-32] bn_cross_n_n210 = bn_unit_z_s15 * normal_y_s15; // s36f32
    wire signed [3:-32] bn_cross_n_n212 = bn_unit_z_s15 * normal_x_s15; // s36f32
    wire signed [3:-32] bn_cross_n_n213 = bn_unit_x_s15 * normal_z_s15; // s36f32
    wire signed [3:-32] bn_cross_n_n215 = bn_unit_x_s15 * normal_y_s15; // s36f32
    wire signed [3:-32] bn_cross_n_n216 = bn_unit_y_s15 * normal_x_s15; // s36f32
    // b_dot_l
    wire signed [2:-35] b_dot_l_n384 = bn_unit_x_s15 * l_norm_x_s15; // s38f35
    wire signed [2:-35] b_dot_l_n385 = bn_unit_y_s15 * l_norm_y_s15; // s38f35
    wire signed [2:-35] b_dot_l_n386 = bn_unit_z_s15 * l_norm_z_s15; // s38f35

    reg signed [6:-18] s0_s16; // s25f18
    reg signed [6:-18] t0_s16; // s25f18
    reg signed [6:-18] q0_s16; // s25f18
    reg signed [6:-18] r0_s16; // s25f18
    reg signed [3:-32] bn_cross_n_n209_s16; // s36f32
    reg signed [3:-32] bn_cross_n_n210_s16; // s36f32
    reg signed [3:-32] bn_cross_n_n212_s16; // s36f32
    reg signed [3:-32] bn_cross_n_n213_s16; // s36f32
    reg signed [3:-32] bn_cross_n_n215_s16; // s36f32
    reg signed [3:-32] bn_cross_n_n216_s16; // s36f32
    reg signed [0:-17] l_norm_x_s16; // s18f17
    reg signed [0:-17] l_norm_y_s16; // s18f17
    reg signed [0:-17] l_norm_z_s16; // s18f17
    reg [1:-18] reciprocal_length_reciprocal_length_s16; // u20f18
    reg signed [2:-35] b_dot_l_n384_s16; // s38f35
    reg signed [2:-35] b_dot_l_n385_s16; // s38f35
    reg signed [2:-35] b_dot_l_n386_s16; // s38f35
    reg signed [9:-20] ks_q_s16; // s30f20
    reg n406_s16; // u1f0
    always @(posedge clk)
        if (ce) begin
            s0_s16 <= s0_s15;
            t0_s16 <= t0_s15;
            q0_s16 <= q0_s15;
            r0_s16 <= r0_s15;
            bn_cross_n_n209_s16 <= bn_cross_n_n209;
            bn_cross_n_n210_s16 <= bn_cross_n_n210;
            bn_cross_n_n212_s16 <= bn_cross_n_n212;
            bn_cross_n_n213_s16 <= bn_cross_n_n213;
            bn_cross_n_n215_s16 <= bn_cross_n_n215;
            bn_cross_n_n216_s16 <= bn_cross_n_n216;
            l_norm_x_s16 <= l_norm_x_s15;
            l_norm_y_s16 <= l_norm_y_s15;
            l_norm_z_s16 <= l_norm_z_s15;
            reciprocal_length_reciprocal_length_s16 <= reciprocal_length_reciprocal_length_s15;
            b_dot_l_n384_s16 <= b_dot_l_n384;
            b_dot_l_n385_s16 <= b_dot_l_n385;
            b_dot_l_n386_s16 <= b_dot_l_n386;
            ks_q_s16 <= ks_q_s15;
            n406_s16 <= n406_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // bn_cross_n
    wire signed [4:-32] bn_cross_n_n211 = {bn_cross_n_n209_s16[3], bn_cross_n_n209_s16} - {bn_cross_n_n210_s16[3], bn_cross_n_n210_s16}; // s37f32
    wire signed [4:-32] bn_cross_n_n214 = {bn_cross_n_n212_s16[3], bn_cross_n_n212_s16} - {bn_cross_n_n213_s16[3], bn_cross_n_n213_s16}; // s37f32
    wire signed [4:-32] bn_cross_n_n217 = {bn_cross_n_n215_s16[3], bn_cross_n_n215_s16} - {bn_cross_n_n216_s16[3], bn_cross_n_n216_s16}; // s37f32
    // (unit)
    wire signed [5:-32] n218_sum = {bn_cross_n_n211[4], bn_cross_n_n211} + 38'h2000;
    wire signed [5:-18] n218_cut = n218_sum[5:-18];
    wire signed [5:-18] n218 = n218_cut; // s24f18
    wire signed [5:-32] n219_sum = {bn_cross_n_n214[4], bn_cross_n_n214} + 38'h2000;
    wire signed [5:-18] n219_cut = n219_sum[5:-18];
    wire signed [5:-18] n219 = n219_cut; // s24f18
    wire signed [5:-32] n220_sum = {bn_cross_n_n217[4], bn_cross_n_n217} + 38'h2000;
    wire signed [5:-18] n220_cut = n220_sum[5:-18];
    wire signed [5:-18] n220 = n220_cut; // s24f18
    // b_dot_l
    wire signed [3:-35] b_dot_l_n387 = {b_dot_l_n384_s16[2], b_dot_l_n384_s16} + {b_dot_l_n385_s16[2], b_dot_l_n385_s16}; // s39f35
    wire signed [4:-35] b_dot_l_n388 = {b_dot_l_n387[3], b_dot_l_n387} + {{2{b_dot_l_n386_s16[2]}}, b_dot_l_n386_s16}; // s40f35
    // (unit)
    wire signed [5:-35] b_l_sum = {b_dot_l_n388[4], b_dot_l_n388} + 41'h4000;
    wire signed [5:-20] b_l_cut = b_l_sum[5:-20];
    wire signed [5:-20] b_l = b_l_cut; // s26f20

    reg signed [6:-18] s0_s17; // s25f18
    reg signed [6:-18] t0_s17; // s25f18
    reg signed [6:-18] q0_s17; // s25f18
    reg signed [6:-18] r0_s17; // s25f18
    reg signed [5:-18] n218_s17; // s24f18
    reg signed [5:-18] n219_s17; // s24f18
    reg signed [5:-18] n220_s17; // s24f18
    reg signed [0:-17] l_norm_x_s17; // s18f17
    reg signed [0:-17] l_norm_y_s17; // s18f17
    reg signed [0:-17] l_norm_z_s17; // s18f17
    reg [1:-18] reciprocal_length_reciprocal_length_s17; // u20f18
    reg signed [5:-20] b_l_s17; // s26f20
    reg signed [9:-20] ks_q_s17; // s30f20
    reg n406_s17; // u1f0
    always @(posedge clk)
        if (ce) begin
            s0_s17 <= s0_s16;
            t0_s17 <= t0_s16;
            q0_s17 <= q0_s16;
            r0_s17 <= r0_s16;
            n218_s17 <= n218;
            n219_s17 <= n219;
            n220_s17 <= n220;
            l_norm_x_s17 <= l_norm_x_s16;
            l_norm_y_s17 <= l_norm_y_s16;
            l_norm_z_s17 <= l_norm_z_s16;
            reciprocal_length_reciprocal_length_s17 <= reciprocal_length_reciprocal_length_s16;
            b_l_s17 <= b_l;
            ks_q_s17 <= ks_q_s16;
            n406_s17 <= n406_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // t_dot_l
    wire signed [6:-35] t_dot_l_n329 = n218_s17 * l_norm_x_s17; // s42f35
    wire signed [6:-35] t_dot_l_n330 = n219_s17 * l_norm_y_s17; // s42f35
    wire signed [6:-35] t_dot_l_n331 = n220_s17 * l_norm_z_s17; // s42f35
    // (unit)
    wire signed [7:-38] ds_product = b_l_s17 * $signed({1'b0, reciprocal_length_reciprocal_length_s17}); // s46f38

    reg signed [6:-18] s0_s18; // s25f18
    reg signed [6:-18] t0_s18; // s25f18
    reg signed [6:-18] q0_s18; // s25f18
    reg signed [6:-18] r0_s18; // s25f18
    reg signed [6:-35] t_dot_l_n329_s18; // s42f35
    reg signed [6:-35] t_dot_l_n330_s18; // s42f35
    reg signed [6:-35] t_dot_l_n331_s18; // s42f35
    reg [1:-18] reciprocal_length_reciprocal_length_s18; // u20f18
    reg signed [7:-38] ds_product_s18; // s46f38
    reg signed [9:-20] ks_q_s18; // s30f20
    reg n406_s18; // u1f0
    always @(posedge clk)
        if (ce) begin
            s0_s18 <= s0_s17;
            t0_s18 <= t0_s17;
            q0_s18 <= q0_s17;
            r0_s18 <= r0_s17;
            t_dot_l_n329_s18 <= t_dot_l_n329;
            t_dot_l_n330_s18 <= t_dot_l_n330;
            t_dot_l_n331_s18 <= t_dot_l_n331;
            reciprocal_length_reciprocal_length_s18 <= reciprocal_length_reciprocal_length_s17;
            ds_product_s18 <= ds_product;
            ks_q_s18 <= ks_q_s17;
            n406_s18 <= n406_s17;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // t_dot_l
    wire signed [7:-35] t_dot_l_n332 = {t_dot_l_n329_s18[6], t_dot_l_n329_s18} + {t_dot_l_n330_s18[6], t_dot_l_n330_s18}; // s43f35
    wire signed [8:-35] t_dot_l_n333 = {t_dot_l_n332[7], t_dot_l_n332} + {{2{t_dot_l_n331_s18[6]}}, t_dot_l_n331_s18}; // s44f35
    // (unit)
    wire signed [8:-38] ds_unit_sum = {ds_product_s18[7], ds_product_s18} + 47'h20000;
    wire signed [8:-20] ds_unit_cut = ds_unit_sum[8:-20];
    wire ds_unit_over = ~ds_unit_cut[8] & (|ds_unit_cut[7:2]);
    wire ds_unit_under = ds_unit_cut[8] & ~(&ds_unit_cut[7:2]);
    wire signed [2:-20] ds_unit = ds_unit_over ? 23'h3fffff : ds_unit_under ? 23'h400000 : ds_unit_cut[2:-20]; // s23f20

    reg signed [6:-18] s0_s19; // s25f18
    reg signed [6:-18] t0_s19; // s25f18
    reg signed [6:-18] q0_s19; // s25f18
    reg signed [6:-18] r0_s19; // s25f18
    reg signed [8:-35] t_dot_l_n333_s19; // s44f35
    reg [1:-18] reciprocal_length_reciprocal_length_s19; // u20f18
    reg signed [2:-20] ds_unit_s19; // s23f20
    reg signed [9:-20] ks_q_s19; // s30f20
    reg n406_s19; // u1f0
    always @(posedge clk)
        if (ce) begin
            s0_s19 <= s0_s18;
            t0_s19 <= t0_s18;
            q0_s19 <= q0_s18;
            r0_s19 <= r0_s18;
            t_dot_l_n333_s19 <= t_dot_l_n333;
            reciprocal_length_reciprocal_length_s19 <= reciprocal_length_reciprocal_length_s18;
            ds_unit_s19 <= ds_unit;
            ks_q_s19 <= ks_q_s18;
            n406_s19 <= n406_s18;
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    wire signed [9:-35] t_l_sum = {t_dot_l_n333_s19[8], t_dot_l_n333_s19} + 45'h4000;
    wire signed [9:-20] t_l_cut = t_l_sum[9:-20];
    wire signed [9:-20] t_l = t_l_cut; // s30f20
    wire signed [12:-40] n395 = ds_unit_s19 * ks_q_s19; // s53f40

    reg signed [6:-18] s0_s20; // s25f18
    reg signed [6:-18] t0_s20; // s25f18
    reg signed [6:-18] q0_s20; // s25f18
    reg signed [6:-18] r0_s20; // s25f18
    reg signed [9:-20] t_l_s20; // s30f20
    reg [1:-18] reciprocal_length_reciprocal_length_s20; // u20f18
    reg signed [9:-20] ks_q_s20; // s30f20
    reg signed [12:-40] n395_s20; // s53f40
    reg n406_s20; // u1f0
    always @(posedge clk)
        if (ce) begin
            s0_s20 <= s0_s19;
            t0_s20 <= t0_s19;
            q0_s20 <= q0_s19;
            r0_s20 <= r0_s19;
            t_l_s20 <= t_l;
            reciprocal_length_reciprocal_length_s20 <= reciprocal_length_reciprocal_length_s19;
            ks_q_s20 <= ks_q_s19;
            n395_s20 <= n395;
            n406_s20 <= n406_s19;
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    wire signed [13:-40] ds_next_sum = {n395_s20[12], n395_s20} + 54'h200000;
    wire signed [13:-18] ds_next_cut = ds_next_sum[13:-18];
    wire ds_next_over = ~ds_next_cut[13] & (|ds_next_cut[12:11]);
    wire ds_next_under = ds_next_cut[13] & ~(&ds_next_cut[12:11]);
    wire signed [11:-18] ds_next = ds_next_over ? 30'h1fffffff : ds_next_under ? 30'h20000000 : ds_next_cut[11:-18]; // s30f18
    wire signed [12:-18] s1_sum = {{6{s0_s20[6]}}, s0_s20} + {ds_next[11], ds_next}; // s31f18
    wire s1_next_over = ~s1_sum[12] & (|s1_sum[11:6]);
    wire s1_next_under = s1_sum[12] & ~(&s1_sum[11:6]);
    wire signed [6:-18] s1_next = s1_next_over ? 25'hffffff : s1_next_under ? 25'h1000000 : s1_sum[6:-18]; // s25f18
    wire signed [11:-38] dt_product = t_l_s20 * $signed({1'b0, reciprocal_length_reciprocal_length_s20}); // s50f38

    reg signed [6:-18] t0_s21; // s25f18
    reg signed [6:-18] q0_s21; // s25f18
    reg signed [6:-18] r0_s21; // s25f18
    reg signed [9:-20] ks_q_s21; // s30f20
    reg signed [11:-18] ds_next_s21; // s30f18
    reg signed [6:-18] s1_next_s21; // s25f18
    reg signed [11:-38] dt_product_s21; // s50f38
    reg n406_s21; // u1f0
    always @(posedge clk)
        if (ce) begin
            t0_s21 <= t0_s20;
            q0_s21 <= q0_s20;
            r0_s21 <= r0_s20;
            ks_q_s21 <= ks_q_s20;
            ds_next_s21 <= ds_next;
            s1_next_s21 <= s1_next;
            dt_product_s21 <= dt_product;
            n406_s21 <= n406_s20;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;

    // ---- stage 21 ----
    wire signed [12:-38] dt_unit_sum = {dt_product_s21[11], dt_product_s21} + 51'h20000;
    wire signed [12:-20] dt_unit_cut = dt_unit_sum[12:-20];
    wire dt_unit_over = ~dt_unit_cut[12] & (|dt_unit_cut[11:6]);
    wire dt_unit_under = dt_unit_cut[12] & ~(&dt_unit_cut[11:6]);
    wire signed [6:-20] dt_unit = dt_unit_over ? 27'h3ffffff : dt_unit_under ? 27'h4000000 : dt_unit_cut[6:-20]; // s27f20

    reg signed [6:-18] t0_s22; // s25f18
    reg signed [6:-18] q0_s22; // s25f18
    reg signed [6:-18] r0_s22; // s25f18
    reg signed [9:-20] ks_q_s22; // s30f20
    reg signed [11:-18] ds_next_s22; // s30f18
    reg signed [6:-18] s1_next_s22; // s25f18
    reg signed [6:-20] dt_unit_s22; // s27f20
    reg n406_s22; // u1f0
    always @(posedge clk)
        if (ce) begin
            t0_s22 <= t0_s21;
            q0_s22 <= q0_s21;
            r0_s22 <= r0_s21;
            ks_q_s22 <= ks_q_s21;
            ds_next_s22 <= ds_next_s21;
            s1_next_s22 <= s1_next_s21;
            dt_unit_s22 <= dt_unit;
            n406_s22 <= n406_s21;
        end
    reg valid_s22;
    always @(posedge clk)
        if (rst) valid_s22 <= 1'b0;
        else if (ce) valid_s22 <= valid_s21;

    // ---- stage 22 ----
    wire signed [16:-40] n401 = dt_unit_s22 * ks_q_s22; // s57f40

    reg signed [6:-18] t0_s23; // s25f18
    reg signed [6:-18] q0_s23; // s25f18
    reg signed [6:-18] r0_s23; // s25f18
    reg signed [11:-18] ds_next_s23; // s30f18
    reg signed [6:-18] s1_next_s23; // s25f18
    reg signed [16:-40] n401_s23; // s57f40
    reg n406_s23; // u1f0
    always @(posedge clk)
        if (ce) begin
            t0_s23 <= t0_s22;
            q0_s23 <= q0_s22;
            r0_s23 <= r0_s22;
            ds_next_s23 <= ds_next_s22;
            s1_next_s23 <= s1_next_s22;
            n401_s23 <= n401;
            n406_s23 <= n406_s22;
        end
    reg valid_s23;
    always @(posedge clk)
        if (rst) valid_s23 <= 1'b0;
        else if (ce) valid_s23 <= valid_s22;

    // ---- stage 23 ----
    wire signed [17:-40] n402 = -{n401_s23[16], n401_s23}; // s58f40
    wire signed [18:-40] dt_next_sum = {n402[17], n402} + 59'h200000;
    wire signed [18:-18] dt_next_cut = dt_next_sum[18:-18];
    wire dt_next_over = ~dt_next_cut[18] & (|dt_next_cut[17:15]);
    wire dt_next_under = dt_next_cut[18] & ~(&dt_next_cut[17:15]);
    wire signed [15:-18] dt_next = dt_next_over ? 34'h1ffffffff : dt_next_under ? 34'h200000000 : dt_next_cut[15:-18]; // s34f18

    reg signed [6:-18] t0_s24; // s25f18
    reg signed [6:-18] q0_s24; // s25f18
    reg signed [6:-18] r0_s24; // s25f18
    reg signed [11:-18] ds_next_s24; // s30f18
    reg signed [6:-18] s1_next_s24; // s25f18
    reg signed [15:-18] dt_next_s24; // s34f18
    reg n406_s24; // u1f0
    always @(posedge clk)
        if (ce) begin
            t0_s24 <= t0_s23;
            q0_s24 <= q0_s23;
            r0_s24 <= r0_s23;
            ds_next_s24 <= ds_next_s23;
            s1_next_s24 <= s1_next_s23;
            dt_next_s24 <= dt_next;
            n406_s24 <= n406_s23;
        end
    reg valid_s24;
    always @(posedge clk)
        if (rst) valid_s24 <= 1'b0;
        else if (ce) valid_s24 <= valid_s23;

    // ---- stage 24 ----
    wire signed [16:-18] t1_sum = {{10{t0_s24[6]}}, t0_s24} + {dt_next_s24[15], dt_next_s24}; // s35f18
    wire t1_next_over = ~t1_sum[16] & (|t1_sum[15:6]);
    wire t1_next_under = t1_sum[16] & ~(&t1_sum[15:6]);
    wire signed [6:-18] t1_next = t1_next_over ? 25'hffffff : t1_next_under ? 25'h1000000 : t1_sum[6:-18]; // s25f18

    always @(posedge clk)
        if (ce) begin
            q1 <= q0_s24;
            r1 <= r0_s24;
            ds <= ds_next_s24;
            s1 <= s1_next_s24;
            dt <= dt_next_s24;
            t1 <= t1_next;
            degenerate <= n406_s24;
        end
    reg valid_s25;
    always @(posedge clk)
        if (rst) valid_s25 <= 1'b0;
        else if (ce) valid_s25 <= valid_s24;
    assign valid_out = valid_s25;

    // ---- stage 25 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        ks_q_sum[-21:-38],
        l_block_n253[27:0],
        bn_n65[31:0],
        l_norm_x_sum[-18:-29],
        l_norm_y_sum[-18:-29],
        l_norm_z_sum[-18:-29],
        bn_norm_x_sum[-18:-33],
        bn_norm_y_sum[-18:-33],
        bn_norm_z_sum[-18:-33],
        reciprocal_length_square_sum[-21:-34],
        bn_length_square_sum[-21:-34],
        reciprocal_length_n362[1:0],
        reciprocal_length_n367[2],
        bn_length_n179[1:0],
        bn_length_n185[2],
        reciprocal_length_recip_root_n378_sum[-21:-33],
        bn_length_recip_root_n196_sum[-21:-33],
        reciprocal_length_reciprocal_length_sum[-19:-21],
        bn_length_bn_length_sum[-19:-21],
        bn_unit_x_sum[-19:-35],
        bn_unit_y_sum[-19:-35],
        bn_unit_z_sum[-19:-35],
        n218_sum[-19:-32],
        n219_sum[-19:-32],
        n220_sum[-19:-32],
        b_l_sum[-21:-35],
        ds_unit_sum[-21:-38],
        t_l_sum[-21:-35],
        ds_next_sum[-19:-40],
        dt_unit_sum[-21:-38],
        dt_next_sum[-19:-40]};
endmodule
