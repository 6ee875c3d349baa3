// rotation: turns a direction in polar form into the frame of a surface normal
// made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
//   variant=exact output=polar-cordic angle_bits=16 table_addr_bits=10 scheme=direct
//   quarter_wave=off frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate
//   sincos_addr_bits=auto asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
//   prop_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
//   period_ps=5000 stages=auto rom=block
// latency 27 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   angle: mean 1.41e-3 rad, largest seen 4.89e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   dot: mean 1.41e-3, largest seen 4.89e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   x: mean 7.66e-4, largest seen 4.11e-3 at phi_a=29150 theta_a=16832 phi_n=13217 theta_n=8896
//   y: mean 6.08e-4, largest seen 3.10e-3 at phi_a=30741 theta_a=4418 phi_n=47062 theta_n=20098
//   z: mean 7.28e-4, largest seen 3.81e-3 at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
// stated bound on the angle: 1.07e-2 rad
module rotation_exact_polar_cordic (
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
    initial begin
        sincos_rom[0] = 40'h003183fffe; sincos_rom[1] = 40'h009603fff4; sincos_rom[2] = 40'h00fa83ffe0; sincos_rom[3] = 40'h015f13ffc3;
        sincos_rom[4] = 40'h01c393ff9b; sincos_rom[5] = 40'h022803ff6a; sincos_rom[6] = 40'h028c83ff2f; sincos_rom[7] = 40'h02f0f3feea;
        sincos_rom[8] = 40'h035553fe9b; sincos_rom[9] = 40'h03b9b3fe42; sincos_rom[10] = 40'h041e13fde0; sincos_rom[11] = 40'h048263fd73;
        sincos_rom[12] = 40'h04e6a3fcfd; sincos_rom[13] = 40'h054ad3fc7d; sincos_rom[14] = 40'h05af03fbf3; sincos_rom[15] = 40'h061313fb5f;
        sincos_rom[16] = 40'h067723fac2; sincos_rom[17] = 40'h06db23fa1a; sincos_rom[18] = 40'h073f13f969; sincos_rom[19] = 40'h07a2e3f8ae;
        sincos_rom[20] = 40'h0806b3f7e9; sincos_rom[21] = 40'h086a63f71b; sincos_rom[22] = 40'h08ce03f642; sincos_rom[23] = 40'h093183f560;
        sincos_rom[24] = 40'h0994f3f474; sincos_rom[25] = 40'h09f853f37e; sincos_rom[26] = 40'h0a5b93f27f; sincos_rom[27] = 40'h0abeb3f176;
        sincos_rom[28] = 40'h0b21c3f063; sincos_rom[29] = 40'h0b84b3ef46; sincos_rom[30] = 40'h0be793ee20; sincos_rom[31] = 40'h0c4a43ecf0;
        sincos_rom[32] = 40'h0cace3ebb6; sincos_rom[33] = 40'h0d0f53ea73; sincos_rom[34] = 40'h0d71b3e926; sincos_rom[35] = 40'h0dd3f3e7cf;
        sincos_rom[36] = 40'h0e3603e66f; sincos_rom[37] = 40'h0e97f3e505; sincos_rom[38] = 40'h0ef9c3e391; sincos_rom[39] = 40'h0f5b73e214;
        sincos_rom[40] = 40'h0fbcf3e08d; sincos_rom[41] = 40'h101e53defd; sincos_rom[42] = 40'h107f83dd63; sincos_rom[43] = 40'h10e093dbc0;
        sincos_rom[44] = 40'h114183da13; sincos_rom[45] = 40'h11a233d85c; sincos_rom[46] = 40'h1202c3d69c; sincos_rom[47] = 40'h126323d4d3;
        sincos_rom[48] = 40'h12c353d300; sincos_rom[49] = 40'h132363d124; sincos_rom[50] = 40'h138333cf3e; sincos_rom[51] = 40'h13e2d3cd4f;
        sincos_rom[52] = 40'h144253cb57; sincos_rom[53] = 40'h14a193c955; sincos_rom[54] = 40'h1500a3c749; sincos_rom[55] = 40'h155f83c535;
        sincos_rom[56] = 40'h15be23c317; sincos_rom[57] = 40'h161c93c0f0; sincos_rom[58] = 40'h167ad3bec0; sincos_rom[59] = 40'h16d8d3bc86;
        sincos_rom[60] = 40'h1736a3ba43; sincos_rom[61] = 40'h179433b7f7; sincos_rom[62] = 40'h17f193b5a2; sincos_rom[63] = 40'h184eb3b344;
        sincos_rom[64] = 40'h18ab93b0dc; sincos_rom[65] = 40'h190833ae6c; sincos_rom[66] = 40'h196493abf2; sincos_rom[67] = 40'h19c0c3a96f;
        sincos_rom[68] = 40'h1a1ca3a6e4; sincos_rom[69] = 40'h1a7853a44f; sincos_rom[70] = 40'h1ad3b3a1b1; sincos_rom[71] = 40'h1b2ee39f0a;
        sincos_rom[72] = 40'h1b89c39c5b; sincos_rom[73] = 40'h1be45399a2; sincos_rom[74] = 40'h1c3eb396e1; sincos_rom[75] = 40'h1c98c39416;
        sincos_rom[76] = 40'h1cf2939143; sincos_rom[77] = 40'h1d4c138e67; sincos_rom[78] = 40'h1da5538b83; sincos_rom[79] = 40'h1dfe438895;
        sincos_rom[80] = 40'h1e56f3859f; sincos_rom[81] = 40'h1eaf5382a0; sincos_rom[82] = 40'h1f07637f99; sincos_rom[83] = 40'h1f5f237c89;
        sincos_rom[84] = 40'h1fb6a37970; sincos_rom[85] = 40'h200dd3764e; sincos_rom[86] = 40'h2064a37325; sincos_rom[87] = 40'h20bb336ff2;
        sincos_rom[88] = 40'h2111736cb7; sincos_rom[89] = 40'h2167536974; sincos_rom[90] = 40'h21bcf36628; sincos_rom[91] = 40'h22123362d4;
        sincos_rom[92] = 40'h2267235f78; sincos_rom[93] = 40'h22bbc35c13; sincos_rom[94] = 40'h23100358a6; sincos_rom[95] = 40'h2363f35531;
        sincos_rom[96] = 40'h23b78351b3; sincos_rom[97] = 40'h240ac34e2d; sincos_rom[98] = 40'h245db34a9f; sincos_rom[99] = 40'h24b0334709;
        sincos_rom[100] = 40'h250273436b; sincos_rom[101] = 40'h2554433fc5; sincos_rom[102] = 40'h25a5c33c17; sincos_rom[103] = 40'h25f6d33861;
        sincos_rom[104] = 40'h26479334a3; sincos_rom[105] = 40'h26980330dc; sincos_rom[106] = 40'h26e8032d0f; sincos_rom[107] = 40'h2737a32939;
        sincos_rom[108] = 40'h2786e3255b; sincos_rom[109] = 40'h27d5c32176; sincos_rom[110] = 40'h2824431d89; sincos_rom[111] = 40'h2872531994;
        sincos_rom[112] = 40'h28c0131598; sincos_rom[113] = 40'h290d631194; sincos_rom[114] = 40'h295a530d88; sincos_rom[115] = 40'h29a6d30975;
        sincos_rom[116] = 40'h29f2f3055b; sincos_rom[117] = 40'h2a3eb30139; sincos_rom[118] = 40'h2a8a02fd0f; sincos_rom[119] = 40'h2ad4e2f8df;
        sincos_rom[120] = 40'h2b1f62f4a6; sincos_rom[121] = 40'h2b6972f067; sincos_rom[122] = 40'h2bb322ec20; sincos_rom[123] = 40'h2bfc62e7d2;
        sincos_rom[124] = 40'h2c4532e37d; sincos_rom[125] = 40'h2c8d92df21; sincos_rom[126] = 40'h2cd582dabe; sincos_rom[127] = 40'h2d1d02d654;
        sincos_rom[128] = 40'h2d6422d1e2; sincos_rom[129] = 40'h2daac2cd6a; sincos_rom[130] = 40'h2df102c8eb; sincos_rom[131] = 40'h2e36c2c465;
        sincos_rom[132] = 40'h2e7c12bfd8; sincos_rom[133] = 40'h2ec0f2bb44; sincos_rom[134] = 40'h2f0562b6aa; sincos_rom[135] = 40'h2f4962b209;
        sincos_rom[136] = 40'h2f8ce2ad61; sincos_rom[137] = 40'h2fcff2a8b3; sincos_rom[138] = 40'h301282a3fe; sincos_rom[139] = 40'h3054a29f42;
        sincos_rom[140] = 40'h3096529a80; sincos_rom[141] = 40'h30d78295b8; sincos_rom[142] = 40'h31184290e9; sincos_rom[143] = 40'h3158828c14;
        sincos_rom[144] = 40'h3198428739; sincos_rom[145] = 40'h31d7928257; sincos_rom[146] = 40'h3216627d70; sincos_rom[147] = 40'h3254c27882;
        sincos_rom[148] = 40'h329292738e; sincos_rom[149] = 40'h32cff26e94; sincos_rom[150] = 40'h330cd26994; sincos_rom[151] = 40'h334932648e;
        sincos_rom[152] = 40'h3385225f82; sincos_rom[153] = 40'h33c0825a70; sincos_rom[154] = 40'h33fb625558; sincos_rom[155] = 40'h3435d2503b;
        sincos_rom[156] = 40'h346fb24b18; sincos_rom[157] = 40'h34a91245ef; sincos_rom[158] = 40'h34e1f240c1; sincos_rom[159] = 40'h351a523b8d;
        sincos_rom[160] = 40'h3552323654; sincos_rom[161] = 40'h3589823115; sincos_rom[162] = 40'h35c0522bd1; sincos_rom[163] = 40'h35f6a22687;
        sincos_rom[164] = 40'h362c722138; sincos_rom[165] = 40'h3661b21be4; sincos_rom[166] = 40'h369672168b; sincos_rom[167] = 40'h36caa2112c;
        sincos_rom[168] = 40'h36fe520bc9; sincos_rom[169] = 40'h3731820660; sincos_rom[170] = 40'h37642200f2; sincos_rom[171] = 40'h379631fb80;
        sincos_rom[172] = 40'h37c7c1f608; sincos_rom[173] = 40'h37f8d1f08c; sincos_rom[174] = 40'h382941eb0b; sincos_rom[175] = 40'h385931e585;
        sincos_rom[176] = 40'h388891dffb; sincos_rom[177] = 40'h38b771da6b; sincos_rom[178] = 40'h38e5c1d4d8; sincos_rom[179] = 40'h391381cf3f;
        sincos_rom[180] = 40'h3940b1c9a3; sincos_rom[181] = 40'h396d61c402; sincos_rom[182] = 40'h399971be5c; sincos_rom[183] = 40'h39c501b8b2;
        sincos_rom[184] = 40'h39f001b304; sincos_rom[185] = 40'h3a1a71ad52; sincos_rom[186] = 40'h3a4441a79c; sincos_rom[187] = 40'h3a6d91a1e1;
        sincos_rom[188] = 40'h3a96519c23; sincos_rom[189] = 40'h3abe819660; sincos_rom[190] = 40'h3ae621909a; sincos_rom[191] = 40'h3b0d318ad0;
        sincos_rom[192] = 40'h3b33a18502; sincos_rom[193] = 40'h3b59917f30; sincos_rom[194] = 40'h3b7ee1795b; sincos_rom[195] = 40'h3ba3a17382;
        sincos_rom[196] = 40'h3bc7d16da5; sincos_rom[197] = 40'h3beb7167c5; sincos_rom[198] = 40'h3c0e7161e1; sincos_rom[199] = 40'h3c30f15bfa;
        sincos_rom[200] = 40'h3c52d1560f; sincos_rom[201] = 40'h3c74115022; sincos_rom[202] = 40'h3c94d14a31; sincos_rom[203] = 40'h3cb4f1443d;
        sincos_rom[204] = 40'h3cd4713e45; sincos_rom[205] = 40'h3cf361384b; sincos_rom[206] = 40'h3d11c1324e; sincos_rom[207] = 40'h3d2f912c4d;
        sincos_rom[208] = 40'h3d4cc1264a; sincos_rom[209] = 40'h3d69512044; sincos_rom[210] = 40'h3d85511a3b; sincos_rom[211] = 40'h3da0c11430;
        sincos_rom[212] = 40'h3dbb910e22; sincos_rom[213] = 40'h3dd5d10811; sincos_rom[214] = 40'h3def7101fd; sincos_rom[215] = 40'h3e0870fbe8;
        sincos_rom[216] = 40'h3e20e0f5cf; sincos_rom[217] = 40'h3e38b0efb5; sincos_rom[218] = 40'h3e4ff0e998; sincos_rom[219] = 40'h3e6690e378;
        sincos_rom[220] = 40'h3e7ca0dd57; sincos_rom[221] = 40'h3e9200d734; sincos_rom[222] = 40'h3ea6e0d10e; sincos_rom[223] = 40'h3ebb10cae6;
        sincos_rom[224] = 40'h3eceb0c4bd; sincos_rom[225] = 40'h3ee1b0be91; sincos_rom[226] = 40'h3ef420b864; sincos_rom[227] = 40'h3f05f0b235;
        sincos_rom[228] = 40'h3f1720ac04; sincos_rom[229] = 40'h3f27b0a5d2; sincos_rom[230] = 40'h3f37b09f9e; sincos_rom[231] = 40'h3f47009968;
        sincos_rom[232] = 40'h3f55c09331; sincos_rom[233] = 40'h3f63f08cf9; sincos_rom[234] = 40'h3f717086bf; sincos_rom[235] = 40'h3f7e608084;
        sincos_rom[236] = 40'h3f8ab07a47; sincos_rom[237] = 40'h3f9660740a; sincos_rom[238] = 40'h3fa1806dcb; sincos_rom[239] = 40'h3fabf0678b;
        sincos_rom[240] = 40'h3fb5d0614b; sincos_rom[241] = 40'h3fbf105b09; sincos_rom[242] = 40'h3fc7b054c6; sincos_rom[243] = 40'h3fcfb04e83;
        sincos_rom[244] = 40'h3fd720483f; sincos_rom[245] = 40'h3fdde041fa; sincos_rom[246] = 40'h3fe4103bb5; sincos_rom[247] = 40'h3fe9a0356f;
        sincos_rom[248] = 40'h3fee902f28; sincos_rom[249] = 40'h3ff2e028e1; sincos_rom[250] = 40'h3ff690229a; sincos_rom[251] = 40'h3ff9b01c52;
        sincos_rom[252] = 40'h3ffc20160a; sincos_rom[253] = 40'h3ffe000fc2; sincos_rom[254] = 40'h3fff400979; sincos_rom[255] = 40'h3fffe00331;
        sincos_rom[256] = 40'h3fffeffce8; sincos_rom[257] = 40'h3fff4ff6a0; sincos_rom[258] = 40'h3ffe0ff058; sincos_rom[259] = 40'h3ffc3fea0f;
        sincos_rom[260] = 40'h3ff9bfe3c7; sincos_rom[261] = 40'h3ff6afdd80; sincos_rom[262] = 40'h3ff2ffd738; sincos_rom[263] = 40'h3feeafd0f1;
        sincos_rom[264] = 40'h3fe9bfcaab; sincos_rom[265] = 40'h3fe42fc465; sincos_rom[266] = 40'h3fde0fbe1f; sincos_rom[267] = 40'h3fd73fb7da;
        sincos_rom[268] = 40'h3fcfdfb196; sincos_rom[269] = 40'h3fc7dfab53; sincos_rom[270] = 40'h3fbf3fa510; sincos_rom[271] = 40'h3fb5ff9ecf;
        sincos_rom[272] = 40'h3fac2f988e; sincos_rom[273] = 40'h3fa1af924e; sincos_rom[274] = 40'h3f969f8c0f; sincos_rom[275] = 40'h3f8aef85d2;
        sincos_rom[276] = 40'h3f7e9f7f95; sincos_rom[277] = 40'h3f71bf795a; sincos_rom[278] = 40'h3f642f7320; sincos_rom[279] = 40'h3f560f6ce8;
        sincos_rom[280] = 40'h3f474f66b1; sincos_rom[281] = 40'h3f37ef607b; sincos_rom[282] = 40'h3f27ff5a47; sincos_rom[283] = 40'h3f176f5415;
        sincos_rom[284] = 40'h3f063f4de4; sincos_rom[285] = 40'h3ef46f47b5; sincos_rom[286] = 40'h3ee20f4187; sincos_rom[287] = 40'h3ecf0f3b5c;
        sincos_rom[288] = 40'h3ebb6f3532; sincos_rom[289] = 40'h3ea73f2f0b; sincos_rom[290] = 40'h3e926f28e5; sincos_rom[291] = 40'h3e7cff22c1;
        sincos_rom[292] = 40'h3e66ff1ca0; sincos_rom[293] = 40'h3e505f1681; sincos_rom[294] = 40'h3e391f1064; sincos_rom[295] = 40'h3e214f0a49;
        sincos_rom[296] = 40'h3e08df0431; sincos_rom[297] = 40'h3defdefe1b; sincos_rom[298] = 40'h3dd63ef808; sincos_rom[299] = 40'h3dbc0ef1f7;
        sincos_rom[300] = 40'h3da13eebe8; sincos_rom[301] = 40'h3d85cee5dd; sincos_rom[302] = 40'h3d69cedfd4; sincos_rom[303] = 40'h3d4d3ed9ce;
        sincos_rom[304] = 40'h3d300ed3cb; sincos_rom[305] = 40'h3d124ecdca; sincos_rom[306] = 40'h3cf3eec7cd; sincos_rom[307] = 40'h3cd4fec1d3;
        sincos_rom[308] = 40'h3cb57ebbdb; sincos_rom[309] = 40'h3c955eb5e7; sincos_rom[310] = 40'h3c749eaff6; sincos_rom[311] = 40'h3c535eaa08;
        sincos_rom[312] = 40'h3c317ea41e; sincos_rom[313] = 40'h3c0f0e9e37; sincos_rom[314] = 40'h3bec0e9853; sincos_rom[315] = 40'h3bc86e9273;
        sincos_rom[316] = 40'h3ba43e8c96; sincos_rom[317] = 40'h3b7f7e86bd; sincos_rom[318] = 40'h3b5a2e80e7; sincos_rom[319] = 40'h3b344e7b15;
        sincos_rom[320] = 40'h3b0dce7547; sincos_rom[321] = 40'h3ae6ce6f7d; sincos_rom[322] = 40'h3abf2e69b7; sincos_rom[323] = 40'h3a96fe63f4;
        sincos_rom[324] = 40'h3a6e4e5e36; sincos_rom[325] = 40'h3a44fe587b; sincos_rom[326] = 40'h3a1b1e52c5; sincos_rom[327] = 40'h39f0ae4d12;
        sincos_rom[328] = 40'h39c5be4764; sincos_rom[329] = 40'h399a2e41bb; sincos_rom[330] = 40'h396e1e3c15; sincos_rom[331] = 40'h39416e3674;
        sincos_rom[332] = 40'h39143e30d7; sincos_rom[333] = 40'h38e67e2b3f; sincos_rom[334] = 40'h38b83e25ab; sincos_rom[335] = 40'h38895e201c;
        sincos_rom[336] = 40'h3859fe1a91; sincos_rom[337] = 40'h382a0e150b; sincos_rom[338] = 40'h37f99e0f8a; sincos_rom[339] = 40'h37c89e0a0e;
        sincos_rom[340] = 40'h37970e0496; sincos_rom[341] = 40'h3764edff23; sincos_rom[342] = 40'h37325df9b6; sincos_rom[343] = 40'h36ff2df44d;
        sincos_rom[344] = 40'h36cb7deee9; sincos_rom[345] = 40'h36974de98b; sincos_rom[346] = 40'h36628de431; sincos_rom[347] = 40'h362d4ddedd;
        sincos_rom[348] = 40'h35f78dd98e; sincos_rom[349] = 40'h35c13dd444; sincos_rom[350] = 40'h358a6dcf00; sincos_rom[351] = 40'h35531dc9c1;
        sincos_rom[352] = 40'h351b3dc488; sincos_rom[353] = 40'h34e2ddbf54; sincos_rom[354] = 40'h34a9fdba25; sincos_rom[355] = 40'h34709db4fd;
        sincos_rom[356] = 40'h3436bdafd9; sincos_rom[357] = 40'h33fc5daabc; sincos_rom[358] = 40'h33c17da5a4; sincos_rom[359] = 40'h33861da093;
        sincos_rom[360] = 40'h334a3d9b87; sincos_rom[361] = 40'h330dcd9680; sincos_rom[362] = 40'h32d0fd9180; sincos_rom[363] = 40'h32939d8c86;
        sincos_rom[364] = 40'h3255bd8792; sincos_rom[365] = 40'h32176d82a4; sincos_rom[366] = 40'h31d89d7dbc; sincos_rom[367] = 40'h31994d78db;
        sincos_rom[368] = 40'h31598d73ff; sincos_rom[369] = 40'h31194d6f2a; sincos_rom[370] = 40'h30d88d6a5b; sincos_rom[371] = 40'h30975d6593;
        sincos_rom[372] = 40'h3055bd60d1; sincos_rom[373] = 40'h30139d5c15; sincos_rom[374] = 40'h2fd0fd5760; sincos_rom[375] = 40'h2f8dfd52b2;
        sincos_rom[376] = 40'h2f4a6d4e0a; sincos_rom[377] = 40'h2f067d4969; sincos_rom[378] = 40'h2ec20d44ce; sincos_rom[379] = 40'h2e7d2d403a;
        sincos_rom[380] = 40'h2e37dd3bad; sincos_rom[381] = 40'h2df21d3727; sincos_rom[382] = 40'h2dabed32a8; sincos_rom[383] = 40'h2d654d2e30;
        sincos_rom[384] = 40'h2d1e2d29be; sincos_rom[385] = 40'h2cd6ad2554; sincos_rom[386] = 40'h2c8ebd20f0; sincos_rom[387] = 40'h2c465d1c94;
        sincos_rom[388] = 40'h2bfd8d183f; sincos_rom[389] = 40'h2bb44d13f1; sincos_rom[390] = 40'h2b6aad0faa; sincos_rom[391] = 40'h2b209d0b6a;
        sincos_rom[392] = 40'h2ad61d0732; sincos_rom[393] = 40'h2a8b3d0301; sincos_rom[394] = 40'h2a3fecfed8; sincos_rom[395] = 40'h29f42cfab6;
        sincos_rom[396] = 40'h29a80cf69b; sincos_rom[397] = 40'h295b8cf288; sincos_rom[398] = 40'h290e9cee7c; sincos_rom[399] = 40'h28c14cea78;
        sincos_rom[400] = 40'h28739ce67c; sincos_rom[401] = 40'h28257ce287; sincos_rom[402] = 40'h27d70cde9a; sincos_rom[403] = 40'h27882cdab4;
        sincos_rom[404] = 40'h2738ecd6d7; sincos_rom[405] = 40'h26e94cd301; sincos_rom[406] = 40'h26994ccf33; sincos_rom[407] = 40'h2648eccb6d;
        sincos_rom[408] = 40'h25f82cc7ae; sincos_rom[409] = 40'h25a70cc3f8; sincos_rom[410] = 40'h25558cc04a; sincos_rom[411] = 40'h2503bcbca3;
        sincos_rom[412] = 40'h24b18cb905; sincos_rom[413] = 40'h245efcb56f; sincos_rom[414] = 40'h240c1cb1e1; sincos_rom[415] = 40'h23b8dcae5b;
        sincos_rom[416] = 40'h23654caadd; sincos_rom[417] = 40'h23115ca768; sincos_rom[418] = 40'h22bd1ca3fb; sincos_rom[419] = 40'h22687ca096;
        sincos_rom[420] = 40'h22138c9d39; sincos_rom[421] = 40'h21be4c99e5; sincos_rom[422] = 40'h2168bc9699; sincos_rom[423] = 40'h2112cc9356;
        sincos_rom[424] = 40'h20bc9c901b; sincos_rom[425] = 40'h20660c8ce8; sincos_rom[426] = 40'h200f2c89be; sincos_rom[427] = 40'h1fb80c869d;
        sincos_rom[428] = 40'h1f608c8384; sincos_rom[429] = 40'h1f08cc8073; sincos_rom[430] = 40'h1eb0bc7d6c; sincos_rom[431] = 40'h1e585c7a6d;
        sincos_rom[432] = 40'h1dffbc7777; sincos_rom[433] = 40'h1da6bc7489; sincos_rom[434] = 40'h1d4d8c71a4; sincos_rom[435] = 40'h1cf3fc6ec8;
        sincos_rom[436] = 40'h1c9a3c6bf5; sincos_rom[437] = 40'h1c402c692a; sincos_rom[438] = 40'h1be5cc6669; sincos_rom[439] = 40'h1b8b2c63b0;
        sincos_rom[440] = 40'h1b304c6100; sincos_rom[441] = 40'h1ad52c5e59; sincos_rom[442] = 40'h1a79cc5bbc; sincos_rom[443] = 40'h1a1e1c5927;
        sincos_rom[444] = 40'h19c23c569b; sincos_rom[445] = 40'h19660c5418; sincos_rom[446] = 40'h1909ac519e; sincos_rom[447] = 40'h18ad0c4f2d;
        sincos_rom[448] = 40'h18502c4cc6; sincos_rom[449] = 40'h17f30c4a67; sincos_rom[450] = 40'h1795bc4812; sincos_rom[451] = 40'h17382c45c6;
        sincos_rom[452] = 40'h16da5c4383; sincos_rom[453] = 40'h167c5c4149; sincos_rom[454] = 40'h161e1c3f19; sincos_rom[455] = 40'h15bfac3cf1;
        sincos_rom[456] = 40'h1560fc3ad3; sincos_rom[457] = 40'h15022c38bf; sincos_rom[458] = 40'h14a31c36b3; sincos_rom[459] = 40'h1443dc34b1;
        sincos_rom[460] = 40'h13e45c32b9; sincos_rom[461] = 40'h1384bc30ca; sincos_rom[462] = 40'h1324ec2ee4; sincos_rom[463] = 40'h12c4dc2d07;
        sincos_rom[464] = 40'h1264ac2b34; sincos_rom[465] = 40'h12044c296b; sincos_rom[466] = 40'h11a3bc27ab; sincos_rom[467] = 40'h11430c25f4;
        sincos_rom[468] = 40'h10e22c2447; sincos_rom[469] = 40'h10811c22a3; sincos_rom[470] = 40'h101fdc2109; sincos_rom[471] = 40'h0fbe8c1f79;
        sincos_rom[472] = 40'h0f5cfc1df2; sincos_rom[473] = 40'h0efb5c1c75; sincos_rom[474] = 40'h0e998c1b01; sincos_rom[475] = 40'h0e378c1997;
        sincos_rom[476] = 40'h0dd57c1836; sincos_rom[477] = 40'h0d734c16e0; sincos_rom[478] = 40'h0d10ec1592; sincos_rom[479] = 40'h0cae6c144f;
        sincos_rom[480] = 40'h0c4bdc1315; sincos_rom[481] = 40'h0be91c11e5; sincos_rom[482] = 40'h0b864c10be; sincos_rom[483] = 40'h0b235c0fa1;
        sincos_rom[484] = 40'h0ac04c0e8e; sincos_rom[485] = 40'h0a5d2c0d85; sincos_rom[486] = 40'h09f9ec0c85; sincos_rom[487] = 40'h09968c0b90;
        sincos_rom[488] = 40'h09331c0aa4; sincos_rom[489] = 40'h08cf9c09c1; sincos_rom[490] = 40'h086bfc08e9; sincos_rom[491] = 40'h08084c081a;
        sincos_rom[492] = 40'h07a47c0755; sincos_rom[493] = 40'h0740ac069a; sincos_rom[494] = 40'h06dcbc05e8; sincos_rom[495] = 40'h0678bc0541;
        sincos_rom[496] = 40'h0614bc04a3; sincos_rom[497] = 40'h05b09c040f; sincos_rom[498] = 40'h054c6c0385; sincos_rom[499] = 40'h04e83c0305;
        sincos_rom[500] = 40'h0483fc028e; sincos_rom[501] = 40'h041fac0222; sincos_rom[502] = 40'h03bb5c01bf; sincos_rom[503] = 40'h0356fc0166;
        sincos_rom[504] = 40'h02f28c0117; sincos_rom[505] = 40'h028e1c00d2; sincos_rom[506] = 40'h0229ac0097; sincos_rom[507] = 40'h01c52c0065;
        sincos_rom[508] = 40'h0160ac003e; sincos_rom[509] = 40'h00fc2c0020; sincos_rom[510] = 40'h00979c000c; sincos_rom[511] = 40'h00331c0002;
        sincos_rom[512] = 40'hffce8c0002; sincos_rom[513] = 40'hff6a0c000c; sincos_rom[514] = 40'hff058c0020; sincos_rom[515] = 40'hfea0fc003d;
        sincos_rom[516] = 40'hfe3c7c0065; sincos_rom[517] = 40'hfdd80c0096; sincos_rom[518] = 40'hfd738c00d1; sincos_rom[519] = 40'hfd0f1c0116;
        sincos_rom[520] = 40'hfcaabc0165; sincos_rom[521] = 40'hfc465c01be; sincos_rom[522] = 40'hfbe1fc0220; sincos_rom[523] = 40'hfb7dac028d;
        sincos_rom[524] = 40'hfb196c0303; sincos_rom[525] = 40'hfab53c0383; sincos_rom[526] = 40'hfa510c040d; sincos_rom[527] = 40'hf9ecfc04a1;
        sincos_rom[528] = 40'hf988ec053e; sincos_rom[529] = 40'hf924ec05e6; sincos_rom[530] = 40'hf8c0fc0697; sincos_rom[531] = 40'hf85d2c0752;
        sincos_rom[532] = 40'hf7f95c0817; sincos_rom[533] = 40'hf795ac08e5; sincos_rom[534] = 40'hf7320c09be; sincos_rom[535] = 40'hf6ce8c0aa0;
        sincos_rom[536] = 40'hf66b1c0b8c; sincos_rom[537] = 40'hf607bc0c82; sincos_rom[538] = 40'hf5a47c0d81; sincos_rom[539] = 40'hf5415c0e8a;
        sincos_rom[540] = 40'hf4de4c0f9d; sincos_rom[541] = 40'hf47b5c10ba; sincos_rom[542] = 40'hf4187c11e0; sincos_rom[543] = 40'hf3b5cc1310;
        sincos_rom[544] = 40'hf3532c144a; sincos_rom[545] = 40'hf2f0bc158d; sincos_rom[546] = 40'hf28e5c16da; sincos_rom[547] = 40'hf22c1c1831;
        sincos_rom[548] = 40'hf1ca0c1991; sincos_rom[549] = 40'hf1681c1afb; sincos_rom[550] = 40'hf1064c1c6f; sincos_rom[551] = 40'hf0a49c1dec;
        sincos_rom[552] = 40'hf0431c1f73; sincos_rom[553] = 40'hefe1bc2103; sincos_rom[554] = 40'hef808c229d; sincos_rom[555] = 40'hef1f7c2440;
        sincos_rom[556] = 40'heebe8c25ed; sincos_rom[557] = 40'hee5ddc27a4; sincos_rom[558] = 40'hedfd4c2964; sincos_rom[559] = 40'hed9cec2b2d;
        sincos_rom[560] = 40'hed3cbc2d00; sincos_rom[561] = 40'hecdcac2edc; sincos_rom[562] = 40'hec7cdc30c2; sincos_rom[563] = 40'hec1d3c32b1;
        sincos_rom[564] = 40'hebbdbc34a9; sincos_rom[565] = 40'heb5e7c36ab; sincos_rom[566] = 40'heaff6c38b7; sincos_rom[567] = 40'heaa08c3acb;
        sincos_rom[568] = 40'hea41ec3ce9; sincos_rom[569] = 40'he9e37c3f10; sincos_rom[570] = 40'he9853c4140; sincos_rom[571] = 40'he9273c437a;
        sincos_rom[572] = 40'he8c96c45bd; sincos_rom[573] = 40'he86bdc4809; sincos_rom[574] = 40'he80e7c4a5e; sincos_rom[575] = 40'he7b15c4cbc;
        sincos_rom[576] = 40'he7547c4f24; sincos_rom[577] = 40'he6f7dc5194; sincos_rom[578] = 40'he69b7c540e; sincos_rom[579] = 40'he63f4c5691;
        sincos_rom[580] = 40'he5e36c591c; sincos_rom[581] = 40'he587bc5bb1; sincos_rom[582] = 40'he52c5c5e4f; sincos_rom[583] = 40'he4d12c60f6;
        sincos_rom[584] = 40'he4764c63a5; sincos_rom[585] = 40'he41bbc665e; sincos_rom[586] = 40'he3c15c691f; sincos_rom[587] = 40'he3674c6bea;
        sincos_rom[588] = 40'he30d7c6ebd; sincos_rom[589] = 40'he2b3fc7199; sincos_rom[590] = 40'he25abc747d; sincos_rom[591] = 40'he201cc776b;
        sincos_rom[592] = 40'he1a91c7a61; sincos_rom[593] = 40'he150bc7d60; sincos_rom[594] = 40'he0f8ac8067; sincos_rom[595] = 40'he0a0ec8377;
        sincos_rom[596] = 40'he0496c8690; sincos_rom[597] = 40'hdff23c89b2; sincos_rom[598] = 40'hdf9b6c8cdb; sincos_rom[599] = 40'hdf44dc900e;
        sincos_rom[600] = 40'hdeee9c9349; sincos_rom[601] = 40'hde98bc968c; sincos_rom[602] = 40'hde431c99d8; sincos_rom[603] = 40'hddeddc9d2c;
        sincos_rom[604] = 40'hdd98eca088; sincos_rom[605] = 40'hdd444ca3ed; sincos_rom[606] = 40'hdcf00ca75a; sincos_rom[607] = 40'hdc9c1caacf;
        sincos_rom[608] = 40'hdc488cae4d; sincos_rom[609] = 40'hdbf54cb1d3; sincos_rom[610] = 40'hdba25cb561; sincos_rom[611] = 40'hdb4fdcb8f7;
        sincos_rom[612] = 40'hdafd9cbc95; sincos_rom[613] = 40'hdaabccc03b; sincos_rom[614] = 40'hda5a4cc3e9; sincos_rom[615] = 40'hda093cc79f;
        sincos_rom[616] = 40'hd9b87ccb5d; sincos_rom[617] = 40'hd9680ccf24; sincos_rom[618] = 40'hd9180cd2f1; sincos_rom[619] = 40'hd8c86cd6c7;
        sincos_rom[620] = 40'hd8792cdaa5; sincos_rom[621] = 40'hd82a4cde8a; sincos_rom[622] = 40'hd7dbcce277; sincos_rom[623] = 40'hd78dbce66c;
        sincos_rom[624] = 40'hd73ffcea68; sincos_rom[625] = 40'hd6f2acee6c; sincos_rom[626] = 40'hd6a5bcf278; sincos_rom[627] = 40'hd6593cf68b;
        sincos_rom[628] = 40'hd60d1cfaa5; sincos_rom[629] = 40'hd5c15cfec7; sincos_rom[630] = 40'hd5760d02f1; sincos_rom[631] = 40'hd52b2d0721;
        sincos_rom[632] = 40'hd4e0ad0b5a; sincos_rom[633] = 40'hd4969d0f99; sincos_rom[634] = 40'hd44ced13e0; sincos_rom[635] = 40'hd403ad182e;
        sincos_rom[636] = 40'hd3badd1c83; sincos_rom[637] = 40'hd3727d20df; sincos_rom[638] = 40'hd32a8d2542; sincos_rom[639] = 40'hd2e30d29ac;
        sincos_rom[640] = 40'hd29bed2e1e; sincos_rom[641] = 40'hd2554d3296; sincos_rom[642] = 40'hd20f0d3715; sincos_rom[643] = 40'hd1c94d3b9b;
        sincos_rom[644] = 40'hd183fd4028; sincos_rom[645] = 40'hd13f1d44bc; sincos_rom[646] = 40'hd0faad4956; sincos_rom[647] = 40'hd0b6ad4df7;
        sincos_rom[648] = 40'hd0732d529f; sincos_rom[649] = 40'hd0301d574d; sincos_rom[650] = 40'hcfed8d5c02; sincos_rom[651] = 40'hcfab6d60be;
        sincos_rom[652] = 40'hcf69bd6580; sincos_rom[653] = 40'hcf288d6a48; sincos_rom[654] = 40'hcee7cd6f17; sincos_rom[655] = 40'hcea78d73ec;
        sincos_rom[656] = 40'hce67cd78c7; sincos_rom[657] = 40'hce287d7da9; sincos_rom[658] = 40'hcde9ad8290; sincos_rom[659] = 40'hcdab4d877e;
        sincos_rom[660] = 40'hcd6d7d8c72; sincos_rom[661] = 40'hcd301d916c; sincos_rom[662] = 40'hccf33d966c; sincos_rom[663] = 40'hccb6dd9b72;
        sincos_rom[664] = 40'hcc7aeda07e; sincos_rom[665] = 40'hcc3f8da590; sincos_rom[666] = 40'hcc04adaaa8; sincos_rom[667] = 40'hcbca3dafc5;
        sincos_rom[668] = 40'hcb905db4e8; sincos_rom[669] = 40'hcb56fdba11; sincos_rom[670] = 40'hcb1e1dbf3f; sincos_rom[671] = 40'hcae5bdc473;
        sincos_rom[672] = 40'hcaadddc9ac; sincos_rom[673] = 40'hca768dceeb; sincos_rom[674] = 40'hca3fbdd42f; sincos_rom[675] = 40'hca096dd979;
        sincos_rom[676] = 40'hc9d39ddec8; sincos_rom[677] = 40'hc99e5de41c; sincos_rom[678] = 40'hc9699de975; sincos_rom[679] = 40'hc9356deed4;
        sincos_rom[680] = 40'hc901bdf437; sincos_rom[681] = 40'hc8ce8df9a0; sincos_rom[682] = 40'hc89bedff0e; sincos_rom[683] = 40'hc869de0480;
        sincos_rom[684] = 40'hc8384e09f8; sincos_rom[685] = 40'hc8073e0f74; sincos_rom[686] = 40'hc7d6ce14f5; sincos_rom[687] = 40'hc7a6de1a7b;
        sincos_rom[688] = 40'hc7777e2005; sincos_rom[689] = 40'hc7489e2595; sincos_rom[690] = 40'hc71a4e2b28; sincos_rom[691] = 40'hc6ec8e30c1;
        sincos_rom[692] = 40'hc6bf5e365d; sincos_rom[693] = 40'hc692ae3bfe; sincos_rom[694] = 40'hc6669e41a4; sincos_rom[695] = 40'hc63b0e474e;
        sincos_rom[696] = 40'hc6100e4cfc; sincos_rom[697] = 40'hc5e59e52ae; sincos_rom[698] = 40'hc5bbce5864; sincos_rom[699] = 40'hc5927e5e1f;
        sincos_rom[700] = 40'hc569be63dd; sincos_rom[701] = 40'hc5418e69a0; sincos_rom[702] = 40'hc519ee6f66; sincos_rom[703] = 40'hc4f2de7530;
        sincos_rom[704] = 40'hc4cc6e7afe; sincos_rom[705] = 40'hc4a67e80d0; sincos_rom[706] = 40'hc4812e86a5; sincos_rom[707] = 40'hc45c6e8c7e;
        sincos_rom[708] = 40'hc4383e925b; sincos_rom[709] = 40'hc4149e983b; sincos_rom[710] = 40'hc3f19e9e1f; sincos_rom[711] = 40'hc3cf1ea406;
        sincos_rom[712] = 40'hc3ad3ea9f1; sincos_rom[713] = 40'hc38bfeafde; sincos_rom[714] = 40'hc36b3eb5cf; sincos_rom[715] = 40'hc34b1ebbc3;
        sincos_rom[716] = 40'hc32b9ec1bb; sincos_rom[717] = 40'hc30caec7b5; sincos_rom[718] = 40'hc2ee4ecdb2; sincos_rom[719] = 40'hc2d07ed3b3;
        sincos_rom[720] = 40'hc2b34ed9b6; sincos_rom[721] = 40'hc296bedfbc; sincos_rom[722] = 40'hc27abee5c5; sincos_rom[723] = 40'hc25f4eebd0;
        sincos_rom[724] = 40'hc2447ef1de; sincos_rom[725] = 40'hc22a3ef7ef; sincos_rom[726] = 40'hc2109efe03; sincos_rom[727] = 40'hc1f79f0418;
        sincos_rom[728] = 40'hc1df2f0a31; sincos_rom[729] = 40'hc1c75f104b; sincos_rom[730] = 40'hc1b01f1668; sincos_rom[731] = 40'hc1997f1c88;
        sincos_rom[732] = 40'hc1836f22a9; sincos_rom[733] = 40'hc16e0f28cc; sincos_rom[734] = 40'hc1592f2ef2; sincos_rom[735] = 40'hc144ff351a;
        sincos_rom[736] = 40'hc1315f3b43; sincos_rom[737] = 40'hc11e5f416f; sincos_rom[738] = 40'hc10bef479c; sincos_rom[739] = 40'hc0fa1f4dcb;
        sincos_rom[740] = 40'hc0e8ef53fc; sincos_rom[741] = 40'hc0d85f5a2e; sincos_rom[742] = 40'hc0c85f6062; sincos_rom[743] = 40'hc0b90f6698;
        sincos_rom[744] = 40'hc0aa4f6ccf; sincos_rom[745] = 40'hc09c1f7307; sincos_rom[746] = 40'hc08e9f7941; sincos_rom[747] = 40'hc081af7f7c;
        sincos_rom[748] = 40'hc0755f85b9; sincos_rom[749] = 40'hc069af8bf6; sincos_rom[750] = 40'hc05e8f9235; sincos_rom[751] = 40'hc0541f9875;
        sincos_rom[752] = 40'hc04a3f9eb5; sincos_rom[753] = 40'hc040ffa4f7; sincos_rom[754] = 40'hc0385fab3a; sincos_rom[755] = 40'hc0305fb17d;
        sincos_rom[756] = 40'hc028efb7c1; sincos_rom[757] = 40'hc0222fbe06; sincos_rom[758] = 40'hc01bffc44b; sincos_rom[759] = 40'hc0166fca91;
        sincos_rom[760] = 40'hc0117fd0d8; sincos_rom[761] = 40'hc00d2fd71f; sincos_rom[762] = 40'hc0097fdd66; sincos_rom[763] = 40'hc0065fe3ae;
        sincos_rom[764] = 40'hc003efe9f6; sincos_rom[765] = 40'hc0020ff03e; sincos_rom[766] = 40'hc000cff687; sincos_rom[767] = 40'hc0002ffccf;
        sincos_rom[768] = 40'hc000200318; sincos_rom[769] = 40'hc000c00960; sincos_rom[770] = 40'hc002000fa8; sincos_rom[771] = 40'hc003d015f1;
        sincos_rom[772] = 40'hc006501c39; sincos_rom[773] = 40'hc009602280; sincos_rom[774] = 40'hc00d1028c8; sincos_rom[775] = 40'hc011602f0f;
        sincos_rom[776] = 40'hc016503555; sincos_rom[777] = 40'hc01be03b9b; sincos_rom[778] = 40'hc0220041e1; sincos_rom[779] = 40'hc028d04826;
        sincos_rom[780] = 40'hc030304e6a; sincos_rom[781] = 40'hc0383054ad; sincos_rom[782] = 40'hc040d05af0; sincos_rom[783] = 40'hc04a106131;
        sincos_rom[784] = 40'hc053e06772; sincos_rom[785] = 40'hc05e606db2; sincos_rom[786] = 40'hc0697073f1; sincos_rom[787] = 40'hc075207a2e;
        sincos_rom[788] = 40'hc08170806b; sincos_rom[789] = 40'hc08e5086a6; sincos_rom[790] = 40'hc09be08ce0; sincos_rom[791] = 40'hc0aa009318;
        sincos_rom[792] = 40'hc0b8c0994f; sincos_rom[793] = 40'hc0c8209f85; sincos_rom[794] = 40'hc0d810a5b9; sincos_rom[795] = 40'hc0e8a0abeb;
        sincos_rom[796] = 40'hc0f9d0b21c; sincos_rom[797] = 40'hc10ba0b84b; sincos_rom[798] = 40'hc11e00be79; sincos_rom[799] = 40'hc13100c4a4;
        sincos_rom[800] = 40'hc144a0cace; sincos_rom[801] = 40'hc158d0d0f5; sincos_rom[802] = 40'hc16da0d71b; sincos_rom[803] = 40'hc18310dd3f;
        sincos_rom[804] = 40'hc19910e360; sincos_rom[805] = 40'hc1afb0e97f; sincos_rom[806] = 40'hc1c6f0ef9c; sincos_rom[807] = 40'hc1dec0f5b7;
        sincos_rom[808] = 40'hc1f730fbcf; sincos_rom[809] = 40'hc2103101e5; sincos_rom[810] = 40'hc229d107f8; sincos_rom[811] = 40'hc244010e09;
        sincos_rom[812] = 40'hc25ed11418; sincos_rom[813] = 40'hc27a411a23; sincos_rom[814] = 40'hc29641202c; sincos_rom[815] = 40'hc2b2d12632;
        sincos_rom[816] = 40'hc2d0012c35; sincos_rom[817] = 40'hc2edc13236; sincos_rom[818] = 40'hc30c213833; sincos_rom[819] = 40'hc32b113e2d;
        sincos_rom[820] = 40'hc34a914425; sincos_rom[821] = 40'hc36ab14a19; sincos_rom[822] = 40'hc38b71500a; sincos_rom[823] = 40'hc3acb155f8;
        sincos_rom[824] = 40'hc3ce915be2; sincos_rom[825] = 40'hc3f10161c9; sincos_rom[826] = 40'hc4140167ad; sincos_rom[827] = 40'hc437a16d8d;
        sincos_rom[828] = 40'hc45bd1736a; sincos_rom[829] = 40'hc480917943; sincos_rom[830] = 40'hc4a5e17f19; sincos_rom[831] = 40'hc4cbc184eb;
        sincos_rom[832] = 40'hc4f2418ab9; sincos_rom[833] = 40'hc519419083; sincos_rom[834] = 40'hc540e19649; sincos_rom[835] = 40'hc569119c0c;
        sincos_rom[836] = 40'hc591c1a1ca; sincos_rom[837] = 40'hc5bb11a785; sincos_rom[838] = 40'hc5e4f1ad3b; sincos_rom[839] = 40'hc60f61b2ee;
        sincos_rom[840] = 40'hc63a51b89c; sincos_rom[841] = 40'hc665e1be45; sincos_rom[842] = 40'hc691f1c3eb; sincos_rom[843] = 40'hc6bea1c98c;
        sincos_rom[844] = 40'hc6ebd1cf29; sincos_rom[845] = 40'hc71991d4c1; sincos_rom[846] = 40'hc747d1da55; sincos_rom[847] = 40'hc776b1dfe4;
        sincos_rom[848] = 40'hc7a611e56f; sincos_rom[849] = 40'hc7d601eaf5; sincos_rom[850] = 40'hc80671f076; sincos_rom[851] = 40'hc83771f5f2;
        sincos_rom[852] = 40'hc86901fb6a; sincos_rom[853] = 40'hc89b2200dd; sincos_rom[854] = 40'hc8cdb2064a; sincos_rom[855] = 40'hc900e20bb3;
        sincos_rom[856] = 40'hc934921117; sincos_rom[857] = 40'hc968c21675; sincos_rom[858] = 40'hc99d821bcf; sincos_rom[859] = 40'hc9d2c22123;
        sincos_rom[860] = 40'hca08822672; sincos_rom[861] = 40'hca3ed22bbc; sincos_rom[862] = 40'hca75a23100; sincos_rom[863] = 40'hcaacf2363f;
        sincos_rom[864] = 40'hcae4d23b78; sincos_rom[865] = 40'hcb1d3240ac; sincos_rom[866] = 40'hcb561245db; sincos_rom[867] = 40'hcb8f724b03;
        sincos_rom[868] = 40'hcbc9525027; sincos_rom[869] = 40'hcc03b25544; sincos_rom[870] = 40'hcc3e925a5c; sincos_rom[871] = 40'hcc79f25f6d;
        sincos_rom[872] = 40'hccb5d26479; sincos_rom[873] = 40'hccf2426980; sincos_rom[874] = 40'hcd2f126e80; sincos_rom[875] = 40'hcd6c72737a;
        sincos_rom[876] = 40'hcdaa52786e; sincos_rom[877] = 40'hcde8a27d5c; sincos_rom[878] = 40'hce27728244; sincos_rom[879] = 40'hce66c28725;
        sincos_rom[880] = 40'hcea6828c01; sincos_rom[881] = 40'hcee6c290d6; sincos_rom[882] = 40'hcf278295a5; sincos_rom[883] = 40'hcf68b29a6d;
        sincos_rom[884] = 40'hcfaa529f2f; sincos_rom[885] = 40'hcfec72a3eb; sincos_rom[886] = 40'hd02f12a8a0; sincos_rom[887] = 40'hd07212ad4e;
        sincos_rom[888] = 40'hd0b5a2b1f6; sincos_rom[889] = 40'hd0f992b697; sincos_rom[890] = 40'hd13e02bb32; sincos_rom[891] = 40'hd182e2bfc6;
        sincos_rom[892] = 40'hd1c832c453; sincos_rom[893] = 40'hd20df2c8d9; sincos_rom[894] = 40'hd25422cd58; sincos_rom[895] = 40'hd29ac2d1d0;
        sincos_rom[896] = 40'hd2e1e2d642; sincos_rom[897] = 40'hd32962daac; sincos_rom[898] = 40'hd37152df10; sincos_rom[899] = 40'hd3b9b2e36c;
        sincos_rom[900] = 40'hd40282e7c1; sincos_rom[901] = 40'hd44bc2ec0f; sincos_rom[902] = 40'hd49562f056; sincos_rom[903] = 40'hd4df72f496;
        sincos_rom[904] = 40'hd529f2f8ce; sincos_rom[905] = 40'hd574d2fcff; sincos_rom[906] = 40'hd5c0230128; sincos_rom[907] = 40'hd60be3054a;
        sincos_rom[908] = 40'hd658030965; sincos_rom[909] = 40'hd6a4830d78; sincos_rom[910] = 40'hd6f1731184; sincos_rom[911] = 40'hd73ec31588;
        sincos_rom[912] = 40'hd78c731984; sincos_rom[913] = 40'hd7da931d79; sincos_rom[914] = 40'hd829032166; sincos_rom[915] = 40'hd877e3254c;
        sincos_rom[916] = 40'hd8c7232929; sincos_rom[917] = 40'hd916c32cff; sincos_rom[918] = 40'hd966c330cd; sincos_rom[919] = 40'hd9b7233493;
        sincos_rom[920] = 40'hda07e33852; sincos_rom[921] = 40'hda59033c08; sincos_rom[922] = 40'hdaaa833fb6; sincos_rom[923] = 40'hdafc53435d;
        sincos_rom[924] = 40'hdb4e8346fb; sincos_rom[925] = 40'hdba1134a91; sincos_rom[926] = 40'hdbf3f34e1f; sincos_rom[927] = 40'hdc473351a5;
        sincos_rom[928] = 40'hdc9ac35523; sincos_rom[929] = 40'hdceeb35898; sincos_rom[930] = 40'hdd42f35c05; sincos_rom[931] = 40'hdd97935f6a;
        sincos_rom[932] = 40'hddec8362c7; sincos_rom[933] = 40'hde41c3661b; sincos_rom[934] = 40'hde97536967; sincos_rom[935] = 40'hdeed436caa;
        sincos_rom[936] = 40'hdf43736fe5; sincos_rom[937] = 40'hdf9a037318; sincos_rom[938] = 40'hdff0e37642; sincos_rom[939] = 40'he048037963;
        sincos_rom[940] = 40'he09f837c7c; sincos_rom[941] = 40'he0f7437f8d; sincos_rom[942] = 40'he14f538294; sincos_rom[943] = 40'he1a7b38593;
        sincos_rom[944] = 40'he200538889; sincos_rom[945] = 40'he259538b77; sincos_rom[946] = 40'he2b2838e5c; sincos_rom[947] = 40'he30c139138;
        sincos_rom[948] = 40'he365d3940b; sincos_rom[949] = 40'he3bfe396d6; sincos_rom[950] = 40'he41a439997; sincos_rom[951] = 40'he474e39c50;
        sincos_rom[952] = 40'he4cfc39f00; sincos_rom[953] = 40'he52ae3a1a7; sincos_rom[954] = 40'he58643a444; sincos_rom[955] = 40'he5e1f3a6d9;
        sincos_rom[956] = 40'he63dd3a965; sincos_rom[957] = 40'he69a03abe8; sincos_rom[958] = 40'he6f663ae62; sincos_rom[959] = 40'he75303b0d3;
        sincos_rom[960] = 40'he7afe3b33a; sincos_rom[961] = 40'he80d03b599; sincos_rom[962] = 40'he86a53b7ee; sincos_rom[963] = 40'he8c7e3ba3a;
        sincos_rom[964] = 40'he925b3bc7d; sincos_rom[965] = 40'he983b3beb7; sincos_rom[966] = 40'he9e1f3c0e7; sincos_rom[967] = 40'hea4063c30f;
        sincos_rom[968] = 40'hea9f13c52d; sincos_rom[969] = 40'heafde3c741; sincos_rom[970] = 40'heb5cf3c94d; sincos_rom[971] = 40'hebbc33cb4f;
        sincos_rom[972] = 40'hec1bb3cd47; sincos_rom[973] = 40'hec7b53cf36; sincos_rom[974] = 40'hecdb23d11c; sincos_rom[975] = 40'hed3b33d2f9;
        sincos_rom[976] = 40'hed9b63d4cc; sincos_rom[977] = 40'hedfbc3d695; sincos_rom[978] = 40'hee5c53d855; sincos_rom[979] = 40'heebd03da0c;
        sincos_rom[980] = 40'hef1de3dbb9; sincos_rom[981] = 40'hef7ef3dd5d; sincos_rom[982] = 40'hefe033def7; sincos_rom[983] = 40'hf04183e087;
        sincos_rom[984] = 40'hf0a313e20e; sincos_rom[985] = 40'hf104b3e38b; sincos_rom[986] = 40'hf16683e4ff; sincos_rom[987] = 40'hf1c883e669;
        sincos_rom[988] = 40'hf22a93e7ca; sincos_rom[989] = 40'hf28cc3e920; sincos_rom[990] = 40'hf2ef23ea6e; sincos_rom[991] = 40'hf351a3ebb1;
        sincos_rom[992] = 40'hf3b433eceb; sincos_rom[993] = 40'hf416f3ee1b; sincos_rom[994] = 40'hf479c3ef42; sincos_rom[995] = 40'hf4dcb3f05f;
        sincos_rom[996] = 40'hf53fc3f172; sincos_rom[997] = 40'hf5a2e3f27b; sincos_rom[998] = 40'hf60623f37b; sincos_rom[999] = 40'hf66983f470;
        sincos_rom[1000] = 40'hf6ccf3f55c; sincos_rom[1001] = 40'hf73073f63f; sincos_rom[1002] = 40'hf79413f717; sincos_rom[1003] = 40'hf7f7c3f7e6;
        sincos_rom[1004] = 40'hf85b93f8ab; sincos_rom[1005] = 40'hf8bf63f966; sincos_rom[1006] = 40'hf92353fa18; sincos_rom[1007] = 40'hf98753fabf;
        sincos_rom[1008] = 40'hf9eb53fb5d; sincos_rom[1009] = 40'hfa4f73fbf1; sincos_rom[1010] = 40'hfab3a3fc7b; sincos_rom[1011] = 40'hfb17d3fcfb;
        sincos_rom[1012] = 40'hfb7c13fd72; sincos_rom[1013] = 40'hfbe063fdde; sincos_rom[1014] = 40'hfc44b3fe41; sincos_rom[1015] = 40'hfca913fe9a;
        sincos_rom[1016] = 40'hfd0d83fee9; sincos_rom[1017] = 40'hfd71f3ff2e; sincos_rom[1018] = 40'hfdd663ff69; sincos_rom[1019] = 40'hfe3ae3ff9b;
        sincos_rom[1020] = 40'hfe9f63ffc2; sincos_rom[1021] = 40'hff03e3ffe0; sincos_rom[1022] = 40'hff6873fff4; sincos_rom[1023] = 40'hffccf3fffe;
    end

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_2 [0:1023];
    initial begin
        sincos_rom_2[0] = 40'h003183fffe; sincos_rom_2[1] = 40'h009603fff4; sincos_rom_2[2] = 40'h00fa83ffe0; sincos_rom_2[3] = 40'h015f13ffc3;
        sincos_rom_2[4] = 40'h01c393ff9b; sincos_rom_2[5] = 40'h022803ff6a; sincos_rom_2[6] = 40'h028c83ff2f; sincos_rom_2[7] = 40'h02f0f3feea;
        sincos_rom_2[8] = 40'h035553fe9b; sincos_rom_2[9] = 40'h03b9b3fe42; sincos_rom_2[10] = 40'h041e13fde0; sincos_rom_2[11] = 40'h048263fd73;
        sincos_rom_2[12] = 40'h04e6a3fcfd; sincos_rom_2[13] = 40'h054ad3fc7d; sincos_rom_2[14] = 40'h05af03fbf3; sincos_rom_2[15] = 40'h061313fb5f;
        sincos_rom_2[16] = 40'h067723fac2; sincos_rom_2[17] = 40'h06db23fa1a; sincos_rom_2[18] = 40'h073f13f969; sincos_rom_2[19] = 40'h07a2e3f8ae;
        sincos_rom_2[20] = 40'h0806b3f7e9; sincos_rom_2[21] = 40'h086a63f71b; sincos_rom_2[22] = 40'h08ce03f642; sincos_rom_2[23] = 40'h093183f560;
        sincos_rom_2[24] = 40'h0994f3f474; sincos_rom_2[25] = 40'h09f853f37e; sincos_rom_2[26] = 40'h0a5b93f27f; sincos_rom_2[27] = 40'h0abeb3f176;
        sincos_rom_2[28] = 40'h0b21c3f063; sincos_rom_2[29] = 40'h0b84b3ef46; sincos_rom_2[30] = 40'h0be793ee20; sincos_rom_2[31] = 40'h0c4a43ecf0;
        sincos_rom_2[32] = 40'h0cace3ebb6; sincos_rom_2[33] = 40'h0d0f53ea73; sincos_rom_2[34] = 40'h0d71b3e926; sincos_rom_2[35] = 40'h0dd3f3e7cf;
        sincos_rom_2[36] = 40'h0e3603e66f; sincos_rom_2[37] = 40'h0e97f3e505; sincos_rom_2[38] = 40'h0ef9c3e391; sincos_rom_2[39] = 40'h0f5b73e214;
        sincos_rom_2[40] = 40'h0fbcf3e08d; sincos_rom_2[41] = 40'h101e53defd; sincos_rom_2[42] = 40'h107f83dd63; sincos_rom_2[43] = 40'h10e093dbc0;
        sincos_rom_2[44] = 40'h114183da13; sincos_rom_2[45] = 40'h11a233d85c; sincos_rom_2[46] = 40'h1202c3d69c; sincos_rom_2[47] = 40'h126323d4d3;
        sincos_rom_2[48] = 40'h12c353d300; sincos_rom_2[49] = 40'h132363d124; sincos_rom_2[50] = 40'h138333cf3e; sincos_rom_2[51] = 40'h13e2d3cd4f;
        sincos_rom_2[52] = 40'h144253cb57; sincos_rom_2[53] = 40'h14a193c955; sincos_rom_2[54] = 40'h1500a3c749; sincos_rom_2[55] = 40'h155f83c535;
        sincos_rom_2[56] = 40'h15be23c317; sincos_rom_2[57] = 40'h161c93c0f0; sincos_rom_2[58] = 40'h167ad3bec0; sincos_rom_2[59] = 40'h16d8d3bc86;
        sincos_rom_2[60] = 40'h1736a3ba43; sincos_rom_2[61] = 40'h179433b7f7; sincos_rom_2[62] = 40'h17f193b5a2; sincos_rom_2[63] = 40'h184eb3b344;
        sincos_rom_2[64] = 40'h18ab93b0dc; sincos_rom_2[65] = 40'h190833ae6c; sincos_rom_2[66] = 40'h196493abf2; sincos_rom_2[67] = 40'h19c0c3a96f;
        sincos_rom_2[68] = 40'h1a1ca3a6e4; sincos_rom_2[69] = 40'h1a7853a44f; sincos_rom_2[70] = 40'h1ad3b3a1b1; sincos_rom_2[71] = 40'h1b2ee39f0a;
        sincos_rom_2[72] = 40'h1b89c39c5b; sincos_rom_2[73] = 40'h1be45399a2; sincos_rom_2[74] = 40'h1c3eb396e1; sincos_rom_2[75] = 40'h1c98c39416;
        sincos_rom_2[76] = 40'h1cf2939143; sincos_rom_2[77] = 40'h1d4c138e67; sincos_rom_2[78] = 40'h1da5538b83; sincos_rom_2[79] = 40'h1dfe438895;
        sincos_rom_2[80] = 40'h1e56f3859f; sincos_rom_2[81] = 40'h1eaf5382a0; sincos_rom_2[82] = 40'h1f07637f99; sincos_rom_2[83] = 40'h1f5f237c89;
        sincos_rom_2[84] = 40'h1fb6a37970; sincos_rom_2[85] = 40'h200dd3764e; sincos_rom_2[86] = 40'h2064a37325; sincos_rom_2[87] = 40'h20bb336ff2;
        sincos_rom_2[88] = 40'h2111736cb7; sincos_rom_2[89] = 40'h2167536974; sincos_rom_2[90] = 40'h21bcf36628; sincos_rom_2[91] = 40'h22123362d4;
        sincos_rom_2[92] = 40'h2267235f78; sincos_rom_2[93] = 40'h22bbc35c13; sincos_rom_2[94] = 40'h23100358a6; sincos_rom_2[95] = 40'h2363f35531;
        sincos_rom_2[96] = 40'h23b78351b3; sincos_rom_2[97] = 40'h240ac34e2d; sincos_rom_2[98] = 40'h245db34a9f; sincos_rom_2[99] = 40'h24b0334709;
        sincos_rom_2[100] = 40'h250273436b; sincos_rom_2[101] = 40'h2554433fc5; sincos_rom_2[102] = 40'h25a5c33c17; sincos_rom_2[103] = 40'h25f6d33861;
        sincos_rom_2[104] = 40'h26479334a3; sincos_rom_2[105] = 40'h26980330dc; sincos_rom_2[106] = 40'h26e8032d0f; sincos_rom_2[107] = 40'h2737a32939;
        sincos_rom_2[108] = 40'h2786e3255b; sincos_rom_2[109] = 40'h27d5c32176; sincos_rom_2[110] = 40'h2824431d89; sincos_rom_2[111] = 40'h2872531994;
        sincos_rom_2[112] = 40'h28c0131598; sincos_rom_2[113] = 40'h290d631194; sincos_rom_2[114] = 40'h295a530d88; sincos_rom_2[115] = 40'h29a6d30975;
        sincos_rom_2[116] = 40'h29f2f3055b; sincos_rom_2[117] = 40'h2a3eb30139; sincos_rom_2[118] = 40'h2a8a02fd0f; sincos_rom_2[119] = 40'h2ad4e2f8df;
        sincos_rom_2[120] = 40'h2b1f62f4a6; sincos_rom_2[121] = 40'h2b6972f067; sincos_rom_2[122] = 40'h2bb322ec20; sincos_rom_2[123] = 40'h2bfc62e7d2;
        sincos_rom_2[124] = 40'h2c4532e37d; sincos_rom_2[125] = 40'h2c8d92df21; sincos_rom_2[126] = 40'h2cd582dabe; sincos_rom_2[127] = 40'h2d1d02d654;
        sincos_rom_2[128] = 40'h2d6422d1e2; sincos_rom_2[129] = 40'h2daac2cd6a; sincos_rom_2[130] = 40'h2df102c8eb; sincos_rom_2[131] = 40'h2e36c2c465;
        sincos_rom_2[132] = 40'h2e7c12bfd8; sincos_rom_2[133] = 40'h2ec0f2bb44; sincos_rom_2[134] = 40'h2f0562b6aa; sincos_rom_2[135] = 40'h2f4962b209;
        sincos_rom_2[136] = 40'h2f8ce2ad61; sincos_rom_2[137] = 40'h2fcff2a8b3; sincos_rom_2[138] = 40'h301282a3fe; sincos_rom_2[139] = 40'h3054a29f42;
        sincos_rom_2[140] = 40'h3096529a80; sincos_rom_2[141] = 40'h30d78295b8; sincos_rom_2[142] = 40'h31184290e9; sincos_rom_2[143] = 40'h3158828c14;
        sincos_rom_2[144] = 40'h3198428739; sincos_rom_2[145] = 40'h31d7928257; sincos_rom_2[146] = 40'h3216627d70; sincos_rom_2[147] = 40'h3254c27882;
        sincos_rom_2[148] = 40'h329292738e; sincos_rom_2[149] = 40'h32cff26e94; sincos_rom_2[150] = 40'h330cd26994; sincos_rom_2[151] = 40'h334932648e;
        sincos_rom_2[152] = 40'h3385225f82; sincos_rom_2[153] = 40'h33c0825a70; sincos_rom_2[154] = 40'h33fb625558; sincos_rom_2[155] = 40'h3435d2503b;
        sincos_rom_2[156] = 40'h346fb24b18; sincos_rom_2[157] = 40'h34a91245ef; sincos_rom_2[158] = 40'h34e1f240c1; sincos_rom_2[159] = 40'h351a523b8d;
        sincos_rom_2[160] = 40'h3552323654; sincos_rom_2[161] = 40'h3589823115; sincos_rom_2[162] = 40'h35c0522bd1; sincos_rom_2[163] = 40'h35f6a22687;
        sincos_rom_2[164] = 40'h362c722138; sincos_rom_2[165] = 40'h3661b21be4; sincos_rom_2[166] = 40'h369672168b; sincos_rom_2[167] = 40'h36caa2112c;
        sincos_rom_2[168] = 40'h36fe520bc9; sincos_rom_2[169] = 40'h3731820660; sincos_rom_2[170] = 40'h37642200f2; sincos_rom_2[171] = 40'h379631fb80;
        sincos_rom_2[172] = 40'h37c7c1f608; sincos_rom_2[173] = 40'h37f8d1f08c; sincos_rom_2[174] = 40'h382941eb0b; sincos_rom_2[175] = 40'h385931e585;
        sincos_rom_2[176] = 40'h388891dffb; sincos_rom_2[177] = 40'h38b771da6b; sincos_rom_2[178] = 40'h38e5c1d4d8; sincos_rom_2[179] = 40'h391381cf3f;
        sincos_rom_2[180] = 40'h3940b1c9a3; sincos_rom_2[181] = 40'h396d61c402; sincos_rom_2[182] = 40'h399971be5c; sincos_rom_2[183] = 40'h39c501b8b2;
        sincos_rom_2[184] = 40'h39f001b304; sincos_rom_2[185] = 40'h3a1a71ad52; sincos_rom_2[186] = 40'h3a4441a79c; sincos_rom_2[187] = 40'h3a6d91a1e1;
        sincos_rom_2[188] = 40'h3a96519c23; sincos_rom_2[189] = 40'h3abe819660; sincos_rom_2[190] = 40'h3ae621909a; sincos_rom_2[191] = 40'h3b0d318ad0;
        sincos_rom_2[192] = 40'h3b33a18502; sincos_rom_2[193] = 40'h3b59917f30; sincos_rom_2[194] = 40'h3b7ee1795b; sincos_rom_2[195] = 40'h3ba3a17382;
        sincos_rom_2[196] = 40'h3bc7d16da5; sincos_rom_2[197] = 40'h3beb7167c5; sincos_rom_2[198] = 40'h3c0e7161e1; sincos_rom_2[199] = 40'h3c30f15bfa;
        sincos_rom_2[200] = 40'h3c52d1560f; sincos_rom_2[201] = 40'h3c74115022; sincos_rom_2[202] = 40'h3c94d14a31; sincos_rom_2[203] = 40'h3cb4f1443d;
        sincos_rom_2[204] = 40'h3cd4713e45; sincos_rom_2[205] = 40'h3cf361384b; sincos_rom_2[206] = 40'h3d11c1324e; sincos_rom_2[207] = 40'h3d2f912c4d;
        sincos_rom_2[208] = 40'h3d4cc1264a; sincos_rom_2[209] = 40'h3d69512044; sincos_rom_2[210] = 40'h3d85511a3b; sincos_rom_2[211] = 40'h3da0c11430;
        sincos_rom_2[212] = 40'h3dbb910e22; sincos_rom_2[213] = 40'h3dd5d10811; sincos_rom_2[214] = 40'h3def7101fd; sincos_rom_2[215] = 40'h3e0870fbe8;
        sincos_rom_2[216] = 40'h3e20e0f5cf; sincos_rom_2[217] = 40'h3e38b0efb5; sincos_rom_2[218] = 40'h3e4ff0e998; sincos_rom_2[219] = 40'h3e6690e378;
        sincos_rom_2[220] = 40'h3e7ca0dd57; sincos_rom_2[221] = 40'h3e9200d734; sincos_rom_2[222] = 40'h3ea6e0d10e; sincos_rom_2[223] = 40'h3ebb10cae6;
        sincos_rom_2[224] = 40'h3eceb0c4bd; sincos_rom_2[225] = 40'h3ee1b0be91; sincos_rom_2[226] = 40'h3ef420b864; sincos_rom_2[227] = 40'h3f05f0b235;
        sincos_rom_2[228] = 40'h3f1720ac04; sincos_rom_2[229] = 40'h3f27b0a5d2; sincos_rom_2[230] = 40'h3f37b09f9e; sincos_rom_2[231] = 40'h3f47009968;
        sincos_rom_2[232] = 40'h3f55c09331; sincos_rom_2[233] = 40'h3f63f08cf9; sincos_rom_2[234] = 40'h3f717086bf; sincos_rom_2[235] = 40'h3f7e608084;
        sincos_rom_2[236] = 40'h3f8ab07a47; sincos_rom_2[237] = 40'h3f9660740a; sincos_rom_2[238] = 40'h3fa1806dcb; sincos_rom_2[239] = 40'h3fabf0678b;
        sincos_rom_2[240] = 40'h3fb5d0614b; sincos_rom_2[241] = 40'h3fbf105b09; sincos_rom_2[242] = 40'h3fc7b054c6; sincos_rom_2[243] = 40'h3fcfb04e83;
        sincos_rom_2[244] = 40'h3fd720483f; sincos_rom_2[245] = 40'h3fdde041fa; sincos_rom_2[246] = 40'h3fe4103bb5; sincos_rom_2[247] = 40'h3fe9a0356f;
        sincos_rom_2[248] = 40'h3fee902f28; sincos_rom_2[249] = 40'h3ff2e028e1; sincos_rom_2[250] = 40'h3ff690229a; sincos_rom_2[251] = 40'h3ff9b01c52;
        sincos_rom_2[252] = 40'h3ffc20160a; sincos_rom_2[253] = 40'h3ffe000fc2; sincos_rom_2[254] = 40'h3fff400979; sincos_rom_2[255] = 40'h3fffe00331;
        sincos_rom_2[256] = 40'h3fffeffce8; sincos_rom_2[257] = 40'h3fff4ff6a0; sincos_rom_2[258] = 40'h3ffe0ff058; sincos_rom_2[259] = 40'h3ffc3fea0f;
        sincos_rom_2[260] = 40'h3ff9bfe3c7; sincos_rom_2[261] = 40'h3ff6afdd80; sincos_rom_2[262] = 40'h3ff2ffd738; sincos_rom_2[263] = 40'h3feeafd0f1;
        sincos_rom_2[264] = 40'h3fe9bfcaab; sincos_rom_2[265] = 40'h3fe42fc465; sincos_rom_2[266] = 40'h3fde0fbe1f; sincos_rom_2[267] = 40'h3fd73fb7da;
        sincos_rom_2[268] = 40'h3fcfdfb196; sincos_rom_2[269] = 40'h3fc7dfab53; sincos_rom_2[270] = 40'h3fbf3fa510; sincos_rom_2[271] = 40'h3fb5ff9ecf;
        sincos_rom_2[272] = 40'h3fac2f988e; sincos_rom_2[273] = 40'h3fa1af924e; sincos_rom_2[274] = 40'h3f969f8c0f; sincos_rom_2[275] = 40'h3f8aef85d2;
        sincos_rom_2[276] = 40'h3f7e9f7f95; sincos_rom_2[277] = 40'h3f71bf795a; sincos_rom_2[278] = 40'h3f642f7320; sincos_rom_2[279] = 40'h3f560f6ce8;
        sincos_rom_2[280] = 40'h3f474f66b1; sincos_rom_2[281] = 40'h3f37ef607b; sincos_rom_2[282] = 40'h3f27ff5a47; sincos_rom_2[283] = 40'h3f176f5415;
        sincos_rom_2[284] = 40'h3f063f4de4; sincos_rom_2[285] = 40'h3ef46f47b5; sincos_rom_2[286] = 40'h3ee20f4187; sincos_rom_2[287] = 40'h3ecf0f3b5c;
        sincos_rom_2[288] = 40'h3ebb6f3532; sincos_rom_2[289] = 40'h3ea73f2f0b; sincos_rom_2[290] = 40'h3e926f28e5; sincos_rom_2[291] = 40'h3e7cff22c1;
        sincos_rom_2[292] = 40'h3e66ff1ca0; sincos_rom_2[293] = 40'h3e505f1681; sincos_rom_2[294] = 40'h3e391f1064; sincos_rom_2[295] = 40'h3e214f0a49;
        sincos_rom_2[296] = 40'h3e08df0431; sincos_rom_2[297] = 40'h3defdefe1b; sincos_rom_2[298] = 40'h3dd63ef808; sincos_rom_2[299] = 40'h3dbc0ef1f7;
        sincos_rom_2[300] = 40'h3da13eebe8; sincos_rom_2[301] = 40'h3d85cee5dd; sincos_rom_2[302] = 40'h3d69cedfd4; sincos_rom_2[303] = 40'h3d4d3ed9ce;
        sincos_rom_2[304] = 40'h3d300ed3cb; sincos_rom_2[305] = 40'h3d124ecdca; sincos_rom_2[306] = 40'h3cf3eec7cd; sincos_rom_2[307] = 40'h3cd4fec1d3;
        sincos_rom_2[308] = 40'h3cb57ebbdb; sincos_rom_2[309] = 40'h3c955eb5e7; sincos_rom_2[310] = 40'h3c749eaff6; sincos_rom_2[311] = 40'h3c535eaa08;
        sincos_rom_2[312] = 40'h3c317ea41e; sincos_rom_2[313] = 40'h3c0f0e9e37; sincos_rom_2[314] = 40'h3bec0e9853; sincos_rom_2[315] = 40'h3bc86e9273;
        sincos_rom_2[316] = 40'h3ba43e8c96; sincos_rom_2[317] = 40'h3b7f7e86bd; sincos_rom_2[318] = 40'h3b5a2e80e7; sincos_rom_2[319] = 40'h3b344e7b15;
        sincos_rom_2[320] = 40'h3b0dce7547; sincos_rom_2[321] = 40'h3ae6ce6f7d; sincos_rom_2[322] = 40'h3abf2e69b7; sincos_rom_2[323] = 40'h3a96fe63f4;
        sincos_rom_2[324] = 40'h3a6e4e5e36; sincos_rom_2[325] = 40'h3a44fe587b; sincos_rom_2[326] = 40'h3a1b1e52c5; sincos_rom_2[327] = 40'h39f0ae4d12;
        sincos_rom_2[328] = 40'h39c5be4764; sincos_rom_2[329] = 40'h399a2e41bb; sincos_rom_2[330] = 40'h396e1e3c15; sincos_rom_2[331] = 40'h39416e3674;
        sincos_rom_2[332] = 40'h39143e30d7; sincos_rom_2[333] = 40'h38e67e2b3f; sincos_rom_2[334] = 40'h38b83e25ab; sincos_rom_2[335] = 40'h38895e201c;
        sincos_rom_2[336] = 40'h3859fe1a91; sincos_rom_2[337] = 40'h382a0e150b; sincos_rom_2[338] = 40'h37f99e0f8a; sincos_rom_2[339] = 40'h37c89e0a0e;
        sincos_rom_2[340] = 40'h37970e0496; sincos_rom_2[341] = 40'h3764edff23; sincos_rom_2[342] = 40'h37325df9b6; sincos_rom_2[343] = 40'h36ff2df44d;
        sincos_rom_2[344] = 40'h36cb7deee9; sincos_rom_2[345] = 40'h36974de98b; sincos_rom_2[346] = 40'h36628de431; sincos_rom_2[347] = 40'h362d4ddedd;
        sincos_rom_2[348] = 40'h35f78dd98e; sincos_rom_2[349] = 40'h35c13dd444; sincos_rom_2[350] = 40'h358a6dcf00; sincos_rom_2[351] = 40'h35531dc9c1;
        sincos_rom_2[352] = 40'h351b3dc488; sincos_rom_2[353] = 40'h34e2ddbf54; sincos_rom_2[354] = 40'h34a9fdba25; sincos_rom_2[355] = 40'h34709db4fd;
        sincos_rom_2[356] = 40'h3436bdafd9; sincos_rom_2[357] = 40'h33fc5daabc; sincos_rom_2[358] = 40'h33c17da5a4; sincos_rom_2[359] = 40'h33861da093;
        sincos_rom_2[360] = 40'h334a3d9b87; sincos_rom_2[361] = 40'h330dcd9680; sincos_rom_2[362] = 40'h32d0fd9180; sincos_rom_2[363] = 40'h32939d8c86;
        sincos_rom_2[364] = 40'h3255bd8792; sincos_rom_2[365] = 40'h32176d82a4; sincos_rom_2[366] = 40'h31d89d7dbc; sincos_rom_2[367] = 40'h31994d78db;
        sincos_rom_2[368] = 40'h31598d73ff; sincos_rom_2[369] = 40'h31194d6f2a; sincos_rom_2[370] = 40'h30d88d6a5b; sincos_rom_2[371] = 40'h30975d6593;
        sincos_rom_2[372] = 40'h3055bd60d1; sincos_rom_2[373] = 40'h30139d5c15; sincos_rom_2[374] = 40'h2fd0fd5760; sincos_rom_2[375] = 40'h2f8dfd52b2;
        sincos_rom_2[376] = 40'h2f4a6d4e0a; sincos_rom_2[377] = 40'h2f067d4969; sincos_rom_2[378] = 40'h2ec20d44ce; sincos_rom_2[379] = 40'h2e7d2d403a;
        sincos_rom_2[380] = 40'h2e37dd3bad; sincos_rom_2[381] = 40'h2df21d3727; sincos_rom_2[382] = 40'h2dabed32a8; sincos_rom_2[383] = 40'h2d654d2e30;
        sincos_rom_2[384] = 40'h2d1e2d29be; sincos_rom_2[385] = 40'h2cd6ad2554; sincos_rom_2[386] = 40'h2c8ebd20f0; sincos_rom_2[387] = 40'h2c465d1c94;
        sincos_rom_2[388] = 40'h2bfd8d183f; sincos_rom_2[389] = 40'h2bb44d13f1; sincos_rom_2[390] = 40'h2b6aad0faa; sincos_rom_2[391] = 40'h2b209d0b6a;
        sincos_rom_2[392] = 40'h2ad61d0732; sincos_rom_2[393] = 40'h2a8b3d0301; sincos_rom_2[394] = 40'h2a3fecfed8; sincos_rom_2[395] = 40'h29f42cfab6;
        sincos_rom_2[396] = 40'h29a80cf69b; sincos_rom_2[397] = 40'h295b8cf288; sincos_rom_2[398] = 40'h290e9cee7c; sincos_rom_2[399] = 40'h28c14cea78;
        sincos_rom_2[400] = 40'h28739ce67c; sincos_rom_2[401] = 40'h28257ce287; sincos_rom_2[402] = 40'h27d70cde9a; sincos_rom_2[403] = 40'h27882cdab4;
        sincos_rom_2[404] = 40'h2738ecd6d7; sincos_rom_2[405] = 40'h26e94cd301; sincos_rom_2[406] = 40'h26994ccf33; sincos_rom_2[407] = 40'h2648eccb6d;
        sincos_rom_2[408] = 40'h25f82cc7ae; sincos_rom_2[409] = 40'h25a70cc3f8; sincos_rom_2[410] = 40'h25558cc04a; sincos_rom_2[411] = 40'h2503bcbca3;
        sincos_rom_2[412] = 40'h24b18cb905; sincos_rom_2[413] = 40'h245efcb56f; sincos_rom_2[414] = 40'h240c1cb1e1; sincos_rom_2[415] = 40'h23b8dcae5b;
        sincos_rom_2[416] = 40'h23654caadd; sincos_rom_2[417] = 40'h23115ca768; sincos_rom_2[418] = 40'h22bd1ca3fb; sincos_rom_2[419] = 40'h22687ca096;
        sincos_rom_2[420] = 40'h22138c9d39; sincos_rom_2[421] = 40'h21be4c99e5; sincos_rom_2[422] = 40'h2168bc9699; sincos_rom_2[423] = 40'h2112cc9356;
        sincos_rom_2[424] = 40'h20bc9c901b; sincos_rom_2[425] = 40'h20660c8ce8; sincos_rom_2[426] = 40'h200f2c89be; sincos_rom_2[427] = 40'h1fb80c869d;
        sincos_rom_2[428] = 40'h1f608c8384; sincos_rom_2[429] = 40'h1f08cc8073; sincos_rom_2[430] = 40'h1eb0bc7d6c; sincos_rom_2[431] = 40'h1e585c7a6d;
        sincos_rom_2[432] = 40'h1dffbc7777; sincos_rom_2[433] = 40'h1da6bc7489; sincos_rom_2[434] = 40'h1d4d8c71a4; sincos_rom_2[435] = 40'h1cf3fc6ec8;
        sincos_rom_2[436] = 40'h1c9a3c6bf5; sincos_rom_2[437] = 40'h1c402c692a; sincos_rom_2[438] = 40'h1be5cc6669; sincos_rom_2[439] = 40'h1b8b2c63b0;
        sincos_rom_2[440] = 40'h1b304c6100; sincos_rom_2[441] = 40'h1ad52c5e59; sincos_rom_2[442] = 40'h1a79cc5bbc; sincos_rom_2[443] = 40'h1a1e1c5927;
        sincos_rom_2[444] = 40'h19c23c569b; sincos_rom_2[445] = 40'h19660c5418; sincos_rom_2[446] = 40'h1909ac519e; sincos_rom_2[447] = 40'h18ad0c4f2d;
        sincos_rom_2[448] = 40'h18502c4cc6; sincos_rom_2[449] = 40'h17f30c4a67; sincos_rom_2[450] = 40'h1795bc4812; sincos_rom_2[451] = 40'h17382c45c6;
        sincos_rom_2[452] = 40'h16da5c4383; sincos_rom_2[453] = 40'h167c5c4149; sincos_rom_2[454] = 40'h161e1c3f19; sincos_rom_2[455] = 40'h15bfac3cf1;
        sincos_rom_2[456] = 40'h1560fc3ad3; sincos_rom_2[457] = 40'h15022c38bf; sincos_rom_2[458] = 40'h14a31c36b3; sincos_rom_2[459] = 40'h1443dc34b1;
        sincos_rom_2[460] = 40'h13e45c32b9; sincos_rom_2[461] = 40'h1384bc30ca; sincos_rom_2[462] = 40'h1324ec2ee4; sincos_rom_2[463] = 40'h12c4dc2d07;
        sincos_rom_2[464] = 40'h1264ac2b34; sincos_rom_2[465] = 40'h12044c296b; sincos_rom_2[466] = 40'h11a3bc27ab; sincos_rom_2[467] = 40'h11430c25f4;
        sincos_rom_2[468] = 40'h10e22c2447; sincos_rom_2[469] = 40'h10811c22a3; sincos_rom_2[470] = 40'h101fdc2109; sincos_rom_2[471] = 40'h0fbe8c1f79;
        sincos_rom_2[472] = 40'h0f5cfc1df2; sincos_rom_2[473] = 40'h0efb5c1c75; sincos_rom_2[474] = 40'h0e998c1b01; sincos_rom_2[475] = 40'h0e378c1997;
        sincos_rom_2[476] = 40'h0dd57c1836; sincos_rom_2[477] = 40'h0d734c16e0; sincos_rom_2[478] = 40'h0d10ec1592; sincos_rom_2[479] = 40'h0cae6c144f;
        sincos_rom_2[480] = 40'h0c4bdc1315; sincos_rom_2[481] = 40'h0be91c11e5; sincos_rom_2[482] = 40'h0b864c10be; sincos_rom_2[483] = 40'h0b235c0fa1;
        sincos_rom_2[484] = 40'h0ac04c0e8e; sincos_rom_2[485] = 40'h0a5d2c0d85; sincos_rom_2[486] = 40'h09f9ec0c85; sincos_rom_2[487] = 40'h09968c0b90;
        sincos_rom_2[488] = 40'h09331c0aa4; sincos_rom_2[489] = 40'h08cf9c09c1; sincos_rom_2[490] = 40'h086bfc08e9; sincos_rom_2[491] = 40'h08084c081a;
        sincos_rom_2[492] = 40'h07a47c0755; sincos_rom_2[493] = 40'h0740ac069a; sincos_rom_2[494] = 40'h06dcbc05e8; sincos_rom_2[495] = 40'h0678bc0541;
        sincos_rom_2[496] = 40'h0614bc04a3; sincos_rom_2[497] = 40'h05b09c040f; sincos_rom_2[498] = 40'h054c6c0385; sincos_rom_2[499] = 40'h04e83c0305;
        sincos_rom_2[500] = 40'h0483fc028e; sincos_rom_2[501] = 40'h041fac0222; sincos_rom_2[502] = 40'h03bb5c01bf; sincos_rom_2[503] = 40'h0356fc0166;
        sincos_rom_2[504] = 40'h02f28c0117; sincos_rom_2[505] = 40'h028e1c00d2; sincos_rom_2[506] = 40'h0229ac0097; sincos_rom_2[507] = 40'h01c52c0065;
        sincos_rom_2[508] = 40'h0160ac003e; sincos_rom_2[509] = 40'h00fc2c0020; sincos_rom_2[510] = 40'h00979c000c; sincos_rom_2[511] = 40'h00331c0002;
        sincos_rom_2[512] = 40'hffce8c0002; sincos_rom_2[513] = 40'hff6a0c000c; sincos_rom_2[514] = 40'hff058c0020; sincos_rom_2[515] = 40'hfea0fc003d;
        sincos_rom_2[516] = 40'hfe3c7c0065; sincos_rom_2[517] = 40'hfdd80c0096; sincos_rom_2[518] = 40'hfd738c00d1; sincos_rom_2[519] = 40'hfd0f1c0116;
        sincos_rom_2[520] = 40'hfcaabc0165; sincos_rom_2[521] = 40'hfc465c01be; sincos_rom_2[522] = 40'hfbe1fc0220; sincos_rom_2[523] = 40'hfb7dac028d;
        sincos_rom_2[524] = 40'hfb196c0303; sincos_rom_2[525] = 40'hfab53c0383; sincos_rom_2[526] = 40'hfa510c040d; sincos_rom_2[527] = 40'hf9ecfc04a1;
        sincos_rom_2[528] = 40'hf988ec053e; sincos_rom_2[529] = 40'hf924ec05e6; sincos_rom_2[530] = 40'hf8c0fc0697; sincos_rom_2[531] = 40'hf85d2c0752;
        sincos_rom_2[532] = 40'hf7f95c0817; sincos_rom_2[533] = 40'hf795ac08e5; sincos_rom_2[534] = 40'hf7320c09be; sincos_rom_2[535] = 40'hf6ce8c0aa0;
        sincos_rom_2[536] = 40'hf66b1c0b8c; sincos_rom_2[537] = 40'hf607bc0c82; sincos_rom_2[538] = 40'hf5a47c0d81; sincos_rom_2[539] = 40'hf5415c0e8a;
        sincos_rom_2[540] = 40'hf4de4c0f9d; sincos_rom_2[541] = 40'hf47b5c10ba; sincos_rom_2[542] = 40'hf4187c11e0; sincos_rom_2[543] = 40'hf3b5cc1310;
        sincos_rom_2[544] = 40'hf3532c144a; sincos_rom_2[545] = 40'hf2f0bc158d; sincos_rom_2[546] = 40'hf28e5c16da; sincos_rom_2[547] = 40'hf22c1c1831;
        sincos_rom_2[548] = 40'hf1ca0c1991; sincos_rom_2[549] = 40'hf1681c1afb; sincos_rom_2[550] = 40'hf1064c1c6f; sincos_rom_2[551] = 40'hf0a49c1dec;
        sincos_rom_2[552] = 40'hf0431c1f73; sincos_rom_2[553] = 40'hefe1bc2103; sincos_rom_2[554] = 40'hef808c229d; sincos_rom_2[555] = 40'hef1f7c2440;
        sincos_rom_2[556] = 40'heebe8c25ed; sincos_rom_2[557] = 40'hee5ddc27a4; sincos_rom_2[558] = 40'hedfd4c2964; sincos_rom_2[559] = 40'hed9cec2b2d;
        sincos_rom_2[560] = 40'hed3cbc2d00; sincos_rom_2[561] = 40'hecdcac2edc; sincos_rom_2[562] = 40'hec7cdc30c2; sincos_rom_2[563] = 40'hec1d3c32b1;
        sincos_rom_2[564] = 40'hebbdbc34a9; sincos_rom_2[565] = 40'heb5e7c36ab; sincos_rom_2[566] = 40'heaff6c38b7; sincos_rom_2[567] = 40'heaa08c3acb;
        sincos_rom_2[568] = 40'hea41ec3ce9; sincos_rom_2[569] = 40'he9e37c3f10; sincos_rom_2[570] = 40'he9853c4140; sincos_rom_2[571] = 40'he9273c437a;
        sincos_rom_2[572] = 40'he8c96c45bd; sincos_rom_2[573] = 40'he86bdc4809; sincos_rom_2[574] = 40'he80e7c4a5e; sincos_rom_2[575] = 40'he7b15c4cbc;
        sincos_rom_2[576] = 40'he7547c4f24; sincos_rom_2[577] = 40'he6f7dc5194; sincos_rom_2[578] = 40'he69b7c540e; sincos_rom_2[579] = 40'he63f4c5691;
        sincos_rom_2[580] = 40'he5e36c591c; sincos_rom_2[581] = 40'he587bc5bb1; sincos_rom_2[582] = 40'he52c5c5e4f; sincos_rom_2[583] = 40'he4d12c60f6;
        sincos_rom_2[584] = 40'he4764c63a5; sincos_rom_2[585] = 40'he41bbc665e; sincos_rom_2[586] = 40'he3c15c691f; sincos_rom_2[587] = 40'he3674c6bea;
        sincos_rom_2[588] = 40'he30d7c6ebd; sincos_rom_2[589] = 40'he2b3fc7199; sincos_rom_2[590] = 40'he25abc747d; sincos_rom_2[591] = 40'he201cc776b;
        sincos_rom_2[592] = 40'he1a91c7a61; sincos_rom_2[593] = 40'he150bc7d60; sincos_rom_2[594] = 40'he0f8ac8067; sincos_rom_2[595] = 40'he0a0ec8377;
        sincos_rom_2[596] = 40'he0496c8690; sincos_rom_2[597] = 40'hdff23c89b2; sincos_rom_2[598] = 40'hdf9b6c8cdb; sincos_rom_2[599] = 40'hdf44dc900e;
        sincos_rom_2[600] = 40'hdeee9c9349; sincos_rom_2[601] = 40'hde98bc968c; sincos_rom_2[602] = 40'hde431c99d8; sincos_rom_2[603] = 40'hddeddc9d2c;
        sincos_rom_2[604] = 40'hdd98eca088; sincos_rom_2[605] = 40'hdd444ca3ed; sincos_rom_2[606] = 40'hdcf00ca75a; sincos_rom_2[607] = 40'hdc9c1caacf;
        sincos_rom_2[608] = 40'hdc488cae4d; sincos_rom_2[609] = 40'hdbf54cb1d3; sincos_rom_2[610] = 40'hdba25cb561; sincos_rom_2[611] = 40'hdb4fdcb8f7;
        sincos_rom_2[612] = 40'hdafd9cbc95; sincos_rom_2[613] = 40'hdaabccc03b; sincos_rom_2[614] = 40'hda5a4cc3e9; sincos_rom_2[615] = 40'hda093cc79f;
        sincos_rom_2[616] = 40'hd9b87ccb5d; sincos_rom_2[617] = 40'hd9680ccf24; sincos_rom_2[618] = 40'hd9180cd2f1; sincos_rom_2[619] = 40'hd8c86cd6c7;
        sincos_rom_2[620] = 40'hd8792cdaa5; sincos_rom_2[621] = 40'hd82a4cde8a; sincos_rom_2[622] = 40'hd7dbcce277; sincos_rom_2[623] = 40'hd78dbce66c;
        sincos_rom_2[624] = 40'hd73ffcea68; sincos_rom_2[625] = 40'hd6f2acee6c; sincos_rom_2[626] = 40'hd6a5bcf278; sincos_rom_2[627] = 40'hd6593cf68b;
        sincos_rom_2[628] = 40'hd60d1cfaa5; sincos_rom_2[629] = 40'hd5c15cfec7; sincos_rom_2[630] = 40'hd5760d02f1; sincos_rom_2[631] = 40'hd52b2d0721;
        sincos_rom_2[632] = 40'hd4e0ad0b5a; sincos_rom_2[633] = 40'hd4969d0f99; sincos_rom_2[634] = 40'hd44ced13e0; sincos_rom_2[635] = 40'hd403ad182e;
        sincos_rom_2[636] = 40'hd3badd1c83; sincos_rom_2[637] = 40'hd3727d20df; sincos_rom_2[638] = 40'hd32a8d2542; sincos_rom_2[639] = 40'hd2e30d29ac;
        sincos_rom_2[640] = 40'hd29bed2e1e; sincos_rom_2[641] = 40'hd2554d3296; sincos_rom_2[642] = 40'hd20f0d3715; sincos_rom_2[643] = 40'hd1c94d3b9b;
        sincos_rom_2[644] = 40'hd183fd4028; sincos_rom_2[645] = 40'hd13f1d44bc; sincos_rom_2[646] = 40'hd0faad4956; sincos_rom_2[647] = 40'hd0b6ad4df7;
        sincos_rom_2[648] = 40'hd0732d529f; sincos_rom_2[649] = 40'hd0301d574d; sincos_rom_2[650] = 40'hcfed8d5c02; sincos_rom_2[651] = 40'hcfab6d60be;
        sincos_rom_2[652] = 40'hcf69bd6580; sincos_rom_2[653] = 40'hcf288d6a48; sincos_rom_2[654] = 40'hcee7cd6f17; sincos_rom_2[655] = 40'hcea78d73ec;
        sincos_rom_2[656] = 40'hce67cd78c7; sincos_rom_2[657] = 40'hce287d7da9; sincos_rom_2[658] = 40'hcde9ad8290; sincos_rom_2[659] = 40'hcdab4d877e;
        sincos_rom_2[660] = 40'hcd6d7d8c72; sincos_rom_2[661] = 40'hcd301d916c; sincos_rom_2[662] = 40'hccf33d966c; sincos_rom_2[663] = 40'hccb6dd9b72;
        sincos_rom_2[664] = 40'hcc7aeda07e; sincos_rom_2[665] = 40'hcc3f8da590; sincos_rom_2[666] = 40'hcc04adaaa8; sincos_rom_2[667] = 40'hcbca3dafc5;
        sincos_rom_2[668] = 40'hcb905db4e8; sincos_rom_2[669] = 40'hcb56fdba11; sincos_rom_2[670] = 40'hcb1e1dbf3f; sincos_rom_2[671] = 40'hcae5bdc473;
        sincos_rom_2[672] = 40'hcaadddc9ac; sincos_rom_2[673] = 40'hca768dceeb; sincos_rom_2[674] = 40'hca3fbdd42f; sincos_rom_2[675] = 40'hca096dd979;
        sincos_rom_2[676] = 40'hc9d39ddec8; sincos_rom_2[677] = 40'hc99e5de41c; sincos_rom_2[678] = 40'hc9699de975; sincos_rom_2[679] = 40'hc9356deed4;
        sincos_rom_2[680] = 40'hc901bdf437; sincos_rom_2[681] = 40'hc8ce8df9a0; sincos_rom_2[682] = 40'hc89bedff0e; sincos_rom_2[683] = 40'hc869de0480;
        sincos_rom_2[684] = 40'hc8384e09f8; sincos_rom_2[685] = 40'hc8073e0f74; sincos_rom_2[686] = 40'hc7d6ce14f5; sincos_rom_2[687] = 40'hc7a6de1a7b;
        sincos_rom_2[688] = 40'hc7777e2005; sincos_rom_2[689] = 40'hc7489e2595; sincos_rom_2[690] = 40'hc71a4e2b28; sincos_rom_2[691] = 40'hc6ec8e30c1;
        sincos_rom_2[692] = 40'hc6bf5e365d; sincos_rom_2[693] = 40'hc692ae3bfe; sincos_rom_2[694] = 40'hc6669e41a4; sincos_rom_2[695] = 40'hc63b0e474e;
        sincos_rom_2[696] = 40'hc6100e4cfc; sincos_rom_2[697] = 40'hc5e59e52ae; sincos_rom_2[698] = 40'hc5bbce5864; sincos_rom_2[699] = 40'hc5927e5e1f;
        sincos_rom_2[700] = 40'hc569be63dd; sincos_rom_2[701] = 40'hc5418e69a0; sincos_rom_2[702] = 40'hc519ee6f66; sincos_rom_2[703] = 40'hc4f2de7530;
        sincos_rom_2[704] = 40'hc4cc6e7afe; sincos_rom_2[705] = 40'hc4a67e80d0; sincos_rom_2[706] = 40'hc4812e86a5; sincos_rom_2[707] = 40'hc45c6e8c7e;
        sincos_rom_2[708] = 40'hc4383e925b; sincos_rom_2[709] = 40'hc4149e983b; sincos_rom_2[710] = 40'hc3f19e9e1f; sincos_rom_2[711] = 40'hc3cf1ea406;
        sincos_rom_2[712] = 40'hc3ad3ea9f1; sincos_rom_2[713] = 40'hc38bfeafde; sincos_rom_2[714] = 40'hc36b3eb5cf; sincos_rom_2[715] = 40'hc34b1ebbc3;
        sincos_rom_2[716] = 40'hc32b9ec1bb; sincos_rom_2[717] = 40'hc30caec7b5; sincos_rom_2[718] = 40'hc2ee4ecdb2; sincos_rom_2[719] = 40'hc2d07ed3b3;
        sincos_rom_2[720] = 40'hc2b34ed9b6; sincos_rom_2[721] = 40'hc296bedfbc; sincos_rom_2[722] = 40'hc27abee5c5; sincos_rom_2[723] = 40'hc25f4eebd0;
        sincos_rom_2[724] = 40'hc2447ef1de; sincos_rom_2[725] = 40'hc22a3ef7ef; sincos_rom_2[726] = 40'hc2109efe03; sincos_rom_2[727] = 40'hc1f79f0418;
        sincos_rom_2[728] = 40'hc1df2f0a31; sincos_rom_2[729] = 40'hc1c75f104b; sincos_rom_2[730] = 40'hc1b01f1668; sincos_rom_2[731] = 40'hc1997f1c88;
        sincos_rom_2[732] = 40'hc1836f22a9; sincos_rom_2[733] = 40'hc16e0f28cc; sincos_rom_2[734] = 40'hc1592f2ef2; sincos_rom_2[735] = 40'hc144ff351a;
        sincos_rom_2[736] = 40'hc1315f3b43; sincos_rom_2[737] = 40'hc11e5f416f; sincos_rom_2[738] = 40'hc10bef479c; sincos_rom_2[739] = 40'hc0fa1f4dcb;
        sincos_rom_2[740] = 40'hc0e8ef53fc; sincos_rom_2[741] = 40'hc0d85f5a2e; sincos_rom_2[742] = 40'hc0c85f6062; sincos_rom_2[743] = 40'hc0b90f6698;
        sincos_rom_2[744] = 40'hc0aa4f6ccf; sincos_rom_2[745] = 40'hc09c1f7307; sincos_rom_2[746] = 40'hc08e9f7941; sincos_rom_2[747] = 40'hc081af7f7c;
        sincos_rom_2[748] = 40'hc0755f85b9; sincos_rom_2[749] = 40'hc069af8bf6; sincos_rom_2[750] = 40'hc05e8f9235; sincos_rom_2[751] = 40'hc0541f9875;
        sincos_rom_2[752] = 40'hc04a3f9eb5; sincos_rom_2[753] = 40'hc040ffa4f7; sincos_rom_2[754] = 40'hc0385fab3a; sincos_rom_2[755] = 40'hc0305fb17d;
        sincos_rom_2[756] = 40'hc028efb7c1; sincos_rom_2[757] = 40'hc0222fbe06; sincos_rom_2[758] = 40'hc01bffc44b; sincos_rom_2[759] = 40'hc0166fca91;
        sincos_rom_2[760] = 40'hc0117fd0d8; sincos_rom_2[761] = 40'hc00d2fd71f; sincos_rom_2[762] = 40'hc0097fdd66; sincos_rom_2[763] = 40'hc0065fe3ae;
        sincos_rom_2[764] = 40'hc003efe9f6; sincos_rom_2[765] = 40'hc0020ff03e; sincos_rom_2[766] = 40'hc000cff687; sincos_rom_2[767] = 40'hc0002ffccf;
        sincos_rom_2[768] = 40'hc000200318; sincos_rom_2[769] = 40'hc000c00960; sincos_rom_2[770] = 40'hc002000fa8; sincos_rom_2[771] = 40'hc003d015f1;
        sincos_rom_2[772] = 40'hc006501c39; sincos_rom_2[773] = 40'hc009602280; sincos_rom_2[774] = 40'hc00d1028c8; sincos_rom_2[775] = 40'hc011602f0f;
        sincos_rom_2[776] = 40'hc016503555; sincos_rom_2[777] = 40'hc01be03b9b; sincos_rom_2[778] = 40'hc0220041e1; sincos_rom_2[779] = 40'hc028d04826;
        sincos_rom_2[780] = 40'hc030304e6a; sincos_rom_2[781] = 40'hc0383054ad; sincos_rom_2[782] = 40'hc040d05af0; sincos_rom_2[783] = 40'hc04a106131;
        sincos_rom_2[784] = 40'hc053e06772; sincos_rom_2[785] = 40'hc05e606db2; sincos_rom_2[786] = 40'hc0697073f1; sincos_rom_2[787] = 40'hc075207a2e;
        sincos_rom_2[788] = 40'hc08170806b; sincos_rom_2[789] = 40'hc08e5086a6; sincos_rom_2[790] = 40'hc09be08ce0; sincos_rom_2[791] = 40'hc0aa009318;
        sincos_rom_2[792] = 40'hc0b8c0994f; sincos_rom_2[793] = 40'hc0c8209f85; sincos_rom_2[794] = 40'hc0d810a5b9; sincos_rom_2[795] = 40'hc0e8a0abeb;
        sincos_rom_2[796] = 40'hc0f9d0b21c; sincos_rom_2[797] = 40'hc10ba0b84b; sincos_rom_2[798] = 40'hc11e00be79; sincos_rom_2[799] = 40'hc13100c4a4;
        sincos_rom_2[800] = 40'hc144a0cace; sincos_rom_2[801] = 40'hc158d0d0f5; sincos_rom_2[802] = 40'hc16da0d71b; sincos_rom_2[803] = 40'hc18310dd3f;
        sincos_rom_2[804] = 40'hc19910e360; sincos_rom_2[805] = 40'hc1afb0e97f; sincos_rom_2[806] = 40'hc1c6f0ef9c; sincos_rom_2[807] = 40'hc1dec0f5b7;
        sincos_rom_2[808] = 40'hc1f730fbcf; sincos_rom_2[809] = 40'hc2103101e5; sincos_rom_2[810] = 40'hc229d107f8; sincos_rom_2[811] = 40'hc244010e09;
        sincos_rom_2[812] = 40'hc25ed11418; sincos_rom_2[813] = 40'hc27a411a23; sincos_rom_2[814] = 40'hc29641202c; sincos_rom_2[815] = 40'hc2b2d12632;
        sincos_rom_2[816] = 40'hc2d0012c35; sincos_rom_2[817] = 40'hc2edc13236; sincos_rom_2[818] = 40'hc30c213833; sincos_rom_2[819] = 40'hc32b113e2d;
        sincos_rom_2[820] = 40'hc34a914425; sincos_rom_2[821] = 40'hc36ab14a19; sincos_rom_2[822] = 40'hc38b71500a; sincos_rom_2[823] = 40'hc3acb155f8;
        sincos_rom_2[824] = 40'hc3ce915be2; sincos_rom_2[825] = 40'hc3f10161c9; sincos_rom_2[826] = 40'hc4140167ad; sincos_rom_2[827] = 40'hc437a16d8d;
        sincos_rom_2[828] = 40'hc45bd1736a; sincos_rom_2[829] = 40'hc480917943; sincos_rom_2[830] = 40'hc4a5e17f19; sincos_rom_2[831] = 40'hc4cbc184eb;
        sincos_rom_2[832] = 40'hc4f2418ab9; sincos_rom_2[833] = 40'hc519419083; sincos_rom_2[834] = 40'hc540e19649; sincos_rom_2[835] = 40'hc569119c0c;
        sincos_rom_2[836] = 40'hc591c1a1ca; sincos_rom_2[837] = 40'hc5bb11a785; sincos_rom_2[838] = 40'hc5e4f1ad3b; sincos_rom_2[839] = 40'hc60f61b2ee;
        sincos_rom_2[840] = 40'hc63a51b89c; sincos_rom_2[841] = 40'hc665e1be45; sincos_rom_2[842] = 40'hc691f1c3eb; sincos_rom_2[843] = 40'hc6bea1c98c;
        sincos_rom_2[844] = 40'hc6ebd1cf29; sincos_rom_2[845] = 40'hc71991d4c1; sincos_rom_2[846] = 40'hc747d1da55; sincos_rom_2[847] = 40'hc776b1dfe4;
        sincos_rom_2[848] = 40'hc7a611e56f; sincos_rom_2[849] = 40'hc7d601eaf5; sincos_rom_2[850] = 40'hc80671f076; sincos_rom_2[851] = 40'hc83771f5f2;
        sincos_rom_2[852] = 40'hc86901fb6a; sincos_rom_2[853] = 40'hc89b2200dd; sincos_rom_2[854] = 40'hc8cdb2064a; sincos_rom_2[855] = 40'hc900e20bb3;
        sincos_rom_2[856] = 40'hc934921117; sincos_rom_2[857] = 40'hc968c21675; sincos_rom_2[858] = 40'hc99d821bcf; sincos_rom_2[859] = 40'hc9d2c22123;
        sincos_rom_2[860] = 40'hca08822672; sincos_rom_2[861] = 40'hca3ed22bbc; sincos_rom_2[862] = 40'hca75a23100; sincos_rom_2[863] = 40'hcaacf2363f;
        sincos_rom_2[864] = 40'hcae4d23b78; sincos_rom_2[865] = 40'hcb1d3240ac; sincos_rom_2[866] = 40'hcb561245db; sincos_rom_2[867] = 40'hcb8f724b03;
        sincos_rom_2[868] = 40'hcbc9525027; sincos_rom_2[869] = 40'hcc03b25544; sincos_rom_2[870] = 40'hcc3e925a5c; sincos_rom_2[871] = 40'hcc79f25f6d;
        sincos_rom_2[872] = 40'hccb5d26479; sincos_rom_2[873] = 40'hccf2426980; sincos_rom_2[874] = 40'hcd2f126e80; sincos_rom_2[875] = 40'hcd6c72737a;
        sincos_rom_2[876] = 40'hcdaa52786e; sincos_rom_2[877] = 40'hcde8a27d5c; sincos_rom_2[878] = 40'hce27728244; sincos_rom_2[879] = 40'hce66c28725;
        sincos_rom_2[880] = 40'hcea6828c01; sincos_rom_2[881] = 40'hcee6c290d6; sincos_rom_2[882] = 40'hcf278295a5; sincos_rom_2[883] = 40'hcf68b29a6d;
        sincos_rom_2[884] = 40'hcfaa529f2f; sincos_rom_2[885] = 40'hcfec72a3eb; sincos_rom_2[886] = 40'hd02f12a8a0; sincos_rom_2[887] = 40'hd07212ad4e;
        sincos_rom_2[888] = 40'hd0b5a2b1f6; sincos_rom_2[889] = 40'hd0f992b697; sincos_rom_2[890] = 40'hd13e02bb32; sincos_rom_2[891] = 40'hd182e2bfc6;
        sincos_rom_2[892] = 40'hd1c832c453; sincos_rom_2[893] = 40'hd20df2c8d9; sincos_rom_2[894] = 40'hd25422cd58; sincos_rom_2[895] = 40'hd29ac2d1d0;
        sincos_rom_2[896] = 40'hd2e1e2d642; sincos_rom_2[897] = 40'hd32962daac; sincos_rom_2[898] = 40'hd37152df10; sincos_rom_2[899] = 40'hd3b9b2e36c;
        sincos_rom_2[900] = 40'hd40282e7c1; sincos_rom_2[901] = 40'hd44bc2ec0f; sincos_rom_2[902] = 40'hd49562f056; sincos_rom_2[903] = 40'hd4df72f496;
        sincos_rom_2[904] = 40'hd529f2f8ce; sincos_rom_2[905] = 40'hd574d2fcff; sincos_rom_2[906] = 40'hd5c0230128; sincos_rom_2[907] = 40'hd60be3054a;
        sincos_rom_2[908] = 40'hd658030965; sincos_rom_2[909] = 40'hd6a4830d78; sincos_rom_2[910] = 40'hd6f1731184; sincos_rom_2[911] = 40'hd73ec31588;
        sincos_rom_2[912] = 40'hd78c731984; sincos_rom_2[913] = 40'hd7da931d79; sincos_rom_2[914] = 40'hd829032166; sincos_rom_2[915] = 40'hd877e3254c;
        sincos_rom_2[916] = 40'hd8c7232929; sincos_rom_2[917] = 40'hd916c32cff; sincos_rom_2[918] = 40'hd966c330cd; sincos_rom_2[919] = 40'hd9b7233493;
        sincos_rom_2[920] = 40'hda07e33852; sincos_rom_2[921] = 40'hda59033c08; sincos_rom_2[922] = 40'hdaaa833fb6; sincos_rom_2[923] = 40'hdafc53435d;
        sincos_rom_2[924] = 40'hdb4e8346fb; sincos_rom_2[925] = 40'hdba1134a91; sincos_rom_2[926] = 40'hdbf3f34e1f; sincos_rom_2[927] = 40'hdc473351a5;
        sincos_rom_2[928] = 40'hdc9ac35523; sincos_rom_2[929] = 40'hdceeb35898; sincos_rom_2[930] = 40'hdd42f35c05; sincos_rom_2[931] = 40'hdd97935f6a;
        sincos_rom_2[932] = 40'hddec8362c7; sincos_rom_2[933] = 40'hde41c3661b; sincos_rom_2[934] = 40'hde97536967; sincos_rom_2[935] = 40'hdeed436caa;
        sincos_rom_2[936] = 40'hdf43736fe5; sincos_rom_2[937] = 40'hdf9a037318; sincos_rom_2[938] = 40'hdff0e37642; sincos_rom_2[939] = 40'he048037963;
        sincos_rom_2[940] = 40'he09f837c7c; sincos_rom_2[941] = 40'he0f7437f8d; sincos_rom_2[942] = 40'he14f538294; sincos_rom_2[943] = 40'he1a7b38593;
        sincos_rom_2[944] = 40'he200538889; sincos_rom_2[945] = 40'he259538b77; sincos_rom_2[946] = 40'he2b2838e5c; sincos_rom_2[947] = 40'he30c139138;
        sincos_rom_2[948] = 40'he365d3940b; sincos_rom_2[949] = 40'he3bfe396d6; sincos_rom_2[950] = 40'he41a439997; sincos_rom_2[951] = 40'he474e39c50;
        sincos_rom_2[952] = 40'he4cfc39f00; sincos_rom_2[953] = 40'he52ae3a1a7; sincos_rom_2[954] = 40'he58643a444; sincos_rom_2[955] = 40'he5e1f3a6d9;
        sincos_rom_2[956] = 40'he63dd3a965; sincos_rom_2[957] = 40'he69a03abe8; sincos_rom_2[958] = 40'he6f663ae62; sincos_rom_2[959] = 40'he75303b0d3;
        sincos_rom_2[960] = 40'he7afe3b33a; sincos_rom_2[961] = 40'he80d03b599; sincos_rom_2[962] = 40'he86a53b7ee; sincos_rom_2[963] = 40'he8c7e3ba3a;
        sincos_rom_2[964] = 40'he925b3bc7d; sincos_rom_2[965] = 40'he983b3beb7; sincos_rom_2[966] = 40'he9e1f3c0e7; sincos_rom_2[967] = 40'hea4063c30f;
        sincos_rom_2[968] = 40'hea9f13c52d; sincos_rom_2[969] = 40'heafde3c741; sincos_rom_2[970] = 40'heb5cf3c94d; sincos_rom_2[971] = 40'hebbc33cb4f;
        sincos_rom_2[972] = 40'hec1bb3cd47; sincos_rom_2[973] = 40'hec7b53cf36; sincos_rom_2[974] = 40'hecdb23d11c; sincos_rom_2[975] = 40'hed3b33d2f9;
        sincos_rom_2[976] = 40'hed9b63d4cc; sincos_rom_2[977] = 40'hedfbc3d695; sincos_rom_2[978] = 40'hee5c53d855; sincos_rom_2[979] = 40'heebd03da0c;
        sincos_rom_2[980] = 40'hef1de3dbb9; sincos_rom_2[981] = 40'hef7ef3dd5d; sincos_rom_2[982] = 40'hefe033def7; sincos_rom_2[983] = 40'hf04183e087;
        sincos_rom_2[984] = 40'hf0a313e20e; sincos_rom_2[985] = 40'hf104b3e38b; sincos_rom_2[986] = 40'hf16683e4ff; sincos_rom_2[987] = 40'hf1c883e669;
        sincos_rom_2[988] = 40'hf22a93e7ca; sincos_rom_2[989] = 40'hf28cc3e920; sincos_rom_2[990] = 40'hf2ef23ea6e; sincos_rom_2[991] = 40'hf351a3ebb1;
        sincos_rom_2[992] = 40'hf3b433eceb; sincos_rom_2[993] = 40'hf416f3ee1b; sincos_rom_2[994] = 40'hf479c3ef42; sincos_rom_2[995] = 40'hf4dcb3f05f;
        sincos_rom_2[996] = 40'hf53fc3f172; sincos_rom_2[997] = 40'hf5a2e3f27b; sincos_rom_2[998] = 40'hf60623f37b; sincos_rom_2[999] = 40'hf66983f470;
        sincos_rom_2[1000] = 40'hf6ccf3f55c; sincos_rom_2[1001] = 40'hf73073f63f; sincos_rom_2[1002] = 40'hf79413f717; sincos_rom_2[1003] = 40'hf7f7c3f7e6;
        sincos_rom_2[1004] = 40'hf85b93f8ab; sincos_rom_2[1005] = 40'hf8bf63f966; sincos_rom_2[1006] = 40'hf92353fa18; sincos_rom_2[1007] = 40'hf98753fabf;
        sincos_rom_2[1008] = 40'hf9eb53fb5d; sincos_rom_2[1009] = 40'hfa4f73fbf1; sincos_rom_2[1010] = 40'hfab3a3fc7b; sincos_rom_2[1011] = 40'hfb17d3fcfb;
        sincos_rom_2[1012] = 40'hfb7c13fd72; sincos_rom_2[1013] = 40'hfbe063fdde; sincos_rom_2[1014] = 40'hfc44b3fe41; sincos_rom_2[1015] = 40'hfca913fe9a;
        sincos_rom_2[1016] = 40'hfd0d83fee9; sincos_rom_2[1017] = 40'hfd71f3ff2e; sincos_rom_2[1018] = 40'hfdd663ff69; sincos_rom_2[1019] = 40'hfe3ae3ff9b;
        sincos_rom_2[1020] = 40'hfe9f63ffc2; sincos_rom_2[1021] = 40'hff03e3ffe0; sincos_rom_2[1022] = 40'hff6873fff4; sincos_rom_2[1023] = 40'hffccf3fffe;
    end

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_3 [0:1023];
    initial begin
        sincos_rom_3[0] = 40'h003183fffe; sincos_rom_3[1] = 40'h009603fff4; sincos_rom_3[2] = 40'h00fa83ffe0; sincos_rom_3[3] = 40'h015f13ffc3;
        sincos_rom_3[4] = 40'h01c393ff9b; sincos_rom_3[5] = 40'h022803ff6a; sincos_rom_3[6] = 40'h028c83ff2f; sincos_rom_3[7] = 40'h02f0f3feea;
        sincos_rom_3[8] = 40'h035553fe9b; sincos_rom_3[9] = 40'h03b9b3fe42; sincos_rom_3[10] = 40'h041e13fde0; sincos_rom_3[11] = 40'h048263fd73;
        sincos_rom_3[12] = 40'h04e6a3fcfd; sincos_rom_3[13] = 40'h054ad3fc7d; sincos_rom_3[14] = 40'h05af03fbf3; sincos_rom_3[15] = 40'h061313fb5f;
        sincos_rom_3[16] = 40'h067723fac2; sincos_rom_3[17] = 40'h06db23fa1a; sincos_rom_3[18] = 40'h073f13f969; sincos_rom_3[19] = 40'h07a2e3f8ae;
        sincos_rom_3[20] = 40'h0806b3f7e9; sincos_rom_3[21] = 40'h086a63f71b; sincos_rom_3[22] = 40'h08ce03f642; sincos_rom_3[23] = 40'h093183f560;
        sincos_rom_3[24] = 40'h0994f3f474; sincos_rom_3[25] = 40'h09f853f37e; sincos_rom_3[26] = 40'h0a5b93f27f; sincos_rom_3[27] = 40'h0abeb3f176;
        sincos_rom_3[28] = 40'h0b21c3f063; sincos_rom_3[29] = 40'h0b84b3ef46; sincos_rom_3[30] = 40'h0be793ee20; sincos_rom_3[31] = 40'h0c4a43ecf0;
        sincos_rom_3[32] = 40'h0cace3ebb6; sincos_rom_3[33] = 40'h0d0f53ea73; sincos_rom_3[34] = 40'h0d71b3e926; sincos_rom_3[35] = 40'h0dd3f3e7cf;
        sincos_rom_3[36] = 40'h0e3603e66f; sincos_rom_3[37] = 40'h0e97f3e505; sincos_rom_3[38] = 40'h0ef9c3e391; sincos_rom_3[39] = 40'h0f5b73e214;
        sincos_rom_3[40] = 40'h0fbcf3e08d; sincos_rom_3[41] = 40'h101e53defd; sincos_rom_3[42] = 40'h107f83dd63; sincos_rom_3[43] = 40'h10e093dbc0;
        sincos_rom_3[44] = 40'h114183da13; sincos_rom_3[45] = 40'h11a233d85c; sincos_rom_3[46] = 40'h1202c3d69c; sincos_rom_3[47] = 40'h126323d4d3;
        sincos_rom_3[48] = 40'h12c353d300; sincos_rom_3[49] = 40'h132363d124; sincos_rom_3[50] = 40'h138333cf3e; sincos_rom_3[51] = 40'h13e2d3cd4f;
        sincos_rom_3[52] = 40'h144253cb57; sincos_rom_3[53] = 40'h14a193c955; sincos_rom_3[54] = 40'h1500a3c749; sincos_rom_3[55] = 40'h155f83c535;
        sincos_rom_3[56] = 40'h15be23c317; sincos_rom_3[57] = 40'h161c93c0f0; sincos_rom_3[58] = 40'h167ad3bec0; sincos_rom_3[59] = 40'h16d8d3bc86;
        sincos_rom_3[60] = 40'h1736a3ba43; sincos_rom_3[61] = 40'h179433b7f7; sincos_rom_3[62] = 40'h17f193b5a2; sincos_rom_3[63] = 40'h184eb3b344;
        sincos_rom_3[64] = 40'h18ab93b0dc; sincos_rom_3[65] = 40'h190833ae6c; sincos_rom_3[66] = 40'h196493abf2; sincos_rom_3[67] = 40'h19c0c3a96f;
        sincos_rom_3[68] = 40'h1a1ca3a6e4; sincos_rom_3[69] = 40'h1a7853a44f; sincos_rom_3[70] = 40'h1ad3b3a1b1; sincos_rom_3[71] = 40'h1b2ee39f0a;
        sincos_rom_3[72] = 40'h1b89c39c5b; sincos_rom_3[73] = 40'h1be45399a2; sincos_rom_3[74] = 40'h1c3eb396e1; sincos_rom_3[75] = 40'h1c98c39416;
        sincos_rom_3[76] = 40'h1cf2939143; sincos_rom_3[77] = 40'h1d4c138e67; sincos_rom_3[78] = 40'h1da5538b83; sincos_rom_3[79] = 40'h1dfe438895;
        sincos_rom_3[80] = 40'h1e56f3859f; sincos_rom_3[81] = 40'h1eaf5382a0; sincos_rom_3[82] = 40'h1f07637f99; sincos_rom_3[83] = 40'h1f5f237c89;
        sincos_rom_3[84] = 40'h1fb6a37970; sincos_rom_3[85] = 40'h200dd3764e; sincos_rom_3[86] = 40'h2064a37325; sincos_rom_3[87] = 40'h20bb336ff2;
        sincos_rom_3[88] = 40'h2111736cb7; sincos_rom_3[89] = 40'h2167536974; sincos_rom_3[90] = 40'h21bcf36628; sincos_rom_3[91] = 40'h22123362d4;
        sincos_rom_3[92] = 40'h2267235f78; sincos_rom_3[93] = 40'h22bbc35c13; sincos_rom_3[94] = 40'h23100358a6; sincos_rom_3[95] = 40'h2363f35531;
        sincos_rom_3[96] = 40'h23b78351b3; sincos_rom_3[97] = 40'h240ac34e2d; sincos_rom_3[98] = 40'h245db34a9f; sincos_rom_3[99] = 40'h24b0334709;
        sincos_rom_3[100] = 40'h250273436b; sincos_rom_3[101] = 40'h2554433fc5; sincos_rom_3[102] = 40'h25a5c33c17; sincos_rom_3[103] = 40'h25f6d33861;
        sincos_rom_3[104] = 40'h26479334a3; sincos_rom_3[105] = 40'h26980330dc; sincos_rom_3[106] = 40'h26e8032d0f; sincos_rom_3[107] = 40'h2737a32939;
        sincos_rom_3[108] = 40'h2786e3255b; sincos_rom_3[109] = 40'h27d5c32176; sincos_rom_3[110] = 40'h2824431d89; sincos_rom_3[111] = 40'h2872531994;
        sincos_rom_3[112] = 40'h28c0131598; sincos_rom_3[113] = 40'h290d631194; sincos_rom_3[114] = 40'h295a530d88; sincos_rom_3[115] = 40'h29a6d30975;
        sincos_rom_3[116] = 40'h29f2f3055b; sincos_rom_3[117] = 40'h2a3eb30139; sincos_rom_3[118] = 40'h2a8a02fd0f; sincos_rom_3[119] = 40'h2ad4e2f8df;
        sincos_rom_3[120] = 40'h2b1f62f4a6; sincos_rom_3[121] = 40'h2b6972f067; sincos_rom_3[122] = 40'h2bb322ec20; sincos_rom_3[123] = 40'h2bfc62e7d2;
        sincos_rom_3[124] = 40'h2c4532e37d; sincos_rom_3[125] = 40'h2c8d92df21; sincos_rom_3[126] = 40'h2cd582dabe; sincos_rom_3[127] = 40'h2d1d02d654;
        sincos_rom_3[128] = 40'h2d6422d1e2; sincos_rom_3[129] = 40'h2daac2cd6a; sincos_rom_3[130] = 40'h2df102c8eb; sincos_rom_3[131] = 40'h2e36c2c465;
        sincos_rom_3[132] = 40'h2e7c12bfd8; sincos_rom_3[133] = 40'h2ec0f2bb44; sincos_rom_3[134] = 40'h2f0562b6aa; sincos_rom_3[135] = 40'h2f4962b209;
        sincos_rom_3[136] = 40'h2f8ce2ad61; sincos_rom_3[137] = 40'h2fcff2a8b3; sincos_rom_3[138] = 40'h301282a3fe; sincos_rom_3[139] = 40'h3054a29f42;
        sincos_rom_3[140] = 40'h3096529a80; sincos_rom_3[141] = 40'h30d78295b8; sincos_rom_3[142] = 40'h31184290e9; sincos_rom_3[143] = 40'h3158828c14;
        sincos_rom_3[144] = 40'h3198428739; sincos_rom_3[145] = 40'h31d7928257; sincos_rom_3[146] = 40'h3216627d70; sincos_rom_3[147] = 40'h3254c27882;
        sincos_rom_3[148] = 40'h329292738e; sincos_rom_3[149] = 40'h32cff26e94; sincos_rom_3[150] = 40'h330cd26994; sincos_rom_3[151] = 40'h334932648e;
        sincos_rom_3[152] = 40'h3385225f82; sincos_rom_3[153] = 40'h33c0825a70; sincos_rom_3[154] = 40'h33fb625558; sincos_rom_3[155] = 40'h3435d2503b;
        sincos_rom_3[156] = 40'h346fb24b18; sincos_rom_3[157] = 40'h34a91245ef; sincos_rom_3[158] = 40'h34e1f240c1; sincos_rom_3[159] = 40'h351a523b8d;
        sincos_rom_3[160] = 40'h3552323654; sincos_rom_3[161] = 40'h3589823115; sincos_rom_3[162] = 40'h35c0522bd1; sincos_rom_3[163] = 40'h35f6a22687;
        sincos_rom_3[164] = 40'h362c722138; sincos_rom_3[165] = 40'h3661b21be4; sincos_rom_3[166] = 40'h369672168b; sincos_rom_3[167] = 40'h36caa2112c;
        sincos_rom_3[168] = 40'h36fe520bc9; sincos_rom_3[169] = 40'h3731820660; sincos_rom_3[170] = 40'h37642200f2; sincos_rom_3[171] = 40'h379631fb80;
        sincos_rom_3[172] = 40'h37c7c1f608; sincos_rom_3[173] = 40'h37f8d1f08c; sincos_rom_3[174] = 40'h382941eb0b; sincos_rom_3[175] = 40'h385931e585;
        sincos_rom_3[176] = 40'h388891dffb; sincos_rom_3[177] = 40'h38b771da6b; sincos_rom_3[178] = 40'h38e5c1d4d8; sincos_rom_3[179] = 40'h391381cf3f;
        sincos_rom_3[180] = 40'h3940b1c9a3; sincos_rom_3[181] = 40'h396d61c402; sincos_rom_3[182] = 40'h399971be5c; sincos_rom_3[183] = 40'h39c501b8b2;
        sincos_rom_3[184] = 40'h39f001b304; sincos_rom_3[185] = 40'h3a1a71ad52; sincos_rom_3[186] = 40'h3a4441a79c; sincos_rom_3[187] = 40'h3a6d91a1e1;
        sincos_rom_3[188] = 40'h3a96519c23; sincos_rom_3[189] = 40'h3abe819660; sincos_rom_3[190] = 40'h3ae621909a; sincos_rom_3[191] = 40'h3b0d318ad0;
        sincos_rom_3[192] = 40'h3b33a18502; sincos_rom_3[193] = 40'h3b59917f30; sincos_rom_3[194] = 40'h3b7ee1795b; sincos_rom_3[195] = 40'h3ba3a17382;
        sincos_rom_3[196] = 40'h3bc7d16da5; sincos_rom_3[197] = 40'h3beb7167c5; sincos_rom_3[198] = 40'h3c0e7161e1; sincos_rom_3[199] = 40'h3c30f15bfa;
        sincos_rom_3[200] = 40'h3c52d1560f; sincos_rom_3[201] = 40'h3c74115022; sincos_rom_3[202] = 40'h3c94d14a31; sincos_rom_3[203] = 40'h3cb4f1443d;
        sincos_rom_3[204] = 40'h3cd4713e45; sincos_rom_3[205] = 40'h3cf361384b; sincos_rom_3[206] = 40'h3d11c1324e; sincos_rom_3[207] = 40'h3d2f912c4d;
        sincos_rom_3[208] = 40'h3d4cc1264a; sincos_rom_3[209] = 40'h3d69512044; sincos_rom_3[210] = 40'h3d85511a3b; sincos_rom_3[211] = 40'h3da0c11430;
        sincos_rom_3[212] = 40'h3dbb910e22; sincos_rom_3[213] = 40'h3dd5d10811; sincos_rom_3[214] = 40'h3def7101fd; sincos_rom_3[215] = 40'h3e0870fbe8;
        sincos_rom_3[216] = 40'h3e20e0f5cf; sincos_rom_3[217] = 40'h3e38b0efb5; sincos_rom_3[218] = 40'h3e4ff0e998; sincos_rom_3[219] = 40'h3e6690e378;
        sincos_rom_3[220] = 40'h3e7ca0dd57; sincos_rom_3[221] = 40'h3e9200d734; sincos_rom_3[222] = 40'h3ea6e0d10e; sincos_rom_3[223] = 40'h3ebb10cae6;
        sincos_rom_3[224] = 40'h3eceb0c4bd; sincos_rom_3[225] = 40'h3ee1b0be91; sincos_rom_3[226] = 40'h3ef420b864; sincos_rom_3[227] = 40'h3f05f0b235;
        sincos_rom_3[228] = 40'h3f1720ac04; sincos_rom_3[229] = 40'h3f27b0a5d2; sincos_rom_3[230] = 40'h3f37b09f9e; sincos_rom_3[231] = 40'h3f47009968;
        sincos_rom_3[232] = 40'h3f55c09331; sincos_rom_3[233] = 40'h3f63f08cf9; sincos_rom_3[234] = 40'h3f717086bf; sincos_rom_3[235] = 40'h3f7e608084;
        sincos_rom_3[236] = 40'h3f8ab07a47; sincos_rom_3[237] = 40'h3f9660740a; sincos_rom_3[238] = 40'h3fa1806dcb; sincos_rom_3[239] = 40'h3fabf0678b;
        sincos_rom_3[240] = 40'h3fb5d0614b; sincos_rom_3[241] = 40'h3fbf105b09; sincos_rom_3[242] = 40'h3fc7b054c6; sincos_rom_3[243] = 40'h3fcfb04e83;
        sincos_rom_3[244] = 40'h3fd720483f; sincos_rom_3[245] = 40'h3fdde041fa; sincos_rom_3[246] = 40'h3fe4103bb5; sincos_rom_3[247] = 40'h3fe9a0356f;
        sincos_rom_3[248] = 40'h3fee902f28; sincos_rom_3[249] = 40'h3ff2e028e1; sincos_rom_3[250] = 40'h3ff690229a; sincos_rom_3[251] = 40'h3ff9b01c52;
        sincos_rom_3[252] = 40'h3ffc20160a; sincos_rom_3[253] = 40'h3ffe000fc2; sincos_rom_3[254] = 40'h3fff400979; sincos_rom_3[255] = 40'h3fffe00331;
        sincos_rom_3[256] = 40'h3fffeffce8; sincos_rom_3[257] = 40'h3fff4ff6a0; sincos_rom_3[258] = 40'h3ffe0ff058; sincos_rom_3[259] = 40'h3ffc3fea0f;
        sincos_rom_3[260] = 40'h3ff9bfe3c7; sincos_rom_3[261] = 40'h3ff6afdd80; sincos_rom_3[262] = 40'h3ff2ffd738; sincos_rom_3[263] = 40'h3feeafd0f1;
        sincos_rom_3[264] = 40'h3fe9bfcaab; sincos_rom_3[265] = 40'h3fe42fc465; sincos_rom_3[266] = 40'h3fde0fbe1f; sincos_rom_3[267] = 40'h3fd73fb7da;
        sincos_rom_3[268] = 40'h3fcfdfb196; sincos_rom_3[269] = 40'h3fc7dfab53; sincos_rom_3[270] = 40'h3fbf3fa510; sincos_rom_3[271] = 40'h3fb5ff9ecf;
        sincos_rom_3[272] = 40'h3fac2f988e; sincos_rom_3[273] = 40'h3fa1af924e; sincos_rom_3[274] = 40'h3f969f8c0f; sincos_rom_3[275] = 40'h3f8aef85d2;
        sincos_rom_3[276] = 40'h3f7e9f7f95; sincos_rom_3[277] = 40'h3f71bf795a; sincos_rom_3[278] = 40'h3f642f7320; sincos_rom_3[279] = 40'h3f560f6ce8;
        sincos_rom_3[280] = 40'h3f474f66b1; sincos_rom_3[281] = 40'h3f37ef607b; sincos_rom_3[282] = 40'h3f27ff5a47; sincos_rom_3[283] = 40'h3f176f5415;
        sincos_rom_3[284] = 40'h3f063f4de4; sincos_rom_3[285] = 40'h3ef46f47b5; sincos_rom_3[286] = 40'h3ee20f4187; sincos_rom_3[287] = 40'h3ecf0f3b5c;
        sincos_rom_3[288] = 40'h3ebb6f3532; sincos_rom_3[289] = 40'h3ea73f2f0b; sincos_rom_3[290] = 40'h3e926f28e5; sincos_rom_3[291] = 40'h3e7cff22c1;
        sincos_rom_3[292] = 40'h3e66ff1ca0; sincos_rom_3[293] = 40'h3e505f1681; sincos_rom_3[294] = 40'h3e391f1064; sincos_rom_3[295] = 40'h3e214f0a49;
        sincos_rom_3[296] = 40'h3e08df0431; sincos_rom_3[297] = 40'h3defdefe1b; sincos_rom_3[298] = 40'h3dd63ef808; sincos_rom_3[299] = 40'h3dbc0ef1f7;
        sincos_rom_3[300] = 40'h3da13eebe8; sincos_rom_3[301] = 40'h3d85cee5dd; sincos_rom_3[302] = 40'h3d69cedfd4; sincos_rom_3[303] = 40'h3d4d3ed9ce;
        sincos_rom_3[304] = 40'h3d300ed3cb; sincos_rom_3[305] = 40'h3d124ecdca; sincos_rom_3[306] = 40'h3cf3eec7cd; sincos_rom_3[307] = 40'h3cd4fec1d3;
        sincos_rom_3[308] = 40'h3cb57ebbdb; sincos_rom_3[309] = 40'h3c955eb5e7; sincos_rom_3[310] = 40'h3c749eaff6; sincos_rom_3[311] = 40'h3c535eaa08;
        sincos_rom_3[312] = 40'h3c317ea41e; sincos_rom_3[313] = 40'h3c0f0e9e37; sincos_rom_3[314] = 40'h3bec0e9853; sincos_rom_3[315] = 40'h3bc86e9273;
        sincos_rom_3[316] = 40'h3ba43e8c96; sincos_rom_3[317] = 40'h3b7f7e86bd; sincos_rom_3[318] = 40'h3b5a2e80e7; sincos_rom_3[319] = 40'h3b344e7b15;
        sincos_rom_3[320] = 40'h3b0dce7547; sincos_rom_3[321] = 40'h3ae6ce6f7d; sincos_rom_3[322] = 40'h3abf2e69b7; sincos_rom_3[323] = 40'h3a96fe63f4;
        sincos_rom_3[324] = 40'h3a6e4e5e36; sincos_rom_3[325] = 40'h3a44fe587b; sincos_rom_3[326] = 40'h3a1b1e52c5; sincos_rom_3[327] = 40'h39f0ae4d12;
        sincos_rom_3[328] = 40'h39c5be4764; sincos_rom_3[329] = 40'h399a2e41bb; sincos_rom_3[330] = 40'h396e1e3c15; sincos_rom_3[331] = 40'h39416e3674;
        sincos_rom_3[332] = 40'h39143e30d7; sincos_rom_3[333] = 40'h38e67e2b3f; sincos_rom_3[334] = 40'h38b83e25ab; sincos_rom_3[335] = 40'h38895e201c;
        sincos_rom_3[336] = 40'h3859fe1a91; sincos_rom_3[337] = 40'h382a0e150b; sincos_rom_3[338] = 40'h37f99e0f8a; sincos_rom_3[339] = 40'h37c89e0a0e;
        sincos_rom_3[340] = 40'h37970e0496; sincos_rom_3[341] = 40'h3764edff23; sincos_rom_3[342] = 40'h37325df9b6; sincos_rom_3[343] = 40'h36ff2df44d;
        sincos_rom_3[344] = 40'h36cb7deee9; sincos_rom_3[345] = 40'h36974de98b; sincos_rom_3[346] = 40'h36628de431; sincos_rom_3[347] = 40'h362d4ddedd;
        sincos_rom_3[348] = 40'h35f78dd98e; sincos_rom_3[349] = 40'h35c13dd444; sincos_rom_3[350] = 40'h358a6dcf00; sincos_rom_3[351] = 40'h35531dc9c1;
        sincos_rom_3[352] = 40'h351b3dc488; sincos_rom_3[353] = 40'h34e2ddbf54; sincos_rom_3[354] = 40'h34a9fdba25; sincos_rom_3[355] = 40'h34709db4fd;
        sincos_rom_3[356] = 40'h3436bdafd9; sincos_rom_3[357] = 40'h33fc5daabc; sincos_rom_3[358] = 40'h33c17da5a4; sincos_rom_3[359] = 40'h33861da093;
        sincos_rom_3[360] = 40'h334a3d9b87; sincos_rom_3[361] = 40'h330dcd9680; sincos_rom_3[362] = 40'h32d0fd9180; sincos_rom_3[363] = 40'h32939d8c86;
        sincos_rom_3[364] = 40'h3255bd8792; sincos_rom_3[365] = 40'h32176d82a4; sincos_rom_3[366] = 40'h31d89d7dbc; sincos_rom_3[367] = 40'h31994d78db;
        sincos_rom_3[368] = 40'h31598d73ff; sincos_rom_3[369] = 40'h31194d6f2a; sincos_rom_3[370] = 40'h30d88d6a5b; sincos_rom_3[371] = 40'h30975d6593;
        sincos_rom_3[372] = 40'h3055bd60d1; sincos_rom_3[373] = 40'h30139d5c15; sincos_rom_3[374] = 40'h2fd0fd5760; sincos_rom_3[375] = 40'h2f8dfd52b2;
        sincos_rom_3[376] = 40'h2f4a6d4e0a; sincos_rom_3[377] = 40'h2f067d4969; sincos_rom_3[378] = 40'h2ec20d44ce; sincos_rom_3[379] = 40'h2e7d2d403a;
        sincos_rom_3[380] = 40'h2e37dd3bad; sincos_rom_3[381] = 40'h2df21d3727; sincos_rom_3[382] = 40'h2dabed32a8; sincos_rom_3[383] = 40'h2d654d2e30;
        sincos_rom_3[384] = 40'h2d1e2d29be; sincos_rom_3[385] = 40'h2cd6ad2554; sincos_rom_3[386] = 40'h2c8ebd20f0; sincos_rom_3[387] = 40'h2c465d1c94;
        sincos_rom_3[388] = 40'h2bfd8d183f; sincos_rom_3[389] = 40'h2bb44d13f1; sincos_rom_3[390] = 40'h2b6aad0faa; sincos_rom_3[391] = 40'h2b209d0b6a;
        sincos_rom_3[392] = 40'h2ad61d0732; sincos_rom_3[393] = 40'h2a8b3d0301; sincos_rom_3[394] = 40'h2a3fecfed8; sincos_rom_3[395] = 40'h29f42cfab6;
        sincos_rom_3[396] = 40'h29a80cf69b; sincos_rom_3[397] = 40'h295b8cf288; sincos_rom_3[398] = 40'h290e9cee7c; sincos_rom_3[399] = 40'h28c14cea78;
        sincos_rom_3[400] = 40'h28739ce67c; sincos_rom_3[401] = 40'h28257ce287; sincos_rom_3[402] = 40'h27d70cde9a; sincos_rom_3[403] = 40'h27882cdab4;
        sincos_rom_3[404] = 40'h2738ecd6d7; sincos_rom_3[405] = 40'h26e94cd301; sincos_rom_3[406] = 40'h26994ccf33; sincos_rom_3[407] = 40'h2648eccb6d;
        sincos_rom_3[408] = 40'h25f82cc7ae; sincos_rom_3[409] = 40'h25a70cc3f8; sincos_rom_3[410] = 40'h25558cc04a; sincos_rom_3[411] = 40'h2503bcbca3;
        sincos_rom_3[412] = 40'h24b18cb905; sincos_rom_3[413] = 40'h245efcb56f; sincos_rom_3[414] = 40'h240c1cb1e1; sincos_rom_3[415] = 40'h23b8dcae5b;
        sincos_rom_3[416] = 40'h23654caadd; sincos_rom_3[417] = 40'h23115ca768; sincos_rom_3[418] = 40'h22bd1ca3fb; sincos_rom_3[419] = 40'h22687ca096;
        sincos_rom_3[420] = 40'h22138c9d39; sincos_rom_3[421] = 40'h21be4c99e5; sincos_rom_3[422] = 40'h2168bc9699; sincos_rom_3[423] = 40'h2112cc9356;
        sincos_rom_3[424] = 40'h20bc9c901b; sincos_rom_3[425] = 40'h20660c8ce8; sincos_rom_3[426] = 40'h200f2c89be; sincos_rom_3[427] = 40'h1fb80c869d;
        sincos_rom_3[428] = 40'h1f608c8384; sincos_rom_3[429] = 40'h1f08cc8073; sincos_rom_3[430] = 40'h1eb0bc7d6c; sincos_rom_3[431] = 40'h1e585c7a6d;
        sincos_rom_3[432] = 40'h1dffbc7777; sincos_rom_3[433] = 40'h1da6bc7489; sincos_rom_3[434] = 40'h1d4d8c71a4; sincos_rom_3[435] = 40'h1cf3fc6ec8;
        sincos_rom_3[436] = 40'h1c9a3c6bf5; sincos_rom_3[437] = 40'h1c402c692a; sincos_rom_3[438] = 40'h1be5cc6669; sincos_rom_3[439] = 40'h1b8b2c63b0;
        sincos_rom_3[440] = 40'h1b304c6100; sincos_rom_3[441] = 40'h1ad52c5e59; sincos_rom_3[442] = 40'h1a79cc5bbc; sincos_rom_3[443] = 40'h1a1e1c5927;
        sincos_rom_3[444] = 40'h19c23c569b; sincos_rom_3[445] = 40'h19660c5418; sincos_rom_3[446] = 40'h1909ac519e; sincos_rom_3[447] = 40'h18ad0c4f2d;
        sincos_rom_3[448] = 40'h18502c4cc6; sincos_rom_3[449] = 40'h17f30c4a67; sincos_rom_3[450] = 40'h1795bc4812; sincos_rom_3[451] = 40'h17382c45c6;
        sincos_rom_3[452] = 40'h16da5c4383; sincos_rom_3[453] = 40'h167c5c4149; sincos_rom_3[454] = 40'h161e1c3f19; sincos_rom_3[455] = 40'h15bfac3cf1;
        sincos_rom_3[456] = 40'h1560fc3ad3; sincos_rom_3[457] = 40'h15022c38bf; sincos_rom_3[458] = 40'h14a31c36b3; sincos_rom_3[459] = 40'h1443dc34b1;
        sincos_rom_3[460] = 40'h13e45c32b9; sincos_rom_3[461] = 40'h1384bc30ca; sincos_rom_3[462] = 40'h1324ec2ee4; sincos_rom_3[463] = 40'h12c4dc2d07;
        sincos_rom_3[464] = 40'h1264ac2b34; sincos_rom_3[465] = 40'h12044c296b; sincos_rom_3[466] = 40'h11a3bc27ab; sincos_rom_3[467] = 40'h11430c25f4;
        sincos_rom_3[468] = 40'h10e22c2447; sincos_rom_3[469] = 40'h10811c22a3; sincos_rom_3[470] = 40'h101fdc2109; sincos_rom_3[471] = 40'h0fbe8c1f79;
        sincos_rom_3[472] = 40'h0f5cfc1df2; sincos_rom_3[473] = 40'h0efb5c1c75; sincos_rom_3[474] = 40'h0e998c1b01; sincos_rom_3[475] = 40'h0e378c1997;
        sincos_rom_3[476] = 40'h0dd57c1836; sincos_rom_3[477] = 40'h0d734c16e0; sincos_rom_3[478] = 40'h0d10ec1592; sincos_rom_3[479] = 40'h0cae6c144f;
        sincos_rom_3[480] = 40'h0c4bdc1315; sincos_rom_3[481] = 40'h0be91c11e5; sincos_rom_3[482] = 40'h0b864c10be; sincos_rom_3[483] = 40'h0b235c0fa1;
        sincos_rom_3[484] = 40'h0ac04c0e8e; sincos_rom_3[485] = 40'h0a5d2c0d85; sincos_rom_3[486] = 40'h09f9ec0c85; sincos_rom_3[487] = 40'h09968c0b90;
        sincos_rom_3[488] = 40'h09331c0aa4; sincos_rom_3[489] = 40'h08cf9c09c1; sincos_rom_3[490] = 40'h086bfc08e9; sincos_rom_3[491] = 40'h08084c081a;
        sincos_rom_3[492] = 40'h07a47c0755; sincos_rom_3[493] = 40'h0740ac069a; sincos_rom_3[494] = 40'h06dcbc05e8; sincos_rom_3[495] = 40'h0678bc0541;
        sincos_rom_3[496] = 40'h0614bc04a3; sincos_rom_3[497] = 40'h05b09c040f; sincos_rom_3[498] = 40'h054c6c0385; sincos_rom_3[499] = 40'h04e83c0305;
        sincos_rom_3[500] = 40'h0483fc028e; sincos_rom_3[501] = 40'h041fac0222; sincos_rom_3[502] = 40'h03bb5c01bf; sincos_rom_3[503] = 40'h0356fc0166;
        sincos_rom_3[504] = 40'h02f28c0117; sincos_rom_3[505] = 40'h028e1c00d2; sincos_rom_3[506] = 40'h0229ac0097; sincos_rom_3[507] = 40'h01c52c0065;
        sincos_rom_3[508] = 40'h0160ac003e; sincos_rom_3[509] = 40'h00fc2c0020; sincos_rom_3[510] = 40'h00979c000c; sincos_rom_3[511] = 40'h00331c0002;
        sincos_rom_3[512] = 40'hffce8c0002; sincos_rom_3[513] = 40'hff6a0c000c; sincos_rom_3[514] = 40'hff058c0020; sincos_rom_3[515] = 40'hfea0fc003d;
        sincos_rom_3[516] = 40'hfe3c7c0065; sincos_rom_3[517] = 40'hfdd80c0096; sincos_rom_3[518] = 40'hfd738c00d1; sincos_rom_3[519] = 40'hfd0f1c0116;
        sincos_rom_3[520] = 40'hfcaabc0165; sincos_rom_3[521] = 40'hfc465c01be; sincos_rom_3[522] = 40'hfbe1fc0220; sincos_rom_3[523] = 40'hfb7dac028d;
        sincos_rom_3[524] = 40'hfb196c0303; sincos_rom_3[525] = 40'hfab53c0383; sincos_rom_3[526] = 40'hfa510c040d; sincos_rom_3[527] = 40'hf9ecfc04a1;
        sincos_rom_3[528] = 40'hf988ec053e; sincos_rom_3[529] = 40'hf924ec05e6; sincos_rom_3[530] = 40'hf8c0fc0697; sincos_rom_3[531] = 40'hf85d2c0752;
        sincos_rom_3[532] = 40'hf7f95c0817; sincos_rom_3[533] = 40'hf795ac08e5; sincos_rom_3[534] = 40'hf7320c09be; sincos_rom_3[535] = 40'hf6ce8c0aa0;
        sincos_rom_3[536] = 40'hf66b1c0b8c; sincos_rom_3[537] = 40'hf607bc0c82; sincos_rom_3[538] = 40'hf5a47c0d81; sincos_rom_3[539] = 40'hf5415c0e8a;
        sincos_rom_3[540] = 40'hf4de4c0f9d; sincos_rom_3[541] = 40'hf47b5c10ba; sincos_rom_3[542] = 40'hf4187c11e0; sincos_rom_3[543] = 40'hf3b5cc1310;
        sincos_rom_3[544] = 40'hf3532c144a; sincos_rom_3[545] = 40'hf2f0bc158d; sincos_rom_3[546] = 40'hf28e5c16da; sincos_rom_3[547] = 40'hf22c1c1831;
        sincos_rom_3[548] = 40'hf1ca0c1991; sincos_rom_3[549] = 40'hf1681c1afb; sincos_rom_3[550] = 40'hf1064c1c6f; sincos_rom_3[551] = 40'hf0a49c1dec;
        sincos_rom_3[552] = 40'hf0431c1f73; sincos_rom_3[553] = 40'hefe1bc2103; sincos_rom_3[554] = 40'hef808c229d; sincos_rom_3[555] = 40'hef1f7c2440;
        sincos_rom_3[556] = 40'heebe8c25ed; sincos_rom_3[557] = 40'hee5ddc27a4; sincos_rom_3[558] = 40'hedfd4c2964; sincos_rom_3[559] = 40'hed9cec2b2d;
        sincos_rom_3[560] = 40'hed3cbc2d00; sincos_rom_3[561] = 40'hecdcac2edc; sincos_rom_3[562] = 40'hec7cdc30c2; sincos_rom_3[563] = 40'hec1d3c32b1;
        sincos_rom_3[564] = 40'hebbdbc34a9; sincos_rom_3[565] = 40'heb5e7c36ab; sincos_rom_3[566] = 40'heaff6c38b7; sincos_rom_3[567] = 40'heaa08c3acb;
        sincos_rom_3[568] = 40'hea41ec3ce9; sincos_rom_3[569] = 40'he9e37c3f10; sincos_rom_3[570] = 40'he9853c4140; sincos_rom_3[571] = 40'he9273c437a;
        sincos_rom_3[572] = 40'he8c96c45bd; sincos_rom_3[573] = 40'he86bdc4809; sincos_rom_3[574] = 40'he80e7c4a5e; sincos_rom_3[575] = 40'he7b15c4cbc;
        sincos_rom_3[576] = 40'he7547c4f24; sincos_rom_3[577] = 40'he6f7dc5194; sincos_rom_3[578] = 40'he69b7c540e; sincos_rom_3[579] = 40'he63f4c5691;
        sincos_rom_3[580] = 40'he5e36c591c; sincos_rom_3[581] = 40'he587bc5bb1; sincos_rom_3[582] = 40'he52c5c5e4f; sincos_rom_3[583] = 40'he4d12c60f6;
        sincos_rom_3[584] = 40'he4764c63a5; sincos_rom_3[585] = 40'he41bbc665e; sincos_rom_3[586] = 40'he3c15c691f; sincos_rom_3[587] = 40'he3674c6bea;
        sincos_rom_3[588] = 40'he30d7c6ebd; sincos_rom_3[589] = 40'he2b3fc7199; sincos_rom_3[590] = 40'he25abc747d; sincos_rom_3[591] = 40'he201cc776b;
        sincos_rom_3[592] = 40'he1a91c7a61; sincos_rom_3[593] = 40'he150bc7d60; sincos_rom_3[594] = 40'he0f8ac8067; sincos_rom_3[595] = 40'he0a0ec8377;
        sincos_rom_3[596] = 40'he0496c8690; sincos_rom_3[597] = 40'hdff23c89b2; sincos_rom_3[598] = 40'hdf9b6c8cdb; sincos_rom_3[599] = 40'hdf44dc900e;
        sincos_rom_3[600] = 40'hdeee9c9349; sincos_rom_3[601] = 40'hde98bc968c; sincos_rom_3[602] = 40'hde431c99d8; sincos_rom_3[603] = 40'hddeddc9d2c;
        sincos_rom_3[604] = 40'hdd98eca088; sincos_rom_3[605] = 40'hdd444ca3ed; sincos_rom_3[606] = 40'hdcf00ca75a; sincos_rom_3[607] = 40'hdc9c1caacf;
        sincos_rom_3[608] = 40'hdc488cae4d; sincos_rom_3[609] = 40'hdbf54cb1d3; sincos_rom_3[610] = 40'hdba25cb561; sincos_rom_3[611] = 40'hdb4fdcb8f7;
        sincos_rom_3[612] = 40'hdafd9cbc95; sincos_rom_3[613] = 40'hdaabccc03b; sincos_rom_3[614] = 40'hda5a4cc3e9; sincos_rom_3[615] = 40'hda093cc79f;
        sincos_rom_3[616] = 40'hd9b87ccb5d; sincos_rom_3[617] = 40'hd9680ccf24; sincos_rom_3[618] = 40'hd9180cd2f1; sincos_rom_3[619] = 40'hd8c86cd6c7;
        sincos_rom_3[620] = 40'hd8792cdaa5; sincos_rom_3[621] = 40'hd82a4cde8a; sincos_rom_3[622] = 40'hd7dbcce277; sincos_rom_3[623] = 40'hd78dbce66c;
        sincos_rom_3[624] = 40'hd73ffcea68; sincos_rom_3[625] = 40'hd6f2acee6c; sincos_rom_3[626] = 40'hd6a5bcf278; sincos_rom_3[627] = 40'hd6593cf68b;
        sincos_rom_3[628] = 40'hd60d1cfaa5; sincos_rom_3[629] = 40'hd5c15cfec7; sincos_rom_3[630] = 40'hd5760d02f1; sincos_rom_3[631] = 40'hd52b2d0721;
        sincos_rom_3[632] = 40'hd4e0ad0b5a; sincos_rom_3[633] = 40'hd4969d0f99; sincos_rom_3[634] = 40'hd44ced13e0; sincos_rom_3[635] = 40'hd403ad182e;
        sincos_rom_3[636] = 40'hd3badd1c83; sincos_rom_3[637] = 40'hd3727d20df; sincos_rom_3[638] = 40'hd32a8d2542; sincos_rom_3[639] = 40'hd2e30d29ac;
        sincos_rom_3[640] = 40'hd29bed2e1e; sincos_rom_3[641] = 40'hd2554d3296; sincos_rom_3[642] = 40'hd20f0d3715; sincos_rom_3[643] = 40'hd1c94d3b9b;
        sincos_rom_3[644] = 40'hd183fd4028; sincos_rom_3[645] = 40'hd13f1d44bc; sincos_rom_3[646] = 40'hd0faad4956; sincos_rom_3[647] = 40'hd0b6ad4df7;
        sincos_rom_3[648] = 40'hd0732d529f; sincos_rom_3[649] = 40'hd0301d574d; sincos_rom_3[650] = 40'hcfed8d5c02; sincos_rom_3[651] = 40'hcfab6d60be;
        sincos_rom_3[652] = 40'hcf69bd6580; sincos_rom_3[653] = 40'hcf288d6a48; sincos_rom_3[654] = 40'hcee7cd6f17; sincos_rom_3[655] = 40'hcea78d73ec;
        sincos_rom_3[656] = 40'hce67cd78c7; sincos_rom_3[657] = 40'hce287d7da9; sincos_rom_3[658] = 40'hcde9ad8290; sincos_rom_3[659] = 40'hcdab4d877e;
        sincos_rom_3[660] = 40'hcd6d7d8c72; sincos_rom_3[661] = 40'hcd301d916c; sincos_rom_3[662] = 40'hccf33d966c; sincos_rom_3[663] = 40'hccb6dd9b72;
        sincos_rom_3[664] = 40'hcc7aeda07e; sincos_rom_3[665] = 40'hcc3f8da590; sincos_rom_3[666] = 40'hcc04adaaa8; sincos_rom_3[667] = 40'hcbca3dafc5;
        sincos_rom_3[668] = 40'hcb905db4e8; sincos_rom_3[669] = 40'hcb56fdba11; sincos_rom_3[670] = 40'hcb1e1dbf3f; sincos_rom_3[671] = 40'hcae5bdc473;
        sincos_rom_3[672] = 40'hcaadddc9ac; sincos_rom_3[673] = 40'hca768dceeb; sincos_rom_3[674] = 40'hca3fbdd42f; sincos_rom_3[675] = 40'hca096dd979;
        sincos_rom_3[676] = 40'hc9d39ddec8; sincos_rom_3[677] = 40'hc99e5de41c; sincos_rom_3[678] = 40'hc9699de975; sincos_rom_3[679] = 40'hc9356deed4;
        sincos_rom_3[680] = 40'hc901bdf437; sincos_rom_3[681] = 40'hc8ce8df9a0; sincos_rom_3[682] = 40'hc89bedff0e; sincos_rom_3[683] = 40'hc869de0480;
        sincos_rom_3[684] = 40'hc8384e09f8; sincos_rom_3[685] = 40'hc8073e0f74; sincos_rom_3[686] = 40'hc7d6ce14f5; sincos_rom_3[687] = 40'hc7a6de1a7b;
        sincos_rom_3[688] = 40'hc7777e2005; sincos_rom_3[689] = 40'hc7489e2595; sincos_rom_3[690] = 40'hc71a4e2b28; sincos_rom_3[691] = 40'hc6ec8e30c1;
        sincos_rom_3[692] = 40'hc6bf5e365d; sincos_rom_3[693] = 40'hc692ae3bfe; sincos_rom_3[694] = 40'hc6669e41a4; sincos_rom_3[695] = 40'hc63b0e474e;
        sincos_rom_3[696] = 40'hc6100e4cfc; sincos_rom_3[697] = 40'hc5e59e52ae; sincos_rom_3[698] = 40'hc5bbce5864; sincos_rom_3[699] = 40'hc5927e5e1f;
        sincos_rom_3[700] = 40'hc569be63dd; sincos_rom_3[701] = 40'hc5418e69a0; sincos_rom_3[702] = 40'hc519ee6f66; sincos_rom_3[703] = 40'hc4f2de7530;
        sincos_rom_3[704] = 40'hc4cc6e7afe; sincos_rom_3[705] = 40'hc4a67e80d0; sincos_rom_3[706] = 40'hc4812e86a5; sincos_rom_3[707] = 40'hc45c6e8c7e;
        sincos_rom_3[708] = 40'hc4383e925b; sincos_rom_3[709] = 40'hc4149e983b; sincos_rom_3[710] = 40'hc3f19e9e1f; sincos_rom_3[711] = 40'hc3cf1ea406;
        sincos_rom_3[712] = 40'hc3ad3ea9f1; sincos_rom_3[713] = 40'hc38bfeafde; sincos_rom_3[714] = 40'hc36b3eb5cf; sincos_rom_3[715] = 40'hc34b1ebbc3;
        sincos_rom_3[716] = 40'hc32b9ec1bb; sincos_rom_3[717] = 40'hc30caec7b5; sincos_rom_3[718] = 40'hc2ee4ecdb2; sincos_rom_3[719] = 40'hc2d07ed3b3;
        sincos_rom_3[720] = 40'hc2b34ed9b6; sincos_rom_3[721] = 40'hc296bedfbc; sincos_rom_3[722] = 40'hc27abee5c5; sincos_rom_3[723] = 40'hc25f4eebd0;
        sincos_rom_3[724] = 40'hc2447ef1de; sincos_rom_3[725] = 40'hc22a3ef7ef; sincos_rom_3[726] = 40'hc2109efe03; sincos_rom_3[727] = 40'hc1f79f0418;
        sincos_rom_3[728] = 40'hc1df2f0a31; sincos_rom_3[729] = 40'hc1c75f104b; sincos_rom_3[730] = 40'hc1b01f1668; sincos_rom_3[731] = 40'hc1997f1c88;
        sincos_rom_3[732] = 40'hc1836f22a9; sincos_rom_3[733] = 40'hc16e0f28cc; sincos_rom_3[734] = 40'hc1592f2ef2; sincos_rom_3[735] = 40'hc144ff351a;
        sincos_rom_3[736] = 40'hc1315f3b43; sincos_rom_3[737] = 40'hc11e5f416f; sincos_rom_3[738] = 40'hc10bef479c; sincos_rom_3[739] = 40'hc0fa1f4dcb;
        sincos_rom_3[740] = 40'hc0e8ef53fc; sincos_rom_3[741] = 40'hc0d85f5a2e; sincos_rom_3[742] = 40'hc0c85f6062; sincos_rom_3[743] = 40'hc0b90f6698;
        sincos_rom_3[744] = 40'hc0aa4f6ccf; sincos_rom_3[745] = 40'hc09c1f7307; sincos_rom_3[746] = 40'hc08e9f7941; sincos_rom_3[747] = 40'hc081af7f7c;
        sincos_rom_3[748] = 40'hc0755f85b9; sincos_rom_3[749] = 40'hc069af8bf6; sincos_rom_3[750] = 40'hc05e8f9235; sincos_rom_3[751] = 40'hc0541f9875;
        sincos_rom_3[752] = 40'hc04a3f9eb5; sincos_rom_3[753] = 40'hc040ffa4f7; sincos_rom_3[754] = 40'hc0385fab3a; sincos_rom_3[755] = 40'hc0305fb17d;
        sincos_rom_3[756] = 40'hc028efb7c1; sincos_rom_3[757] = 40'hc0222fbe06; sincos_rom_3[758] = 40'hc01bffc44b; sincos_rom_3[759] = 40'hc0166fca91;
        sincos_rom_3[760] = 40'hc0117fd0d8; sincos_rom_3[761] = 40'hc00d2fd71f; sincos_rom_3[762] = 40'hc0097fdd66; sincos_rom_3[763] = 40'hc0065fe3ae;
        sincos_rom_3[764] = 40'hc003efe9f6; sincos_rom_3[765] = 40'hc0020ff03e; sincos_rom_3[766] = 40'hc000cff687; sincos_rom_3[767] = 40'hc0002ffccf;
        sincos_rom_3[768] = 40'hc000200318; sincos_rom_3[769] = 40'hc000c00960; sincos_rom_3[770] = 40'hc002000fa8; sincos_rom_3[771] = 40'hc003d015f1;
        sincos_rom_3[772] = 40'hc006501c39; sincos_rom_3[773] = 40'hc009602280; sincos_rom_3[774] = 40'hc00d1028c8; sincos_rom_3[775] = 40'hc011602f0f;
        sincos_rom_3[776] = 40'hc016503555; sincos_rom_3[777] = 40'hc01be03b9b; sincos_rom_3[778] = 40'hc0220041e1; sincos_rom_3[779] = 40'hc028d04826;
        sincos_rom_3[780] = 40'hc030304e6a; sincos_rom_3[781] = 40'hc0383054ad; sincos_rom_3[782] = 40'hc040d05af0; sincos_rom_3[783] = 40'hc04a106131;
        sincos_rom_3[784] = 40'hc053e06772; sincos_rom_3[785] = 40'hc05e606db2; sincos_rom_3[786] = 40'hc0697073f1; sincos_rom_3[787] = 40'hc075207a2e;
        sincos_rom_3[788] = 40'hc08170806b; sincos_rom_3[789] = 40'hc08e5086a6; sincos_rom_3[790] = 40'hc09be08ce0; sincos_rom_3[791] = 40'hc0aa009318;
        sincos_rom_3[792] = 40'hc0b8c0994f; sincos_rom_3[793] = 40'hc0c8209f85; sincos_rom_3[794] = 40'hc0d810a5b9; sincos_rom_3[795] = 40'hc0e8a0abeb;
        sincos_rom_3[796] = 40'hc0f9d0b21c; sincos_rom_3[797] = 40'hc10ba0b84b; sincos_rom_3[798] = 40'hc11e00be79; sincos_rom_3[799] = 40'hc13100c4a4;
        sincos_rom_3[800] = 40'hc144a0cace; sincos_rom_3[801] = 40'hc158d0d0f5; sincos_rom_3[802] = 40'hc16da0d71b; sincos_rom_3[803] = 40'hc18310dd3f;
        sincos_rom_3[804] = 40'hc19910e360; sincos_rom_3[805] = 40'hc1afb0e97f; sincos_rom_3[806] = 40'hc1c6f0ef9c; sincos_rom_3[807] = 40'hc1dec0f5b7;
        sincos_rom_3[808] = 40'hc1f730fbcf; sincos_rom_3[809] = 40'hc2103101e5; sincos_rom_3[810] = 40'hc229d107f8; sincos_rom_3[811] = 40'hc244010e09;
        sincos_rom_3[812] = 40'hc25ed11418; sincos_rom_3[813] = 40'hc27a411a23; sincos_rom_3[814] = 40'hc29641202c; sincos_rom_3[815] = 40'hc2b2d12632;
        sincos_rom_3[816] = 40'hc2d0012c35; sincos_rom_3[817] = 40'hc2edc13236; sincos_rom_3[818] = 40'hc30c213833; sincos_rom_3[819] = 40'hc32b113e2d;
        sincos_rom_3[820] = 40'hc34a914425; sincos_rom_3[821] = 40'hc36ab14a19; sincos_rom_3[822] = 40'hc38b71500a; sincos_rom_3[823] = 40'hc3acb155f8;
        sincos_rom_3[824] = 40'hc3ce915be2; sincos_rom_3[825] = 40'hc3f10161c9; sincos_rom_3[826] = 40'hc4140167ad; sincos_rom_3[827] = 40'hc437a16d8d;
        sincos_rom_3[828] = 40'hc45bd1736a; sincos_rom_3[829] = 40'hc480917943; sincos_rom_3[830] = 40'hc4a5e17f19; sincos_rom_3[831] = 40'hc4cbc184eb;
        sincos_rom_3[832] = 40'hc4f2418ab9; sincos_rom_3[833] = 40'hc519419083; sincos_rom_3[834] = 40'hc540e19649; sincos_rom_3[835] = 40'hc569119c0c;
        sincos_rom_3[836] = 40'hc591c1a1ca; sincos_rom_3[837] = 40'hc5bb11a785; sincos_rom_3[838] = 40'hc5e4f1ad3b; sincos_rom_3[839] = 40'hc60f61b2ee;
        sincos_rom_3[840] = 40'hc63a51b89c; sincos_rom_3[841] = 40'hc665e1be45; sincos_rom_3[842] = 40'hc691f1c3eb; sincos_rom_3[843] = 40'hc6bea1c98c;
        sincos_rom_3[844] = 40'hc6ebd1cf29; sincos_rom_3[845] = 40'hc71991d4c1; sincos_rom_3[846] = 40'hc747d1da55; sincos_rom_3[847] = 40'hc776b1dfe4;
        sincos_rom_3[848] = 40'hc7a611e56f; sincos_rom_3[849] = 40'hc7d601eaf5; sincos_rom_3[850] = 40'hc80671f076; sincos_rom_3[851] = 40'hc83771f5f2;
        sincos_rom_3[852] = 40'hc86901fb6a; sincos_rom_3[853] = 40'hc89b2200dd; sincos_rom_3[854] = 40'hc8cdb2064a; sincos_rom_3[855] = 40'hc900e20bb3;
        sincos_rom_3[856] = 40'hc934921117; sincos_rom_3[857] = 40'hc968c21675; sincos_rom_3[858] = 40'hc99d821bcf; sincos_rom_3[859] = 40'hc9d2c22123;
        sincos_rom_3[860] = 40'hca08822672; sincos_rom_3[861] = 40'hca3ed22bbc; sincos_rom_3[862] = 40'hca75a23100; sincos_rom_3[863] = 40'hcaacf2363f;
        sincos_rom_3[864] = 40'hcae4d23b78; sincos_rom_3[865] = 40'hcb1d3240ac; sincos_rom_3[866] = 40'hcb561245db; sincos_rom_3[867] = 40'hcb8f724b03;
        sincos_rom_3[868] = 40'hcbc9525027; sincos_rom_3[869] = 40'hcc03b25544; sincos_rom_3[870] = 40'hcc3e925a5c; sincos_rom_3[871] = 40'hcc79f25f6d;
        sincos_rom_3[872] = 40'hccb5d26479; sincos_rom_3[873] = 40'hccf2426980; sincos_rom_3[874] = 40'hcd2f126e80; sincos_rom_3[875] = 40'hcd6c72737a;
        sincos_rom_3[876] = 40'hcdaa52786e; sincos_rom_3[877] = 40'hcde8a27d5c; sincos_rom_3[878] = 40'hce27728244; sincos_rom_3[879] = 40'hce66c28725;
        sincos_rom_3[880] = 40'hcea6828c01; sincos_rom_3[881] = 40'hcee6c290d6; sincos_rom_3[882] = 40'hcf278295a5; sincos_rom_3[883] = 40'hcf68b29a6d;
        sincos_rom_3[884] = 40'hcfaa529f2f; sincos_rom_3[885] = 40'hcfec72a3eb; sincos_rom_3[886] = 40'hd02f12a8a0; sincos_rom_3[887] = 40'hd07212ad4e;
        sincos_rom_3[888] = 40'hd0b5a2b1f6; sincos_rom_3[889] = 40'hd0f992b697; sincos_rom_3[890] = 40'hd13e02bb32; sincos_rom_3[891] = 40'hd182e2bfc6;
        sincos_rom_3[892] = 40'hd1c832c453; sincos_rom_3[893] = 40'hd20df2c8d9; sincos_rom_3[894] = 40'hd25422cd58; sincos_rom_3[895] = 40'hd29ac2d1d0;
        sincos_rom_3[896] = 40'hd2e1e2d642; sincos_rom_3[897] = 40'hd32962daac; sincos_rom_3[898] = 40'hd37152df10; sincos_rom_3[899] = 40'hd3b9b2e36c;
        sincos_rom_3[900] = 40'hd40282e7c1; sincos_rom_3[901] = 40'hd44bc2ec0f; sincos_rom_3[902] = 40'hd49562f056; sincos_rom_3[903] = 40'hd4df72f496;
        sincos_rom_3[904] = 40'hd529f2f8ce; sincos_rom_3[905] = 40'hd574d2fcff; sincos_rom_3[906] = 40'hd5c0230128; sincos_rom_3[907] = 40'hd60be3054a;
        sincos_rom_3[908] = 40'hd658030965; sincos_rom_3[909] = 40'hd6a4830d78; sincos_rom_3[910] = 40'hd6f1731184; sincos_rom_3[911] = 40'hd73ec31588;
        sincos_rom_3[912] = 40'hd78c731984; sincos_rom_3[913] = 40'hd7da931d79; sincos_rom_3[914] = 40'hd829032166; sincos_rom_3[915] = 40'hd877e3254c;
        sincos_rom_3[916] = 40'hd8c7232929; sincos_rom_3[917] = 40'hd916c32cff; sincos_rom_3[918] = 40'hd966c330cd; sincos_rom_3[919] = 40'hd9b7233493;
        sincos_rom_3[920] = 40'hda07e33852; sincos_rom_3[921] = 40'hda59033c08; sincos_rom_3[922] = 40'hdaaa833fb6; sincos_rom_3[923] = 40'hdafc53435d;
        sincos_rom_3[924] = 40'hdb4e8346fb; sincos_rom_3[925] = 40'hdba1134a91; sincos_rom_3[926] = 40'hdbf3f34e1f; sincos_rom_3[927] = 40'hdc473351a5;
        sincos_rom_3[928] = 40'hdc9ac35523; sincos_rom_3[929] = 40'hdceeb35898; sincos_rom_3[930] = 40'hdd42f35c05; sincos_rom_3[931] = 40'hdd97935f6a;
        sincos_rom_3[932] = 40'hddec8362c7; sincos_rom_3[933] = 40'hde41c3661b; sincos_rom_3[934] = 40'hde97536967; sincos_rom_3[935] = 40'hdeed436caa;
        sincos_rom_3[936] = 40'hdf43736fe5; sincos_rom_3[937] = 40'hdf9a037318; sincos_rom_3[938] = 40'hdff0e37642; sincos_rom_3[939] = 40'he048037963;
        sincos_rom_3[940] = 40'he09f837c7c; sincos_rom_3[941] = 40'he0f7437f8d; sincos_rom_3[942] = 40'he14f538294; sincos_rom_3[943] = 40'he1a7b38593;
        sincos_rom_3[944] = 40'he200538889; sincos_rom_3[945] = 40'he259538b77; sincos_rom_3[946] = 40'he2b2838e5c; sincos_rom_3[947] = 40'he30c139138;
        sincos_rom_3[948] = 40'he365d3940b; sincos_rom_3[949] = 40'he3bfe396d6; sincos_rom_3[950] = 40'he41a439997; sincos_rom_3[951] = 40'he474e39c50;
        sincos_rom_3[952] = 40'he4cfc39f00; sincos_rom_3[953] = 40'he52ae3a1a7; sincos_rom_3[954] = 40'he58643a444; sincos_rom_3[955] = 40'he5e1f3a6d9;
        sincos_rom_3[956] = 40'he63dd3a965; sincos_rom_3[957] = 40'he69a03abe8; sincos_rom_3[958] = 40'he6f663ae62; sincos_rom_3[959] = 40'he75303b0d3;
        sincos_rom_3[960] = 40'he7afe3b33a; sincos_rom_3[961] = 40'he80d03b599; sincos_rom_3[962] = 40'he86a53b7ee; sincos_rom_3[963] = 40'he8c7e3ba3a;
        sincos_rom_3[964] = 40'he925b3bc7d; sincos_rom_3[965] = 40'he983b3beb7; sincos_rom_3[966] = 40'he9e1f3c0e7; sincos_rom_3[967] = 40'hea4063c30f;
        sincos_rom_3[968] = 40'hea9f13c52d; sincos_rom_3[969] = 40'heafde3c741; sincos_rom_3[970] = 40'heb5cf3c94d; sincos_rom_3[971] = 40'hebbc33cb4f;
        sincos_rom_3[972] = 40'hec1bb3cd47; sincos_rom_3[973] = 40'hec7b53cf36; sincos_rom_3[974] = 40'hecdb23d11c; sincos_rom_3[975] = 40'hed3b33d2f9;
        sincos_rom_3[976] = 40'hed9b63d4cc; sincos_rom_3[977] = 40'hedfbc3d695; sincos_rom_3[978] = 40'hee5c53d855; sincos_rom_3[979] = 40'heebd03da0c;
        sincos_rom_3[980] = 40'hef1de3dbb9; sincos_rom_3[981] = 40'hef7ef3dd5d; sincos_rom_3[982] = 40'hefe033def7; sincos_rom_3[983] = 40'hf04183e087;
        sincos_rom_3[984] = 40'hf0a313e20e; sincos_rom_3[985] = 40'hf104b3e38b; sincos_rom_3[986] = 40'hf16683e4ff; sincos_rom_3[987] = 40'hf1c883e669;
        sincos_rom_3[988] = 40'hf22a93e7ca; sincos_rom_3[989] = 40'hf28cc3e920; sincos_rom_3[990] = 40'hf2ef23ea6e; sincos_rom_3[991] = 40'hf351a3ebb1;
        sincos_rom_3[992] = 40'hf3b433eceb; sincos_rom_3[993] = 40'hf416f3ee1b; sincos_rom_3[994] = 40'hf479c3ef42; sincos_rom_3[995] = 40'hf4dcb3f05f;
        sincos_rom_3[996] = 40'hf53fc3f172; sincos_rom_3[997] = 40'hf5a2e3f27b; sincos_rom_3[998] = 40'hf60623f37b; sincos_rom_3[999] = 40'hf66983f470;
        sincos_rom_3[1000] = 40'hf6ccf3f55c; sincos_rom_3[1001] = 40'hf73073f63f; sincos_rom_3[1002] = 40'hf79413f717; sincos_rom_3[1003] = 40'hf7f7c3f7e6;
        sincos_rom_3[1004] = 40'hf85b93f8ab; sincos_rom_3[1005] = 40'hf8bf63f966; sincos_rom_3[1006] = 40'hf92353fa18; sincos_rom_3[1007] = 40'hf98753fabf;
        sincos_rom_3[1008] = 40'hf9eb53fb5d; sincos_rom_3[1009] = 40'hfa4f73fbf1; sincos_rom_3[1010] = 40'hfab3a3fc7b; sincos_rom_3[1011] = 40'hfb17d3fcfb;
        sincos_rom_3[1012] = 40'hfb7c13fd72; sincos_rom_3[1013] = 40'hfbe063fdde; sincos_rom_3[1014] = 40'hfc44b3fe41; sincos_rom_3[1015] = 40'hfca913fe9a;
        sincos_rom_3[1016] = 40'hfd0d83fee9; sincos_rom_3[1017] = 40'hfd71f3ff2e; sincos_rom_3[1018] = 40'hfdd663ff69; sincos_rom_3[1019] = 40'hfe3ae3ff9b;
        sincos_rom_3[1020] = 40'hfe9f63ffc2; sincos_rom_3[1021] = 40'hff03e3ffe0; sincos_rom_3[1022] = 40'hff6873fff4; sincos_rom_3[1023] = 40'hffccf3fffe;
    end

    // a copy of table sincos: sin s20f18, cos s20f18
    (* rom_style = "block" *)
    reg [39:0] sincos_rom_4 [0:1023];
    initial begin
        sincos_rom_4[0] = 40'h003183fffe; sincos_rom_4[1] = 40'h009603fff4; sincos_rom_4[2] = 40'h00fa83ffe0; sincos_rom_4[3] = 40'h015f13ffc3;
        sincos_rom_4[4] = 40'h01c393ff9b; sincos_rom_4[5] = 40'h022803ff6a; sincos_rom_4[6] = 40'h028c83ff2f; sincos_rom_4[7] = 40'h02f0f3feea;
        sincos_rom_4[8] = 40'h035553fe9b; sincos_rom_4[9] = 40'h03b9b3fe42; sincos_rom_4[10] = 40'h041e13fde0; sincos_rom_4[11] = 40'h048263fd73;
        sincos_rom_4[12] = 40'h04e6a3fcfd; sincos_rom_4[13] = 40'h054ad3fc7d; sincos_rom_4[14] = 40'h05af03fbf3; sincos_rom_4[15] = 40'h061313fb5f;
        sincos_rom_4[16] = 40'h067723fac2; sincos_rom_4[17] = 40'h06db23fa1a; sincos_rom_4[18] = 40'h073f13f969; sincos_rom_4[19] = 40'h07a2e3f8ae;
        sincos_rom_4[20] = 40'h0806b3f7e9; sincos_rom_4[21] = 40'h086a63f71b; sincos_rom_4[22] = 40'h08ce03f642; sincos_rom_4[23] = 40'h093183f560;
        sincos_rom_4[24] = 40'h0994f3f474; sincos_rom_4[25] = 40'h09f853f37e; sincos_rom_4[26] = 40'h0a5b93f27f; sincos_rom_4[27] = 40'h0abeb3f176;
        sincos_rom_4[28] = 40'h0b21c3f063; sincos_rom_4[29] = 40'h0b84b3ef46; sincos_rom_4[30] = 40'h0be793ee20; sincos_rom_4[31] = 40'h0c4a43ecf0;
        sincos_rom_4[32] = 40'h0cace3ebb6; sincos_rom_4[33] = 40'h0d0f53ea73; sincos_rom_4[34] = 40'h0d71b3e926; sincos_rom_4[35] = 40'h0dd3f3e7cf;
        sincos_rom_4[36] = 40'h0e3603e66f; sincos_rom_4[37] = 40'h0e97f3e505; sincos_rom_4[38] = 40'h0ef9c3e391; sincos_rom_4[39] = 40'h0f5b73e214;
        sincos_rom_4[40] = 40'h0fbcf3e08d; sincos_rom_4[41] = 40'h101e53defd; sincos_rom_4[42] = 40'h107f83dd63; sincos_rom_4[43] = 40'h10e093dbc0;
        sincos_rom_4[44] = 40'h114183da13; sincos_rom_4[45] = 40'h11a233d85c; sincos_rom_4[46] = 40'h1202c3d69c; sincos_rom_4[47] = 40'h126323d4d3;
        sincos_rom_4[48] = 40'h12c353d300; sincos_rom_4[49] = 40'h132363d124; sincos_rom_4[50] = 40'h138333cf3e; sincos_rom_4[51] = 40'h13e2d3cd4f;
        sincos_rom_4[52] = 40'h144253cb57; sincos_rom_4[53] = 40'h14a193c955; sincos_rom_4[54] = 40'h1500a3c749; sincos_rom_4[55] = 40'h155f83c535;
        sincos_rom_4[56] = 40'h15be23c317; sincos_rom_4[57] = 40'h161c93c0f0; sincos_rom_4[58] = 40'h167ad3bec0; sincos_rom_4[59] = 40'h16d8d3bc86;
        sincos_rom_4[60] = 40'h1736a3ba43; sincos_rom_4[61] = 40'h179433b7f7; sincos_rom_4[62] = 40'h17f193b5a2; sincos_rom_4[63] = 40'h184eb3b344;
        sincos_rom_4[64] = 40'h18ab93b0dc; sincos_rom_4[65] = 40'h190833ae6c; sincos_rom_4[66] = 40'h196493abf2; sincos_rom_4[67] = 40'h19c0c3a96f;
        sincos_rom_4[68] = 40'h1a1ca3a6e4; sincos_rom_4[69] = 40'h1a7853a44f; sincos_rom_4[70] = 40'h1ad3b3a1b1; sincos_rom_4[71] = 40'h1b2ee39f0a;
        sincos_rom_4[72] = 40'h1b89c39c5b; sincos_rom_4[73] = 40'h1be45399a2; sincos_rom_4[74] = 40'h1c3eb396e1; sincos_rom_4[75] = 40'h1c98c39416;
        sincos_rom_4[76] = 40'h1cf2939143; sincos_rom_4[77] = 40'h1d4c138e67; sincos_rom_4[78] = 40'h1da5538b83; sincos_rom_4[79] = 40'h1dfe438895;
        sincos_rom_4[80] = 40'h1e56f3859f; sincos_rom_4[81] = 40'h1eaf5382a0; sincos_rom_4[82] = 40'h1f07637f99; sincos_rom_4[83] = 40'h1f5f237c89;
        sincos_rom_4[84] = 40'h1fb6a37970; sincos_rom_4[85] = 40'h200dd3764e; sincos_rom_4[86] = 40'h2064a37325; sincos_rom_4[87] = 40'h20bb336ff2;
        sincos_rom_4[88] = 40'h2111736cb7; sincos_rom_4[89] = 40'h2167536974; sincos_rom_4[90] = 40'h21bcf36628; sincos_rom_4[91] = 40'h22123362d4;
        sincos_rom_4[92] = 40'h2267235f78; sincos_rom_4[93] = 40'h22bbc35c13; sincos_rom_4[94] = 40'h23100358a6; sincos_rom_4[95] = 40'h2363f35531;
        sincos_rom_4[96] = 40'h23b78351b3; sincos_rom_4[97] = 40'h240ac34e2d; sincos_rom_4[98] = 40'h245db34a9f; sincos_rom_4[99] = 40'h24b0334709;
        sincos_rom_4[100] = 40'h250273436b; sincos_rom_4[101] = 40'h2554433fc5; sincos_rom_4[102] = 40'h25a5c33c17; sincos_rom_4[103] = 40'h25f6d33861;
        sincos_rom_4[104] = 40'h26479334a3; sincos_rom_4[105] = 40'h26980330dc; sincos_rom_4[106] = 40'h26e8032d0f; sincos_rom_4[107] = 40'h2737a32939;
        sincos_rom_4[108] = 40'h2786e3255b; sincos_rom_4[109] = 40'h27d5c32176; sincos_rom_4[110] = 40'h2824431d89; sincos_rom_4[111] = 40'h2872531994;
        sincos_rom_4[112] = 40'h28c0131598; sincos_rom_4[113] = 40'h290d631194; sincos_rom_4[114] = 40'h295a530d88; sincos_rom_4[115] = 40'h29a6d30975;
        sincos_rom_4[116] = 40'h29f2f3055b; sincos_rom_4[117] = 40'h2a3eb30139; sincos_rom_4[118] = 40'h2a8a02fd0f; sincos_rom_4[119] = 40'h2ad4e2f8df;
        sincos_rom_4[120] = 40'h2b1f62f4a6; sincos_rom_4[121] = 40'h2b6972f067; sincos_rom_4[122] = 40'h2bb322ec20; sincos_rom_4[123] = 40'h2bfc62e7d2;
        sincos_rom_4[124] = 40'h2c4532e37d; sincos_rom_4[125] = 40'h2c8d92df21; sincos_rom_4[126] = 40'h2cd582dabe; sincos_rom_4[127] = 40'h2d1d02d654;
        sincos_rom_4[128] = 40'h2d6422d1e2; sincos_rom_4[129] = 40'h2daac2cd6a; sincos_rom_4[130] = 40'h2df102c8eb; sincos_rom_4[131] = 40'h2e36c2c465;
        sincos_rom_4[132] = 40'h2e7c12bfd8; sincos_rom_4[133] = 40'h2ec0f2bb44; sincos_rom_4[134] = 40'h2f0562b6aa; sincos_rom_4[135] = 40'h2f4962b209;
        sincos_rom_4[136] = 40'h2f8ce2ad61; sincos_rom_4[137] = 40'h2fcff2a8b3; sincos_rom_4[138] = 40'h301282a3fe; sincos_rom_4[139] = 40'h3054a29f42;
        sincos_rom_4[140] = 40'h3096529a80; sincos_rom_4[141] = 40'h30d78295b8; sincos_rom_4[142] = 40'h31184290e9; sincos_rom_4[143] = 40'h3158828c14;
        sincos_rom_4[144] = 40'h3198428739; sincos_rom_4[145] = 40'h31d7928257; sincos_rom_4[146] = 40'h3216627d70; sincos_rom_4[147] = 40'h3254c27882;
        sincos_rom_4[148] = 40'h329292738e; sincos_rom_4[149] = 40'h32cff26e94; sincos_rom_4[150] = 40'h330cd26994; sincos_rom_4[151] = 40'h334932648e;
        sincos_rom_4[152] = 40'h3385225f82; sincos_rom_4[153] = 40'h33c0825a70; sincos_rom_4[154] = 40'h33fb625558; sincos_rom_4[155] = 40'h3435d2503b;
        sincos_rom_4[156] = 40'h346fb24b18; sincos_rom_4[157] = 40'h34a91245ef; sincos_rom_4[158] = 40'h34e1f240c1; sincos_rom_4[159] = 40'h351a523b8d;
        sincos_rom_4[160] = 40'h3552323654; sincos_rom_4[161] = 40'h3589823115; sincos_rom_4[162] = 40'h35c0522bd1; sincos_rom_4[163] = 40'h35f6a22687;
        sincos_rom_4[164] = 40'h362c722138; sincos_rom_4[165] = 40'h3661b21be4; sincos_rom_4[166] = 40'h369672168b; sincos_rom_4[167] = 40'h36caa2112c;
        sincos_rom_4[168] = 40'h36fe520bc9; sincos_rom_4[169] = 40'h3731820660; sincos_rom_4[170] = 40'h37642200f2; sincos_rom_4[171] = 40'h379631fb80;
        sincos_rom_4[172] = 40'h37c7c1f608; sincos_rom_4[173] = 40'h37f8d1f08c; sincos_rom_4[174] = 40'h382941eb0b; sincos_rom_4[175] = 40'h385931e585;
        sincos_rom_4[176] = 40'h388891dffb; sincos_rom_4[177] = 40'h38b771da6b; sincos_rom_4[178] = 40'h38e5c1d4d8; sincos_rom_4[179] = 40'h391381cf3f;
        sincos_rom_4[180] = 40'h3940b1c9a3; sincos_rom_4[181] = 40'h396d61c402; sincos_rom_4[182] = 40'h399971be5c; sincos_rom_4[183] = 40'h39c501b8b2;
        sincos_rom_4[184] = 40'h39f001b304; sincos_rom_4[185] = 40'h3a1a71ad52; sincos_rom_4[186] = 40'h3a4441a79c; sincos_rom_4[187] = 40'h3a6d91a1e1;
        sincos_rom_4[188] = 40'h3a96519c23; sincos_rom_4[189] = 40'h3abe819660; sincos_rom_4[190] = 40'h3ae621909a; sincos_rom_4[191] = 40'h3b0d318ad0;
        sincos_rom_4[192] = 40'h3b33a18502; sincos_rom_4[193] = 40'h3b59917f30; sincos_rom_4[194] = 40'h3b7ee1795b; sincos_rom_4[195] = 40'h3ba3a17382;
        sincos_rom_4[196] = 40'h3bc7d16da5; sincos_rom_4[197] = 40'h3beb7167c5; sincos_rom_4[198] = 40'h3c0e7161e1; sincos_rom_4[199] = 40'h3c30f15bfa;
        sincos_rom_4[200] = 40'h3c52d1560f; sincos_rom_4[201] = 40'h3c74115022; sincos_rom_4[202] = 40'h3c94d14a31; sincos_rom_4[203] = 40'h3cb4f1443d;
        sincos_rom_4[204] = 40'h3cd4713e45; sincos_rom_4[205] = 40'h3cf361384b; sincos_rom_4[206] = 40'h3d11c1324e; sincos_rom_4[207] = 40'h3d2f912c4d;
        sincos_rom_4[208] = 40'h3d4cc1264a; sincos_rom_4[209] = 40'h3d69512044; sincos_rom_4[210] = 40'h3d85511a3b; sincos_rom_4[211] = 40'h3da0c11430;
        sincos_rom_4[212] = 40'h3dbb910e22; sincos_rom_4[213] = 40'h3dd5d10811; sincos_rom_4[214] = 40'h3def7101fd; sincos_rom_4[215] = 40'h3e0870fbe8;
        sincos_rom_4[216] = 40'h3e20e0f5cf; sincos_rom_4[217] = 40'h3e38b0efb5; sincos_rom_4[218] = 40'h3e4ff0e998; sincos_rom_4[219] = 40'h3e6690e378;
        sincos_rom_4[220] = 40'h3e7ca0dd57; sincos_rom_4[221] = 40'h3e9200d734; sincos_rom_4[222] = 40'h3ea6e0d10e; sincos_rom_4[223] = 40'h3ebb10cae6;
        sincos_rom_4[224] = 40'h3eceb0c4bd; sincos_rom_4[225] = 40'h3ee1b0be91; sincos_rom_4[226] = 40'h3ef420b864; sincos_rom_4[227] = 40'h3f05f0b235;
        sincos_rom_4[228] = 40'h3f1720ac04; sincos_rom_4[229] = 40'h3f27b0a5d2; sincos_rom_4[230] = 40'h3f37b09f9e; sincos_rom_4[231] = 40'h3f47009968;
        sincos_rom_4[232] = 40'h3f55c09331; sincos_rom_4[233] = 40'h3f63f08cf9; sincos_rom_4[234] = 40'h3f717086bf; sincos_rom_4[235] = 40'h3f7e608084;
        sincos_rom_4[236] = 40'h3f8ab07a47; sincos_rom_4[237] = 40'h3f9660740a; sincos_rom_4[238] = 40'h3fa1806dcb; sincos_rom_4[239] = 40'h3fabf0678b;
        sincos_rom_4[240] = 40'h3fb5d0614b; sincos_rom_4[241] = 40'h3fbf105b09; sincos_rom_4[242] = 40'h3fc7b054c6; sincos_rom_4[243] = 40'h3fcfb04e83;
        sincos_rom_4[244] = 40'h3fd720483f; sincos_rom_4[245] = 40'h3fdde041fa; sincos_rom_4[246] = 40'h3fe4103bb5; sincos_rom_4[247] = 40'h3fe9a0356f;
        sincos_rom_4[248] = 40'h3fee902f28; sincos_rom_4[249] = 40'h3ff2e028e1; sincos_rom_4[250] = 40'h3ff690229a; sincos_rom_4[251] = 40'h3ff9b01c52;
        sincos_rom_4[252] = 40'h3ffc20160a; sincos_rom_4[253] = 40'h3ffe000fc2; sincos_rom_4[254] = 40'h3fff400979; sincos_rom_4[255] = 40'h3fffe00331;
        sincos_rom_4[256] = 40'h3fffeffce8; sincos_rom_4[257] = 40'h3fff4ff6a0; sincos_rom_4[258] = 40'h3ffe0ff058; sincos_rom_4[259] = 40'h3ffc3fea0f;
        sincos_rom_4[260] = 40'h3ff9bfe3c7; sincos_rom_4[261] = 40'h3ff6afdd80; sincos_rom_4[262] = 40'h3ff2ffd738; sincos_rom_4[263] = 40'h3feeafd0f1;
        sincos_rom_4[264] = 40'h3fe9bfcaab; sincos_rom_4[265] = 40'h3fe42fc465; sincos_rom_4[266] = 40'h3fde0fbe1f; sincos_rom_4[267] = 40'h3fd73fb7da;
        sincos_rom_4[268] = 40'h3fcfdfb196; sincos_rom_4[269] = 40'h3fc7dfab53; sincos_rom_4[270] = 40'h3fbf3fa510; sincos_rom_4[271] = 40'h3fb5ff9ecf;
        sincos_rom_4[272] = 40'h3fac2f988e; sincos_rom_4[273] = 40'h3fa1af924e; sincos_rom_4[274] = 40'h3f969f8c0f; sincos_rom_4[275] = 40'h3f8aef85d2;
        sincos_rom_4[276] = 40'h3f7e9f7f95; sincos_rom_4[277] = 40'h3f71bf795a; sincos_rom_4[278] = 40'h3f642f7320; sincos_rom_4[279] = 40'h3f560f6ce8;
        sincos_rom_4[280] = 40'h3f474f66b1; sincos_rom_4[281] = 40'h3f37ef607b; sincos_rom_4[282] = 40'h3f27ff5a47; sincos_rom_4[283] = 40'h3f176f5415;
        sincos_rom_4[284] = 40'h3f063f4de4; sincos_rom_4[285] = 40'h3ef46f47b5; sincos_rom_4[286] = 40'h3ee20f4187; sincos_rom_4[287] = 40'h3ecf0f3b5c;
        sincos_rom_4[288] = 40'h3ebb6f3532; sincos_rom_4[289] = 40'h3ea73f2f0b; sincos_rom_4[290] = 40'h3e926f28e5; sincos_rom_4[291] = 40'h3e7cff22c1;
        sincos_rom_4[292] = 40'h3e66ff1ca0; sincos_rom_4[293] = 40'h3e505f1681; sincos_rom_4[294] = 40'h3e391f1064; sincos_rom_4[295] = 40'h3e214f0a49;
        sincos_rom_4[296] = 40'h3e08df0431; sincos_rom_4[297] = 40'h3defdefe1b; sincos_rom_4[298] = 40'h3dd63ef808; sincos_rom_4[299] = 40'h3dbc0ef1f7;
        sincos_rom_4[300] = 40'h3da13eebe8; sincos_rom_4[301] = 40'h3d85cee5dd; sincos_rom_4[302] = 40'h3d69cedfd4; sincos_rom_4[303] = 40'h3d4d3ed9ce;
        sincos_rom_4[304] = 40'h3d300ed3cb; sincos_rom_4[305] = 40'h3d124ecdca; sincos_rom_4[306] = 40'h3cf3eec7cd; sincos_rom_4[307] = 40'h3cd4fec1d3;
        sincos_rom_4[308] = 40'h3cb57ebbdb; sincos_rom_4[309] = 40'h3c955eb5e7; sincos_rom_4[310] = 40'h3c749eaff6; sincos_rom_4[311] = 40'h3c535eaa08;
        sincos_rom_4[312] = 40'h3c317ea41e; sincos_rom_4[313] = 40'h3c0f0e9e37; sincos_rom_4[314] = 40'h3bec0e9853; sincos_rom_4[315] = 40'h3bc86e9273;
        sincos_rom_4[316] = 40'h3ba43e8c96; sincos_rom_4[317] = 40'h3b7f7e86bd; sincos_rom_4[318] = 40'h3b5a2e80e7; sincos_rom_4[319] = 40'h3b344e7b15;
        sincos_rom_4[320] = 40'h3b0dce7547; sincos_rom_4[321] = 40'h3ae6ce6f7d; sincos_rom_4[322] = 40'h3abf2e69b7; sincos_rom_4[323] = 40'h3a96fe63f4;
        sincos_rom_4[324] = 40'h3a6e4e5e36; sincos_rom_4[325] = 40'h3a44fe587b; sincos_rom_4[326] = 40'h3a1b1e52c5; sincos_rom_4[327] = 40'h39f0ae4d12;
        sincos_rom_4[328] = 40'h39c5be4764; sincos_rom_4[329] = 40'h399a2e41bb; sincos_rom_4[330] = 40'h396e1e3c15; sincos_rom_4[331] = 40'h39416e3674;
        sincos_rom_4[332] = 40'h39143e30d7; sincos_rom_4[333] = 40'h38e67e2b3f; sincos_rom_4[334] = 40'h38b83e25ab; sincos_rom_4[335] = 40'h38895e201c;
        sincos_rom_4[336] = 40'h3859fe1a91; sincos_rom_4[337] = 40'h382a0e150b; sincos_rom_4[338] = 40'h37f99e0f8a; sincos_rom_4[339] = 40'h37c89e0a0e;
        sincos_rom_4[340] = 40'h37970e0496; sincos_rom_4[341] = 40'h3764edff23; sincos_rom_4[342] = 40'h37325df9b6; sincos_rom_4[343] = 40'h36ff2df44d;
        sincos_rom_4[344] = 40'h36cb7deee9; sincos_rom_4[345] = 40'h36974de98b; sincos_rom_4[346] = 40'h36628de431; sincos_rom_4[347] = 40'h362d4ddedd;
        sincos_rom_4[348] = 40'h35f78dd98e; sincos_rom_4[349] = 40'h35c13dd444; sincos_rom_4[350] = 40'h358a6dcf00; sincos_rom_4[351] = 40'h35531dc9c1;
        sincos_rom_4[352] = 40'h351b3dc488; sincos_rom_4[353] = 40'h34e2ddbf54; sincos_rom_4[354] = 40'h34a9fdba25; sincos_rom_4[355] = 40'h34709db4fd;
        sincos_rom_4[356] = 40'h3436bdafd9; sincos_rom_4[357] = 40'h33fc5daabc; sincos_rom_4[358] = 40'h33c17da5a4; sincos_rom_4[359] = 40'h33861da093;
        sincos_rom_4[360] = 40'h334a3d9b87; sincos_rom_4[361] = 40'h330dcd9680; sincos_rom_4[362] = 40'h32d0fd9180; sincos_rom_4[363] = 40'h32939d8c86;
        sincos_rom_4[364] = 40'h3255bd8792; sincos_rom_4[365] = 40'h32176d82a4; sincos_rom_4[366] = 40'h31d89d7dbc; sincos_rom_4[367] = 40'h31994d78db;
        sincos_rom_4[368] = 40'h31598d73ff; sincos_rom_4[369] = 40'h31194d6f2a; sincos_rom_4[370] = 40'h30d88d6a5b; sincos_rom_4[371] = 40'h30975d6593;
        sincos_rom_4[372] = 40'h3055bd60d1; sincos_rom_4[373] = 40'h30139d5c15; sincos_rom_4[374] = 40'h2fd0fd5760; sincos_rom_4[375] = 40'h2f8dfd52b2;
        sincos_rom_4[376] = 40'h2f4a6d4e0a; sincos_rom_4[377] = 40'h2f067d4969; sincos_rom_4[378] = 40'h2ec20d44ce; sincos_rom_4[379] = 40'h2e7d2d403a;
        sincos_rom_4[380] = 40'h2e37dd3bad; sincos_rom_4[381] = 40'h2df21d3727; sincos_rom_4[382] = 40'h2dabed32a8; sincos_rom_4[383] = 40'h2d654d2e30;
        sincos_rom_4[384] = 40'h2d1e2d29be; sincos_rom_4[385] = 40'h2cd6ad2554; sincos_rom_4[386] = 40'h2c8ebd20f0; sincos_rom_4[387] = 40'h2c465d1c94;
        sincos_rom_4[388] = 40'h2bfd8d183f; sincos_rom_4[389] = 40'h2bb44d13f1; sincos_rom_4[390] = 40'h2b6aad0faa; sincos_rom_4[391] = 40'h2b209d0b6a;
        sincos_rom_4[392] = 40'h2ad61d0732; sincos_rom_4[393] = 40'h2a8b3d0301; sincos_rom_4[394] = 40'h2a3fecfed8; sincos_rom_4[395] = 40'h29f42cfab6;
        sincos_rom_4[396] = 40'h29a80cf69b; sincos_rom_4[397] = 40'h295b8cf288; sincos_rom_4[398] = 40'h290e9cee7c; sincos_rom_4[399] = 40'h28c14cea78;
        sincos_rom_4[400] = 40'h28739ce67c; sincos_rom_4[401] = 40'h28257ce287; sincos_rom_4[402] = 40'h27d70cde9a; sincos_rom_4[403] = 40'h27882cdab4;
        sincos_rom_4[404] = 40'h2738ecd6d7; sincos_rom_4[405] = 40'h26e94cd301; sincos_rom_4[406] = 40'h26994ccf33; sincos_rom_4[407] = 40'h2648eccb6d;
        sincos_rom_4[408] = 40'h25f82cc7ae; sincos_rom_4[409] = 40'h25a70cc3f8; sincos_rom_4[410] = 40'h25558cc04a; sincos_rom_4[411] = 40'h2503bcbca3;
        sincos_rom_4[412] = 40'h24b18cb905; sincos_rom_4[413] = 40'h245efcb56f; sincos_rom_4[414] = 40'h240c1cb1e1; sincos_rom_4[415] = 40'h23b8dcae5b;
        sincos_rom_4[416] = 40'h23654caadd; sincos_rom_4[417] = 40'h23115ca768; sincos_rom_4[418] = 40'h22bd1ca3fb; sincos_rom_4[419] = 40'h22687ca096;
        sincos_rom_4[420] = 40'h22138c9d39; sincos_rom_4[421] = 40'h21be4c99e5; sincos_rom_4[422] = 40'h2168bc9699; sincos_rom_4[423] = 40'h2112cc9356;
        sincos_rom_4[424] = 40'h20bc9c901b; sincos_rom_4[425] = 40'h20660c8ce8; sincos_rom_4[426] = 40'h200f2c89be; sincos_rom_4[427] = 40'h1fb80c869d;
        sincos_rom_4[428] = 40'h1f608c8384; sincos_rom_4[429] = 40'h1f08cc8073; sincos_rom_4[430] = 40'h1eb0bc7d6c; sincos_rom_4[431] = 40'h1e585c7a6d;
        sincos_rom_4[432] = 40'h1dffbc7777; sincos_rom_4[433] = 40'h1da6bc7489; sincos_rom_4[434] = 40'h1d4d8c71a4; sincos_rom_4[435] = 40'h1cf3fc6ec8;
        sincos_rom_4[436] = 40'h1c9a3c6bf5; sincos_rom_4[437] = 40'h1c402c692a; sincos_rom_4[438] = 40'h1be5cc6669; sincos_rom_4[439] = 40'h1b8b2c63b0;
        sincos_rom_4[440] = 40'h1b304c6100; sincos_rom_4[441] = 40'h1ad52c5e59; sincos_rom_4[442] = 40'h1a79cc5bbc; sincos_rom_4[443] = 40'h1a1e1c5927;
        sincos_rom_4[444] = 40'h19c23c569b; sincos_rom_4[445] = 40'h19660c5418; sincos_rom_4[446] = 40'h1909ac519e; sincos_rom_4[447] = 40'h18ad0c4f2d;
        sincos_rom_4[448] = 40'h18502c4cc6; sincos_rom_4[449] = 40'h17f30c4a67; sincos_rom_4[450] = 40'h1795bc4812; sincos_rom_4[451] = 40'h17382c45c6;
        sincos_rom_4[452] = 40'h16da5c4383; sincos_rom_4[453] = 40'h167c5c4149; sincos_rom_4[454] = 40'h161e1c3f19; sincos_rom_4[455] = 40'h15bfac3cf1;
        sincos_rom_4[456] = 40'h1560fc3ad3; sincos_rom_4[457] = 40'h15022c38bf; sincos_rom_4[458] = 40'h14a31c36b3; sincos_rom_4[459] = 40'h1443dc34b1;
        sincos_rom_4[460] = 40'h13e45c32b9; sincos_rom_4[461] = 40'h1384bc30ca; sincos_rom_4[462] = 40'h1324ec2ee4; sincos_rom_4[463] = 40'h12c4dc2d07;
        sincos_rom_4[464] = 40'h1264ac2b34; sincos_rom_4[465] = 40'h12044c296b; sincos_rom_4[466] = 40'h11a3bc27ab; sincos_rom_4[467] = 40'h11430c25f4;
        sincos_rom_4[468] = 40'h10e22c2447; sincos_rom_4[469] = 40'h10811c22a3; sincos_rom_4[470] = 40'h101fdc2109; sincos_rom_4[471] = 40'h0fbe8c1f79;
        sincos_rom_4[472] = 40'h0f5cfc1df2; sincos_rom_4[473] = 40'h0efb5c1c75; sincos_rom_4[474] = 40'h0e998c1b01; sincos_rom_4[475] = 40'h0e378c1997;
        sincos_rom_4[476] = 40'h0dd57c1836; sincos_rom_4[477] = 40'h0d734c16e0; sincos_rom_4[478] = 40'h0d10ec1592; sincos_rom_4[479] = 40'h0cae6c144f;
        sincos_rom_4[480] = 40'h0c4bdc1315; sincos_rom_4[481] = 40'h0be91c11e5; sincos_rom_4[482] = 40'h0b864c10be; sincos_rom_4[483] = 40'h0b235c0fa1;
        sincos_rom_4[484] = 40'h0ac04c0e8e; sincos_rom_4[485] = 40'h0a5d2c0d85; sincos_rom_4[486] = 40'h09f9ec0c85; sincos_rom_4[487] = 40'h09968c0b90;
        sincos_rom_4[488] = 40'h09331c0aa4; sincos_rom_4[489] = 40'h08cf9c09c1; sincos_rom_4[490] = 40'h086bfc08e9; sincos_rom_4[491] = 40'h08084c081a;
        sincos_rom_4[492] = 40'h07a47c0755; sincos_rom_4[493] = 40'h0740ac069a; sincos_rom_4[494] = 40'h06dcbc05e8; sincos_rom_4[495] = 40'h0678bc0541;
        sincos_rom_4[496] = 40'h0614bc04a3; sincos_rom_4[497] = 40'h05b09c040f; sincos_rom_4[498] = 40'h054c6c0385; sincos_rom_4[499] = 40'h04e83c0305;
        sincos_rom_4[500] = 40'h0483fc028e; sincos_rom_4[501] = 40'h041fac0222; sincos_rom_4[502] = 40'h03bb5c01bf; sincos_rom_4[503] = 40'h0356fc0166;
        sincos_rom_4[504] = 40'h02f28c0117; sincos_rom_4[505] = 40'h028e1c00d2; sincos_rom_4[506] = 40'h0229ac0097; sincos_rom_4[507] = 40'h01c52c0065;
        sincos_rom_4[508] = 40'h0160ac003e; sincos_rom_4[509] = 40'h00fc2c0020; sincos_rom_4[510] = 40'h00979c000c; sincos_rom_4[511] = 40'h00331c0002;
        sincos_rom_4[512] = 40'hffce8c0002; sincos_rom_4[513] = 40'hff6a0c000c; sincos_rom_4[514] = 40'hff058c0020; sincos_rom_4[515] = 40'hfea0fc003d;
        sincos_rom_4[516] = 40'hfe3c7c0065; sincos_rom_4[517] = 40'hfdd80c0096; sincos_rom_4[518] = 40'hfd738c00d1; sincos_rom_4[519] = 40'hfd0f1c0116;
        sincos_rom_4[520] = 40'hfcaabc0165; sincos_rom_4[521] = 40'hfc465c01be; sincos_rom_4[522] = 40'hfbe1fc0220; sincos_rom_4[523] = 40'hfb7dac028d;
        sincos_rom_4[524] = 40'hfb196c0303; sincos_rom_4[525] = 40'hfab53c0383; sincos_rom_4[526] = 40'hfa510c040d; sincos_rom_4[527] = 40'hf9ecfc04a1;
        sincos_rom_4[528] = 40'hf988ec053e; sincos_rom_4[529] = 40'hf924ec05e6; sincos_rom_4[530] = 40'hf8c0fc0697; sincos_rom_4[531] = 40'hf85d2c0752;
        sincos_rom_4[532] = 40'hf7f95c0817; sincos_rom_4[533] = 40'hf795ac08e5; sincos_rom_4[534] = 40'hf7320c09be; sincos_rom_4[535] = 40'hf6ce8c0aa0;
        sincos_rom_4[536] = 40'hf66b1c0b8c; sincos_rom_4[537] = 40'hf607bc0c82; sincos_rom_4[538] = 40'hf5a47c0d81; sincos_rom_4[539] = 40'hf5415c0e8a;
        sincos_rom_4[540] = 40'hf4de4c0f9d; sincos_rom_4[541] = 40'hf47b5c10ba; sincos_rom_4[542] = 40'hf4187c11e0; sincos_rom_4[543] = 40'hf3b5cc1310;
        sincos_rom_4[544] = 40'hf3532c144a; sincos_rom_4[545] = 40'hf2f0bc158d; sincos_rom_4[546] = 40'hf28e5c16da; sincos_rom_4[547] = 40'hf22c1c1831;
        sincos_rom_4[548] = 40'hf1ca0c1991; sincos_rom_4[549] = 40'hf1681c1afb; sincos_rom_4[550] = 40'hf1064c1c6f; sincos_rom_4[551] = 40'hf0a49c1dec;
        sincos_rom_4[552] = 40'hf0431c1f73; sincos_rom_4[553] = 40'hefe1bc2103; sincos_rom_4[554] = 40'hef808c229d; sincos_rom_4[555] = 40'hef1f7c2440;
        sincos_rom_4[556] = 40'heebe8c25ed; sincos_rom_4[557] = 40'hee5ddc27a4; sincos_rom_4[558] = 40'hedfd4c2964; sincos_rom_4[559] = 40'hed9cec2b2d;
        sincos_rom_4[560] = 40'hed3cbc2d00; sincos_rom_4[561] = 40'hecdcac2edc; sincos_rom_4[562] = 40'hec7cdc30c2; sincos_rom_4[563] = 40'hec1d3c32b1;
        sincos_rom_4[564] = 40'hebbdbc34a9; sincos_rom_4[565] = 40'heb5e7c36ab; sincos_rom_4[566] = 40'heaff6c38b7; sincos_rom_4[567] = 40'heaa08c3acb;
        sincos_rom_4[568] = 40'hea41ec3ce9; sincos_rom_4[569] = 40'he9e37c3f10; sincos_rom_4[570] = 40'he9853c4140; sincos_rom_4[571] = 40'he9273c437a;
        sincos_rom_4[572] = 40'he8c96c45bd; sincos_rom_4[573] = 40'he86bdc4809; sincos_rom_4[574] = 40'he80e7c4a5e; sincos_rom_4[575] = 40'he7b15c4cbc;
        sincos_rom_4[576] = 40'he7547c4f24; sincos_rom_4[577] = 40'he6f7dc5194; sincos_rom_4[578] = 40'he69b7c540e; sincos_rom_4[579] = 40'he63f4c5691;
        sincos_rom_4[580] = 40'he5e36c591c; sincos_rom_4[581] = 40'he587bc5bb1; sincos_rom_4[582] = 40'he52c5c5e4f; sincos_rom_4[583] = 40'he4d12c60f6;
        sincos_rom_4[584] = 40'he4764c63a5; sincos_rom_4[585] = 40'he41bbc665e; sincos_rom_4[586] = 40'he3c15c691f; sincos_rom_4[587] = 40'he3674c6bea;
        sincos_rom_4[588] = 40'he30d7c6ebd; sincos_rom_4[589] = 40'he2b3fc7199; sincos_rom_4[590] = 40'he25abc747d; sincos_rom_4[591] = 40'he201cc776b;
        sincos_rom_4[592] = 40'he1a91c7a61; sincos_rom_4[593] = 40'he150bc7d60; sincos_rom_4[594] = 40'he0f8ac8067; sincos_rom_4[595] = 40'he0a0ec8377;
        sincos_rom_4[596] = 40'he0496c8690; sincos_rom_4[597] = 40'hdff23c89b2; sincos_rom_4[598] = 40'hdf9b6c8cdb; sincos_rom_4[599] = 40'hdf44dc900e;
        sincos_rom_4[600] = 40'hdeee9c9349; sincos_rom_4[601] = 40'hde98bc968c; sincos_rom_4[602] = 40'hde431c99d8; sincos_rom_4[603] = 40'hddeddc9d2c;
        sincos_rom_4[604] = 40'hdd98eca088; sincos_rom_4[605] = 40'hdd444ca3ed; sincos_rom_4[606] = 40'hdcf00ca75a; sincos_rom_4[607] = 40'hdc9c1caacf;
        sincos_rom_4[608] = 40'hdc488cae4d; sincos_rom_4[609] = 40'hdbf54cb1d3; sincos_rom_4[610] = 40'hdba25cb561; sincos_rom_4[611] = 40'hdb4fdcb8f7;
        sincos_rom_4[612] = 40'hdafd9cbc95; sincos_rom_4[613] = 40'hdaabccc03b; sincos_rom_4[614] = 40'hda5a4cc3e9; sincos_rom_4[615] = 40'hda093cc79f;
        sincos_rom_4[616] = 40'hd9b87ccb5d; sincos_rom_4[617] = 40'hd9680ccf24; sincos_rom_4[618] = 40'hd9180cd2f1; sincos_rom_4[619] = 40'hd8c86cd6c7;
        sincos_rom_4[620] = 40'hd8792cdaa5; sincos_rom_4[621] = 40'hd82a4cde8a; sincos_rom_4[622] = 40'hd7dbcce277; sincos_rom_4[623] = 40'hd78dbce66c;
        sincos_rom_4[624] = 40'hd73ffcea68; sincos_rom_4[625] = 40'hd6f2acee6c; sincos_rom_4[626] = 40'hd6a5bcf278; sincos_rom_4[627] = 40'hd6593cf68b;
        sincos_rom_4[628] = 40'hd60d1cfaa5; sincos_rom_4[629] = 40'hd5c15cfec7; sincos_rom_4[630] = 40'hd5760d02f1; sincos_rom_4[631] = 40'hd52b2d0721;
        sincos_rom_4[632] = 40'hd4e0ad0b5a; sincos_rom_4[633] = 40'hd4969d0f99; sincos_rom_4[634] = 40'hd44ced13e0; sincos_rom_4[635] = 40'hd403ad182e;
        sincos_rom_4[636] = 40'hd3badd1c83; sincos_rom_4[637] = 40'hd3727d20df; sincos_rom_4[638] = 40'hd32a8d2542; sincos_rom_4[639] = 40'hd2e30d29ac;
        sincos_rom_4[640] = 40'hd29bed2e1e; sincos_rom_4[641] = 40'hd2554d3296; sincos_rom_4[642] = 40'hd20f0d3715; sincos_rom_4[643] = 40'hd1c94d3b9b;
        sincos_rom_4[644] = 40'hd183fd4028; sincos_rom_4[645] = 40'hd13f1d44bc; sincos_rom_4[646] = 40'hd0faad4956; sincos_rom_4[647] = 40'hd0b6ad4df7;
        sincos_rom_4[648] = 40'hd0732d529f; sincos_rom_4[649] = 40'hd0301d574d; sincos_rom_4[650] = 40'hcfed8d5c02; sincos_rom_4[651] = 40'hcfab6d60be;
        sincos_rom_4[652] = 40'hcf69bd6580; sincos_rom_4[653] = 40'hcf288d6a48; sincos_rom_4[654] = 40'hcee7cd6f17; sincos_rom_4[655] = 40'hcea78d73ec;
        sincos_rom_4[656] = 40'hce67cd78c7; sincos_rom_4[657] = 40'hce287d7da9; sincos_rom_4[658] = 40'hcde9ad8290; sincos_rom_4[659] = 40'hcdab4d877e;
        sincos_rom_4[660] = 40'hcd6d7d8c72; sincos_rom_4[661] = 40'hcd301d916c; sincos_rom_4[662] = 40'hccf33d966c; sincos_rom_4[663] = 40'hccb6dd9b72;
        sincos_rom_4[664] = 40'hcc7aeda07e; sincos_rom_4[665] = 40'hcc3f8da590; sincos_rom_4[666] = 40'hcc04adaaa8; sincos_rom_4[667] = 40'hcbca3dafc5;
        sincos_rom_4[668] = 40'hcb905db4e8; sincos_rom_4[669] = 40'hcb56fdba11; sincos_rom_4[670] = 40'hcb1e1dbf3f; sincos_rom_4[671] = 40'hcae5bdc473;
        sincos_rom_4[672] = 40'hcaadddc9ac; sincos_rom_4[673] = 40'hca768dceeb; sincos_rom_4[674] = 40'hca3fbdd42f; sincos_rom_4[675] = 40'hca096dd979;
        sincos_rom_4[676] = 40'hc9d39ddec8; sincos_rom_4[677] = 40'hc99e5de41c; sincos_rom_4[678] = 40'hc9699de975; sincos_rom_4[679] = 40'hc9356deed4;
        sincos_rom_4[680] = 40'hc901bdf437; sincos_rom_4[681] = 40'hc8ce8df9a0; sincos_rom_4[682] = 40'hc89bedff0e; sincos_rom_4[683] = 40'hc869de0480;
        sincos_rom_4[684] = 40'hc8384e09f8; sincos_rom_4[685] = 40'hc8073e0f74; sincos_rom_4[686] = 40'hc7d6ce14f5; sincos_rom_4[687] = 40'hc7a6de1a7b;
        sincos_rom_4[688] = 40'hc7777e2005; sincos_rom_4[689] = 40'hc7489e2595; sincos_rom_4[690] = 40'hc71a4e2b28; sincos_rom_4[691] = 40'hc6ec8e30c1;
        sincos_rom_4[692] = 40'hc6bf5e365d; sincos_rom_4[693] = 40'hc692ae3bfe; sincos_rom_4[694] = 40'hc6669e41a4; sincos_rom_4[695] = 40'hc63b0e474e;
        sincos_rom_4[696] = 40'hc6100e4cfc; sincos_rom_4[697] = 40'hc5e59e52ae; sincos_rom_4[698] = 40'hc5bbce5864; sincos_rom_4[699] = 40'hc5927e5e1f;
        sincos_rom_4[700] = 40'hc569be63dd; sincos_rom_4[701] = 40'hc5418e69a0; sincos_rom_4[702] = 40'hc519ee6f66; sincos_rom_4[703] = 40'hc4f2de7530;
        sincos_rom_4[704] = 40'hc4cc6e7afe; sincos_rom_4[705] = 40'hc4a67e80d0; sincos_rom_4[706] = 40'hc4812e86a5; sincos_rom_4[707] = 40'hc45c6e8c7e;
        sincos_rom_4[708] = 40'hc4383e925b; sincos_rom_4[709] = 40'hc4149e983b; sincos_rom_4[710] = 40'hc3f19e9e1f; sincos_rom_4[711] = 40'hc3cf1ea406;
        sincos_rom_4[712] = 40'hc3ad3ea9f1; sincos_rom_4[713] = 40'hc38bfeafde; sincos_rom_4[714] = 40'hc36b3eb5cf; sincos_rom_4[715] = 40'hc34b1ebbc3;
        sincos_rom_4[716] = 40'hc32b9ec1bb; sincos_rom_4[717] = 40'hc30caec7b5; sincos_rom_4[718] = 40'hc2ee4ecdb2; sincos_rom_4[719] = 40'hc2d07ed3b3;
        sincos_rom_4[720] = 40'hc2b34ed9b6; sincos_rom_4[721] = 40'hc296bedfbc; sincos_rom_4[722] = 40'hc27abee5c5; sincos_rom_4[723] = 40'hc25f4eebd0;
        sincos_rom_4[724] = 40'hc2447ef1de; sincos_rom_4[725] = 40'hc22a3ef7ef; sincos_rom_4[726] = 40'hc2109efe03; sincos_rom_4[727] = 40'hc1f79f0418;
        sincos_rom_4[728] = 40'hc1df2f0a31; sincos_rom_4[729] = 40'hc1c75f104b; sincos_rom_4[730] = 40'hc1b01f1668; sincos_rom_4[731] = 40'hc1997f1c88;
        sincos_rom_4[732] = 40'hc1836f22a9; sincos_rom_4[733] = 40'hc16e0f28cc; sincos_rom_4[734] = 40'hc1592f2ef2; sincos_rom_4[735] = 40'hc144ff351a;
        sincos_rom_4[736] = 40'hc1315f3b43; sincos_rom_4[737] = 40'hc11e5f416f; sincos_rom_4[738] = 40'hc10bef479c; sincos_rom_4[739] = 40'hc0fa1f4dcb;
        sincos_rom_4[740] = 40'hc0e8ef53fc; sincos_rom_4[741] = 40'hc0d85f5a2e; sincos_rom_4[742] = 40'hc0c85f6062; sincos_rom_4[743] = 40'hc0b90f6698;
        sincos_rom_4[744] = 40'hc0aa4f6ccf; sincos_rom_4[745] = 40'hc09c1f7307; sincos_rom_4[746] = 40'hc08e9f7941; sincos_rom_4[747] = 40'hc081af7f7c;
        sincos_rom_4[748] = 40'hc0755f85b9; sincos_rom_4[749] = 40'hc069af8bf6; sincos_rom_4[750] = 40'hc05e8f9235; sincos_rom_4[751] = 40'hc0541f9875;
        sincos_rom_4[752] = 40'hc04a3f9eb5; sincos_rom_4[753] = 40'hc040ffa4f7; sincos_rom_4[754] = 40'hc0385fab3a; sincos_rom_4[755] = 40'hc0305fb17d;
        sincos_rom_4[756] = 40'hc028efb7c1; sincos_rom_4[757] = 40'hc0222fbe06; sincos_rom_4[758] = 40'hc01bffc44b; sincos_rom_4[759] = 40'hc0166fca91;
        sincos_rom_4[760] = 40'hc0117fd0d8; sincos_rom_4[761] = 40'hc00d2fd71f; sincos_rom_4[762] = 40'hc0097fdd66; sincos_rom_4[763] = 40'hc0065fe3ae;
        sincos_rom_4[764] = 40'hc003efe9f6; sincos_rom_4[765] = 40'hc0020ff03e; sincos_rom_4[766] = 40'hc000cff687; sincos_rom_4[767] = 40'hc0002ffccf;
        sincos_rom_4[768] = 40'hc000200318; sincos_rom_4[769] = 40'hc000c00960; sincos_rom_4[770] = 40'hc002000fa8; sincos_rom_4[771] = 40'hc003d015f1;
        sincos_rom_4[772] = 40'hc006501c39; sincos_rom_4[773] = 40'hc009602280; sincos_rom_4[774] = 40'hc00d1028c8; sincos_rom_4[775] = 40'hc011602f0f;
        sincos_rom_4[776] = 40'hc016503555; sincos_rom_4[777] = 40'hc01be03b9b; sincos_rom_4[778] = 40'hc0220041e1; sincos_rom_4[779] = 40'hc028d04826;
        sincos_rom_4[780] = 40'hc030304e6a; sincos_rom_4[781] = 40'hc0383054ad; sincos_rom_4[782] = 40'hc040d05af0; sincos_rom_4[783] = 40'hc04a106131;
        sincos_rom_4[784] = 40'hc053e06772; sincos_rom_4[785] = 40'hc05e606db2; sincos_rom_4[786] = 40'hc0697073f1; sincos_rom_4[787] = 40'hc075207a2e;
        sincos_rom_4[788] = 40'hc08170806b; sincos_rom_4[789] = 40'hc08e5086a6; sincos_rom_4[790] = 40'hc09be08ce0; sincos_rom_4[791] = 40'hc0aa009318;
        sincos_rom_4[792] = 40'hc0b8c0994f; sincos_rom_4[793] = 40'hc0c8209f85; sincos_rom_4[794] = 40'hc0d810a5b9; sincos_rom_4[795] = 40'hc0e8a0abeb;
        sincos_rom_4[796] = 40'hc0f9d0b21c; sincos_rom_4[797] = 40'hc10ba0b84b; sincos_rom_4[798] = 40'hc11e00be79; sincos_rom_4[799] = 40'hc13100c4a4;
        sincos_rom_4[800] = 40'hc144a0cace; sincos_rom_4[801] = 40'hc158d0d0f5; sincos_rom_4[802] = 40'hc16da0d71b; sincos_rom_4[803] = 40'hc18310dd3f;
        sincos_rom_4[804] = 40'hc19910e360; sincos_rom_4[805] = 40'hc1afb0e97f; sincos_rom_4[806] = 40'hc1c6f0ef9c; sincos_rom_4[807] = 40'hc1dec0f5b7;
        sincos_rom_4[808] = 40'hc1f730fbcf; sincos_rom_4[809] = 40'hc2103101e5; sincos_rom_4[810] = 40'hc229d107f8; sincos_rom_4[811] = 40'hc244010e09;
        sincos_rom_4[812] = 40'hc25ed11418; sincos_rom_4[813] = 40'hc27a411a23; sincos_rom_4[814] = 40'hc29641202c; sincos_rom_4[815] = 40'hc2b2d12632;
        sincos_rom_4[816] = 40'hc2d0012c35; sincos_rom_4[817] = 40'hc2edc13236; sincos_rom_4[818] = 40'hc30c213833; sincos_rom_4[819] = 40'hc32b113e2d;
        sincos_rom_4[820] = 40'hc34a914425; sincos_rom_4[821] = 40'hc36ab14a19; sincos_rom_4[822] = 40'hc38b71500a; sincos_rom_4[823] = 40'hc3acb155f8;
        sincos_rom_4[824] = 40'hc3ce915be2; sincos_rom_4[825] = 40'hc3f10161c9; sincos_rom_4[826] = 40'hc4140167ad; sincos_rom_4[827] = 40'hc437a16d8d;
        sincos_rom_4[828] = 40'hc45bd1736a; sincos_rom_4[829] = 40'hc480917943; sincos_rom_4[830] = 40'hc4a5e17f19; sincos_rom_4[831] = 40'hc4cbc184eb;
        sincos_rom_4[832] = 40'hc4f2418ab9; sincos_rom_4[833] = 40'hc519419083; sincos_rom_4[834] = 40'hc540e19649; sincos_rom_4[835] = 40'hc569119c0c;
        sincos_rom_4[836] = 40'hc591c1a1ca; sincos_rom_4[837] = 40'hc5bb11a785; sincos_rom_4[838] = 40'hc5e4f1ad3b; sincos_rom_4[839] = 40'hc60f61b2ee;
        sincos_rom_4[840] = 40'hc63a51b89c; sincos_rom_4[841] = 40'hc665e1be45; sincos_rom_4[842] = 40'hc691f1c3eb; sincos_rom_4[843] = 40'hc6bea1c98c;
        sincos_rom_4[844] = 40'hc6ebd1cf29; sincos_rom_4[845] = 40'hc71991d4c1; sincos_rom_4[846] = 40'hc747d1da55; sincos_rom_4[847] = 40'hc776b1dfe4;
        sincos_rom_4[848] = 40'hc7a611e56f; sincos_rom_4[849] = 40'hc7d601eaf5; sincos_rom_4[850] = 40'hc80671f076; sincos_rom_4[851] = 40'hc83771f5f2;
        sincos_rom_4[852] = 40'hc86901fb6a; sincos_rom_4[853] = 40'hc89b2200dd; sincos_rom_4[854] = 40'hc8cdb2064a; sincos_rom_4[855] = 40'hc900e20bb3;
        sincos_rom_4[856] = 40'hc934921117; sincos_rom_4[857] = 40'hc968c21675; sincos_rom_4[858] = 40'hc99d821bcf; sincos_rom_4[859] = 40'hc9d2c22123;
        sincos_rom_4[860] = 40'hca08822672; sincos_rom_4[861] = 40'hca3ed22bbc; sincos_rom_4[862] = 40'hca75a23100; sincos_rom_4[863] = 40'hcaacf2363f;
        sincos_rom_4[864] = 40'hcae4d23b78; sincos_rom_4[865] = 40'hcb1d3240ac; sincos_rom_4[866] = 40'hcb561245db; sincos_rom_4[867] = 40'hcb8f724b03;
        sincos_rom_4[868] = 40'hcbc9525027; sincos_rom_4[869] = 40'hcc03b25544; sincos_rom_4[870] = 40'hcc3e925a5c; sincos_rom_4[871] = 40'hcc79f25f6d;
        sincos_rom_4[872] = 40'hccb5d26479; sincos_rom_4[873] = 40'hccf2426980; sincos_rom_4[874] = 40'hcd2f126e80; sincos_rom_4[875] = 40'hcd6c72737a;
        sincos_rom_4[876] = 40'hcdaa52786e; sincos_rom_4[877] = 40'hcde8a27d5c; sincos_rom_4[878] = 40'hce27728244; sincos_rom_4[879] = 40'hce66c28725;
        sincos_rom_4[880] = 40'hcea6828c01; sincos_rom_4[881] = 40'hcee6c290d6; sincos_rom_4[882] = 40'hcf278295a5; sincos_rom_4[883] = 40'hcf68b29a6d;
        sincos_rom_4[884] = 40'hcfaa529f2f; sincos_rom_4[885] = 40'hcfec72a3eb; sincos_rom_4[886] = 40'hd02f12a8a0; sincos_rom_4[887] = 40'hd07212ad4e;
        sincos_rom_4[888] = 40'hd0b5a2b1f6; sincos_rom_4[889] = 40'hd0f992b697; sincos_rom_4[890] = 40'hd13e02bb32; sincos_rom_4[891] = 40'hd182e2bfc6;
        sincos_rom_4[892] = 40'hd1c832c453; sincos_rom_4[893] = 40'hd20df2c8d9; sincos_rom_4[894] = 40'hd25422cd58; sincos_rom_4[895] = 40'hd29ac2d1d0;
        sincos_rom_4[896] = 40'hd2e1e2d642; sincos_rom_4[897] = 40'hd32962daac; sincos_rom_4[898] = 40'hd37152df10; sincos_rom_4[899] = 40'hd3b9b2e36c;
        sincos_rom_4[900] = 40'hd40282e7c1; sincos_rom_4[901] = 40'hd44bc2ec0f; sincos_rom_4[902] = 40'hd49562f056; sincos_rom_4[903] = 40'hd4df72f496;
        sincos_rom_4[904] = 40'hd529f2f8ce; sincos_rom_4[905] = 40'hd574d2fcff; sincos_rom_4[906] = 40'hd5c0230128; sincos_rom_4[907] = 40'hd60be3054a;
        sincos_rom_4[908] = 40'hd658030965; sincos_rom_4[909] = 40'hd6a4830d78; sincos_rom_4[910] = 40'hd6f1731184; sincos_rom_4[911] = 40'hd73ec31588;
        sincos_rom_4[912] = 40'hd78c731984; sincos_rom_4[913] = 40'hd7da931d79; sincos_rom_4[914] = 40'hd829032166; sincos_rom_4[915] = 40'hd877e3254c;
        sincos_rom_4[916] = 40'hd8c7232929; sincos_rom_4[917] = 40'hd916c32cff; sincos_rom_4[918] = 40'hd966c330cd; sincos_rom_4[919] = 40'hd9b7233493;
        sincos_rom_4[920] = 40'hda07e33852; sincos_rom_4[921] = 40'hda59033c08; sincos_rom_4[922] = 40'hdaaa833fb6; sincos_rom_4[923] = 40'hdafc53435d;
        sincos_rom_4[924] = 40'hdb4e8346fb; sincos_rom_4[925] = 40'hdba1134a91; sincos_rom_4[926] = 40'hdbf3f34e1f; sincos_rom_4[927] = 40'hdc473351a5;
        sincos_rom_4[928] = 40'hdc9ac35523; sincos_rom_4[929] = 40'hdceeb35898; sincos_rom_4[930] = 40'hdd42f35c05; sincos_rom_4[931] = 40'hdd97935f6a;
        sincos_rom_4[932] = 40'hddec8362c7; sincos_rom_4[933] = 40'hde41c3661b; sincos_rom_4[934] = 40'hde97536967; sincos_rom_4[935] = 40'hdeed436caa;
        sincos_rom_4[936] = 40'hdf43736fe5; sincos_rom_4[937] = 40'hdf9a037318; sincos_rom_4[938] = 40'hdff0e37642; sincos_rom_4[939] = 40'he048037963;
        sincos_rom_4[940] = 40'he09f837c7c; sincos_rom_4[941] = 40'he0f7437f8d; sincos_rom_4[942] = 40'he14f538294; sincos_rom_4[943] = 40'he1a7b38593;
        sincos_rom_4[944] = 40'he200538889; sincos_rom_4[945] = 40'he259538b77; sincos_rom_4[946] = 40'he2b2838e5c; sincos_rom_4[947] = 40'he30c139138;
        sincos_rom_4[948] = 40'he365d3940b; sincos_rom_4[949] = 40'he3bfe396d6; sincos_rom_4[950] = 40'he41a439997; sincos_rom_4[951] = 40'he474e39c50;
        sincos_rom_4[952] = 40'he4cfc39f00; sincos_rom_4[953] = 40'he52ae3a1a7; sincos_rom_4[954] = 40'he58643a444; sincos_rom_4[955] = 40'he5e1f3a6d9;
        sincos_rom_4[956] = 40'he63dd3a965; sincos_rom_4[957] = 40'he69a03abe8; sincos_rom_4[958] = 40'he6f663ae62; sincos_rom_4[959] = 40'he75303b0d3;
        sincos_rom_4[960] = 40'he7afe3b33a; sincos_rom_4[961] = 40'he80d03b599; sincos_rom_4[962] = 40'he86a53b7ee; sincos_rom_4[963] = 40'he8c7e3ba3a;
        sincos_rom_4[964] = 40'he925b3bc7d; sincos_rom_4[965] = 40'he983b3beb7; sincos_rom_4[966] = 40'he9e1f3c0e7; sincos_rom_4[967] = 40'hea4063c30f;
        sincos_rom_4[968] = 40'hea9f13c52d; sincos_rom_4[969] = 40'heafde3c741; sincos_rom_4[970] = 40'heb5cf3c94d; sincos_rom_4[971] = 40'hebbc33cb4f;
        sincos_rom_4[972] = 40'hec1bb3cd47; sincos_rom_4[973] = 40'hec7b53cf36; sincos_rom_4[974] = 40'hecdb23d11c; sincos_rom_4[975] = 40'hed3b33d2f9;
        sincos_rom_4[976] = 40'hed9b63d4cc; sincos_rom_4[977] = 40'hedfbc3d695; sincos_rom_4[978] = 40'hee5c53d855; sincos_rom_4[979] = 40'heebd03da0c;
        sincos_rom_4[980] = 40'hef1de3dbb9; sincos_rom_4[981] = 40'hef7ef3dd5d; sincos_rom_4[982] = 40'hefe033def7; sincos_rom_4[983] = 40'hf04183e087;
        sincos_rom_4[984] = 40'hf0a313e20e; sincos_rom_4[985] = 40'hf104b3e38b; sincos_rom_4[986] = 40'hf16683e4ff; sincos_rom_4[987] = 40'hf1c883e669;
        sincos_rom_4[988] = 40'hf22a93e7ca; sincos_rom_4[989] = 40'hf28cc3e920; sincos_rom_4[990] = 40'hf2ef23ea6e; sincos_rom_4[991] = 40'hf351a3ebb1;
        sincos_rom_4[992] = 40'hf3b433eceb; sincos_rom_4[993] = 40'hf416f3ee1b; sincos_rom_4[994] = 40'hf479c3ef42; sincos_rom_4[995] = 40'hf4dcb3f05f;
        sincos_rom_4[996] = 40'hf53fc3f172; sincos_rom_4[997] = 40'hf5a2e3f27b; sincos_rom_4[998] = 40'hf60623f37b; sincos_rom_4[999] = 40'hf66983f470;
        sincos_rom_4[1000] = 40'hf6ccf3f55c; sincos_rom_4[1001] = 40'hf73073f63f; sincos_rom_4[1002] = 40'hf79413f717; sincos_rom_4[1003] = 40'hf7f7c3f7e6;
        sincos_rom_4[1004] = 40'hf85b93f8ab; sincos_rom_4[1005] = 40'hf8bf63f966; sincos_rom_4[1006] = 40'hf92353fa18; sincos_rom_4[1007] = 40'hf98753fabf;
        sincos_rom_4[1008] = 40'hf9eb53fb5d; sincos_rom_4[1009] = 40'hfa4f73fbf1; sincos_rom_4[1010] = 40'hfab3a3fc7b; sincos_rom_4[1011] = 40'hfb17d3fcfb;
        sincos_rom_4[1012] = 40'hfb7c13fd72; sincos_rom_4[1013] = 40'hfbe063fdde; sincos_rom_4[1014] = 40'hfc44b3fe41; sincos_rom_4[1015] = 40'hfca913fe9a;
        sincos_rom_4[1016] = 40'hfd0d83fee9; sincos_rom_4[1017] = 40'hfd71f3ff2e; sincos_rom_4[1018] = 40'hfdd663ff69; sincos_rom_4[1019] = 40'hfe3ae3ff9b;
        sincos_rom_4[1020] = 40'hfe9f63ffc2; sincos_rom_4[1021] = 40'hff03e3ffe0; sincos_rom_4[1022] = 40'hff6873fff4; sincos_rom_4[1023] = 40'hffccf3fffe;
    end

    // ---- stage 0 ----
    // angles
    wire signed [0:-16] angles_n4 = {1'b0, phi_a} - {1'b0, phi_n}; // s17f16
    wire [-1:-16] angles_delta = angles_n4[-1:-16]; // u16f16
    wire [0:-16] angles_n6 = {1'b0, theta_a} + {1'b0, angles_delta}; // u17f16
    wire [-1:-16] angles_ang_x = angles_n6[-1:-16]; // u16f16
    wire signed [0:-16] angles_n8 = {1'b0, theta_a} - {1'b0, angles_delta}; // s17f16
    wire [-1:-16] angles_ang_y = angles_n8[-1:-16]; // u16f16
    wire [0:-16] angles_n10 = {1'b0, angles_ang_x} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] angles_x_plus_n = angles_n10[-1:-16]; // u16f16
    wire signed [0:-16] angles_n12 = {1'b0, angles_ang_x} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] angles_x_minus_n = angles_n12[-1:-16]; // u16f16
    wire [0:-16] angles_n14 = {1'b0, angles_ang_y} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] angles_y_plus_n = angles_n14[-1:-16]; // u16f16
    wire signed [0:-16] angles_n16 = {1'b0, angles_ang_y} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] angles_y_minus_n = angles_n16[-1:-16]; // u16f16
    wire [0:-16] angles_n18 = {1'b0, theta_a} + {1'b0, theta_n}; // u17f16
    wire [-1:-16] angles_a_plus_n = angles_n18[-1:-16]; // u16f16
    wire signed [0:-16] angles_n20 = {1'b0, theta_a} - {1'b0, theta_n}; // s17f16
    wire [-1:-16] angles_a_minus_n = angles_n20[-1:-16]; // u16f16
    // sincos
    wire [9:0] sincos_n22 = angles_ang_y[-1:-10]; // u10f0
    wire [9:0] sincos_n24 = angles_ang_x[-1:-10]; // u10f0
    wire [9:0] sincos_n26 = angles_x_plus_n[-1:-10]; // u10f0
    wire [9:0] sincos_n29 = angles_x_minus_n[-1:-10]; // u10f0
    wire [9:0] sincos_n32 = angles_y_plus_n[-1:-10]; // u10f0
    wire [9:0] sincos_n35 = angles_y_minus_n[-1:-10]; // u10f0
    wire [9:0] sincos_n38 = angles_a_plus_n[-1:-10]; // u10f0
    wire [9:0] sincos_n41 = angles_a_minus_n[-1:-10]; // u10f0
    // azimuth
    wire azimuth_n65 = 1'b0; // u1f0
    wire azimuth_n76 = 1'b1; // u1f0
    wire signed [-1:-24] azimuth_n77 = 24'hb8f8f2; // s24f24
    wire signed [-1:-24] azimuth_n78 = 24'h0; // s24f24
    wire signed [-1:-24] azimuth_n84 = 24'h200000; // s24f24
    wire signed [-1:-24] azimuth_n95 = 24'h12e405; // s24f24
    wire signed [-1:-24] azimuth_n106 = 24'h9fb38; // s24f24
    wire signed [-1:-24] azimuth_n117 = 24'h51112; // s24f24
    wire signed [-1:-24] azimuth_n128 = 24'h28b0d; // s24f24
    wire signed [-1:-24] azimuth_n139 = 24'h145d8; // s24f24
    wire signed [-1:-24] azimuth_n150 = 24'ha2f6; // s24f24
    wire signed [-1:-24] azimuth_n161 = 24'h517c; // s24f24
    wire signed [-1:-24] azimuth_n172 = 24'h28be; // s24f24
    wire signed [-1:-24] azimuth_n183 = 24'h145f; // s24f24
    wire signed [-1:-24] azimuth_n194 = 24'ha30; // s24f24
    wire signed [-1:-24] azimuth_n205 = 24'h518; // s24f24
    wire signed [-1:-24] azimuth_n216 = 24'h28c; // s24f24
    wire signed [-1:-24] azimuth_n227 = 24'h146; // s24f24
    wire signed [-1:-24] azimuth_n238 = 24'ha3; // s24f24
    wire signed [-1:-24] azimuth_n249 = 24'h51; // s24f24
    wire signed [-1:-24] azimuth_n260 = 24'h29; // s24f24
    wire signed [-1:-24] azimuth_n268 = 24'h14; // s24f24
    wire [-1:-24] azimuth_n273 = 24'h800000; // u24f24

    reg [39:0] sincos_row;
    reg [39:0] sincos_row_2;
    reg [39:0] sincos_row_3;
    reg [39:0] sincos_row_4;
    reg [39:0] sincos_row_5;
    reg [39:0] sincos_row_6;
    reg [39:0] sincos_row_7;
    reg [39:0] sincos_row_8;
    always @(posedge clk)
        if (ce) begin
            sincos_row <= sincos_rom[sincos_n22];
            sincos_row_2 <= sincos_rom[sincos_n24];
            sincos_row_3 <= sincos_rom_2[sincos_n26];
            sincos_row_4 <= sincos_rom_2[sincos_n29];
            sincos_row_5 <= sincos_rom_3[sincos_n32];
            sincos_row_6 <= sincos_rom_3[sincos_n35];
            sincos_row_7 <= sincos_rom_4[sincos_n38];
            sincos_row_8 <= sincos_rom_4[sincos_n41];
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // sincos
    wire signed [1:-18] sincos_cos_y = sincos_row[19:0]; // s20f18
    wire signed [1:-18] sincos_cos_x = sincos_row_2[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_xpn = sincos_row_3[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_xpn = sincos_row_3[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_xmn = sincos_row_4[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_xmn = sincos_row_4[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_ypn = sincos_row_5[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_ypn = sincos_row_5[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_ymn = sincos_row_6[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_ymn = sincos_row_6[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_apn = sincos_row_7[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_apn = sincos_row_7[19:0]; // s20f18
    wire signed [1:-18] sincos_sin_amn = sincos_row_8[39:20]; // s20f18
    wire signed [1:-18] sincos_cos_amn = sincos_row_8[19:0]; // s20f18
    // sums
    wire signed [2:-18] sums_n44 = {sincos_sin_xpn[1], sincos_sin_xpn} + {sincos_sin_xmn[1], sincos_sin_xmn}; // s21f18
    wire signed [2:-18] sums_n45 = {sincos_sin_ypn[1], sincos_sin_ypn} + {sincos_sin_ymn[1], sincos_sin_ymn}; // s21f18
    wire signed [3:-18] sums_n46 = {sums_n44[2], sums_n44} + {sums_n45[2], sums_n45}; // s22f18
    wire signed [1:-20] sums_n47 = sums_n46; // s22f20
    wire signed [2:-18] sums_n48 = {sincos_sin_apn[1], sincos_sin_apn} - {sincos_sin_amn[1], sincos_sin_amn}; // s21f18
    wire signed [1:-19] sums_n49 = sums_n48; // s21f19
    wire signed [2:-18] sums_n51 = {sincos_cos_y[1], sincos_cos_y} - {sincos_cos_x[1], sincos_cos_x}; // s21f18
    wire signed [1:-19] sums_y_sum = sums_n51; // s21f19
    wire signed [2:-18] sums_n53 = {sincos_cos_xmn[1], sincos_cos_xmn} - {sincos_cos_xpn[1], sincos_cos_xpn}; // s21f18
    wire signed [2:-18] sums_n54 = {sincos_cos_ymn[1], sincos_cos_ymn} - {sincos_cos_ypn[1], sincos_cos_ypn}; // s21f18
    wire signed [3:-18] sums_n55 = {sums_n53[2], sums_n53} + {sums_n54[2], sums_n54}; // s22f18
    wire signed [1:-20] sums_n56 = sums_n55; // s22f20
    wire signed [2:-18] sums_n57 = {sincos_cos_apn[1], sincos_cos_apn} + {sincos_cos_amn[1], sincos_cos_amn}; // s21f18
    wire signed [1:-19] sums_n58 = sums_n57; // s21f19

    reg signed [1:-20] sums_n47_s2; // s22f20
    reg signed [1:-19] sums_n49_s2; // s21f19
    reg signed [1:-19] sums_y_sum_s2; // s21f19
    reg signed [1:-20] sums_n56_s2; // s22f20
    reg signed [1:-19] sums_n58_s2; // s21f19
    always @(posedge clk)
        if (ce) begin
            sums_n47_s2 <= sums_n47;
            sums_n49_s2 <= sums_n49;
            sums_y_sum_s2 <= sums_y_sum;
            sums_n56_s2 <= sums_n56;
            sums_n58_s2 <= sums_n58;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // sums
    wire signed [2:-20] sums_x_sum = {sums_n47_s2[1], sums_n47_s2} - {sums_n49_s2[1], sums_n49_s2, 1'b0}; // s23f20
    wire signed [2:-20] sums_z_sum = {sums_n56_s2[1], sums_n56_s2} + {sums_n58_s2[1], sums_n58_s2, 1'b0}; // s23f20
    // (unit)
    wire signed [3:-20] x_sum = {sums_x_sum[2], sums_x_sum} + 24'h2;
    wire signed [3:-18] x_cut = x_sum[3:-18];
    wire x_over = ~x_cut[3] & (|x_cut[2:1]);
    wire x_under = x_cut[3] & ~(&x_cut[2:1]);
    wire signed [1:-18] x = x_over ? 20'h7ffff : x_under ? 20'h80000 : x_cut[1:-18]; // s20f18
    wire signed [2:-19] y_sum = {sums_y_sum_s2[1], sums_y_sum_s2} + 22'h1;
    wire signed [2:-18] y_cut = y_sum[2:-18];
    wire y_over = ~y_cut[2] & (|y_cut[1]);
    wire signed [1:-18] y = y_over ? 20'h7ffff : y_cut[1:-18]; // s20f18
    wire signed [3:-20] z_sum = {sums_z_sum[2], sums_z_sum} + 24'h2;
    wire signed [3:-18] z_cut = z_sum[3:-18];
    wire z_over = ~z_cut[3] & (|z_cut[2:1]);
    wire z_under = z_cut[3] & ~(&z_cut[2:1]);
    wire signed [1:-18] z = z_over ? 20'h7ffff : z_under ? 20'h80000 : z_cut[1:-18]; // s20f18
    // azimuth
    wire signed [1:-24] azimuth_n63_wide = {x, 6'h0};
    wire signed [2:-24] azimuth_n63 = {azimuth_n63_wide[1], azimuth_n63_wide}; // s27f24
    wire signed [1:-24] azimuth_n64_wide = {y, 6'h0};
    wire signed [2:-24] azimuth_n64 = {azimuth_n64_wide[1], azimuth_n64_wide}; // s27f24
    wire azimuth_n66 = azimuth_n63 == {2'h0, azimuth_n65, 24'h0}; // u1f0
    wire azimuth_n67 = azimuth_n64 == {2'h0, azimuth_n65, 24'h0}; // u1f0
    wire azimuth_n69 = azimuth_n63[2]; // u1f0
    wire signed [3:-24] azimuth_n70 = -{azimuth_n63[2], azimuth_n63}; // s28f24
    wire signed [3:-24] azimuth_n71 = -{azimuth_n64[2], azimuth_n64}; // s28f24
    wire signed [3:-24] azimuth_n73 = azimuth_n69 ? azimuth_n71 : {azimuth_n64[2], azimuth_n64}; // s28f24
    wire azimuth_n75_over = ~azimuth_n73[3] & (|azimuth_n73[2]);
    wire azimuth_n75_under = azimuth_n73[3] & ~(&azimuth_n73[2]);
    wire signed [2:-24] azimuth_n75 = azimuth_n75_over ? 27'h3ffffff : azimuth_n75_under ? 27'h4000000 : azimuth_n73[2:-24]; // s27f24
    wire azimuth_n80 = azimuth_n75[2]; // u1f0
    // polar_angle
    wire signed [-23:-42] polar_angle_n276 = z; // s20f42
    wire signed [-21:-40] polar_angle_n277 = z; // s20f40
    wire signed [-20:-42] polar_angle_n278 = {{3{polar_angle_n276[-23]}}, polar_angle_n276} + {polar_angle_n277[-21], polar_angle_n277, 2'h0}; // s23f42
    wire signed [-19:-38] polar_angle_n279 = z; // s20f38
    wire signed [-14:-33] polar_angle_n281 = z; // s20f33
    wire signed [-11:-30] polar_angle_n283 = z; // s20f30
    wire signed [-8:-27] polar_angle_n285 = z; // s20f27
    wire signed [-6:-25] polar_angle_n287 = z; // s20f25
    wire signed [-4:-23] polar_angle_n289 = z; // s20f23
    wire signed [-2:-21] polar_angle_n291 = z; // s20f21
    wire signed [0:-19] polar_angle_n293 = z; // s20f19
    wire signed [2:-17] polar_angle_n295 = z; // s20f17

    reg signed [2:-24] azimuth_n63_s3; // s27f24
    reg azimuth_n66_s3; // u1f0
    reg azimuth_n67_s3; // u1f0
    reg azimuth_n69_s3; // u1f0
    reg signed [3:-24] azimuth_n70_s3; // s28f24
    reg signed [2:-24] azimuth_n75_s3; // s27f24
    reg azimuth_n80_s3; // u1f0
    reg signed [-20:-42] polar_angle_n278_s3; // s23f42
    reg signed [-19:-38] polar_angle_n279_s3; // s20f38
    reg signed [-14:-33] polar_angle_n281_s3; // s20f33
    reg signed [-11:-30] polar_angle_n283_s3; // s20f30
    reg signed [-8:-27] polar_angle_n285_s3; // s20f27
    reg signed [-6:-25] polar_angle_n287_s3; // s20f25
    reg signed [-4:-23] polar_angle_n289_s3; // s20f23
    reg signed [-2:-21] polar_angle_n291_s3; // s20f21
    reg signed [0:-19] polar_angle_n293_s3; // s20f19
    reg signed [2:-17] polar_angle_n295_s3; // s20f17
    always @(posedge clk)
        if (ce) begin
            azimuth_n63_s3 <= azimuth_n63;
            azimuth_n66_s3 <= azimuth_n66;
            azimuth_n67_s3 <= azimuth_n67;
            azimuth_n69_s3 <= azimuth_n69;
            azimuth_n70_s3 <= azimuth_n70;
            azimuth_n75_s3 <= azimuth_n75;
            azimuth_n80_s3 <= azimuth_n80;
            polar_angle_n278_s3 <= polar_angle_n278;
            polar_angle_n279_s3 <= polar_angle_n279;
            polar_angle_n281_s3 <= polar_angle_n281;
            polar_angle_n283_s3 <= polar_angle_n283;
            polar_angle_n285_s3 <= polar_angle_n285;
            polar_angle_n287_s3 <= polar_angle_n287;
            polar_angle_n289_s3 <= polar_angle_n289;
            polar_angle_n291_s3 <= polar_angle_n291;
            polar_angle_n293_s3 <= polar_angle_n293;
            polar_angle_n295_s3 <= polar_angle_n295;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // azimuth
    wire azimuth_n68 = azimuth_n66_s3 & azimuth_n67_s3; // u1f0
    wire signed [3:-24] azimuth_n72 = azimuth_n69_s3 ? azimuth_n70_s3 : {azimuth_n63_s3[2], azimuth_n63_s3}; // s28f24
    wire azimuth_n74_over = ~azimuth_n72[3] & (|azimuth_n72[2]);
    wire azimuth_n74_under = azimuth_n72[3] & ~(&azimuth_n72[2]);
    wire signed [2:-24] azimuth_n74 = azimuth_n74_over ? 27'h3ffffff : azimuth_n74_under ? 27'h4000000 : azimuth_n72[2:-24]; // s27f24
    wire signed [-1:-24] azimuth_n79 = azimuth_n68 ? azimuth_n77 : azimuth_n78; // s24f24
    wire azimuth_n81 = azimuth_n80_s3 ^ azimuth_n76; // u1f0
    wire [3:-24] azimuth_n82_term = {azimuth_n75_s3[2], azimuth_n75_s3} ^ {28{azimuth_n80_s3}};
    wire signed [3:-24] azimuth_n82 = {azimuth_n74[2], azimuth_n74} + azimuth_n82_term + {27'h0, azimuth_n80_s3}; // s28f24
    wire [3:-24] azimuth_n83_term = {azimuth_n74[2], azimuth_n74} ^ {28{azimuth_n81}};
    wire signed [3:-24] azimuth_n83 = {azimuth_n75_s3[2], azimuth_n75_s3} + azimuth_n83_term + {27'h0, azimuth_n81}; // s28f24
    wire [0:-24] azimuth_n85_term = {azimuth_n84[-1], azimuth_n84} ^ {25{azimuth_n80_s3}};
    wire signed [0:-24] azimuth_n85 = {azimuth_n79[-1], azimuth_n79} + azimuth_n85_term + {24'h0, azimuth_n80_s3}; // s25f24
    wire azimuth_n86_over = ~azimuth_n85[0] & (|azimuth_n85[-1]);
    wire azimuth_n86_under = azimuth_n85[0] & ~(&azimuth_n85[-1]);
    wire signed [-1:-24] azimuth_n86 = azimuth_n86_over ? 24'h7fffff : azimuth_n86_under ? 24'h800000 : azimuth_n85[-1:-24]; // s24f24
    wire azimuth_n87_over = ~azimuth_n82[3] & (|azimuth_n82[2]);
    wire azimuth_n87_under = azimuth_n82[3] & ~(&azimuth_n82[2]);
    wire signed [2:-24] azimuth_n87 = azimuth_n87_over ? 27'h3ffffff : azimuth_n87_under ? 27'h4000000 : azimuth_n82[2:-24]; // s27f24
    wire azimuth_n88_over = ~azimuth_n83[3] & (|azimuth_n83[2]);
    wire azimuth_n88_under = azimuth_n83[3] & ~(&azimuth_n83[2]);
    wire signed [2:-24] azimuth_n88 = azimuth_n88_over ? 27'h3ffffff : azimuth_n88_under ? 27'h4000000 : azimuth_n83[2:-24]; // s27f24
    wire azimuth_n89 = azimuth_n88[2]; // u1f0
    wire azimuth_n90 = azimuth_n89 ^ azimuth_n76; // u1f0
    wire signed [1:-25] azimuth_n91 = azimuth_n88; // s27f25
    wire signed [1:-25] azimuth_n92 = azimuth_n87; // s27f25
    wire [3:-25] azimuth_n93_term = {{2{azimuth_n91[1]}}, azimuth_n91} ^ {29{azimuth_n89}};
    wire signed [3:-25] azimuth_n93 = {azimuth_n87[2], azimuth_n87, 1'b0} + azimuth_n93_term + {28'h0, azimuth_n89}; // s29f25
    wire [0:-24] azimuth_n96_term = {azimuth_n95[-1], azimuth_n95} ^ {25{azimuth_n89}};
    wire signed [0:-24] azimuth_n96 = {azimuth_n86[-1], azimuth_n86} + azimuth_n96_term + {24'h0, azimuth_n89}; // s25f24
    // polar_angle
    wire signed [-18:-42] polar_angle_n280 = {{2{polar_angle_n278_s3[-20]}}, polar_angle_n278_s3} + {polar_angle_n279_s3[-19], polar_angle_n279_s3, 4'h0}; // s25f42
    wire signed [-13:-42] polar_angle_n282 = {{5{polar_angle_n280[-18]}}, polar_angle_n280} + {polar_angle_n281_s3[-14], polar_angle_n281_s3, 9'h0}; // s30f42
    wire signed [-10:-42] polar_angle_n284 = {{3{polar_angle_n282[-13]}}, polar_angle_n282} + {polar_angle_n283_s3[-11], polar_angle_n283_s3, 12'h0}; // s33f42

    reg azimuth_n69_s4; // u1f0
    reg signed [2:-24] azimuth_n88_s4; // s27f24
    reg azimuth_n90_s4; // u1f0
    reg signed [1:-25] azimuth_n92_s4; // s27f25
    reg signed [3:-25] azimuth_n93_s4; // s29f25
    reg signed [0:-24] azimuth_n96_s4; // s25f24
    reg signed [-10:-42] polar_angle_n284_s4; // s33f42
    reg signed [-8:-27] polar_angle_n285_s4; // s20f27
    reg signed [-6:-25] polar_angle_n287_s4; // s20f25
    reg signed [-4:-23] polar_angle_n289_s4; // s20f23
    reg signed [-2:-21] polar_angle_n291_s4; // s20f21
    reg signed [0:-19] polar_angle_n293_s4; // s20f19
    reg signed [2:-17] polar_angle_n295_s4; // s20f17
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s4 <= azimuth_n69_s3;
            azimuth_n88_s4 <= azimuth_n88;
            azimuth_n90_s4 <= azimuth_n90;
            azimuth_n92_s4 <= azimuth_n92;
            azimuth_n93_s4 <= azimuth_n93;
            azimuth_n96_s4 <= azimuth_n96;
            polar_angle_n284_s4 <= polar_angle_n284;
            polar_angle_n285_s4 <= polar_angle_n285_s3;
            polar_angle_n287_s4 <= polar_angle_n287_s3;
            polar_angle_n289_s4 <= polar_angle_n289_s3;
            polar_angle_n291_s4 <= polar_angle_n291_s3;
            polar_angle_n293_s4 <= polar_angle_n293_s3;
            polar_angle_n295_s4 <= polar_angle_n295_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // azimuth
    wire [3:-25] azimuth_n94_term = {{2{azimuth_n92_s4[1]}}, azimuth_n92_s4} ^ {29{azimuth_n90_s4}};
    wire signed [3:-25] azimuth_n94 = {azimuth_n88_s4[2], azimuth_n88_s4, 1'b0} + azimuth_n94_term + {28'h0, azimuth_n90_s4}; // s29f25
    wire azimuth_n97_over = ~azimuth_n96_s4[0] & (|azimuth_n96_s4[-1]);
    wire azimuth_n97_under = azimuth_n96_s4[0] & ~(&azimuth_n96_s4[-1]);
    wire signed [-1:-24] azimuth_n97 = azimuth_n97_over ? 24'h7fffff : azimuth_n97_under ? 24'h800000 : azimuth_n96_s4[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n98_cut = azimuth_n93_s4[3:-24];
    wire azimuth_n98_over = ~azimuth_n98_cut[3] & (|azimuth_n98_cut[2]);
    wire azimuth_n98_under = azimuth_n98_cut[3] & ~(&azimuth_n98_cut[2]);
    wire signed [2:-24] azimuth_n98 = azimuth_n98_over ? 27'h3ffffff : azimuth_n98_under ? 27'h4000000 : azimuth_n98_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n99_cut = azimuth_n94[3:-24];
    wire azimuth_n99_over = ~azimuth_n99_cut[3] & (|azimuth_n99_cut[2]);
    wire azimuth_n99_under = azimuth_n99_cut[3] & ~(&azimuth_n99_cut[2]);
    wire signed [2:-24] azimuth_n99 = azimuth_n99_over ? 27'h3ffffff : azimuth_n99_under ? 27'h4000000 : azimuth_n99_cut[2:-24]; // s27f24
    wire azimuth_n100 = azimuth_n99[2]; // u1f0
    wire azimuth_n101 = azimuth_n100 ^ azimuth_n76; // u1f0
    wire signed [0:-26] azimuth_n102 = azimuth_n99; // s27f26
    wire signed [0:-26] azimuth_n103 = azimuth_n98; // s27f26
    wire [3:-26] azimuth_n104_term = {{3{azimuth_n102[0]}}, azimuth_n102} ^ {30{azimuth_n100}};
    wire signed [3:-26] azimuth_n104 = {azimuth_n98[2], azimuth_n98, 2'h0} + azimuth_n104_term + {29'h0, azimuth_n100}; // s30f26
    wire [3:-26] azimuth_n105_term = {{3{azimuth_n103[0]}}, azimuth_n103} ^ {30{azimuth_n101}};
    wire signed [3:-26] azimuth_n105 = {azimuth_n99[2], azimuth_n99, 2'h0} + azimuth_n105_term + {29'h0, azimuth_n101}; // s30f26
    wire [0:-24] azimuth_n107_term = {azimuth_n106[-1], azimuth_n106} ^ {25{azimuth_n100}};
    wire signed [0:-24] azimuth_n107 = {azimuth_n97[-1], azimuth_n97} + azimuth_n107_term + {24'h0, azimuth_n100}; // s25f24
    wire azimuth_n108_over = ~azimuth_n107[0] & (|azimuth_n107[-1]);
    wire azimuth_n108_under = azimuth_n107[0] & ~(&azimuth_n107[-1]);
    wire signed [-1:-24] azimuth_n108 = azimuth_n108_over ? 24'h7fffff : azimuth_n108_under ? 24'h800000 : azimuth_n107[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n109_cut = azimuth_n104[3:-24];
    wire azimuth_n109_over = ~azimuth_n109_cut[3] & (|azimuth_n109_cut[2]);
    wire azimuth_n109_under = azimuth_n109_cut[3] & ~(&azimuth_n109_cut[2]);
    wire signed [2:-24] azimuth_n109 = azimuth_n109_over ? 27'h3ffffff : azimuth_n109_under ? 27'h4000000 : azimuth_n109_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n110_cut = azimuth_n105[3:-24];
    wire azimuth_n110_over = ~azimuth_n110_cut[3] & (|azimuth_n110_cut[2]);
    wire azimuth_n110_under = azimuth_n110_cut[3] & ~(&azimuth_n110_cut[2]);
    wire signed [2:-24] azimuth_n110 = azimuth_n110_over ? 27'h3ffffff : azimuth_n110_under ? 27'h4000000 : azimuth_n110_cut[2:-24]; // s27f24
    wire azimuth_n111 = azimuth_n110[2]; // u1f0
    wire signed [-1:-27] azimuth_n113 = azimuth_n110; // s27f27
    wire signed [-1:-27] azimuth_n114 = azimuth_n109; // s27f27
    // polar_angle
    wire signed [-7:-42] polar_angle_n286 = {{3{polar_angle_n284_s4[-10]}}, polar_angle_n284_s4} - {polar_angle_n285_s4[-8], polar_angle_n285_s4, 15'h0}; // s36f42
    wire signed [-5:-42] polar_angle_n288 = {{2{polar_angle_n286[-7]}}, polar_angle_n286} - {polar_angle_n287_s4[-6], polar_angle_n287_s4, 17'h0}; // s38f42

    reg azimuth_n69_s5; // u1f0
    reg signed [-1:-24] azimuth_n108_s5; // s24f24
    reg signed [2:-24] azimuth_n109_s5; // s27f24
    reg signed [2:-24] azimuth_n110_s5; // s27f24
    reg azimuth_n111_s5; // u1f0
    reg signed [-1:-27] azimuth_n113_s5; // s27f27
    reg signed [-1:-27] azimuth_n114_s5; // s27f27
    reg signed [-5:-42] polar_angle_n288_s5; // s38f42
    reg signed [-4:-23] polar_angle_n289_s5; // s20f23
    reg signed [-2:-21] polar_angle_n291_s5; // s20f21
    reg signed [0:-19] polar_angle_n293_s5; // s20f19
    reg signed [2:-17] polar_angle_n295_s5; // s20f17
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s5 <= azimuth_n69_s4;
            azimuth_n108_s5 <= azimuth_n108;
            azimuth_n109_s5 <= azimuth_n109;
            azimuth_n110_s5 <= azimuth_n110;
            azimuth_n111_s5 <= azimuth_n111;
            azimuth_n113_s5 <= azimuth_n113;
            azimuth_n114_s5 <= azimuth_n114;
            polar_angle_n288_s5 <= polar_angle_n288;
            polar_angle_n289_s5 <= polar_angle_n289_s4;
            polar_angle_n291_s5 <= polar_angle_n291_s4;
            polar_angle_n293_s5 <= polar_angle_n293_s4;
            polar_angle_n295_s5 <= polar_angle_n295_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // azimuth
    wire azimuth_n112 = azimuth_n111_s5 ^ azimuth_n76; // u1f0
    wire [3:-27] azimuth_n115_term = {{4{azimuth_n113_s5[-1]}}, azimuth_n113_s5} ^ {31{azimuth_n111_s5}};
    wire signed [3:-27] azimuth_n115 = {azimuth_n109_s5[2], azimuth_n109_s5, 3'h0} + azimuth_n115_term + {30'h0, azimuth_n111_s5}; // s31f27
    wire [3:-27] azimuth_n116_term = {{4{azimuth_n114_s5[-1]}}, azimuth_n114_s5} ^ {31{azimuth_n112}};
    wire signed [3:-27] azimuth_n116 = {azimuth_n110_s5[2], azimuth_n110_s5, 3'h0} + azimuth_n116_term + {30'h0, azimuth_n112}; // s31f27
    wire [0:-24] azimuth_n118_term = {azimuth_n117[-1], azimuth_n117} ^ {25{azimuth_n111_s5}};
    wire signed [0:-24] azimuth_n118 = {azimuth_n108_s5[-1], azimuth_n108_s5} + azimuth_n118_term + {24'h0, azimuth_n111_s5}; // s25f24
    wire azimuth_n119_over = ~azimuth_n118[0] & (|azimuth_n118[-1]);
    wire azimuth_n119_under = azimuth_n118[0] & ~(&azimuth_n118[-1]);
    wire signed [-1:-24] azimuth_n119 = azimuth_n119_over ? 24'h7fffff : azimuth_n119_under ? 24'h800000 : azimuth_n118[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n120_cut = azimuth_n115[3:-24];
    wire azimuth_n120_over = ~azimuth_n120_cut[3] & (|azimuth_n120_cut[2]);
    wire azimuth_n120_under = azimuth_n120_cut[3] & ~(&azimuth_n120_cut[2]);
    wire signed [2:-24] azimuth_n120 = azimuth_n120_over ? 27'h3ffffff : azimuth_n120_under ? 27'h4000000 : azimuth_n120_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n121_cut = azimuth_n116[3:-24];
    wire azimuth_n121_over = ~azimuth_n121_cut[3] & (|azimuth_n121_cut[2]);
    wire azimuth_n121_under = azimuth_n121_cut[3] & ~(&azimuth_n121_cut[2]);
    wire signed [2:-24] azimuth_n121 = azimuth_n121_over ? 27'h3ffffff : azimuth_n121_under ? 27'h4000000 : azimuth_n121_cut[2:-24]; // s27f24
    wire azimuth_n122 = azimuth_n121[2]; // u1f0
    wire azimuth_n123 = azimuth_n122 ^ azimuth_n76; // u1f0
    wire signed [-2:-28] azimuth_n124 = azimuth_n121; // s27f28
    wire signed [-2:-28] azimuth_n125 = azimuth_n120; // s27f28
    wire [3:-28] azimuth_n126_term = {{5{azimuth_n124[-2]}}, azimuth_n124} ^ {32{azimuth_n122}};
    wire signed [3:-28] azimuth_n126 = {azimuth_n120[2], azimuth_n120, 4'h0} + azimuth_n126_term + {31'h0, azimuth_n122}; // s32f28
    wire [3:-28] azimuth_n127_term = {{5{azimuth_n125[-2]}}, azimuth_n125} ^ {32{azimuth_n123}};
    wire signed [3:-28] azimuth_n127 = {azimuth_n121[2], azimuth_n121, 4'h0} + azimuth_n127_term + {31'h0, azimuth_n123}; // s32f28
    wire [0:-24] azimuth_n129_term = {azimuth_n128[-1], azimuth_n128} ^ {25{azimuth_n122}};
    wire signed [0:-24] azimuth_n129 = {azimuth_n119[-1], azimuth_n119} + azimuth_n129_term + {24'h0, azimuth_n122}; // s25f24
    wire azimuth_n130_over = ~azimuth_n129[0] & (|azimuth_n129[-1]);
    wire azimuth_n130_under = azimuth_n129[0] & ~(&azimuth_n129[-1]);
    wire signed [-1:-24] azimuth_n130 = azimuth_n130_over ? 24'h7fffff : azimuth_n130_under ? 24'h800000 : azimuth_n129[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n131_cut = azimuth_n126[3:-24];
    wire azimuth_n131_over = ~azimuth_n131_cut[3] & (|azimuth_n131_cut[2]);
    wire azimuth_n131_under = azimuth_n131_cut[3] & ~(&azimuth_n131_cut[2]);
    wire signed [2:-24] azimuth_n131 = azimuth_n131_over ? 27'h3ffffff : azimuth_n131_under ? 27'h4000000 : azimuth_n131_cut[2:-24]; // s27f24
    wire signed [-3:-29] azimuth_n136 = azimuth_n131; // s27f29
    // polar_angle
    wire signed [-3:-42] polar_angle_n290 = {{2{polar_angle_n288_s5[-5]}}, polar_angle_n288_s5} + {polar_angle_n289_s5[-4], polar_angle_n289_s5, 19'h0}; // s40f42
    wire signed [-1:-42] polar_angle_n292 = {{2{polar_angle_n290[-3]}}, polar_angle_n290} + {polar_angle_n291_s5[-2], polar_angle_n291_s5, 21'h0}; // s42f42

    reg azimuth_n69_s6; // u1f0
    reg signed [3:-28] azimuth_n127_s6; // s32f28
    reg signed [-1:-24] azimuth_n130_s6; // s24f24
    reg signed [2:-24] azimuth_n131_s6; // s27f24
    reg signed [-3:-29] azimuth_n136_s6; // s27f29
    reg signed [-1:-42] polar_angle_n292_s6; // s42f42
    reg signed [0:-19] polar_angle_n293_s6; // s20f19
    reg signed [2:-17] polar_angle_n295_s6; // s20f17
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s6 <= azimuth_n69_s5;
            azimuth_n127_s6 <= azimuth_n127;
            azimuth_n130_s6 <= azimuth_n130;
            azimuth_n131_s6 <= azimuth_n131;
            azimuth_n136_s6 <= azimuth_n136;
            polar_angle_n292_s6 <= polar_angle_n292;
            polar_angle_n293_s6 <= polar_angle_n293_s5;
            polar_angle_n295_s6 <= polar_angle_n295_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // azimuth
    wire signed [3:-24] azimuth_n132_cut = azimuth_n127_s6[3:-24];
    wire azimuth_n132_over = ~azimuth_n132_cut[3] & (|azimuth_n132_cut[2]);
    wire azimuth_n132_under = azimuth_n132_cut[3] & ~(&azimuth_n132_cut[2]);
    wire signed [2:-24] azimuth_n132 = azimuth_n132_over ? 27'h3ffffff : azimuth_n132_under ? 27'h4000000 : azimuth_n132_cut[2:-24]; // s27f24
    wire azimuth_n133 = azimuth_n132[2]; // u1f0
    wire azimuth_n134 = azimuth_n133 ^ azimuth_n76; // u1f0
    wire signed [-3:-29] azimuth_n135 = azimuth_n132; // s27f29
    wire [3:-29] azimuth_n137_term = {{6{azimuth_n135[-3]}}, azimuth_n135} ^ {33{azimuth_n133}};
    wire signed [3:-29] azimuth_n137 = {azimuth_n131_s6[2], azimuth_n131_s6, 5'h0} + azimuth_n137_term + {32'h0, azimuth_n133}; // s33f29
    wire [3:-29] azimuth_n138_term = {{6{azimuth_n136_s6[-3]}}, azimuth_n136_s6} ^ {33{azimuth_n134}};
    wire signed [3:-29] azimuth_n138 = {azimuth_n132[2], azimuth_n132, 5'h0} + azimuth_n138_term + {32'h0, azimuth_n134}; // s33f29
    wire [0:-24] azimuth_n140_term = {azimuth_n139[-1], azimuth_n139} ^ {25{azimuth_n133}};
    wire signed [0:-24] azimuth_n140 = {azimuth_n130_s6[-1], azimuth_n130_s6} + azimuth_n140_term + {24'h0, azimuth_n133}; // s25f24
    wire azimuth_n141_over = ~azimuth_n140[0] & (|azimuth_n140[-1]);
    wire azimuth_n141_under = azimuth_n140[0] & ~(&azimuth_n140[-1]);
    wire signed [-1:-24] azimuth_n141 = azimuth_n141_over ? 24'h7fffff : azimuth_n141_under ? 24'h800000 : azimuth_n140[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n142_cut = azimuth_n137[3:-24];
    wire azimuth_n142_over = ~azimuth_n142_cut[3] & (|azimuth_n142_cut[2]);
    wire azimuth_n142_under = azimuth_n142_cut[3] & ~(&azimuth_n142_cut[2]);
    wire signed [2:-24] azimuth_n142 = azimuth_n142_over ? 27'h3ffffff : azimuth_n142_under ? 27'h4000000 : azimuth_n142_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n143_cut = azimuth_n138[3:-24];
    wire azimuth_n143_over = ~azimuth_n143_cut[3] & (|azimuth_n143_cut[2]);
    wire azimuth_n143_under = azimuth_n143_cut[3] & ~(&azimuth_n143_cut[2]);
    wire signed [2:-24] azimuth_n143 = azimuth_n143_over ? 27'h3ffffff : azimuth_n143_under ? 27'h4000000 : azimuth_n143_cut[2:-24]; // s27f24
    wire azimuth_n144 = azimuth_n143[2]; // u1f0
    wire azimuth_n145 = azimuth_n144 ^ azimuth_n76; // u1f0
    wire signed [-4:-30] azimuth_n146 = azimuth_n143; // s27f30
    wire signed [-4:-30] azimuth_n147 = azimuth_n142; // s27f30
    wire [0:-24] azimuth_n151_term = {azimuth_n150[-1], azimuth_n150} ^ {25{azimuth_n144}};
    wire signed [0:-24] azimuth_n151 = {azimuth_n141[-1], azimuth_n141} + azimuth_n151_term + {24'h0, azimuth_n144}; // s25f24
    // polar_angle
    wire signed [1:-42] polar_angle_n294 = {{2{polar_angle_n292_s6[-1]}}, polar_angle_n292_s6} - {polar_angle_n293_s6[0], polar_angle_n293_s6, 23'h0}; // s44f42
    wire signed [3:-42] polar_angle_n296 = {{2{polar_angle_n294[1]}}, polar_angle_n294} + {polar_angle_n295_s6[2], polar_angle_n295_s6, 25'h0}; // s46f42
    wire signed [3:-24] polar_angle_n297_cut = polar_angle_n296[3:-24];
    wire polar_angle_n297_over = ~polar_angle_n297_cut[3] & (|polar_angle_n297_cut[2]);
    wire polar_angle_n297_under = polar_angle_n297_cut[3] & ~(&polar_angle_n297_cut[2]);
    wire signed [2:-24] polar_angle_n297 = polar_angle_n297_over ? 27'h3ffffff : polar_angle_n297_under ? 27'h4000000 : polar_angle_n297_cut[2:-24]; // s27f24
    wire polar_angle_n301 = polar_angle_n297[2]; // u1f0

    reg azimuth_n69_s7; // u1f0
    reg signed [2:-24] azimuth_n142_s7; // s27f24
    reg signed [2:-24] azimuth_n143_s7; // s27f24
    reg azimuth_n144_s7; // u1f0
    reg azimuth_n145_s7; // u1f0
    reg signed [-4:-30] azimuth_n146_s7; // s27f30
    reg signed [-4:-30] azimuth_n147_s7; // s27f30
    reg signed [0:-24] azimuth_n151_s7; // s25f24
    reg signed [2:-24] polar_angle_n297_s7; // s27f24
    reg polar_angle_n301_s7; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s7 <= azimuth_n69_s6;
            azimuth_n142_s7 <= azimuth_n142;
            azimuth_n143_s7 <= azimuth_n143;
            azimuth_n144_s7 <= azimuth_n144;
            azimuth_n145_s7 <= azimuth_n145;
            azimuth_n146_s7 <= azimuth_n146;
            azimuth_n147_s7 <= azimuth_n147;
            azimuth_n151_s7 <= azimuth_n151;
            polar_angle_n297_s7 <= polar_angle_n297;
            polar_angle_n301_s7 <= polar_angle_n301;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // azimuth
    wire [3:-30] azimuth_n148_term = {{7{azimuth_n146_s7[-4]}}, azimuth_n146_s7} ^ {34{azimuth_n144_s7}};
    wire signed [3:-30] azimuth_n148 = {azimuth_n142_s7[2], azimuth_n142_s7, 6'h0} + azimuth_n148_term + {33'h0, azimuth_n144_s7}; // s34f30
    wire [3:-30] azimuth_n149_term = {{7{azimuth_n147_s7[-4]}}, azimuth_n147_s7} ^ {34{azimuth_n145_s7}};
    wire signed [3:-30] azimuth_n149 = {azimuth_n143_s7[2], azimuth_n143_s7, 6'h0} + azimuth_n149_term + {33'h0, azimuth_n145_s7}; // s34f30
    wire azimuth_n152_over = ~azimuth_n151_s7[0] & (|azimuth_n151_s7[-1]);
    wire azimuth_n152_under = azimuth_n151_s7[0] & ~(&azimuth_n151_s7[-1]);
    wire signed [-1:-24] azimuth_n152 = azimuth_n152_over ? 24'h7fffff : azimuth_n152_under ? 24'h800000 : azimuth_n151_s7[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n153_cut = azimuth_n148[3:-24];
    wire azimuth_n153_over = ~azimuth_n153_cut[3] & (|azimuth_n153_cut[2]);
    wire azimuth_n153_under = azimuth_n153_cut[3] & ~(&azimuth_n153_cut[2]);
    wire signed [2:-24] azimuth_n153 = azimuth_n153_over ? 27'h3ffffff : azimuth_n153_under ? 27'h4000000 : azimuth_n153_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n154_cut = azimuth_n149[3:-24];
    wire azimuth_n154_over = ~azimuth_n154_cut[3] & (|azimuth_n154_cut[2]);
    wire azimuth_n154_under = azimuth_n154_cut[3] & ~(&azimuth_n154_cut[2]);
    wire signed [2:-24] azimuth_n154 = azimuth_n154_over ? 27'h3ffffff : azimuth_n154_under ? 27'h4000000 : azimuth_n154_cut[2:-24]; // s27f24
    wire azimuth_n155 = azimuth_n154[2]; // u1f0
    wire azimuth_n156 = azimuth_n155 ^ azimuth_n76; // u1f0
    wire signed [-5:-31] azimuth_n157 = azimuth_n154; // s27f31
    wire signed [-5:-31] azimuth_n158 = azimuth_n153; // s27f31
    wire [3:-31] azimuth_n159_term = {{8{azimuth_n157[-5]}}, azimuth_n157} ^ {35{azimuth_n155}};
    wire signed [3:-31] azimuth_n159 = {azimuth_n153[2], azimuth_n153, 7'h0} + azimuth_n159_term + {34'h0, azimuth_n155}; // s35f31
    wire [3:-31] azimuth_n160_term = {{8{azimuth_n158[-5]}}, azimuth_n158} ^ {35{azimuth_n156}};
    wire signed [3:-31] azimuth_n160 = {azimuth_n154[2], azimuth_n154, 7'h0} + azimuth_n160_term + {34'h0, azimuth_n156}; // s35f31
    wire [0:-24] azimuth_n162_term = {azimuth_n161[-1], azimuth_n161} ^ {25{azimuth_n155}};
    wire signed [0:-24] azimuth_n162 = {azimuth_n152[-1], azimuth_n152} + azimuth_n162_term + {24'h0, azimuth_n155}; // s25f24
    wire azimuth_n163_over = ~azimuth_n162[0] & (|azimuth_n162[-1]);
    wire azimuth_n163_under = azimuth_n162[0] & ~(&azimuth_n162[-1]);
    wire signed [-1:-24] azimuth_n163 = azimuth_n163_over ? 24'h7fffff : azimuth_n163_under ? 24'h800000 : azimuth_n162[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n164_cut = azimuth_n159[3:-24];
    wire azimuth_n164_over = ~azimuth_n164_cut[3] & (|azimuth_n164_cut[2]);
    wire azimuth_n164_under = azimuth_n164_cut[3] & ~(&azimuth_n164_cut[2]);
    wire signed [2:-24] azimuth_n164 = azimuth_n164_over ? 27'h3ffffff : azimuth_n164_under ? 27'h4000000 : azimuth_n164_cut[2:-24]; // s27f24
    wire signed [-6:-32] azimuth_n169 = azimuth_n164; // s27f32
    // polar_angle
    wire polar_angle_n298 = polar_angle_n297_s7 == {2'h0, azimuth_n65, 24'h0}; // u1f0
    wire signed [3:-24] polar_angle_n302 = -{polar_angle_n297_s7[2], polar_angle_n297_s7}; // s28f24
    wire signed [3:-24] polar_angle_n304 = polar_angle_n301_s7 ? polar_angle_n302 : {polar_angle_n297_s7[2], polar_angle_n297_s7}; // s28f24
    wire polar_angle_n306_over = ~polar_angle_n304[3] & (|polar_angle_n304[2]);
    wire polar_angle_n306_under = polar_angle_n304[3] & ~(&polar_angle_n304[2]);
    wire signed [2:-24] polar_angle_n306 = polar_angle_n306_over ? 27'h3ffffff : polar_angle_n306_under ? 27'h4000000 : polar_angle_n304[2:-24]; // s27f24

    reg azimuth_n69_s8; // u1f0
    reg signed [3:-31] azimuth_n160_s8; // s35f31
    reg signed [-1:-24] azimuth_n163_s8; // s24f24
    reg signed [2:-24] azimuth_n164_s8; // s27f24
    reg signed [-6:-32] azimuth_n169_s8; // s27f32
    reg polar_angle_n298_s8; // u1f0
    reg polar_angle_n301_s8; // u1f0
    reg signed [2:-24] polar_angle_n306_s8; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s8 <= azimuth_n69_s7;
            azimuth_n160_s8 <= azimuth_n160;
            azimuth_n163_s8 <= azimuth_n163;
            azimuth_n164_s8 <= azimuth_n164;
            azimuth_n169_s8 <= azimuth_n169;
            polar_angle_n298_s8 <= polar_angle_n298;
            polar_angle_n301_s8 <= polar_angle_n301_s7;
            polar_angle_n306_s8 <= polar_angle_n306;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // azimuth
    wire signed [3:-24] azimuth_n165_cut = azimuth_n160_s8[3:-24];
    wire azimuth_n165_over = ~azimuth_n165_cut[3] & (|azimuth_n165_cut[2]);
    wire azimuth_n165_under = azimuth_n165_cut[3] & ~(&azimuth_n165_cut[2]);
    wire signed [2:-24] azimuth_n165 = azimuth_n165_over ? 27'h3ffffff : azimuth_n165_under ? 27'h4000000 : azimuth_n165_cut[2:-24]; // s27f24
    wire azimuth_n166 = azimuth_n165[2]; // u1f0
    wire azimuth_n167 = azimuth_n166 ^ azimuth_n76; // u1f0
    wire signed [-6:-32] azimuth_n168 = azimuth_n165; // s27f32
    wire [3:-32] azimuth_n170_term = {{9{azimuth_n168[-6]}}, azimuth_n168} ^ {36{azimuth_n166}};
    wire signed [3:-32] azimuth_n170 = {azimuth_n164_s8[2], azimuth_n164_s8, 8'h0} + azimuth_n170_term + {35'h0, azimuth_n166}; // s36f32
    wire [3:-32] azimuth_n171_term = {{9{azimuth_n169_s8[-6]}}, azimuth_n169_s8} ^ {36{azimuth_n167}};
    wire signed [3:-32] azimuth_n171 = {azimuth_n165[2], azimuth_n165, 8'h0} + azimuth_n171_term + {35'h0, azimuth_n167}; // s36f32
    wire [0:-24] azimuth_n173_term = {azimuth_n172[-1], azimuth_n172} ^ {25{azimuth_n166}};
    wire signed [0:-24] azimuth_n173 = {azimuth_n163_s8[-1], azimuth_n163_s8} + azimuth_n173_term + {24'h0, azimuth_n166}; // s25f24
    wire azimuth_n174_over = ~azimuth_n173[0] & (|azimuth_n173[-1]);
    wire azimuth_n174_under = azimuth_n173[0] & ~(&azimuth_n173[-1]);
    wire signed [-1:-24] azimuth_n174 = azimuth_n174_over ? 24'h7fffff : azimuth_n174_under ? 24'h800000 : azimuth_n173[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n175_cut = azimuth_n170[3:-24];
    wire azimuth_n175_over = ~azimuth_n175_cut[3] & (|azimuth_n175_cut[2]);
    wire azimuth_n175_under = azimuth_n175_cut[3] & ~(&azimuth_n175_cut[2]);
    wire signed [2:-24] azimuth_n175 = azimuth_n175_over ? 27'h3ffffff : azimuth_n175_under ? 27'h4000000 : azimuth_n175_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n176_cut = azimuth_n171[3:-24];
    wire azimuth_n176_over = ~azimuth_n176_cut[3] & (|azimuth_n176_cut[2]);
    wire azimuth_n176_under = azimuth_n176_cut[3] & ~(&azimuth_n176_cut[2]);
    wire signed [2:-24] azimuth_n176 = azimuth_n176_over ? 27'h3ffffff : azimuth_n176_under ? 27'h4000000 : azimuth_n176_cut[2:-24]; // s27f24
    wire azimuth_n177 = azimuth_n176[2]; // u1f0
    wire azimuth_n178 = azimuth_n177 ^ azimuth_n76; // u1f0
    wire signed [-7:-33] azimuth_n179 = azimuth_n176; // s27f33
    wire signed [-7:-33] azimuth_n180 = azimuth_n175; // s27f33
    wire [0:-24] azimuth_n184_term = {azimuth_n183[-1], azimuth_n183} ^ {25{azimuth_n177}};
    wire signed [0:-24] azimuth_n184 = {azimuth_n174[-1], azimuth_n174} + azimuth_n184_term + {24'h0, azimuth_n177}; // s25f24

    reg azimuth_n69_s9; // u1f0
    reg signed [2:-24] azimuth_n175_s9; // s27f24
    reg signed [2:-24] azimuth_n176_s9; // s27f24
    reg azimuth_n177_s9; // u1f0
    reg azimuth_n178_s9; // u1f0
    reg signed [-7:-33] azimuth_n179_s9; // s27f33
    reg signed [-7:-33] azimuth_n180_s9; // s27f33
    reg signed [0:-24] azimuth_n184_s9; // s25f24
    reg polar_angle_n298_s9; // u1f0
    reg polar_angle_n301_s9; // u1f0
    reg signed [2:-24] polar_angle_n306_s9; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s9 <= azimuth_n69_s8;
            azimuth_n175_s9 <= azimuth_n175;
            azimuth_n176_s9 <= azimuth_n176;
            azimuth_n177_s9 <= azimuth_n177;
            azimuth_n178_s9 <= azimuth_n178;
            azimuth_n179_s9 <= azimuth_n179;
            azimuth_n180_s9 <= azimuth_n180;
            azimuth_n184_s9 <= azimuth_n184;
            polar_angle_n298_s9 <= polar_angle_n298_s8;
            polar_angle_n301_s9 <= polar_angle_n301_s8;
            polar_angle_n306_s9 <= polar_angle_n306_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // azimuth
    wire [3:-33] azimuth_n181_term = {{10{azimuth_n179_s9[-7]}}, azimuth_n179_s9} ^ {37{azimuth_n177_s9}};
    wire signed [3:-33] azimuth_n181 = {azimuth_n175_s9[2], azimuth_n175_s9, 9'h0} + azimuth_n181_term + {36'h0, azimuth_n177_s9}; // s37f33
    wire [3:-33] azimuth_n182_term = {{10{azimuth_n180_s9[-7]}}, azimuth_n180_s9} ^ {37{azimuth_n178_s9}};
    wire signed [3:-33] azimuth_n182 = {azimuth_n176_s9[2], azimuth_n176_s9, 9'h0} + azimuth_n182_term + {36'h0, azimuth_n178_s9}; // s37f33
    wire azimuth_n185_over = ~azimuth_n184_s9[0] & (|azimuth_n184_s9[-1]);
    wire azimuth_n185_under = azimuth_n184_s9[0] & ~(&azimuth_n184_s9[-1]);
    wire signed [-1:-24] azimuth_n185 = azimuth_n185_over ? 24'h7fffff : azimuth_n185_under ? 24'h800000 : azimuth_n184_s9[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n186_cut = azimuth_n181[3:-24];
    wire azimuth_n186_over = ~azimuth_n186_cut[3] & (|azimuth_n186_cut[2]);
    wire azimuth_n186_under = azimuth_n186_cut[3] & ~(&azimuth_n186_cut[2]);
    wire signed [2:-24] azimuth_n186 = azimuth_n186_over ? 27'h3ffffff : azimuth_n186_under ? 27'h4000000 : azimuth_n186_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n187_cut = azimuth_n182[3:-24];
    wire azimuth_n187_over = ~azimuth_n187_cut[3] & (|azimuth_n187_cut[2]);
    wire azimuth_n187_under = azimuth_n187_cut[3] & ~(&azimuth_n187_cut[2]);
    wire signed [2:-24] azimuth_n187 = azimuth_n187_over ? 27'h3ffffff : azimuth_n187_under ? 27'h4000000 : azimuth_n187_cut[2:-24]; // s27f24
    wire azimuth_n188 = azimuth_n187[2]; // u1f0
    wire azimuth_n189 = azimuth_n188 ^ azimuth_n76; // u1f0
    wire signed [-8:-34] azimuth_n190 = azimuth_n187; // s27f34
    wire signed [-8:-34] azimuth_n191 = azimuth_n186; // s27f34
    wire [3:-34] azimuth_n192_term = {{11{azimuth_n190[-8]}}, azimuth_n190} ^ {38{azimuth_n188}};
    wire signed [3:-34] azimuth_n192 = {azimuth_n186[2], azimuth_n186, 10'h0} + azimuth_n192_term + {37'h0, azimuth_n188}; // s38f34
    wire [3:-34] azimuth_n193_term = {{11{azimuth_n191[-8]}}, azimuth_n191} ^ {38{azimuth_n189}};
    wire signed [3:-34] azimuth_n193 = {azimuth_n187[2], azimuth_n187, 10'h0} + azimuth_n193_term + {37'h0, azimuth_n189}; // s38f34
    wire [0:-24] azimuth_n195_term = {azimuth_n194[-1], azimuth_n194} ^ {25{azimuth_n188}};
    wire signed [0:-24] azimuth_n195 = {azimuth_n185[-1], azimuth_n185} + azimuth_n195_term + {24'h0, azimuth_n188}; // s25f24
    wire azimuth_n196_over = ~azimuth_n195[0] & (|azimuth_n195[-1]);
    wire azimuth_n196_under = azimuth_n195[0] & ~(&azimuth_n195[-1]);
    wire signed [-1:-24] azimuth_n196 = azimuth_n196_over ? 24'h7fffff : azimuth_n196_under ? 24'h800000 : azimuth_n195[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n197_cut = azimuth_n192[3:-24];
    wire azimuth_n197_over = ~azimuth_n197_cut[3] & (|azimuth_n197_cut[2]);
    wire azimuth_n197_under = azimuth_n197_cut[3] & ~(&azimuth_n197_cut[2]);
    wire signed [2:-24] azimuth_n197 = azimuth_n197_over ? 27'h3ffffff : azimuth_n197_under ? 27'h4000000 : azimuth_n197_cut[2:-24]; // s27f24
    wire signed [-9:-35] azimuth_n202 = azimuth_n197; // s27f35

    reg azimuth_n69_s10; // u1f0
    reg signed [3:-34] azimuth_n193_s10; // s38f34
    reg signed [-1:-24] azimuth_n196_s10; // s24f24
    reg signed [2:-24] azimuth_n197_s10; // s27f24
    reg signed [-9:-35] azimuth_n202_s10; // s27f35
    reg polar_angle_n298_s10; // u1f0
    reg polar_angle_n301_s10; // u1f0
    reg signed [2:-24] polar_angle_n306_s10; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s10 <= azimuth_n69_s9;
            azimuth_n193_s10 <= azimuth_n193;
            azimuth_n196_s10 <= azimuth_n196;
            azimuth_n197_s10 <= azimuth_n197;
            azimuth_n202_s10 <= azimuth_n202;
            polar_angle_n298_s10 <= polar_angle_n298_s9;
            polar_angle_n301_s10 <= polar_angle_n301_s9;
            polar_angle_n306_s10 <= polar_angle_n306_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // azimuth
    wire signed [3:-24] azimuth_n198_cut = azimuth_n193_s10[3:-24];
    wire azimuth_n198_over = ~azimuth_n198_cut[3] & (|azimuth_n198_cut[2]);
    wire azimuth_n198_under = azimuth_n198_cut[3] & ~(&azimuth_n198_cut[2]);
    wire signed [2:-24] azimuth_n198 = azimuth_n198_over ? 27'h3ffffff : azimuth_n198_under ? 27'h4000000 : azimuth_n198_cut[2:-24]; // s27f24
    wire azimuth_n199 = azimuth_n198[2]; // u1f0
    wire azimuth_n200 = azimuth_n199 ^ azimuth_n76; // u1f0
    wire signed [-9:-35] azimuth_n201 = azimuth_n198; // s27f35
    wire [3:-35] azimuth_n203_term = {{12{azimuth_n201[-9]}}, azimuth_n201} ^ {39{azimuth_n199}};
    wire signed [3:-35] azimuth_n203 = {azimuth_n197_s10[2], azimuth_n197_s10, 11'h0} + azimuth_n203_term + {38'h0, azimuth_n199}; // s39f35
    wire [3:-35] azimuth_n204_term = {{12{azimuth_n202_s10[-9]}}, azimuth_n202_s10} ^ {39{azimuth_n200}};
    wire signed [3:-35] azimuth_n204 = {azimuth_n198[2], azimuth_n198, 11'h0} + azimuth_n204_term + {38'h0, azimuth_n200}; // s39f35
    wire [0:-24] azimuth_n206_term = {azimuth_n205[-1], azimuth_n205} ^ {25{azimuth_n199}};
    wire signed [0:-24] azimuth_n206 = {azimuth_n196_s10[-1], azimuth_n196_s10} + azimuth_n206_term + {24'h0, azimuth_n199}; // s25f24
    wire azimuth_n207_over = ~azimuth_n206[0] & (|azimuth_n206[-1]);
    wire azimuth_n207_under = azimuth_n206[0] & ~(&azimuth_n206[-1]);
    wire signed [-1:-24] azimuth_n207 = azimuth_n207_over ? 24'h7fffff : azimuth_n207_under ? 24'h800000 : azimuth_n206[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n208_cut = azimuth_n203[3:-24];
    wire azimuth_n208_over = ~azimuth_n208_cut[3] & (|azimuth_n208_cut[2]);
    wire azimuth_n208_under = azimuth_n208_cut[3] & ~(&azimuth_n208_cut[2]);
    wire signed [2:-24] azimuth_n208 = azimuth_n208_over ? 27'h3ffffff : azimuth_n208_under ? 27'h4000000 : azimuth_n208_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n209_cut = azimuth_n204[3:-24];
    wire azimuth_n209_over = ~azimuth_n209_cut[3] & (|azimuth_n209_cut[2]);
    wire azimuth_n209_under = azimuth_n209_cut[3] & ~(&azimuth_n209_cut[2]);
    wire signed [2:-24] azimuth_n209 = azimuth_n209_over ? 27'h3ffffff : azimuth_n209_under ? 27'h4000000 : azimuth_n209_cut[2:-24]; // s27f24
    wire azimuth_n210 = azimuth_n209[2]; // u1f0
    wire azimuth_n211 = azimuth_n210 ^ azimuth_n76; // u1f0
    wire signed [-10:-36] azimuth_n212 = azimuth_n209; // s27f36
    wire signed [-10:-36] azimuth_n213 = azimuth_n208; // s27f36
    wire [0:-24] azimuth_n217_term = {azimuth_n216[-1], azimuth_n216} ^ {25{azimuth_n210}};
    wire signed [0:-24] azimuth_n217 = {azimuth_n207[-1], azimuth_n207} + azimuth_n217_term + {24'h0, azimuth_n210}; // s25f24

    reg azimuth_n69_s11; // u1f0
    reg signed [2:-24] azimuth_n208_s11; // s27f24
    reg signed [2:-24] azimuth_n209_s11; // s27f24
    reg azimuth_n210_s11; // u1f0
    reg azimuth_n211_s11; // u1f0
    reg signed [-10:-36] azimuth_n212_s11; // s27f36
    reg signed [-10:-36] azimuth_n213_s11; // s27f36
    reg signed [0:-24] azimuth_n217_s11; // s25f24
    reg polar_angle_n298_s11; // u1f0
    reg polar_angle_n301_s11; // u1f0
    reg signed [2:-24] polar_angle_n306_s11; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s11 <= azimuth_n69_s10;
            azimuth_n208_s11 <= azimuth_n208;
            azimuth_n209_s11 <= azimuth_n209;
            azimuth_n210_s11 <= azimuth_n210;
            azimuth_n211_s11 <= azimuth_n211;
            azimuth_n212_s11 <= azimuth_n212;
            azimuth_n213_s11 <= azimuth_n213;
            azimuth_n217_s11 <= azimuth_n217;
            polar_angle_n298_s11 <= polar_angle_n298_s10;
            polar_angle_n301_s11 <= polar_angle_n301_s10;
            polar_angle_n306_s11 <= polar_angle_n306_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // azimuth
    wire [3:-36] azimuth_n214_term = {{13{azimuth_n212_s11[-10]}}, azimuth_n212_s11} ^ {40{azimuth_n210_s11}};
    wire signed [3:-36] azimuth_n214 = {azimuth_n208_s11[2], azimuth_n208_s11, 12'h0} + azimuth_n214_term + {39'h0, azimuth_n210_s11}; // s40f36
    wire [3:-36] azimuth_n215_term = {{13{azimuth_n213_s11[-10]}}, azimuth_n213_s11} ^ {40{azimuth_n211_s11}};
    wire signed [3:-36] azimuth_n215 = {azimuth_n209_s11[2], azimuth_n209_s11, 12'h0} + azimuth_n215_term + {39'h0, azimuth_n211_s11}; // s40f36
    wire azimuth_n218_over = ~azimuth_n217_s11[0] & (|azimuth_n217_s11[-1]);
    wire azimuth_n218_under = azimuth_n217_s11[0] & ~(&azimuth_n217_s11[-1]);
    wire signed [-1:-24] azimuth_n218 = azimuth_n218_over ? 24'h7fffff : azimuth_n218_under ? 24'h800000 : azimuth_n217_s11[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n219_cut = azimuth_n214[3:-24];
    wire azimuth_n219_over = ~azimuth_n219_cut[3] & (|azimuth_n219_cut[2]);
    wire azimuth_n219_under = azimuth_n219_cut[3] & ~(&azimuth_n219_cut[2]);
    wire signed [2:-24] azimuth_n219 = azimuth_n219_over ? 27'h3ffffff : azimuth_n219_under ? 27'h4000000 : azimuth_n219_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n220_cut = azimuth_n215[3:-24];
    wire azimuth_n220_over = ~azimuth_n220_cut[3] & (|azimuth_n220_cut[2]);
    wire azimuth_n220_under = azimuth_n220_cut[3] & ~(&azimuth_n220_cut[2]);
    wire signed [2:-24] azimuth_n220 = azimuth_n220_over ? 27'h3ffffff : azimuth_n220_under ? 27'h4000000 : azimuth_n220_cut[2:-24]; // s27f24
    wire azimuth_n221 = azimuth_n220[2]; // u1f0
    wire azimuth_n222 = azimuth_n221 ^ azimuth_n76; // u1f0
    wire signed [-11:-37] azimuth_n223 = azimuth_n220; // s27f37
    wire signed [-11:-37] azimuth_n224 = azimuth_n219; // s27f37
    wire [3:-37] azimuth_n225_term = {{14{azimuth_n223[-11]}}, azimuth_n223} ^ {41{azimuth_n221}};
    wire signed [3:-37] azimuth_n225 = {azimuth_n219[2], azimuth_n219, 13'h0} + azimuth_n225_term + {40'h0, azimuth_n221}; // s41f37
    wire [3:-37] azimuth_n226_term = {{14{azimuth_n224[-11]}}, azimuth_n224} ^ {41{azimuth_n222}};
    wire signed [3:-37] azimuth_n226 = {azimuth_n220[2], azimuth_n220, 13'h0} + azimuth_n226_term + {40'h0, azimuth_n222}; // s41f37
    wire [0:-24] azimuth_n228_term = {azimuth_n227[-1], azimuth_n227} ^ {25{azimuth_n221}};
    wire signed [0:-24] azimuth_n228 = {azimuth_n218[-1], azimuth_n218} + azimuth_n228_term + {24'h0, azimuth_n221}; // s25f24
    wire azimuth_n229_over = ~azimuth_n228[0] & (|azimuth_n228[-1]);
    wire azimuth_n229_under = azimuth_n228[0] & ~(&azimuth_n228[-1]);
    wire signed [-1:-24] azimuth_n229 = azimuth_n229_over ? 24'h7fffff : azimuth_n229_under ? 24'h800000 : azimuth_n228[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n230_cut = azimuth_n225[3:-24];
    wire azimuth_n230_over = ~azimuth_n230_cut[3] & (|azimuth_n230_cut[2]);
    wire azimuth_n230_under = azimuth_n230_cut[3] & ~(&azimuth_n230_cut[2]);
    wire signed [2:-24] azimuth_n230 = azimuth_n230_over ? 27'h3ffffff : azimuth_n230_under ? 27'h4000000 : azimuth_n230_cut[2:-24]; // s27f24
    wire signed [-12:-38] azimuth_n235 = azimuth_n230; // s27f38

    reg azimuth_n69_s12; // u1f0
    reg signed [3:-37] azimuth_n226_s12; // s41f37
    reg signed [-1:-24] azimuth_n229_s12; // s24f24
    reg signed [2:-24] azimuth_n230_s12; // s27f24
    reg signed [-12:-38] azimuth_n235_s12; // s27f38
    reg polar_angle_n298_s12; // u1f0
    reg polar_angle_n301_s12; // u1f0
    reg signed [2:-24] polar_angle_n306_s12; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s12 <= azimuth_n69_s11;
            azimuth_n226_s12 <= azimuth_n226;
            azimuth_n229_s12 <= azimuth_n229;
            azimuth_n230_s12 <= azimuth_n230;
            azimuth_n235_s12 <= azimuth_n235;
            polar_angle_n298_s12 <= polar_angle_n298_s11;
            polar_angle_n301_s12 <= polar_angle_n301_s11;
            polar_angle_n306_s12 <= polar_angle_n306_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // azimuth
    wire signed [3:-24] azimuth_n231_cut = azimuth_n226_s12[3:-24];
    wire azimuth_n231_over = ~azimuth_n231_cut[3] & (|azimuth_n231_cut[2]);
    wire azimuth_n231_under = azimuth_n231_cut[3] & ~(&azimuth_n231_cut[2]);
    wire signed [2:-24] azimuth_n231 = azimuth_n231_over ? 27'h3ffffff : azimuth_n231_under ? 27'h4000000 : azimuth_n231_cut[2:-24]; // s27f24
    wire azimuth_n232 = azimuth_n231[2]; // u1f0
    wire azimuth_n233 = azimuth_n232 ^ azimuth_n76; // u1f0
    wire signed [-12:-38] azimuth_n234 = azimuth_n231; // s27f38
    wire [3:-38] azimuth_n236_term = {{15{azimuth_n234[-12]}}, azimuth_n234} ^ {42{azimuth_n232}};
    wire signed [3:-38] azimuth_n236 = {azimuth_n230_s12[2], azimuth_n230_s12, 14'h0} + azimuth_n236_term + {41'h0, azimuth_n232}; // s42f38
    wire [3:-38] azimuth_n237_term = {{15{azimuth_n235_s12[-12]}}, azimuth_n235_s12} ^ {42{azimuth_n233}};
    wire signed [3:-38] azimuth_n237 = {azimuth_n231[2], azimuth_n231, 14'h0} + azimuth_n237_term + {41'h0, azimuth_n233}; // s42f38
    wire [0:-24] azimuth_n239_term = {azimuth_n238[-1], azimuth_n238} ^ {25{azimuth_n232}};
    wire signed [0:-24] azimuth_n239 = {azimuth_n229_s12[-1], azimuth_n229_s12} + azimuth_n239_term + {24'h0, azimuth_n232}; // s25f24
    wire azimuth_n240_over = ~azimuth_n239[0] & (|azimuth_n239[-1]);
    wire azimuth_n240_under = azimuth_n239[0] & ~(&azimuth_n239[-1]);
    wire signed [-1:-24] azimuth_n240 = azimuth_n240_over ? 24'h7fffff : azimuth_n240_under ? 24'h800000 : azimuth_n239[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n241_cut = azimuth_n236[3:-24];
    wire azimuth_n241_over = ~azimuth_n241_cut[3] & (|azimuth_n241_cut[2]);
    wire azimuth_n241_under = azimuth_n241_cut[3] & ~(&azimuth_n241_cut[2]);
    wire signed [2:-24] azimuth_n241 = azimuth_n241_over ? 27'h3ffffff : azimuth_n241_under ? 27'h4000000 : azimuth_n241_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n242_cut = azimuth_n237[3:-24];
    wire azimuth_n242_over = ~azimuth_n242_cut[3] & (|azimuth_n242_cut[2]);
    wire azimuth_n242_under = azimuth_n242_cut[3] & ~(&azimuth_n242_cut[2]);
    wire signed [2:-24] azimuth_n242 = azimuth_n242_over ? 27'h3ffffff : azimuth_n242_under ? 27'h4000000 : azimuth_n242_cut[2:-24]; // s27f24
    wire azimuth_n243 = azimuth_n242[2]; // u1f0
    wire azimuth_n244 = azimuth_n243 ^ azimuth_n76; // u1f0
    wire signed [-13:-39] azimuth_n245 = azimuth_n242; // s27f39
    wire signed [-13:-39] azimuth_n246 = azimuth_n241; // s27f39

    reg azimuth_n69_s13; // u1f0
    reg signed [-1:-24] azimuth_n240_s13; // s24f24
    reg signed [2:-24] azimuth_n241_s13; // s27f24
    reg signed [2:-24] azimuth_n242_s13; // s27f24
    reg azimuth_n243_s13; // u1f0
    reg azimuth_n244_s13; // u1f0
    reg signed [-13:-39] azimuth_n245_s13; // s27f39
    reg signed [-13:-39] azimuth_n246_s13; // s27f39
    reg polar_angle_n298_s13; // u1f0
    reg polar_angle_n301_s13; // u1f0
    reg signed [2:-24] polar_angle_n306_s13; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s13 <= azimuth_n69_s12;
            azimuth_n240_s13 <= azimuth_n240;
            azimuth_n241_s13 <= azimuth_n241;
            azimuth_n242_s13 <= azimuth_n242;
            azimuth_n243_s13 <= azimuth_n243;
            azimuth_n244_s13 <= azimuth_n244;
            azimuth_n245_s13 <= azimuth_n245;
            azimuth_n246_s13 <= azimuth_n246;
            polar_angle_n298_s13 <= polar_angle_n298_s12;
            polar_angle_n301_s13 <= polar_angle_n301_s12;
            polar_angle_n306_s13 <= polar_angle_n306_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // azimuth
    wire [3:-39] azimuth_n247_term = {{16{azimuth_n245_s13[-13]}}, azimuth_n245_s13} ^ {43{azimuth_n243_s13}};
    wire signed [3:-39] azimuth_n247 = {azimuth_n241_s13[2], azimuth_n241_s13, 15'h0} + azimuth_n247_term + {42'h0, azimuth_n243_s13}; // s43f39
    wire [3:-39] azimuth_n248_term = {{16{azimuth_n246_s13[-13]}}, azimuth_n246_s13} ^ {43{azimuth_n244_s13}};
    wire signed [3:-39] azimuth_n248 = {azimuth_n242_s13[2], azimuth_n242_s13, 15'h0} + azimuth_n248_term + {42'h0, azimuth_n244_s13}; // s43f39
    wire [0:-24] azimuth_n250_term = {azimuth_n249[-1], azimuth_n249} ^ {25{azimuth_n243_s13}};
    wire signed [0:-24] azimuth_n250 = {azimuth_n240_s13[-1], azimuth_n240_s13} + azimuth_n250_term + {24'h0, azimuth_n243_s13}; // s25f24
    wire azimuth_n251_over = ~azimuth_n250[0] & (|azimuth_n250[-1]);
    wire azimuth_n251_under = azimuth_n250[0] & ~(&azimuth_n250[-1]);
    wire signed [-1:-24] azimuth_n251 = azimuth_n251_over ? 24'h7fffff : azimuth_n251_under ? 24'h800000 : azimuth_n250[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n252_cut = azimuth_n247[3:-24];
    wire azimuth_n252_over = ~azimuth_n252_cut[3] & (|azimuth_n252_cut[2]);
    wire azimuth_n252_under = azimuth_n252_cut[3] & ~(&azimuth_n252_cut[2]);
    wire signed [2:-24] azimuth_n252 = azimuth_n252_over ? 27'h3ffffff : azimuth_n252_under ? 27'h4000000 : azimuth_n252_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n253_cut = azimuth_n248[3:-24];
    wire azimuth_n253_over = ~azimuth_n253_cut[3] & (|azimuth_n253_cut[2]);
    wire azimuth_n253_under = azimuth_n253_cut[3] & ~(&azimuth_n253_cut[2]);
    wire signed [2:-24] azimuth_n253 = azimuth_n253_over ? 27'h3ffffff : azimuth_n253_under ? 27'h4000000 : azimuth_n253_cut[2:-24]; // s27f24
    wire azimuth_n254 = azimuth_n253[2]; // u1f0
    wire azimuth_n255 = azimuth_n254 ^ azimuth_n76; // u1f0
    wire signed [-14:-40] azimuth_n256 = azimuth_n253; // s27f40
    wire signed [-14:-40] azimuth_n257 = azimuth_n252; // s27f40
    wire [3:-40] azimuth_n258_term = {{17{azimuth_n256[-14]}}, azimuth_n256} ^ {44{azimuth_n254}};
    wire signed [3:-40] azimuth_n258 = {azimuth_n252[2], azimuth_n252, 16'h0} + azimuth_n258_term + {43'h0, azimuth_n254}; // s44f40
    wire [3:-40] azimuth_n259_term = {{17{azimuth_n257[-14]}}, azimuth_n257} ^ {44{azimuth_n255}};
    wire signed [3:-40] azimuth_n259 = {azimuth_n253[2], azimuth_n253, 16'h0} + azimuth_n259_term + {43'h0, azimuth_n255}; // s44f40
    wire [0:-24] azimuth_n261_term = {azimuth_n260[-1], azimuth_n260} ^ {25{azimuth_n254}};
    wire signed [0:-24] azimuth_n261 = {azimuth_n251[-1], azimuth_n251} + azimuth_n261_term + {24'h0, azimuth_n254}; // s25f24
    wire azimuth_n262_over = ~azimuth_n261[0] & (|azimuth_n261[-1]);
    wire azimuth_n262_under = azimuth_n261[0] & ~(&azimuth_n261[-1]);
    wire signed [-1:-24] azimuth_n262 = azimuth_n262_over ? 24'h7fffff : azimuth_n262_under ? 24'h800000 : azimuth_n261[-1:-24]; // s24f24

    reg azimuth_n69_s14; // u1f0
    reg signed [3:-40] azimuth_n258_s14; // s44f40
    reg signed [3:-40] azimuth_n259_s14; // s44f40
    reg signed [-1:-24] azimuth_n262_s14; // s24f24
    reg polar_angle_n298_s14; // u1f0
    reg polar_angle_n301_s14; // u1f0
    reg signed [2:-24] polar_angle_n306_s14; // s27f24
    always @(posedge clk)
        if (ce) begin
            azimuth_n69_s14 <= azimuth_n69_s13;
            azimuth_n258_s14 <= azimuth_n258;
            azimuth_n259_s14 <= azimuth_n259;
            azimuth_n262_s14 <= azimuth_n262;
            polar_angle_n298_s14 <= polar_angle_n298_s13;
            polar_angle_n301_s14 <= polar_angle_n301_s13;
            polar_angle_n306_s14 <= polar_angle_n306_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // azimuth
    wire signed [3:-24] azimuth_n263_cut = azimuth_n258_s14[3:-24];
    wire azimuth_n263_over = ~azimuth_n263_cut[3] & (|azimuth_n263_cut[2]);
    wire azimuth_n263_under = azimuth_n263_cut[3] & ~(&azimuth_n263_cut[2]);
    wire signed [2:-24] azimuth_n263 = azimuth_n263_over ? 27'h3ffffff : azimuth_n263_under ? 27'h4000000 : azimuth_n263_cut[2:-24]; // s27f24
    wire signed [3:-24] azimuth_n264_cut = azimuth_n259_s14[3:-24];
    wire azimuth_n264_over = ~azimuth_n264_cut[3] & (|azimuth_n264_cut[2]);
    wire azimuth_n264_under = azimuth_n264_cut[3] & ~(&azimuth_n264_cut[2]);
    wire signed [2:-24] azimuth_n264 = azimuth_n264_over ? 27'h3ffffff : azimuth_n264_under ? 27'h4000000 : azimuth_n264_cut[2:-24]; // s27f24
    wire azimuth_n265 = azimuth_n264[2]; // u1f0
    wire signed [-15:-41] azimuth_n266 = azimuth_n264; // s27f41
    wire [3:-41] azimuth_n267_term = {{18{azimuth_n266[-15]}}, azimuth_n266} ^ {45{azimuth_n265}};
    wire signed [3:-41] azimuth_n267 = {azimuth_n263[2], azimuth_n263, 17'h0} + azimuth_n267_term + {44'h0, azimuth_n265}; // s45f41
    wire [0:-24] azimuth_n269_term = {azimuth_n268[-1], azimuth_n268} ^ {25{azimuth_n265}};
    wire signed [0:-24] azimuth_n269 = {azimuth_n262_s14[-1], azimuth_n262_s14} + azimuth_n269_term + {24'h0, azimuth_n265}; // s25f24
    wire azimuth_n270_over = ~azimuth_n269[0] & (|azimuth_n269[-1]);
    wire azimuth_n270_under = azimuth_n269[0] & ~(&azimuth_n269[-1]);
    wire signed [-1:-24] azimuth_n270 = azimuth_n270_over ? 24'h7fffff : azimuth_n270_under ? 24'h800000 : azimuth_n269[-1:-24]; // s24f24
    wire signed [3:-24] azimuth_n271_cut = azimuth_n267[3:-24];
    wire azimuth_n271_over = ~azimuth_n271_cut[3] & (|azimuth_n271_cut[2]);
    wire azimuth_n271_under = azimuth_n271_cut[3] & ~(&azimuth_n271_cut[2]);
    wire signed [2:-24] azimuth_n271 = azimuth_n271_over ? 27'h3ffffff : azimuth_n271_under ? 27'h4000000 : azimuth_n271_cut[2:-24]; // s27f24
    wire [-1:-24] azimuth_n272 = azimuth_n270; // u24f24
    wire [-1:-24] azimuth_n274 = azimuth_n272 ^ azimuth_n273; // u24f24
    wire [-1:-24] azimuth_n275 = azimuth_n69_s14 ? azimuth_n274 : azimuth_n272; // u24f24
    // polar_angle
    wire polar_angle_n299 = azimuth_n271 == {2'h0, azimuth_n65, 24'h0}; // u1f0
    wire signed [3:-24] polar_angle_n303 = -{azimuth_n271[2], azimuth_n271}; // s28f24
    // (unit)
    wire [0:-24] n480_sum = {1'b0, azimuth_n275} + 25'h80;
    wire [0:-16] n480_cut = n480_sum[0:-16];
    wire [0:-16] n480 = n480_cut; // u17f16
    wire [-1:-16] phi_next = n480[-1:-16]; // u16f16

    reg signed [2:-24] azimuth_n271_s15; // s27f24
    reg polar_angle_n298_s15; // u1f0
    reg polar_angle_n299_s15; // u1f0
    reg polar_angle_n301_s15; // u1f0
    reg signed [3:-24] polar_angle_n303_s15; // s28f24
    reg signed [2:-24] polar_angle_n306_s15; // s27f24
    reg [-1:-16] phi_next_s15; // u16f16
    always @(posedge clk)
        if (ce) begin
            azimuth_n271_s15 <= azimuth_n271;
            polar_angle_n298_s15 <= polar_angle_n298_s14;
            polar_angle_n299_s15 <= polar_angle_n299;
            polar_angle_n301_s15 <= polar_angle_n301_s14;
            polar_angle_n303_s15 <= polar_angle_n303;
            polar_angle_n306_s15 <= polar_angle_n306_s14;
            phi_next_s15 <= phi_next;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // polar_angle
    wire polar_angle_n300 = polar_angle_n298_s15 & polar_angle_n299_s15; // u1f0
    wire signed [3:-24] polar_angle_n305 = polar_angle_n301_s15 ? polar_angle_n303_s15 : {azimuth_n271_s15[2], azimuth_n271_s15}; // s28f24
    wire polar_angle_n307_over = ~polar_angle_n305[3] & (|polar_angle_n305[2]);
    wire polar_angle_n307_under = polar_angle_n305[3] & ~(&polar_angle_n305[2]);
    wire signed [2:-24] polar_angle_n307 = polar_angle_n307_over ? 27'h3ffffff : polar_angle_n307_under ? 27'h4000000 : polar_angle_n305[2:-24]; // s27f24
    wire signed [-1:-24] polar_angle_n308 = polar_angle_n300 ? azimuth_n77 : azimuth_n78; // s24f24
    wire polar_angle_n309 = polar_angle_n307[2]; // u1f0
    wire polar_angle_n310 = polar_angle_n309 ^ azimuth_n76; // u1f0
    wire [3:-24] polar_angle_n311_term = {polar_angle_n307[2], polar_angle_n307} ^ {28{polar_angle_n309}};
    wire signed [3:-24] polar_angle_n311 = {polar_angle_n306_s15[2], polar_angle_n306_s15} + polar_angle_n311_term + {27'h0, polar_angle_n309}; // s28f24
    wire [3:-24] polar_angle_n312_term = {polar_angle_n306_s15[2], polar_angle_n306_s15} ^ {28{polar_angle_n310}};
    wire signed [3:-24] polar_angle_n312 = {polar_angle_n307[2], polar_angle_n307} + polar_angle_n312_term + {27'h0, polar_angle_n310}; // s28f24
    wire [0:-24] polar_angle_n313_term = {azimuth_n84[-1], azimuth_n84} ^ {25{polar_angle_n309}};
    wire signed [0:-24] polar_angle_n313 = {polar_angle_n308[-1], polar_angle_n308} + polar_angle_n313_term + {24'h0, polar_angle_n309}; // s25f24
    wire polar_angle_n314_over = ~polar_angle_n313[0] & (|polar_angle_n313[-1]);
    wire polar_angle_n314_under = polar_angle_n313[0] & ~(&polar_angle_n313[-1]);
    wire signed [-1:-24] polar_angle_n314 = polar_angle_n314_over ? 24'h7fffff : polar_angle_n314_under ? 24'h800000 : polar_angle_n313[-1:-24]; // s24f24
    wire polar_angle_n315_over = ~polar_angle_n311[3] & (|polar_angle_n311[2]);
    wire polar_angle_n315_under = polar_angle_n311[3] & ~(&polar_angle_n311[2]);
    wire signed [2:-24] polar_angle_n315 = polar_angle_n315_over ? 27'h3ffffff : polar_angle_n315_under ? 27'h4000000 : polar_angle_n311[2:-24]; // s27f24
    wire polar_angle_n316_over = ~polar_angle_n312[3] & (|polar_angle_n312[2]);
    wire polar_angle_n316_under = polar_angle_n312[3] & ~(&polar_angle_n312[2]);
    wire signed [2:-24] polar_angle_n316 = polar_angle_n316_over ? 27'h3ffffff : polar_angle_n316_under ? 27'h4000000 : polar_angle_n312[2:-24]; // s27f24
    wire polar_angle_n317 = polar_angle_n316[2]; // u1f0
    wire polar_angle_n318 = polar_angle_n317 ^ azimuth_n76; // u1f0
    wire signed [1:-25] polar_angle_n319 = polar_angle_n316; // s27f25
    wire signed [1:-25] polar_angle_n320 = polar_angle_n315; // s27f25

    reg polar_angle_n301_s16; // u1f0
    reg signed [-1:-24] polar_angle_n314_s16; // s24f24
    reg signed [2:-24] polar_angle_n315_s16; // s27f24
    reg signed [2:-24] polar_angle_n316_s16; // s27f24
    reg polar_angle_n317_s16; // u1f0
    reg polar_angle_n318_s16; // u1f0
    reg signed [1:-25] polar_angle_n319_s16; // s27f25
    reg signed [1:-25] polar_angle_n320_s16; // s27f25
    reg [-1:-16] phi_next_s16; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s16 <= polar_angle_n301_s15;
            polar_angle_n314_s16 <= polar_angle_n314;
            polar_angle_n315_s16 <= polar_angle_n315;
            polar_angle_n316_s16 <= polar_angle_n316;
            polar_angle_n317_s16 <= polar_angle_n317;
            polar_angle_n318_s16 <= polar_angle_n318;
            polar_angle_n319_s16 <= polar_angle_n319;
            polar_angle_n320_s16 <= polar_angle_n320;
            phi_next_s16 <= phi_next_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // polar_angle
    wire [3:-25] polar_angle_n321_term = {{2{polar_angle_n319_s16[1]}}, polar_angle_n319_s16} ^ {29{polar_angle_n317_s16}};
    wire signed [3:-25] polar_angle_n321 = {polar_angle_n315_s16[2], polar_angle_n315_s16, 1'b0} + polar_angle_n321_term + {28'h0, polar_angle_n317_s16}; // s29f25
    wire [3:-25] polar_angle_n322_term = {{2{polar_angle_n320_s16[1]}}, polar_angle_n320_s16} ^ {29{polar_angle_n318_s16}};
    wire signed [3:-25] polar_angle_n322 = {polar_angle_n316_s16[2], polar_angle_n316_s16, 1'b0} + polar_angle_n322_term + {28'h0, polar_angle_n318_s16}; // s29f25
    wire [0:-24] polar_angle_n323_term = {azimuth_n95[-1], azimuth_n95} ^ {25{polar_angle_n317_s16}};
    wire signed [0:-24] polar_angle_n323 = {polar_angle_n314_s16[-1], polar_angle_n314_s16} + polar_angle_n323_term + {24'h0, polar_angle_n317_s16}; // s25f24
    wire polar_angle_n324_over = ~polar_angle_n323[0] & (|polar_angle_n323[-1]);
    wire polar_angle_n324_under = polar_angle_n323[0] & ~(&polar_angle_n323[-1]);
    wire signed [-1:-24] polar_angle_n324 = polar_angle_n324_over ? 24'h7fffff : polar_angle_n324_under ? 24'h800000 : polar_angle_n323[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n325_cut = polar_angle_n321[3:-24];
    wire polar_angle_n325_over = ~polar_angle_n325_cut[3] & (|polar_angle_n325_cut[2]);
    wire polar_angle_n325_under = polar_angle_n325_cut[3] & ~(&polar_angle_n325_cut[2]);
    wire signed [2:-24] polar_angle_n325 = polar_angle_n325_over ? 27'h3ffffff : polar_angle_n325_under ? 27'h4000000 : polar_angle_n325_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n326_cut = polar_angle_n322[3:-24];
    wire polar_angle_n326_over = ~polar_angle_n326_cut[3] & (|polar_angle_n326_cut[2]);
    wire polar_angle_n326_under = polar_angle_n326_cut[3] & ~(&polar_angle_n326_cut[2]);
    wire signed [2:-24] polar_angle_n326 = polar_angle_n326_over ? 27'h3ffffff : polar_angle_n326_under ? 27'h4000000 : polar_angle_n326_cut[2:-24]; // s27f24
    wire polar_angle_n327 = polar_angle_n326[2]; // u1f0
    wire polar_angle_n328 = polar_angle_n327 ^ azimuth_n76; // u1f0
    wire signed [0:-26] polar_angle_n329 = polar_angle_n326; // s27f26
    wire signed [0:-26] polar_angle_n330 = polar_angle_n325; // s27f26
    wire [3:-26] polar_angle_n331_term = {{3{polar_angle_n329[0]}}, polar_angle_n329} ^ {30{polar_angle_n327}};
    wire signed [3:-26] polar_angle_n331 = {polar_angle_n325[2], polar_angle_n325, 2'h0} + polar_angle_n331_term + {29'h0, polar_angle_n327}; // s30f26
    wire [3:-26] polar_angle_n332_term = {{3{polar_angle_n330[0]}}, polar_angle_n330} ^ {30{polar_angle_n328}};
    wire signed [3:-26] polar_angle_n332 = {polar_angle_n326[2], polar_angle_n326, 2'h0} + polar_angle_n332_term + {29'h0, polar_angle_n328}; // s30f26
    wire [0:-24] polar_angle_n333_term = {azimuth_n106[-1], azimuth_n106} ^ {25{polar_angle_n327}};
    wire signed [0:-24] polar_angle_n333 = {polar_angle_n324[-1], polar_angle_n324} + polar_angle_n333_term + {24'h0, polar_angle_n327}; // s25f24
    wire polar_angle_n334_over = ~polar_angle_n333[0] & (|polar_angle_n333[-1]);
    wire polar_angle_n334_under = polar_angle_n333[0] & ~(&polar_angle_n333[-1]);
    wire signed [-1:-24] polar_angle_n334 = polar_angle_n334_over ? 24'h7fffff : polar_angle_n334_under ? 24'h800000 : polar_angle_n333[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n335_cut = polar_angle_n331[3:-24];
    wire polar_angle_n335_over = ~polar_angle_n335_cut[3] & (|polar_angle_n335_cut[2]);
    wire polar_angle_n335_under = polar_angle_n335_cut[3] & ~(&polar_angle_n335_cut[2]);
    wire signed [2:-24] polar_angle_n335 = polar_angle_n335_over ? 27'h3ffffff : polar_angle_n335_under ? 27'h4000000 : polar_angle_n335_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n336_cut = polar_angle_n332[3:-24];
    wire polar_angle_n336_over = ~polar_angle_n336_cut[3] & (|polar_angle_n336_cut[2]);
    wire polar_angle_n336_under = polar_angle_n336_cut[3] & ~(&polar_angle_n336_cut[2]);
    wire signed [2:-24] polar_angle_n336 = polar_angle_n336_over ? 27'h3ffffff : polar_angle_n336_under ? 27'h4000000 : polar_angle_n336_cut[2:-24]; // s27f24
    wire polar_angle_n337 = polar_angle_n336[2]; // u1f0
    wire signed [-1:-27] polar_angle_n339 = polar_angle_n336; // s27f27
    wire signed [-1:-27] polar_angle_n340 = polar_angle_n335; // s27f27

    reg polar_angle_n301_s17; // u1f0
    reg signed [-1:-24] polar_angle_n334_s17; // s24f24
    reg signed [2:-24] polar_angle_n335_s17; // s27f24
    reg signed [2:-24] polar_angle_n336_s17; // s27f24
    reg polar_angle_n337_s17; // u1f0
    reg signed [-1:-27] polar_angle_n339_s17; // s27f27
    reg signed [-1:-27] polar_angle_n340_s17; // s27f27
    reg [-1:-16] phi_next_s17; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s17 <= polar_angle_n301_s16;
            polar_angle_n334_s17 <= polar_angle_n334;
            polar_angle_n335_s17 <= polar_angle_n335;
            polar_angle_n336_s17 <= polar_angle_n336;
            polar_angle_n337_s17 <= polar_angle_n337;
            polar_angle_n339_s17 <= polar_angle_n339;
            polar_angle_n340_s17 <= polar_angle_n340;
            phi_next_s17 <= phi_next_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // polar_angle
    wire polar_angle_n338 = polar_angle_n337_s17 ^ azimuth_n76; // u1f0
    wire [3:-27] polar_angle_n341_term = {{4{polar_angle_n339_s17[-1]}}, polar_angle_n339_s17} ^ {31{polar_angle_n337_s17}};
    wire signed [3:-27] polar_angle_n341 = {polar_angle_n335_s17[2], polar_angle_n335_s17, 3'h0} + polar_angle_n341_term + {30'h0, polar_angle_n337_s17}; // s31f27
    wire [3:-27] polar_angle_n342_term = {{4{polar_angle_n340_s17[-1]}}, polar_angle_n340_s17} ^ {31{polar_angle_n338}};
    wire signed [3:-27] polar_angle_n342 = {polar_angle_n336_s17[2], polar_angle_n336_s17, 3'h0} + polar_angle_n342_term + {30'h0, polar_angle_n338}; // s31f27
    wire [0:-24] polar_angle_n343_term = {azimuth_n117[-1], azimuth_n117} ^ {25{polar_angle_n337_s17}};
    wire signed [0:-24] polar_angle_n343 = {polar_angle_n334_s17[-1], polar_angle_n334_s17} + polar_angle_n343_term + {24'h0, polar_angle_n337_s17}; // s25f24
    wire polar_angle_n344_over = ~polar_angle_n343[0] & (|polar_angle_n343[-1]);
    wire polar_angle_n344_under = polar_angle_n343[0] & ~(&polar_angle_n343[-1]);
    wire signed [-1:-24] polar_angle_n344 = polar_angle_n344_over ? 24'h7fffff : polar_angle_n344_under ? 24'h800000 : polar_angle_n343[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n345_cut = polar_angle_n341[3:-24];
    wire polar_angle_n345_over = ~polar_angle_n345_cut[3] & (|polar_angle_n345_cut[2]);
    wire polar_angle_n345_under = polar_angle_n345_cut[3] & ~(&polar_angle_n345_cut[2]);
    wire signed [2:-24] polar_angle_n345 = polar_angle_n345_over ? 27'h3ffffff : polar_angle_n345_under ? 27'h4000000 : polar_angle_n345_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n346_cut = polar_angle_n342[3:-24];
    wire polar_angle_n346_over = ~polar_angle_n346_cut[3] & (|polar_angle_n346_cut[2]);
    wire polar_angle_n346_under = polar_angle_n346_cut[3] & ~(&polar_angle_n346_cut[2]);
    wire signed [2:-24] polar_angle_n346 = polar_angle_n346_over ? 27'h3ffffff : polar_angle_n346_under ? 27'h4000000 : polar_angle_n346_cut[2:-24]; // s27f24
    wire polar_angle_n347 = polar_angle_n346[2]; // u1f0
    wire polar_angle_n348 = polar_angle_n347 ^ azimuth_n76; // u1f0
    wire signed [-2:-28] polar_angle_n349 = polar_angle_n346; // s27f28
    wire signed [-2:-28] polar_angle_n350 = polar_angle_n345; // s27f28
    wire [3:-28] polar_angle_n351_term = {{5{polar_angle_n349[-2]}}, polar_angle_n349} ^ {32{polar_angle_n347}};
    wire signed [3:-28] polar_angle_n351 = {polar_angle_n345[2], polar_angle_n345, 4'h0} + polar_angle_n351_term + {31'h0, polar_angle_n347}; // s32f28
    wire [3:-28] polar_angle_n352_term = {{5{polar_angle_n350[-2]}}, polar_angle_n350} ^ {32{polar_angle_n348}};
    wire signed [3:-28] polar_angle_n352 = {polar_angle_n346[2], polar_angle_n346, 4'h0} + polar_angle_n352_term + {31'h0, polar_angle_n348}; // s32f28
    wire [0:-24] polar_angle_n353_term = {azimuth_n128[-1], azimuth_n128} ^ {25{polar_angle_n347}};
    wire signed [0:-24] polar_angle_n353 = {polar_angle_n344[-1], polar_angle_n344} + polar_angle_n353_term + {24'h0, polar_angle_n347}; // s25f24
    wire polar_angle_n354_over = ~polar_angle_n353[0] & (|polar_angle_n353[-1]);
    wire polar_angle_n354_under = polar_angle_n353[0] & ~(&polar_angle_n353[-1]);
    wire signed [-1:-24] polar_angle_n354 = polar_angle_n354_over ? 24'h7fffff : polar_angle_n354_under ? 24'h800000 : polar_angle_n353[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n355_cut = polar_angle_n351[3:-24];
    wire polar_angle_n355_over = ~polar_angle_n355_cut[3] & (|polar_angle_n355_cut[2]);
    wire polar_angle_n355_under = polar_angle_n355_cut[3] & ~(&polar_angle_n355_cut[2]);
    wire signed [2:-24] polar_angle_n355 = polar_angle_n355_over ? 27'h3ffffff : polar_angle_n355_under ? 27'h4000000 : polar_angle_n355_cut[2:-24]; // s27f24
    wire signed [-3:-29] polar_angle_n360 = polar_angle_n355; // s27f29

    reg polar_angle_n301_s18; // u1f0
    reg signed [3:-28] polar_angle_n352_s18; // s32f28
    reg signed [-1:-24] polar_angle_n354_s18; // s24f24
    reg signed [2:-24] polar_angle_n355_s18; // s27f24
    reg signed [-3:-29] polar_angle_n360_s18; // s27f29
    reg [-1:-16] phi_next_s18; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s18 <= polar_angle_n301_s17;
            polar_angle_n352_s18 <= polar_angle_n352;
            polar_angle_n354_s18 <= polar_angle_n354;
            polar_angle_n355_s18 <= polar_angle_n355;
            polar_angle_n360_s18 <= polar_angle_n360;
            phi_next_s18 <= phi_next_s17;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // polar_angle
    wire signed [3:-24] polar_angle_n356_cut = polar_angle_n352_s18[3:-24];
    wire polar_angle_n356_over = ~polar_angle_n356_cut[3] & (|polar_angle_n356_cut[2]);
    wire polar_angle_n356_under = polar_angle_n356_cut[3] & ~(&polar_angle_n356_cut[2]);
    wire signed [2:-24] polar_angle_n356 = polar_angle_n356_over ? 27'h3ffffff : polar_angle_n356_under ? 27'h4000000 : polar_angle_n356_cut[2:-24]; // s27f24
    wire polar_angle_n357 = polar_angle_n356[2]; // u1f0
    wire polar_angle_n358 = polar_angle_n357 ^ azimuth_n76; // u1f0
    wire signed [-3:-29] polar_angle_n359 = polar_angle_n356; // s27f29
    wire [3:-29] polar_angle_n361_term = {{6{polar_angle_n359[-3]}}, polar_angle_n359} ^ {33{polar_angle_n357}};
    wire signed [3:-29] polar_angle_n361 = {polar_angle_n355_s18[2], polar_angle_n355_s18, 5'h0} + polar_angle_n361_term + {32'h0, polar_angle_n357}; // s33f29
    wire [3:-29] polar_angle_n362_term = {{6{polar_angle_n360_s18[-3]}}, polar_angle_n360_s18} ^ {33{polar_angle_n358}};
    wire signed [3:-29] polar_angle_n362 = {polar_angle_n356[2], polar_angle_n356, 5'h0} + polar_angle_n362_term + {32'h0, polar_angle_n358}; // s33f29
    wire [0:-24] polar_angle_n363_term = {azimuth_n139[-1], azimuth_n139} ^ {25{polar_angle_n357}};
    wire signed [0:-24] polar_angle_n363 = {polar_angle_n354_s18[-1], polar_angle_n354_s18} + polar_angle_n363_term + {24'h0, polar_angle_n357}; // s25f24
    wire polar_angle_n364_over = ~polar_angle_n363[0] & (|polar_angle_n363[-1]);
    wire polar_angle_n364_under = polar_angle_n363[0] & ~(&polar_angle_n363[-1]);
    wire signed [-1:-24] polar_angle_n364 = polar_angle_n364_over ? 24'h7fffff : polar_angle_n364_under ? 24'h800000 : polar_angle_n363[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n365_cut = polar_angle_n361[3:-24];
    wire polar_angle_n365_over = ~polar_angle_n365_cut[3] & (|polar_angle_n365_cut[2]);
    wire polar_angle_n365_under = polar_angle_n365_cut[3] & ~(&polar_angle_n365_cut[2]);
    wire signed [2:-24] polar_angle_n365 = polar_angle_n365_over ? 27'h3ffffff : polar_angle_n365_under ? 27'h4000000 : polar_angle_n365_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n366_cut = polar_angle_n362[3:-24];
    wire polar_angle_n366_over = ~polar_angle_n366_cut[3] & (|polar_angle_n366_cut[2]);
    wire polar_angle_n366_under = polar_angle_n366_cut[3] & ~(&polar_angle_n366_cut[2]);
    wire signed [2:-24] polar_angle_n366 = polar_angle_n366_over ? 27'h3ffffff : polar_angle_n366_under ? 27'h4000000 : polar_angle_n366_cut[2:-24]; // s27f24
    wire polar_angle_n367 = polar_angle_n366[2]; // u1f0
    wire polar_angle_n368 = polar_angle_n367 ^ azimuth_n76; // u1f0
    wire signed [-4:-30] polar_angle_n369 = polar_angle_n366; // s27f30
    wire signed [-4:-30] polar_angle_n370 = polar_angle_n365; // s27f30
    wire [0:-24] polar_angle_n373_term = {azimuth_n150[-1], azimuth_n150} ^ {25{polar_angle_n367}};
    wire signed [0:-24] polar_angle_n373 = {polar_angle_n364[-1], polar_angle_n364} + polar_angle_n373_term + {24'h0, polar_angle_n367}; // s25f24

    reg polar_angle_n301_s19; // u1f0
    reg signed [2:-24] polar_angle_n365_s19; // s27f24
    reg signed [2:-24] polar_angle_n366_s19; // s27f24
    reg polar_angle_n367_s19; // u1f0
    reg polar_angle_n368_s19; // u1f0
    reg signed [-4:-30] polar_angle_n369_s19; // s27f30
    reg signed [-4:-30] polar_angle_n370_s19; // s27f30
    reg signed [0:-24] polar_angle_n373_s19; // s25f24
    reg [-1:-16] phi_next_s19; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s19 <= polar_angle_n301_s18;
            polar_angle_n365_s19 <= polar_angle_n365;
            polar_angle_n366_s19 <= polar_angle_n366;
            polar_angle_n367_s19 <= polar_angle_n367;
            polar_angle_n368_s19 <= polar_angle_n368;
            polar_angle_n369_s19 <= polar_angle_n369;
            polar_angle_n370_s19 <= polar_angle_n370;
            polar_angle_n373_s19 <= polar_angle_n373;
            phi_next_s19 <= phi_next_s18;
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // polar_angle
    wire [3:-30] polar_angle_n371_term = {{7{polar_angle_n369_s19[-4]}}, polar_angle_n369_s19} ^ {34{polar_angle_n367_s19}};
    wire signed [3:-30] polar_angle_n371 = {polar_angle_n365_s19[2], polar_angle_n365_s19, 6'h0} + polar_angle_n371_term + {33'h0, polar_angle_n367_s19}; // s34f30
    wire [3:-30] polar_angle_n372_term = {{7{polar_angle_n370_s19[-4]}}, polar_angle_n370_s19} ^ {34{polar_angle_n368_s19}};
    wire signed [3:-30] polar_angle_n372 = {polar_angle_n366_s19[2], polar_angle_n366_s19, 6'h0} + polar_angle_n372_term + {33'h0, polar_angle_n368_s19}; // s34f30
    wire polar_angle_n374_over = ~polar_angle_n373_s19[0] & (|polar_angle_n373_s19[-1]);
    wire polar_angle_n374_under = polar_angle_n373_s19[0] & ~(&polar_angle_n373_s19[-1]);
    wire signed [-1:-24] polar_angle_n374 = polar_angle_n374_over ? 24'h7fffff : polar_angle_n374_under ? 24'h800000 : polar_angle_n373_s19[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n375_cut = polar_angle_n371[3:-24];
    wire polar_angle_n375_over = ~polar_angle_n375_cut[3] & (|polar_angle_n375_cut[2]);
    wire polar_angle_n375_under = polar_angle_n375_cut[3] & ~(&polar_angle_n375_cut[2]);
    wire signed [2:-24] polar_angle_n375 = polar_angle_n375_over ? 27'h3ffffff : polar_angle_n375_under ? 27'h4000000 : polar_angle_n375_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n376_cut = polar_angle_n372[3:-24];
    wire polar_angle_n376_over = ~polar_angle_n376_cut[3] & (|polar_angle_n376_cut[2]);
    wire polar_angle_n376_under = polar_angle_n376_cut[3] & ~(&polar_angle_n376_cut[2]);
    wire signed [2:-24] polar_angle_n376 = polar_angle_n376_over ? 27'h3ffffff : polar_angle_n376_under ? 27'h4000000 : polar_angle_n376_cut[2:-24]; // s27f24
    wire polar_angle_n377 = polar_angle_n376[2]; // u1f0
    wire polar_angle_n378 = polar_angle_n377 ^ azimuth_n76; // u1f0
    wire signed [-5:-31] polar_angle_n379 = polar_angle_n376; // s27f31
    wire signed [-5:-31] polar_angle_n380 = polar_angle_n375; // s27f31
    wire [3:-31] polar_angle_n381_term = {{8{polar_angle_n379[-5]}}, polar_angle_n379} ^ {35{polar_angle_n377}};
    wire signed [3:-31] polar_angle_n381 = {polar_angle_n375[2], polar_angle_n375, 7'h0} + polar_angle_n381_term + {34'h0, polar_angle_n377}; // s35f31
    wire [3:-31] polar_angle_n382_term = {{8{polar_angle_n380[-5]}}, polar_angle_n380} ^ {35{polar_angle_n378}};
    wire signed [3:-31] polar_angle_n382 = {polar_angle_n376[2], polar_angle_n376, 7'h0} + polar_angle_n382_term + {34'h0, polar_angle_n378}; // s35f31
    wire [0:-24] polar_angle_n383_term = {azimuth_n161[-1], azimuth_n161} ^ {25{polar_angle_n377}};
    wire signed [0:-24] polar_angle_n383 = {polar_angle_n374[-1], polar_angle_n374} + polar_angle_n383_term + {24'h0, polar_angle_n377}; // s25f24
    wire polar_angle_n384_over = ~polar_angle_n383[0] & (|polar_angle_n383[-1]);
    wire polar_angle_n384_under = polar_angle_n383[0] & ~(&polar_angle_n383[-1]);
    wire signed [-1:-24] polar_angle_n384 = polar_angle_n384_over ? 24'h7fffff : polar_angle_n384_under ? 24'h800000 : polar_angle_n383[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n385_cut = polar_angle_n381[3:-24];
    wire polar_angle_n385_over = ~polar_angle_n385_cut[3] & (|polar_angle_n385_cut[2]);
    wire polar_angle_n385_under = polar_angle_n385_cut[3] & ~(&polar_angle_n385_cut[2]);
    wire signed [2:-24] polar_angle_n385 = polar_angle_n385_over ? 27'h3ffffff : polar_angle_n385_under ? 27'h4000000 : polar_angle_n385_cut[2:-24]; // s27f24
    wire signed [-6:-32] polar_angle_n390 = polar_angle_n385; // s27f32

    reg polar_angle_n301_s20; // u1f0
    reg signed [3:-31] polar_angle_n382_s20; // s35f31
    reg signed [-1:-24] polar_angle_n384_s20; // s24f24
    reg signed [2:-24] polar_angle_n385_s20; // s27f24
    reg signed [-6:-32] polar_angle_n390_s20; // s27f32
    reg [-1:-16] phi_next_s20; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s20 <= polar_angle_n301_s19;
            polar_angle_n382_s20 <= polar_angle_n382;
            polar_angle_n384_s20 <= polar_angle_n384;
            polar_angle_n385_s20 <= polar_angle_n385;
            polar_angle_n390_s20 <= polar_angle_n390;
            phi_next_s20 <= phi_next_s19;
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // polar_angle
    wire signed [3:-24] polar_angle_n386_cut = polar_angle_n382_s20[3:-24];
    wire polar_angle_n386_over = ~polar_angle_n386_cut[3] & (|polar_angle_n386_cut[2]);
    wire polar_angle_n386_under = polar_angle_n386_cut[3] & ~(&polar_angle_n386_cut[2]);
    wire signed [2:-24] polar_angle_n386 = polar_angle_n386_over ? 27'h3ffffff : polar_angle_n386_under ? 27'h4000000 : polar_angle_n386_cut[2:-24]; // s27f24
    wire polar_angle_n387 = polar_angle_n386[2]; // u1f0
    wire polar_angle_n388 = polar_angle_n387 ^ azimuth_n76; // u1f0
    wire signed [-6:-32] polar_angle_n389 = polar_angle_n386; // s27f32
    wire [3:-32] polar_angle_n391_term = {{9{polar_angle_n389[-6]}}, polar_angle_n389} ^ {36{polar_angle_n387}};
    wire signed [3:-32] polar_angle_n391 = {polar_angle_n385_s20[2], polar_angle_n385_s20, 8'h0} + polar_angle_n391_term + {35'h0, polar_angle_n387}; // s36f32
    wire [3:-32] polar_angle_n392_term = {{9{polar_angle_n390_s20[-6]}}, polar_angle_n390_s20} ^ {36{polar_angle_n388}};
    wire signed [3:-32] polar_angle_n392 = {polar_angle_n386[2], polar_angle_n386, 8'h0} + polar_angle_n392_term + {35'h0, polar_angle_n388}; // s36f32
    wire [0:-24] polar_angle_n393_term = {azimuth_n172[-1], azimuth_n172} ^ {25{polar_angle_n387}};
    wire signed [0:-24] polar_angle_n393 = {polar_angle_n384_s20[-1], polar_angle_n384_s20} + polar_angle_n393_term + {24'h0, polar_angle_n387}; // s25f24
    wire polar_angle_n394_over = ~polar_angle_n393[0] & (|polar_angle_n393[-1]);
    wire polar_angle_n394_under = polar_angle_n393[0] & ~(&polar_angle_n393[-1]);
    wire signed [-1:-24] polar_angle_n394 = polar_angle_n394_over ? 24'h7fffff : polar_angle_n394_under ? 24'h800000 : polar_angle_n393[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n395_cut = polar_angle_n391[3:-24];
    wire polar_angle_n395_over = ~polar_angle_n395_cut[3] & (|polar_angle_n395_cut[2]);
    wire polar_angle_n395_under = polar_angle_n395_cut[3] & ~(&polar_angle_n395_cut[2]);
    wire signed [2:-24] polar_angle_n395 = polar_angle_n395_over ? 27'h3ffffff : polar_angle_n395_under ? 27'h4000000 : polar_angle_n395_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n396_cut = polar_angle_n392[3:-24];
    wire polar_angle_n396_over = ~polar_angle_n396_cut[3] & (|polar_angle_n396_cut[2]);
    wire polar_angle_n396_under = polar_angle_n396_cut[3] & ~(&polar_angle_n396_cut[2]);
    wire signed [2:-24] polar_angle_n396 = polar_angle_n396_over ? 27'h3ffffff : polar_angle_n396_under ? 27'h4000000 : polar_angle_n396_cut[2:-24]; // s27f24
    wire polar_angle_n397 = polar_angle_n396[2]; // u1f0
    wire polar_angle_n398 = polar_angle_n397 ^ azimuth_n76; // u1f0
    wire signed [-7:-33] polar_angle_n399 = polar_angle_n396; // s27f33
    wire signed [-7:-33] polar_angle_n400 = polar_angle_n395; // s27f33
    wire [0:-24] polar_angle_n403_term = {azimuth_n183[-1], azimuth_n183} ^ {25{polar_angle_n397}};
    wire signed [0:-24] polar_angle_n403 = {polar_angle_n394[-1], polar_angle_n394} + polar_angle_n403_term + {24'h0, polar_angle_n397}; // s25f24

    reg polar_angle_n301_s21; // u1f0
    reg signed [2:-24] polar_angle_n395_s21; // s27f24
    reg signed [2:-24] polar_angle_n396_s21; // s27f24
    reg polar_angle_n397_s21; // u1f0
    reg polar_angle_n398_s21; // u1f0
    reg signed [-7:-33] polar_angle_n399_s21; // s27f33
    reg signed [-7:-33] polar_angle_n400_s21; // s27f33
    reg signed [0:-24] polar_angle_n403_s21; // s25f24
    reg [-1:-16] phi_next_s21; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s21 <= polar_angle_n301_s20;
            polar_angle_n395_s21 <= polar_angle_n395;
            polar_angle_n396_s21 <= polar_angle_n396;
            polar_angle_n397_s21 <= polar_angle_n397;
            polar_angle_n398_s21 <= polar_angle_n398;
            polar_angle_n399_s21 <= polar_angle_n399;
            polar_angle_n400_s21 <= polar_angle_n400;
            polar_angle_n403_s21 <= polar_angle_n403;
            phi_next_s21 <= phi_next_s20;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;

    // ---- stage 21 ----
    // polar_angle
    wire [3:-33] polar_angle_n401_term = {{10{polar_angle_n399_s21[-7]}}, polar_angle_n399_s21} ^ {37{polar_angle_n397_s21}};
    wire signed [3:-33] polar_angle_n401 = {polar_angle_n395_s21[2], polar_angle_n395_s21, 9'h0} + polar_angle_n401_term + {36'h0, polar_angle_n397_s21}; // s37f33
    wire [3:-33] polar_angle_n402_term = {{10{polar_angle_n400_s21[-7]}}, polar_angle_n400_s21} ^ {37{polar_angle_n398_s21}};
    wire signed [3:-33] polar_angle_n402 = {polar_angle_n396_s21[2], polar_angle_n396_s21, 9'h0} + polar_angle_n402_term + {36'h0, polar_angle_n398_s21}; // s37f33
    wire polar_angle_n404_over = ~polar_angle_n403_s21[0] & (|polar_angle_n403_s21[-1]);
    wire polar_angle_n404_under = polar_angle_n403_s21[0] & ~(&polar_angle_n403_s21[-1]);
    wire signed [-1:-24] polar_angle_n404 = polar_angle_n404_over ? 24'h7fffff : polar_angle_n404_under ? 24'h800000 : polar_angle_n403_s21[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n405_cut = polar_angle_n401[3:-24];
    wire polar_angle_n405_over = ~polar_angle_n405_cut[3] & (|polar_angle_n405_cut[2]);
    wire polar_angle_n405_under = polar_angle_n405_cut[3] & ~(&polar_angle_n405_cut[2]);
    wire signed [2:-24] polar_angle_n405 = polar_angle_n405_over ? 27'h3ffffff : polar_angle_n405_under ? 27'h4000000 : polar_angle_n405_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n406_cut = polar_angle_n402[3:-24];
    wire polar_angle_n406_over = ~polar_angle_n406_cut[3] & (|polar_angle_n406_cut[2]);
    wire polar_angle_n406_under = polar_angle_n406_cut[3] & ~(&polar_angle_n406_cut[2]);
    wire signed [2:-24] polar_angle_n406 = polar_angle_n406_over ? 27'h3ffffff : polar_angle_n406_under ? 27'h4000000 : polar_angle_n406_cut[2:-24]; // s27f24
    wire polar_angle_n407 = polar_angle_n406[2]; // u1f0
    wire polar_angle_n408 = polar_angle_n407 ^ azimuth_n76; // u1f0
    wire signed [-8:-34] polar_angle_n409 = polar_angle_n406; // s27f34
    wire signed [-8:-34] polar_angle_n410 = polar_angle_n405; // s27f34
    wire [3:-34] polar_angle_n411_term = {{11{polar_angle_n409[-8]}}, polar_angle_n409} ^ {38{polar_angle_n407}};
    wire signed [3:-34] polar_angle_n411 = {polar_angle_n405[2], polar_angle_n405, 10'h0} + polar_angle_n411_term + {37'h0, polar_angle_n407}; // s38f34
    wire [3:-34] polar_angle_n412_term = {{11{polar_angle_n410[-8]}}, polar_angle_n410} ^ {38{polar_angle_n408}};
    wire signed [3:-34] polar_angle_n412 = {polar_angle_n406[2], polar_angle_n406, 10'h0} + polar_angle_n412_term + {37'h0, polar_angle_n408}; // s38f34
    wire [0:-24] polar_angle_n413_term = {azimuth_n194[-1], azimuth_n194} ^ {25{polar_angle_n407}};
    wire signed [0:-24] polar_angle_n413 = {polar_angle_n404[-1], polar_angle_n404} + polar_angle_n413_term + {24'h0, polar_angle_n407}; // s25f24
    wire polar_angle_n414_over = ~polar_angle_n413[0] & (|polar_angle_n413[-1]);
    wire polar_angle_n414_under = polar_angle_n413[0] & ~(&polar_angle_n413[-1]);
    wire signed [-1:-24] polar_angle_n414 = polar_angle_n414_over ? 24'h7fffff : polar_angle_n414_under ? 24'h800000 : polar_angle_n413[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n415_cut = polar_angle_n411[3:-24];
    wire polar_angle_n415_over = ~polar_angle_n415_cut[3] & (|polar_angle_n415_cut[2]);
    wire polar_angle_n415_under = polar_angle_n415_cut[3] & ~(&polar_angle_n415_cut[2]);
    wire signed [2:-24] polar_angle_n415 = polar_angle_n415_over ? 27'h3ffffff : polar_angle_n415_under ? 27'h4000000 : polar_angle_n415_cut[2:-24]; // s27f24
    wire signed [-9:-35] polar_angle_n420 = polar_angle_n415; // s27f35

    reg polar_angle_n301_s22; // u1f0
    reg signed [3:-34] polar_angle_n412_s22; // s38f34
    reg signed [-1:-24] polar_angle_n414_s22; // s24f24
    reg signed [2:-24] polar_angle_n415_s22; // s27f24
    reg signed [-9:-35] polar_angle_n420_s22; // s27f35
    reg [-1:-16] phi_next_s22; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s22 <= polar_angle_n301_s21;
            polar_angle_n412_s22 <= polar_angle_n412;
            polar_angle_n414_s22 <= polar_angle_n414;
            polar_angle_n415_s22 <= polar_angle_n415;
            polar_angle_n420_s22 <= polar_angle_n420;
            phi_next_s22 <= phi_next_s21;
        end
    reg valid_s22;
    always @(posedge clk)
        if (rst) valid_s22 <= 1'b0;
        else if (ce) valid_s22 <= valid_s21;

    // ---- stage 22 ----
    // polar_angle
    wire signed [3:-24] polar_angle_n416_cut = polar_angle_n412_s22[3:-24];
    wire polar_angle_n416_over = ~polar_angle_n416_cut[3] & (|polar_angle_n416_cut[2]);
    wire polar_angle_n416_under = polar_angle_n416_cut[3] & ~(&polar_angle_n416_cut[2]);
    wire signed [2:-24] polar_angle_n416 = polar_angle_n416_over ? 27'h3ffffff : polar_angle_n416_under ? 27'h4000000 : polar_angle_n416_cut[2:-24]; // s27f24
    wire polar_angle_n417 = polar_angle_n416[2]; // u1f0
    wire polar_angle_n418 = polar_angle_n417 ^ azimuth_n76; // u1f0
    wire signed [-9:-35] polar_angle_n419 = polar_angle_n416; // s27f35
    wire [3:-35] polar_angle_n421_term = {{12{polar_angle_n419[-9]}}, polar_angle_n419} ^ {39{polar_angle_n417}};
    wire signed [3:-35] polar_angle_n421 = {polar_angle_n415_s22[2], polar_angle_n415_s22, 11'h0} + polar_angle_n421_term + {38'h0, polar_angle_n417}; // s39f35
    wire [3:-35] polar_angle_n422_term = {{12{polar_angle_n420_s22[-9]}}, polar_angle_n420_s22} ^ {39{polar_angle_n418}};
    wire signed [3:-35] polar_angle_n422 = {polar_angle_n416[2], polar_angle_n416, 11'h0} + polar_angle_n422_term + {38'h0, polar_angle_n418}; // s39f35
    wire [0:-24] polar_angle_n423_term = {azimuth_n205[-1], azimuth_n205} ^ {25{polar_angle_n417}};
    wire signed [0:-24] polar_angle_n423 = {polar_angle_n414_s22[-1], polar_angle_n414_s22} + polar_angle_n423_term + {24'h0, polar_angle_n417}; // s25f24
    wire polar_angle_n424_over = ~polar_angle_n423[0] & (|polar_angle_n423[-1]);
    wire polar_angle_n424_under = polar_angle_n423[0] & ~(&polar_angle_n423[-1]);
    wire signed [-1:-24] polar_angle_n424 = polar_angle_n424_over ? 24'h7fffff : polar_angle_n424_under ? 24'h800000 : polar_angle_n423[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n425_cut = polar_angle_n421[3:-24];
    wire polar_angle_n425_over = ~polar_angle_n425_cut[3] & (|polar_angle_n425_cut[2]);
    wire polar_angle_n425_under = polar_angle_n425_cut[3] & ~(&polar_angle_n425_cut[2]);
    wire signed [2:-24] polar_angle_n425 = polar_angle_n425_over ? 27'h3ffffff : polar_angle_n425_under ? 27'h4000000 : polar_angle_n425_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n426_cut = polar_angle_n422[3:-24];
    wire polar_angle_n426_over = ~polar_angle_n426_cut[3] & (|polar_angle_n426_cut[2]);
    wire polar_angle_n426_under = polar_angle_n426_cut[3] & ~(&polar_angle_n426_cut[2]);
    wire signed [2:-24] polar_angle_n426 = polar_angle_n426_over ? 27'h3ffffff : polar_angle_n426_under ? 27'h4000000 : polar_angle_n426_cut[2:-24]; // s27f24
    wire polar_angle_n427 = polar_angle_n426[2]; // u1f0
    wire polar_angle_n428 = polar_angle_n427 ^ azimuth_n76; // u1f0
    wire signed [-10:-36] polar_angle_n429 = polar_angle_n426; // s27f36
    wire signed [-10:-36] polar_angle_n430 = polar_angle_n425; // s27f36
    wire [0:-24] polar_angle_n433_term = {azimuth_n216[-1], azimuth_n216} ^ {25{polar_angle_n427}};
    wire signed [0:-24] polar_angle_n433 = {polar_angle_n424[-1], polar_angle_n424} + polar_angle_n433_term + {24'h0, polar_angle_n427}; // s25f24

    reg polar_angle_n301_s23; // u1f0
    reg signed [2:-24] polar_angle_n425_s23; // s27f24
    reg signed [2:-24] polar_angle_n426_s23; // s27f24
    reg polar_angle_n427_s23; // u1f0
    reg polar_angle_n428_s23; // u1f0
    reg signed [-10:-36] polar_angle_n429_s23; // s27f36
    reg signed [-10:-36] polar_angle_n430_s23; // s27f36
    reg signed [0:-24] polar_angle_n433_s23; // s25f24
    reg [-1:-16] phi_next_s23; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s23 <= polar_angle_n301_s22;
            polar_angle_n425_s23 <= polar_angle_n425;
            polar_angle_n426_s23 <= polar_angle_n426;
            polar_angle_n427_s23 <= polar_angle_n427;
            polar_angle_n428_s23 <= polar_angle_n428;
            polar_angle_n429_s23 <= polar_angle_n429;
            polar_angle_n430_s23 <= polar_angle_n430;
            polar_angle_n433_s23 <= polar_angle_n433;
            phi_next_s23 <= phi_next_s22;
        end
    reg valid_s23;
    always @(posedge clk)
        if (rst) valid_s23 <= 1'b0;
        else if (ce) valid_s23 <= valid_s22;

    // ---- stage 23 ----
    // polar_angle
    wire [3:-36] polar_angle_n431_term = {{13{polar_angle_n429_s23[-10]}}, polar_angle_n429_s23} ^ {40{polar_angle_n427_s23}};
    wire signed [3:-36] polar_angle_n431 = {polar_angle_n425_s23[2], polar_angle_n425_s23, 12'h0} + polar_angle_n431_term + {39'h0, polar_angle_n427_s23}; // s40f36
    wire [3:-36] polar_angle_n432_term = {{13{polar_angle_n430_s23[-10]}}, polar_angle_n430_s23} ^ {40{polar_angle_n428_s23}};
    wire signed [3:-36] polar_angle_n432 = {polar_angle_n426_s23[2], polar_angle_n426_s23, 12'h0} + polar_angle_n432_term + {39'h0, polar_angle_n428_s23}; // s40f36
    wire polar_angle_n434_over = ~polar_angle_n433_s23[0] & (|polar_angle_n433_s23[-1]);
    wire polar_angle_n434_under = polar_angle_n433_s23[0] & ~(&polar_angle_n433_s23[-1]);
    wire signed [-1:-24] polar_angle_n434 = polar_angle_n434_over ? 24'h7fffff : polar_angle_n434_under ? 24'h800000 : polar_angle_n433_s23[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n435_cut = polar_angle_n431[3:-24];
    wire polar_angle_n435_over = ~polar_angle_n435_cut[3] & (|polar_angle_n435_cut[2]);
    wire polar_angle_n435_under = polar_angle_n435_cut[3] & ~(&polar_angle_n435_cut[2]);
    wire signed [2:-24] polar_angle_n435 = polar_angle_n435_over ? 27'h3ffffff : polar_angle_n435_under ? 27'h4000000 : polar_angle_n435_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n436_cut = polar_angle_n432[3:-24];
    wire polar_angle_n436_over = ~polar_angle_n436_cut[3] & (|polar_angle_n436_cut[2]);
    wire polar_angle_n436_under = polar_angle_n436_cut[3] & ~(&polar_angle_n436_cut[2]);
    wire signed [2:-24] polar_angle_n436 = polar_angle_n436_over ? 27'h3ffffff : polar_angle_n436_under ? 27'h4000000 : polar_angle_n436_cut[2:-24]; // s27f24
    wire polar_angle_n437 = polar_angle_n436[2]; // u1f0
    wire polar_angle_n438 = polar_angle_n437 ^ azimuth_n76; // u1f0
    wire signed [-11:-37] polar_angle_n439 = polar_angle_n436; // s27f37
    wire signed [-11:-37] polar_angle_n440 = polar_angle_n435; // s27f37
    wire [3:-37] polar_angle_n441_term = {{14{polar_angle_n439[-11]}}, polar_angle_n439} ^ {41{polar_angle_n437}};
    wire signed [3:-37] polar_angle_n441 = {polar_angle_n435[2], polar_angle_n435, 13'h0} + polar_angle_n441_term + {40'h0, polar_angle_n437}; // s41f37
    wire [3:-37] polar_angle_n442_term = {{14{polar_angle_n440[-11]}}, polar_angle_n440} ^ {41{polar_angle_n438}};
    wire signed [3:-37] polar_angle_n442 = {polar_angle_n436[2], polar_angle_n436, 13'h0} + polar_angle_n442_term + {40'h0, polar_angle_n438}; // s41f37
    wire [0:-24] polar_angle_n443_term = {azimuth_n227[-1], azimuth_n227} ^ {25{polar_angle_n437}};
    wire signed [0:-24] polar_angle_n443 = {polar_angle_n434[-1], polar_angle_n434} + polar_angle_n443_term + {24'h0, polar_angle_n437}; // s25f24
    wire polar_angle_n444_over = ~polar_angle_n443[0] & (|polar_angle_n443[-1]);
    wire polar_angle_n444_under = polar_angle_n443[0] & ~(&polar_angle_n443[-1]);
    wire signed [-1:-24] polar_angle_n444 = polar_angle_n444_over ? 24'h7fffff : polar_angle_n444_under ? 24'h800000 : polar_angle_n443[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n445_cut = polar_angle_n441[3:-24];
    wire polar_angle_n445_over = ~polar_angle_n445_cut[3] & (|polar_angle_n445_cut[2]);
    wire polar_angle_n445_under = polar_angle_n445_cut[3] & ~(&polar_angle_n445_cut[2]);
    wire signed [2:-24] polar_angle_n445 = polar_angle_n445_over ? 27'h3ffffff : polar_angle_n445_under ? 27'h4000000 : polar_angle_n445_cut[2:-24]; // s27f24
    wire signed [-12:-38] polar_angle_n450 = polar_angle_n445; // s27f38

    reg polar_angle_n301_s24; // u1f0
    reg signed [3:-37] polar_angle_n442_s24; // s41f37
    reg signed [-1:-24] polar_angle_n444_s24; // s24f24
    reg signed [2:-24] polar_angle_n445_s24; // s27f24
    reg signed [-12:-38] polar_angle_n450_s24; // s27f38
    reg [-1:-16] phi_next_s24; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s24 <= polar_angle_n301_s23;
            polar_angle_n442_s24 <= polar_angle_n442;
            polar_angle_n444_s24 <= polar_angle_n444;
            polar_angle_n445_s24 <= polar_angle_n445;
            polar_angle_n450_s24 <= polar_angle_n450;
            phi_next_s24 <= phi_next_s23;
        end
    reg valid_s24;
    always @(posedge clk)
        if (rst) valid_s24 <= 1'b0;
        else if (ce) valid_s24 <= valid_s23;

    // ---- stage 24 ----
    // polar_angle
    wire signed [3:-24] polar_angle_n446_cut = polar_angle_n442_s24[3:-24];
    wire polar_angle_n446_over = ~polar_angle_n446_cut[3] & (|polar_angle_n446_cut[2]);
    wire polar_angle_n446_under = polar_angle_n446_cut[3] & ~(&polar_angle_n446_cut[2]);
    wire signed [2:-24] polar_angle_n446 = polar_angle_n446_over ? 27'h3ffffff : polar_angle_n446_under ? 27'h4000000 : polar_angle_n446_cut[2:-24]; // s27f24
    wire polar_angle_n447 = polar_angle_n446[2]; // u1f0
    wire polar_angle_n448 = polar_angle_n447 ^ azimuth_n76; // u1f0
    wire signed [-12:-38] polar_angle_n449 = polar_angle_n446; // s27f38
    wire [3:-38] polar_angle_n451_term = {{15{polar_angle_n449[-12]}}, polar_angle_n449} ^ {42{polar_angle_n447}};
    wire signed [3:-38] polar_angle_n451 = {polar_angle_n445_s24[2], polar_angle_n445_s24, 14'h0} + polar_angle_n451_term + {41'h0, polar_angle_n447}; // s42f38
    wire [3:-38] polar_angle_n452_term = {{15{polar_angle_n450_s24[-12]}}, polar_angle_n450_s24} ^ {42{polar_angle_n448}};
    wire signed [3:-38] polar_angle_n452 = {polar_angle_n446[2], polar_angle_n446, 14'h0} + polar_angle_n452_term + {41'h0, polar_angle_n448}; // s42f38
    wire [0:-24] polar_angle_n453_term = {azimuth_n238[-1], azimuth_n238} ^ {25{polar_angle_n447}};
    wire signed [0:-24] polar_angle_n453 = {polar_angle_n444_s24[-1], polar_angle_n444_s24} + polar_angle_n453_term + {24'h0, polar_angle_n447}; // s25f24
    wire polar_angle_n454_over = ~polar_angle_n453[0] & (|polar_angle_n453[-1]);
    wire polar_angle_n454_under = polar_angle_n453[0] & ~(&polar_angle_n453[-1]);
    wire signed [-1:-24] polar_angle_n454 = polar_angle_n454_over ? 24'h7fffff : polar_angle_n454_under ? 24'h800000 : polar_angle_n453[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n455_cut = polar_angle_n451[3:-24];
    wire polar_angle_n455_over = ~polar_angle_n455_cut[3] & (|polar_angle_n455_cut[2]);
    wire polar_angle_n455_under = polar_angle_n455_cut[3] & ~(&polar_angle_n455_cut[2]);
    wire signed [2:-24] polar_angle_n455 = polar_angle_n455_over ? 27'h3ffffff : polar_angle_n455_under ? 27'h4000000 : polar_angle_n455_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n456_cut = polar_angle_n452[3:-24];
    wire polar_angle_n456_over = ~polar_angle_n456_cut[3] & (|polar_angle_n456_cut[2]);
    wire polar_angle_n456_under = polar_angle_n456_cut[3] & ~(&polar_angle_n456_cut[2]);
    wire signed [2:-24] polar_angle_n456 = polar_angle_n456_over ? 27'h3ffffff : polar_angle_n456_under ? 27'h4000000 : polar_angle_n456_cut[2:-24]; // s27f24
    wire polar_angle_n457 = polar_angle_n456[2]; // u1f0
    wire polar_angle_n458 = polar_angle_n457 ^ azimuth_n76; // u1f0
    wire signed [-13:-39] polar_angle_n459 = polar_angle_n456; // s27f39
    wire signed [-13:-39] polar_angle_n460 = polar_angle_n455; // s27f39

    reg polar_angle_n301_s25; // u1f0
    reg signed [-1:-24] polar_angle_n454_s25; // s24f24
    reg signed [2:-24] polar_angle_n455_s25; // s27f24
    reg signed [2:-24] polar_angle_n456_s25; // s27f24
    reg polar_angle_n457_s25; // u1f0
    reg polar_angle_n458_s25; // u1f0
    reg signed [-13:-39] polar_angle_n459_s25; // s27f39
    reg signed [-13:-39] polar_angle_n460_s25; // s27f39
    reg [-1:-16] phi_next_s25; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s25 <= polar_angle_n301_s24;
            polar_angle_n454_s25 <= polar_angle_n454;
            polar_angle_n455_s25 <= polar_angle_n455;
            polar_angle_n456_s25 <= polar_angle_n456;
            polar_angle_n457_s25 <= polar_angle_n457;
            polar_angle_n458_s25 <= polar_angle_n458;
            polar_angle_n459_s25 <= polar_angle_n459;
            polar_angle_n460_s25 <= polar_angle_n460;
            phi_next_s25 <= phi_next_s24;
        end
    reg valid_s25;
    always @(posedge clk)
        if (rst) valid_s25 <= 1'b0;
        else if (ce) valid_s25 <= valid_s24;

    // ---- stage 25 ----
    // polar_angle
    wire [3:-39] polar_angle_n461_term = {{16{polar_angle_n459_s25[-13]}}, polar_angle_n459_s25} ^ {43{polar_angle_n457_s25}};
    wire signed [3:-39] polar_angle_n461 = {polar_angle_n455_s25[2], polar_angle_n455_s25, 15'h0} + polar_angle_n461_term + {42'h0, polar_angle_n457_s25}; // s43f39
    wire [3:-39] polar_angle_n462_term = {{16{polar_angle_n460_s25[-13]}}, polar_angle_n460_s25} ^ {43{polar_angle_n458_s25}};
    wire signed [3:-39] polar_angle_n462 = {polar_angle_n456_s25[2], polar_angle_n456_s25, 15'h0} + polar_angle_n462_term + {42'h0, polar_angle_n458_s25}; // s43f39
    wire [0:-24] polar_angle_n463_term = {azimuth_n249[-1], azimuth_n249} ^ {25{polar_angle_n457_s25}};
    wire signed [0:-24] polar_angle_n463 = {polar_angle_n454_s25[-1], polar_angle_n454_s25} + polar_angle_n463_term + {24'h0, polar_angle_n457_s25}; // s25f24
    wire polar_angle_n464_over = ~polar_angle_n463[0] & (|polar_angle_n463[-1]);
    wire polar_angle_n464_under = polar_angle_n463[0] & ~(&polar_angle_n463[-1]);
    wire signed [-1:-24] polar_angle_n464 = polar_angle_n464_over ? 24'h7fffff : polar_angle_n464_under ? 24'h800000 : polar_angle_n463[-1:-24]; // s24f24
    wire signed [3:-24] polar_angle_n465_cut = polar_angle_n461[3:-24];
    wire polar_angle_n465_over = ~polar_angle_n465_cut[3] & (|polar_angle_n465_cut[2]);
    wire polar_angle_n465_under = polar_angle_n465_cut[3] & ~(&polar_angle_n465_cut[2]);
    wire signed [2:-24] polar_angle_n465 = polar_angle_n465_over ? 27'h3ffffff : polar_angle_n465_under ? 27'h4000000 : polar_angle_n465_cut[2:-24]; // s27f24
    wire signed [3:-24] polar_angle_n466_cut = polar_angle_n462[3:-24];
    wire polar_angle_n466_over = ~polar_angle_n466_cut[3] & (|polar_angle_n466_cut[2]);
    wire polar_angle_n466_under = polar_angle_n466_cut[3] & ~(&polar_angle_n466_cut[2]);
    wire signed [2:-24] polar_angle_n466 = polar_angle_n466_over ? 27'h3ffffff : polar_angle_n466_under ? 27'h4000000 : polar_angle_n466_cut[2:-24]; // s27f24
    wire polar_angle_n467 = polar_angle_n466[2]; // u1f0
    wire polar_angle_n468 = polar_angle_n467 ^ azimuth_n76; // u1f0
    wire signed [-14:-40] polar_angle_n469 = polar_angle_n465; // s27f40
    wire [3:-40] polar_angle_n470_term = {{17{polar_angle_n469[-14]}}, polar_angle_n469} ^ {44{polar_angle_n468}};
    wire signed [3:-40] polar_angle_n470 = {polar_angle_n466[2], polar_angle_n466, 16'h0} + polar_angle_n470_term + {43'h0, polar_angle_n468}; // s44f40
    wire [0:-24] polar_angle_n471_term = {azimuth_n260[-1], azimuth_n260} ^ {25{polar_angle_n467}};
    wire signed [0:-24] polar_angle_n471 = {polar_angle_n464[-1], polar_angle_n464} + polar_angle_n471_term + {24'h0, polar_angle_n467}; // s25f24
    wire polar_angle_n472_over = ~polar_angle_n471[0] & (|polar_angle_n471[-1]);
    wire polar_angle_n472_under = polar_angle_n471[0] & ~(&polar_angle_n471[-1]);
    wire signed [-1:-24] polar_angle_n472 = polar_angle_n472_over ? 24'h7fffff : polar_angle_n472_under ? 24'h800000 : polar_angle_n471[-1:-24]; // s24f24

    reg polar_angle_n301_s26; // u1f0
    reg signed [3:-40] polar_angle_n470_s26; // s44f40
    reg signed [-1:-24] polar_angle_n472_s26; // s24f24
    reg [-1:-16] phi_next_s26; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n301_s26 <= polar_angle_n301_s25;
            polar_angle_n470_s26 <= polar_angle_n470;
            polar_angle_n472_s26 <= polar_angle_n472;
            phi_next_s26 <= phi_next_s25;
        end
    reg valid_s26;
    always @(posedge clk)
        if (rst) valid_s26 <= 1'b0;
        else if (ce) valid_s26 <= valid_s25;

    // ---- stage 26 ----
    // polar_angle
    wire signed [3:-24] polar_angle_n473_cut = polar_angle_n470_s26[3:-24];
    wire polar_angle_n473_over = ~polar_angle_n473_cut[3] & (|polar_angle_n473_cut[2]);
    wire polar_angle_n473_under = polar_angle_n473_cut[3] & ~(&polar_angle_n473_cut[2]);
    wire signed [2:-24] polar_angle_n473 = polar_angle_n473_over ? 27'h3ffffff : polar_angle_n473_under ? 27'h4000000 : polar_angle_n473_cut[2:-24]; // s27f24
    wire polar_angle_n474 = polar_angle_n473[2]; // u1f0
    wire [0:-24] polar_angle_n475_term = {azimuth_n268[-1], azimuth_n268} ^ {25{polar_angle_n474}};
    wire signed [0:-24] polar_angle_n475 = {polar_angle_n472_s26[-1], polar_angle_n472_s26} + polar_angle_n475_term + {24'h0, polar_angle_n474}; // s25f24
    wire polar_angle_n476_over = ~polar_angle_n475[0] & (|polar_angle_n475[-1]);
    wire polar_angle_n476_under = polar_angle_n475[0] & ~(&polar_angle_n475[-1]);
    wire signed [-1:-24] polar_angle_n476 = polar_angle_n476_over ? 24'h7fffff : polar_angle_n476_under ? 24'h800000 : polar_angle_n475[-1:-24]; // s24f24
    wire [-1:-24] polar_angle_n477 = polar_angle_n476; // u24f24
    wire [-1:-24] polar_angle_n478 = polar_angle_n477 ^ azimuth_n273; // u24f24
    wire [-1:-24] polar_angle_n479 = polar_angle_n301_s26 ? polar_angle_n478 : polar_angle_n477; // u24f24
    // (unit)
    wire [0:-24] n482_sum = {1'b0, polar_angle_n479} + 25'h80;
    wire [0:-16] n482_cut = n482_sum[0:-16];
    wire [0:-16] n482 = n482_cut; // u17f16
    wire [-1:-16] theta_next = n482[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            phi <= phi_next_s26;
            theta <= theta_next;
        end
    reg valid_s27;
    always @(posedge clk)
        if (rst) valid_s27 <= 1'b0;
        else if (ce) valid_s27 <= valid_s26;
    assign valid_out = valid_s27;

    // ---- stage 27 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        angles_n4[0],
        angles_n6[0],
        angles_n8[0],
        angles_n10[0],
        angles_x_plus_n[-11:-16],
        angles_n12[0],
        angles_x_minus_n[-11:-16],
        angles_n14[0],
        angles_y_plus_n[-11:-16],
        angles_n16[0],
        angles_y_minus_n[-11:-16],
        angles_n18[0],
        angles_a_plus_n[-11:-16],
        angles_n20[0],
        angles_a_minus_n[-11:-16],
        sincos_row[39:20],
        sincos_row_2[39:20],
        x_sum[-19:-20],
        y_sum[-19],
        z_sum[-19:-20],
        azimuth_n93_s4[-25],
        azimuth_n94[-25],
        azimuth_n104[-25:-26],
        azimuth_n105[-25:-26],
        azimuth_n115[-25:-27],
        azimuth_n116[-25:-27],
        azimuth_n126[-25:-28],
        azimuth_n127_s6[-25:-28],
        azimuth_n137[-25:-29],
        azimuth_n138[-25:-29],
        polar_angle_n296[-25:-42],
        azimuth_n148[-25:-30],
        azimuth_n149[-25:-30],
        azimuth_n159[-25:-31],
        azimuth_n160_s8[-25:-31],
        azimuth_n170[-25:-32],
        azimuth_n171[-25:-32],
        azimuth_n181[-25:-33],
        azimuth_n182[-25:-33],
        azimuth_n192[-25:-34],
        azimuth_n193_s10[-25:-34],
        azimuth_n203[-25:-35],
        azimuth_n204[-25:-35],
        azimuth_n214[-25:-36],
        azimuth_n215[-25:-36],
        azimuth_n225[-25:-37],
        azimuth_n226_s12[-25:-37],
        azimuth_n236[-25:-38],
        azimuth_n237[-25:-38],
        azimuth_n247[-25:-39],
        azimuth_n248[-25:-39],
        azimuth_n258_s14[-25:-40],
        azimuth_n259_s14[-25:-40],
        azimuth_n267[-25:-41],
        n480[0],
        n480_sum[-17:-24],
        polar_angle_n321[-25],
        polar_angle_n322[-25],
        polar_angle_n331[-25:-26],
        polar_angle_n332[-25:-26],
        polar_angle_n341[-25:-27],
        polar_angle_n342[-25:-27],
        polar_angle_n351[-25:-28],
        polar_angle_n352_s18[-25:-28],
        polar_angle_n361[-25:-29],
        polar_angle_n362[-25:-29],
        polar_angle_n371[-25:-30],
        polar_angle_n372[-25:-30],
        polar_angle_n381[-25:-31],
        polar_angle_n382_s20[-25:-31],
        polar_angle_n391[-25:-32],
        polar_angle_n392[-25:-32],
        polar_angle_n401[-25:-33],
        polar_angle_n402[-25:-33],
        polar_angle_n411[-25:-34],
        polar_angle_n412_s22[-25:-34],
        polar_angle_n421[-25:-35],
        polar_angle_n422[-25:-35],
        polar_angle_n431[-25:-36],
        polar_angle_n432[-25:-36],
        polar_angle_n441[-25:-37],
        polar_angle_n442_s24[-25:-37],
        polar_angle_n451[-25:-38],
        polar_angle_n452[-25:-38],
        polar_angle_n461[-25:-39],
        polar_angle_n462[-25:-39],
        polar_angle_n470_s26[-25:-40],
        polar_angle_n473[1:-24],
        n482[0],
        n482_sum[-17:-24]};
endmodule
