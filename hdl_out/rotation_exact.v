// rotation: turns a direction in polar form into the frame of a surface normal
// made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
// Angular Operation, section 3.1 and Fig. 7
//   variant=exact output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
//   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
//   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
//   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
//   stages=auto rom=block
// latency 3 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   angle: mean 1.41e-3 rad, largest seen 4.85e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   dot: mean 1.65e-3, largest seen 4.85e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
//   x: mean 9.18e-4, largest seen 4.10e-3 (268.8 ulp) at phi_a=29150 theta_a=16832 phi_n=13217 theta_n=8896
//   y: mean 7.11e-4, largest seen 2.97e-3 (194.4 ulp) at phi_a=63595 theta_a=15808 phi_n=31274 theta_n=12249
//   z: mean 8.46e-4, largest seen 3.82e-3 (250.3 ulp) at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
// stated bound on each component: 6.05e-3
module rotation_exact (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [-1:-16] phi_a, // u16f16
    input  wire [-1:-16] theta_a, // u16f16
    input  wire [-1:-16] phi_n, // u16f16
    input  wire [-1:-16] theta_n, // u16f16
    output wire valid_out,
    output reg  signed [1:-16] x, // s18f16
    output reg  signed [1:-16] y, // s18f16
    output reg  signed [1:-16] z // s18f16
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
    wire signed [3:-20] x_next_sum = {sums_x_sum[2], sums_x_sum} + 24'h8;
    wire signed [3:-16] x_next_cut = x_next_sum[3:-16];
    wire x_next_over = ~x_next_cut[3] & (|x_next_cut[2:1]);
    wire x_next_under = x_next_cut[3] & ~(&x_next_cut[2:1]);
    wire signed [1:-16] x_next = x_next_over ? 18'h1ffff : x_next_under ? 18'h20000 : x_next_cut[1:-16]; // s18f16
    wire signed [2:-19] y_next_sum = {sums_y_sum_s2[1], sums_y_sum_s2} + 22'h4;
    wire signed [2:-16] y_next_cut = y_next_sum[2:-16];
    wire y_next_over = ~y_next_cut[2] & (|y_next_cut[1]);
    wire signed [1:-16] y_next = y_next_over ? 18'h1ffff : y_next_cut[1:-16]; // s18f16
    wire signed [3:-20] z_next_sum = {sums_z_sum[2], sums_z_sum} + 24'h8;
    wire signed [3:-16] z_next_cut = z_next_sum[3:-16];
    wire z_next_over = ~z_next_cut[3] & (|z_next_cut[2:1]);
    wire z_next_under = z_next_cut[3] & ~(&z_next_cut[2:1]);
    wire signed [1:-16] z_next = z_next_over ? 18'h1ffff : z_next_under ? 18'h20000 : z_next_cut[1:-16]; // s18f16

    always @(posedge clk)
        if (ce) begin
            x <= x_next;
            y <= y_next;
            z <= z_next;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;
    assign valid_out = valid_s3;

    // ---- stage 3 ----


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
        x_next_sum[-17:-20],
        y_next_sum[-17:-19],
        z_next_sum[-17:-20]};
endmodule
