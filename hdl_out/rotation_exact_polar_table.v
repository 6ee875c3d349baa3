// rotation: turns a direction in polar form into the frame of a surface normal
// made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
//   variant=exact output=polar-table angle_bits=16 table_addr_bits=10 scheme=direct
//   quarter_wave=off frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate
//   sincos_addr_bits=auto asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
//   prop_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
//   period_ps=5000 stages=auto rom=block
// latency 18 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   angle: mean 1.43e-3 rad, largest seen 5.07e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   dot: mean 1.43e-3, largest seen 5.07e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   x: mean 7.76e-4, largest seen 4.02e-3 at phi_a=49436 theta_a=17053 phi_n=14175 theta_n=17886
//   y: mean 6.22e-4, largest seen 3.23e-3 at phi_a=58542 theta_a=14878 phi_n=27212 theta_n=6389
//   z: mean 7.43e-4, largest seen 4.00e-3 at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
// stated bound on the angle: 1.82e-2 rad
module rotation_exact_polar_table (
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

    // table recip: recip u20f18
    (* rom_style = "block" *)
    reg [19:0] recip_rom [0:1023];
    initial begin
        recip_rom[0] = 20'h7ff01; recip_rom[1] = 20'h7fd02; recip_rom[2] = 20'h7fb04; recip_rom[3] = 20'h7f907;
        recip_rom[4] = 20'h7f70b; recip_rom[5] = 20'h7f510; recip_rom[6] = 20'h7f316; recip_rom[7] = 20'h7f11d;
        recip_rom[8] = 20'h7ef24; recip_rom[9] = 20'h7ed2d; recip_rom[10] = 20'h7eb37; recip_rom[11] = 20'h7e942;
        recip_rom[12] = 20'h7e74e; recip_rom[13] = 20'h7e55b; recip_rom[14] = 20'h7e368; recip_rom[15] = 20'h7e177;
        recip_rom[16] = 20'h7df87; recip_rom[17] = 20'h7dd97; recip_rom[18] = 20'h7dba9; recip_rom[19] = 20'h7d9bb;
        recip_rom[20] = 20'h7d7cf; recip_rom[21] = 20'h7d5e3; recip_rom[22] = 20'h7d3f8; recip_rom[23] = 20'h7d20f;
        recip_rom[24] = 20'h7d026; recip_rom[25] = 20'h7ce3e; recip_rom[26] = 20'h7cc57; recip_rom[27] = 20'h7ca71;
        recip_rom[28] = 20'h7c88c; recip_rom[29] = 20'h7c6a8; recip_rom[30] = 20'h7c4c4; recip_rom[31] = 20'h7c2e2;
        recip_rom[32] = 20'h7c100; recip_rom[33] = 20'h7bf20; recip_rom[34] = 20'h7bd40; recip_rom[35] = 20'h7bb62;
        recip_rom[36] = 20'h7b984; recip_rom[37] = 20'h7b7a7; recip_rom[38] = 20'h7b5cb; recip_rom[39] = 20'h7b3f0;
        recip_rom[40] = 20'h7b215; recip_rom[41] = 20'h7b03c; recip_rom[42] = 20'h7ae64; recip_rom[43] = 20'h7ac8c;
        recip_rom[44] = 20'h7aab5; recip_rom[45] = 20'h7a8e0; recip_rom[46] = 20'h7a70b; recip_rom[47] = 20'h7a537;
        recip_rom[48] = 20'h7a364; recip_rom[49] = 20'h7a191; recip_rom[50] = 20'h79fc0; recip_rom[51] = 20'h79def;
        recip_rom[52] = 20'h79c1f; recip_rom[53] = 20'h79a51; recip_rom[54] = 20'h79883; recip_rom[55] = 20'h796b5;
        recip_rom[56] = 20'h794e9; recip_rom[57] = 20'h7931e; recip_rom[58] = 20'h79153; recip_rom[59] = 20'h78f89;
        recip_rom[60] = 20'h78dc1; recip_rom[61] = 20'h78bf9; recip_rom[62] = 20'h78a31; recip_rom[63] = 20'h7886b;
        recip_rom[64] = 20'h786a5; recip_rom[65] = 20'h784e1; recip_rom[66] = 20'h7831d; recip_rom[67] = 20'h7815a;
        recip_rom[68] = 20'h77f98; recip_rom[69] = 20'h77dd6; recip_rom[70] = 20'h77c16; recip_rom[71] = 20'h77a56;
        recip_rom[72] = 20'h77897; recip_rom[73] = 20'h776d9; recip_rom[74] = 20'h7751b; recip_rom[75] = 20'h7735f;
        recip_rom[76] = 20'h771a3; recip_rom[77] = 20'h76fe8; recip_rom[78] = 20'h76e2e; recip_rom[79] = 20'h76c75;
        recip_rom[80] = 20'h76abd; recip_rom[81] = 20'h76905; recip_rom[82] = 20'h7674e; recip_rom[83] = 20'h76598;
        recip_rom[84] = 20'h763e3; recip_rom[85] = 20'h7622e; recip_rom[86] = 20'h7607a; recip_rom[87] = 20'h75ec7;
        recip_rom[88] = 20'h75d15; recip_rom[89] = 20'h75b64; recip_rom[90] = 20'h759b3; recip_rom[91] = 20'h75803;
        recip_rom[92] = 20'h75654; recip_rom[93] = 20'h754a6; recip_rom[94] = 20'h752f8; recip_rom[95] = 20'h7514c;
        recip_rom[96] = 20'h74fa0; recip_rom[97] = 20'h74df4; recip_rom[98] = 20'h74c4a; recip_rom[99] = 20'h74aa0;
        recip_rom[100] = 20'h748f7; recip_rom[101] = 20'h7474f; recip_rom[102] = 20'h745a8; recip_rom[103] = 20'h74401;
        recip_rom[104] = 20'h7425b; recip_rom[105] = 20'h740b6; recip_rom[106] = 20'h73f11; recip_rom[107] = 20'h73d6e;
        recip_rom[108] = 20'h73bcb; recip_rom[109] = 20'h73a28; recip_rom[110] = 20'h73887; recip_rom[111] = 20'h736e6;
        recip_rom[112] = 20'h73546; recip_rom[113] = 20'h733a7; recip_rom[114] = 20'h73208; recip_rom[115] = 20'h7306b;
        recip_rom[116] = 20'h72ecd; recip_rom[117] = 20'h72d31; recip_rom[118] = 20'h72b95; recip_rom[119] = 20'h729fa;
        recip_rom[120] = 20'h72860; recip_rom[121] = 20'h726c7; recip_rom[122] = 20'h7252e; recip_rom[123] = 20'h72396;
        recip_rom[124] = 20'h721fe; recip_rom[125] = 20'h72068; recip_rom[126] = 20'h71ed2; recip_rom[127] = 20'h71d3d;
        recip_rom[128] = 20'h71ba8; recip_rom[129] = 20'h71a14; recip_rom[130] = 20'h71881; recip_rom[131] = 20'h716ef;
        recip_rom[132] = 20'h7155d; recip_rom[133] = 20'h713cc; recip_rom[134] = 20'h7123b; recip_rom[135] = 20'h710ac;
        recip_rom[136] = 20'h70f1d; recip_rom[137] = 20'h70d8f; recip_rom[138] = 20'h70c01; recip_rom[139] = 20'h70a74;
        recip_rom[140] = 20'h708e8; recip_rom[141] = 20'h7075c; recip_rom[142] = 20'h705d1; recip_rom[143] = 20'h70447;
        recip_rom[144] = 20'h702be; recip_rom[145] = 20'h70135; recip_rom[146] = 20'h6ffac; recip_rom[147] = 20'h6fe25;
        recip_rom[148] = 20'h6fc9e; recip_rom[149] = 20'h6fb18; recip_rom[150] = 20'h6f992; recip_rom[151] = 20'h6f80e;
        recip_rom[152] = 20'h6f689; recip_rom[153] = 20'h6f506; recip_rom[154] = 20'h6f383; recip_rom[155] = 20'h6f201;
        recip_rom[156] = 20'h6f07f; recip_rom[157] = 20'h6eefe; recip_rom[158] = 20'h6ed7e; recip_rom[159] = 20'h6ebfe;
        recip_rom[160] = 20'h6ea7f; recip_rom[161] = 20'h6e901; recip_rom[162] = 20'h6e783; recip_rom[163] = 20'h6e606;
        recip_rom[164] = 20'h6e48a; recip_rom[165] = 20'h6e30e; recip_rom[166] = 20'h6e193; recip_rom[167] = 20'h6e019;
        recip_rom[168] = 20'h6de9f; recip_rom[169] = 20'h6dd25; recip_rom[170] = 20'h6dbad; recip_rom[171] = 20'h6da35;
        recip_rom[172] = 20'h6d8be; recip_rom[173] = 20'h6d747; recip_rom[174] = 20'h6d5d1; recip_rom[175] = 20'h6d45b;
        recip_rom[176] = 20'h6d2e7; recip_rom[177] = 20'h6d172; recip_rom[178] = 20'h6cfff; recip_rom[179] = 20'h6ce8c;
        recip_rom[180] = 20'h6cd19; recip_rom[181] = 20'h6cba8; recip_rom[182] = 20'h6ca37; recip_rom[183] = 20'h6c8c6;
        recip_rom[184] = 20'h6c756; recip_rom[185] = 20'h6c5e7; recip_rom[186] = 20'h6c478; recip_rom[187] = 20'h6c30a;
        recip_rom[188] = 20'h6c19d; recip_rom[189] = 20'h6c030; recip_rom[190] = 20'h6bec3; recip_rom[191] = 20'h6bd58;
        recip_rom[192] = 20'h6bbed; recip_rom[193] = 20'h6ba82; recip_rom[194] = 20'h6b918; recip_rom[195] = 20'h6b7af;
        recip_rom[196] = 20'h6b646; recip_rom[197] = 20'h6b4de; recip_rom[198] = 20'h6b377; recip_rom[199] = 20'h6b210;
        recip_rom[200] = 20'h6b0a9; recip_rom[201] = 20'h6af44; recip_rom[202] = 20'h6adde; recip_rom[203] = 20'h6ac7a;
        recip_rom[204] = 20'h6ab16; recip_rom[205] = 20'h6a9b2; recip_rom[206] = 20'h6a84f; recip_rom[207] = 20'h6a6ed;
        recip_rom[208] = 20'h6a58b; recip_rom[209] = 20'h6a42a; recip_rom[210] = 20'h6a2ca; recip_rom[211] = 20'h6a16a;
        recip_rom[212] = 20'h6a00a; recip_rom[213] = 20'h69eab; recip_rom[214] = 20'h69d4d; recip_rom[215] = 20'h69bef;
        recip_rom[216] = 20'h69a92; recip_rom[217] = 20'h69936; recip_rom[218] = 20'h697da; recip_rom[219] = 20'h6967e;
        recip_rom[220] = 20'h69523; recip_rom[221] = 20'h693c9; recip_rom[222] = 20'h6926f; recip_rom[223] = 20'h69116;
        recip_rom[224] = 20'h68fbd; recip_rom[225] = 20'h68e65; recip_rom[226] = 20'h68d0d; recip_rom[227] = 20'h68bb6;
        recip_rom[228] = 20'h68a60; recip_rom[229] = 20'h6890a; recip_rom[230] = 20'h687b4; recip_rom[231] = 20'h68660;
        recip_rom[232] = 20'h6850b; recip_rom[233] = 20'h683b8; recip_rom[234] = 20'h68264; recip_rom[235] = 20'h68112;
        recip_rom[236] = 20'h67fbf; recip_rom[237] = 20'h67e6e; recip_rom[238] = 20'h67d1d; recip_rom[239] = 20'h67bcc;
        recip_rom[240] = 20'h67a7c; recip_rom[241] = 20'h6792d; recip_rom[242] = 20'h677de; recip_rom[243] = 20'h6768f;
        recip_rom[244] = 20'h67541; recip_rom[245] = 20'h673f4; recip_rom[246] = 20'h672a7; recip_rom[247] = 20'h6715b;
        recip_rom[248] = 20'h6700f; recip_rom[249] = 20'h66ec4; recip_rom[250] = 20'h66d79; recip_rom[251] = 20'h66c2f;
        recip_rom[252] = 20'h66ae5; recip_rom[253] = 20'h6699c; recip_rom[254] = 20'h66853; recip_rom[255] = 20'h6670b;
        recip_rom[256] = 20'h665c3; recip_rom[257] = 20'h6647c; recip_rom[258] = 20'h66335; recip_rom[259] = 20'h661ef;
        recip_rom[260] = 20'h660a9; recip_rom[261] = 20'h65f64; recip_rom[262] = 20'h65e20; recip_rom[263] = 20'h65cdb;
        recip_rom[264] = 20'h65b98; recip_rom[265] = 20'h65a55; recip_rom[266] = 20'h65912; recip_rom[267] = 20'h657d0;
        recip_rom[268] = 20'h6568e; recip_rom[269] = 20'h6554d; recip_rom[270] = 20'h6540d; recip_rom[271] = 20'h652cd;
        recip_rom[272] = 20'h6518d; recip_rom[273] = 20'h6504e; recip_rom[274] = 20'h64f0f; recip_rom[275] = 20'h64dd1;
        recip_rom[276] = 20'h64c93; recip_rom[277] = 20'h64b56; recip_rom[278] = 20'h64a19; recip_rom[279] = 20'h648dd;
        recip_rom[280] = 20'h647a1; recip_rom[281] = 20'h64666; recip_rom[282] = 20'h6452b; recip_rom[283] = 20'h643f1;
        recip_rom[284] = 20'h642b7; recip_rom[285] = 20'h6417e; recip_rom[286] = 20'h64045; recip_rom[287] = 20'h63f0d;
        recip_rom[288] = 20'h63dd5; recip_rom[289] = 20'h63c9d; recip_rom[290] = 20'h63b67; recip_rom[291] = 20'h63a30;
        recip_rom[292] = 20'h638fa; recip_rom[293] = 20'h637c5; recip_rom[294] = 20'h6368f; recip_rom[295] = 20'h6355b;
        recip_rom[296] = 20'h63427; recip_rom[297] = 20'h632f3; recip_rom[298] = 20'h631c0; recip_rom[299] = 20'h6308d;
        recip_rom[300] = 20'h62f5b; recip_rom[301] = 20'h62e29; recip_rom[302] = 20'h62cf8; recip_rom[303] = 20'h62bc7;
        recip_rom[304] = 20'h62a96; recip_rom[305] = 20'h62967; recip_rom[306] = 20'h62837; recip_rom[307] = 20'h62708;
        recip_rom[308] = 20'h625d9; recip_rom[309] = 20'h624ab; recip_rom[310] = 20'h6237e; recip_rom[311] = 20'h62250;
        recip_rom[312] = 20'h62123; recip_rom[313] = 20'h61ff7; recip_rom[314] = 20'h61ecb; recip_rom[315] = 20'h61da0;
        recip_rom[316] = 20'h61c75; recip_rom[317] = 20'h61b4a; recip_rom[318] = 20'h61a20; recip_rom[319] = 20'h618f7;
        recip_rom[320] = 20'h617cd; recip_rom[321] = 20'h616a5; recip_rom[322] = 20'h6157c; recip_rom[323] = 20'h61454;
        recip_rom[324] = 20'h6132d; recip_rom[325] = 20'h61206; recip_rom[326] = 20'h610df; recip_rom[327] = 20'h60fb9;
        recip_rom[328] = 20'h60e93; recip_rom[329] = 20'h60d6e; recip_rom[330] = 20'h60c49; recip_rom[331] = 20'h60b25;
        recip_rom[332] = 20'h60a01; recip_rom[333] = 20'h608dd; recip_rom[334] = 20'h607ba; recip_rom[335] = 20'h60698;
        recip_rom[336] = 20'h60575; recip_rom[337] = 20'h60453; recip_rom[338] = 20'h60332; recip_rom[339] = 20'h60211;
        recip_rom[340] = 20'h600f0; recip_rom[341] = 20'h5ffd0; recip_rom[342] = 20'h5feb1; recip_rom[343] = 20'h5fd91;
        recip_rom[344] = 20'h5fc72; recip_rom[345] = 20'h5fb54; recip_rom[346] = 20'h5fa36; recip_rom[347] = 20'h5f918;
        recip_rom[348] = 20'h5f7fb; recip_rom[349] = 20'h5f6de; recip_rom[350] = 20'h5f5c2; recip_rom[351] = 20'h5f4a6;
        recip_rom[352] = 20'h5f38a; recip_rom[353] = 20'h5f26f; recip_rom[354] = 20'h5f155; recip_rom[355] = 20'h5f03a;
        recip_rom[356] = 20'h5ef20; recip_rom[357] = 20'h5ee07; recip_rom[358] = 20'h5ecee; recip_rom[359] = 20'h5ebd5;
        recip_rom[360] = 20'h5eabd; recip_rom[361] = 20'h5e9a5; recip_rom[362] = 20'h5e88d; recip_rom[363] = 20'h5e776;
        recip_rom[364] = 20'h5e660; recip_rom[365] = 20'h5e549; recip_rom[366] = 20'h5e434; recip_rom[367] = 20'h5e31e;
        recip_rom[368] = 20'h5e209; recip_rom[369] = 20'h5e0f4; recip_rom[370] = 20'h5dfe0; recip_rom[371] = 20'h5decc;
        recip_rom[372] = 20'h5ddb9; recip_rom[373] = 20'h5dca6; recip_rom[374] = 20'h5db93; recip_rom[375] = 20'h5da81;
        recip_rom[376] = 20'h5d96f; recip_rom[377] = 20'h5d85d; recip_rom[378] = 20'h5d74c; recip_rom[379] = 20'h5d63b;
        recip_rom[380] = 20'h5d52b; recip_rom[381] = 20'h5d41b; recip_rom[382] = 20'h5d30b; recip_rom[383] = 20'h5d1fc;
        recip_rom[384] = 20'h5d0ed; recip_rom[385] = 20'h5cfdf; recip_rom[386] = 20'h5ced1; recip_rom[387] = 20'h5cdc3;
        recip_rom[388] = 20'h5ccb6; recip_rom[389] = 20'h5cba9; recip_rom[390] = 20'h5ca9c; recip_rom[391] = 20'h5c990;
        recip_rom[392] = 20'h5c885; recip_rom[393] = 20'h5c779; recip_rom[394] = 20'h5c66e; recip_rom[395] = 20'h5c564;
        recip_rom[396] = 20'h5c459; recip_rom[397] = 20'h5c34f; recip_rom[398] = 20'h5c246; recip_rom[399] = 20'h5c13d;
        recip_rom[400] = 20'h5c034; recip_rom[401] = 20'h5bf2c; recip_rom[402] = 20'h5be24; recip_rom[403] = 20'h5bd1c;
        recip_rom[404] = 20'h5bc15; recip_rom[405] = 20'h5bb0e; recip_rom[406] = 20'h5ba07; recip_rom[407] = 20'h5b901;
        recip_rom[408] = 20'h5b7fb; recip_rom[409] = 20'h5b6f6; recip_rom[410] = 20'h5b5f1; recip_rom[411] = 20'h5b4ec;
        recip_rom[412] = 20'h5b3e8; recip_rom[413] = 20'h5b2e4; recip_rom[414] = 20'h5b1e0; recip_rom[415] = 20'h5b0dd;
        recip_rom[416] = 20'h5afda; recip_rom[417] = 20'h5aed7; recip_rom[418] = 20'h5add5; recip_rom[419] = 20'h5acd3;
        recip_rom[420] = 20'h5abd2; recip_rom[421] = 20'h5aad1; recip_rom[422] = 20'h5a9d0; recip_rom[423] = 20'h5a8d0;
        recip_rom[424] = 20'h5a7d0; recip_rom[425] = 20'h5a6d0; recip_rom[426] = 20'h5a5d0; recip_rom[427] = 20'h5a4d1;
        recip_rom[428] = 20'h5a3d3; recip_rom[429] = 20'h5a2d5; recip_rom[430] = 20'h5a1d7; recip_rom[431] = 20'h5a0d9;
        recip_rom[432] = 20'h59fdc; recip_rom[433] = 20'h59edf; recip_rom[434] = 20'h59de2; recip_rom[435] = 20'h59ce6;
        recip_rom[436] = 20'h59bea; recip_rom[437] = 20'h59aef; recip_rom[438] = 20'h599f4; recip_rom[439] = 20'h598f9;
        recip_rom[440] = 20'h597fe; recip_rom[441] = 20'h59704; recip_rom[442] = 20'h5960a; recip_rom[443] = 20'h59511;
        recip_rom[444] = 20'h59418; recip_rom[445] = 20'h5931f; recip_rom[446] = 20'h59226; recip_rom[447] = 20'h5912e;
        recip_rom[448] = 20'h59037; recip_rom[449] = 20'h58f3f; recip_rom[450] = 20'h58e48; recip_rom[451] = 20'h58d51;
        recip_rom[452] = 20'h58c5b; recip_rom[453] = 20'h58b65; recip_rom[454] = 20'h58a6f; recip_rom[455] = 20'h58979;
        recip_rom[456] = 20'h58884; recip_rom[457] = 20'h58790; recip_rom[458] = 20'h5869b; recip_rom[459] = 20'h585a7;
        recip_rom[460] = 20'h584b3; recip_rom[461] = 20'h583c0; recip_rom[462] = 20'h582cd; recip_rom[463] = 20'h581da;
        recip_rom[464] = 20'h580e7; recip_rom[465] = 20'h57ff5; recip_rom[466] = 20'h57f03; recip_rom[467] = 20'h57e12;
        recip_rom[468] = 20'h57d21; recip_rom[469] = 20'h57c30; recip_rom[470] = 20'h57b3f; recip_rom[471] = 20'h57a4f;
        recip_rom[472] = 20'h5795f; recip_rom[473] = 20'h57870; recip_rom[474] = 20'h57780; recip_rom[475] = 20'h57692;
        recip_rom[476] = 20'h575a3; recip_rom[477] = 20'h574b5; recip_rom[478] = 20'h573c7; recip_rom[479] = 20'h572d9;
        recip_rom[480] = 20'h571ec; recip_rom[481] = 20'h570ff; recip_rom[482] = 20'h57012; recip_rom[483] = 20'h56f26;
        recip_rom[484] = 20'h56e39; recip_rom[485] = 20'h56d4e; recip_rom[486] = 20'h56c62; recip_rom[487] = 20'h56b77;
        recip_rom[488] = 20'h56a8c; recip_rom[489] = 20'h569a2; recip_rom[490] = 20'h568b7; recip_rom[491] = 20'h567ce;
        recip_rom[492] = 20'h566e4; recip_rom[493] = 20'h565fb; recip_rom[494] = 20'h56512; recip_rom[495] = 20'h56429;
        recip_rom[496] = 20'h56341; recip_rom[497] = 20'h56259; recip_rom[498] = 20'h56171; recip_rom[499] = 20'h56089;
        recip_rom[500] = 20'h55fa2; recip_rom[501] = 20'h55ebb; recip_rom[502] = 20'h55dd5; recip_rom[503] = 20'h55cef;
        recip_rom[504] = 20'h55c09; recip_rom[505] = 20'h55b23; recip_rom[506] = 20'h55a3e; recip_rom[507] = 20'h55959;
        recip_rom[508] = 20'h55874; recip_rom[509] = 20'h5578f; recip_rom[510] = 20'h556ab; recip_rom[511] = 20'h555c7;
        recip_rom[512] = 20'h554e4; recip_rom[513] = 20'h55401; recip_rom[514] = 20'h5531e; recip_rom[515] = 20'h5523b;
        recip_rom[516] = 20'h55159; recip_rom[517] = 20'h55077; recip_rom[518] = 20'h54f95; recip_rom[519] = 20'h54eb3;
        recip_rom[520] = 20'h54dd2; recip_rom[521] = 20'h54cf1; recip_rom[522] = 20'h54c10; recip_rom[523] = 20'h54b30;
        recip_rom[524] = 20'h54a50; recip_rom[525] = 20'h54970; recip_rom[526] = 20'h54891; recip_rom[527] = 20'h547b2;
        recip_rom[528] = 20'h546d3; recip_rom[529] = 20'h545f4; recip_rom[530] = 20'h54516; recip_rom[531] = 20'h54438;
        recip_rom[532] = 20'h5435a; recip_rom[533] = 20'h5427d; recip_rom[534] = 20'h541a0; recip_rom[535] = 20'h540c3;
        recip_rom[536] = 20'h53fe6; recip_rom[537] = 20'h53f0a; recip_rom[538] = 20'h53e2e; recip_rom[539] = 20'h53d52;
        recip_rom[540] = 20'h53c76; recip_rom[541] = 20'h53b9b; recip_rom[542] = 20'h53ac0; recip_rom[543] = 20'h539e6;
        recip_rom[544] = 20'h5390b; recip_rom[545] = 20'h53831; recip_rom[546] = 20'h53757; recip_rom[547] = 20'h5367e;
        recip_rom[548] = 20'h535a5; recip_rom[549] = 20'h534cc; recip_rom[550] = 20'h533f3; recip_rom[551] = 20'h5331a;
        recip_rom[552] = 20'h53242; recip_rom[553] = 20'h5316a; recip_rom[554] = 20'h53093; recip_rom[555] = 20'h52fbc;
        recip_rom[556] = 20'h52ee4; recip_rom[557] = 20'h52e0e; recip_rom[558] = 20'h52d37; recip_rom[559] = 20'h52c61;
        recip_rom[560] = 20'h52b8b; recip_rom[561] = 20'h52ab5; recip_rom[562] = 20'h529e0; recip_rom[563] = 20'h5290b;
        recip_rom[564] = 20'h52836; recip_rom[565] = 20'h52761; recip_rom[566] = 20'h5268d; recip_rom[567] = 20'h525b9;
        recip_rom[568] = 20'h524e5; recip_rom[569] = 20'h52411; recip_rom[570] = 20'h5233e; recip_rom[571] = 20'h5226b;
        recip_rom[572] = 20'h52198; recip_rom[573] = 20'h520c6; recip_rom[574] = 20'h51ff3; recip_rom[575] = 20'h51f21;
        recip_rom[576] = 20'h51e50; recip_rom[577] = 20'h51d7e; recip_rom[578] = 20'h51cad; recip_rom[579] = 20'h51bdc;
        recip_rom[580] = 20'h51b0b; recip_rom[581] = 20'h51a3b; recip_rom[582] = 20'h5196b; recip_rom[583] = 20'h5189b;
        recip_rom[584] = 20'h517cb; recip_rom[585] = 20'h516fc; recip_rom[586] = 20'h5162d; recip_rom[587] = 20'h5155e;
        recip_rom[588] = 20'h5148f; recip_rom[589] = 20'h513c1; recip_rom[590] = 20'h512f3; recip_rom[591] = 20'h51225;
        recip_rom[592] = 20'h51158; recip_rom[593] = 20'h5108a; recip_rom[594] = 20'h50fbd; recip_rom[595] = 20'h50ef0;
        recip_rom[596] = 20'h50e24; recip_rom[597] = 20'h50d57; recip_rom[598] = 20'h50c8b; recip_rom[599] = 20'h50bc0;
        recip_rom[600] = 20'h50af4; recip_rom[601] = 20'h50a29; recip_rom[602] = 20'h5095e; recip_rom[603] = 20'h50893;
        recip_rom[604] = 20'h507c8; recip_rom[605] = 20'h506fe; recip_rom[606] = 20'h50634; recip_rom[607] = 20'h5056a;
        recip_rom[608] = 20'h504a0; recip_rom[609] = 20'h503d7; recip_rom[610] = 20'h5030e; recip_rom[611] = 20'h50245;
        recip_rom[612] = 20'h5017d; recip_rom[613] = 20'h500b4; recip_rom[614] = 20'h4ffec; recip_rom[615] = 20'h4ff24;
        recip_rom[616] = 20'h4fe5d; recip_rom[617] = 20'h4fd95; recip_rom[618] = 20'h4fcce; recip_rom[619] = 20'h4fc07;
        recip_rom[620] = 20'h4fb41; recip_rom[621] = 20'h4fa7a; recip_rom[622] = 20'h4f9b4; recip_rom[623] = 20'h4f8ee;
        recip_rom[624] = 20'h4f829; recip_rom[625] = 20'h4f763; recip_rom[626] = 20'h4f69e; recip_rom[627] = 20'h4f5d9;
        recip_rom[628] = 20'h4f514; recip_rom[629] = 20'h4f450; recip_rom[630] = 20'h4f38c; recip_rom[631] = 20'h4f2c8;
        recip_rom[632] = 20'h4f204; recip_rom[633] = 20'h4f140; recip_rom[634] = 20'h4f07d; recip_rom[635] = 20'h4efba;
        recip_rom[636] = 20'h4eef7; recip_rom[637] = 20'h4ee34; recip_rom[638] = 20'h4ed72; recip_rom[639] = 20'h4ecb0;
        recip_rom[640] = 20'h4ebee; recip_rom[641] = 20'h4eb2c; recip_rom[642] = 20'h4ea6b; recip_rom[643] = 20'h4e9aa;
        recip_rom[644] = 20'h4e8e9; recip_rom[645] = 20'h4e828; recip_rom[646] = 20'h4e768; recip_rom[647] = 20'h4e6a7;
        recip_rom[648] = 20'h4e5e7; recip_rom[649] = 20'h4e527; recip_rom[650] = 20'h4e468; recip_rom[651] = 20'h4e3a9;
        recip_rom[652] = 20'h4e2e9; recip_rom[653] = 20'h4e22a; recip_rom[654] = 20'h4e16c; recip_rom[655] = 20'h4e0ad;
        recip_rom[656] = 20'h4dfef; recip_rom[657] = 20'h4df31; recip_rom[658] = 20'h4de73; recip_rom[659] = 20'h4ddb6;
        recip_rom[660] = 20'h4dcf9; recip_rom[661] = 20'h4dc3b; recip_rom[662] = 20'h4db7f; recip_rom[663] = 20'h4dac2;
        recip_rom[664] = 20'h4da06; recip_rom[665] = 20'h4d949; recip_rom[666] = 20'h4d88d; recip_rom[667] = 20'h4d7d2;
        recip_rom[668] = 20'h4d716; recip_rom[669] = 20'h4d65b; recip_rom[670] = 20'h4d5a0; recip_rom[671] = 20'h4d4e5;
        recip_rom[672] = 20'h4d42a; recip_rom[673] = 20'h4d370; recip_rom[674] = 20'h4d2b6; recip_rom[675] = 20'h4d1fc;
        recip_rom[676] = 20'h4d142; recip_rom[677] = 20'h4d088; recip_rom[678] = 20'h4cfcf; recip_rom[679] = 20'h4cf16;
        recip_rom[680] = 20'h4ce5d; recip_rom[681] = 20'h4cda4; recip_rom[682] = 20'h4ccec; recip_rom[683] = 20'h4cc33;
        recip_rom[684] = 20'h4cb7b; recip_rom[685] = 20'h4cac4; recip_rom[686] = 20'h4ca0c; recip_rom[687] = 20'h4c955;
        recip_rom[688] = 20'h4c89d; recip_rom[689] = 20'h4c7e7; recip_rom[690] = 20'h4c730; recip_rom[691] = 20'h4c679;
        recip_rom[692] = 20'h4c5c3; recip_rom[693] = 20'h4c50d; recip_rom[694] = 20'h4c457; recip_rom[695] = 20'h4c3a1;
        recip_rom[696] = 20'h4c2ec; recip_rom[697] = 20'h4c236; recip_rom[698] = 20'h4c181; recip_rom[699] = 20'h4c0cd;
        recip_rom[700] = 20'h4c018; recip_rom[701] = 20'h4bf64; recip_rom[702] = 20'h4beaf; recip_rom[703] = 20'h4bdfb;
        recip_rom[704] = 20'h4bd48; recip_rom[705] = 20'h4bc94; recip_rom[706] = 20'h4bbe1; recip_rom[707] = 20'h4bb2d;
        recip_rom[708] = 20'h4ba7a; recip_rom[709] = 20'h4b9c8; recip_rom[710] = 20'h4b915; recip_rom[711] = 20'h4b863;
        recip_rom[712] = 20'h4b7b1; recip_rom[713] = 20'h4b6ff; recip_rom[714] = 20'h4b64d; recip_rom[715] = 20'h4b59b;
        recip_rom[716] = 20'h4b4ea; recip_rom[717] = 20'h4b439; recip_rom[718] = 20'h4b388; recip_rom[719] = 20'h4b2d7;
        recip_rom[720] = 20'h4b227; recip_rom[721] = 20'h4b176; recip_rom[722] = 20'h4b0c6; recip_rom[723] = 20'h4b016;
        recip_rom[724] = 20'h4af67; recip_rom[725] = 20'h4aeb7; recip_rom[726] = 20'h4ae08; recip_rom[727] = 20'h4ad59;
        recip_rom[728] = 20'h4acaa; recip_rom[729] = 20'h4abfb; recip_rom[730] = 20'h4ab4d; recip_rom[731] = 20'h4aa9e;
        recip_rom[732] = 20'h4a9f0; recip_rom[733] = 20'h4a942; recip_rom[734] = 20'h4a895; recip_rom[735] = 20'h4a7e7;
        recip_rom[736] = 20'h4a73a; recip_rom[737] = 20'h4a68d; recip_rom[738] = 20'h4a5e0; recip_rom[739] = 20'h4a533;
        recip_rom[740] = 20'h4a487; recip_rom[741] = 20'h4a3da; recip_rom[742] = 20'h4a32e; recip_rom[743] = 20'h4a282;
        recip_rom[744] = 20'h4a1d6; recip_rom[745] = 20'h4a12b; recip_rom[746] = 20'h4a07f; recip_rom[747] = 20'h49fd4;
        recip_rom[748] = 20'h49f29; recip_rom[749] = 20'h49e7e; recip_rom[750] = 20'h49dd4; recip_rom[751] = 20'h49d29;
        recip_rom[752] = 20'h49c7f; recip_rom[753] = 20'h49bd5; recip_rom[754] = 20'h49b2b; recip_rom[755] = 20'h49a82;
        recip_rom[756] = 20'h499d8; recip_rom[757] = 20'h4992f; recip_rom[758] = 20'h49886; recip_rom[759] = 20'h497dd;
        recip_rom[760] = 20'h49734; recip_rom[761] = 20'h4968c; recip_rom[762] = 20'h495e4; recip_rom[763] = 20'h4953c;
        recip_rom[764] = 20'h49494; recip_rom[765] = 20'h493ec; recip_rom[766] = 20'h49344; recip_rom[767] = 20'h4929d;
        recip_rom[768] = 20'h491f6; recip_rom[769] = 20'h4914f; recip_rom[770] = 20'h490a8; recip_rom[771] = 20'h49001;
        recip_rom[772] = 20'h48f5b; recip_rom[773] = 20'h48eb5; recip_rom[774] = 20'h48e0f; recip_rom[775] = 20'h48d69;
        recip_rom[776] = 20'h48cc3; recip_rom[777] = 20'h48c1d; recip_rom[778] = 20'h48b78; recip_rom[779] = 20'h48ad3;
        recip_rom[780] = 20'h48a2e; recip_rom[781] = 20'h48989; recip_rom[782] = 20'h488e5; recip_rom[783] = 20'h48840;
        recip_rom[784] = 20'h4879c; recip_rom[785] = 20'h486f8; recip_rom[786] = 20'h48654; recip_rom[787] = 20'h485b0;
        recip_rom[788] = 20'h4850d; recip_rom[789] = 20'h48469; recip_rom[790] = 20'h483c6; recip_rom[791] = 20'h48323;
        recip_rom[792] = 20'h48281; recip_rom[793] = 20'h481de; recip_rom[794] = 20'h4813c; recip_rom[795] = 20'h48099;
        recip_rom[796] = 20'h47ff7; recip_rom[797] = 20'h47f55; recip_rom[798] = 20'h47eb4; recip_rom[799] = 20'h47e12;
        recip_rom[800] = 20'h47d71; recip_rom[801] = 20'h47ccf; recip_rom[802] = 20'h47c2e; recip_rom[803] = 20'h47b8e;
        recip_rom[804] = 20'h47aed; recip_rom[805] = 20'h47a4c; recip_rom[806] = 20'h479ac; recip_rom[807] = 20'h4790c;
        recip_rom[808] = 20'h4786c; recip_rom[809] = 20'h477cc; recip_rom[810] = 20'h4772d; recip_rom[811] = 20'h4768d;
        recip_rom[812] = 20'h475ee; recip_rom[813] = 20'h4754f; recip_rom[814] = 20'h474b0; recip_rom[815] = 20'h47411;
        recip_rom[816] = 20'h47373; recip_rom[817] = 20'h472d4; recip_rom[818] = 20'h47236; recip_rom[819] = 20'h47198;
        recip_rom[820] = 20'h470fa; recip_rom[821] = 20'h4705c; recip_rom[822] = 20'h46fbf; recip_rom[823] = 20'h46f21;
        recip_rom[824] = 20'h46e84; recip_rom[825] = 20'h46de7; recip_rom[826] = 20'h46d4a; recip_rom[827] = 20'h46cae;
        recip_rom[828] = 20'h46c11; recip_rom[829] = 20'h46b75; recip_rom[830] = 20'h46ad8; recip_rom[831] = 20'h46a3c;
        recip_rom[832] = 20'h469a1; recip_rom[833] = 20'h46905; recip_rom[834] = 20'h46869; recip_rom[835] = 20'h467ce;
        recip_rom[836] = 20'h46733; recip_rom[837] = 20'h46698; recip_rom[838] = 20'h465fd; recip_rom[839] = 20'h46562;
        recip_rom[840] = 20'h464c8; recip_rom[841] = 20'h4642d; recip_rom[842] = 20'h46393; recip_rom[843] = 20'h462f9;
        recip_rom[844] = 20'h4625f; recip_rom[845] = 20'h461c6; recip_rom[846] = 20'h4612c; recip_rom[847] = 20'h46093;
        recip_rom[848] = 20'h45ffa; recip_rom[849] = 20'h45f61; recip_rom[850] = 20'h45ec8; recip_rom[851] = 20'h45e2f;
        recip_rom[852] = 20'h45d96; recip_rom[853] = 20'h45cfe; recip_rom[854] = 20'h45c66; recip_rom[855] = 20'h45bce;
        recip_rom[856] = 20'h45b36; recip_rom[857] = 20'h45a9e; recip_rom[858] = 20'h45a07; recip_rom[859] = 20'h4596f;
        recip_rom[860] = 20'h458d8; recip_rom[861] = 20'h45841; recip_rom[862] = 20'h457aa; recip_rom[863] = 20'h45713;
        recip_rom[864] = 20'h4567c; recip_rom[865] = 20'h455e6; recip_rom[866] = 20'h45550; recip_rom[867] = 20'h454ba;
        recip_rom[868] = 20'h45424; recip_rom[869] = 20'h4538e; recip_rom[870] = 20'h452f8; recip_rom[871] = 20'h45263;
        recip_rom[872] = 20'h451cd; recip_rom[873] = 20'h45138; recip_rom[874] = 20'h450a3; recip_rom[875] = 20'h4500e;
        recip_rom[876] = 20'h44f79; recip_rom[877] = 20'h44ee5; recip_rom[878] = 20'h44e50; recip_rom[879] = 20'h44dbc;
        recip_rom[880] = 20'h44d28; recip_rom[881] = 20'h44c94; recip_rom[882] = 20'h44c00; recip_rom[883] = 20'h44b6d;
        recip_rom[884] = 20'h44ad9; recip_rom[885] = 20'h44a46; recip_rom[886] = 20'h449b3; recip_rom[887] = 20'h44920;
        recip_rom[888] = 20'h4488d; recip_rom[889] = 20'h447fa; recip_rom[890] = 20'h44768; recip_rom[891] = 20'h446d5;
        recip_rom[892] = 20'h44643; recip_rom[893] = 20'h445b1; recip_rom[894] = 20'h4451f; recip_rom[895] = 20'h4448d;
        recip_rom[896] = 20'h443fc; recip_rom[897] = 20'h4436a; recip_rom[898] = 20'h442d9; recip_rom[899] = 20'h44248;
        recip_rom[900] = 20'h441b7; recip_rom[901] = 20'h44126; recip_rom[902] = 20'h44095; recip_rom[903] = 20'h44004;
        recip_rom[904] = 20'h43f74; recip_rom[905] = 20'h43ee4; recip_rom[906] = 20'h43e54; recip_rom[907] = 20'h43dc4;
        recip_rom[908] = 20'h43d34; recip_rom[909] = 20'h43ca4; recip_rom[910] = 20'h43c15; recip_rom[911] = 20'h43b85;
        recip_rom[912] = 20'h43af6; recip_rom[913] = 20'h43a67; recip_rom[914] = 20'h439d8; recip_rom[915] = 20'h43949;
        recip_rom[916] = 20'h438ba; recip_rom[917] = 20'h4382c; recip_rom[918] = 20'h4379e; recip_rom[919] = 20'h4370f;
        recip_rom[920] = 20'h43681; recip_rom[921] = 20'h435f3; recip_rom[922] = 20'h43566; recip_rom[923] = 20'h434d8;
        recip_rom[924] = 20'h4344b; recip_rom[925] = 20'h433bd; recip_rom[926] = 20'h43330; recip_rom[927] = 20'h432a3;
        recip_rom[928] = 20'h43216; recip_rom[929] = 20'h43189; recip_rom[930] = 20'h430fd; recip_rom[931] = 20'h43070;
        recip_rom[932] = 20'h42fe4; recip_rom[933] = 20'h42f58; recip_rom[934] = 20'h42ecc; recip_rom[935] = 20'h42e40;
        recip_rom[936] = 20'h42db4; recip_rom[937] = 20'h42d28; recip_rom[938] = 20'h42c9d; recip_rom[939] = 20'h42c12;
        recip_rom[940] = 20'h42b86; recip_rom[941] = 20'h42afb; recip_rom[942] = 20'h42a70; recip_rom[943] = 20'h429e6;
        recip_rom[944] = 20'h4295b; recip_rom[945] = 20'h428d1; recip_rom[946] = 20'h42846; recip_rom[947] = 20'h427bc;
        recip_rom[948] = 20'h42732; recip_rom[949] = 20'h426a8; recip_rom[950] = 20'h4261e; recip_rom[951] = 20'h42595;
        recip_rom[952] = 20'h4250b; recip_rom[953] = 20'h42482; recip_rom[954] = 20'h423f9; recip_rom[955] = 20'h42370;
        recip_rom[956] = 20'h422e7; recip_rom[957] = 20'h4225e; recip_rom[958] = 20'h421d5; recip_rom[959] = 20'h4214d;
        recip_rom[960] = 20'h420c4; recip_rom[961] = 20'h4203c; recip_rom[962] = 20'h41fb4; recip_rom[963] = 20'h41f2c;
        recip_rom[964] = 20'h41ea4; recip_rom[965] = 20'h41e1c; recip_rom[966] = 20'h41d95; recip_rom[967] = 20'h41d0d;
        recip_rom[968] = 20'h41c86; recip_rom[969] = 20'h41bff; recip_rom[970] = 20'h41b78; recip_rom[971] = 20'h41af1;
        recip_rom[972] = 20'h41a6a; recip_rom[973] = 20'h419e4; recip_rom[974] = 20'h4195d; recip_rom[975] = 20'h418d7;
        recip_rom[976] = 20'h41851; recip_rom[977] = 20'h417ca; recip_rom[978] = 20'h41744; recip_rom[979] = 20'h416bf;
        recip_rom[980] = 20'h41639; recip_rom[981] = 20'h415b3; recip_rom[982] = 20'h4152e; recip_rom[983] = 20'h414a9;
        recip_rom[984] = 20'h41424; recip_rom[985] = 20'h4139f; recip_rom[986] = 20'h4131a; recip_rom[987] = 20'h41295;
        recip_rom[988] = 20'h41210; recip_rom[989] = 20'h4118c; recip_rom[990] = 20'h41107; recip_rom[991] = 20'h41083;
        recip_rom[992] = 20'h40fff; recip_rom[993] = 20'h40f7b; recip_rom[994] = 20'h40ef7; recip_rom[995] = 20'h40e74;
        recip_rom[996] = 20'h40df0; recip_rom[997] = 20'h40d6d; recip_rom[998] = 20'h40ce9; recip_rom[999] = 20'h40c66;
        recip_rom[1000] = 20'h40be3; recip_rom[1001] = 20'h40b60; recip_rom[1002] = 20'h40add; recip_rom[1003] = 20'h40a5b;
        recip_rom[1004] = 20'h409d8; recip_rom[1005] = 20'h40956; recip_rom[1006] = 20'h408d3; recip_rom[1007] = 20'h40851;
        recip_rom[1008] = 20'h407cf; recip_rom[1009] = 20'h4074d; recip_rom[1010] = 20'h406cc; recip_rom[1011] = 20'h4064a;
        recip_rom[1012] = 20'h405c8; recip_rom[1013] = 20'h40547; recip_rom[1014] = 20'h404c6; recip_rom[1015] = 20'h40445;
        recip_rom[1016] = 20'h403c4; recip_rom[1017] = 20'h40343; recip_rom[1018] = 20'h402c2; recip_rom[1019] = 20'h40241;
        recip_rom[1020] = 20'h401c1; recip_rom[1021] = 20'h40141; recip_rom[1022] = 20'h400c0; recip_rom[1023] = 20'h40040;
    end

    // table atan: atan u19f18, secant u19f18
    (* rom_style = "block" *)
    reg [37:0] atan_rom [0:1023];
    initial begin
        atan_rom[0] = 38'h0000a40000; atan_rom[1] = 38'h0001ec0000; atan_rom[2] = 38'h0003340001; atan_rom[3] = 38'h00047c0002;
        atan_rom[4] = 38'h0005bc0003; atan_rom[5] = 38'h0007040004; atan_rom[6] = 38'h00084c0005; atan_rom[7] = 38'h00098c0007;
        atan_rom[8] = 38'h000ad40009; atan_rom[9] = 38'h000c1c000b; atan_rom[10] = 38'h000d64000e; atan_rom[11] = 38'h000ea40011;
        atan_rom[12] = 38'h000fec0014; atan_rom[13] = 38'h0011340017; atan_rom[14] = 38'h00127c001a; atan_rom[15] = 38'h0013bc001e;
        atan_rom[16] = 38'h0015040022; atan_rom[17] = 38'h00164c0026; atan_rom[18] = 38'h001794002b; atan_rom[19] = 38'h0018d40030;
        atan_rom[20] = 38'h001a1c0035; atan_rom[21] = 38'h001b64003a; atan_rom[22] = 38'h001cac003f; atan_rom[23] = 38'h001dec0045;
        atan_rom[24] = 38'h001f34004b; atan_rom[25] = 38'h00207c0051; atan_rom[26] = 38'h0021bc0058; atan_rom[27] = 38'h002304005f;
        atan_rom[28] = 38'h00244c0066; atan_rom[29] = 38'h002594006d; atan_rom[30] = 38'h0026d40074; atan_rom[31] = 38'h00281c007c;
        atan_rom[32] = 38'h0029640084; atan_rom[33] = 38'h002aa4008c; atan_rom[34] = 38'h002bec0095; atan_rom[35] = 38'h002d34009d;
        atan_rom[36] = 38'h002e7400a6; atan_rom[37] = 38'h002fbc00b0; atan_rom[38] = 38'h00310400b9; atan_rom[39] = 38'h00324400c3;
        atan_rom[40] = 38'h00338c00cd; atan_rom[41] = 38'h0034d400d7; atan_rom[42] = 38'h00361c00e2; atan_rom[43] = 38'h00375c00ec;
        atan_rom[44] = 38'h0038a400f7; atan_rom[45] = 38'h0039ec0103; atan_rom[46] = 38'h003b2c010e; atan_rom[47] = 38'h003c74011a;
        atan_rom[48] = 38'h003dbc0126; atan_rom[49] = 38'h003efc0132; atan_rom[50] = 38'h004044013f; atan_rom[51] = 38'h004184014b;
        atan_rom[52] = 38'h0042cc0158; atan_rom[53] = 38'h0044140166; atan_rom[54] = 38'h0045540173; atan_rom[55] = 38'h00469c0181;
        atan_rom[56] = 38'h0047e4018f; atan_rom[57] = 38'h004924019d; atan_rom[58] = 38'h004a6c01ab; atan_rom[59] = 38'h004bac01ba;
        atan_rom[60] = 38'h004cf401c9; atan_rom[61] = 38'h004e3c01d8; atan_rom[62] = 38'h004f7c01e8; atan_rom[63] = 38'h0050c401f8;
        atan_rom[64] = 38'h0052040208; atan_rom[65] = 38'h00534c0218; atan_rom[66] = 38'h0054940228; atan_rom[67] = 38'h0055d40239;
        atan_rom[68] = 38'h00571c024a; atan_rom[69] = 38'h00585c025b; atan_rom[70] = 38'h0059a4026d; atan_rom[71] = 38'h005ae4027e;
        atan_rom[72] = 38'h005c2c0290; atan_rom[73] = 38'h005d6c02a2; atan_rom[74] = 38'h005eb402b5; atan_rom[75] = 38'h005ffc02c8;
        atan_rom[76] = 38'h00613c02db; atan_rom[77] = 38'h00628402ee; atan_rom[78] = 38'h0063c40301; atan_rom[79] = 38'h00650c0315;
        atan_rom[80] = 38'h00664c0329; atan_rom[81] = 38'h006794033d; atan_rom[82] = 38'h0068d40351; atan_rom[83] = 38'h006a1c0366;
        atan_rom[84] = 38'h006b5c037b; atan_rom[85] = 38'h006c9c0390; atan_rom[86] = 38'h006de403a6; atan_rom[87] = 38'h006f2403bb;
        atan_rom[88] = 38'h00706c03d1; atan_rom[89] = 38'h0071ac03e7; atan_rom[90] = 38'h0072f403fe; atan_rom[91] = 38'h0074340414;
        atan_rom[92] = 38'h00757c042b; atan_rom[93] = 38'h0076bc0442; atan_rom[94] = 38'h0077fc045a; atan_rom[95] = 38'h0079440472;
        atan_rom[96] = 38'h007a840489; atan_rom[97] = 38'h007bc404a2; atan_rom[98] = 38'h007d0c04ba; atan_rom[99] = 38'h007e4c04d3;
        atan_rom[100] = 38'h007f9404eb; atan_rom[101] = 38'h0080d40505; atan_rom[102] = 38'h008214051e; atan_rom[103] = 38'h00835c0538;
        atan_rom[104] = 38'h00849c0551; atan_rom[105] = 38'h0085dc056c; atan_rom[106] = 38'h0087240586; atan_rom[107] = 38'h00886405a1;
        atan_rom[108] = 38'h0089a405bb; atan_rom[109] = 38'h008ae405d6; atan_rom[110] = 38'h008c2c05f2; atan_rom[111] = 38'h008d6c060d;
        atan_rom[112] = 38'h008eac0629; atan_rom[113] = 38'h008ff40645; atan_rom[114] = 38'h0091340662; atan_rom[115] = 38'h009274067e;
        atan_rom[116] = 38'h0093b4069b; atan_rom[117] = 38'h0094f406b8; atan_rom[118] = 38'h00963c06d5; atan_rom[119] = 38'h00977c06f3;
        atan_rom[120] = 38'h0098bc0711; atan_rom[121] = 38'h0099fc072f; atan_rom[122] = 38'h009b3c074d; atan_rom[123] = 38'h009c84076c;
        atan_rom[124] = 38'h009dc4078a; atan_rom[125] = 38'h009f0407a9; atan_rom[126] = 38'h00a04407c9; atan_rom[127] = 38'h00a18407e8;
        atan_rom[128] = 38'h00a2c40808; atan_rom[129] = 38'h00a4040828; atan_rom[130] = 38'h00a5440848; atan_rom[131] = 38'h00a68c0869;
        atan_rom[132] = 38'h00a7cc0889; atan_rom[133] = 38'h00a90c08aa; atan_rom[134] = 38'h00aa4c08cc; atan_rom[135] = 38'h00ab8c08ed;
        atan_rom[136] = 38'h00accc090f; atan_rom[137] = 38'h00ae0c0931; atan_rom[138] = 38'h00af4c0953; atan_rom[139] = 38'h00b08c0975;
        atan_rom[140] = 38'h00b1cc0998; atan_rom[141] = 38'h00b30c09bb; atan_rom[142] = 38'h00b44c09de; atan_rom[143] = 38'h00b58c0a01;
        atan_rom[144] = 38'h00b6cc0a25; atan_rom[145] = 38'h00b80c0a49; atan_rom[146] = 38'h00b94c0a6d; atan_rom[147] = 38'h00ba8c0a92;
        atan_rom[148] = 38'h00bbc40ab6; atan_rom[149] = 38'h00bd040adb; atan_rom[150] = 38'h00be440b00; atan_rom[151] = 38'h00bf840b25;
        atan_rom[152] = 38'h00c0c40b4b; atan_rom[153] = 38'h00c2040b71; atan_rom[154] = 38'h00c3440b97; atan_rom[155] = 38'h00c4840bbd;
        atan_rom[156] = 38'h00c5bc0be4; atan_rom[157] = 38'h00c6fc0c0b; atan_rom[158] = 38'h00c83c0c32; atan_rom[159] = 38'h00c97c0c59;
        atan_rom[160] = 38'h00cabc0c80; atan_rom[161] = 38'h00cbf40ca8; atan_rom[162] = 38'h00cd340cd0; atan_rom[163] = 38'h00ce740cf8;
        atan_rom[164] = 38'h00cfac0d21; atan_rom[165] = 38'h00d0ec0d4a; atan_rom[166] = 38'h00d22c0d73; atan_rom[167] = 38'h00d36c0d9c;
        atan_rom[168] = 38'h00d4a40dc5; atan_rom[169] = 38'h00d5e40def; atan_rom[170] = 38'h00d7240e19; atan_rom[171] = 38'h00d85c0e43;
        atan_rom[172] = 38'h00d99c0e6d; atan_rom[173] = 38'h00dad40e98; atan_rom[174] = 38'h00dc140ec3; atan_rom[175] = 38'h00dd540eee;
        atan_rom[176] = 38'h00de8c0f19; atan_rom[177] = 38'h00dfcc0f45; atan_rom[178] = 38'h00e1040f71; atan_rom[179] = 38'h00e2440f9d;
        atan_rom[180] = 38'h00e37c0fc9; atan_rom[181] = 38'h00e4bc0ff6; atan_rom[182] = 38'h00e5f41023; atan_rom[183] = 38'h00e7341050;
        atan_rom[184] = 38'h00e86c107d; atan_rom[185] = 38'h00e9ac10ab; atan_rom[186] = 38'h00eae410d8; atan_rom[187] = 38'h00ec241106;
        atan_rom[188] = 38'h00ed5c1134; atan_rom[189] = 38'h00ee941163; atan_rom[190] = 38'h00efd41192; atan_rom[191] = 38'h00f10c11c1;
        atan_rom[192] = 38'h00f24c11f0; atan_rom[193] = 38'h00f384121f; atan_rom[194] = 38'h00f4bc124f; atan_rom[195] = 38'h00f5fc127f;
        atan_rom[196] = 38'h00f73412af; atan_rom[197] = 38'h00f86c12df; atan_rom[198] = 38'h00f9a41310; atan_rom[199] = 38'h00fae41341;
        atan_rom[200] = 38'h00fc1c1372; atan_rom[201] = 38'h00fd5413a3; atan_rom[202] = 38'h00fe8c13d5; atan_rom[203] = 38'h00ffcc1406;
        atan_rom[204] = 38'h0101041438; atan_rom[205] = 38'h01023c146b; atan_rom[206] = 38'h010374149d; atan_rom[207] = 38'h0104ac14d0;
        atan_rom[208] = 38'h0105e41503; atan_rom[209] = 38'h0107241536; atan_rom[210] = 38'h01085c1569; atan_rom[211] = 38'h010994159d;
        atan_rom[212] = 38'h010acc15d1; atan_rom[213] = 38'h010c041605; atan_rom[214] = 38'h010d3c1639; atan_rom[215] = 38'h010e74166e;
        atan_rom[216] = 38'h010fac16a3; atan_rom[217] = 38'h0110e416d8; atan_rom[218] = 38'h01121c170d; atan_rom[219] = 38'h0113541743;
        atan_rom[220] = 38'h01148c1779; atan_rom[221] = 38'h0115c417af; atan_rom[222] = 38'h0116fc17e5; atan_rom[223] = 38'h011834181b;
        atan_rom[224] = 38'h0119641852; atan_rom[225] = 38'h011a9c1889; atan_rom[226] = 38'h011bd418c0; atan_rom[227] = 38'h011d0c18f8;
        atan_rom[228] = 38'h011e44192f; atan_rom[229] = 38'h011f7c1967; atan_rom[230] = 38'h0120ac199f; atan_rom[231] = 38'h0121e419d7;
        atan_rom[232] = 38'h01231c1a10; atan_rom[233] = 38'h0124541a49; atan_rom[234] = 38'h0125841a82; atan_rom[235] = 38'h0126bc1abb;
        atan_rom[236] = 38'h0127f41af5; atan_rom[237] = 38'h0129241b2e; atan_rom[238] = 38'h012a5c1b68; atan_rom[239] = 38'h012b941ba2;
        atan_rom[240] = 38'h012cc41bdd; atan_rom[241] = 38'h012dfc1c18; atan_rom[242] = 38'h012f341c52; atan_rom[243] = 38'h0130641c8e;
        atan_rom[244] = 38'h01319c1cc9; atan_rom[245] = 38'h0132cc1d04; atan_rom[246] = 38'h0134041d40; atan_rom[247] = 38'h0135341d7c;
        atan_rom[248] = 38'h01366c1db9; atan_rom[249] = 38'h01379c1df5; atan_rom[250] = 38'h0138d41e32; atan_rom[251] = 38'h013a041e6f;
        atan_rom[252] = 38'h013b341eac; atan_rom[253] = 38'h013c6c1ee9; atan_rom[254] = 38'h013d9c1f27; atan_rom[255] = 38'h013ed41f65;
        atan_rom[256] = 38'h0140041fa3; atan_rom[257] = 38'h0141341fe1; atan_rom[258] = 38'h01426c2020; atan_rom[259] = 38'h01439c205e;
        atan_rom[260] = 38'h0144cc209d; atan_rom[261] = 38'h0145fc20dd; atan_rom[262] = 38'h014734211c; atan_rom[263] = 38'h014864215c;
        atan_rom[264] = 38'h014994219c; atan_rom[265] = 38'h014ac421dc; atan_rom[266] = 38'h014bf4221c; atan_rom[267] = 38'h014d2c225d;
        atan_rom[268] = 38'h014e5c229e; atan_rom[269] = 38'h014f8c22df; atan_rom[270] = 38'h0150bc2320; atan_rom[271] = 38'h0151ec2361;
        atan_rom[272] = 38'h01531c23a3; atan_rom[273] = 38'h01544c23e5; atan_rom[274] = 38'h01557c2427; atan_rom[275] = 38'h0156ac246a;
        atan_rom[276] = 38'h0157dc24ac; atan_rom[277] = 38'h01590c24ef; atan_rom[278] = 38'h015a3c2532; atan_rom[279] = 38'h015b6c2576;
        atan_rom[280] = 38'h015c9c25b9; atan_rom[281] = 38'h015dcc25fd; atan_rom[282] = 38'h015efc2641; atan_rom[283] = 38'h01602c2685;
        atan_rom[284] = 38'h01615426c9; atan_rom[285] = 38'h016284270e; atan_rom[286] = 38'h0163b42753; atan_rom[287] = 38'h0164e42798;
        atan_rom[288] = 38'h01660c27dd; atan_rom[289] = 38'h01673c2823; atan_rom[290] = 38'h01686c2869; atan_rom[291] = 38'h01699c28af;
        atan_rom[292] = 38'h016ac428f5; atan_rom[293] = 38'h016bf4293b; atan_rom[294] = 38'h016d242982; atan_rom[295] = 38'h016e4c29c9;
        atan_rom[296] = 38'h016f7c2a10; atan_rom[297] = 38'h0170a42a57; atan_rom[298] = 38'h0171d42a9f; atan_rom[299] = 38'h0173042ae6;
        atan_rom[300] = 38'h01742c2b2e; atan_rom[301] = 38'h01755c2b77; atan_rom[302] = 38'h0176842bbf; atan_rom[303] = 38'h0177b42c08;
        atan_rom[304] = 38'h0178dc2c50; atan_rom[305] = 38'h017a042c9a; atan_rom[306] = 38'h017b342ce3; atan_rom[307] = 38'h017c5c2d2c;
        atan_rom[308] = 38'h017d8c2d76; atan_rom[309] = 38'h017eb42dc0; atan_rom[310] = 38'h017fdc2e0a; atan_rom[311] = 38'h0181042e55;
        atan_rom[312] = 38'h0182342e9f; atan_rom[313] = 38'h01835c2eea; atan_rom[314] = 38'h0184842f35; atan_rom[315] = 38'h0185ac2f80;
        atan_rom[316] = 38'h0186dc2fcc; atan_rom[317] = 38'h0188043018; atan_rom[318] = 38'h01892c3063; atan_rom[319] = 38'h018a5430b0;
        atan_rom[320] = 38'h018b7c30fc; atan_rom[321] = 38'h018ca43149; atan_rom[322] = 38'h018dcc3195; atan_rom[323] = 38'h018efc31e2;
        atan_rom[324] = 38'h0190243230; atan_rom[325] = 38'h01914c327d; atan_rom[326] = 38'h01927432cb; atan_rom[327] = 38'h01939c3319;
        atan_rom[328] = 38'h0194c43367; atan_rom[329] = 38'h0195e433b5; atan_rom[330] = 38'h01970c3403; atan_rom[331] = 38'h0198343452;
        atan_rom[332] = 38'h01995c34a1; atan_rom[333] = 38'h019a8434f0; atan_rom[334] = 38'h019bac3540; atan_rom[335] = 38'h019cd4358f;
        atan_rom[336] = 38'h019df435df; atan_rom[337] = 38'h019f1c362f; atan_rom[338] = 38'h01a044367f; atan_rom[339] = 38'h01a16c36d0;
        atan_rom[340] = 38'h01a28c3721; atan_rom[341] = 38'h01a3b43771; atan_rom[342] = 38'h01a4dc37c2; atan_rom[343] = 38'h01a5fc3814;
        atan_rom[344] = 38'h01a7243865; atan_rom[345] = 38'h01a84438b7; atan_rom[346] = 38'h01a96c3909; atan_rom[347] = 38'h01aa94395b;
        atan_rom[348] = 38'h01abb439ae; atan_rom[349] = 38'h01acdc3a00; atan_rom[350] = 38'h01adfc3a53; atan_rom[351] = 38'h01af243aa6;
        atan_rom[352] = 38'h01b0443af9; atan_rom[353] = 38'h01b1643b4d; atan_rom[354] = 38'h01b28c3ba0; atan_rom[355] = 38'h01b3ac3bf4;
        atan_rom[356] = 38'h01b4d43c48; atan_rom[357] = 38'h01b5f43c9c; atan_rom[358] = 38'h01b7143cf1; atan_rom[359] = 38'h01b8343d46;
        atan_rom[360] = 38'h01b95c3d9b; atan_rom[361] = 38'h01ba7c3df0; atan_rom[362] = 38'h01bb9c3e45; atan_rom[363] = 38'h01bcbc3e9a;
        atan_rom[364] = 38'h01bde43ef0; atan_rom[365] = 38'h01bf043f46; atan_rom[366] = 38'h01c0243f9c; atan_rom[367] = 38'h01c1443ff3;
        atan_rom[368] = 38'h01c2644049; atan_rom[369] = 38'h01c38440a0; atan_rom[370] = 38'h01c4a440f7; atan_rom[371] = 38'h01c5c4414e;
        atan_rom[372] = 38'h01c6e441a6; atan_rom[373] = 38'h01c80441fd; atan_rom[374] = 38'h01c9244255; atan_rom[375] = 38'h01ca4442ad;
        atan_rom[376] = 38'h01cb644305; atan_rom[377] = 38'h01cc84435e; atan_rom[378] = 38'h01cda443b6; atan_rom[379] = 38'h01cebc440f;
        atan_rom[380] = 38'h01cfdc4468; atan_rom[381] = 38'h01d0fc44c2; atan_rom[382] = 38'h01d21c451b; atan_rom[383] = 38'h01d33c4575;
        atan_rom[384] = 38'h01d45445cf; atan_rom[385] = 38'h01d5744629; atan_rom[386] = 38'h01d6944683; atan_rom[387] = 38'h01d7ac46de;
        atan_rom[388] = 38'h01d8cc4738; atan_rom[389] = 38'h01d9e44793; atan_rom[390] = 38'h01db0447ee; atan_rom[391] = 38'h01dc24484a;
        atan_rom[392] = 38'h01dd3c48a5; atan_rom[393] = 38'h01de5c4901; atan_rom[394] = 38'h01df74495d; atan_rom[395] = 38'h01e09449b9;
        atan_rom[396] = 38'h01e1ac4a15; atan_rom[397] = 38'h01e2cc4a72; atan_rom[398] = 38'h01e3e44acf; atan_rom[399] = 38'h01e4fc4b2c;
        atan_rom[400] = 38'h01e61c4b89; atan_rom[401] = 38'h01e7344be6; atan_rom[402] = 38'h01e84c4c44; atan_rom[403] = 38'h01e96c4ca1;
        atan_rom[404] = 38'h01ea844cff; atan_rom[405] = 38'h01eb9c4d5d; atan_rom[406] = 38'h01ecb44dbc; atan_rom[407] = 38'h01edcc4e1a;
        atan_rom[408] = 38'h01eeec4e79; atan_rom[409] = 38'h01f0044ed8; atan_rom[410] = 38'h01f11c4f37; atan_rom[411] = 38'h01f2344f97;
        atan_rom[412] = 38'h01f34c4ff6; atan_rom[413] = 38'h01f4645056; atan_rom[414] = 38'h01f57c50b6; atan_rom[415] = 38'h01f6945116;
        atan_rom[416] = 38'h01f7ac5176; atan_rom[417] = 38'h01f8c451d7; atan_rom[418] = 38'h01f9dc5238; atan_rom[419] = 38'h01faf45299;
        atan_rom[420] = 38'h01fc0c52fa; atan_rom[421] = 38'h01fd24535b; atan_rom[422] = 38'h01fe3453bd; atan_rom[423] = 38'h01ff4c541e;
        atan_rom[424] = 38'h0200645480; atan_rom[425] = 38'h02017c54e2; atan_rom[426] = 38'h02028c5545; atan_rom[427] = 38'h0203a455a7;
        atan_rom[428] = 38'h0204bc560a; atan_rom[429] = 38'h0205cc566d; atan_rom[430] = 38'h0206e456d0; atan_rom[431] = 38'h0207fc5733;
        atan_rom[432] = 38'h02090c5797; atan_rom[433] = 38'h020a2457fb; atan_rom[434] = 38'h020b34585e; atan_rom[435] = 38'h020c4c58c3;
        atan_rom[436] = 38'h020d5c5927; atan_rom[437] = 38'h020e74598b; atan_rom[438] = 38'h020f8459f0; atan_rom[439] = 38'h02109c5a55;
        atan_rom[440] = 38'h0211ac5aba; atan_rom[441] = 38'h0212c45b1f; atan_rom[442] = 38'h0213d45b85; atan_rom[443] = 38'h0214e45bea;
        atan_rom[444] = 38'h0215f45c50; atan_rom[445] = 38'h02170c5cb6; atan_rom[446] = 38'h02181c5d1c; atan_rom[447] = 38'h02192c5d83;
        atan_rom[448] = 38'h021a3c5de9; atan_rom[449] = 38'h021b545e50; atan_rom[450] = 38'h021c645eb7; atan_rom[451] = 38'h021d745f1e;
        atan_rom[452] = 38'h021e845f86; atan_rom[453] = 38'h021f945fed; atan_rom[454] = 38'h0220a46055; atan_rom[455] = 38'h0221b460bd;
        atan_rom[456] = 38'h0222c46125; atan_rom[457] = 38'h0223d4618e; atan_rom[458] = 38'h0224e461f6; atan_rom[459] = 38'h0225f4625f;
        atan_rom[460] = 38'h02270462c8; atan_rom[461] = 38'h0228146331; atan_rom[462] = 38'h022924639a; atan_rom[463] = 38'h022a2c6403;
        atan_rom[464] = 38'h022b3c646d; atan_rom[465] = 38'h022c4c64d7; atan_rom[466] = 38'h022d5c6541; atan_rom[467] = 38'h022e6465ab;
        atan_rom[468] = 38'h022f746616; atan_rom[469] = 38'h0230846680; atan_rom[470] = 38'h02319466eb; atan_rom[471] = 38'h02329c6756;
        atan_rom[472] = 38'h0233ac67c1; atan_rom[473] = 38'h0234b4682d; atan_rom[474] = 38'h0235c46898; atan_rom[475] = 38'h0236cc6904;
        atan_rom[476] = 38'h0237dc6970; atan_rom[477] = 38'h0238e469dc; atan_rom[478] = 38'h0239f46a48; atan_rom[479] = 38'h023afc6ab5;
        atan_rom[480] = 38'h023c0c6b21; atan_rom[481] = 38'h023d146b8e; atan_rom[482] = 38'h023e1c6bfb; atan_rom[483] = 38'h023f2c6c68;
        atan_rom[484] = 38'h0240346cd6; atan_rom[485] = 38'h02413c6d43; atan_rom[486] = 38'h02424c6db1; atan_rom[487] = 38'h0243546e1f;
        atan_rom[488] = 38'h02445c6e8d; atan_rom[489] = 38'h0245646efb; atan_rom[490] = 38'h02466c6f6a; atan_rom[491] = 38'h0247746fd9;
        atan_rom[492] = 38'h0248847047; atan_rom[493] = 38'h02498c70b7; atan_rom[494] = 38'h024a947126; atan_rom[495] = 38'h024b9c7195;
        atan_rom[496] = 38'h024ca47205; atan_rom[497] = 38'h024dac7275; atan_rom[498] = 38'h024eb472e5; atan_rom[499] = 38'h024fbc7355;
        atan_rom[500] = 38'h0250bc73c5; atan_rom[501] = 38'h0251c47435; atan_rom[502] = 38'h0252cc74a6; atan_rom[503] = 38'h0253d47517;
        atan_rom[504] = 38'h0254dc7588; atan_rom[505] = 38'h0255e475f9; atan_rom[506] = 38'h0256e4766b; atan_rom[507] = 38'h0257ec76dc;
        atan_rom[508] = 38'h0258f4774e; atan_rom[509] = 38'h0259f477c0; atan_rom[510] = 38'h025afc7832; atan_rom[511] = 38'h025c0478a4;
        atan_rom[512] = 38'h025d047917; atan_rom[513] = 38'h025e0c798a; atan_rom[514] = 38'h025f0c79fc; atan_rom[515] = 38'h0260147a6f;
        atan_rom[516] = 38'h0261147ae3; atan_rom[517] = 38'h02621c7b56; atan_rom[518] = 38'h02631c7bca; atan_rom[519] = 38'h0264247c3d;
        atan_rom[520] = 38'h0265247cb1; atan_rom[521] = 38'h02662c7d25; atan_rom[522] = 38'h02672c7d9a; atan_rom[523] = 38'h02682c7e0e;
        atan_rom[524] = 38'h02692c7e83; atan_rom[525] = 38'h026a347ef7; atan_rom[526] = 38'h026b347f6c; atan_rom[527] = 38'h026c347fe2;
        atan_rom[528] = 38'h026d348057; atan_rom[529] = 38'h026e3c80cc; atan_rom[530] = 38'h026f3c8142; atan_rom[531] = 38'h02703c81b8;
        atan_rom[532] = 38'h02713c822e; atan_rom[533] = 38'h02723c82a4; atan_rom[534] = 38'h02733c831b; atan_rom[535] = 38'h02743c8391;
        atan_rom[536] = 38'h02753c8408; atan_rom[537] = 38'h02763c847f; atan_rom[538] = 38'h02773c84f6; atan_rom[539] = 38'h02783c856d;
        atan_rom[540] = 38'h02793c85e4; atan_rom[541] = 38'h027a34865c; atan_rom[542] = 38'h027b3486d4; atan_rom[543] = 38'h027c34874c;
        atan_rom[544] = 38'h027d3487c4; atan_rom[545] = 38'h027e34883c; atan_rom[546] = 38'h027f2c88b5; atan_rom[547] = 38'h02802c892d;
        atan_rom[548] = 38'h02812c89a6; atan_rom[549] = 38'h0282248a1f; atan_rom[550] = 38'h0283248a98; atan_rom[551] = 38'h0284248b11;
        atan_rom[552] = 38'h02851c8b8b; atan_rom[553] = 38'h02861c8c04; atan_rom[554] = 38'h0287148c7e; atan_rom[555] = 38'h0288148cf8;
        atan_rom[556] = 38'h02890c8d72; atan_rom[557] = 38'h028a0c8ded; atan_rom[558] = 38'h028b048e67; atan_rom[559] = 38'h028bfc8ee2;
        atan_rom[560] = 38'h028cfc8f5d; atan_rom[561] = 38'h028df48fd8; atan_rom[562] = 38'h028eec9053; atan_rom[563] = 38'h028fec90ce;
        atan_rom[564] = 38'h0290e4914a; atan_rom[565] = 38'h0291dc91c5; atan_rom[566] = 38'h0292d49241; atan_rom[567] = 38'h0293d492bd;
        atan_rom[568] = 38'h0294cc9339; atan_rom[569] = 38'h0295c493b6; atan_rom[570] = 38'h0296bc9432; atan_rom[571] = 38'h0297b494af;
        atan_rom[572] = 38'h0298ac952c; atan_rom[573] = 38'h0299a495a9; atan_rom[574] = 38'h029a9c9626; atan_rom[575] = 38'h029b9496a3;
        atan_rom[576] = 38'h029c8c9721; atan_rom[577] = 38'h029d84979e; atan_rom[578] = 38'h029e7c981c; atan_rom[579] = 38'h029f74989a;
        atan_rom[580] = 38'h02a06c9918; atan_rom[581] = 38'h02a15c9997; atan_rom[582] = 38'h02a2549a15; atan_rom[583] = 38'h02a34c9a94;
        atan_rom[584] = 38'h02a4449b13; atan_rom[585] = 38'h02a5349b92; atan_rom[586] = 38'h02a62c9c11; atan_rom[587] = 38'h02a7249c90;
        atan_rom[588] = 38'h02a8149d10; atan_rom[589] = 38'h02a90c9d8f; atan_rom[590] = 38'h02aa049e0f; atan_rom[591] = 38'h02aaf49e8f;
        atan_rom[592] = 38'h02abec9f0f; atan_rom[593] = 38'h02acdc9f90; atan_rom[594] = 38'h02add4a010; atan_rom[595] = 38'h02aec4a091;
        atan_rom[596] = 38'h02afbca111; atan_rom[597] = 38'h02b0aca192; atan_rom[598] = 38'h02b19ca213; atan_rom[599] = 38'h02b294a295;
        atan_rom[600] = 38'h02b384a316; atan_rom[601] = 38'h02b474a398; atan_rom[602] = 38'h02b56ca419; atan_rom[603] = 38'h02b65ca49b;
        atan_rom[604] = 38'h02b74ca51d; atan_rom[605] = 38'h02b83ca5a0; atan_rom[606] = 38'h02b934a622; atan_rom[607] = 38'h02ba24a6a5;
        atan_rom[608] = 38'h02bb14a727; atan_rom[609] = 38'h02bc04a7aa; atan_rom[610] = 38'h02bcf4a82d; atan_rom[611] = 38'h02bde4a8b0;
        atan_rom[612] = 38'h02bed4a934; atan_rom[613] = 38'h02bfc4a9b7; atan_rom[614] = 38'h02c0b4aa3b; atan_rom[615] = 38'h02c1a4aabf;
        atan_rom[616] = 38'h02c294ab43; atan_rom[617] = 38'h02c384abc7; atan_rom[618] = 38'h02c474ac4b; atan_rom[619] = 38'h02c564accf;
        atan_rom[620] = 38'h02c64cad54; atan_rom[621] = 38'h02c73cadd9; atan_rom[622] = 38'h02c82cae5e; atan_rom[623] = 38'h02c91caee3;
        atan_rom[624] = 38'h02ca04af68; atan_rom[625] = 38'h02caf4afed; atan_rom[626] = 38'h02cbe4b073; atan_rom[627] = 38'h02ccccb0f8;
        atan_rom[628] = 38'h02cdbcb17e; atan_rom[629] = 38'h02cea4b204; atan_rom[630] = 38'h02cf94b28a; atan_rom[631] = 38'h02d084b311;
        atan_rom[632] = 38'h02d16cb397; atan_rom[633] = 38'h02d25cb41e; atan_rom[634] = 38'h02d344b4a5; atan_rom[635] = 38'h02d42cb52b;
        atan_rom[636] = 38'h02d51cb5b3; atan_rom[637] = 38'h02d604b63a; atan_rom[638] = 38'h02d6f4b6c1; atan_rom[639] = 38'h02d7dcb749;
        atan_rom[640] = 38'h02d8c4b7d0; atan_rom[641] = 38'h02d9acb858; atan_rom[642] = 38'h02da9cb8e0; atan_rom[643] = 38'h02db84b968;
        atan_rom[644] = 38'h02dc6cb9f1; atan_rom[645] = 38'h02dd54ba79; atan_rom[646] = 38'h02de3cbb02; atan_rom[647] = 38'h02df2cbb8a;
        atan_rom[648] = 38'h02e014bc13; atan_rom[649] = 38'h02e0fcbc9c; atan_rom[650] = 38'h02e1e4bd25; atan_rom[651] = 38'h02e2ccbdaf;
        atan_rom[652] = 38'h02e3b4be38; atan_rom[653] = 38'h02e49cbec2; atan_rom[654] = 38'h02e584bf4c; atan_rom[655] = 38'h02e66cbfd6;
        atan_rom[656] = 38'h02e74cc060; atan_rom[657] = 38'h02e834c0ea; atan_rom[658] = 38'h02e91cc174; atan_rom[659] = 38'h02ea04c1ff;
        atan_rom[660] = 38'h02eaecc28a; atan_rom[661] = 38'h02ebd4c314; atan_rom[662] = 38'h02ecb4c39f; atan_rom[663] = 38'h02ed9cc42b;
        atan_rom[664] = 38'h02ee84c4b6; atan_rom[665] = 38'h02ef64c541; atan_rom[666] = 38'h02f04cc5cd; atan_rom[667] = 38'h02f134c659;
        atan_rom[668] = 38'h02f214c6e4; atan_rom[669] = 38'h02f2fcc770; atan_rom[670] = 38'h02f3dcc7fd; atan_rom[671] = 38'h02f4c4c889;
        atan_rom[672] = 38'h02f5a4c915; atan_rom[673] = 38'h02f68cc9a2; atan_rom[674] = 38'h02f76cca2f; atan_rom[675] = 38'h02f84ccabc;
        atan_rom[676] = 38'h02f934cb49; atan_rom[677] = 38'h02fa14cbd6; atan_rom[678] = 38'h02fafccc63; atan_rom[679] = 38'h02fbdcccf1;
        atan_rom[680] = 38'h02fcbccd7e; atan_rom[681] = 38'h02fd9cce0c; atan_rom[682] = 38'h02fe84ce9a; atan_rom[683] = 38'h02ff64cf28;
        atan_rom[684] = 38'h030044cfb6; atan_rom[685] = 38'h030124d045; atan_rom[686] = 38'h030204d0d3; atan_rom[687] = 38'h0302e4d162;
        atan_rom[688] = 38'h0303c4d1f0; atan_rom[689] = 38'h0304a4d27f; atan_rom[690] = 38'h030584d30e; atan_rom[691] = 38'h030664d39e;
        atan_rom[692] = 38'h030744d42d; atan_rom[693] = 38'h030824d4bc; atan_rom[694] = 38'h030904d54c; atan_rom[695] = 38'h0309e4d5dc;
        atan_rom[696] = 38'h030ac4d66c; atan_rom[697] = 38'h030ba4d6fc; atan_rom[698] = 38'h030c84d78c; atan_rom[699] = 38'h030d64d81c;
        atan_rom[700] = 38'h030e3cd8ad; atan_rom[701] = 38'h030f1cd93d; atan_rom[702] = 38'h030ffcd9ce; atan_rom[703] = 38'h0310d4da5f;
        atan_rom[704] = 38'h0311b4daf0; atan_rom[705] = 38'h031294db81; atan_rom[706] = 38'h03136cdc12; atan_rom[707] = 38'h03144cdca4;
        atan_rom[708] = 38'h03152cdd36; atan_rom[709] = 38'h031604ddc7; atan_rom[710] = 38'h0316e4de59; atan_rom[711] = 38'h0317bcdeeb;
        atan_rom[712] = 38'h03189cdf7d; atan_rom[713] = 38'h031974e010; atan_rom[714] = 38'h031a4ce0a2; atan_rom[715] = 38'h031b2ce135;
        atan_rom[716] = 38'h031c04e1c7; atan_rom[717] = 38'h031cdce25a; atan_rom[718] = 38'h031dbce2ed; atan_rom[719] = 38'h031e94e380;
        atan_rom[720] = 38'h031f6ce413; atan_rom[721] = 38'h03204ce4a7; atan_rom[722] = 38'h032124e53a; atan_rom[723] = 38'h0321fce5ce;
        atan_rom[724] = 38'h0322d4e662; atan_rom[725] = 38'h0323ace6f6; atan_rom[726] = 38'h032484e78a; atan_rom[727] = 38'h032564e81e;
        atan_rom[728] = 38'h03263ce8b2; atan_rom[729] = 38'h032714e947; atan_rom[730] = 38'h0327ece9db; atan_rom[731] = 38'h0328c4ea70;
        atan_rom[732] = 38'h03299ceb05; atan_rom[733] = 38'h032a74eb9a; atan_rom[734] = 38'h032b44ec2f; atan_rom[735] = 38'h032c1cecc4;
        atan_rom[736] = 38'h032cf4ed5a; atan_rom[737] = 38'h032dccedef; atan_rom[738] = 38'h032ea4ee85; atan_rom[739] = 38'h032f7cef1b;
        atan_rom[740] = 38'h03304cefb1; atan_rom[741] = 38'h033124f047; atan_rom[742] = 38'h0331fcf0dd; atan_rom[743] = 38'h0332d4f173;
        atan_rom[744] = 38'h0333a4f20a; atan_rom[745] = 38'h03347cf2a0; atan_rom[746] = 38'h03354cf337; atan_rom[747] = 38'h033624f3ce;
        atan_rom[748] = 38'h0336fcf465; atan_rom[749] = 38'h0337ccf4fc; atan_rom[750] = 38'h0338a4f593; atan_rom[751] = 38'h033974f62b;
        atan_rom[752] = 38'h033a4cf6c2; atan_rom[753] = 38'h033b1cf75a; atan_rom[754] = 38'h033bf4f7f2; atan_rom[755] = 38'h033cc4f88a;
        atan_rom[756] = 38'h033d94f922; atan_rom[757] = 38'h033e6cf9ba; atan_rom[758] = 38'h033f3cfa52; atan_rom[759] = 38'h03400cfaeb;
        atan_rom[760] = 38'h0340e4fb83; atan_rom[761] = 38'h0341b4fc1c; atan_rom[762] = 38'h034284fcb5; atan_rom[763] = 38'h034354fd4e;
        atan_rom[764] = 38'h034424fde7; atan_rom[765] = 38'h0344fcfe80; atan_rom[766] = 38'h0345ccff19; atan_rom[767] = 38'h03469cffb3;
        atan_rom[768] = 38'h03476d004d; atan_rom[769] = 38'h03483d00e6; atan_rom[770] = 38'h03490d0180; atan_rom[771] = 38'h0349dd021a;
        atan_rom[772] = 38'h034aad02b4; atan_rom[773] = 38'h034b7d034e; atan_rom[774] = 38'h034c4d03e9; atan_rom[775] = 38'h034d1d0483;
        atan_rom[776] = 38'h034ded051e; atan_rom[777] = 38'h034eb505b9; atan_rom[778] = 38'h034f850654; atan_rom[779] = 38'h03505506ef;
        atan_rom[780] = 38'h035125078a; atan_rom[781] = 38'h0351f50825; atan_rom[782] = 38'h0352bd08c0; atan_rom[783] = 38'h03538d095c;
        atan_rom[784] = 38'h03545d09f7; atan_rom[785] = 38'h0355250a93; atan_rom[786] = 38'h0355f50b2f; atan_rom[787] = 38'h0356c50bcb;
        atan_rom[788] = 38'h03578d0c67; atan_rom[789] = 38'h03585d0d03; atan_rom[790] = 38'h0359250da0; atan_rom[791] = 38'h0359f50e3c;
        atan_rom[792] = 38'h035abd0ed9; atan_rom[793] = 38'h035b8d0f76; atan_rom[794] = 38'h035c551012; atan_rom[795] = 38'h035d2510af;
        atan_rom[796] = 38'h035ded114d; atan_rom[797] = 38'h035eb511ea; atan_rom[798] = 38'h035f851287; atan_rom[799] = 38'h03604d1325;
        atan_rom[800] = 38'h03611513c2; atan_rom[801] = 38'h0361e51460; atan_rom[802] = 38'h0362ad14fe; atan_rom[803] = 38'h036375159c;
        atan_rom[804] = 38'h03643d163a; atan_rom[805] = 38'h03650d16d8; atan_rom[806] = 38'h0365d51776; atan_rom[807] = 38'h03669d1815;
        atan_rom[808] = 38'h03676518b4; atan_rom[809] = 38'h03682d1952; atan_rom[810] = 38'h0368f519f1; atan_rom[811] = 38'h0369bd1a90;
        atan_rom[812] = 38'h036a851b2f; atan_rom[813] = 38'h036b4d1bce; atan_rom[814] = 38'h036c151c6e; atan_rom[815] = 38'h036cdd1d0d;
        atan_rom[816] = 38'h036da51dac; atan_rom[817] = 38'h036e6d1e4c; atan_rom[818] = 38'h036f351eec; atan_rom[819] = 38'h036ffd1f8c;
        atan_rom[820] = 38'h0370bd202c; atan_rom[821] = 38'h03718520cc; atan_rom[822] = 38'h03724d216c; atan_rom[823] = 38'h037315220d;
        atan_rom[824] = 38'h0373dd22ad; atan_rom[825] = 38'h03749d234e; atan_rom[826] = 38'h03756523ee; atan_rom[827] = 38'h03762d248f;
        atan_rom[828] = 38'h0376ed2530; atan_rom[829] = 38'h0377b525d1; atan_rom[830] = 38'h0378752672; atan_rom[831] = 38'h03793d2714;
        atan_rom[832] = 38'h0379fd27b5; atan_rom[833] = 38'h037ac52857; atan_rom[834] = 38'h037b8d28f8; atan_rom[835] = 38'h037c4d299a;
        atan_rom[836] = 38'h037d0d2a3c; atan_rom[837] = 38'h037dd52ade; atan_rom[838] = 38'h037e952b80; atan_rom[839] = 38'h037f5d2c23;
        atan_rom[840] = 38'h03801d2cc5; atan_rom[841] = 38'h0380dd2d67; atan_rom[842] = 38'h0381a52e0a; atan_rom[843] = 38'h0382652ead;
        atan_rom[844] = 38'h0383252f4f; atan_rom[845] = 38'h0383e52ff2; atan_rom[846] = 38'h0384ad3095; atan_rom[847] = 38'h03856d3139;
        atan_rom[848] = 38'h03862d31dc; atan_rom[849] = 38'h0386ed327f; atan_rom[850] = 38'h0387ad3323; atan_rom[851] = 38'h03886d33c6;
        atan_rom[852] = 38'h03892d346a; atan_rom[853] = 38'h0389ed350e; atan_rom[854] = 38'h038ab535b2; atan_rom[855] = 38'h038b753656;
        atan_rom[856] = 38'h038c3536fa; atan_rom[857] = 38'h038ced379f; atan_rom[858] = 38'h038dad3843; atan_rom[859] = 38'h038e6d38e7;
        atan_rom[860] = 38'h038f2d398c; atan_rom[861] = 38'h038fed3a31; atan_rom[862] = 38'h0390ad3ad6; atan_rom[863] = 38'h03916d3b7b;
        atan_rom[864] = 38'h03922d3c20; atan_rom[865] = 38'h0392e53cc5; atan_rom[866] = 38'h0393a53d6a; atan_rom[867] = 38'h0394653e10;
        atan_rom[868] = 38'h0395253eb5; atan_rom[869] = 38'h0395dd3f5b; atan_rom[870] = 38'h03969d4001; atan_rom[871] = 38'h03975d40a7;
        atan_rom[872] = 38'h039815414d; atan_rom[873] = 38'h0398d541f3; atan_rom[874] = 38'h03998d4299; atan_rom[875] = 38'h039a4d433f;
        atan_rom[876] = 38'h039b0543e6; atan_rom[877] = 38'h039bc5448c; atan_rom[878] = 38'h039c7d4533; atan_rom[879] = 38'h039d3d45d9;
        atan_rom[880] = 38'h039df54680; atan_rom[881] = 38'h039eb54727; atan_rom[882] = 38'h039f6d47ce; atan_rom[883] = 38'h03a0254875;
        atan_rom[884] = 38'h03a0e5491d; atan_rom[885] = 38'h03a19d49c4; atan_rom[886] = 38'h03a2554a6c; atan_rom[887] = 38'h03a3154b13;
        atan_rom[888] = 38'h03a3cd4bbb; atan_rom[889] = 38'h03a4854c63; atan_rom[890] = 38'h03a53d4d0b; atan_rom[891] = 38'h03a5fd4db3;
        atan_rom[892] = 38'h03a6b54e5b; atan_rom[893] = 38'h03a76d4f03; atan_rom[894] = 38'h03a8254fac; atan_rom[895] = 38'h03a8dd5054;
        atan_rom[896] = 38'h03a99550fd; atan_rom[897] = 38'h03aa4d51a5; atan_rom[898] = 38'h03ab05524e; atan_rom[899] = 38'h03abbd52f7;
        atan_rom[900] = 38'h03ac7553a0; atan_rom[901] = 38'h03ad2d5449; atan_rom[902] = 38'h03ade554f2; atan_rom[903] = 38'h03ae9d559c;
        atan_rom[904] = 38'h03af555645; atan_rom[905] = 38'h03b00d56ef; atan_rom[906] = 38'h03b0c55798; atan_rom[907] = 38'h03b17d5842;
        atan_rom[908] = 38'h03b22d58ec; atan_rom[909] = 38'h03b2e55996; atan_rom[910] = 38'h03b39d5a40; atan_rom[911] = 38'h03b4555aea;
        atan_rom[912] = 38'h03b5055b94; atan_rom[913] = 38'h03b5bd5c3f; atan_rom[914] = 38'h03b6755ce9; atan_rom[915] = 38'h03b7255d94;
        atan_rom[916] = 38'h03b7dd5e3e; atan_rom[917] = 38'h03b8955ee9; atan_rom[918] = 38'h03b9455f94; atan_rom[919] = 38'h03b9fd603f;
        atan_rom[920] = 38'h03baad60ea; atan_rom[921] = 38'h03bb656195; atan_rom[922] = 38'h03bc156241; atan_rom[923] = 38'h03bccd62ec;
        atan_rom[924] = 38'h03bd7d6397; atan_rom[925] = 38'h03be356443; atan_rom[926] = 38'h03bee564ef; atan_rom[927] = 38'h03bf9d659b;
        atan_rom[928] = 38'h03c04d6646; atan_rom[929] = 38'h03c0fd66f2; atan_rom[930] = 38'h03c1b5679f; atan_rom[931] = 38'h03c265684b;
        atan_rom[932] = 38'h03c31568f7; atan_rom[933] = 38'h03c3c569a4; atan_rom[934] = 38'h03c47d6a50; atan_rom[935] = 38'h03c52d6afd;
        atan_rom[936] = 38'h03c5dd6ba9; atan_rom[937] = 38'h03c68d6c56; atan_rom[938] = 38'h03c73d6d03; atan_rom[939] = 38'h03c7f56db0;
        atan_rom[940] = 38'h03c8a56e5d; atan_rom[941] = 38'h03c9556f0a; atan_rom[942] = 38'h03ca056fb8; atan_rom[943] = 38'h03cab57065;
        atan_rom[944] = 38'h03cb657113; atan_rom[945] = 38'h03cc1571c0; atan_rom[946] = 38'h03ccc5726e; atan_rom[947] = 38'h03cd75731c;
        atan_rom[948] = 38'h03ce2573ca; atan_rom[949] = 38'h03ced57478; atan_rom[950] = 38'h03cf857526; atan_rom[951] = 38'h03d02d75d4;
        atan_rom[952] = 38'h03d0dd7682; atan_rom[953] = 38'h03d18d7731; atan_rom[954] = 38'h03d23d77df; atan_rom[955] = 38'h03d2ed788e;
        atan_rom[956] = 38'h03d39d793d; atan_rom[957] = 38'h03d44579eb; atan_rom[958] = 38'h03d4f57a9a; atan_rom[959] = 38'h03d5a57b49;
        atan_rom[960] = 38'h03d64d7bf8; atan_rom[961] = 38'h03d6fd7ca8; atan_rom[962] = 38'h03d7ad7d57; atan_rom[963] = 38'h03d8557e06;
        atan_rom[964] = 38'h03d9057eb6; atan_rom[965] = 38'h03d9b57f65; atan_rom[966] = 38'h03da5d8015; atan_rom[967] = 38'h03db0d80c5;
        atan_rom[968] = 38'h03dbb58175; atan_rom[969] = 38'h03dc658225; atan_rom[970] = 38'h03dd0d82d5; atan_rom[971] = 38'h03ddbd8385;
        atan_rom[972] = 38'h03de658435; atan_rom[973] = 38'h03df0d84e5; atan_rom[974] = 38'h03dfbd8596; atan_rom[975] = 38'h03e0658646;
        atan_rom[976] = 38'h03e11586f7; atan_rom[977] = 38'h03e1bd87a8; atan_rom[978] = 38'h03e2658858; atan_rom[979] = 38'h03e30d8909;
        atan_rom[980] = 38'h03e3bd89ba; atan_rom[981] = 38'h03e4658a6b; atan_rom[982] = 38'h03e50d8b1d; atan_rom[983] = 38'h03e5b58bce;
        atan_rom[984] = 38'h03e6658c7f; atan_rom[985] = 38'h03e70d8d31; atan_rom[986] = 38'h03e7b58de2; atan_rom[987] = 38'h03e85d8e94;
        atan_rom[988] = 38'h03e9058f46; atan_rom[989] = 38'h03e9ad8ff8; atan_rom[990] = 38'h03ea5590aa; atan_rom[991] = 38'h03eafd915c;
        atan_rom[992] = 38'h03eba5920e; atan_rom[993] = 38'h03ec4d92c0; atan_rom[994] = 38'h03ecf59372; atan_rom[995] = 38'h03ed9d9425;
        atan_rom[996] = 38'h03ee4594d7; atan_rom[997] = 38'h03eeed958a; atan_rom[998] = 38'h03ef95963c; atan_rom[999] = 38'h03f03d96ef;
        atan_rom[1000] = 38'h03f0e597a2; atan_rom[1001] = 38'h03f18d9855; atan_rom[1002] = 38'h03f22d9908; atan_rom[1003] = 38'h03f2d599bb;
        atan_rom[1004] = 38'h03f37d9a6e; atan_rom[1005] = 38'h03f4259b22; atan_rom[1006] = 38'h03f4c59bd5; atan_rom[1007] = 38'h03f56d9c89;
        atan_rom[1008] = 38'h03f6159d3c; atan_rom[1009] = 38'h03f6b59df0; atan_rom[1010] = 38'h03f75d9ea4; atan_rom[1011] = 38'h03f8059f57;
        atan_rom[1012] = 38'h03f8a5a00b; atan_rom[1013] = 38'h03f94da0bf; atan_rom[1014] = 38'h03f9f5a174; atan_rom[1015] = 38'h03fa95a228;
        atan_rom[1016] = 38'h03fb3da2dc; atan_rom[1017] = 38'h03fbdda391; atan_rom[1018] = 38'h03fc85a445; atan_rom[1019] = 38'h03fd25a4fa;
        atan_rom[1020] = 38'h03fdcda5ae; atan_rom[1021] = 38'h03fe6da663; atan_rom[1022] = 38'h03ff0da718; atan_rom[1023] = 38'h03ffb5a7cd;
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
    wire [0:-18] azimuth_n83 = 19'h10000; // u19f18
    wire [0:-18] azimuth_n87 = 19'h20000; // u19f18

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
    wire [1:-18] azimuth_n63_neg = -x;
    wire [1:-18] azimuth_n63 = x[1] ? azimuth_n63_neg : x; // u20f18
    wire [1:-18] azimuth_n64_neg = -y;
    wire [1:-18] azimuth_n64 = y[1] ? azimuth_n64_neg : y; // u20f18
    wire azimuth_n86 = x[1]; // u1f0
    wire azimuth_n90 = y[1]; // u1f0
    // polar_angle
    wire [1:-18] polar_angle_n97_neg = -z;
    wire [1:-18] polar_angle_n97 = z[1] ? polar_angle_n97_neg : z; // u20f18
    wire polar_angle_n118 = z[1]; // u1f0

    reg [1:-18] azimuth_n63_s3; // u20f18
    reg [1:-18] azimuth_n64_s3; // u20f18
    reg azimuth_n86_s3; // u1f0
    reg azimuth_n90_s3; // u1f0
    reg [1:-18] polar_angle_n97_s3; // u20f18
    reg polar_angle_n118_s3; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n63_s3 <= azimuth_n63;
            azimuth_n64_s3 <= azimuth_n64;
            azimuth_n86_s3 <= azimuth_n86;
            azimuth_n90_s3 <= azimuth_n90;
            polar_angle_n97_s3 <= polar_angle_n97;
            polar_angle_n118_s3 <= polar_angle_n118;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // azimuth
    wire azimuth_n65 = azimuth_n63_s3 < azimuth_n64_s3; // u1f0
    wire [1:-18] azimuth_n66 = azimuth_n65 ? azimuth_n64_s3 : azimuth_n63_s3; // u20f18
    wire [1:-18] azimuth_n67 = azimuth_n65 ? azimuth_n63_s3 : azimuth_n64_s3; // u20f18
    wire [31:0] azimuth_n68_padded = {azimuth_n66, 12'hfff};
    wire azimuth_n68_skip16 = azimuth_n68_padded[31:16] == 16'h0;
    wire [15:0] azimuth_n68_part16 = azimuth_n68_skip16 ? azimuth_n68_padded[15:0] : azimuth_n68_padded[31:16];
    wire azimuth_n68_skip8 = azimuth_n68_part16[15:8] == 8'h0;
    wire [7:0] azimuth_n68_part8 = azimuth_n68_skip8 ? azimuth_n68_part16[7:0] : azimuth_n68_part16[15:8];
    wire azimuth_n68_skip4 = azimuth_n68_part8[7:4] == 4'h0;
    wire [3:0] azimuth_n68_part4 = azimuth_n68_skip4 ? azimuth_n68_part8[3:0] : azimuth_n68_part8[7:4];
    wire azimuth_n68_skip2 = azimuth_n68_part4[3:2] == 2'h0;
    wire [1:0] azimuth_n68_part2 = azimuth_n68_skip2 ? azimuth_n68_part4[1:0] : azimuth_n68_part4[3:2];
    wire azimuth_n68_skip1 = azimuth_n68_part2[1] == 1'b0;
    wire [4:0] azimuth_n68 = {azimuth_n68_skip16, azimuth_n68_skip8, azimuth_n68_skip4, azimuth_n68_skip2, azimuth_n68_skip1}; // u5f0

    reg azimuth_n65_s4; // u1f0
    reg [1:-18] azimuth_n66_s4; // u20f18
    reg [1:-18] azimuth_n67_s4; // u20f18
    reg [4:0] azimuth_n68_s4; // u5f0
    reg azimuth_n86_s4; // u1f0
    reg azimuth_n90_s4; // u1f0
    reg [1:-18] polar_angle_n97_s4; // u20f18
    reg polar_angle_n118_s4; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n65_s4 <= azimuth_n65;
            azimuth_n66_s4 <= azimuth_n66;
            azimuth_n67_s4 <= azimuth_n67;
            azimuth_n68_s4 <= azimuth_n68;
            azimuth_n86_s4 <= azimuth_n86_s3;
            azimuth_n90_s4 <= azimuth_n90_s3;
            polar_angle_n97_s4 <= polar_angle_n97_s3;
            polar_angle_n118_s4 <= polar_angle_n118_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // azimuth
    wire azimuth_n69_past = 5'h14 < azimuth_n68_s4;
    wire [4:0] azimuth_n69_count = azimuth_n69_past ? 5'h14 : azimuth_n68_s4;
    wire [21:-18] azimuth_n69 = {20'h0, azimuth_n66_s4} << azimuth_n69_count; // u40f18
    wire [19:0] azimuth_n70 = azimuth_n69[1:-18]; // u20f0
    wire azimuth_n71_past = 5'h14 < azimuth_n68_s4;
    wire [4:0] azimuth_n71_count = azimuth_n71_past ? 5'h14 : azimuth_n68_s4;
    wire [21:-18] azimuth_n71 = {20'h0, azimuth_n67_s4} << azimuth_n71_count; // u40f18
    wire [19:0] azimuth_n72 = azimuth_n71[1:-18]; // u20f0
    wire [18:0] azimuth_n73 = azimuth_n70[18:0]; // u19f0
    wire [-2:-20] azimuth_n74 = azimuth_n73; // u19f20
    // azimuth.recip
    wire [9:0] azimuth_recip_n75 = azimuth_n74[-2:-11]; // u10f0
    // azimuth
    wire [-1:-20] azimuth_n77 = azimuth_n72; // u20f20

    reg azimuth_n65_s5; // u1f0
    reg [1:-18] azimuth_n66_s5; // u20f18
    reg [19:0] recip_row;
    reg [-1:-20] azimuth_n77_s5; // u20f20
    reg azimuth_n86_s5; // u1f0
    reg azimuth_n90_s5; // u1f0
    reg [1:-18] polar_angle_n97_s5; // u20f18
    reg polar_angle_n118_s5; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n65_s5 <= azimuth_n65_s4;
            azimuth_n66_s5 <= azimuth_n66_s4;
            recip_row <= recip_rom[azimuth_recip_n75];
            azimuth_n77_s5 <= azimuth_n77;
            azimuth_n86_s5 <= azimuth_n86_s4;
            azimuth_n90_s5 <= azimuth_n90_s4;
            polar_angle_n97_s5 <= polar_angle_n97_s4;
            polar_angle_n118_s5 <= polar_angle_n118_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // azimuth.recip
    wire [1:-18] azimuth_recip_n76 = recip_row; // u20f18

    reg azimuth_n65_s6; // u1f0
    reg [1:-18] azimuth_n66_s6; // u20f18
    reg [1:-18] azimuth_recip_n76_s6; // u20f18
    reg [-1:-20] azimuth_n77_s6; // u20f20
    reg azimuth_n86_s6; // u1f0
    reg azimuth_n90_s6; // u1f0
    reg [1:-18] polar_angle_n97_s6; // u20f18
    reg polar_angle_n118_s6; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n65_s6 <= azimuth_n65_s5;
            azimuth_n66_s6 <= azimuth_n66_s5;
            azimuth_recip_n76_s6 <= azimuth_recip_n76;
            azimuth_n77_s6 <= azimuth_n77_s5;
            azimuth_n86_s6 <= azimuth_n86_s5;
            azimuth_n90_s6 <= azimuth_n90_s5;
            polar_angle_n97_s6 <= polar_angle_n97_s5;
            polar_angle_n118_s6 <= polar_angle_n118_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // azimuth
    wire [1:-38] azimuth_n78 = azimuth_n77_s6 * azimuth_recip_n76_s6; // u40f38

    reg azimuth_n65_s7; // u1f0
    reg [1:-18] azimuth_n66_s7; // u20f18
    reg [1:-38] azimuth_n78_s7; // u40f38
    reg azimuth_n86_s7; // u1f0
    reg azimuth_n90_s7; // u1f0
    reg [1:-18] polar_angle_n97_s7; // u20f18
    reg polar_angle_n118_s7; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n65_s7 <= azimuth_n65_s6;
            azimuth_n66_s7 <= azimuth_n66_s6;
            azimuth_n78_s7 <= azimuth_n78;
            azimuth_n86_s7 <= azimuth_n86_s6;
            azimuth_n90_s7 <= azimuth_n90_s6;
            polar_angle_n97_s7 <= polar_angle_n97_s6;
            polar_angle_n118_s7 <= polar_angle_n118_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // azimuth
    wire [2:-38] azimuth_ratio_sum = {1'b0, azimuth_n78_s7} + 41'h80000;
    wire [2:-18] azimuth_ratio_cut = azimuth_ratio_sum[2:-18];
    wire azimuth_ratio_over = |azimuth_ratio_cut[2:0];
    wire [-1:-18] azimuth_ratio = azimuth_ratio_over ? 18'h3ffff : azimuth_ratio_cut[-1:-18]; // u18f18
    // azimuth.atan
    wire [9:0] azimuth_atan_n80 = azimuth_ratio[-1:-10]; // u10f0

    reg azimuth_n65_s8; // u1f0
    reg [1:-18] azimuth_n66_s8; // u20f18
    reg [37:0] atan_row;
    reg azimuth_n86_s8; // u1f0
    reg azimuth_n90_s8; // u1f0
    reg [1:-18] polar_angle_n97_s8; // u20f18
    reg polar_angle_n118_s8; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n65_s8 <= azimuth_n65_s7;
            azimuth_n66_s8 <= azimuth_n66_s7;
            atan_row <= atan_rom[azimuth_atan_n80];
            azimuth_n86_s8 <= azimuth_n86_s7;
            azimuth_n90_s8 <= azimuth_n90_s7;
            polar_angle_n97_s8 <= polar_angle_n97_s7;
            polar_angle_n118_s8 <= polar_angle_n118_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // azimuth.atan
    wire [0:-18] azimuth_atan_n81 = atan_row[37:19]; // u19f18
    wire [0:-18] azimuth_atan_n82 = atan_row[18:0]; // u19f18
    // azimuth
    wire signed [1:-18] azimuth_n84 = {1'b0, azimuth_n83} - {1'b0, azimuth_atan_n81}; // s20f18
    wire signed [1:-18] azimuth_n85 = azimuth_n65_s8 ? azimuth_n84 : {1'b0, azimuth_atan_n81}; // s20f18

    reg [1:-18] azimuth_n66_s9; // u20f18
    reg [0:-18] azimuth_atan_n82_s9; // u19f18
    reg signed [1:-18] azimuth_n85_s9; // s20f18
    reg azimuth_n86_s9; // u1f0
    reg azimuth_n90_s9; // u1f0
    reg [1:-18] polar_angle_n97_s9; // u20f18
    reg polar_angle_n118_s9; // u1f0
    always @(posedge clk)
        if (ce) begin
            azimuth_n66_s9 <= azimuth_n66_s8;
            azimuth_atan_n82_s9 <= azimuth_atan_n82;
            azimuth_n85_s9 <= azimuth_n85;
            azimuth_n86_s9 <= azimuth_n86_s8;
            azimuth_n90_s9 <= azimuth_n90_s8;
            polar_angle_n97_s9 <= polar_angle_n97_s8;
            polar_angle_n118_s9 <= polar_angle_n118_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // azimuth
    wire signed [2:-18] azimuth_n88 = {2'h0, azimuth_n87} - {azimuth_n85_s9[1], azimuth_n85_s9}; // s21f18
    wire signed [2:-18] azimuth_n89 = azimuth_n86_s9 ? azimuth_n88 : {azimuth_n85_s9[1], azimuth_n85_s9}; // s21f18
    wire signed [3:-18] azimuth_n91 = -{azimuth_n89[2], azimuth_n89}; // s22f18
    wire signed [3:-18] azimuth_n92 = azimuth_n90_s9 ? azimuth_n91 : {azimuth_n89[2], azimuth_n89}; // s22f18
    wire [-1:-18] azimuth_n93 = azimuth_n92[-1:-18]; // u18f18
    wire [2:-36] azimuth_n94 = azimuth_n66_s9 * azimuth_atan_n82_s9; // u39f36
    // (unit)
    wire [0:-18] n125_sum = {1'b0, azimuth_n93} + 19'h2;
    wire [0:-16] n125_cut = n125_sum[0:-16];
    wire [0:-16] n125 = n125_cut; // u17f16
    wire [-1:-16] phi_next = n125[-1:-16]; // u16f16

    reg [2:-36] azimuth_n94_s10; // u39f36
    reg [1:-18] polar_angle_n97_s10; // u20f18
    reg polar_angle_n118_s10; // u1f0
    reg [-1:-16] phi_next_s10; // u16f16
    always @(posedge clk)
        if (ce) begin
            azimuth_n94_s10 <= azimuth_n94;
            polar_angle_n97_s10 <= polar_angle_n97_s9;
            polar_angle_n118_s10 <= polar_angle_n118_s9;
            phi_next_s10 <= phi_next;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // azimuth
    wire [3:-36] azimuth_n95_sum = {1'b0, azimuth_n94_s10} + 40'h20000;
    wire [3:-18] azimuth_n95_cut = azimuth_n95_sum[3:-18];
    wire azimuth_n95_over = |azimuth_n95_cut[3:2];
    wire signed [2:-18] azimuth_n95 = azimuth_n95_over ? 21'hfffff : azimuth_n95_cut[2:-18]; // s21f18
    // (unit)
    wire n96_over = ~azimuth_n95[2] & (|azimuth_n95[1]);
    wire n96_under = azimuth_n95[2] & ~(&azimuth_n95[1]);
    wire signed [1:-18] n96 = n96_over ? 20'h7ffff : n96_under ? 20'h80000 : azimuth_n95[1:-18]; // s20f18
    // polar_angle
    wire [1:-18] polar_angle_n98_neg = -n96;
    wire [1:-18] polar_angle_n98 = n96[1] ? polar_angle_n98_neg : n96; // u20f18
    wire polar_angle_n121 = n96[1]; // u1f0

    reg [1:-18] polar_angle_n97_s11; // u20f18
    reg [1:-18] polar_angle_n98_s11; // u20f18
    reg polar_angle_n118_s11; // u1f0
    reg polar_angle_n121_s11; // u1f0
    reg [-1:-16] phi_next_s11; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n97_s11 <= polar_angle_n97_s10;
            polar_angle_n98_s11 <= polar_angle_n98;
            polar_angle_n118_s11 <= polar_angle_n118_s10;
            polar_angle_n121_s11 <= polar_angle_n121;
            phi_next_s11 <= phi_next_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // polar_angle
    wire polar_angle_n99 = polar_angle_n97_s11 < polar_angle_n98_s11; // u1f0
    wire [1:-18] polar_angle_n100 = polar_angle_n99 ? polar_angle_n98_s11 : polar_angle_n97_s11; // u20f18
    wire [1:-18] polar_angle_n101 = polar_angle_n99 ? polar_angle_n97_s11 : polar_angle_n98_s11; // u20f18
    wire [31:0] polar_angle_n102_padded = {polar_angle_n100, 12'hfff};
    wire polar_angle_n102_skip16 = polar_angle_n102_padded[31:16] == 16'h0;
    wire [15:0] polar_angle_n102_part16 = polar_angle_n102_skip16 ? polar_angle_n102_padded[15:0] : polar_angle_n102_padded[31:16];
    wire polar_angle_n102_skip8 = polar_angle_n102_part16[15:8] == 8'h0;
    wire [7:0] polar_angle_n102_part8 = polar_angle_n102_skip8 ? polar_angle_n102_part16[7:0] : polar_angle_n102_part16[15:8];
    wire polar_angle_n102_skip4 = polar_angle_n102_part8[7:4] == 4'h0;
    wire [3:0] polar_angle_n102_part4 = polar_angle_n102_skip4 ? polar_angle_n102_part8[3:0] : polar_angle_n102_part8[7:4];
    wire polar_angle_n102_skip2 = polar_angle_n102_part4[3:2] == 2'h0;
    wire [1:0] polar_angle_n102_part2 = polar_angle_n102_skip2 ? polar_angle_n102_part4[1:0] : polar_angle_n102_part4[3:2];
    wire polar_angle_n102_skip1 = polar_angle_n102_part2[1] == 1'b0;
    wire [4:0] polar_angle_n102 = {polar_angle_n102_skip16, polar_angle_n102_skip8, polar_angle_n102_skip4, polar_angle_n102_skip2, polar_angle_n102_skip1}; // u5f0

    reg polar_angle_n99_s12; // u1f0
    reg [1:-18] polar_angle_n100_s12; // u20f18
    reg [1:-18] polar_angle_n101_s12; // u20f18
    reg [4:0] polar_angle_n102_s12; // u5f0
    reg polar_angle_n118_s12; // u1f0
    reg polar_angle_n121_s12; // u1f0
    reg [-1:-16] phi_next_s12; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n99_s12 <= polar_angle_n99;
            polar_angle_n100_s12 <= polar_angle_n100;
            polar_angle_n101_s12 <= polar_angle_n101;
            polar_angle_n102_s12 <= polar_angle_n102;
            polar_angle_n118_s12 <= polar_angle_n118_s11;
            polar_angle_n121_s12 <= polar_angle_n121_s11;
            phi_next_s12 <= phi_next_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // polar_angle
    wire polar_angle_n103_past = 5'h14 < polar_angle_n102_s12;
    wire [4:0] polar_angle_n103_count = polar_angle_n103_past ? 5'h14 : polar_angle_n102_s12;
    wire [21:-18] polar_angle_n103 = {20'h0, polar_angle_n100_s12} << polar_angle_n103_count; // u40f18
    wire [19:0] polar_angle_n104 = polar_angle_n103[1:-18]; // u20f0
    wire polar_angle_n105_past = 5'h14 < polar_angle_n102_s12;
    wire [4:0] polar_angle_n105_count = polar_angle_n105_past ? 5'h14 : polar_angle_n102_s12;
    wire [21:-18] polar_angle_n105 = {20'h0, polar_angle_n101_s12} << polar_angle_n105_count; // u40f18
    wire [19:0] polar_angle_n106 = polar_angle_n105[1:-18]; // u20f0
    wire [18:0] polar_angle_n107 = polar_angle_n104[18:0]; // u19f0
    wire [-2:-20] polar_angle_n108 = polar_angle_n107; // u19f20
    // polar_angle.recip
    wire [9:0] polar_angle_recip_n109 = polar_angle_n108[-2:-11]; // u10f0
    // polar_angle
    wire [-1:-20] polar_angle_n111 = polar_angle_n106; // u20f20

    reg polar_angle_n99_s13; // u1f0
    reg [19:0] recip_row_2;
    reg [-1:-20] polar_angle_n111_s13; // u20f20
    reg polar_angle_n118_s13; // u1f0
    reg polar_angle_n121_s13; // u1f0
    reg [-1:-16] phi_next_s13; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n99_s13 <= polar_angle_n99_s12;
            recip_row_2 <= recip_rom[polar_angle_recip_n109];
            polar_angle_n111_s13 <= polar_angle_n111;
            polar_angle_n118_s13 <= polar_angle_n118_s12;
            polar_angle_n121_s13 <= polar_angle_n121_s12;
            phi_next_s13 <= phi_next_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // polar_angle.recip
    wire [1:-18] polar_angle_recip_n110 = recip_row_2; // u20f18

    reg polar_angle_n99_s14; // u1f0
    reg [1:-18] polar_angle_recip_n110_s14; // u20f18
    reg [-1:-20] polar_angle_n111_s14; // u20f20
    reg polar_angle_n118_s14; // u1f0
    reg polar_angle_n121_s14; // u1f0
    reg [-1:-16] phi_next_s14; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n99_s14 <= polar_angle_n99_s13;
            polar_angle_recip_n110_s14 <= polar_angle_recip_n110;
            polar_angle_n111_s14 <= polar_angle_n111_s13;
            polar_angle_n118_s14 <= polar_angle_n118_s13;
            polar_angle_n121_s14 <= polar_angle_n121_s13;
            phi_next_s14 <= phi_next_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // polar_angle
    wire [1:-38] polar_angle_n112 = polar_angle_n111_s14 * polar_angle_recip_n110_s14; // u40f38

    reg polar_angle_n99_s15; // u1f0
    reg [1:-38] polar_angle_n112_s15; // u40f38
    reg polar_angle_n118_s15; // u1f0
    reg polar_angle_n121_s15; // u1f0
    reg [-1:-16] phi_next_s15; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n99_s15 <= polar_angle_n99_s14;
            polar_angle_n112_s15 <= polar_angle_n112;
            polar_angle_n118_s15 <= polar_angle_n118_s14;
            polar_angle_n121_s15 <= polar_angle_n121_s14;
            phi_next_s15 <= phi_next_s14;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // polar_angle
    wire [2:-38] polar_angle_ratio_sum = {1'b0, polar_angle_n112_s15} + 41'h80000;
    wire [2:-18] polar_angle_ratio_cut = polar_angle_ratio_sum[2:-18];
    wire polar_angle_ratio_over = |polar_angle_ratio_cut[2:0];
    wire [-1:-18] polar_angle_ratio = polar_angle_ratio_over ? 18'h3ffff : polar_angle_ratio_cut[-1:-18]; // u18f18
    // polar_angle.atan
    wire [9:0] polar_angle_atan_n114 = polar_angle_ratio[-1:-10]; // u10f0

    reg polar_angle_n99_s16; // u1f0
    reg [37:0] atan_row_2;
    reg polar_angle_n118_s16; // u1f0
    reg polar_angle_n121_s16; // u1f0
    reg [-1:-16] phi_next_s16; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n99_s16 <= polar_angle_n99_s15;
            atan_row_2 <= atan_rom[polar_angle_atan_n114];
            polar_angle_n118_s16 <= polar_angle_n118_s15;
            polar_angle_n121_s16 <= polar_angle_n121_s15;
            phi_next_s16 <= phi_next_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // polar_angle.atan
    wire [0:-18] polar_angle_atan_n115 = atan_row_2[37:19]; // u19f18
    // polar_angle
    wire signed [1:-18] polar_angle_n116 = {1'b0, azimuth_n83} - {1'b0, polar_angle_atan_n115}; // s20f18
    wire signed [1:-18] polar_angle_n117 = polar_angle_n99_s16 ? polar_angle_n116 : {1'b0, polar_angle_atan_n115}; // s20f18

    reg signed [1:-18] polar_angle_n117_s17; // s20f18
    reg polar_angle_n118_s17; // u1f0
    reg polar_angle_n121_s17; // u1f0
    reg [-1:-16] phi_next_s17; // u16f16
    always @(posedge clk)
        if (ce) begin
            polar_angle_n117_s17 <= polar_angle_n117;
            polar_angle_n118_s17 <= polar_angle_n118_s16;
            polar_angle_n121_s17 <= polar_angle_n121_s16;
            phi_next_s17 <= phi_next_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // polar_angle
    wire signed [2:-18] polar_angle_n119 = {2'h0, azimuth_n87} - {polar_angle_n117_s17[1], polar_angle_n117_s17}; // s21f18
    wire signed [2:-18] polar_angle_n120 = polar_angle_n118_s17 ? polar_angle_n119 : {polar_angle_n117_s17[1], polar_angle_n117_s17}; // s21f18
    wire signed [3:-18] polar_angle_n122 = -{polar_angle_n120[2], polar_angle_n120}; // s22f18
    wire signed [3:-18] polar_angle_n123 = polar_angle_n121_s17 ? polar_angle_n122 : {polar_angle_n120[2], polar_angle_n120}; // s22f18
    wire [-1:-18] polar_angle_n124 = polar_angle_n123[-1:-18]; // u18f18
    // (unit)
    wire [0:-18] n127_sum = {1'b0, polar_angle_n124} + 19'h2;
    wire [0:-16] n127_cut = n127_sum[0:-16];
    wire [0:-16] n127 = n127_cut; // u17f16
    wire [-1:-16] theta_next = n127[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            phi <= phi_next_s17;
            theta <= theta_next;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;
    assign valid_out = valid_s18;

    // ---- stage 18 ----


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
        azimuth_n68_part2[0],
        azimuth_n69[21:2],
        azimuth_n70[19],
        azimuth_n71[21:2],
        azimuth_n74[-12:-20],
        azimuth_ratio[-11:-18],
        azimuth_ratio_sum[-19:-38],
        azimuth_n92[3:0],
        n125[0],
        n125_sum[-17:-18],
        azimuth_n95_sum[-19:-36],
        polar_angle_n102_part2[0],
        polar_angle_n103[21:2],
        polar_angle_n104[19],
        polar_angle_n105[21:2],
        polar_angle_n108[-12:-20],
        polar_angle_ratio[-11:-18],
        polar_angle_ratio_sum[-19:-38],
        atan_row_2[18:0],
        polar_angle_n123[3:0],
        n127[0],
        n127_sum[-17:-18]};
endmodule
