// illumination: light of a pixel from light, halfway and perturbed normal vector in the texture frame
// made by fixpath 0.1.0; seed 001 (Lee et al.), sections 3.2 and 4.2, Fig. 8; variant kim: its eqs (3) and (4)
//   variant=corrected angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
//   guard_bits=2 rounding=half-up sincos_addr_bits=auto cos_addr_bits=auto highlight=on
//   diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1
//   diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
// latency 6 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 3.82e-4, largest seen 6.81e-3 (446.6 ulp) at phi_lt=37053 theta_lt=4180 phi_ht=35367 theta_ht=8197 phi_p=34886 theta_p=6598
//   diffuse: mean 3.22e-4, largest seen 2.59e-3 (169.6 ulp) at phi_lt=54705 theta_lt=16284 phi_ht=62205 theta_ht=13786 phi_p=39476 theta_p=7521
//   specular: mean 9.58e-5, largest seen 6.87e-3 (450.0 ulp) at phi_lt=9407 theta_lt=14751 phi_ht=20560 theta_ht=8847 phi_p=19346 theta_p=7827
//   dot_l: mean 1.03e-3, largest seen 4.01e-3 (262.7 ulp) at phi_lt=9033 theta_lt=16932 phi_ht=2260 theta_ht=13923 phi_p=24522 theta_p=8033
//   dot_h: mean 1.03e-3, largest seen 3.98e-3 (260.8 ulp) at phi_lt=8635 theta_lt=24817 phi_ht=7806 theta_ht=14338 phi_p=58302 theta_p=9088
// stated bound on each dot: 9.08e-3
// stated bound on each diffuse: 5.76e-3
// stated bound on each specular: 8.05e-2
// stated bound on each intensity: 8.63e-2
module illumination (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [-1:-16] phi_lt, // u16f16
    input  wire [-1:-16] theta_lt, // u16f16
    input  wire [-1:-16] phi_ht, // u16f16
    input  wire [-1:-16] theta_ht, // u16f16
    input  wire [-1:-16] phi_p, // u16f16
    input  wire [-1:-16] theta_p, // u16f16
    output wire valid_out,
    output reg  [-1:-16] intensity, // u16f16
    output reg  [-1:-16] diffuse, // u16f16
    output reg  [-1:-16] specular // u16f16
);

    // table cos: cos s20f18
    (* rom_style = "block" *)
    reg [19:0] cos_rom [0:1023];
    initial begin
        cos_rom[0] = 20'h3fffe; cos_rom[1] = 20'h3fff4; cos_rom[2] = 20'h3ffe0; cos_rom[3] = 20'h3ffc3;
        cos_rom[4] = 20'h3ff9b; cos_rom[5] = 20'h3ff6a; cos_rom[6] = 20'h3ff2f; cos_rom[7] = 20'h3feea;
        cos_rom[8] = 20'h3fe9b; cos_rom[9] = 20'h3fe42; cos_rom[10] = 20'h3fde0; cos_rom[11] = 20'h3fd73;
        cos_rom[12] = 20'h3fcfd; cos_rom[13] = 20'h3fc7d; cos_rom[14] = 20'h3fbf3; cos_rom[15] = 20'h3fb5f;
        cos_rom[16] = 20'h3fac2; cos_rom[17] = 20'h3fa1a; cos_rom[18] = 20'h3f969; cos_rom[19] = 20'h3f8ae;
        cos_rom[20] = 20'h3f7e9; cos_rom[21] = 20'h3f71b; cos_rom[22] = 20'h3f642; cos_rom[23] = 20'h3f560;
        cos_rom[24] = 20'h3f474; cos_rom[25] = 20'h3f37e; cos_rom[26] = 20'h3f27f; cos_rom[27] = 20'h3f176;
        cos_rom[28] = 20'h3f063; cos_rom[29] = 20'h3ef46; cos_rom[30] = 20'h3ee20; cos_rom[31] = 20'h3ecf0;
        cos_rom[32] = 20'h3ebb6; cos_rom[33] = 20'h3ea73; cos_rom[34] = 20'h3e926; cos_rom[35] = 20'h3e7cf;
        cos_rom[36] = 20'h3e66f; cos_rom[37] = 20'h3e505; cos_rom[38] = 20'h3e391; cos_rom[39] = 20'h3e214;
        cos_rom[40] = 20'h3e08d; cos_rom[41] = 20'h3defd; cos_rom[42] = 20'h3dd63; cos_rom[43] = 20'h3dbc0;
        cos_rom[44] = 20'h3da13; cos_rom[45] = 20'h3d85c; cos_rom[46] = 20'h3d69c; cos_rom[47] = 20'h3d4d3;
        cos_rom[48] = 20'h3d300; cos_rom[49] = 20'h3d124; cos_rom[50] = 20'h3cf3e; cos_rom[51] = 20'h3cd4f;
        cos_rom[52] = 20'h3cb57; cos_rom[53] = 20'h3c955; cos_rom[54] = 20'h3c749; cos_rom[55] = 20'h3c535;
        cos_rom[56] = 20'h3c317; cos_rom[57] = 20'h3c0f0; cos_rom[58] = 20'h3bec0; cos_rom[59] = 20'h3bc86;
        cos_rom[60] = 20'h3ba43; cos_rom[61] = 20'h3b7f7; cos_rom[62] = 20'h3b5a2; cos_rom[63] = 20'h3b344;
        cos_rom[64] = 20'h3b0dc; cos_rom[65] = 20'h3ae6c; cos_rom[66] = 20'h3abf2; cos_rom[67] = 20'h3a96f;
        cos_rom[68] = 20'h3a6e4; cos_rom[69] = 20'h3a44f; cos_rom[70] = 20'h3a1b1; cos_rom[71] = 20'h39f0a;
        cos_rom[72] = 20'h39c5b; cos_rom[73] = 20'h399a2; cos_rom[74] = 20'h396e1; cos_rom[75] = 20'h39416;
        cos_rom[76] = 20'h39143; cos_rom[77] = 20'h38e67; cos_rom[78] = 20'h38b83; cos_rom[79] = 20'h38895;
        cos_rom[80] = 20'h3859f; cos_rom[81] = 20'h382a0; cos_rom[82] = 20'h37f99; cos_rom[83] = 20'h37c89;
        cos_rom[84] = 20'h37970; cos_rom[85] = 20'h3764e; cos_rom[86] = 20'h37325; cos_rom[87] = 20'h36ff2;
        cos_rom[88] = 20'h36cb7; cos_rom[89] = 20'h36974; cos_rom[90] = 20'h36628; cos_rom[91] = 20'h362d4;
        cos_rom[92] = 20'h35f78; cos_rom[93] = 20'h35c13; cos_rom[94] = 20'h358a6; cos_rom[95] = 20'h35531;
        cos_rom[96] = 20'h351b3; cos_rom[97] = 20'h34e2d; cos_rom[98] = 20'h34a9f; cos_rom[99] = 20'h34709;
        cos_rom[100] = 20'h3436b; cos_rom[101] = 20'h33fc5; cos_rom[102] = 20'h33c17; cos_rom[103] = 20'h33861;
        cos_rom[104] = 20'h334a3; cos_rom[105] = 20'h330dc; cos_rom[106] = 20'h32d0f; cos_rom[107] = 20'h32939;
        cos_rom[108] = 20'h3255b; cos_rom[109] = 20'h32176; cos_rom[110] = 20'h31d89; cos_rom[111] = 20'h31994;
        cos_rom[112] = 20'h31598; cos_rom[113] = 20'h31194; cos_rom[114] = 20'h30d88; cos_rom[115] = 20'h30975;
        cos_rom[116] = 20'h3055b; cos_rom[117] = 20'h30139; cos_rom[118] = 20'h2fd0f; cos_rom[119] = 20'h2f8df;
        cos_rom[120] = 20'h2f4a6; cos_rom[121] = 20'h2f067; cos_rom[122] = 20'h2ec20; cos_rom[123] = 20'h2e7d2;
        cos_rom[124] = 20'h2e37d; cos_rom[125] = 20'h2df21; cos_rom[126] = 20'h2dabe; cos_rom[127] = 20'h2d654;
        cos_rom[128] = 20'h2d1e2; cos_rom[129] = 20'h2cd6a; cos_rom[130] = 20'h2c8eb; cos_rom[131] = 20'h2c465;
        cos_rom[132] = 20'h2bfd8; cos_rom[133] = 20'h2bb44; cos_rom[134] = 20'h2b6aa; cos_rom[135] = 20'h2b209;
        cos_rom[136] = 20'h2ad61; cos_rom[137] = 20'h2a8b3; cos_rom[138] = 20'h2a3fe; cos_rom[139] = 20'h29f42;
        cos_rom[140] = 20'h29a80; cos_rom[141] = 20'h295b8; cos_rom[142] = 20'h290e9; cos_rom[143] = 20'h28c14;
        cos_rom[144] = 20'h28739; cos_rom[145] = 20'h28257; cos_rom[146] = 20'h27d70; cos_rom[147] = 20'h27882;
        cos_rom[148] = 20'h2738e; cos_rom[149] = 20'h26e94; cos_rom[150] = 20'h26994; cos_rom[151] = 20'h2648e;
        cos_rom[152] = 20'h25f82; cos_rom[153] = 20'h25a70; cos_rom[154] = 20'h25558; cos_rom[155] = 20'h2503b;
        cos_rom[156] = 20'h24b18; cos_rom[157] = 20'h245ef; cos_rom[158] = 20'h240c1; cos_rom[159] = 20'h23b8d;
        cos_rom[160] = 20'h23654; cos_rom[161] = 20'h23115; cos_rom[162] = 20'h22bd1; cos_rom[163] = 20'h22687;
        cos_rom[164] = 20'h22138; cos_rom[165] = 20'h21be4; cos_rom[166] = 20'h2168b; cos_rom[167] = 20'h2112c;
        cos_rom[168] = 20'h20bc9; cos_rom[169] = 20'h20660; cos_rom[170] = 20'h200f2; cos_rom[171] = 20'h1fb80;
        cos_rom[172] = 20'h1f608; cos_rom[173] = 20'h1f08c; cos_rom[174] = 20'h1eb0b; cos_rom[175] = 20'h1e585;
        cos_rom[176] = 20'h1dffb; cos_rom[177] = 20'h1da6b; cos_rom[178] = 20'h1d4d8; cos_rom[179] = 20'h1cf3f;
        cos_rom[180] = 20'h1c9a3; cos_rom[181] = 20'h1c402; cos_rom[182] = 20'h1be5c; cos_rom[183] = 20'h1b8b2;
        cos_rom[184] = 20'h1b304; cos_rom[185] = 20'h1ad52; cos_rom[186] = 20'h1a79c; cos_rom[187] = 20'h1a1e1;
        cos_rom[188] = 20'h19c23; cos_rom[189] = 20'h19660; cos_rom[190] = 20'h1909a; cos_rom[191] = 20'h18ad0;
        cos_rom[192] = 20'h18502; cos_rom[193] = 20'h17f30; cos_rom[194] = 20'h1795b; cos_rom[195] = 20'h17382;
        cos_rom[196] = 20'h16da5; cos_rom[197] = 20'h167c5; cos_rom[198] = 20'h161e1; cos_rom[199] = 20'h15bfa;
        cos_rom[200] = 20'h1560f; cos_rom[201] = 20'h15022; cos_rom[202] = 20'h14a31; cos_rom[203] = 20'h1443d;
        cos_rom[204] = 20'h13e45; cos_rom[205] = 20'h1384b; cos_rom[206] = 20'h1324e; cos_rom[207] = 20'h12c4d;
        cos_rom[208] = 20'h1264a; cos_rom[209] = 20'h12044; cos_rom[210] = 20'h11a3b; cos_rom[211] = 20'h11430;
        cos_rom[212] = 20'h10e22; cos_rom[213] = 20'h10811; cos_rom[214] = 20'h101fd; cos_rom[215] = 20'h0fbe8;
        cos_rom[216] = 20'h0f5cf; cos_rom[217] = 20'h0efb5; cos_rom[218] = 20'h0e998; cos_rom[219] = 20'h0e378;
        cos_rom[220] = 20'h0dd57; cos_rom[221] = 20'h0d734; cos_rom[222] = 20'h0d10e; cos_rom[223] = 20'h0cae6;
        cos_rom[224] = 20'h0c4bd; cos_rom[225] = 20'h0be91; cos_rom[226] = 20'h0b864; cos_rom[227] = 20'h0b235;
        cos_rom[228] = 20'h0ac04; cos_rom[229] = 20'h0a5d2; cos_rom[230] = 20'h09f9e; cos_rom[231] = 20'h09968;
        cos_rom[232] = 20'h09331; cos_rom[233] = 20'h08cf9; cos_rom[234] = 20'h086bf; cos_rom[235] = 20'h08084;
        cos_rom[236] = 20'h07a47; cos_rom[237] = 20'h0740a; cos_rom[238] = 20'h06dcb; cos_rom[239] = 20'h0678b;
        cos_rom[240] = 20'h0614b; cos_rom[241] = 20'h05b09; cos_rom[242] = 20'h054c6; cos_rom[243] = 20'h04e83;
        cos_rom[244] = 20'h0483f; cos_rom[245] = 20'h041fa; cos_rom[246] = 20'h03bb5; cos_rom[247] = 20'h0356f;
        cos_rom[248] = 20'h02f28; cos_rom[249] = 20'h028e1; cos_rom[250] = 20'h0229a; cos_rom[251] = 20'h01c52;
        cos_rom[252] = 20'h0160a; cos_rom[253] = 20'h00fc2; cos_rom[254] = 20'h00979; cos_rom[255] = 20'h00331;
        cos_rom[256] = 20'hffce8; cos_rom[257] = 20'hff6a0; cos_rom[258] = 20'hff058; cos_rom[259] = 20'hfea0f;
        cos_rom[260] = 20'hfe3c7; cos_rom[261] = 20'hfdd80; cos_rom[262] = 20'hfd738; cos_rom[263] = 20'hfd0f1;
        cos_rom[264] = 20'hfcaab; cos_rom[265] = 20'hfc465; cos_rom[266] = 20'hfbe1f; cos_rom[267] = 20'hfb7da;
        cos_rom[268] = 20'hfb196; cos_rom[269] = 20'hfab53; cos_rom[270] = 20'hfa510; cos_rom[271] = 20'hf9ecf;
        cos_rom[272] = 20'hf988e; cos_rom[273] = 20'hf924e; cos_rom[274] = 20'hf8c0f; cos_rom[275] = 20'hf85d2;
        cos_rom[276] = 20'hf7f95; cos_rom[277] = 20'hf795a; cos_rom[278] = 20'hf7320; cos_rom[279] = 20'hf6ce8;
        cos_rom[280] = 20'hf66b1; cos_rom[281] = 20'hf607b; cos_rom[282] = 20'hf5a47; cos_rom[283] = 20'hf5415;
        cos_rom[284] = 20'hf4de4; cos_rom[285] = 20'hf47b5; cos_rom[286] = 20'hf4187; cos_rom[287] = 20'hf3b5c;
        cos_rom[288] = 20'hf3532; cos_rom[289] = 20'hf2f0b; cos_rom[290] = 20'hf28e5; cos_rom[291] = 20'hf22c1;
        cos_rom[292] = 20'hf1ca0; cos_rom[293] = 20'hf1681; cos_rom[294] = 20'hf1064; cos_rom[295] = 20'hf0a49;
        cos_rom[296] = 20'hf0431; cos_rom[297] = 20'hefe1b; cos_rom[298] = 20'hef808; cos_rom[299] = 20'hef1f7;
        cos_rom[300] = 20'heebe8; cos_rom[301] = 20'hee5dd; cos_rom[302] = 20'hedfd4; cos_rom[303] = 20'hed9ce;
        cos_rom[304] = 20'hed3cb; cos_rom[305] = 20'hecdca; cos_rom[306] = 20'hec7cd; cos_rom[307] = 20'hec1d3;
        cos_rom[308] = 20'hebbdb; cos_rom[309] = 20'heb5e7; cos_rom[310] = 20'heaff6; cos_rom[311] = 20'heaa08;
        cos_rom[312] = 20'hea41e; cos_rom[313] = 20'he9e37; cos_rom[314] = 20'he9853; cos_rom[315] = 20'he9273;
        cos_rom[316] = 20'he8c96; cos_rom[317] = 20'he86bd; cos_rom[318] = 20'he80e7; cos_rom[319] = 20'he7b15;
        cos_rom[320] = 20'he7547; cos_rom[321] = 20'he6f7d; cos_rom[322] = 20'he69b7; cos_rom[323] = 20'he63f4;
        cos_rom[324] = 20'he5e36; cos_rom[325] = 20'he587b; cos_rom[326] = 20'he52c5; cos_rom[327] = 20'he4d12;
        cos_rom[328] = 20'he4764; cos_rom[329] = 20'he41bb; cos_rom[330] = 20'he3c15; cos_rom[331] = 20'he3674;
        cos_rom[332] = 20'he30d7; cos_rom[333] = 20'he2b3f; cos_rom[334] = 20'he25ab; cos_rom[335] = 20'he201c;
        cos_rom[336] = 20'he1a91; cos_rom[337] = 20'he150b; cos_rom[338] = 20'he0f8a; cos_rom[339] = 20'he0a0e;
        cos_rom[340] = 20'he0496; cos_rom[341] = 20'hdff23; cos_rom[342] = 20'hdf9b6; cos_rom[343] = 20'hdf44d;
        cos_rom[344] = 20'hdeee9; cos_rom[345] = 20'hde98b; cos_rom[346] = 20'hde431; cos_rom[347] = 20'hddedd;
        cos_rom[348] = 20'hdd98e; cos_rom[349] = 20'hdd444; cos_rom[350] = 20'hdcf00; cos_rom[351] = 20'hdc9c1;
        cos_rom[352] = 20'hdc488; cos_rom[353] = 20'hdbf54; cos_rom[354] = 20'hdba25; cos_rom[355] = 20'hdb4fd;
        cos_rom[356] = 20'hdafd9; cos_rom[357] = 20'hdaabc; cos_rom[358] = 20'hda5a4; cos_rom[359] = 20'hda093;
        cos_rom[360] = 20'hd9b87; cos_rom[361] = 20'hd9680; cos_rom[362] = 20'hd9180; cos_rom[363] = 20'hd8c86;
        cos_rom[364] = 20'hd8792; cos_rom[365] = 20'hd82a4; cos_rom[366] = 20'hd7dbc; cos_rom[367] = 20'hd78db;
        cos_rom[368] = 20'hd73ff; cos_rom[369] = 20'hd6f2a; cos_rom[370] = 20'hd6a5b; cos_rom[371] = 20'hd6593;
        cos_rom[372] = 20'hd60d1; cos_rom[373] = 20'hd5c15; cos_rom[374] = 20'hd5760; cos_rom[375] = 20'hd52b2;
        cos_rom[376] = 20'hd4e0a; cos_rom[377] = 20'hd4969; cos_rom[378] = 20'hd44ce; cos_rom[379] = 20'hd403a;
        cos_rom[380] = 20'hd3bad; cos_rom[381] = 20'hd3727; cos_rom[382] = 20'hd32a8; cos_rom[383] = 20'hd2e30;
        cos_rom[384] = 20'hd29be; cos_rom[385] = 20'hd2554; cos_rom[386] = 20'hd20f0; cos_rom[387] = 20'hd1c94;
        cos_rom[388] = 20'hd183f; cos_rom[389] = 20'hd13f1; cos_rom[390] = 20'hd0faa; cos_rom[391] = 20'hd0b6a;
        cos_rom[392] = 20'hd0732; cos_rom[393] = 20'hd0301; cos_rom[394] = 20'hcfed8; cos_rom[395] = 20'hcfab6;
        cos_rom[396] = 20'hcf69b; cos_rom[397] = 20'hcf288; cos_rom[398] = 20'hcee7c; cos_rom[399] = 20'hcea78;
        cos_rom[400] = 20'hce67c; cos_rom[401] = 20'hce287; cos_rom[402] = 20'hcde9a; cos_rom[403] = 20'hcdab4;
        cos_rom[404] = 20'hcd6d7; cos_rom[405] = 20'hcd301; cos_rom[406] = 20'hccf33; cos_rom[407] = 20'hccb6d;
        cos_rom[408] = 20'hcc7ae; cos_rom[409] = 20'hcc3f8; cos_rom[410] = 20'hcc04a; cos_rom[411] = 20'hcbca3;
        cos_rom[412] = 20'hcb905; cos_rom[413] = 20'hcb56f; cos_rom[414] = 20'hcb1e1; cos_rom[415] = 20'hcae5b;
        cos_rom[416] = 20'hcaadd; cos_rom[417] = 20'hca768; cos_rom[418] = 20'hca3fb; cos_rom[419] = 20'hca096;
        cos_rom[420] = 20'hc9d39; cos_rom[421] = 20'hc99e5; cos_rom[422] = 20'hc9699; cos_rom[423] = 20'hc9356;
        cos_rom[424] = 20'hc901b; cos_rom[425] = 20'hc8ce8; cos_rom[426] = 20'hc89be; cos_rom[427] = 20'hc869d;
        cos_rom[428] = 20'hc8384; cos_rom[429] = 20'hc8073; cos_rom[430] = 20'hc7d6c; cos_rom[431] = 20'hc7a6d;
        cos_rom[432] = 20'hc7777; cos_rom[433] = 20'hc7489; cos_rom[434] = 20'hc71a4; cos_rom[435] = 20'hc6ec8;
        cos_rom[436] = 20'hc6bf5; cos_rom[437] = 20'hc692a; cos_rom[438] = 20'hc6669; cos_rom[439] = 20'hc63b0;
        cos_rom[440] = 20'hc6100; cos_rom[441] = 20'hc5e59; cos_rom[442] = 20'hc5bbc; cos_rom[443] = 20'hc5927;
        cos_rom[444] = 20'hc569b; cos_rom[445] = 20'hc5418; cos_rom[446] = 20'hc519e; cos_rom[447] = 20'hc4f2d;
        cos_rom[448] = 20'hc4cc6; cos_rom[449] = 20'hc4a67; cos_rom[450] = 20'hc4812; cos_rom[451] = 20'hc45c6;
        cos_rom[452] = 20'hc4383; cos_rom[453] = 20'hc4149; cos_rom[454] = 20'hc3f19; cos_rom[455] = 20'hc3cf1;
        cos_rom[456] = 20'hc3ad3; cos_rom[457] = 20'hc38bf; cos_rom[458] = 20'hc36b3; cos_rom[459] = 20'hc34b1;
        cos_rom[460] = 20'hc32b9; cos_rom[461] = 20'hc30ca; cos_rom[462] = 20'hc2ee4; cos_rom[463] = 20'hc2d07;
        cos_rom[464] = 20'hc2b34; cos_rom[465] = 20'hc296b; cos_rom[466] = 20'hc27ab; cos_rom[467] = 20'hc25f4;
        cos_rom[468] = 20'hc2447; cos_rom[469] = 20'hc22a3; cos_rom[470] = 20'hc2109; cos_rom[471] = 20'hc1f79;
        cos_rom[472] = 20'hc1df2; cos_rom[473] = 20'hc1c75; cos_rom[474] = 20'hc1b01; cos_rom[475] = 20'hc1997;
        cos_rom[476] = 20'hc1836; cos_rom[477] = 20'hc16e0; cos_rom[478] = 20'hc1592; cos_rom[479] = 20'hc144f;
        cos_rom[480] = 20'hc1315; cos_rom[481] = 20'hc11e5; cos_rom[482] = 20'hc10be; cos_rom[483] = 20'hc0fa1;
        cos_rom[484] = 20'hc0e8e; cos_rom[485] = 20'hc0d85; cos_rom[486] = 20'hc0c85; cos_rom[487] = 20'hc0b90;
        cos_rom[488] = 20'hc0aa4; cos_rom[489] = 20'hc09c1; cos_rom[490] = 20'hc08e9; cos_rom[491] = 20'hc081a;
        cos_rom[492] = 20'hc0755; cos_rom[493] = 20'hc069a; cos_rom[494] = 20'hc05e8; cos_rom[495] = 20'hc0541;
        cos_rom[496] = 20'hc04a3; cos_rom[497] = 20'hc040f; cos_rom[498] = 20'hc0385; cos_rom[499] = 20'hc0305;
        cos_rom[500] = 20'hc028e; cos_rom[501] = 20'hc0222; cos_rom[502] = 20'hc01bf; cos_rom[503] = 20'hc0166;
        cos_rom[504] = 20'hc0117; cos_rom[505] = 20'hc00d2; cos_rom[506] = 20'hc0097; cos_rom[507] = 20'hc0065;
        cos_rom[508] = 20'hc003e; cos_rom[509] = 20'hc0020; cos_rom[510] = 20'hc000c; cos_rom[511] = 20'hc0002;
        cos_rom[512] = 20'hc0002; cos_rom[513] = 20'hc000c; cos_rom[514] = 20'hc0020; cos_rom[515] = 20'hc003d;
        cos_rom[516] = 20'hc0065; cos_rom[517] = 20'hc0096; cos_rom[518] = 20'hc00d1; cos_rom[519] = 20'hc0116;
        cos_rom[520] = 20'hc0165; cos_rom[521] = 20'hc01be; cos_rom[522] = 20'hc0220; cos_rom[523] = 20'hc028d;
        cos_rom[524] = 20'hc0303; cos_rom[525] = 20'hc0383; cos_rom[526] = 20'hc040d; cos_rom[527] = 20'hc04a1;
        cos_rom[528] = 20'hc053e; cos_rom[529] = 20'hc05e6; cos_rom[530] = 20'hc0697; cos_rom[531] = 20'hc0752;
        cos_rom[532] = 20'hc0817; cos_rom[533] = 20'hc08e5; cos_rom[534] = 20'hc09be; cos_rom[535] = 20'hc0aa0;
        cos_rom[536] = 20'hc0b8c; cos_rom[537] = 20'hc0c82; cos_rom[538] = 20'hc0d81; cos_rom[539] = 20'hc0e8a;
        cos_rom[540] = 20'hc0f9d; cos_rom[541] = 20'hc10ba; cos_rom[542] = 20'hc11e0; cos_rom[543] = 20'hc1310;
        cos_rom[544] = 20'hc144a; cos_rom[545] = 20'hc158d; cos_rom[546] = 20'hc16da; cos_rom[547] = 20'hc1831;
        cos_rom[548] = 20'hc1991; cos_rom[549] = 20'hc1afb; cos_rom[550] = 20'hc1c6f; cos_rom[551] = 20'hc1dec;
        cos_rom[552] = 20'hc1f73; cos_rom[553] = 20'hc2103; cos_rom[554] = 20'hc229d; cos_rom[555] = 20'hc2440;
        cos_rom[556] = 20'hc25ed; cos_rom[557] = 20'hc27a4; cos_rom[558] = 20'hc2964; cos_rom[559] = 20'hc2b2d;
        cos_rom[560] = 20'hc2d00; cos_rom[561] = 20'hc2edc; cos_rom[562] = 20'hc30c2; cos_rom[563] = 20'hc32b1;
        cos_rom[564] = 20'hc34a9; cos_rom[565] = 20'hc36ab; cos_rom[566] = 20'hc38b7; cos_rom[567] = 20'hc3acb;
        cos_rom[568] = 20'hc3ce9; cos_rom[569] = 20'hc3f10; cos_rom[570] = 20'hc4140; cos_rom[571] = 20'hc437a;
        cos_rom[572] = 20'hc45bd; cos_rom[573] = 20'hc4809; cos_rom[574] = 20'hc4a5e; cos_rom[575] = 20'hc4cbc;
        cos_rom[576] = 20'hc4f24; cos_rom[577] = 20'hc5194; cos_rom[578] = 20'hc540e; cos_rom[579] = 20'hc5691;
        cos_rom[580] = 20'hc591c; cos_rom[581] = 20'hc5bb1; cos_rom[582] = 20'hc5e4f; cos_rom[583] = 20'hc60f6;
        cos_rom[584] = 20'hc63a5; cos_rom[585] = 20'hc665e; cos_rom[586] = 20'hc691f; cos_rom[587] = 20'hc6bea;
        cos_rom[588] = 20'hc6ebd; cos_rom[589] = 20'hc7199; cos_rom[590] = 20'hc747d; cos_rom[591] = 20'hc776b;
        cos_rom[592] = 20'hc7a61; cos_rom[593] = 20'hc7d60; cos_rom[594] = 20'hc8067; cos_rom[595] = 20'hc8377;
        cos_rom[596] = 20'hc8690; cos_rom[597] = 20'hc89b2; cos_rom[598] = 20'hc8cdb; cos_rom[599] = 20'hc900e;
        cos_rom[600] = 20'hc9349; cos_rom[601] = 20'hc968c; cos_rom[602] = 20'hc99d8; cos_rom[603] = 20'hc9d2c;
        cos_rom[604] = 20'hca088; cos_rom[605] = 20'hca3ed; cos_rom[606] = 20'hca75a; cos_rom[607] = 20'hcaacf;
        cos_rom[608] = 20'hcae4d; cos_rom[609] = 20'hcb1d3; cos_rom[610] = 20'hcb561; cos_rom[611] = 20'hcb8f7;
        cos_rom[612] = 20'hcbc95; cos_rom[613] = 20'hcc03b; cos_rom[614] = 20'hcc3e9; cos_rom[615] = 20'hcc79f;
        cos_rom[616] = 20'hccb5d; cos_rom[617] = 20'hccf24; cos_rom[618] = 20'hcd2f1; cos_rom[619] = 20'hcd6c7;
        cos_rom[620] = 20'hcdaa5; cos_rom[621] = 20'hcde8a; cos_rom[622] = 20'hce277; cos_rom[623] = 20'hce66c;
        cos_rom[624] = 20'hcea68; cos_rom[625] = 20'hcee6c; cos_rom[626] = 20'hcf278; cos_rom[627] = 20'hcf68b;
        cos_rom[628] = 20'hcfaa5; cos_rom[629] = 20'hcfec7; cos_rom[630] = 20'hd02f1; cos_rom[631] = 20'hd0721;
        cos_rom[632] = 20'hd0b5a; cos_rom[633] = 20'hd0f99; cos_rom[634] = 20'hd13e0; cos_rom[635] = 20'hd182e;
        cos_rom[636] = 20'hd1c83; cos_rom[637] = 20'hd20df; cos_rom[638] = 20'hd2542; cos_rom[639] = 20'hd29ac;
        cos_rom[640] = 20'hd2e1e; cos_rom[641] = 20'hd3296; cos_rom[642] = 20'hd3715; cos_rom[643] = 20'hd3b9b;
        cos_rom[644] = 20'hd4028; cos_rom[645] = 20'hd44bc; cos_rom[646] = 20'hd4956; cos_rom[647] = 20'hd4df7;
        cos_rom[648] = 20'hd529f; cos_rom[649] = 20'hd574d; cos_rom[650] = 20'hd5c02; cos_rom[651] = 20'hd60be;
        cos_rom[652] = 20'hd6580; cos_rom[653] = 20'hd6a48; cos_rom[654] = 20'hd6f17; cos_rom[655] = 20'hd73ec;
        cos_rom[656] = 20'hd78c7; cos_rom[657] = 20'hd7da9; cos_rom[658] = 20'hd8290; cos_rom[659] = 20'hd877e;
        cos_rom[660] = 20'hd8c72; cos_rom[661] = 20'hd916c; cos_rom[662] = 20'hd966c; cos_rom[663] = 20'hd9b72;
        cos_rom[664] = 20'hda07e; cos_rom[665] = 20'hda590; cos_rom[666] = 20'hdaaa8; cos_rom[667] = 20'hdafc5;
        cos_rom[668] = 20'hdb4e8; cos_rom[669] = 20'hdba11; cos_rom[670] = 20'hdbf3f; cos_rom[671] = 20'hdc473;
        cos_rom[672] = 20'hdc9ac; cos_rom[673] = 20'hdceeb; cos_rom[674] = 20'hdd42f; cos_rom[675] = 20'hdd979;
        cos_rom[676] = 20'hddec8; cos_rom[677] = 20'hde41c; cos_rom[678] = 20'hde975; cos_rom[679] = 20'hdeed4;
        cos_rom[680] = 20'hdf437; cos_rom[681] = 20'hdf9a0; cos_rom[682] = 20'hdff0e; cos_rom[683] = 20'he0480;
        cos_rom[684] = 20'he09f8; cos_rom[685] = 20'he0f74; cos_rom[686] = 20'he14f5; cos_rom[687] = 20'he1a7b;
        cos_rom[688] = 20'he2005; cos_rom[689] = 20'he2595; cos_rom[690] = 20'he2b28; cos_rom[691] = 20'he30c1;
        cos_rom[692] = 20'he365d; cos_rom[693] = 20'he3bfe; cos_rom[694] = 20'he41a4; cos_rom[695] = 20'he474e;
        cos_rom[696] = 20'he4cfc; cos_rom[697] = 20'he52ae; cos_rom[698] = 20'he5864; cos_rom[699] = 20'he5e1f;
        cos_rom[700] = 20'he63dd; cos_rom[701] = 20'he69a0; cos_rom[702] = 20'he6f66; cos_rom[703] = 20'he7530;
        cos_rom[704] = 20'he7afe; cos_rom[705] = 20'he80d0; cos_rom[706] = 20'he86a5; cos_rom[707] = 20'he8c7e;
        cos_rom[708] = 20'he925b; cos_rom[709] = 20'he983b; cos_rom[710] = 20'he9e1f; cos_rom[711] = 20'hea406;
        cos_rom[712] = 20'hea9f1; cos_rom[713] = 20'heafde; cos_rom[714] = 20'heb5cf; cos_rom[715] = 20'hebbc3;
        cos_rom[716] = 20'hec1bb; cos_rom[717] = 20'hec7b5; cos_rom[718] = 20'hecdb2; cos_rom[719] = 20'hed3b3;
        cos_rom[720] = 20'hed9b6; cos_rom[721] = 20'hedfbc; cos_rom[722] = 20'hee5c5; cos_rom[723] = 20'heebd0;
        cos_rom[724] = 20'hef1de; cos_rom[725] = 20'hef7ef; cos_rom[726] = 20'hefe03; cos_rom[727] = 20'hf0418;
        cos_rom[728] = 20'hf0a31; cos_rom[729] = 20'hf104b; cos_rom[730] = 20'hf1668; cos_rom[731] = 20'hf1c88;
        cos_rom[732] = 20'hf22a9; cos_rom[733] = 20'hf28cc; cos_rom[734] = 20'hf2ef2; cos_rom[735] = 20'hf351a;
        cos_rom[736] = 20'hf3b43; cos_rom[737] = 20'hf416f; cos_rom[738] = 20'hf479c; cos_rom[739] = 20'hf4dcb;
        cos_rom[740] = 20'hf53fc; cos_rom[741] = 20'hf5a2e; cos_rom[742] = 20'hf6062; cos_rom[743] = 20'hf6698;
        cos_rom[744] = 20'hf6ccf; cos_rom[745] = 20'hf7307; cos_rom[746] = 20'hf7941; cos_rom[747] = 20'hf7f7c;
        cos_rom[748] = 20'hf85b9; cos_rom[749] = 20'hf8bf6; cos_rom[750] = 20'hf9235; cos_rom[751] = 20'hf9875;
        cos_rom[752] = 20'hf9eb5; cos_rom[753] = 20'hfa4f7; cos_rom[754] = 20'hfab3a; cos_rom[755] = 20'hfb17d;
        cos_rom[756] = 20'hfb7c1; cos_rom[757] = 20'hfbe06; cos_rom[758] = 20'hfc44b; cos_rom[759] = 20'hfca91;
        cos_rom[760] = 20'hfd0d8; cos_rom[761] = 20'hfd71f; cos_rom[762] = 20'hfdd66; cos_rom[763] = 20'hfe3ae;
        cos_rom[764] = 20'hfe9f6; cos_rom[765] = 20'hff03e; cos_rom[766] = 20'hff687; cos_rom[767] = 20'hffccf;
        cos_rom[768] = 20'h00318; cos_rom[769] = 20'h00960; cos_rom[770] = 20'h00fa8; cos_rom[771] = 20'h015f1;
        cos_rom[772] = 20'h01c39; cos_rom[773] = 20'h02280; cos_rom[774] = 20'h028c8; cos_rom[775] = 20'h02f0f;
        cos_rom[776] = 20'h03555; cos_rom[777] = 20'h03b9b; cos_rom[778] = 20'h041e1; cos_rom[779] = 20'h04826;
        cos_rom[780] = 20'h04e6a; cos_rom[781] = 20'h054ad; cos_rom[782] = 20'h05af0; cos_rom[783] = 20'h06131;
        cos_rom[784] = 20'h06772; cos_rom[785] = 20'h06db2; cos_rom[786] = 20'h073f1; cos_rom[787] = 20'h07a2e;
        cos_rom[788] = 20'h0806b; cos_rom[789] = 20'h086a6; cos_rom[790] = 20'h08ce0; cos_rom[791] = 20'h09318;
        cos_rom[792] = 20'h0994f; cos_rom[793] = 20'h09f85; cos_rom[794] = 20'h0a5b9; cos_rom[795] = 20'h0abeb;
        cos_rom[796] = 20'h0b21c; cos_rom[797] = 20'h0b84b; cos_rom[798] = 20'h0be79; cos_rom[799] = 20'h0c4a4;
        cos_rom[800] = 20'h0cace; cos_rom[801] = 20'h0d0f5; cos_rom[802] = 20'h0d71b; cos_rom[803] = 20'h0dd3f;
        cos_rom[804] = 20'h0e360; cos_rom[805] = 20'h0e97f; cos_rom[806] = 20'h0ef9c; cos_rom[807] = 20'h0f5b7;
        cos_rom[808] = 20'h0fbcf; cos_rom[809] = 20'h101e5; cos_rom[810] = 20'h107f8; cos_rom[811] = 20'h10e09;
        cos_rom[812] = 20'h11418; cos_rom[813] = 20'h11a23; cos_rom[814] = 20'h1202c; cos_rom[815] = 20'h12632;
        cos_rom[816] = 20'h12c35; cos_rom[817] = 20'h13236; cos_rom[818] = 20'h13833; cos_rom[819] = 20'h13e2d;
        cos_rom[820] = 20'h14425; cos_rom[821] = 20'h14a19; cos_rom[822] = 20'h1500a; cos_rom[823] = 20'h155f8;
        cos_rom[824] = 20'h15be2; cos_rom[825] = 20'h161c9; cos_rom[826] = 20'h167ad; cos_rom[827] = 20'h16d8d;
        cos_rom[828] = 20'h1736a; cos_rom[829] = 20'h17943; cos_rom[830] = 20'h17f19; cos_rom[831] = 20'h184eb;
        cos_rom[832] = 20'h18ab9; cos_rom[833] = 20'h19083; cos_rom[834] = 20'h19649; cos_rom[835] = 20'h19c0c;
        cos_rom[836] = 20'h1a1ca; cos_rom[837] = 20'h1a785; cos_rom[838] = 20'h1ad3b; cos_rom[839] = 20'h1b2ee;
        cos_rom[840] = 20'h1b89c; cos_rom[841] = 20'h1be45; cos_rom[842] = 20'h1c3eb; cos_rom[843] = 20'h1c98c;
        cos_rom[844] = 20'h1cf29; cos_rom[845] = 20'h1d4c1; cos_rom[846] = 20'h1da55; cos_rom[847] = 20'h1dfe4;
        cos_rom[848] = 20'h1e56f; cos_rom[849] = 20'h1eaf5; cos_rom[850] = 20'h1f076; cos_rom[851] = 20'h1f5f2;
        cos_rom[852] = 20'h1fb6a; cos_rom[853] = 20'h200dd; cos_rom[854] = 20'h2064a; cos_rom[855] = 20'h20bb3;
        cos_rom[856] = 20'h21117; cos_rom[857] = 20'h21675; cos_rom[858] = 20'h21bcf; cos_rom[859] = 20'h22123;
        cos_rom[860] = 20'h22672; cos_rom[861] = 20'h22bbc; cos_rom[862] = 20'h23100; cos_rom[863] = 20'h2363f;
        cos_rom[864] = 20'h23b78; cos_rom[865] = 20'h240ac; cos_rom[866] = 20'h245db; cos_rom[867] = 20'h24b03;
        cos_rom[868] = 20'h25027; cos_rom[869] = 20'h25544; cos_rom[870] = 20'h25a5c; cos_rom[871] = 20'h25f6d;
        cos_rom[872] = 20'h26479; cos_rom[873] = 20'h26980; cos_rom[874] = 20'h26e80; cos_rom[875] = 20'h2737a;
        cos_rom[876] = 20'h2786e; cos_rom[877] = 20'h27d5c; cos_rom[878] = 20'h28244; cos_rom[879] = 20'h28725;
        cos_rom[880] = 20'h28c01; cos_rom[881] = 20'h290d6; cos_rom[882] = 20'h295a5; cos_rom[883] = 20'h29a6d;
        cos_rom[884] = 20'h29f2f; cos_rom[885] = 20'h2a3eb; cos_rom[886] = 20'h2a8a0; cos_rom[887] = 20'h2ad4e;
        cos_rom[888] = 20'h2b1f6; cos_rom[889] = 20'h2b697; cos_rom[890] = 20'h2bb32; cos_rom[891] = 20'h2bfc6;
        cos_rom[892] = 20'h2c453; cos_rom[893] = 20'h2c8d9; cos_rom[894] = 20'h2cd58; cos_rom[895] = 20'h2d1d0;
        cos_rom[896] = 20'h2d642; cos_rom[897] = 20'h2daac; cos_rom[898] = 20'h2df10; cos_rom[899] = 20'h2e36c;
        cos_rom[900] = 20'h2e7c1; cos_rom[901] = 20'h2ec0f; cos_rom[902] = 20'h2f056; cos_rom[903] = 20'h2f496;
        cos_rom[904] = 20'h2f8ce; cos_rom[905] = 20'h2fcff; cos_rom[906] = 20'h30128; cos_rom[907] = 20'h3054a;
        cos_rom[908] = 20'h30965; cos_rom[909] = 20'h30d78; cos_rom[910] = 20'h31184; cos_rom[911] = 20'h31588;
        cos_rom[912] = 20'h31984; cos_rom[913] = 20'h31d79; cos_rom[914] = 20'h32166; cos_rom[915] = 20'h3254c;
        cos_rom[916] = 20'h32929; cos_rom[917] = 20'h32cff; cos_rom[918] = 20'h330cd; cos_rom[919] = 20'h33493;
        cos_rom[920] = 20'h33852; cos_rom[921] = 20'h33c08; cos_rom[922] = 20'h33fb6; cos_rom[923] = 20'h3435d;
        cos_rom[924] = 20'h346fb; cos_rom[925] = 20'h34a91; cos_rom[926] = 20'h34e1f; cos_rom[927] = 20'h351a5;
        cos_rom[928] = 20'h35523; cos_rom[929] = 20'h35898; cos_rom[930] = 20'h35c05; cos_rom[931] = 20'h35f6a;
        cos_rom[932] = 20'h362c7; cos_rom[933] = 20'h3661b; cos_rom[934] = 20'h36967; cos_rom[935] = 20'h36caa;
        cos_rom[936] = 20'h36fe5; cos_rom[937] = 20'h37318; cos_rom[938] = 20'h37642; cos_rom[939] = 20'h37963;
        cos_rom[940] = 20'h37c7c; cos_rom[941] = 20'h37f8d; cos_rom[942] = 20'h38294; cos_rom[943] = 20'h38593;
        cos_rom[944] = 20'h38889; cos_rom[945] = 20'h38b77; cos_rom[946] = 20'h38e5c; cos_rom[947] = 20'h39138;
        cos_rom[948] = 20'h3940b; cos_rom[949] = 20'h396d6; cos_rom[950] = 20'h39997; cos_rom[951] = 20'h39c50;
        cos_rom[952] = 20'h39f00; cos_rom[953] = 20'h3a1a7; cos_rom[954] = 20'h3a444; cos_rom[955] = 20'h3a6d9;
        cos_rom[956] = 20'h3a965; cos_rom[957] = 20'h3abe8; cos_rom[958] = 20'h3ae62; cos_rom[959] = 20'h3b0d3;
        cos_rom[960] = 20'h3b33a; cos_rom[961] = 20'h3b599; cos_rom[962] = 20'h3b7ee; cos_rom[963] = 20'h3ba3a;
        cos_rom[964] = 20'h3bc7d; cos_rom[965] = 20'h3beb7; cos_rom[966] = 20'h3c0e7; cos_rom[967] = 20'h3c30f;
        cos_rom[968] = 20'h3c52d; cos_rom[969] = 20'h3c741; cos_rom[970] = 20'h3c94d; cos_rom[971] = 20'h3cb4f;
        cos_rom[972] = 20'h3cd47; cos_rom[973] = 20'h3cf36; cos_rom[974] = 20'h3d11c; cos_rom[975] = 20'h3d2f9;
        cos_rom[976] = 20'h3d4cc; cos_rom[977] = 20'h3d695; cos_rom[978] = 20'h3d855; cos_rom[979] = 20'h3da0c;
        cos_rom[980] = 20'h3dbb9; cos_rom[981] = 20'h3dd5d; cos_rom[982] = 20'h3def7; cos_rom[983] = 20'h3e087;
        cos_rom[984] = 20'h3e20e; cos_rom[985] = 20'h3e38b; cos_rom[986] = 20'h3e4ff; cos_rom[987] = 20'h3e669;
        cos_rom[988] = 20'h3e7ca; cos_rom[989] = 20'h3e920; cos_rom[990] = 20'h3ea6e; cos_rom[991] = 20'h3ebb1;
        cos_rom[992] = 20'h3eceb; cos_rom[993] = 20'h3ee1b; cos_rom[994] = 20'h3ef42; cos_rom[995] = 20'h3f05f;
        cos_rom[996] = 20'h3f172; cos_rom[997] = 20'h3f27b; cos_rom[998] = 20'h3f37b; cos_rom[999] = 20'h3f470;
        cos_rom[1000] = 20'h3f55c; cos_rom[1001] = 20'h3f63f; cos_rom[1002] = 20'h3f717; cos_rom[1003] = 20'h3f7e6;
        cos_rom[1004] = 20'h3f8ab; cos_rom[1005] = 20'h3f966; cos_rom[1006] = 20'h3fa18; cos_rom[1007] = 20'h3fabf;
        cos_rom[1008] = 20'h3fb5d; cos_rom[1009] = 20'h3fbf1; cos_rom[1010] = 20'h3fc7b; cos_rom[1011] = 20'h3fcfb;
        cos_rom[1012] = 20'h3fd72; cos_rom[1013] = 20'h3fdde; cos_rom[1014] = 20'h3fe41; cos_rom[1015] = 20'h3fe9a;
        cos_rom[1016] = 20'h3fee9; cos_rom[1017] = 20'h3ff2e; cos_rom[1018] = 20'h3ff69; cos_rom[1019] = 20'h3ff9b;
        cos_rom[1020] = 20'h3ffc2; cos_rom[1021] = 20'h3ffe0; cos_rom[1022] = 20'h3fff4; cos_rom[1023] = 20'h3fffe;
    end

    // table diffuse: light u16f16
    (* rom_style = "block" *)
    reg [15:0] diffuse_rom [0:1023];
    initial begin
        diffuse_rom[0] = 16'h19ad; diffuse_rom[1] = 16'h19d3; diffuse_rom[2] = 16'h19f9; diffuse_rom[3] = 16'h1a20;
        diffuse_rom[4] = 16'h1a46; diffuse_rom[5] = 16'h1a6d; diffuse_rom[6] = 16'h1a93; diffuse_rom[7] = 16'h1ab9;
        diffuse_rom[8] = 16'h1ae0; diffuse_rom[9] = 16'h1b06; diffuse_rom[10] = 16'h1b2d; diffuse_rom[11] = 16'h1b53;
        diffuse_rom[12] = 16'h1b79; diffuse_rom[13] = 16'h1ba0; diffuse_rom[14] = 16'h1bc6; diffuse_rom[15] = 16'h1bed;
        diffuse_rom[16] = 16'h1c13; diffuse_rom[17] = 16'h1c39; diffuse_rom[18] = 16'h1c60; diffuse_rom[19] = 16'h1c86;
        diffuse_rom[20] = 16'h1cad; diffuse_rom[21] = 16'h1cd3; diffuse_rom[22] = 16'h1cf9; diffuse_rom[23] = 16'h1d20;
        diffuse_rom[24] = 16'h1d46; diffuse_rom[25] = 16'h1d6d; diffuse_rom[26] = 16'h1d93; diffuse_rom[27] = 16'h1db9;
        diffuse_rom[28] = 16'h1de0; diffuse_rom[29] = 16'h1e06; diffuse_rom[30] = 16'h1e2d; diffuse_rom[31] = 16'h1e53;
        diffuse_rom[32] = 16'h1e79; diffuse_rom[33] = 16'h1ea0; diffuse_rom[34] = 16'h1ec6; diffuse_rom[35] = 16'h1eed;
        diffuse_rom[36] = 16'h1f13; diffuse_rom[37] = 16'h1f39; diffuse_rom[38] = 16'h1f60; diffuse_rom[39] = 16'h1f86;
        diffuse_rom[40] = 16'h1fad; diffuse_rom[41] = 16'h1fd3; diffuse_rom[42] = 16'h1ff9; diffuse_rom[43] = 16'h2020;
        diffuse_rom[44] = 16'h2046; diffuse_rom[45] = 16'h206d; diffuse_rom[46] = 16'h2093; diffuse_rom[47] = 16'h20b9;
        diffuse_rom[48] = 16'h20e0; diffuse_rom[49] = 16'h2106; diffuse_rom[50] = 16'h212d; diffuse_rom[51] = 16'h2153;
        diffuse_rom[52] = 16'h2179; diffuse_rom[53] = 16'h21a0; diffuse_rom[54] = 16'h21c6; diffuse_rom[55] = 16'h21ed;
        diffuse_rom[56] = 16'h2213; diffuse_rom[57] = 16'h2239; diffuse_rom[58] = 16'h2260; diffuse_rom[59] = 16'h2286;
        diffuse_rom[60] = 16'h22ad; diffuse_rom[61] = 16'h22d3; diffuse_rom[62] = 16'h22f9; diffuse_rom[63] = 16'h2320;
        diffuse_rom[64] = 16'h2346; diffuse_rom[65] = 16'h236d; diffuse_rom[66] = 16'h2393; diffuse_rom[67] = 16'h23b9;
        diffuse_rom[68] = 16'h23e0; diffuse_rom[69] = 16'h2406; diffuse_rom[70] = 16'h242d; diffuse_rom[71] = 16'h2453;
        diffuse_rom[72] = 16'h2479; diffuse_rom[73] = 16'h24a0; diffuse_rom[74] = 16'h24c6; diffuse_rom[75] = 16'h24ed;
        diffuse_rom[76] = 16'h2513; diffuse_rom[77] = 16'h2539; diffuse_rom[78] = 16'h2560; diffuse_rom[79] = 16'h2586;
        diffuse_rom[80] = 16'h25ad; diffuse_rom[81] = 16'h25d3; diffuse_rom[82] = 16'h25f9; diffuse_rom[83] = 16'h2620;
        diffuse_rom[84] = 16'h2646; diffuse_rom[85] = 16'h266d; diffuse_rom[86] = 16'h2693; diffuse_rom[87] = 16'h26b9;
        diffuse_rom[88] = 16'h26e0; diffuse_rom[89] = 16'h2706; diffuse_rom[90] = 16'h272d; diffuse_rom[91] = 16'h2753;
        diffuse_rom[92] = 16'h2779; diffuse_rom[93] = 16'h27a0; diffuse_rom[94] = 16'h27c6; diffuse_rom[95] = 16'h27ed;
        diffuse_rom[96] = 16'h2813; diffuse_rom[97] = 16'h2839; diffuse_rom[98] = 16'h2860; diffuse_rom[99] = 16'h2886;
        diffuse_rom[100] = 16'h28ad; diffuse_rom[101] = 16'h28d3; diffuse_rom[102] = 16'h28f9; diffuse_rom[103] = 16'h2920;
        diffuse_rom[104] = 16'h2946; diffuse_rom[105] = 16'h296d; diffuse_rom[106] = 16'h2993; diffuse_rom[107] = 16'h29b9;
        diffuse_rom[108] = 16'h29e0; diffuse_rom[109] = 16'h2a06; diffuse_rom[110] = 16'h2a2d; diffuse_rom[111] = 16'h2a53;
        diffuse_rom[112] = 16'h2a79; diffuse_rom[113] = 16'h2aa0; diffuse_rom[114] = 16'h2ac6; diffuse_rom[115] = 16'h2aed;
        diffuse_rom[116] = 16'h2b13; diffuse_rom[117] = 16'h2b39; diffuse_rom[118] = 16'h2b60; diffuse_rom[119] = 16'h2b86;
        diffuse_rom[120] = 16'h2bad; diffuse_rom[121] = 16'h2bd3; diffuse_rom[122] = 16'h2bf9; diffuse_rom[123] = 16'h2c20;
        diffuse_rom[124] = 16'h2c46; diffuse_rom[125] = 16'h2c6d; diffuse_rom[126] = 16'h2c93; diffuse_rom[127] = 16'h2cb9;
        diffuse_rom[128] = 16'h2ce0; diffuse_rom[129] = 16'h2d06; diffuse_rom[130] = 16'h2d2d; diffuse_rom[131] = 16'h2d53;
        diffuse_rom[132] = 16'h2d79; diffuse_rom[133] = 16'h2da0; diffuse_rom[134] = 16'h2dc6; diffuse_rom[135] = 16'h2ded;
        diffuse_rom[136] = 16'h2e13; diffuse_rom[137] = 16'h2e39; diffuse_rom[138] = 16'h2e60; diffuse_rom[139] = 16'h2e86;
        diffuse_rom[140] = 16'h2ead; diffuse_rom[141] = 16'h2ed3; diffuse_rom[142] = 16'h2ef9; diffuse_rom[143] = 16'h2f20;
        diffuse_rom[144] = 16'h2f46; diffuse_rom[145] = 16'h2f6d; diffuse_rom[146] = 16'h2f93; diffuse_rom[147] = 16'h2fb9;
        diffuse_rom[148] = 16'h2fe0; diffuse_rom[149] = 16'h3006; diffuse_rom[150] = 16'h302d; diffuse_rom[151] = 16'h3053;
        diffuse_rom[152] = 16'h3079; diffuse_rom[153] = 16'h30a0; diffuse_rom[154] = 16'h30c6; diffuse_rom[155] = 16'h30ed;
        diffuse_rom[156] = 16'h3113; diffuse_rom[157] = 16'h3139; diffuse_rom[158] = 16'h3160; diffuse_rom[159] = 16'h3186;
        diffuse_rom[160] = 16'h31ad; diffuse_rom[161] = 16'h31d3; diffuse_rom[162] = 16'h31f9; diffuse_rom[163] = 16'h3220;
        diffuse_rom[164] = 16'h3246; diffuse_rom[165] = 16'h326d; diffuse_rom[166] = 16'h3293; diffuse_rom[167] = 16'h32b9;
        diffuse_rom[168] = 16'h32e0; diffuse_rom[169] = 16'h3306; diffuse_rom[170] = 16'h332d; diffuse_rom[171] = 16'h3353;
        diffuse_rom[172] = 16'h3379; diffuse_rom[173] = 16'h33a0; diffuse_rom[174] = 16'h33c6; diffuse_rom[175] = 16'h33ed;
        diffuse_rom[176] = 16'h3413; diffuse_rom[177] = 16'h3439; diffuse_rom[178] = 16'h3460; diffuse_rom[179] = 16'h3486;
        diffuse_rom[180] = 16'h34ad; diffuse_rom[181] = 16'h34d3; diffuse_rom[182] = 16'h34f9; diffuse_rom[183] = 16'h3520;
        diffuse_rom[184] = 16'h3546; diffuse_rom[185] = 16'h356d; diffuse_rom[186] = 16'h3593; diffuse_rom[187] = 16'h35b9;
        diffuse_rom[188] = 16'h35e0; diffuse_rom[189] = 16'h3606; diffuse_rom[190] = 16'h362d; diffuse_rom[191] = 16'h3653;
        diffuse_rom[192] = 16'h3679; diffuse_rom[193] = 16'h36a0; diffuse_rom[194] = 16'h36c6; diffuse_rom[195] = 16'h36ed;
        diffuse_rom[196] = 16'h3713; diffuse_rom[197] = 16'h3739; diffuse_rom[198] = 16'h3760; diffuse_rom[199] = 16'h3786;
        diffuse_rom[200] = 16'h37ad; diffuse_rom[201] = 16'h37d3; diffuse_rom[202] = 16'h37f9; diffuse_rom[203] = 16'h3820;
        diffuse_rom[204] = 16'h3846; diffuse_rom[205] = 16'h386d; diffuse_rom[206] = 16'h3893; diffuse_rom[207] = 16'h38b9;
        diffuse_rom[208] = 16'h38e0; diffuse_rom[209] = 16'h3906; diffuse_rom[210] = 16'h392d; diffuse_rom[211] = 16'h3953;
        diffuse_rom[212] = 16'h3979; diffuse_rom[213] = 16'h39a0; diffuse_rom[214] = 16'h39c6; diffuse_rom[215] = 16'h39ed;
        diffuse_rom[216] = 16'h3a13; diffuse_rom[217] = 16'h3a39; diffuse_rom[218] = 16'h3a60; diffuse_rom[219] = 16'h3a86;
        diffuse_rom[220] = 16'h3aad; diffuse_rom[221] = 16'h3ad3; diffuse_rom[222] = 16'h3af9; diffuse_rom[223] = 16'h3b20;
        diffuse_rom[224] = 16'h3b46; diffuse_rom[225] = 16'h3b6d; diffuse_rom[226] = 16'h3b93; diffuse_rom[227] = 16'h3bb9;
        diffuse_rom[228] = 16'h3be0; diffuse_rom[229] = 16'h3c06; diffuse_rom[230] = 16'h3c2d; diffuse_rom[231] = 16'h3c53;
        diffuse_rom[232] = 16'h3c79; diffuse_rom[233] = 16'h3ca0; diffuse_rom[234] = 16'h3cc6; diffuse_rom[235] = 16'h3ced;
        diffuse_rom[236] = 16'h3d13; diffuse_rom[237] = 16'h3d39; diffuse_rom[238] = 16'h3d60; diffuse_rom[239] = 16'h3d86;
        diffuse_rom[240] = 16'h3dad; diffuse_rom[241] = 16'h3dd3; diffuse_rom[242] = 16'h3df9; diffuse_rom[243] = 16'h3e20;
        diffuse_rom[244] = 16'h3e46; diffuse_rom[245] = 16'h3e6d; diffuse_rom[246] = 16'h3e93; diffuse_rom[247] = 16'h3eb9;
        diffuse_rom[248] = 16'h3ee0; diffuse_rom[249] = 16'h3f06; diffuse_rom[250] = 16'h3f2d; diffuse_rom[251] = 16'h3f53;
        diffuse_rom[252] = 16'h3f79; diffuse_rom[253] = 16'h3fa0; diffuse_rom[254] = 16'h3fc6; diffuse_rom[255] = 16'h3fed;
        diffuse_rom[256] = 16'h4013; diffuse_rom[257] = 16'h4039; diffuse_rom[258] = 16'h4060; diffuse_rom[259] = 16'h4086;
        diffuse_rom[260] = 16'h40ac; diffuse_rom[261] = 16'h40d3; diffuse_rom[262] = 16'h40f9; diffuse_rom[263] = 16'h4120;
        diffuse_rom[264] = 16'h4146; diffuse_rom[265] = 16'h416c; diffuse_rom[266] = 16'h4193; diffuse_rom[267] = 16'h41b9;
        diffuse_rom[268] = 16'h41e0; diffuse_rom[269] = 16'h4206; diffuse_rom[270] = 16'h422c; diffuse_rom[271] = 16'h4253;
        diffuse_rom[272] = 16'h4279; diffuse_rom[273] = 16'h42a0; diffuse_rom[274] = 16'h42c6; diffuse_rom[275] = 16'h42ec;
        diffuse_rom[276] = 16'h4313; diffuse_rom[277] = 16'h4339; diffuse_rom[278] = 16'h4360; diffuse_rom[279] = 16'h4386;
        diffuse_rom[280] = 16'h43ac; diffuse_rom[281] = 16'h43d3; diffuse_rom[282] = 16'h43f9; diffuse_rom[283] = 16'h4420;
        diffuse_rom[284] = 16'h4446; diffuse_rom[285] = 16'h446c; diffuse_rom[286] = 16'h4493; diffuse_rom[287] = 16'h44b9;
        diffuse_rom[288] = 16'h44e0; diffuse_rom[289] = 16'h4506; diffuse_rom[290] = 16'h452c; diffuse_rom[291] = 16'h4553;
        diffuse_rom[292] = 16'h4579; diffuse_rom[293] = 16'h45a0; diffuse_rom[294] = 16'h45c6; diffuse_rom[295] = 16'h45ec;
        diffuse_rom[296] = 16'h4613; diffuse_rom[297] = 16'h4639; diffuse_rom[298] = 16'h4660; diffuse_rom[299] = 16'h4686;
        diffuse_rom[300] = 16'h46ac; diffuse_rom[301] = 16'h46d3; diffuse_rom[302] = 16'h46f9; diffuse_rom[303] = 16'h4720;
        diffuse_rom[304] = 16'h4746; diffuse_rom[305] = 16'h476c; diffuse_rom[306] = 16'h4793; diffuse_rom[307] = 16'h47b9;
        diffuse_rom[308] = 16'h47e0; diffuse_rom[309] = 16'h4806; diffuse_rom[310] = 16'h482c; diffuse_rom[311] = 16'h4853;
        diffuse_rom[312] = 16'h4879; diffuse_rom[313] = 16'h48a0; diffuse_rom[314] = 16'h48c6; diffuse_rom[315] = 16'h48ec;
        diffuse_rom[316] = 16'h4913; diffuse_rom[317] = 16'h4939; diffuse_rom[318] = 16'h4960; diffuse_rom[319] = 16'h4986;
        diffuse_rom[320] = 16'h49ac; diffuse_rom[321] = 16'h49d3; diffuse_rom[322] = 16'h49f9; diffuse_rom[323] = 16'h4a20;
        diffuse_rom[324] = 16'h4a46; diffuse_rom[325] = 16'h4a6c; diffuse_rom[326] = 16'h4a93; diffuse_rom[327] = 16'h4ab9;
        diffuse_rom[328] = 16'h4ae0; diffuse_rom[329] = 16'h4b06; diffuse_rom[330] = 16'h4b2c; diffuse_rom[331] = 16'h4b53;
        diffuse_rom[332] = 16'h4b79; diffuse_rom[333] = 16'h4ba0; diffuse_rom[334] = 16'h4bc6; diffuse_rom[335] = 16'h4bec;
        diffuse_rom[336] = 16'h4c13; diffuse_rom[337] = 16'h4c39; diffuse_rom[338] = 16'h4c60; diffuse_rom[339] = 16'h4c86;
        diffuse_rom[340] = 16'h4cac; diffuse_rom[341] = 16'h4cd3; diffuse_rom[342] = 16'h4cf9; diffuse_rom[343] = 16'h4d20;
        diffuse_rom[344] = 16'h4d46; diffuse_rom[345] = 16'h4d6c; diffuse_rom[346] = 16'h4d93; diffuse_rom[347] = 16'h4db9;
        diffuse_rom[348] = 16'h4de0; diffuse_rom[349] = 16'h4e06; diffuse_rom[350] = 16'h4e2c; diffuse_rom[351] = 16'h4e53;
        diffuse_rom[352] = 16'h4e79; diffuse_rom[353] = 16'h4ea0; diffuse_rom[354] = 16'h4ec6; diffuse_rom[355] = 16'h4eec;
        diffuse_rom[356] = 16'h4f13; diffuse_rom[357] = 16'h4f39; diffuse_rom[358] = 16'h4f60; diffuse_rom[359] = 16'h4f86;
        diffuse_rom[360] = 16'h4fac; diffuse_rom[361] = 16'h4fd3; diffuse_rom[362] = 16'h4ff9; diffuse_rom[363] = 16'h5020;
        diffuse_rom[364] = 16'h5046; diffuse_rom[365] = 16'h506c; diffuse_rom[366] = 16'h5093; diffuse_rom[367] = 16'h50b9;
        diffuse_rom[368] = 16'h50e0; diffuse_rom[369] = 16'h5106; diffuse_rom[370] = 16'h512c; diffuse_rom[371] = 16'h5153;
        diffuse_rom[372] = 16'h5179; diffuse_rom[373] = 16'h51a0; diffuse_rom[374] = 16'h51c6; diffuse_rom[375] = 16'h51ec;
        diffuse_rom[376] = 16'h5213; diffuse_rom[377] = 16'h5239; diffuse_rom[378] = 16'h5260; diffuse_rom[379] = 16'h5286;
        diffuse_rom[380] = 16'h52ac; diffuse_rom[381] = 16'h52d3; diffuse_rom[382] = 16'h52f9; diffuse_rom[383] = 16'h5320;
        diffuse_rom[384] = 16'h5346; diffuse_rom[385] = 16'h536c; diffuse_rom[386] = 16'h5393; diffuse_rom[387] = 16'h53b9;
        diffuse_rom[388] = 16'h53e0; diffuse_rom[389] = 16'h5406; diffuse_rom[390] = 16'h542c; diffuse_rom[391] = 16'h5453;
        diffuse_rom[392] = 16'h5479; diffuse_rom[393] = 16'h54a0; diffuse_rom[394] = 16'h54c6; diffuse_rom[395] = 16'h54ec;
        diffuse_rom[396] = 16'h5513; diffuse_rom[397] = 16'h5539; diffuse_rom[398] = 16'h5560; diffuse_rom[399] = 16'h5586;
        diffuse_rom[400] = 16'h55ac; diffuse_rom[401] = 16'h55d3; diffuse_rom[402] = 16'h55f9; diffuse_rom[403] = 16'h5620;
        diffuse_rom[404] = 16'h5646; diffuse_rom[405] = 16'h566c; diffuse_rom[406] = 16'h5693; diffuse_rom[407] = 16'h56b9;
        diffuse_rom[408] = 16'h56e0; diffuse_rom[409] = 16'h5706; diffuse_rom[410] = 16'h572c; diffuse_rom[411] = 16'h5753;
        diffuse_rom[412] = 16'h5779; diffuse_rom[413] = 16'h57a0; diffuse_rom[414] = 16'h57c6; diffuse_rom[415] = 16'h57ec;
        diffuse_rom[416] = 16'h5813; diffuse_rom[417] = 16'h5839; diffuse_rom[418] = 16'h5860; diffuse_rom[419] = 16'h5886;
        diffuse_rom[420] = 16'h58ac; diffuse_rom[421] = 16'h58d3; diffuse_rom[422] = 16'h58f9; diffuse_rom[423] = 16'h5920;
        diffuse_rom[424] = 16'h5946; diffuse_rom[425] = 16'h596c; diffuse_rom[426] = 16'h5993; diffuse_rom[427] = 16'h59b9;
        diffuse_rom[428] = 16'h59e0; diffuse_rom[429] = 16'h5a06; diffuse_rom[430] = 16'h5a2c; diffuse_rom[431] = 16'h5a53;
        diffuse_rom[432] = 16'h5a79; diffuse_rom[433] = 16'h5aa0; diffuse_rom[434] = 16'h5ac6; diffuse_rom[435] = 16'h5aec;
        diffuse_rom[436] = 16'h5b13; diffuse_rom[437] = 16'h5b39; diffuse_rom[438] = 16'h5b60; diffuse_rom[439] = 16'h5b86;
        diffuse_rom[440] = 16'h5bac; diffuse_rom[441] = 16'h5bd3; diffuse_rom[442] = 16'h5bf9; diffuse_rom[443] = 16'h5c20;
        diffuse_rom[444] = 16'h5c46; diffuse_rom[445] = 16'h5c6c; diffuse_rom[446] = 16'h5c93; diffuse_rom[447] = 16'h5cb9;
        diffuse_rom[448] = 16'h5ce0; diffuse_rom[449] = 16'h5d06; diffuse_rom[450] = 16'h5d2c; diffuse_rom[451] = 16'h5d53;
        diffuse_rom[452] = 16'h5d79; diffuse_rom[453] = 16'h5da0; diffuse_rom[454] = 16'h5dc6; diffuse_rom[455] = 16'h5dec;
        diffuse_rom[456] = 16'h5e13; diffuse_rom[457] = 16'h5e39; diffuse_rom[458] = 16'h5e60; diffuse_rom[459] = 16'h5e86;
        diffuse_rom[460] = 16'h5eac; diffuse_rom[461] = 16'h5ed3; diffuse_rom[462] = 16'h5ef9; diffuse_rom[463] = 16'h5f20;
        diffuse_rom[464] = 16'h5f46; diffuse_rom[465] = 16'h5f6c; diffuse_rom[466] = 16'h5f93; diffuse_rom[467] = 16'h5fb9;
        diffuse_rom[468] = 16'h5fe0; diffuse_rom[469] = 16'h6006; diffuse_rom[470] = 16'h602c; diffuse_rom[471] = 16'h6053;
        diffuse_rom[472] = 16'h6079; diffuse_rom[473] = 16'h60a0; diffuse_rom[474] = 16'h60c6; diffuse_rom[475] = 16'h60ec;
        diffuse_rom[476] = 16'h6113; diffuse_rom[477] = 16'h6139; diffuse_rom[478] = 16'h6160; diffuse_rom[479] = 16'h6186;
        diffuse_rom[480] = 16'h61ac; diffuse_rom[481] = 16'h61d3; diffuse_rom[482] = 16'h61f9; diffuse_rom[483] = 16'h6220;
        diffuse_rom[484] = 16'h6246; diffuse_rom[485] = 16'h626c; diffuse_rom[486] = 16'h6293; diffuse_rom[487] = 16'h62b9;
        diffuse_rom[488] = 16'h62e0; diffuse_rom[489] = 16'h6306; diffuse_rom[490] = 16'h632c; diffuse_rom[491] = 16'h6353;
        diffuse_rom[492] = 16'h6379; diffuse_rom[493] = 16'h63a0; diffuse_rom[494] = 16'h63c6; diffuse_rom[495] = 16'h63ec;
        diffuse_rom[496] = 16'h6413; diffuse_rom[497] = 16'h6439; diffuse_rom[498] = 16'h6460; diffuse_rom[499] = 16'h6486;
        diffuse_rom[500] = 16'h64ac; diffuse_rom[501] = 16'h64d3; diffuse_rom[502] = 16'h64f9; diffuse_rom[503] = 16'h6520;
        diffuse_rom[504] = 16'h6546; diffuse_rom[505] = 16'h656c; diffuse_rom[506] = 16'h6593; diffuse_rom[507] = 16'h65b9;
        diffuse_rom[508] = 16'h65e0; diffuse_rom[509] = 16'h6606; diffuse_rom[510] = 16'h662c; diffuse_rom[511] = 16'h6653;
        diffuse_rom[512] = 16'h6679; diffuse_rom[513] = 16'h66a0; diffuse_rom[514] = 16'h66c6; diffuse_rom[515] = 16'h66ec;
        diffuse_rom[516] = 16'h6713; diffuse_rom[517] = 16'h6739; diffuse_rom[518] = 16'h6760; diffuse_rom[519] = 16'h6786;
        diffuse_rom[520] = 16'h67ac; diffuse_rom[521] = 16'h67d3; diffuse_rom[522] = 16'h67f9; diffuse_rom[523] = 16'h6820;
        diffuse_rom[524] = 16'h6846; diffuse_rom[525] = 16'h686c; diffuse_rom[526] = 16'h6893; diffuse_rom[527] = 16'h68b9;
        diffuse_rom[528] = 16'h68e0; diffuse_rom[529] = 16'h6906; diffuse_rom[530] = 16'h692c; diffuse_rom[531] = 16'h6953;
        diffuse_rom[532] = 16'h6979; diffuse_rom[533] = 16'h69a0; diffuse_rom[534] = 16'h69c6; diffuse_rom[535] = 16'h69ec;
        diffuse_rom[536] = 16'h6a13; diffuse_rom[537] = 16'h6a39; diffuse_rom[538] = 16'h6a60; diffuse_rom[539] = 16'h6a86;
        diffuse_rom[540] = 16'h6aac; diffuse_rom[541] = 16'h6ad3; diffuse_rom[542] = 16'h6af9; diffuse_rom[543] = 16'h6b20;
        diffuse_rom[544] = 16'h6b46; diffuse_rom[545] = 16'h6b6c; diffuse_rom[546] = 16'h6b93; diffuse_rom[547] = 16'h6bb9;
        diffuse_rom[548] = 16'h6be0; diffuse_rom[549] = 16'h6c06; diffuse_rom[550] = 16'h6c2c; diffuse_rom[551] = 16'h6c53;
        diffuse_rom[552] = 16'h6c79; diffuse_rom[553] = 16'h6ca0; diffuse_rom[554] = 16'h6cc6; diffuse_rom[555] = 16'h6cec;
        diffuse_rom[556] = 16'h6d13; diffuse_rom[557] = 16'h6d39; diffuse_rom[558] = 16'h6d60; diffuse_rom[559] = 16'h6d86;
        diffuse_rom[560] = 16'h6dac; diffuse_rom[561] = 16'h6dd3; diffuse_rom[562] = 16'h6df9; diffuse_rom[563] = 16'h6e20;
        diffuse_rom[564] = 16'h6e46; diffuse_rom[565] = 16'h6e6c; diffuse_rom[566] = 16'h6e93; diffuse_rom[567] = 16'h6eb9;
        diffuse_rom[568] = 16'h6ee0; diffuse_rom[569] = 16'h6f06; diffuse_rom[570] = 16'h6f2c; diffuse_rom[571] = 16'h6f53;
        diffuse_rom[572] = 16'h6f79; diffuse_rom[573] = 16'h6fa0; diffuse_rom[574] = 16'h6fc6; diffuse_rom[575] = 16'h6fec;
        diffuse_rom[576] = 16'h7013; diffuse_rom[577] = 16'h7039; diffuse_rom[578] = 16'h7060; diffuse_rom[579] = 16'h7086;
        diffuse_rom[580] = 16'h70ac; diffuse_rom[581] = 16'h70d3; diffuse_rom[582] = 16'h70f9; diffuse_rom[583] = 16'h7120;
        diffuse_rom[584] = 16'h7146; diffuse_rom[585] = 16'h716c; diffuse_rom[586] = 16'h7193; diffuse_rom[587] = 16'h71b9;
        diffuse_rom[588] = 16'h71e0; diffuse_rom[589] = 16'h7206; diffuse_rom[590] = 16'h722c; diffuse_rom[591] = 16'h7253;
        diffuse_rom[592] = 16'h7279; diffuse_rom[593] = 16'h72a0; diffuse_rom[594] = 16'h72c6; diffuse_rom[595] = 16'h72ec;
        diffuse_rom[596] = 16'h7313; diffuse_rom[597] = 16'h7339; diffuse_rom[598] = 16'h7360; diffuse_rom[599] = 16'h7386;
        diffuse_rom[600] = 16'h73ac; diffuse_rom[601] = 16'h73d3; diffuse_rom[602] = 16'h73f9; diffuse_rom[603] = 16'h7420;
        diffuse_rom[604] = 16'h7446; diffuse_rom[605] = 16'h746c; diffuse_rom[606] = 16'h7493; diffuse_rom[607] = 16'h74b9;
        diffuse_rom[608] = 16'h74e0; diffuse_rom[609] = 16'h7506; diffuse_rom[610] = 16'h752c; diffuse_rom[611] = 16'h7553;
        diffuse_rom[612] = 16'h7579; diffuse_rom[613] = 16'h75a0; diffuse_rom[614] = 16'h75c6; diffuse_rom[615] = 16'h75ec;
        diffuse_rom[616] = 16'h7613; diffuse_rom[617] = 16'h7639; diffuse_rom[618] = 16'h7660; diffuse_rom[619] = 16'h7686;
        diffuse_rom[620] = 16'h76ac; diffuse_rom[621] = 16'h76d3; diffuse_rom[622] = 16'h76f9; diffuse_rom[623] = 16'h7720;
        diffuse_rom[624] = 16'h7746; diffuse_rom[625] = 16'h776c; diffuse_rom[626] = 16'h7793; diffuse_rom[627] = 16'h77b9;
        diffuse_rom[628] = 16'h77e0; diffuse_rom[629] = 16'h7806; diffuse_rom[630] = 16'h782c; diffuse_rom[631] = 16'h7853;
        diffuse_rom[632] = 16'h7879; diffuse_rom[633] = 16'h78a0; diffuse_rom[634] = 16'h78c6; diffuse_rom[635] = 16'h78ec;
        diffuse_rom[636] = 16'h7913; diffuse_rom[637] = 16'h7939; diffuse_rom[638] = 16'h7960; diffuse_rom[639] = 16'h7986;
        diffuse_rom[640] = 16'h79ac; diffuse_rom[641] = 16'h79d3; diffuse_rom[642] = 16'h79f9; diffuse_rom[643] = 16'h7a20;
        diffuse_rom[644] = 16'h7a46; diffuse_rom[645] = 16'h7a6c; diffuse_rom[646] = 16'h7a93; diffuse_rom[647] = 16'h7ab9;
        diffuse_rom[648] = 16'h7ae0; diffuse_rom[649] = 16'h7b06; diffuse_rom[650] = 16'h7b2c; diffuse_rom[651] = 16'h7b53;
        diffuse_rom[652] = 16'h7b79; diffuse_rom[653] = 16'h7ba0; diffuse_rom[654] = 16'h7bc6; diffuse_rom[655] = 16'h7bec;
        diffuse_rom[656] = 16'h7c13; diffuse_rom[657] = 16'h7c39; diffuse_rom[658] = 16'h7c60; diffuse_rom[659] = 16'h7c86;
        diffuse_rom[660] = 16'h7cac; diffuse_rom[661] = 16'h7cd3; diffuse_rom[662] = 16'h7cf9; diffuse_rom[663] = 16'h7d20;
        diffuse_rom[664] = 16'h7d46; diffuse_rom[665] = 16'h7d6c; diffuse_rom[666] = 16'h7d93; diffuse_rom[667] = 16'h7db9;
        diffuse_rom[668] = 16'h7de0; diffuse_rom[669] = 16'h7e06; diffuse_rom[670] = 16'h7e2c; diffuse_rom[671] = 16'h7e53;
        diffuse_rom[672] = 16'h7e79; diffuse_rom[673] = 16'h7ea0; diffuse_rom[674] = 16'h7ec6; diffuse_rom[675] = 16'h7eec;
        diffuse_rom[676] = 16'h7f13; diffuse_rom[677] = 16'h7f39; diffuse_rom[678] = 16'h7f60; diffuse_rom[679] = 16'h7f86;
        diffuse_rom[680] = 16'h7fac; diffuse_rom[681] = 16'h7fd3; diffuse_rom[682] = 16'h7ff9; diffuse_rom[683] = 16'h8020;
        diffuse_rom[684] = 16'h8046; diffuse_rom[685] = 16'h806c; diffuse_rom[686] = 16'h8093; diffuse_rom[687] = 16'h80b9;
        diffuse_rom[688] = 16'h80e0; diffuse_rom[689] = 16'h8106; diffuse_rom[690] = 16'h812c; diffuse_rom[691] = 16'h8153;
        diffuse_rom[692] = 16'h8179; diffuse_rom[693] = 16'h81a0; diffuse_rom[694] = 16'h81c6; diffuse_rom[695] = 16'h81ec;
        diffuse_rom[696] = 16'h8213; diffuse_rom[697] = 16'h8239; diffuse_rom[698] = 16'h8260; diffuse_rom[699] = 16'h8286;
        diffuse_rom[700] = 16'h82ac; diffuse_rom[701] = 16'h82d3; diffuse_rom[702] = 16'h82f9; diffuse_rom[703] = 16'h8320;
        diffuse_rom[704] = 16'h8346; diffuse_rom[705] = 16'h836c; diffuse_rom[706] = 16'h8393; diffuse_rom[707] = 16'h83b9;
        diffuse_rom[708] = 16'h83e0; diffuse_rom[709] = 16'h8406; diffuse_rom[710] = 16'h842c; diffuse_rom[711] = 16'h8453;
        diffuse_rom[712] = 16'h8479; diffuse_rom[713] = 16'h84a0; diffuse_rom[714] = 16'h84c6; diffuse_rom[715] = 16'h84ec;
        diffuse_rom[716] = 16'h8513; diffuse_rom[717] = 16'h8539; diffuse_rom[718] = 16'h8560; diffuse_rom[719] = 16'h8586;
        diffuse_rom[720] = 16'h85ac; diffuse_rom[721] = 16'h85d3; diffuse_rom[722] = 16'h85f9; diffuse_rom[723] = 16'h8620;
        diffuse_rom[724] = 16'h8646; diffuse_rom[725] = 16'h866c; diffuse_rom[726] = 16'h8693; diffuse_rom[727] = 16'h86b9;
        diffuse_rom[728] = 16'h86e0; diffuse_rom[729] = 16'h8706; diffuse_rom[730] = 16'h872c; diffuse_rom[731] = 16'h8753;
        diffuse_rom[732] = 16'h8779; diffuse_rom[733] = 16'h87a0; diffuse_rom[734] = 16'h87c6; diffuse_rom[735] = 16'h87ec;
        diffuse_rom[736] = 16'h8813; diffuse_rom[737] = 16'h8839; diffuse_rom[738] = 16'h8860; diffuse_rom[739] = 16'h8886;
        diffuse_rom[740] = 16'h88ac; diffuse_rom[741] = 16'h88d3; diffuse_rom[742] = 16'h88f9; diffuse_rom[743] = 16'h8920;
        diffuse_rom[744] = 16'h8946; diffuse_rom[745] = 16'h896c; diffuse_rom[746] = 16'h8993; diffuse_rom[747] = 16'h89b9;
        diffuse_rom[748] = 16'h89e0; diffuse_rom[749] = 16'h8a06; diffuse_rom[750] = 16'h8a2c; diffuse_rom[751] = 16'h8a53;
        diffuse_rom[752] = 16'h8a79; diffuse_rom[753] = 16'h8aa0; diffuse_rom[754] = 16'h8ac6; diffuse_rom[755] = 16'h8aec;
        diffuse_rom[756] = 16'h8b13; diffuse_rom[757] = 16'h8b39; diffuse_rom[758] = 16'h8b60; diffuse_rom[759] = 16'h8b86;
        diffuse_rom[760] = 16'h8bac; diffuse_rom[761] = 16'h8bd3; diffuse_rom[762] = 16'h8bf9; diffuse_rom[763] = 16'h8c20;
        diffuse_rom[764] = 16'h8c46; diffuse_rom[765] = 16'h8c6c; diffuse_rom[766] = 16'h8c93; diffuse_rom[767] = 16'h8cb9;
        diffuse_rom[768] = 16'h8ce0; diffuse_rom[769] = 16'h8d06; diffuse_rom[770] = 16'h8d2c; diffuse_rom[771] = 16'h8d53;
        diffuse_rom[772] = 16'h8d79; diffuse_rom[773] = 16'h8da0; diffuse_rom[774] = 16'h8dc6; diffuse_rom[775] = 16'h8dec;
        diffuse_rom[776] = 16'h8e13; diffuse_rom[777] = 16'h8e39; diffuse_rom[778] = 16'h8e60; diffuse_rom[779] = 16'h8e86;
        diffuse_rom[780] = 16'h8eac; diffuse_rom[781] = 16'h8ed3; diffuse_rom[782] = 16'h8ef9; diffuse_rom[783] = 16'h8f20;
        diffuse_rom[784] = 16'h8f46; diffuse_rom[785] = 16'h8f6c; diffuse_rom[786] = 16'h8f93; diffuse_rom[787] = 16'h8fb9;
        diffuse_rom[788] = 16'h8fe0; diffuse_rom[789] = 16'h9006; diffuse_rom[790] = 16'h902c; diffuse_rom[791] = 16'h9053;
        diffuse_rom[792] = 16'h9079; diffuse_rom[793] = 16'h90a0; diffuse_rom[794] = 16'h90c6; diffuse_rom[795] = 16'h90ec;
        diffuse_rom[796] = 16'h9113; diffuse_rom[797] = 16'h9139; diffuse_rom[798] = 16'h9160; diffuse_rom[799] = 16'h9186;
        diffuse_rom[800] = 16'h91ac; diffuse_rom[801] = 16'h91d3; diffuse_rom[802] = 16'h91f9; diffuse_rom[803] = 16'h9220;
        diffuse_rom[804] = 16'h9246; diffuse_rom[805] = 16'h926c; diffuse_rom[806] = 16'h9293; diffuse_rom[807] = 16'h92b9;
        diffuse_rom[808] = 16'h92e0; diffuse_rom[809] = 16'h9306; diffuse_rom[810] = 16'h932c; diffuse_rom[811] = 16'h9353;
        diffuse_rom[812] = 16'h9379; diffuse_rom[813] = 16'h93a0; diffuse_rom[814] = 16'h93c6; diffuse_rom[815] = 16'h93ec;
        diffuse_rom[816] = 16'h9413; diffuse_rom[817] = 16'h9439; diffuse_rom[818] = 16'h9460; diffuse_rom[819] = 16'h9486;
        diffuse_rom[820] = 16'h94ac; diffuse_rom[821] = 16'h94d3; diffuse_rom[822] = 16'h94f9; diffuse_rom[823] = 16'h9520;
        diffuse_rom[824] = 16'h9546; diffuse_rom[825] = 16'h956c; diffuse_rom[826] = 16'h9593; diffuse_rom[827] = 16'h95b9;
        diffuse_rom[828] = 16'h95e0; diffuse_rom[829] = 16'h9606; diffuse_rom[830] = 16'h962c; diffuse_rom[831] = 16'h9653;
        diffuse_rom[832] = 16'h9679; diffuse_rom[833] = 16'h96a0; diffuse_rom[834] = 16'h96c6; diffuse_rom[835] = 16'h96ec;
        diffuse_rom[836] = 16'h9713; diffuse_rom[837] = 16'h9739; diffuse_rom[838] = 16'h9760; diffuse_rom[839] = 16'h9786;
        diffuse_rom[840] = 16'h97ac; diffuse_rom[841] = 16'h97d3; diffuse_rom[842] = 16'h97f9; diffuse_rom[843] = 16'h9820;
        diffuse_rom[844] = 16'h9846; diffuse_rom[845] = 16'h986c; diffuse_rom[846] = 16'h9893; diffuse_rom[847] = 16'h98b9;
        diffuse_rom[848] = 16'h98e0; diffuse_rom[849] = 16'h9906; diffuse_rom[850] = 16'h992c; diffuse_rom[851] = 16'h9953;
        diffuse_rom[852] = 16'h9979; diffuse_rom[853] = 16'h99a0; diffuse_rom[854] = 16'h99c6; diffuse_rom[855] = 16'h99ec;
        diffuse_rom[856] = 16'h9a13; diffuse_rom[857] = 16'h9a39; diffuse_rom[858] = 16'h9a60; diffuse_rom[859] = 16'h9a86;
        diffuse_rom[860] = 16'h9aac; diffuse_rom[861] = 16'h9ad3; diffuse_rom[862] = 16'h9af9; diffuse_rom[863] = 16'h9b20;
        diffuse_rom[864] = 16'h9b46; diffuse_rom[865] = 16'h9b6c; diffuse_rom[866] = 16'h9b93; diffuse_rom[867] = 16'h9bb9;
        diffuse_rom[868] = 16'h9be0; diffuse_rom[869] = 16'h9c06; diffuse_rom[870] = 16'h9c2c; diffuse_rom[871] = 16'h9c53;
        diffuse_rom[872] = 16'h9c79; diffuse_rom[873] = 16'h9ca0; diffuse_rom[874] = 16'h9cc6; diffuse_rom[875] = 16'h9cec;
        diffuse_rom[876] = 16'h9d13; diffuse_rom[877] = 16'h9d39; diffuse_rom[878] = 16'h9d60; diffuse_rom[879] = 16'h9d86;
        diffuse_rom[880] = 16'h9dac; diffuse_rom[881] = 16'h9dd3; diffuse_rom[882] = 16'h9df9; diffuse_rom[883] = 16'h9e20;
        diffuse_rom[884] = 16'h9e46; diffuse_rom[885] = 16'h9e6c; diffuse_rom[886] = 16'h9e93; diffuse_rom[887] = 16'h9eb9;
        diffuse_rom[888] = 16'h9ee0; diffuse_rom[889] = 16'h9f06; diffuse_rom[890] = 16'h9f2c; diffuse_rom[891] = 16'h9f53;
        diffuse_rom[892] = 16'h9f79; diffuse_rom[893] = 16'h9fa0; diffuse_rom[894] = 16'h9fc6; diffuse_rom[895] = 16'h9fec;
        diffuse_rom[896] = 16'ha013; diffuse_rom[897] = 16'ha039; diffuse_rom[898] = 16'ha060; diffuse_rom[899] = 16'ha086;
        diffuse_rom[900] = 16'ha0ac; diffuse_rom[901] = 16'ha0d3; diffuse_rom[902] = 16'ha0f9; diffuse_rom[903] = 16'ha120;
        diffuse_rom[904] = 16'ha146; diffuse_rom[905] = 16'ha16c; diffuse_rom[906] = 16'ha193; diffuse_rom[907] = 16'ha1b9;
        diffuse_rom[908] = 16'ha1e0; diffuse_rom[909] = 16'ha206; diffuse_rom[910] = 16'ha22c; diffuse_rom[911] = 16'ha253;
        diffuse_rom[912] = 16'ha279; diffuse_rom[913] = 16'ha2a0; diffuse_rom[914] = 16'ha2c6; diffuse_rom[915] = 16'ha2ec;
        diffuse_rom[916] = 16'ha313; diffuse_rom[917] = 16'ha339; diffuse_rom[918] = 16'ha360; diffuse_rom[919] = 16'ha386;
        diffuse_rom[920] = 16'ha3ac; diffuse_rom[921] = 16'ha3d3; diffuse_rom[922] = 16'ha3f9; diffuse_rom[923] = 16'ha420;
        diffuse_rom[924] = 16'ha446; diffuse_rom[925] = 16'ha46c; diffuse_rom[926] = 16'ha493; diffuse_rom[927] = 16'ha4b9;
        diffuse_rom[928] = 16'ha4e0; diffuse_rom[929] = 16'ha506; diffuse_rom[930] = 16'ha52c; diffuse_rom[931] = 16'ha553;
        diffuse_rom[932] = 16'ha579; diffuse_rom[933] = 16'ha5a0; diffuse_rom[934] = 16'ha5c6; diffuse_rom[935] = 16'ha5ec;
        diffuse_rom[936] = 16'ha613; diffuse_rom[937] = 16'ha639; diffuse_rom[938] = 16'ha660; diffuse_rom[939] = 16'ha686;
        diffuse_rom[940] = 16'ha6ac; diffuse_rom[941] = 16'ha6d3; diffuse_rom[942] = 16'ha6f9; diffuse_rom[943] = 16'ha720;
        diffuse_rom[944] = 16'ha746; diffuse_rom[945] = 16'ha76c; diffuse_rom[946] = 16'ha793; diffuse_rom[947] = 16'ha7b9;
        diffuse_rom[948] = 16'ha7e0; diffuse_rom[949] = 16'ha806; diffuse_rom[950] = 16'ha82c; diffuse_rom[951] = 16'ha853;
        diffuse_rom[952] = 16'ha879; diffuse_rom[953] = 16'ha8a0; diffuse_rom[954] = 16'ha8c6; diffuse_rom[955] = 16'ha8ec;
        diffuse_rom[956] = 16'ha913; diffuse_rom[957] = 16'ha939; diffuse_rom[958] = 16'ha960; diffuse_rom[959] = 16'ha986;
        diffuse_rom[960] = 16'ha9ac; diffuse_rom[961] = 16'ha9d3; diffuse_rom[962] = 16'ha9f9; diffuse_rom[963] = 16'haa20;
        diffuse_rom[964] = 16'haa46; diffuse_rom[965] = 16'haa6c; diffuse_rom[966] = 16'haa93; diffuse_rom[967] = 16'haab9;
        diffuse_rom[968] = 16'haae0; diffuse_rom[969] = 16'hab06; diffuse_rom[970] = 16'hab2c; diffuse_rom[971] = 16'hab53;
        diffuse_rom[972] = 16'hab79; diffuse_rom[973] = 16'haba0; diffuse_rom[974] = 16'habc6; diffuse_rom[975] = 16'habec;
        diffuse_rom[976] = 16'hac13; diffuse_rom[977] = 16'hac39; diffuse_rom[978] = 16'hac60; diffuse_rom[979] = 16'hac86;
        diffuse_rom[980] = 16'hacac; diffuse_rom[981] = 16'hacd3; diffuse_rom[982] = 16'hacf9; diffuse_rom[983] = 16'had20;
        diffuse_rom[984] = 16'had46; diffuse_rom[985] = 16'had6c; diffuse_rom[986] = 16'had93; diffuse_rom[987] = 16'hadb9;
        diffuse_rom[988] = 16'hade0; diffuse_rom[989] = 16'hae06; diffuse_rom[990] = 16'hae2c; diffuse_rom[991] = 16'hae53;
        diffuse_rom[992] = 16'hae79; diffuse_rom[993] = 16'haea0; diffuse_rom[994] = 16'haec6; diffuse_rom[995] = 16'haeec;
        diffuse_rom[996] = 16'haf13; diffuse_rom[997] = 16'haf39; diffuse_rom[998] = 16'haf60; diffuse_rom[999] = 16'haf86;
        diffuse_rom[1000] = 16'hafac; diffuse_rom[1001] = 16'hafd3; diffuse_rom[1002] = 16'haff9; diffuse_rom[1003] = 16'hb020;
        diffuse_rom[1004] = 16'hb046; diffuse_rom[1005] = 16'hb06c; diffuse_rom[1006] = 16'hb093; diffuse_rom[1007] = 16'hb0b9;
        diffuse_rom[1008] = 16'hb0e0; diffuse_rom[1009] = 16'hb106; diffuse_rom[1010] = 16'hb12c; diffuse_rom[1011] = 16'hb153;
        diffuse_rom[1012] = 16'hb179; diffuse_rom[1013] = 16'hb1a0; diffuse_rom[1014] = 16'hb1c6; diffuse_rom[1015] = 16'hb1ec;
        diffuse_rom[1016] = 16'hb213; diffuse_rom[1017] = 16'hb239; diffuse_rom[1018] = 16'hb260; diffuse_rom[1019] = 16'hb286;
        diffuse_rom[1020] = 16'hb2ac; diffuse_rom[1021] = 16'hb2d3; diffuse_rom[1022] = 16'hb2f9; diffuse_rom[1023] = 16'hb320;
    end

    // table specular: light u16f16
    (* rom_style = "block" *)
    reg [15:0] specular_rom [0:1023];
    initial begin
        specular_rom[0] = 16'h0000; specular_rom[1] = 16'h0000; specular_rom[2] = 16'h0000; specular_rom[3] = 16'h0000;
        specular_rom[4] = 16'h0000; specular_rom[5] = 16'h0000; specular_rom[6] = 16'h0000; specular_rom[7] = 16'h0000;
        specular_rom[8] = 16'h0000; specular_rom[9] = 16'h0000; specular_rom[10] = 16'h0000; specular_rom[11] = 16'h0000;
        specular_rom[12] = 16'h0000; specular_rom[13] = 16'h0000; specular_rom[14] = 16'h0000; specular_rom[15] = 16'h0000;
        specular_rom[16] = 16'h0000; specular_rom[17] = 16'h0000; specular_rom[18] = 16'h0000; specular_rom[19] = 16'h0000;
        specular_rom[20] = 16'h0000; specular_rom[21] = 16'h0000; specular_rom[22] = 16'h0000; specular_rom[23] = 16'h0000;
        specular_rom[24] = 16'h0000; specular_rom[25] = 16'h0000; specular_rom[26] = 16'h0000; specular_rom[27] = 16'h0000;
        specular_rom[28] = 16'h0000; specular_rom[29] = 16'h0000; specular_rom[30] = 16'h0000; specular_rom[31] = 16'h0000;
        specular_rom[32] = 16'h0000; specular_rom[33] = 16'h0000; specular_rom[34] = 16'h0000; specular_rom[35] = 16'h0000;
        specular_rom[36] = 16'h0000; specular_rom[37] = 16'h0000; specular_rom[38] = 16'h0000; specular_rom[39] = 16'h0000;
        specular_rom[40] = 16'h0000; specular_rom[41] = 16'h0000; specular_rom[42] = 16'h0000; specular_rom[43] = 16'h0000;
        specular_rom[44] = 16'h0000; specular_rom[45] = 16'h0000; specular_rom[46] = 16'h0000; specular_rom[47] = 16'h0000;
        specular_rom[48] = 16'h0000; specular_rom[49] = 16'h0000; specular_rom[50] = 16'h0000; specular_rom[51] = 16'h0000;
        specular_rom[52] = 16'h0000; specular_rom[53] = 16'h0000; specular_rom[54] = 16'h0000; specular_rom[55] = 16'h0000;
        specular_rom[56] = 16'h0000; specular_rom[57] = 16'h0000; specular_rom[58] = 16'h0000; specular_rom[59] = 16'h0000;
        specular_rom[60] = 16'h0000; specular_rom[61] = 16'h0000; specular_rom[62] = 16'h0000; specular_rom[63] = 16'h0000;
        specular_rom[64] = 16'h0000; specular_rom[65] = 16'h0000; specular_rom[66] = 16'h0000; specular_rom[67] = 16'h0000;
        specular_rom[68] = 16'h0000; specular_rom[69] = 16'h0000; specular_rom[70] = 16'h0000; specular_rom[71] = 16'h0000;
        specular_rom[72] = 16'h0000; specular_rom[73] = 16'h0000; specular_rom[74] = 16'h0000; specular_rom[75] = 16'h0000;
        specular_rom[76] = 16'h0000; specular_rom[77] = 16'h0000; specular_rom[78] = 16'h0000; specular_rom[79] = 16'h0000;
        specular_rom[80] = 16'h0000; specular_rom[81] = 16'h0000; specular_rom[82] = 16'h0000; specular_rom[83] = 16'h0000;
        specular_rom[84] = 16'h0000; specular_rom[85] = 16'h0000; specular_rom[86] = 16'h0000; specular_rom[87] = 16'h0000;
        specular_rom[88] = 16'h0000; specular_rom[89] = 16'h0000; specular_rom[90] = 16'h0000; specular_rom[91] = 16'h0000;
        specular_rom[92] = 16'h0000; specular_rom[93] = 16'h0000; specular_rom[94] = 16'h0000; specular_rom[95] = 16'h0000;
        specular_rom[96] = 16'h0000; specular_rom[97] = 16'h0000; specular_rom[98] = 16'h0000; specular_rom[99] = 16'h0000;
        specular_rom[100] = 16'h0000; specular_rom[101] = 16'h0000; specular_rom[102] = 16'h0000; specular_rom[103] = 16'h0000;
        specular_rom[104] = 16'h0000; specular_rom[105] = 16'h0000; specular_rom[106] = 16'h0000; specular_rom[107] = 16'h0000;
        specular_rom[108] = 16'h0000; specular_rom[109] = 16'h0000; specular_rom[110] = 16'h0000; specular_rom[111] = 16'h0000;
        specular_rom[112] = 16'h0000; specular_rom[113] = 16'h0000; specular_rom[114] = 16'h0000; specular_rom[115] = 16'h0000;
        specular_rom[116] = 16'h0000; specular_rom[117] = 16'h0000; specular_rom[118] = 16'h0000; specular_rom[119] = 16'h0000;
        specular_rom[120] = 16'h0000; specular_rom[121] = 16'h0000; specular_rom[122] = 16'h0000; specular_rom[123] = 16'h0000;
        specular_rom[124] = 16'h0000; specular_rom[125] = 16'h0000; specular_rom[126] = 16'h0000; specular_rom[127] = 16'h0000;
        specular_rom[128] = 16'h0000; specular_rom[129] = 16'h0000; specular_rom[130] = 16'h0000; specular_rom[131] = 16'h0000;
        specular_rom[132] = 16'h0000; specular_rom[133] = 16'h0000; specular_rom[134] = 16'h0000; specular_rom[135] = 16'h0000;
        specular_rom[136] = 16'h0000; specular_rom[137] = 16'h0000; specular_rom[138] = 16'h0000; specular_rom[139] = 16'h0000;
        specular_rom[140] = 16'h0000; specular_rom[141] = 16'h0000; specular_rom[142] = 16'h0000; specular_rom[143] = 16'h0000;
        specular_rom[144] = 16'h0000; specular_rom[145] = 16'h0000; specular_rom[146] = 16'h0000; specular_rom[147] = 16'h0000;
        specular_rom[148] = 16'h0000; specular_rom[149] = 16'h0000; specular_rom[150] = 16'h0000; specular_rom[151] = 16'h0000;
        specular_rom[152] = 16'h0000; specular_rom[153] = 16'h0000; specular_rom[154] = 16'h0000; specular_rom[155] = 16'h0000;
        specular_rom[156] = 16'h0000; specular_rom[157] = 16'h0000; specular_rom[158] = 16'h0000; specular_rom[159] = 16'h0000;
        specular_rom[160] = 16'h0000; specular_rom[161] = 16'h0000; specular_rom[162] = 16'h0000; specular_rom[163] = 16'h0000;
        specular_rom[164] = 16'h0000; specular_rom[165] = 16'h0000; specular_rom[166] = 16'h0000; specular_rom[167] = 16'h0000;
        specular_rom[168] = 16'h0000; specular_rom[169] = 16'h0000; specular_rom[170] = 16'h0000; specular_rom[171] = 16'h0000;
        specular_rom[172] = 16'h0000; specular_rom[173] = 16'h0000; specular_rom[174] = 16'h0000; specular_rom[175] = 16'h0000;
        specular_rom[176] = 16'h0000; specular_rom[177] = 16'h0000; specular_rom[178] = 16'h0000; specular_rom[179] = 16'h0000;
        specular_rom[180] = 16'h0000; specular_rom[181] = 16'h0000; specular_rom[182] = 16'h0000; specular_rom[183] = 16'h0000;
        specular_rom[184] = 16'h0000; specular_rom[185] = 16'h0000; specular_rom[186] = 16'h0000; specular_rom[187] = 16'h0000;
        specular_rom[188] = 16'h0000; specular_rom[189] = 16'h0000; specular_rom[190] = 16'h0000; specular_rom[191] = 16'h0000;
        specular_rom[192] = 16'h0000; specular_rom[193] = 16'h0000; specular_rom[194] = 16'h0000; specular_rom[195] = 16'h0000;
        specular_rom[196] = 16'h0000; specular_rom[197] = 16'h0000; specular_rom[198] = 16'h0000; specular_rom[199] = 16'h0000;
        specular_rom[200] = 16'h0000; specular_rom[201] = 16'h0000; specular_rom[202] = 16'h0000; specular_rom[203] = 16'h0000;
        specular_rom[204] = 16'h0000; specular_rom[205] = 16'h0000; specular_rom[206] = 16'h0000; specular_rom[207] = 16'h0000;
        specular_rom[208] = 16'h0000; specular_rom[209] = 16'h0000; specular_rom[210] = 16'h0000; specular_rom[211] = 16'h0000;
        specular_rom[212] = 16'h0000; specular_rom[213] = 16'h0000; specular_rom[214] = 16'h0000; specular_rom[215] = 16'h0000;
        specular_rom[216] = 16'h0000; specular_rom[217] = 16'h0000; specular_rom[218] = 16'h0000; specular_rom[219] = 16'h0000;
        specular_rom[220] = 16'h0000; specular_rom[221] = 16'h0000; specular_rom[222] = 16'h0000; specular_rom[223] = 16'h0000;
        specular_rom[224] = 16'h0000; specular_rom[225] = 16'h0000; specular_rom[226] = 16'h0000; specular_rom[227] = 16'h0000;
        specular_rom[228] = 16'h0000; specular_rom[229] = 16'h0000; specular_rom[230] = 16'h0000; specular_rom[231] = 16'h0000;
        specular_rom[232] = 16'h0000; specular_rom[233] = 16'h0000; specular_rom[234] = 16'h0000; specular_rom[235] = 16'h0000;
        specular_rom[236] = 16'h0000; specular_rom[237] = 16'h0000; specular_rom[238] = 16'h0000; specular_rom[239] = 16'h0000;
        specular_rom[240] = 16'h0000; specular_rom[241] = 16'h0000; specular_rom[242] = 16'h0000; specular_rom[243] = 16'h0000;
        specular_rom[244] = 16'h0000; specular_rom[245] = 16'h0000; specular_rom[246] = 16'h0000; specular_rom[247] = 16'h0000;
        specular_rom[248] = 16'h0000; specular_rom[249] = 16'h0000; specular_rom[250] = 16'h0000; specular_rom[251] = 16'h0000;
        specular_rom[252] = 16'h0000; specular_rom[253] = 16'h0000; specular_rom[254] = 16'h0000; specular_rom[255] = 16'h0000;
        specular_rom[256] = 16'h0000; specular_rom[257] = 16'h0000; specular_rom[258] = 16'h0000; specular_rom[259] = 16'h0000;
        specular_rom[260] = 16'h0000; specular_rom[261] = 16'h0000; specular_rom[262] = 16'h0000; specular_rom[263] = 16'h0000;
        specular_rom[264] = 16'h0000; specular_rom[265] = 16'h0000; specular_rom[266] = 16'h0000; specular_rom[267] = 16'h0000;
        specular_rom[268] = 16'h0000; specular_rom[269] = 16'h0000; specular_rom[270] = 16'h0000; specular_rom[271] = 16'h0000;
        specular_rom[272] = 16'h0000; specular_rom[273] = 16'h0000; specular_rom[274] = 16'h0000; specular_rom[275] = 16'h0000;
        specular_rom[276] = 16'h0000; specular_rom[277] = 16'h0000; specular_rom[278] = 16'h0000; specular_rom[279] = 16'h0000;
        specular_rom[280] = 16'h0000; specular_rom[281] = 16'h0000; specular_rom[282] = 16'h0000; specular_rom[283] = 16'h0000;
        specular_rom[284] = 16'h0000; specular_rom[285] = 16'h0000; specular_rom[286] = 16'h0000; specular_rom[287] = 16'h0000;
        specular_rom[288] = 16'h0000; specular_rom[289] = 16'h0000; specular_rom[290] = 16'h0000; specular_rom[291] = 16'h0000;
        specular_rom[292] = 16'h0000; specular_rom[293] = 16'h0000; specular_rom[294] = 16'h0000; specular_rom[295] = 16'h0000;
        specular_rom[296] = 16'h0000; specular_rom[297] = 16'h0000; specular_rom[298] = 16'h0000; specular_rom[299] = 16'h0000;
        specular_rom[300] = 16'h0000; specular_rom[301] = 16'h0000; specular_rom[302] = 16'h0000; specular_rom[303] = 16'h0000;
        specular_rom[304] = 16'h0000; specular_rom[305] = 16'h0000; specular_rom[306] = 16'h0000; specular_rom[307] = 16'h0000;
        specular_rom[308] = 16'h0000; specular_rom[309] = 16'h0000; specular_rom[310] = 16'h0000; specular_rom[311] = 16'h0000;
        specular_rom[312] = 16'h0000; specular_rom[313] = 16'h0000; specular_rom[314] = 16'h0000; specular_rom[315] = 16'h0000;
        specular_rom[316] = 16'h0000; specular_rom[317] = 16'h0000; specular_rom[318] = 16'h0000; specular_rom[319] = 16'h0000;
        specular_rom[320] = 16'h0000; specular_rom[321] = 16'h0000; specular_rom[322] = 16'h0000; specular_rom[323] = 16'h0000;
        specular_rom[324] = 16'h0000; specular_rom[325] = 16'h0000; specular_rom[326] = 16'h0000; specular_rom[327] = 16'h0000;
        specular_rom[328] = 16'h0000; specular_rom[329] = 16'h0000; specular_rom[330] = 16'h0000; specular_rom[331] = 16'h0000;
        specular_rom[332] = 16'h0000; specular_rom[333] = 16'h0000; specular_rom[334] = 16'h0000; specular_rom[335] = 16'h0000;
        specular_rom[336] = 16'h0000; specular_rom[337] = 16'h0000; specular_rom[338] = 16'h0000; specular_rom[339] = 16'h0000;
        specular_rom[340] = 16'h0000; specular_rom[341] = 16'h0000; specular_rom[342] = 16'h0000; specular_rom[343] = 16'h0000;
        specular_rom[344] = 16'h0000; specular_rom[345] = 16'h0000; specular_rom[346] = 16'h0000; specular_rom[347] = 16'h0000;
        specular_rom[348] = 16'h0000; specular_rom[349] = 16'h0000; specular_rom[350] = 16'h0000; specular_rom[351] = 16'h0000;
        specular_rom[352] = 16'h0000; specular_rom[353] = 16'h0000; specular_rom[354] = 16'h0000; specular_rom[355] = 16'h0000;
        specular_rom[356] = 16'h0000; specular_rom[357] = 16'h0000; specular_rom[358] = 16'h0000; specular_rom[359] = 16'h0000;
        specular_rom[360] = 16'h0000; specular_rom[361] = 16'h0000; specular_rom[362] = 16'h0000; specular_rom[363] = 16'h0000;
        specular_rom[364] = 16'h0000; specular_rom[365] = 16'h0000; specular_rom[366] = 16'h0000; specular_rom[367] = 16'h0000;
        specular_rom[368] = 16'h0000; specular_rom[369] = 16'h0000; specular_rom[370] = 16'h0000; specular_rom[371] = 16'h0000;
        specular_rom[372] = 16'h0000; specular_rom[373] = 16'h0000; specular_rom[374] = 16'h0000; specular_rom[375] = 16'h0000;
        specular_rom[376] = 16'h0000; specular_rom[377] = 16'h0000; specular_rom[378] = 16'h0000; specular_rom[379] = 16'h0000;
        specular_rom[380] = 16'h0000; specular_rom[381] = 16'h0000; specular_rom[382] = 16'h0000; specular_rom[383] = 16'h0000;
        specular_rom[384] = 16'h0000; specular_rom[385] = 16'h0000; specular_rom[386] = 16'h0000; specular_rom[387] = 16'h0000;
        specular_rom[388] = 16'h0000; specular_rom[389] = 16'h0000; specular_rom[390] = 16'h0000; specular_rom[391] = 16'h0000;
        specular_rom[392] = 16'h0000; specular_rom[393] = 16'h0000; specular_rom[394] = 16'h0000; specular_rom[395] = 16'h0000;
        specular_rom[396] = 16'h0000; specular_rom[397] = 16'h0000; specular_rom[398] = 16'h0000; specular_rom[399] = 16'h0000;
        specular_rom[400] = 16'h0000; specular_rom[401] = 16'h0000; specular_rom[402] = 16'h0000; specular_rom[403] = 16'h0000;
        specular_rom[404] = 16'h0000; specular_rom[405] = 16'h0000; specular_rom[406] = 16'h0000; specular_rom[407] = 16'h0000;
        specular_rom[408] = 16'h0000; specular_rom[409] = 16'h0000; specular_rom[410] = 16'h0000; specular_rom[411] = 16'h0000;
        specular_rom[412] = 16'h0000; specular_rom[413] = 16'h0000; specular_rom[414] = 16'h0000; specular_rom[415] = 16'h0000;
        specular_rom[416] = 16'h0000; specular_rom[417] = 16'h0000; specular_rom[418] = 16'h0000; specular_rom[419] = 16'h0000;
        specular_rom[420] = 16'h0000; specular_rom[421] = 16'h0000; specular_rom[422] = 16'h0000; specular_rom[423] = 16'h0000;
        specular_rom[424] = 16'h0000; specular_rom[425] = 16'h0000; specular_rom[426] = 16'h0000; specular_rom[427] = 16'h0000;
        specular_rom[428] = 16'h0000; specular_rom[429] = 16'h0000; specular_rom[430] = 16'h0000; specular_rom[431] = 16'h0000;
        specular_rom[432] = 16'h0000; specular_rom[433] = 16'h0000; specular_rom[434] = 16'h0000; specular_rom[435] = 16'h0000;
        specular_rom[436] = 16'h0000; specular_rom[437] = 16'h0000; specular_rom[438] = 16'h0000; specular_rom[439] = 16'h0000;
        specular_rom[440] = 16'h0000; specular_rom[441] = 16'h0000; specular_rom[442] = 16'h0000; specular_rom[443] = 16'h0000;
        specular_rom[444] = 16'h0000; specular_rom[445] = 16'h0000; specular_rom[446] = 16'h0000; specular_rom[447] = 16'h0000;
        specular_rom[448] = 16'h0000; specular_rom[449] = 16'h0000; specular_rom[450] = 16'h0000; specular_rom[451] = 16'h0000;
        specular_rom[452] = 16'h0000; specular_rom[453] = 16'h0000; specular_rom[454] = 16'h0000; specular_rom[455] = 16'h0000;
        specular_rom[456] = 16'h0000; specular_rom[457] = 16'h0000; specular_rom[458] = 16'h0000; specular_rom[459] = 16'h0000;
        specular_rom[460] = 16'h0000; specular_rom[461] = 16'h0000; specular_rom[462] = 16'h0000; specular_rom[463] = 16'h0000;
        specular_rom[464] = 16'h0000; specular_rom[465] = 16'h0000; specular_rom[466] = 16'h0000; specular_rom[467] = 16'h0000;
        specular_rom[468] = 16'h0000; specular_rom[469] = 16'h0000; specular_rom[470] = 16'h0000; specular_rom[471] = 16'h0000;
        specular_rom[472] = 16'h0000; specular_rom[473] = 16'h0000; specular_rom[474] = 16'h0000; specular_rom[475] = 16'h0000;
        specular_rom[476] = 16'h0000; specular_rom[477] = 16'h0000; specular_rom[478] = 16'h0000; specular_rom[479] = 16'h0000;
        specular_rom[480] = 16'h0000; specular_rom[481] = 16'h0000; specular_rom[482] = 16'h0000; specular_rom[483] = 16'h0000;
        specular_rom[484] = 16'h0000; specular_rom[485] = 16'h0000; specular_rom[486] = 16'h0000; specular_rom[487] = 16'h0000;
        specular_rom[488] = 16'h0000; specular_rom[489] = 16'h0000; specular_rom[490] = 16'h0000; specular_rom[491] = 16'h0000;
        specular_rom[492] = 16'h0000; specular_rom[493] = 16'h0000; specular_rom[494] = 16'h0000; specular_rom[495] = 16'h0000;
        specular_rom[496] = 16'h0000; specular_rom[497] = 16'h0000; specular_rom[498] = 16'h0000; specular_rom[499] = 16'h0000;
        specular_rom[500] = 16'h0000; specular_rom[501] = 16'h0000; specular_rom[502] = 16'h0000; specular_rom[503] = 16'h0000;
        specular_rom[504] = 16'h0000; specular_rom[505] = 16'h0000; specular_rom[506] = 16'h0000; specular_rom[507] = 16'h0000;
        specular_rom[508] = 16'h0000; specular_rom[509] = 16'h0000; specular_rom[510] = 16'h0000; specular_rom[511] = 16'h0000;
        specular_rom[512] = 16'h0000; specular_rom[513] = 16'h0000; specular_rom[514] = 16'h0000; specular_rom[515] = 16'h0000;
        specular_rom[516] = 16'h0000; specular_rom[517] = 16'h0000; specular_rom[518] = 16'h0000; specular_rom[519] = 16'h0000;
        specular_rom[520] = 16'h0000; specular_rom[521] = 16'h0000; specular_rom[522] = 16'h0000; specular_rom[523] = 16'h0000;
        specular_rom[524] = 16'h0000; specular_rom[525] = 16'h0000; specular_rom[526] = 16'h0000; specular_rom[527] = 16'h0000;
        specular_rom[528] = 16'h0000; specular_rom[529] = 16'h0000; specular_rom[530] = 16'h0000; specular_rom[531] = 16'h0000;
        specular_rom[532] = 16'h0000; specular_rom[533] = 16'h0000; specular_rom[534] = 16'h0000; specular_rom[535] = 16'h0000;
        specular_rom[536] = 16'h0000; specular_rom[537] = 16'h0000; specular_rom[538] = 16'h0000; specular_rom[539] = 16'h0000;
        specular_rom[540] = 16'h0000; specular_rom[541] = 16'h0000; specular_rom[542] = 16'h0000; specular_rom[543] = 16'h0000;
        specular_rom[544] = 16'h0000; specular_rom[545] = 16'h0000; specular_rom[546] = 16'h0000; specular_rom[547] = 16'h0000;
        specular_rom[548] = 16'h0000; specular_rom[549] = 16'h0000; specular_rom[550] = 16'h0000; specular_rom[551] = 16'h0000;
        specular_rom[552] = 16'h0000; specular_rom[553] = 16'h0000; specular_rom[554] = 16'h0000; specular_rom[555] = 16'h0000;
        specular_rom[556] = 16'h0000; specular_rom[557] = 16'h0000; specular_rom[558] = 16'h0000; specular_rom[559] = 16'h0000;
        specular_rom[560] = 16'h0000; specular_rom[561] = 16'h0000; specular_rom[562] = 16'h0000; specular_rom[563] = 16'h0000;
        specular_rom[564] = 16'h0000; specular_rom[565] = 16'h0000; specular_rom[566] = 16'h0000; specular_rom[567] = 16'h0000;
        specular_rom[568] = 16'h0000; specular_rom[569] = 16'h0000; specular_rom[570] = 16'h0000; specular_rom[571] = 16'h0000;
        specular_rom[572] = 16'h0000; specular_rom[573] = 16'h0000; specular_rom[574] = 16'h0000; specular_rom[575] = 16'h0000;
        specular_rom[576] = 16'h0000; specular_rom[577] = 16'h0000; specular_rom[578] = 16'h0000; specular_rom[579] = 16'h0000;
        specular_rom[580] = 16'h0000; specular_rom[581] = 16'h0000; specular_rom[582] = 16'h0000; specular_rom[583] = 16'h0000;
        specular_rom[584] = 16'h0000; specular_rom[585] = 16'h0000; specular_rom[586] = 16'h0000; specular_rom[587] = 16'h0000;
        specular_rom[588] = 16'h0000; specular_rom[589] = 16'h0000; specular_rom[590] = 16'h0000; specular_rom[591] = 16'h0000;
        specular_rom[592] = 16'h0000; specular_rom[593] = 16'h0000; specular_rom[594] = 16'h0000; specular_rom[595] = 16'h0000;
        specular_rom[596] = 16'h0000; specular_rom[597] = 16'h0000; specular_rom[598] = 16'h0000; specular_rom[599] = 16'h0000;
        specular_rom[600] = 16'h0000; specular_rom[601] = 16'h0000; specular_rom[602] = 16'h0000; specular_rom[603] = 16'h0000;
        specular_rom[604] = 16'h0000; specular_rom[605] = 16'h0000; specular_rom[606] = 16'h0000; specular_rom[607] = 16'h0000;
        specular_rom[608] = 16'h0000; specular_rom[609] = 16'h0000; specular_rom[610] = 16'h0000; specular_rom[611] = 16'h0000;
        specular_rom[612] = 16'h0000; specular_rom[613] = 16'h0000; specular_rom[614] = 16'h0000; specular_rom[615] = 16'h0000;
        specular_rom[616] = 16'h0000; specular_rom[617] = 16'h0000; specular_rom[618] = 16'h0000; specular_rom[619] = 16'h0000;
        specular_rom[620] = 16'h0000; specular_rom[621] = 16'h0000; specular_rom[622] = 16'h0000; specular_rom[623] = 16'h0000;
        specular_rom[624] = 16'h0000; specular_rom[625] = 16'h0000; specular_rom[626] = 16'h0000; specular_rom[627] = 16'h0000;
        specular_rom[628] = 16'h0000; specular_rom[629] = 16'h0000; specular_rom[630] = 16'h0000; specular_rom[631] = 16'h0000;
        specular_rom[632] = 16'h0000; specular_rom[633] = 16'h0000; specular_rom[634] = 16'h0000; specular_rom[635] = 16'h0000;
        specular_rom[636] = 16'h0000; specular_rom[637] = 16'h0000; specular_rom[638] = 16'h0000; specular_rom[639] = 16'h0000;
        specular_rom[640] = 16'h0000; specular_rom[641] = 16'h0000; specular_rom[642] = 16'h0000; specular_rom[643] = 16'h0000;
        specular_rom[644] = 16'h0000; specular_rom[645] = 16'h0000; specular_rom[646] = 16'h0000; specular_rom[647] = 16'h0000;
        specular_rom[648] = 16'h0000; specular_rom[649] = 16'h0000; specular_rom[650] = 16'h0000; specular_rom[651] = 16'h0000;
        specular_rom[652] = 16'h0000; specular_rom[653] = 16'h0000; specular_rom[654] = 16'h0000; specular_rom[655] = 16'h0000;
        specular_rom[656] = 16'h0000; specular_rom[657] = 16'h0000; specular_rom[658] = 16'h0000; specular_rom[659] = 16'h0000;
        specular_rom[660] = 16'h0000; specular_rom[661] = 16'h0000; specular_rom[662] = 16'h0000; specular_rom[663] = 16'h0000;
        specular_rom[664] = 16'h0000; specular_rom[665] = 16'h0000; specular_rom[666] = 16'h0000; specular_rom[667] = 16'h0000;
        specular_rom[668] = 16'h0000; specular_rom[669] = 16'h0000; specular_rom[670] = 16'h0000; specular_rom[671] = 16'h0000;
        specular_rom[672] = 16'h0000; specular_rom[673] = 16'h0000; specular_rom[674] = 16'h0000; specular_rom[675] = 16'h0000;
        specular_rom[676] = 16'h0000; specular_rom[677] = 16'h0000; specular_rom[678] = 16'h0000; specular_rom[679] = 16'h0000;
        specular_rom[680] = 16'h0000; specular_rom[681] = 16'h0000; specular_rom[682] = 16'h0000; specular_rom[683] = 16'h0000;
        specular_rom[684] = 16'h0000; specular_rom[685] = 16'h0000; specular_rom[686] = 16'h0000; specular_rom[687] = 16'h0000;
        specular_rom[688] = 16'h0000; specular_rom[689] = 16'h0000; specular_rom[690] = 16'h0000; specular_rom[691] = 16'h0000;
        specular_rom[692] = 16'h0000; specular_rom[693] = 16'h0000; specular_rom[694] = 16'h0000; specular_rom[695] = 16'h0000;
        specular_rom[696] = 16'h0000; specular_rom[697] = 16'h0000; specular_rom[698] = 16'h0000; specular_rom[699] = 16'h0000;
        specular_rom[700] = 16'h0000; specular_rom[701] = 16'h0000; specular_rom[702] = 16'h0000; specular_rom[703] = 16'h0000;
        specular_rom[704] = 16'h0000; specular_rom[705] = 16'h0000; specular_rom[706] = 16'h0000; specular_rom[707] = 16'h0000;
        specular_rom[708] = 16'h0000; specular_rom[709] = 16'h0000; specular_rom[710] = 16'h0000; specular_rom[711] = 16'h0000;
        specular_rom[712] = 16'h0000; specular_rom[713] = 16'h0000; specular_rom[714] = 16'h0000; specular_rom[715] = 16'h0000;
        specular_rom[716] = 16'h0000; specular_rom[717] = 16'h0000; specular_rom[718] = 16'h0000; specular_rom[719] = 16'h0000;
        specular_rom[720] = 16'h0000; specular_rom[721] = 16'h0000; specular_rom[722] = 16'h0000; specular_rom[723] = 16'h0000;
        specular_rom[724] = 16'h0000; specular_rom[725] = 16'h0000; specular_rom[726] = 16'h0000; specular_rom[727] = 16'h0000;
        specular_rom[728] = 16'h0000; specular_rom[729] = 16'h0000; specular_rom[730] = 16'h0000; specular_rom[731] = 16'h0000;
        specular_rom[732] = 16'h0000; specular_rom[733] = 16'h0000; specular_rom[734] = 16'h0000; specular_rom[735] = 16'h0000;
        specular_rom[736] = 16'h0001; specular_rom[737] = 16'h0001; specular_rom[738] = 16'h0001; specular_rom[739] = 16'h0001;
        specular_rom[740] = 16'h0001; specular_rom[741] = 16'h0001; specular_rom[742] = 16'h0001; specular_rom[743] = 16'h0001;
        specular_rom[744] = 16'h0001; specular_rom[745] = 16'h0001; specular_rom[746] = 16'h0001; specular_rom[747] = 16'h0001;
        specular_rom[748] = 16'h0001; specular_rom[749] = 16'h0001; specular_rom[750] = 16'h0001; specular_rom[751] = 16'h0001;
        specular_rom[752] = 16'h0001; specular_rom[753] = 16'h0001; specular_rom[754] = 16'h0001; specular_rom[755] = 16'h0001;
        specular_rom[756] = 16'h0001; specular_rom[757] = 16'h0001; specular_rom[758] = 16'h0001; specular_rom[759] = 16'h0001;
        specular_rom[760] = 16'h0001; specular_rom[761] = 16'h0002; specular_rom[762] = 16'h0002; specular_rom[763] = 16'h0002;
        specular_rom[764] = 16'h0002; specular_rom[765] = 16'h0002; specular_rom[766] = 16'h0002; specular_rom[767] = 16'h0002;
        specular_rom[768] = 16'h0002; specular_rom[769] = 16'h0002; specular_rom[770] = 16'h0002; specular_rom[771] = 16'h0002;
        specular_rom[772] = 16'h0002; specular_rom[773] = 16'h0002; specular_rom[774] = 16'h0003; specular_rom[775] = 16'h0003;
        specular_rom[776] = 16'h0003; specular_rom[777] = 16'h0003; specular_rom[778] = 16'h0003; specular_rom[779] = 16'h0003;
        specular_rom[780] = 16'h0003; specular_rom[781] = 16'h0003; specular_rom[782] = 16'h0004; specular_rom[783] = 16'h0004;
        specular_rom[784] = 16'h0004; specular_rom[785] = 16'h0004; specular_rom[786] = 16'h0004; specular_rom[787] = 16'h0004;
        specular_rom[788] = 16'h0005; specular_rom[789] = 16'h0005; specular_rom[790] = 16'h0005; specular_rom[791] = 16'h0005;
        specular_rom[792] = 16'h0005; specular_rom[793] = 16'h0006; specular_rom[794] = 16'h0006; specular_rom[795] = 16'h0006;
        specular_rom[796] = 16'h0006; specular_rom[797] = 16'h0007; specular_rom[798] = 16'h0007; specular_rom[799] = 16'h0007;
        specular_rom[800] = 16'h0007; specular_rom[801] = 16'h0008; specular_rom[802] = 16'h0008; specular_rom[803] = 16'h0008;
        specular_rom[804] = 16'h0009; specular_rom[805] = 16'h0009; specular_rom[806] = 16'h0009; specular_rom[807] = 16'h000a;
        specular_rom[808] = 16'h000a; specular_rom[809] = 16'h000b; specular_rom[810] = 16'h000b; specular_rom[811] = 16'h000c;
        specular_rom[812] = 16'h000c; specular_rom[813] = 16'h000c; specular_rom[814] = 16'h000d; specular_rom[815] = 16'h000d;
        specular_rom[816] = 16'h000e; specular_rom[817] = 16'h000f; specular_rom[818] = 16'h000f; specular_rom[819] = 16'h0010;
        specular_rom[820] = 16'h0010; specular_rom[821] = 16'h0011; specular_rom[822] = 16'h0012; specular_rom[823] = 16'h0012;
        specular_rom[824] = 16'h0013; specular_rom[825] = 16'h0014; specular_rom[826] = 16'h0015; specular_rom[827] = 16'h0016;
        specular_rom[828] = 16'h0016; specular_rom[829] = 16'h0017; specular_rom[830] = 16'h0018; specular_rom[831] = 16'h0019;
        specular_rom[832] = 16'h001a; specular_rom[833] = 16'h001b; specular_rom[834] = 16'h001c; specular_rom[835] = 16'h001d;
        specular_rom[836] = 16'h001e; specular_rom[837] = 16'h0020; specular_rom[838] = 16'h0021; specular_rom[839] = 16'h0022;
        specular_rom[840] = 16'h0023; specular_rom[841] = 16'h0025; specular_rom[842] = 16'h0026; specular_rom[843] = 16'h0028;
        specular_rom[844] = 16'h0029; specular_rom[845] = 16'h002b; specular_rom[846] = 16'h002c; specular_rom[847] = 16'h002e;
        specular_rom[848] = 16'h0030; specular_rom[849] = 16'h0032; specular_rom[850] = 16'h0034; specular_rom[851] = 16'h0036;
        specular_rom[852] = 16'h0038; specular_rom[853] = 16'h003a; specular_rom[854] = 16'h003c; specular_rom[855] = 16'h003e;
        specular_rom[856] = 16'h0041; specular_rom[857] = 16'h0043; specular_rom[858] = 16'h0046; specular_rom[859] = 16'h0048;
        specular_rom[860] = 16'h004b; specular_rom[861] = 16'h004e; specular_rom[862] = 16'h0051; specular_rom[863] = 16'h0054;
        specular_rom[864] = 16'h0057; specular_rom[865] = 16'h005a; specular_rom[866] = 16'h005e; specular_rom[867] = 16'h0061;
        specular_rom[868] = 16'h0065; specular_rom[869] = 16'h0069; specular_rom[870] = 16'h006d; specular_rom[871] = 16'h0071;
        specular_rom[872] = 16'h0075; specular_rom[873] = 16'h0079; specular_rom[874] = 16'h007e; specular_rom[875] = 16'h0083;
        specular_rom[876] = 16'h0088; specular_rom[877] = 16'h008d; specular_rom[878] = 16'h0092; specular_rom[879] = 16'h0097;
        specular_rom[880] = 16'h009d; specular_rom[881] = 16'h00a3; specular_rom[882] = 16'h00a9; specular_rom[883] = 16'h00af;
        specular_rom[884] = 16'h00b5; specular_rom[885] = 16'h00bc; specular_rom[886] = 16'h00c3; specular_rom[887] = 16'h00ca;
        specular_rom[888] = 16'h00d1; specular_rom[889] = 16'h00d9; specular_rom[890] = 16'h00e1; specular_rom[891] = 16'h00e9;
        specular_rom[892] = 16'h00f2; specular_rom[893] = 16'h00fb; specular_rom[894] = 16'h0104; specular_rom[895] = 16'h010d;
        specular_rom[896] = 16'h0117; specular_rom[897] = 16'h0121; specular_rom[898] = 16'h012c; specular_rom[899] = 16'h0136;
        specular_rom[900] = 16'h0142; specular_rom[901] = 16'h014d; specular_rom[902] = 16'h0159; specular_rom[903] = 16'h0166;
        specular_rom[904] = 16'h0173; specular_rom[905] = 16'h0180; specular_rom[906] = 16'h018e; specular_rom[907] = 16'h019c;
        specular_rom[908] = 16'h01ab; specular_rom[909] = 16'h01ba; specular_rom[910] = 16'h01ca; specular_rom[911] = 16'h01da;
        specular_rom[912] = 16'h01eb; specular_rom[913] = 16'h01fd; specular_rom[914] = 16'h020f; specular_rom[915] = 16'h0222;
        specular_rom[916] = 16'h0235; specular_rom[917] = 16'h0249; specular_rom[918] = 16'h025e; specular_rom[919] = 16'h0273;
        specular_rom[920] = 16'h028a; specular_rom[921] = 16'h02a1; specular_rom[922] = 16'h02b8; specular_rom[923] = 16'h02d1;
        specular_rom[924] = 16'h02ea; specular_rom[925] = 16'h0305; specular_rom[926] = 16'h0320; specular_rom[927] = 16'h033c;
        specular_rom[928] = 16'h0359; specular_rom[929] = 16'h0377; specular_rom[930] = 16'h0396; specular_rom[931] = 16'h03b6;
        specular_rom[932] = 16'h03d7; specular_rom[933] = 16'h03fa; specular_rom[934] = 16'h041d; specular_rom[935] = 16'h0442;
        specular_rom[936] = 16'h0468; specular_rom[937] = 16'h048f; specular_rom[938] = 16'h04b7; specular_rom[939] = 16'h04e1;
        specular_rom[940] = 16'h050c; specular_rom[941] = 16'h0539; specular_rom[942] = 16'h0567; specular_rom[943] = 16'h0597;
        specular_rom[944] = 16'h05c9; specular_rom[945] = 16'h05fb; specular_rom[946] = 16'h0630; specular_rom[947] = 16'h0667;
        specular_rom[948] = 16'h069f; specular_rom[949] = 16'h06d9; specular_rom[950] = 16'h0715; specular_rom[951] = 16'h0753;
        specular_rom[952] = 16'h0793; specular_rom[953] = 16'h07d5; specular_rom[954] = 16'h081a; specular_rom[955] = 16'h0861;
        specular_rom[956] = 16'h08aa; specular_rom[957] = 16'h08f5; specular_rom[958] = 16'h0943; specular_rom[959] = 16'h0993;
        specular_rom[960] = 16'h09e6; specular_rom[961] = 16'h0a3c; specular_rom[962] = 16'h0a95; specular_rom[963] = 16'h0af0;
        specular_rom[964] = 16'h0b4f; specular_rom[965] = 16'h0bb0; specular_rom[966] = 16'h0c15; specular_rom[967] = 16'h0c7d;
        specular_rom[968] = 16'h0ce9; specular_rom[969] = 16'h0d58; specular_rom[970] = 16'h0dca; specular_rom[971] = 16'h0e41;
        specular_rom[972] = 16'h0ebb; specular_rom[973] = 16'h0f39; specular_rom[974] = 16'h0fbb; specular_rom[975] = 16'h1041;
        specular_rom[976] = 16'h10cc; specular_rom[977] = 16'h115b; specular_rom[978] = 16'h11ef; specular_rom[979] = 16'h1287;
        specular_rom[980] = 16'h1325; specular_rom[981] = 16'h13c7; specular_rom[982] = 16'h146f; specular_rom[983] = 16'h151c;
        specular_rom[984] = 16'h15cf; specular_rom[985] = 16'h1687; specular_rom[986] = 16'h1745; specular_rom[987] = 16'h180a;
        specular_rom[988] = 16'h18d4; specular_rom[989] = 16'h19a5; specular_rom[990] = 16'h1a7d; specular_rom[991] = 16'h1b5b;
        specular_rom[992] = 16'h1c41; specular_rom[993] = 16'h1d2e; specular_rom[994] = 16'h1e22; specular_rom[995] = 16'h1f1e;
        specular_rom[996] = 16'h2023; specular_rom[997] = 16'h212f; specular_rom[998] = 16'h2244; specular_rom[999] = 16'h2361;
        specular_rom[1000] = 16'h2488; specular_rom[1001] = 16'h25b8; specular_rom[1002] = 16'h26f1; specular_rom[1003] = 16'h2834;
        specular_rom[1004] = 16'h2981; specular_rom[1005] = 16'h2ad9; specular_rom[1006] = 16'h2c3c; specular_rom[1007] = 16'h2da9;
        specular_rom[1008] = 16'h2f22; specular_rom[1009] = 16'h30a7; specular_rom[1010] = 16'h3238; specular_rom[1011] = 16'h33d6;
        specular_rom[1012] = 16'h3580; specular_rom[1013] = 16'h3737; specular_rom[1014] = 16'h38fd; specular_rom[1015] = 16'h3ad0;
        specular_rom[1016] = 16'h3cb2; specular_rom[1017] = 16'h3ea2; specular_rom[1018] = 16'h40a2; specular_rom[1019] = 16'h42b2;
        specular_rom[1020] = 16'h44d2; specular_rom[1021] = 16'h4703; specular_rom[1022] = 16'h4945; specular_rom[1023] = 16'h4b99;
    end

    // a copy of table cos: cos s20f18
    (* rom_style = "block" *)
    reg [19:0] cos_rom_2 [0:1023];
    initial begin
        cos_rom_2[0] = 20'h3fffe; cos_rom_2[1] = 20'h3fff4; cos_rom_2[2] = 20'h3ffe0; cos_rom_2[3] = 20'h3ffc3;
        cos_rom_2[4] = 20'h3ff9b; cos_rom_2[5] = 20'h3ff6a; cos_rom_2[6] = 20'h3ff2f; cos_rom_2[7] = 20'h3feea;
        cos_rom_2[8] = 20'h3fe9b; cos_rom_2[9] = 20'h3fe42; cos_rom_2[10] = 20'h3fde0; cos_rom_2[11] = 20'h3fd73;
        cos_rom_2[12] = 20'h3fcfd; cos_rom_2[13] = 20'h3fc7d; cos_rom_2[14] = 20'h3fbf3; cos_rom_2[15] = 20'h3fb5f;
        cos_rom_2[16] = 20'h3fac2; cos_rom_2[17] = 20'h3fa1a; cos_rom_2[18] = 20'h3f969; cos_rom_2[19] = 20'h3f8ae;
        cos_rom_2[20] = 20'h3f7e9; cos_rom_2[21] = 20'h3f71b; cos_rom_2[22] = 20'h3f642; cos_rom_2[23] = 20'h3f560;
        cos_rom_2[24] = 20'h3f474; cos_rom_2[25] = 20'h3f37e; cos_rom_2[26] = 20'h3f27f; cos_rom_2[27] = 20'h3f176;
        cos_rom_2[28] = 20'h3f063; cos_rom_2[29] = 20'h3ef46; cos_rom_2[30] = 20'h3ee20; cos_rom_2[31] = 20'h3ecf0;
        cos_rom_2[32] = 20'h3ebb6; cos_rom_2[33] = 20'h3ea73; cos_rom_2[34] = 20'h3e926; cos_rom_2[35] = 20'h3e7cf;
        cos_rom_2[36] = 20'h3e66f; cos_rom_2[37] = 20'h3e505; cos_rom_2[38] = 20'h3e391; cos_rom_2[39] = 20'h3e214;
        cos_rom_2[40] = 20'h3e08d; cos_rom_2[41] = 20'h3defd; cos_rom_2[42] = 20'h3dd63; cos_rom_2[43] = 20'h3dbc0;
        cos_rom_2[44] = 20'h3da13; cos_rom_2[45] = 20'h3d85c; cos_rom_2[46] = 20'h3d69c; cos_rom_2[47] = 20'h3d4d3;
        cos_rom_2[48] = 20'h3d300; cos_rom_2[49] = 20'h3d124; cos_rom_2[50] = 20'h3cf3e; cos_rom_2[51] = 20'h3cd4f;
        cos_rom_2[52] = 20'h3cb57; cos_rom_2[53] = 20'h3c955; cos_rom_2[54] = 20'h3c749; cos_rom_2[55] = 20'h3c535;
        cos_rom_2[56] = 20'h3c317; cos_rom_2[57] = 20'h3c0f0; cos_rom_2[58] = 20'h3bec0; cos_rom_2[59] = 20'h3bc86;
        cos_rom_2[60] = 20'h3ba43; cos_rom_2[61] = 20'h3b7f7; cos_rom_2[62] = 20'h3b5a2; cos_rom_2[63] = 20'h3b344;
        cos_rom_2[64] = 20'h3b0dc; cos_rom_2[65] = 20'h3ae6c; cos_rom_2[66] = 20'h3abf2; cos_rom_2[67] = 20'h3a96f;
        cos_rom_2[68] = 20'h3a6e4; cos_rom_2[69] = 20'h3a44f; cos_rom_2[70] = 20'h3a1b1; cos_rom_2[71] = 20'h39f0a;
        cos_rom_2[72] = 20'h39c5b; cos_rom_2[73] = 20'h399a2; cos_rom_2[74] = 20'h396e1; cos_rom_2[75] = 20'h39416;
        cos_rom_2[76] = 20'h39143; cos_rom_2[77] = 20'h38e67; cos_rom_2[78] = 20'h38b83; cos_rom_2[79] = 20'h38895;
        cos_rom_2[80] = 20'h3859f; cos_rom_2[81] = 20'h382a0; cos_rom_2[82] = 20'h37f99; cos_rom_2[83] = 20'h37c89;
        cos_rom_2[84] = 20'h37970; cos_rom_2[85] = 20'h3764e; cos_rom_2[86] = 20'h37325; cos_rom_2[87] = 20'h36ff2;
        cos_rom_2[88] = 20'h36cb7; cos_rom_2[89] = 20'h36974; cos_rom_2[90] = 20'h36628; cos_rom_2[91] = 20'h362d4;
        cos_rom_2[92] = 20'h35f78; cos_rom_2[93] = 20'h35c13; cos_rom_2[94] = 20'h358a6; cos_rom_2[95] = 20'h35531;
        cos_rom_2[96] = 20'h351b3; cos_rom_2[97] = 20'h34e2d; cos_rom_2[98] = 20'h34a9f; cos_rom_2[99] = 20'h34709;
        cos_rom_2[100] = 20'h3436b; cos_rom_2[101] = 20'h33fc5; cos_rom_2[102] = 20'h33c17; cos_rom_2[103] = 20'h33861;
        cos_rom_2[104] = 20'h334a3; cos_rom_2[105] = 20'h330dc; cos_rom_2[106] = 20'h32d0f; cos_rom_2[107] = 20'h32939;
        cos_rom_2[108] = 20'h3255b; cos_rom_2[109] = 20'h32176; cos_rom_2[110] = 20'h31d89; cos_rom_2[111] = 20'h31994;
        cos_rom_2[112] = 20'h31598; cos_rom_2[113] = 20'h31194; cos_rom_2[114] = 20'h30d88; cos_rom_2[115] = 20'h30975;
        cos_rom_2[116] = 20'h3055b; cos_rom_2[117] = 20'h30139; cos_rom_2[118] = 20'h2fd0f; cos_rom_2[119] = 20'h2f8df;
        cos_rom_2[120] = 20'h2f4a6; cos_rom_2[121] = 20'h2f067; cos_rom_2[122] = 20'h2ec20; cos_rom_2[123] = 20'h2e7d2;
        cos_rom_2[124] = 20'h2e37d; cos_rom_2[125] = 20'h2df21; cos_rom_2[126] = 20'h2dabe; cos_rom_2[127] = 20'h2d654;
        cos_rom_2[128] = 20'h2d1e2; cos_rom_2[129] = 20'h2cd6a; cos_rom_2[130] = 20'h2c8eb; cos_rom_2[131] = 20'h2c465;
        cos_rom_2[132] = 20'h2bfd8; cos_rom_2[133] = 20'h2bb44; cos_rom_2[134] = 20'h2b6aa; cos_rom_2[135] = 20'h2b209;
        cos_rom_2[136] = 20'h2ad61; cos_rom_2[137] = 20'h2a8b3; cos_rom_2[138] = 20'h2a3fe; cos_rom_2[139] = 20'h29f42;
        cos_rom_2[140] = 20'h29a80; cos_rom_2[141] = 20'h295b8; cos_rom_2[142] = 20'h290e9; cos_rom_2[143] = 20'h28c14;
        cos_rom_2[144] = 20'h28739; cos_rom_2[145] = 20'h28257; cos_rom_2[146] = 20'h27d70; cos_rom_2[147] = 20'h27882;
        cos_rom_2[148] = 20'h2738e; cos_rom_2[149] = 20'h26e94; cos_rom_2[150] = 20'h26994; cos_rom_2[151] = 20'h2648e;
        cos_rom_2[152] = 20'h25f82; cos_rom_2[153] = 20'h25a70; cos_rom_2[154] = 20'h25558; cos_rom_2[155] = 20'h2503b;
        cos_rom_2[156] = 20'h24b18; cos_rom_2[157] = 20'h245ef; cos_rom_2[158] = 20'h240c1; cos_rom_2[159] = 20'h23b8d;
        cos_rom_2[160] = 20'h23654; cos_rom_2[161] = 20'h23115; cos_rom_2[162] = 20'h22bd1; cos_rom_2[163] = 20'h22687;
        cos_rom_2[164] = 20'h22138; cos_rom_2[165] = 20'h21be4; cos_rom_2[166] = 20'h2168b; cos_rom_2[167] = 20'h2112c;
        cos_rom_2[168] = 20'h20bc9; cos_rom_2[169] = 20'h20660; cos_rom_2[170] = 20'h200f2; cos_rom_2[171] = 20'h1fb80;
        cos_rom_2[172] = 20'h1f608; cos_rom_2[173] = 20'h1f08c; cos_rom_2[174] = 20'h1eb0b; cos_rom_2[175] = 20'h1e585;
        cos_rom_2[176] = 20'h1dffb; cos_rom_2[177] = 20'h1da6b; cos_rom_2[178] = 20'h1d4d8; cos_rom_2[179] = 20'h1cf3f;
        cos_rom_2[180] = 20'h1c9a3; cos_rom_2[181] = 20'h1c402; cos_rom_2[182] = 20'h1be5c; cos_rom_2[183] = 20'h1b8b2;
        cos_rom_2[184] = 20'h1b304; cos_rom_2[185] = 20'h1ad52; cos_rom_2[186] = 20'h1a79c; cos_rom_2[187] = 20'h1a1e1;
        cos_rom_2[188] = 20'h19c23; cos_rom_2[189] = 20'h19660; cos_rom_2[190] = 20'h1909a; cos_rom_2[191] = 20'h18ad0;
        cos_rom_2[192] = 20'h18502; cos_rom_2[193] = 20'h17f30; cos_rom_2[194] = 20'h1795b; cos_rom_2[195] = 20'h17382;
        cos_rom_2[196] = 20'h16da5; cos_rom_2[197] = 20'h167c5; cos_rom_2[198] = 20'h161e1; cos_rom_2[199] = 20'h15bfa;
        cos_rom_2[200] = 20'h1560f; cos_rom_2[201] = 20'h15022; cos_rom_2[202] = 20'h14a31; cos_rom_2[203] = 20'h1443d;
        cos_rom_2[204] = 20'h13e45; cos_rom_2[205] = 20'h1384b; cos_rom_2[206] = 20'h1324e; cos_rom_2[207] = 20'h12c4d;
        cos_rom_2[208] = 20'h1264a; cos_rom_2[209] = 20'h12044; cos_rom_2[210] = 20'h11a3b; cos_rom_2[211] = 20'h11430;
        cos_rom_2[212] = 20'h10e22; cos_rom_2[213] = 20'h10811; cos_rom_2[214] = 20'h101fd; cos_rom_2[215] = 20'h0fbe8;
        cos_rom_2[216] = 20'h0f5cf; cos_rom_2[217] = 20'h0efb5; cos_rom_2[218] = 20'h0e998; cos_rom_2[219] = 20'h0e378;
        cos_rom_2[220] = 20'h0dd57; cos_rom_2[221] = 20'h0d734; cos_rom_2[222] = 20'h0d10e; cos_rom_2[223] = 20'h0cae6;
        cos_rom_2[224] = 20'h0c4bd; cos_rom_2[225] = 20'h0be91; cos_rom_2[226] = 20'h0b864; cos_rom_2[227] = 20'h0b235;
        cos_rom_2[228] = 20'h0ac04; cos_rom_2[229] = 20'h0a5d2; cos_rom_2[230] = 20'h09f9e; cos_rom_2[231] = 20'h09968;
        cos_rom_2[232] = 20'h09331; cos_rom_2[233] = 20'h08cf9; cos_rom_2[234] = 20'h086bf; cos_rom_2[235] = 20'h08084;
        cos_rom_2[236] = 20'h07a47; cos_rom_2[237] = 20'h0740a; cos_rom_2[238] = 20'h06dcb; cos_rom_2[239] = 20'h0678b;
        cos_rom_2[240] = 20'h0614b; cos_rom_2[241] = 20'h05b09; cos_rom_2[242] = 20'h054c6; cos_rom_2[243] = 20'h04e83;
        cos_rom_2[244] = 20'h0483f; cos_rom_2[245] = 20'h041fa; cos_rom_2[246] = 20'h03bb5; cos_rom_2[247] = 20'h0356f;
        cos_rom_2[248] = 20'h02f28; cos_rom_2[249] = 20'h028e1; cos_rom_2[250] = 20'h0229a; cos_rom_2[251] = 20'h01c52;
        cos_rom_2[252] = 20'h0160a; cos_rom_2[253] = 20'h00fc2; cos_rom_2[254] = 20'h00979; cos_rom_2[255] = 20'h00331;
        cos_rom_2[256] = 20'hffce8; cos_rom_2[257] = 20'hff6a0; cos_rom_2[258] = 20'hff058; cos_rom_2[259] = 20'hfea0f;
        cos_rom_2[260] = 20'hfe3c7; cos_rom_2[261] = 20'hfdd80; cos_rom_2[262] = 20'hfd738; cos_rom_2[263] = 20'hfd0f1;
        cos_rom_2[264] = 20'hfcaab; cos_rom_2[265] = 20'hfc465; cos_rom_2[266] = 20'hfbe1f; cos_rom_2[267] = 20'hfb7da;
        cos_rom_2[268] = 20'hfb196; cos_rom_2[269] = 20'hfab53; cos_rom_2[270] = 20'hfa510; cos_rom_2[271] = 20'hf9ecf;
        cos_rom_2[272] = 20'hf988e; cos_rom_2[273] = 20'hf924e; cos_rom_2[274] = 20'hf8c0f; cos_rom_2[275] = 20'hf85d2;
        cos_rom_2[276] = 20'hf7f95; cos_rom_2[277] = 20'hf795a; cos_rom_2[278] = 20'hf7320; cos_rom_2[279] = 20'hf6ce8;
        cos_rom_2[280] = 20'hf66b1; cos_rom_2[281] = 20'hf607b; cos_rom_2[282] = 20'hf5a47; cos_rom_2[283] = 20'hf5415;
        cos_rom_2[284] = 20'hf4de4; cos_rom_2[285] = 20'hf47b5; cos_rom_2[286] = 20'hf4187; cos_rom_2[287] = 20'hf3b5c;
        cos_rom_2[288] = 20'hf3532; cos_rom_2[289] = 20'hf2f0b; cos_rom_2[290] = 20'hf28e5; cos_rom_2[291] = 20'hf22c1;
        cos_rom_2[292] = 20'hf1ca0; cos_rom_2[293] = 20'hf1681; cos_rom_2[294] = 20'hf1064; cos_rom_2[295] = 20'hf0a49;
        cos_rom_2[296] = 20'hf0431; cos_rom_2[297] = 20'hefe1b; cos_rom_2[298] = 20'hef808; cos_rom_2[299] = 20'hef1f7;
        cos_rom_2[300] = 20'heebe8; cos_rom_2[301] = 20'hee5dd; cos_rom_2[302] = 20'hedfd4; cos_rom_2[303] = 20'hed9ce;
        cos_rom_2[304] = 20'hed3cb; cos_rom_2[305] = 20'hecdca; cos_rom_2[306] = 20'hec7cd; cos_rom_2[307] = 20'hec1d3;
        cos_rom_2[308] = 20'hebbdb; cos_rom_2[309] = 20'heb5e7; cos_rom_2[310] = 20'heaff6; cos_rom_2[311] = 20'heaa08;
        cos_rom_2[312] = 20'hea41e; cos_rom_2[313] = 20'he9e37; cos_rom_2[314] = 20'he9853; cos_rom_2[315] = 20'he9273;
        cos_rom_2[316] = 20'he8c96; cos_rom_2[317] = 20'he86bd; cos_rom_2[318] = 20'he80e7; cos_rom_2[319] = 20'he7b15;
        cos_rom_2[320] = 20'he7547; cos_rom_2[321] = 20'he6f7d; cos_rom_2[322] = 20'he69b7; cos_rom_2[323] = 20'he63f4;
        cos_rom_2[324] = 20'he5e36; cos_rom_2[325] = 20'he587b; cos_rom_2[326] = 20'he52c5; cos_rom_2[327] = 20'he4d12;
        cos_rom_2[328] = 20'he4764; cos_rom_2[329] = 20'he41bb; cos_rom_2[330] = 20'he3c15; cos_rom_2[331] = 20'he3674;
        cos_rom_2[332] = 20'he30d7; cos_rom_2[333] = 20'he2b3f; cos_rom_2[334] = 20'he25ab; cos_rom_2[335] = 20'he201c;
        cos_rom_2[336] = 20'he1a91; cos_rom_2[337] = 20'he150b; cos_rom_2[338] = 20'he0f8a; cos_rom_2[339] = 20'he0a0e;
        cos_rom_2[340] = 20'he0496; cos_rom_2[341] = 20'hdff23; cos_rom_2[342] = 20'hdf9b6; cos_rom_2[343] = 20'hdf44d;
        cos_rom_2[344] = 20'hdeee9; cos_rom_2[345] = 20'hde98b; cos_rom_2[346] = 20'hde431; cos_rom_2[347] = 20'hddedd;
        cos_rom_2[348] = 20'hdd98e; cos_rom_2[349] = 20'hdd444; cos_rom_2[350] = 20'hdcf00; cos_rom_2[351] = 20'hdc9c1;
        cos_rom_2[352] = 20'hdc488; cos_rom_2[353] = 20'hdbf54; cos_rom_2[354] = 20'hdba25; cos_rom_2[355] = 20'hdb4fd;
        cos_rom_2[356] = 20'hdafd9; cos_rom_2[357] = 20'hdaabc; cos_rom_2[358] = 20'hda5a4; cos_rom_2[359] = 20'hda093;
        cos_rom_2[360] = 20'hd9b87; cos_rom_2[361] = 20'hd9680; cos_rom_2[362] = 20'hd9180; cos_rom_2[363] = 20'hd8c86;
        cos_rom_2[364] = 20'hd8792; cos_rom_2[365] = 20'hd82a4; cos_rom_2[366] = 20'hd7dbc; cos_rom_2[367] = 20'hd78db;
        cos_rom_2[368] = 20'hd73ff; cos_rom_2[369] = 20'hd6f2a; cos_rom_2[370] = 20'hd6a5b; cos_rom_2[371] = 20'hd6593;
        cos_rom_2[372] = 20'hd60d1; cos_rom_2[373] = 20'hd5c15; cos_rom_2[374] = 20'hd5760; cos_rom_2[375] = 20'hd52b2;
        cos_rom_2[376] = 20'hd4e0a; cos_rom_2[377] = 20'hd4969; cos_rom_2[378] = 20'hd44ce; cos_rom_2[379] = 20'hd403a;
        cos_rom_2[380] = 20'hd3bad; cos_rom_2[381] = 20'hd3727; cos_rom_2[382] = 20'hd32a8; cos_rom_2[383] = 20'hd2e30;
        cos_rom_2[384] = 20'hd29be; cos_rom_2[385] = 20'hd2554; cos_rom_2[386] = 20'hd20f0; cos_rom_2[387] = 20'hd1c94;
        cos_rom_2[388] = 20'hd183f; cos_rom_2[389] = 20'hd13f1; cos_rom_2[390] = 20'hd0faa; cos_rom_2[391] = 20'hd0b6a;
        cos_rom_2[392] = 20'hd0732; cos_rom_2[393] = 20'hd0301; cos_rom_2[394] = 20'hcfed8; cos_rom_2[395] = 20'hcfab6;
        cos_rom_2[396] = 20'hcf69b; cos_rom_2[397] = 20'hcf288; cos_rom_2[398] = 20'hcee7c; cos_rom_2[399] = 20'hcea78;
        cos_rom_2[400] = 20'hce67c; cos_rom_2[401] = 20'hce287; cos_rom_2[402] = 20'hcde9a; cos_rom_2[403] = 20'hcdab4;
        cos_rom_2[404] = 20'hcd6d7; cos_rom_2[405] = 20'hcd301; cos_rom_2[406] = 20'hccf33; cos_rom_2[407] = 20'hccb6d;
        cos_rom_2[408] = 20'hcc7ae; cos_rom_2[409] = 20'hcc3f8; cos_rom_2[410] = 20'hcc04a; cos_rom_2[411] = 20'hcbca3;
        cos_rom_2[412] = 20'hcb905; cos_rom_2[413] = 20'hcb56f; cos_rom_2[414] = 20'hcb1e1; cos_rom_2[415] = 20'hcae5b;
        cos_rom_2[416] = 20'hcaadd; cos_rom_2[417] = 20'hca768; cos_rom_2[418] = 20'hca3fb; cos_rom_2[419] = 20'hca096;
        cos_rom_2[420] = 20'hc9d39; cos_rom_2[421] = 20'hc99e5; cos_rom_2[422] = 20'hc9699; cos_rom_2[423] = 20'hc9356;
        cos_rom_2[424] = 20'hc901b; cos_rom_2[425] = 20'hc8ce8; cos_rom_2[426] = 20'hc89be; cos_rom_2[427] = 20'hc869d;
        cos_rom_2[428] = 20'hc8384; cos_rom_2[429] = 20'hc8073; cos_rom_2[430] = 20'hc7d6c; cos_rom_2[431] = 20'hc7a6d;
        cos_rom_2[432] = 20'hc7777; cos_rom_2[433] = 20'hc7489; cos_rom_2[434] = 20'hc71a4; cos_rom_2[435] = 20'hc6ec8;
        cos_rom_2[436] = 20'hc6bf5; cos_rom_2[437] = 20'hc692a; cos_rom_2[438] = 20'hc6669; cos_rom_2[439] = 20'hc63b0;
        cos_rom_2[440] = 20'hc6100; cos_rom_2[441] = 20'hc5e59; cos_rom_2[442] = 20'hc5bbc; cos_rom_2[443] = 20'hc5927;
        cos_rom_2[444] = 20'hc569b; cos_rom_2[445] = 20'hc5418; cos_rom_2[446] = 20'hc519e; cos_rom_2[447] = 20'hc4f2d;
        cos_rom_2[448] = 20'hc4cc6; cos_rom_2[449] = 20'hc4a67; cos_rom_2[450] = 20'hc4812; cos_rom_2[451] = 20'hc45c6;
        cos_rom_2[452] = 20'hc4383; cos_rom_2[453] = 20'hc4149; cos_rom_2[454] = 20'hc3f19; cos_rom_2[455] = 20'hc3cf1;
        cos_rom_2[456] = 20'hc3ad3; cos_rom_2[457] = 20'hc38bf; cos_rom_2[458] = 20'hc36b3; cos_rom_2[459] = 20'hc34b1;
        cos_rom_2[460] = 20'hc32b9; cos_rom_2[461] = 20'hc30ca; cos_rom_2[462] = 20'hc2ee4; cos_rom_2[463] = 20'hc2d07;
        cos_rom_2[464] = 20'hc2b34; cos_rom_2[465] = 20'hc296b; cos_rom_2[466] = 20'hc27ab; cos_rom_2[467] = 20'hc25f4;
        cos_rom_2[468] = 20'hc2447; cos_rom_2[469] = 20'hc22a3; cos_rom_2[470] = 20'hc2109; cos_rom_2[471] = 20'hc1f79;
        cos_rom_2[472] = 20'hc1df2; cos_rom_2[473] = 20'hc1c75; cos_rom_2[474] = 20'hc1b01; cos_rom_2[475] = 20'hc1997;
        cos_rom_2[476] = 20'hc1836; cos_rom_2[477] = 20'hc16e0; cos_rom_2[478] = 20'hc1592; cos_rom_2[479] = 20'hc144f;
        cos_rom_2[480] = 20'hc1315; cos_rom_2[481] = 20'hc11e5; cos_rom_2[482] = 20'hc10be; cos_rom_2[483] = 20'hc0fa1;
        cos_rom_2[484] = 20'hc0e8e; cos_rom_2[485] = 20'hc0d85; cos_rom_2[486] = 20'hc0c85; cos_rom_2[487] = 20'hc0b90;
        cos_rom_2[488] = 20'hc0aa4; cos_rom_2[489] = 20'hc09c1; cos_rom_2[490] = 20'hc08e9; cos_rom_2[491] = 20'hc081a;
        cos_rom_2[492] = 20'hc0755; cos_rom_2[493] = 20'hc069a; cos_rom_2[494] = 20'hc05e8; cos_rom_2[495] = 20'hc0541;
        cos_rom_2[496] = 20'hc04a3; cos_rom_2[497] = 20'hc040f; cos_rom_2[498] = 20'hc0385; cos_rom_2[499] = 20'hc0305;
        cos_rom_2[500] = 20'hc028e; cos_rom_2[501] = 20'hc0222; cos_rom_2[502] = 20'hc01bf; cos_rom_2[503] = 20'hc0166;
        cos_rom_2[504] = 20'hc0117; cos_rom_2[505] = 20'hc00d2; cos_rom_2[506] = 20'hc0097; cos_rom_2[507] = 20'hc0065;
        cos_rom_2[508] = 20'hc003e; cos_rom_2[509] = 20'hc0020; cos_rom_2[510] = 20'hc000c; cos_rom_2[511] = 20'hc0002;
        cos_rom_2[512] = 20'hc0002; cos_rom_2[513] = 20'hc000c; cos_rom_2[514] = 20'hc0020; cos_rom_2[515] = 20'hc003d;
        cos_rom_2[516] = 20'hc0065; cos_rom_2[517] = 20'hc0096; cos_rom_2[518] = 20'hc00d1; cos_rom_2[519] = 20'hc0116;
        cos_rom_2[520] = 20'hc0165; cos_rom_2[521] = 20'hc01be; cos_rom_2[522] = 20'hc0220; cos_rom_2[523] = 20'hc028d;
        cos_rom_2[524] = 20'hc0303; cos_rom_2[525] = 20'hc0383; cos_rom_2[526] = 20'hc040d; cos_rom_2[527] = 20'hc04a1;
        cos_rom_2[528] = 20'hc053e; cos_rom_2[529] = 20'hc05e6; cos_rom_2[530] = 20'hc0697; cos_rom_2[531] = 20'hc0752;
        cos_rom_2[532] = 20'hc0817; cos_rom_2[533] = 20'hc08e5; cos_rom_2[534] = 20'hc09be; cos_rom_2[535] = 20'hc0aa0;
        cos_rom_2[536] = 20'hc0b8c; cos_rom_2[537] = 20'hc0c82; cos_rom_2[538] = 20'hc0d81; cos_rom_2[539] = 20'hc0e8a;
        cos_rom_2[540] = 20'hc0f9d; cos_rom_2[541] = 20'hc10ba; cos_rom_2[542] = 20'hc11e0; cos_rom_2[543] = 20'hc1310;
        cos_rom_2[544] = 20'hc144a; cos_rom_2[545] = 20'hc158d; cos_rom_2[546] = 20'hc16da; cos_rom_2[547] = 20'hc1831;
        cos_rom_2[548] = 20'hc1991; cos_rom_2[549] = 20'hc1afb; cos_rom_2[550] = 20'hc1c6f; cos_rom_2[551] = 20'hc1dec;
        cos_rom_2[552] = 20'hc1f73; cos_rom_2[553] = 20'hc2103; cos_rom_2[554] = 20'hc229d; cos_rom_2[555] = 20'hc2440;
        cos_rom_2[556] = 20'hc25ed; cos_rom_2[557] = 20'hc27a4; cos_rom_2[558] = 20'hc2964; cos_rom_2[559] = 20'hc2b2d;
        cos_rom_2[560] = 20'hc2d00; cos_rom_2[561] = 20'hc2edc; cos_rom_2[562] = 20'hc30c2; cos_rom_2[563] = 20'hc32b1;
        cos_rom_2[564] = 20'hc34a9; cos_rom_2[565] = 20'hc36ab; cos_rom_2[566] = 20'hc38b7; cos_rom_2[567] = 20'hc3acb;
        cos_rom_2[568] = 20'hc3ce9; cos_rom_2[569] = 20'hc3f10; cos_rom_2[570] = 20'hc4140; cos_rom_2[571] = 20'hc437a;
        cos_rom_2[572] = 20'hc45bd; cos_rom_2[573] = 20'hc4809; cos_rom_2[574] = 20'hc4a5e; cos_rom_2[575] = 20'hc4cbc;
        cos_rom_2[576] = 20'hc4f24; cos_rom_2[577] = 20'hc5194; cos_rom_2[578] = 20'hc540e; cos_rom_2[579] = 20'hc5691;
        cos_rom_2[580] = 20'hc591c; cos_rom_2[581] = 20'hc5bb1; cos_rom_2[582] = 20'hc5e4f; cos_rom_2[583] = 20'hc60f6;
        cos_rom_2[584] = 20'hc63a5; cos_rom_2[585] = 20'hc665e; cos_rom_2[586] = 20'hc691f; cos_rom_2[587] = 20'hc6bea;
        cos_rom_2[588] = 20'hc6ebd; cos_rom_2[589] = 20'hc7199; cos_rom_2[590] = 20'hc747d; cos_rom_2[591] = 20'hc776b;
        cos_rom_2[592] = 20'hc7a61; cos_rom_2[593] = 20'hc7d60; cos_rom_2[594] = 20'hc8067; cos_rom_2[595] = 20'hc8377;
        cos_rom_2[596] = 20'hc8690; cos_rom_2[597] = 20'hc89b2; cos_rom_2[598] = 20'hc8cdb; cos_rom_2[599] = 20'hc900e;
        cos_rom_2[600] = 20'hc9349; cos_rom_2[601] = 20'hc968c; cos_rom_2[602] = 20'hc99d8; cos_rom_2[603] = 20'hc9d2c;
        cos_rom_2[604] = 20'hca088; cos_rom_2[605] = 20'hca3ed; cos_rom_2[606] = 20'hca75a; cos_rom_2[607] = 20'hcaacf;
        cos_rom_2[608] = 20'hcae4d; cos_rom_2[609] = 20'hcb1d3; cos_rom_2[610] = 20'hcb561; cos_rom_2[611] = 20'hcb8f7;
        cos_rom_2[612] = 20'hcbc95; cos_rom_2[613] = 20'hcc03b; cos_rom_2[614] = 20'hcc3e9; cos_rom_2[615] = 20'hcc79f;
        cos_rom_2[616] = 20'hccb5d; cos_rom_2[617] = 20'hccf24; cos_rom_2[618] = 20'hcd2f1; cos_rom_2[619] = 20'hcd6c7;
        cos_rom_2[620] = 20'hcdaa5; cos_rom_2[621] = 20'hcde8a; cos_rom_2[622] = 20'hce277; cos_rom_2[623] = 20'hce66c;
        cos_rom_2[624] = 20'hcea68; cos_rom_2[625] = 20'hcee6c; cos_rom_2[626] = 20'hcf278; cos_rom_2[627] = 20'hcf68b;
        cos_rom_2[628] = 20'hcfaa5; cos_rom_2[629] = 20'hcfec7; cos_rom_2[630] = 20'hd02f1; cos_rom_2[631] = 20'hd0721;
        cos_rom_2[632] = 20'hd0b5a; cos_rom_2[633] = 20'hd0f99; cos_rom_2[634] = 20'hd13e0; cos_rom_2[635] = 20'hd182e;
        cos_rom_2[636] = 20'hd1c83; cos_rom_2[637] = 20'hd20df; cos_rom_2[638] = 20'hd2542; cos_rom_2[639] = 20'hd29ac;
        cos_rom_2[640] = 20'hd2e1e; cos_rom_2[641] = 20'hd3296; cos_rom_2[642] = 20'hd3715; cos_rom_2[643] = 20'hd3b9b;
        cos_rom_2[644] = 20'hd4028; cos_rom_2[645] = 20'hd44bc; cos_rom_2[646] = 20'hd4956; cos_rom_2[647] = 20'hd4df7;
        cos_rom_2[648] = 20'hd529f; cos_rom_2[649] = 20'hd574d; cos_rom_2[650] = 20'hd5c02; cos_rom_2[651] = 20'hd60be;
        cos_rom_2[652] = 20'hd6580; cos_rom_2[653] = 20'hd6a48; cos_rom_2[654] = 20'hd6f17; cos_rom_2[655] = 20'hd73ec;
        cos_rom_2[656] = 20'hd78c7; cos_rom_2[657] = 20'hd7da9; cos_rom_2[658] = 20'hd8290; cos_rom_2[659] = 20'hd877e;
        cos_rom_2[660] = 20'hd8c72; cos_rom_2[661] = 20'hd916c; cos_rom_2[662] = 20'hd966c; cos_rom_2[663] = 20'hd9b72;
        cos_rom_2[664] = 20'hda07e; cos_rom_2[665] = 20'hda590; cos_rom_2[666] = 20'hdaaa8; cos_rom_2[667] = 20'hdafc5;
        cos_rom_2[668] = 20'hdb4e8; cos_rom_2[669] = 20'hdba11; cos_rom_2[670] = 20'hdbf3f; cos_rom_2[671] = 20'hdc473;
        cos_rom_2[672] = 20'hdc9ac; cos_rom_2[673] = 20'hdceeb; cos_rom_2[674] = 20'hdd42f; cos_rom_2[675] = 20'hdd979;
        cos_rom_2[676] = 20'hddec8; cos_rom_2[677] = 20'hde41c; cos_rom_2[678] = 20'hde975; cos_rom_2[679] = 20'hdeed4;
        cos_rom_2[680] = 20'hdf437; cos_rom_2[681] = 20'hdf9a0; cos_rom_2[682] = 20'hdff0e; cos_rom_2[683] = 20'he0480;
        cos_rom_2[684] = 20'he09f8; cos_rom_2[685] = 20'he0f74; cos_rom_2[686] = 20'he14f5; cos_rom_2[687] = 20'he1a7b;
        cos_rom_2[688] = 20'he2005; cos_rom_2[689] = 20'he2595; cos_rom_2[690] = 20'he2b28; cos_rom_2[691] = 20'he30c1;
        cos_rom_2[692] = 20'he365d; cos_rom_2[693] = 20'he3bfe; cos_rom_2[694] = 20'he41a4; cos_rom_2[695] = 20'he474e;
        cos_rom_2[696] = 20'he4cfc; cos_rom_2[697] = 20'he52ae; cos_rom_2[698] = 20'he5864; cos_rom_2[699] = 20'he5e1f;
        cos_rom_2[700] = 20'he63dd; cos_rom_2[701] = 20'he69a0; cos_rom_2[702] = 20'he6f66; cos_rom_2[703] = 20'he7530;
        cos_rom_2[704] = 20'he7afe; cos_rom_2[705] = 20'he80d0; cos_rom_2[706] = 20'he86a5; cos_rom_2[707] = 20'he8c7e;
        cos_rom_2[708] = 20'he925b; cos_rom_2[709] = 20'he983b; cos_rom_2[710] = 20'he9e1f; cos_rom_2[711] = 20'hea406;
        cos_rom_2[712] = 20'hea9f1; cos_rom_2[713] = 20'heafde; cos_rom_2[714] = 20'heb5cf; cos_rom_2[715] = 20'hebbc3;
        cos_rom_2[716] = 20'hec1bb; cos_rom_2[717] = 20'hec7b5; cos_rom_2[718] = 20'hecdb2; cos_rom_2[719] = 20'hed3b3;
        cos_rom_2[720] = 20'hed9b6; cos_rom_2[721] = 20'hedfbc; cos_rom_2[722] = 20'hee5c5; cos_rom_2[723] = 20'heebd0;
        cos_rom_2[724] = 20'hef1de; cos_rom_2[725] = 20'hef7ef; cos_rom_2[726] = 20'hefe03; cos_rom_2[727] = 20'hf0418;
        cos_rom_2[728] = 20'hf0a31; cos_rom_2[729] = 20'hf104b; cos_rom_2[730] = 20'hf1668; cos_rom_2[731] = 20'hf1c88;
        cos_rom_2[732] = 20'hf22a9; cos_rom_2[733] = 20'hf28cc; cos_rom_2[734] = 20'hf2ef2; cos_rom_2[735] = 20'hf351a;
        cos_rom_2[736] = 20'hf3b43; cos_rom_2[737] = 20'hf416f; cos_rom_2[738] = 20'hf479c; cos_rom_2[739] = 20'hf4dcb;
        cos_rom_2[740] = 20'hf53fc; cos_rom_2[741] = 20'hf5a2e; cos_rom_2[742] = 20'hf6062; cos_rom_2[743] = 20'hf6698;
        cos_rom_2[744] = 20'hf6ccf; cos_rom_2[745] = 20'hf7307; cos_rom_2[746] = 20'hf7941; cos_rom_2[747] = 20'hf7f7c;
        cos_rom_2[748] = 20'hf85b9; cos_rom_2[749] = 20'hf8bf6; cos_rom_2[750] = 20'hf9235; cos_rom_2[751] = 20'hf9875;
        cos_rom_2[752] = 20'hf9eb5; cos_rom_2[753] = 20'hfa4f7; cos_rom_2[754] = 20'hfab3a; cos_rom_2[755] = 20'hfb17d;
        cos_rom_2[756] = 20'hfb7c1; cos_rom_2[757] = 20'hfbe06; cos_rom_2[758] = 20'hfc44b; cos_rom_2[759] = 20'hfca91;
        cos_rom_2[760] = 20'hfd0d8; cos_rom_2[761] = 20'hfd71f; cos_rom_2[762] = 20'hfdd66; cos_rom_2[763] = 20'hfe3ae;
        cos_rom_2[764] = 20'hfe9f6; cos_rom_2[765] = 20'hff03e; cos_rom_2[766] = 20'hff687; cos_rom_2[767] = 20'hffccf;
        cos_rom_2[768] = 20'h00318; cos_rom_2[769] = 20'h00960; cos_rom_2[770] = 20'h00fa8; cos_rom_2[771] = 20'h015f1;
        cos_rom_2[772] = 20'h01c39; cos_rom_2[773] = 20'h02280; cos_rom_2[774] = 20'h028c8; cos_rom_2[775] = 20'h02f0f;
        cos_rom_2[776] = 20'h03555; cos_rom_2[777] = 20'h03b9b; cos_rom_2[778] = 20'h041e1; cos_rom_2[779] = 20'h04826;
        cos_rom_2[780] = 20'h04e6a; cos_rom_2[781] = 20'h054ad; cos_rom_2[782] = 20'h05af0; cos_rom_2[783] = 20'h06131;
        cos_rom_2[784] = 20'h06772; cos_rom_2[785] = 20'h06db2; cos_rom_2[786] = 20'h073f1; cos_rom_2[787] = 20'h07a2e;
        cos_rom_2[788] = 20'h0806b; cos_rom_2[789] = 20'h086a6; cos_rom_2[790] = 20'h08ce0; cos_rom_2[791] = 20'h09318;
        cos_rom_2[792] = 20'h0994f; cos_rom_2[793] = 20'h09f85; cos_rom_2[794] = 20'h0a5b9; cos_rom_2[795] = 20'h0abeb;
        cos_rom_2[796] = 20'h0b21c; cos_rom_2[797] = 20'h0b84b; cos_rom_2[798] = 20'h0be79; cos_rom_2[799] = 20'h0c4a4;
        cos_rom_2[800] = 20'h0cace; cos_rom_2[801] = 20'h0d0f5; cos_rom_2[802] = 20'h0d71b; cos_rom_2[803] = 20'h0dd3f;
        cos_rom_2[804] = 20'h0e360; cos_rom_2[805] = 20'h0e97f; cos_rom_2[806] = 20'h0ef9c; cos_rom_2[807] = 20'h0f5b7;
        cos_rom_2[808] = 20'h0fbcf; cos_rom_2[809] = 20'h101e5; cos_rom_2[810] = 20'h107f8; cos_rom_2[811] = 20'h10e09;
        cos_rom_2[812] = 20'h11418; cos_rom_2[813] = 20'h11a23; cos_rom_2[814] = 20'h1202c; cos_rom_2[815] = 20'h12632;
        cos_rom_2[816] = 20'h12c35; cos_rom_2[817] = 20'h13236; cos_rom_2[818] = 20'h13833; cos_rom_2[819] = 20'h13e2d;
        cos_rom_2[820] = 20'h14425; cos_rom_2[821] = 20'h14a19; cos_rom_2[822] = 20'h1500a; cos_rom_2[823] = 20'h155f8;
        cos_rom_2[824] = 20'h15be2; cos_rom_2[825] = 20'h161c9; cos_rom_2[826] = 20'h167ad; cos_rom_2[827] = 20'h16d8d;
        cos_rom_2[828] = 20'h1736a; cos_rom_2[829] = 20'h17943; cos_rom_2[830] = 20'h17f19; cos_rom_2[831] = 20'h184eb;
        cos_rom_2[832] = 20'h18ab9; cos_rom_2[833] = 20'h19083; cos_rom_2[834] = 20'h19649; cos_rom_2[835] = 20'h19c0c;
        cos_rom_2[836] = 20'h1a1ca; cos_rom_2[837] = 20'h1a785; cos_rom_2[838] = 20'h1ad3b; cos_rom_2[839] = 20'h1b2ee;
        cos_rom_2[840] = 20'h1b89c; cos_rom_2[841] = 20'h1be45; cos_rom_2[842] = 20'h1c3eb; cos_rom_2[843] = 20'h1c98c;
        cos_rom_2[844] = 20'h1cf29; cos_rom_2[845] = 20'h1d4c1; cos_rom_2[846] = 20'h1da55; cos_rom_2[847] = 20'h1dfe4;
        cos_rom_2[848] = 20'h1e56f; cos_rom_2[849] = 20'h1eaf5; cos_rom_2[850] = 20'h1f076; cos_rom_2[851] = 20'h1f5f2;
        cos_rom_2[852] = 20'h1fb6a; cos_rom_2[853] = 20'h200dd; cos_rom_2[854] = 20'h2064a; cos_rom_2[855] = 20'h20bb3;
        cos_rom_2[856] = 20'h21117; cos_rom_2[857] = 20'h21675; cos_rom_2[858] = 20'h21bcf; cos_rom_2[859] = 20'h22123;
        cos_rom_2[860] = 20'h22672; cos_rom_2[861] = 20'h22bbc; cos_rom_2[862] = 20'h23100; cos_rom_2[863] = 20'h2363f;
        cos_rom_2[864] = 20'h23b78; cos_rom_2[865] = 20'h240ac; cos_rom_2[866] = 20'h245db; cos_rom_2[867] = 20'h24b03;
        cos_rom_2[868] = 20'h25027; cos_rom_2[869] = 20'h25544; cos_rom_2[870] = 20'h25a5c; cos_rom_2[871] = 20'h25f6d;
        cos_rom_2[872] = 20'h26479; cos_rom_2[873] = 20'h26980; cos_rom_2[874] = 20'h26e80; cos_rom_2[875] = 20'h2737a;
        cos_rom_2[876] = 20'h2786e; cos_rom_2[877] = 20'h27d5c; cos_rom_2[878] = 20'h28244; cos_rom_2[879] = 20'h28725;
        cos_rom_2[880] = 20'h28c01; cos_rom_2[881] = 20'h290d6; cos_rom_2[882] = 20'h295a5; cos_rom_2[883] = 20'h29a6d;
        cos_rom_2[884] = 20'h29f2f; cos_rom_2[885] = 20'h2a3eb; cos_rom_2[886] = 20'h2a8a0; cos_rom_2[887] = 20'h2ad4e;
        cos_rom_2[888] = 20'h2b1f6; cos_rom_2[889] = 20'h2b697; cos_rom_2[890] = 20'h2bb32; cos_rom_2[891] = 20'h2bfc6;
        cos_rom_2[892] = 20'h2c453; cos_rom_2[893] = 20'h2c8d9; cos_rom_2[894] = 20'h2cd58; cos_rom_2[895] = 20'h2d1d0;
        cos_rom_2[896] = 20'h2d642; cos_rom_2[897] = 20'h2daac; cos_rom_2[898] = 20'h2df10; cos_rom_2[899] = 20'h2e36c;
        cos_rom_2[900] = 20'h2e7c1; cos_rom_2[901] = 20'h2ec0f; cos_rom_2[902] = 20'h2f056; cos_rom_2[903] = 20'h2f496;
        cos_rom_2[904] = 20'h2f8ce; cos_rom_2[905] = 20'h2fcff; cos_rom_2[906] = 20'h30128; cos_rom_2[907] = 20'h3054a;
        cos_rom_2[908] = 20'h30965; cos_rom_2[909] = 20'h30d78; cos_rom_2[910] = 20'h31184; cos_rom_2[911] = 20'h31588;
        cos_rom_2[912] = 20'h31984; cos_rom_2[913] = 20'h31d79; cos_rom_2[914] = 20'h32166; cos_rom_2[915] = 20'h3254c;
        cos_rom_2[916] = 20'h32929; cos_rom_2[917] = 20'h32cff; cos_rom_2[918] = 20'h330cd; cos_rom_2[919] = 20'h33493;
        cos_rom_2[920] = 20'h33852; cos_rom_2[921] = 20'h33c08; cos_rom_2[922] = 20'h33fb6; cos_rom_2[923] = 20'h3435d;
        cos_rom_2[924] = 20'h346fb; cos_rom_2[925] = 20'h34a91; cos_rom_2[926] = 20'h34e1f; cos_rom_2[927] = 20'h351a5;
        cos_rom_2[928] = 20'h35523; cos_rom_2[929] = 20'h35898; cos_rom_2[930] = 20'h35c05; cos_rom_2[931] = 20'h35f6a;
        cos_rom_2[932] = 20'h362c7; cos_rom_2[933] = 20'h3661b; cos_rom_2[934] = 20'h36967; cos_rom_2[935] = 20'h36caa;
        cos_rom_2[936] = 20'h36fe5; cos_rom_2[937] = 20'h37318; cos_rom_2[938] = 20'h37642; cos_rom_2[939] = 20'h37963;
        cos_rom_2[940] = 20'h37c7c; cos_rom_2[941] = 20'h37f8d; cos_rom_2[942] = 20'h38294; cos_rom_2[943] = 20'h38593;
        cos_rom_2[944] = 20'h38889; cos_rom_2[945] = 20'h38b77; cos_rom_2[946] = 20'h38e5c; cos_rom_2[947] = 20'h39138;
        cos_rom_2[948] = 20'h3940b; cos_rom_2[949] = 20'h396d6; cos_rom_2[950] = 20'h39997; cos_rom_2[951] = 20'h39c50;
        cos_rom_2[952] = 20'h39f00; cos_rom_2[953] = 20'h3a1a7; cos_rom_2[954] = 20'h3a444; cos_rom_2[955] = 20'h3a6d9;
        cos_rom_2[956] = 20'h3a965; cos_rom_2[957] = 20'h3abe8; cos_rom_2[958] = 20'h3ae62; cos_rom_2[959] = 20'h3b0d3;
        cos_rom_2[960] = 20'h3b33a; cos_rom_2[961] = 20'h3b599; cos_rom_2[962] = 20'h3b7ee; cos_rom_2[963] = 20'h3ba3a;
        cos_rom_2[964] = 20'h3bc7d; cos_rom_2[965] = 20'h3beb7; cos_rom_2[966] = 20'h3c0e7; cos_rom_2[967] = 20'h3c30f;
        cos_rom_2[968] = 20'h3c52d; cos_rom_2[969] = 20'h3c741; cos_rom_2[970] = 20'h3c94d; cos_rom_2[971] = 20'h3cb4f;
        cos_rom_2[972] = 20'h3cd47; cos_rom_2[973] = 20'h3cf36; cos_rom_2[974] = 20'h3d11c; cos_rom_2[975] = 20'h3d2f9;
        cos_rom_2[976] = 20'h3d4cc; cos_rom_2[977] = 20'h3d695; cos_rom_2[978] = 20'h3d855; cos_rom_2[979] = 20'h3da0c;
        cos_rom_2[980] = 20'h3dbb9; cos_rom_2[981] = 20'h3dd5d; cos_rom_2[982] = 20'h3def7; cos_rom_2[983] = 20'h3e087;
        cos_rom_2[984] = 20'h3e20e; cos_rom_2[985] = 20'h3e38b; cos_rom_2[986] = 20'h3e4ff; cos_rom_2[987] = 20'h3e669;
        cos_rom_2[988] = 20'h3e7ca; cos_rom_2[989] = 20'h3e920; cos_rom_2[990] = 20'h3ea6e; cos_rom_2[991] = 20'h3ebb1;
        cos_rom_2[992] = 20'h3eceb; cos_rom_2[993] = 20'h3ee1b; cos_rom_2[994] = 20'h3ef42; cos_rom_2[995] = 20'h3f05f;
        cos_rom_2[996] = 20'h3f172; cos_rom_2[997] = 20'h3f27b; cos_rom_2[998] = 20'h3f37b; cos_rom_2[999] = 20'h3f470;
        cos_rom_2[1000] = 20'h3f55c; cos_rom_2[1001] = 20'h3f63f; cos_rom_2[1002] = 20'h3f717; cos_rom_2[1003] = 20'h3f7e6;
        cos_rom_2[1004] = 20'h3f8ab; cos_rom_2[1005] = 20'h3f966; cos_rom_2[1006] = 20'h3fa18; cos_rom_2[1007] = 20'h3fabf;
        cos_rom_2[1008] = 20'h3fb5d; cos_rom_2[1009] = 20'h3fbf1; cos_rom_2[1010] = 20'h3fc7b; cos_rom_2[1011] = 20'h3fcfb;
        cos_rom_2[1012] = 20'h3fd72; cos_rom_2[1013] = 20'h3fdde; cos_rom_2[1014] = 20'h3fe41; cos_rom_2[1015] = 20'h3fe9a;
        cos_rom_2[1016] = 20'h3fee9; cos_rom_2[1017] = 20'h3ff2e; cos_rom_2[1018] = 20'h3ff69; cos_rom_2[1019] = 20'h3ff9b;
        cos_rom_2[1020] = 20'h3ffc2; cos_rom_2[1021] = 20'h3ffe0; cos_rom_2[1022] = 20'h3fff4; cos_rom_2[1023] = 20'h3fffe;
    end

    // a copy of table cos: cos s20f18
    (* rom_style = "block" *)
    reg [19:0] cos_rom_3 [0:1023];
    initial begin
        cos_rom_3[0] = 20'h3fffe; cos_rom_3[1] = 20'h3fff4; cos_rom_3[2] = 20'h3ffe0; cos_rom_3[3] = 20'h3ffc3;
        cos_rom_3[4] = 20'h3ff9b; cos_rom_3[5] = 20'h3ff6a; cos_rom_3[6] = 20'h3ff2f; cos_rom_3[7] = 20'h3feea;
        cos_rom_3[8] = 20'h3fe9b; cos_rom_3[9] = 20'h3fe42; cos_rom_3[10] = 20'h3fde0; cos_rom_3[11] = 20'h3fd73;
        cos_rom_3[12] = 20'h3fcfd; cos_rom_3[13] = 20'h3fc7d; cos_rom_3[14] = 20'h3fbf3; cos_rom_3[15] = 20'h3fb5f;
        cos_rom_3[16] = 20'h3fac2; cos_rom_3[17] = 20'h3fa1a; cos_rom_3[18] = 20'h3f969; cos_rom_3[19] = 20'h3f8ae;
        cos_rom_3[20] = 20'h3f7e9; cos_rom_3[21] = 20'h3f71b; cos_rom_3[22] = 20'h3f642; cos_rom_3[23] = 20'h3f560;
        cos_rom_3[24] = 20'h3f474; cos_rom_3[25] = 20'h3f37e; cos_rom_3[26] = 20'h3f27f; cos_rom_3[27] = 20'h3f176;
        cos_rom_3[28] = 20'h3f063; cos_rom_3[29] = 20'h3ef46; cos_rom_3[30] = 20'h3ee20; cos_rom_3[31] = 20'h3ecf0;
        cos_rom_3[32] = 20'h3ebb6; cos_rom_3[33] = 20'h3ea73; cos_rom_3[34] = 20'h3e926; cos_rom_3[35] = 20'h3e7cf;
        cos_rom_3[36] = 20'h3e66f; cos_rom_3[37] = 20'h3e505; cos_rom_3[38] = 20'h3e391; cos_rom_3[39] = 20'h3e214;
        cos_rom_3[40] = 20'h3e08d; cos_rom_3[41] = 20'h3defd; cos_rom_3[42] = 20'h3dd63; cos_rom_3[43] = 20'h3dbc0;
        cos_rom_3[44] = 20'h3da13; cos_rom_3[45] = 20'h3d85c; cos_rom_3[46] = 20'h3d69c; cos_rom_3[47] = 20'h3d4d3;
        cos_rom_3[48] = 20'h3d300; cos_rom_3[49] = 20'h3d124; cos_rom_3[50] = 20'h3cf3e; cos_rom_3[51] = 20'h3cd4f;
        cos_rom_3[52] = 20'h3cb57; cos_rom_3[53] = 20'h3c955; cos_rom_3[54] = 20'h3c749; cos_rom_3[55] = 20'h3c535;
        cos_rom_3[56] = 20'h3c317; cos_rom_3[57] = 20'h3c0f0; cos_rom_3[58] = 20'h3bec0; cos_rom_3[59] = 20'h3bc86;
        cos_rom_3[60] = 20'h3ba43; cos_rom_3[61] = 20'h3b7f7; cos_rom_3[62] = 20'h3b5a2; cos_rom_3[63] = 20'h3b344;
        cos_rom_3[64] = 20'h3b0dc; cos_rom_3[65] = 20'h3ae6c; cos_rom_3[66] = 20'h3abf2; cos_rom_3[67] = 20'h3a96f;
        cos_rom_3[68] = 20'h3a6e4; cos_rom_3[69] = 20'h3a44f; cos_rom_3[70] = 20'h3a1b1; cos_rom_3[71] = 20'h39f0a;
        cos_rom_3[72] = 20'h39c5b; cos_rom_3[73] = 20'h399a2; cos_rom_3[74] = 20'h396e1; cos_rom_3[75] = 20'h39416;
        cos_rom_3[76] = 20'h39143; cos_rom_3[77] = 20'h38e67; cos_rom_3[78] = 20'h38b83; cos_rom_3[79] = 20'h38895;
        cos_rom_3[80] = 20'h3859f; cos_rom_3[81] = 20'h382a0; cos_rom_3[82] = 20'h37f99; cos_rom_3[83] = 20'h37c89;
        cos_rom_3[84] = 20'h37970; cos_rom_3[85] = 20'h3764e; cos_rom_3[86] = 20'h37325; cos_rom_3[87] = 20'h36ff2;
        cos_rom_3[88] = 20'h36cb7; cos_rom_3[89] = 20'h36974; cos_rom_3[90] = 20'h36628; cos_rom_3[91] = 20'h362d4;
        cos_rom_3[92] = 20'h35f78; cos_rom_3[93] = 20'h35c13; cos_rom_3[94] = 20'h358a6; cos_rom_3[95] = 20'h35531;
        cos_rom_3[96] = 20'h351b3; cos_rom_3[97] = 20'h34e2d; cos_rom_3[98] = 20'h34a9f; cos_rom_3[99] = 20'h34709;
        cos_rom_3[100] = 20'h3436b; cos_rom_3[101] = 20'h33fc5; cos_rom_3[102] = 20'h33c17; cos_rom_3[103] = 20'h33861;
        cos_rom_3[104] = 20'h334a3; cos_rom_3[105] = 20'h330dc; cos_rom_3[106] = 20'h32d0f; cos_rom_3[107] = 20'h32939;
        cos_rom_3[108] = 20'h3255b; cos_rom_3[109] = 20'h32176; cos_rom_3[110] = 20'h31d89; cos_rom_3[111] = 20'h31994;
        cos_rom_3[112] = 20'h31598; cos_rom_3[113] = 20'h31194; cos_rom_3[114] = 20'h30d88; cos_rom_3[115] = 20'h30975;
        cos_rom_3[116] = 20'h3055b; cos_rom_3[117] = 20'h30139; cos_rom_3[118] = 20'h2fd0f; cos_rom_3[119] = 20'h2f8df;
        cos_rom_3[120] = 20'h2f4a6; cos_rom_3[121] = 20'h2f067; cos_rom_3[122] = 20'h2ec20; cos_rom_3[123] = 20'h2e7d2;
        cos_rom_3[124] = 20'h2e37d; cos_rom_3[125] = 20'h2df21; cos_rom_3[126] = 20'h2dabe; cos_rom_3[127] = 20'h2d654;
        cos_rom_3[128] = 20'h2d1e2; cos_rom_3[129] = 20'h2cd6a; cos_rom_3[130] = 20'h2c8eb; cos_rom_3[131] = 20'h2c465;
        cos_rom_3[132] = 20'h2bfd8; cos_rom_3[133] = 20'h2bb44; cos_rom_3[134] = 20'h2b6aa; cos_rom_3[135] = 20'h2b209;
        cos_rom_3[136] = 20'h2ad61; cos_rom_3[137] = 20'h2a8b3; cos_rom_3[138] = 20'h2a3fe; cos_rom_3[139] = 20'h29f42;
        cos_rom_3[140] = 20'h29a80; cos_rom_3[141] = 20'h295b8; cos_rom_3[142] = 20'h290e9; cos_rom_3[143] = 20'h28c14;
        cos_rom_3[144] = 20'h28739; cos_rom_3[145] = 20'h28257; cos_rom_3[146] = 20'h27d70; cos_rom_3[147] = 20'h27882;
        cos_rom_3[148] = 20'h2738e; cos_rom_3[149] = 20'h26e94; cos_rom_3[150] = 20'h26994; cos_rom_3[151] = 20'h2648e;
        cos_rom_3[152] = 20'h25f82; cos_rom_3[153] = 20'h25a70; cos_rom_3[154] = 20'h25558; cos_rom_3[155] = 20'h2503b;
        cos_rom_3[156] = 20'h24b18; cos_rom_3[157] = 20'h245ef; cos_rom_3[158] = 20'h240c1; cos_rom_3[159] = 20'h23b8d;
        cos_rom_3[160] = 20'h23654; cos_rom_3[161] = 20'h23115; cos_rom_3[162] = 20'h22bd1; cos_rom_3[163] = 20'h22687;
        cos_rom_3[164] = 20'h22138; cos_rom_3[165] = 20'h21be4; cos_rom_3[166] = 20'h2168b; cos_rom_3[167] = 20'h2112c;
        cos_rom_3[168] = 20'h20bc9; cos_rom_3[169] = 20'h20660; cos_rom_3[170] = 20'h200f2; cos_rom_3[171] = 20'h1fb80;
        cos_rom_3[172] = 20'h1f608; cos_rom_3[173] = 20'h1f08c; cos_rom_3[174] = 20'h1eb0b; cos_rom_3[175] = 20'h1e585;
        cos_rom_3[176] = 20'h1dffb; cos_rom_3[177] = 20'h1da6b; cos_rom_3[178] = 20'h1d4d8; cos_rom_3[179] = 20'h1cf3f;
        cos_rom_3[180] = 20'h1c9a3; cos_rom_3[181] = 20'h1c402; cos_rom_3[182] = 20'h1be5c; cos_rom_3[183] = 20'h1b8b2;
        cos_rom_3[184] = 20'h1b304; cos_rom_3[185] = 20'h1ad52; cos_rom_3[186] = 20'h1a79c; cos_rom_3[187] = 20'h1a1e1;
        cos_rom_3[188] = 20'h19c23; cos_rom_3[189] = 20'h19660; cos_rom_3[190] = 20'h1909a; cos_rom_3[191] = 20'h18ad0;
        cos_rom_3[192] = 20'h18502; cos_rom_3[193] = 20'h17f30; cos_rom_3[194] = 20'h1795b; cos_rom_3[195] = 20'h17382;
        cos_rom_3[196] = 20'h16da5; cos_rom_3[197] = 20'h167c5; cos_rom_3[198] = 20'h161e1; cos_rom_3[199] = 20'h15bfa;
        cos_rom_3[200] = 20'h1560f; cos_rom_3[201] = 20'h15022; cos_rom_3[202] = 20'h14a31; cos_rom_3[203] = 20'h1443d;
        cos_rom_3[204] = 20'h13e45; cos_rom_3[205] = 20'h1384b; cos_rom_3[206] = 20'h1324e; cos_rom_3[207] = 20'h12c4d;
        cos_rom_3[208] = 20'h1264a; cos_rom_3[209] = 20'h12044; cos_rom_3[210] = 20'h11a3b; cos_rom_3[211] = 20'h11430;
        cos_rom_3[212] = 20'h10e22; cos_rom_3[213] = 20'h10811; cos_rom_3[214] = 20'h101fd; cos_rom_3[215] = 20'h0fbe8;
        cos_rom_3[216] = 20'h0f5cf; cos_rom_3[217] = 20'h0efb5; cos_rom_3[218] = 20'h0e998; cos_rom_3[219] = 20'h0e378;
        cos_rom_3[220] = 20'h0dd57; cos_rom_3[221] = 20'h0d734; cos_rom_3[222] = 20'h0d10e; cos_rom_3[223] = 20'h0cae6;
        cos_rom_3[224] = 20'h0c4bd; cos_rom_3[225] = 20'h0be91; cos_rom_3[226] = 20'h0b864; cos_rom_3[227] = 20'h0b235;
        cos_rom_3[228] = 20'h0ac04; cos_rom_3[229] = 20'h0a5d2; cos_rom_3[230] = 20'h09f9e; cos_rom_3[231] = 20'h09968;
        cos_rom_3[232] = 20'h09331; cos_rom_3[233] = 20'h08cf9; cos_rom_3[234] = 20'h086bf; cos_rom_3[235] = 20'h08084;
        cos_rom_3[236] = 20'h07a47; cos_rom_3[237] = 20'h0740a; cos_rom_3[238] = 20'h06dcb; cos_rom_3[239] = 20'h0678b;
        cos_rom_3[240] = 20'h0614b; cos_rom_3[241] = 20'h05b09; cos_rom_3[242] = 20'h054c6; cos_rom_3[243] = 20'h04e83;
        cos_rom_3[244] = 20'h0483f; cos_rom_3[245] = 20'h041fa; cos_rom_3[246] = 20'h03bb5; cos_rom_3[247] = 20'h0356f;
        cos_rom_3[248] = 20'h02f28; cos_rom_3[249] = 20'h028e1; cos_rom_3[250] = 20'h0229a; cos_rom_3[251] = 20'h01c52;
        cos_rom_3[252] = 20'h0160a; cos_rom_3[253] = 20'h00fc2; cos_rom_3[254] = 20'h00979; cos_rom_3[255] = 20'h00331;
        cos_rom_3[256] = 20'hffce8; cos_rom_3[257] = 20'hff6a0; cos_rom_3[258] = 20'hff058; cos_rom_3[259] = 20'hfea0f;
        cos_rom_3[260] = 20'hfe3c7; cos_rom_3[261] = 20'hfdd80; cos_rom_3[262] = 20'hfd738; cos_rom_3[263] = 20'hfd0f1;
        cos_rom_3[264] = 20'hfcaab; cos_rom_3[265] = 20'hfc465; cos_rom_3[266] = 20'hfbe1f; cos_rom_3[267] = 20'hfb7da;
        cos_rom_3[268] = 20'hfb196; cos_rom_3[269] = 20'hfab53; cos_rom_3[270] = 20'hfa510; cos_rom_3[271] = 20'hf9ecf;
        cos_rom_3[272] = 20'hf988e; cos_rom_3[273] = 20'hf924e; cos_rom_3[274] = 20'hf8c0f; cos_rom_3[275] = 20'hf85d2;
        cos_rom_3[276] = 20'hf7f95; cos_rom_3[277] = 20'hf795a; cos_rom_3[278] = 20'hf7320; cos_rom_3[279] = 20'hf6ce8;
        cos_rom_3[280] = 20'hf66b1; cos_rom_3[281] = 20'hf607b; cos_rom_3[282] = 20'hf5a47; cos_rom_3[283] = 20'hf5415;
        cos_rom_3[284] = 20'hf4de4; cos_rom_3[285] = 20'hf47b5; cos_rom_3[286] = 20'hf4187; cos_rom_3[287] = 20'hf3b5c;
        cos_rom_3[288] = 20'hf3532; cos_rom_3[289] = 20'hf2f0b; cos_rom_3[290] = 20'hf28e5; cos_rom_3[291] = 20'hf22c1;
        cos_rom_3[292] = 20'hf1ca0; cos_rom_3[293] = 20'hf1681; cos_rom_3[294] = 20'hf1064; cos_rom_3[295] = 20'hf0a49;
        cos_rom_3[296] = 20'hf0431; cos_rom_3[297] = 20'hefe1b; cos_rom_3[298] = 20'hef808; cos_rom_3[299] = 20'hef1f7;
        cos_rom_3[300] = 20'heebe8; cos_rom_3[301] = 20'hee5dd; cos_rom_3[302] = 20'hedfd4; cos_rom_3[303] = 20'hed9ce;
        cos_rom_3[304] = 20'hed3cb; cos_rom_3[305] = 20'hecdca; cos_rom_3[306] = 20'hec7cd; cos_rom_3[307] = 20'hec1d3;
        cos_rom_3[308] = 20'hebbdb; cos_rom_3[309] = 20'heb5e7; cos_rom_3[310] = 20'heaff6; cos_rom_3[311] = 20'heaa08;
        cos_rom_3[312] = 20'hea41e; cos_rom_3[313] = 20'he9e37; cos_rom_3[314] = 20'he9853; cos_rom_3[315] = 20'he9273;
        cos_rom_3[316] = 20'he8c96; cos_rom_3[317] = 20'he86bd; cos_rom_3[318] = 20'he80e7; cos_rom_3[319] = 20'he7b15;
        cos_rom_3[320] = 20'he7547; cos_rom_3[321] = 20'he6f7d; cos_rom_3[322] = 20'he69b7; cos_rom_3[323] = 20'he63f4;
        cos_rom_3[324] = 20'he5e36; cos_rom_3[325] = 20'he587b; cos_rom_3[326] = 20'he52c5; cos_rom_3[327] = 20'he4d12;
        cos_rom_3[328] = 20'he4764; cos_rom_3[329] = 20'he41bb; cos_rom_3[330] = 20'he3c15; cos_rom_3[331] = 20'he3674;
        cos_rom_3[332] = 20'he30d7; cos_rom_3[333] = 20'he2b3f; cos_rom_3[334] = 20'he25ab; cos_rom_3[335] = 20'he201c;
        cos_rom_3[336] = 20'he1a91; cos_rom_3[337] = 20'he150b; cos_rom_3[338] = 20'he0f8a; cos_rom_3[339] = 20'he0a0e;
        cos_rom_3[340] = 20'he0496; cos_rom_3[341] = 20'hdff23; cos_rom_3[342] = 20'hdf9b6; cos_rom_3[343] = 20'hdf44d;
        cos_rom_3[344] = 20'hdeee9; cos_rom_3[345] = 20'hde98b; cos_rom_3[346] = 20'hde431; cos_rom_3[347] = 20'hddedd;
        cos_rom_3[348] = 20'hdd98e; cos_rom_3[349] = 20'hdd444; cos_rom_3[350] = 20'hdcf00; cos_rom_3[351] = 20'hdc9c1;
        cos_rom_3[352] = 20'hdc488; cos_rom_3[353] = 20'hdbf54; cos_rom_3[354] = 20'hdba25; cos_rom_3[355] = 20'hdb4fd;
        cos_rom_3[356] = 20'hdafd9; cos_rom_3[357] = 20'hdaabc; cos_rom_3[358] = 20'hda5a4; cos_rom_3[359] = 20'hda093;
        cos_rom_3[360] = 20'hd9b87; cos_rom_3[361] = 20'hd9680; cos_rom_3[362] = 20'hd9180; cos_rom_3[363] = 20'hd8c86;
        cos_rom_3[364] = 20'hd8792; cos_rom_3[365] = 20'hd82a4; cos_rom_3[366] = 20'hd7dbc; cos_rom_3[367] = 20'hd78db;
        cos_rom_3[368] = 20'hd73ff; cos_rom_3[369] = 20'hd6f2a; cos_rom_3[370] = 20'hd6a5b; cos_rom_3[371] = 20'hd6593;
        cos_rom_3[372] = 20'hd60d1; cos_rom_3[373] = 20'hd5c15; cos_rom_3[374] = 20'hd5760; cos_rom_3[375] = 20'hd52b2;
        cos_rom_3[376] = 20'hd4e0a; cos_rom_3[377] = 20'hd4969; cos_rom_3[378] = 20'hd44ce; cos_rom_3[379] = 20'hd403a;
        cos_rom_3[380] = 20'hd3bad; cos_rom_3[381] = 20'hd3727; cos_rom_3[382] = 20'hd32a8; cos_rom_3[383] = 20'hd2e30;
        cos_rom_3[384] = 20'hd29be; cos_rom_3[385] = 20'hd2554; cos_rom_3[386] = 20'hd20f0; cos_rom_3[387] = 20'hd1c94;
        cos_rom_3[388] = 20'hd183f; cos_rom_3[389] = 20'hd13f1; cos_rom_3[390] = 20'hd0faa; cos_rom_3[391] = 20'hd0b6a;
        cos_rom_3[392] = 20'hd0732; cos_rom_3[393] = 20'hd0301; cos_rom_3[394] = 20'hcfed8; cos_rom_3[395] = 20'hcfab6;
        cos_rom_3[396] = 20'hcf69b; cos_rom_3[397] = 20'hcf288; cos_rom_3[398] = 20'hcee7c; cos_rom_3[399] = 20'hcea78;
        cos_rom_3[400] = 20'hce67c; cos_rom_3[401] = 20'hce287; cos_rom_3[402] = 20'hcde9a; cos_rom_3[403] = 20'hcdab4;
        cos_rom_3[404] = 20'hcd6d7; cos_rom_3[405] = 20'hcd301; cos_rom_3[406] = 20'hccf33; cos_rom_3[407] = 20'hccb6d;
        cos_rom_3[408] = 20'hcc7ae; cos_rom_3[409] = 20'hcc3f8; cos_rom_3[410] = 20'hcc04a; cos_rom_3[411] = 20'hcbca3;
        cos_rom_3[412] = 20'hcb905; cos_rom_3[413] = 20'hcb56f; cos_rom_3[414] = 20'hcb1e1; cos_rom_3[415] = 20'hcae5b;
        cos_rom_3[416] = 20'hcaadd; cos_rom_3[417] = 20'hca768; cos_rom_3[418] = 20'hca3fb; cos_rom_3[419] = 20'hca096;
        cos_rom_3[420] = 20'hc9d39; cos_rom_3[421] = 20'hc99e5; cos_rom_3[422] = 20'hc9699; cos_rom_3[423] = 20'hc9356;
        cos_rom_3[424] = 20'hc901b; cos_rom_3[425] = 20'hc8ce8; cos_rom_3[426] = 20'hc89be; cos_rom_3[427] = 20'hc869d;
        cos_rom_3[428] = 20'hc8384; cos_rom_3[429] = 20'hc8073; cos_rom_3[430] = 20'hc7d6c; cos_rom_3[431] = 20'hc7a6d;
        cos_rom_3[432] = 20'hc7777; cos_rom_3[433] = 20'hc7489; cos_rom_3[434] = 20'hc71a4; cos_rom_3[435] = 20'hc6ec8;
        cos_rom_3[436] = 20'hc6bf5; cos_rom_3[437] = 20'hc692a; cos_rom_3[438] = 20'hc6669; cos_rom_3[439] = 20'hc63b0;
        cos_rom_3[440] = 20'hc6100; cos_rom_3[441] = 20'hc5e59; cos_rom_3[442] = 20'hc5bbc; cos_rom_3[443] = 20'hc5927;
        cos_rom_3[444] = 20'hc569b; cos_rom_3[445] = 20'hc5418; cos_rom_3[446] = 20'hc519e; cos_rom_3[447] = 20'hc4f2d;
        cos_rom_3[448] = 20'hc4cc6; cos_rom_3[449] = 20'hc4a67; cos_rom_3[450] = 20'hc4812; cos_rom_3[451] = 20'hc45c6;
        cos_rom_3[452] = 20'hc4383; cos_rom_3[453] = 20'hc4149; cos_rom_3[454] = 20'hc3f19; cos_rom_3[455] = 20'hc3cf1;
        cos_rom_3[456] = 20'hc3ad3; cos_rom_3[457] = 20'hc38bf; cos_rom_3[458] = 20'hc36b3; cos_rom_3[459] = 20'hc34b1;
        cos_rom_3[460] = 20'hc32b9; cos_rom_3[461] = 20'hc30ca; cos_rom_3[462] = 20'hc2ee4; cos_rom_3[463] = 20'hc2d07;
        cos_rom_3[464] = 20'hc2b34; cos_rom_3[465] = 20'hc296b; cos_rom_3[466] = 20'hc27ab; cos_rom_3[467] = 20'hc25f4;
        cos_rom_3[468] = 20'hc2447; cos_rom_3[469] = 20'hc22a3; cos_rom_3[470] = 20'hc2109; cos_rom_3[471] = 20'hc1f79;
        cos_rom_3[472] = 20'hc1df2; cos_rom_3[473] = 20'hc1c75; cos_rom_3[474] = 20'hc1b01; cos_rom_3[475] = 20'hc1997;
        cos_rom_3[476] = 20'hc1836; cos_rom_3[477] = 20'hc16e0; cos_rom_3[478] = 20'hc1592; cos_rom_3[479] = 20'hc144f;
        cos_rom_3[480] = 20'hc1315; cos_rom_3[481] = 20'hc11e5; cos_rom_3[482] = 20'hc10be; cos_rom_3[483] = 20'hc0fa1;
        cos_rom_3[484] = 20'hc0e8e; cos_rom_3[485] = 20'hc0d85; cos_rom_3[486] = 20'hc0c85; cos_rom_3[487] = 20'hc0b90;
        cos_rom_3[488] = 20'hc0aa4; cos_rom_3[489] = 20'hc09c1; cos_rom_3[490] = 20'hc08e9; cos_rom_3[491] = 20'hc081a;
        cos_rom_3[492] = 20'hc0755; cos_rom_3[493] = 20'hc069a; cos_rom_3[494] = 20'hc05e8; cos_rom_3[495] = 20'hc0541;
        cos_rom_3[496] = 20'hc04a3; cos_rom_3[497] = 20'hc040f; cos_rom_3[498] = 20'hc0385; cos_rom_3[499] = 20'hc0305;
        cos_rom_3[500] = 20'hc028e; cos_rom_3[501] = 20'hc0222; cos_rom_3[502] = 20'hc01bf; cos_rom_3[503] = 20'hc0166;
        cos_rom_3[504] = 20'hc0117; cos_rom_3[505] = 20'hc00d2; cos_rom_3[506] = 20'hc0097; cos_rom_3[507] = 20'hc0065;
        cos_rom_3[508] = 20'hc003e; cos_rom_3[509] = 20'hc0020; cos_rom_3[510] = 20'hc000c; cos_rom_3[511] = 20'hc0002;
        cos_rom_3[512] = 20'hc0002; cos_rom_3[513] = 20'hc000c; cos_rom_3[514] = 20'hc0020; cos_rom_3[515] = 20'hc003d;
        cos_rom_3[516] = 20'hc0065; cos_rom_3[517] = 20'hc0096; cos_rom_3[518] = 20'hc00d1; cos_rom_3[519] = 20'hc0116;
        cos_rom_3[520] = 20'hc0165; cos_rom_3[521] = 20'hc01be; cos_rom_3[522] = 20'hc0220; cos_rom_3[523] = 20'hc028d;
        cos_rom_3[524] = 20'hc0303; cos_rom_3[525] = 20'hc0383; cos_rom_3[526] = 20'hc040d; cos_rom_3[527] = 20'hc04a1;
        cos_rom_3[528] = 20'hc053e; cos_rom_3[529] = 20'hc05e6; cos_rom_3[530] = 20'hc0697; cos_rom_3[531] = 20'hc0752;
        cos_rom_3[532] = 20'hc0817; cos_rom_3[533] = 20'hc08e5; cos_rom_3[534] = 20'hc09be; cos_rom_3[535] = 20'hc0aa0;
        cos_rom_3[536] = 20'hc0b8c; cos_rom_3[537] = 20'hc0c82; cos_rom_3[538] = 20'hc0d81; cos_rom_3[539] = 20'hc0e8a;
        cos_rom_3[540] = 20'hc0f9d; cos_rom_3[541] = 20'hc10ba; cos_rom_3[542] = 20'hc11e0; cos_rom_3[543] = 20'hc1310;
        cos_rom_3[544] = 20'hc144a; cos_rom_3[545] = 20'hc158d; cos_rom_3[546] = 20'hc16da; cos_rom_3[547] = 20'hc1831;
        cos_rom_3[548] = 20'hc1991; cos_rom_3[549] = 20'hc1afb; cos_rom_3[550] = 20'hc1c6f; cos_rom_3[551] = 20'hc1dec;
        cos_rom_3[552] = 20'hc1f73; cos_rom_3[553] = 20'hc2103; cos_rom_3[554] = 20'hc229d; cos_rom_3[555] = 20'hc2440;
        cos_rom_3[556] = 20'hc25ed; cos_rom_3[557] = 20'hc27a4; cos_rom_3[558] = 20'hc2964; cos_rom_3[559] = 20'hc2b2d;
        cos_rom_3[560] = 20'hc2d00; cos_rom_3[561] = 20'hc2edc; cos_rom_3[562] = 20'hc30c2; cos_rom_3[563] = 20'hc32b1;
        cos_rom_3[564] = 20'hc34a9; cos_rom_3[565] = 20'hc36ab; cos_rom_3[566] = 20'hc38b7; cos_rom_3[567] = 20'hc3acb;
        cos_rom_3[568] = 20'hc3ce9; cos_rom_3[569] = 20'hc3f10; cos_rom_3[570] = 20'hc4140; cos_rom_3[571] = 20'hc437a;
        cos_rom_3[572] = 20'hc45bd; cos_rom_3[573] = 20'hc4809; cos_rom_3[574] = 20'hc4a5e; cos_rom_3[575] = 20'hc4cbc;
        cos_rom_3[576] = 20'hc4f24; cos_rom_3[577] = 20'hc5194; cos_rom_3[578] = 20'hc540e; cos_rom_3[579] = 20'hc5691;
        cos_rom_3[580] = 20'hc591c; cos_rom_3[581] = 20'hc5bb1; cos_rom_3[582] = 20'hc5e4f; cos_rom_3[583] = 20'hc60f6;
        cos_rom_3[584] = 20'hc63a5; cos_rom_3[585] = 20'hc665e; cos_rom_3[586] = 20'hc691f; cos_rom_3[587] = 20'hc6bea;
        cos_rom_3[588] = 20'hc6ebd; cos_rom_3[589] = 20'hc7199; cos_rom_3[590] = 20'hc747d; cos_rom_3[591] = 20'hc776b;
        cos_rom_3[592] = 20'hc7a61; cos_rom_3[593] = 20'hc7d60; cos_rom_3[594] = 20'hc8067; cos_rom_3[595] = 20'hc8377;
        cos_rom_3[596] = 20'hc8690; cos_rom_3[597] = 20'hc89b2; cos_rom_3[598] = 20'hc8cdb; cos_rom_3[599] = 20'hc900e;
        cos_rom_3[600] = 20'hc9349; cos_rom_3[601] = 20'hc968c; cos_rom_3[602] = 20'hc99d8; cos_rom_3[603] = 20'hc9d2c;
        cos_rom_3[604] = 20'hca088; cos_rom_3[605] = 20'hca3ed; cos_rom_3[606] = 20'hca75a; cos_rom_3[607] = 20'hcaacf;
        cos_rom_3[608] = 20'hcae4d; cos_rom_3[609] = 20'hcb1d3; cos_rom_3[610] = 20'hcb561; cos_rom_3[611] = 20'hcb8f7;
        cos_rom_3[612] = 20'hcbc95; cos_rom_3[613] = 20'hcc03b; cos_rom_3[614] = 20'hcc3e9; cos_rom_3[615] = 20'hcc79f;
        cos_rom_3[616] = 20'hccb5d; cos_rom_3[617] = 20'hccf24; cos_rom_3[618] = 20'hcd2f1; cos_rom_3[619] = 20'hcd6c7;
        cos_rom_3[620] = 20'hcdaa5; cos_rom_3[621] = 20'hcde8a; cos_rom_3[622] = 20'hce277; cos_rom_3[623] = 20'hce66c;
        cos_rom_3[624] = 20'hcea68; cos_rom_3[625] = 20'hcee6c; cos_rom_3[626] = 20'hcf278; cos_rom_3[627] = 20'hcf68b;
        cos_rom_3[628] = 20'hcfaa5; cos_rom_3[629] = 20'hcfec7; cos_rom_3[630] = 20'hd02f1; cos_rom_3[631] = 20'hd0721;
        cos_rom_3[632] = 20'hd0b5a; cos_rom_3[633] = 20'hd0f99; cos_rom_3[634] = 20'hd13e0; cos_rom_3[635] = 20'hd182e;
        cos_rom_3[636] = 20'hd1c83; cos_rom_3[637] = 20'hd20df; cos_rom_3[638] = 20'hd2542; cos_rom_3[639] = 20'hd29ac;
        cos_rom_3[640] = 20'hd2e1e; cos_rom_3[641] = 20'hd3296; cos_rom_3[642] = 20'hd3715; cos_rom_3[643] = 20'hd3b9b;
        cos_rom_3[644] = 20'hd4028; cos_rom_3[645] = 20'hd44bc; cos_rom_3[646] = 20'hd4956; cos_rom_3[647] = 20'hd4df7;
        cos_rom_3[648] = 20'hd529f; cos_rom_3[649] = 20'hd574d; cos_rom_3[650] = 20'hd5c02; cos_rom_3[651] = 20'hd60be;
        cos_rom_3[652] = 20'hd6580; cos_rom_3[653] = 20'hd6a48; cos_rom_3[654] = 20'hd6f17; cos_rom_3[655] = 20'hd73ec;
        cos_rom_3[656] = 20'hd78c7; cos_rom_3[657] = 20'hd7da9; cos_rom_3[658] = 20'hd8290; cos_rom_3[659] = 20'hd877e;
        cos_rom_3[660] = 20'hd8c72; cos_rom_3[661] = 20'hd916c; cos_rom_3[662] = 20'hd966c; cos_rom_3[663] = 20'hd9b72;
        cos_rom_3[664] = 20'hda07e; cos_rom_3[665] = 20'hda590; cos_rom_3[666] = 20'hdaaa8; cos_rom_3[667] = 20'hdafc5;
        cos_rom_3[668] = 20'hdb4e8; cos_rom_3[669] = 20'hdba11; cos_rom_3[670] = 20'hdbf3f; cos_rom_3[671] = 20'hdc473;
        cos_rom_3[672] = 20'hdc9ac; cos_rom_3[673] = 20'hdceeb; cos_rom_3[674] = 20'hdd42f; cos_rom_3[675] = 20'hdd979;
        cos_rom_3[676] = 20'hddec8; cos_rom_3[677] = 20'hde41c; cos_rom_3[678] = 20'hde975; cos_rom_3[679] = 20'hdeed4;
        cos_rom_3[680] = 20'hdf437; cos_rom_3[681] = 20'hdf9a0; cos_rom_3[682] = 20'hdff0e; cos_rom_3[683] = 20'he0480;
        cos_rom_3[684] = 20'he09f8; cos_rom_3[685] = 20'he0f74; cos_rom_3[686] = 20'he14f5; cos_rom_3[687] = 20'he1a7b;
        cos_rom_3[688] = 20'he2005; cos_rom_3[689] = 20'he2595; cos_rom_3[690] = 20'he2b28; cos_rom_3[691] = 20'he30c1;
        cos_rom_3[692] = 20'he365d; cos_rom_3[693] = 20'he3bfe; cos_rom_3[694] = 20'he41a4; cos_rom_3[695] = 20'he474e;
        cos_rom_3[696] = 20'he4cfc; cos_rom_3[697] = 20'he52ae; cos_rom_3[698] = 20'he5864; cos_rom_3[699] = 20'he5e1f;
        cos_rom_3[700] = 20'he63dd; cos_rom_3[701] = 20'he69a0; cos_rom_3[702] = 20'he6f66; cos_rom_3[703] = 20'he7530;
        cos_rom_3[704] = 20'he7afe; cos_rom_3[705] = 20'he80d0; cos_rom_3[706] = 20'he86a5; cos_rom_3[707] = 20'he8c7e;
        cos_rom_3[708] = 20'he925b; cos_rom_3[709] = 20'he983b; cos_rom_3[710] = 20'he9e1f; cos_rom_3[711] = 20'hea406;
        cos_rom_3[712] = 20'hea9f1; cos_rom_3[713] = 20'heafde; cos_rom_3[714] = 20'heb5cf; cos_rom_3[715] = 20'hebbc3;
        cos_rom_3[716] = 20'hec1bb; cos_rom_3[717] = 20'hec7b5; cos_rom_3[718] = 20'hecdb2; cos_rom_3[719] = 20'hed3b3;
        cos_rom_3[720] = 20'hed9b6; cos_rom_3[721] = 20'hedfbc; cos_rom_3[722] = 20'hee5c5; cos_rom_3[723] = 20'heebd0;
        cos_rom_3[724] = 20'hef1de; cos_rom_3[725] = 20'hef7ef; cos_rom_3[726] = 20'hefe03; cos_rom_3[727] = 20'hf0418;
        cos_rom_3[728] = 20'hf0a31; cos_rom_3[729] = 20'hf104b; cos_rom_3[730] = 20'hf1668; cos_rom_3[731] = 20'hf1c88;
        cos_rom_3[732] = 20'hf22a9; cos_rom_3[733] = 20'hf28cc; cos_rom_3[734] = 20'hf2ef2; cos_rom_3[735] = 20'hf351a;
        cos_rom_3[736] = 20'hf3b43; cos_rom_3[737] = 20'hf416f; cos_rom_3[738] = 20'hf479c; cos_rom_3[739] = 20'hf4dcb;
        cos_rom_3[740] = 20'hf53fc; cos_rom_3[741] = 20'hf5a2e; cos_rom_3[742] = 20'hf6062; cos_rom_3[743] = 20'hf6698;
        cos_rom_3[744] = 20'hf6ccf; cos_rom_3[745] = 20'hf7307; cos_rom_3[746] = 20'hf7941; cos_rom_3[747] = 20'hf7f7c;
        cos_rom_3[748] = 20'hf85b9; cos_rom_3[749] = 20'hf8bf6; cos_rom_3[750] = 20'hf9235; cos_rom_3[751] = 20'hf9875;
        cos_rom_3[752] = 20'hf9eb5; cos_rom_3[753] = 20'hfa4f7; cos_rom_3[754] = 20'hfab3a; cos_rom_3[755] = 20'hfb17d;
        cos_rom_3[756] = 20'hfb7c1; cos_rom_3[757] = 20'hfbe06; cos_rom_3[758] = 20'hfc44b; cos_rom_3[759] = 20'hfca91;
        cos_rom_3[760] = 20'hfd0d8; cos_rom_3[761] = 20'hfd71f; cos_rom_3[762] = 20'hfdd66; cos_rom_3[763] = 20'hfe3ae;
        cos_rom_3[764] = 20'hfe9f6; cos_rom_3[765] = 20'hff03e; cos_rom_3[766] = 20'hff687; cos_rom_3[767] = 20'hffccf;
        cos_rom_3[768] = 20'h00318; cos_rom_3[769] = 20'h00960; cos_rom_3[770] = 20'h00fa8; cos_rom_3[771] = 20'h015f1;
        cos_rom_3[772] = 20'h01c39; cos_rom_3[773] = 20'h02280; cos_rom_3[774] = 20'h028c8; cos_rom_3[775] = 20'h02f0f;
        cos_rom_3[776] = 20'h03555; cos_rom_3[777] = 20'h03b9b; cos_rom_3[778] = 20'h041e1; cos_rom_3[779] = 20'h04826;
        cos_rom_3[780] = 20'h04e6a; cos_rom_3[781] = 20'h054ad; cos_rom_3[782] = 20'h05af0; cos_rom_3[783] = 20'h06131;
        cos_rom_3[784] = 20'h06772; cos_rom_3[785] = 20'h06db2; cos_rom_3[786] = 20'h073f1; cos_rom_3[787] = 20'h07a2e;
        cos_rom_3[788] = 20'h0806b; cos_rom_3[789] = 20'h086a6; cos_rom_3[790] = 20'h08ce0; cos_rom_3[791] = 20'h09318;
        cos_rom_3[792] = 20'h0994f; cos_rom_3[793] = 20'h09f85; cos_rom_3[794] = 20'h0a5b9; cos_rom_3[795] = 20'h0abeb;
        cos_rom_3[796] = 20'h0b21c; cos_rom_3[797] = 20'h0b84b; cos_rom_3[798] = 20'h0be79; cos_rom_3[799] = 20'h0c4a4;
        cos_rom_3[800] = 20'h0cace; cos_rom_3[801] = 20'h0d0f5; cos_rom_3[802] = 20'h0d71b; cos_rom_3[803] = 20'h0dd3f;
        cos_rom_3[804] = 20'h0e360; cos_rom_3[805] = 20'h0e97f; cos_rom_3[806] = 20'h0ef9c; cos_rom_3[807] = 20'h0f5b7;
        cos_rom_3[808] = 20'h0fbcf; cos_rom_3[809] = 20'h101e5; cos_rom_3[810] = 20'h107f8; cos_rom_3[811] = 20'h10e09;
        cos_rom_3[812] = 20'h11418; cos_rom_3[813] = 20'h11a23; cos_rom_3[814] = 20'h1202c; cos_rom_3[815] = 20'h12632;
        cos_rom_3[816] = 20'h12c35; cos_rom_3[817] = 20'h13236; cos_rom_3[818] = 20'h13833; cos_rom_3[819] = 20'h13e2d;
        cos_rom_3[820] = 20'h14425; cos_rom_3[821] = 20'h14a19; cos_rom_3[822] = 20'h1500a; cos_rom_3[823] = 20'h155f8;
        cos_rom_3[824] = 20'h15be2; cos_rom_3[825] = 20'h161c9; cos_rom_3[826] = 20'h167ad; cos_rom_3[827] = 20'h16d8d;
        cos_rom_3[828] = 20'h1736a; cos_rom_3[829] = 20'h17943; cos_rom_3[830] = 20'h17f19; cos_rom_3[831] = 20'h184eb;
        cos_rom_3[832] = 20'h18ab9; cos_rom_3[833] = 20'h19083; cos_rom_3[834] = 20'h19649; cos_rom_3[835] = 20'h19c0c;
        cos_rom_3[836] = 20'h1a1ca; cos_rom_3[837] = 20'h1a785; cos_rom_3[838] = 20'h1ad3b; cos_rom_3[839] = 20'h1b2ee;
        cos_rom_3[840] = 20'h1b89c; cos_rom_3[841] = 20'h1be45; cos_rom_3[842] = 20'h1c3eb; cos_rom_3[843] = 20'h1c98c;
        cos_rom_3[844] = 20'h1cf29; cos_rom_3[845] = 20'h1d4c1; cos_rom_3[846] = 20'h1da55; cos_rom_3[847] = 20'h1dfe4;
        cos_rom_3[848] = 20'h1e56f; cos_rom_3[849] = 20'h1eaf5; cos_rom_3[850] = 20'h1f076; cos_rom_3[851] = 20'h1f5f2;
        cos_rom_3[852] = 20'h1fb6a; cos_rom_3[853] = 20'h200dd; cos_rom_3[854] = 20'h2064a; cos_rom_3[855] = 20'h20bb3;
        cos_rom_3[856] = 20'h21117; cos_rom_3[857] = 20'h21675; cos_rom_3[858] = 20'h21bcf; cos_rom_3[859] = 20'h22123;
        cos_rom_3[860] = 20'h22672; cos_rom_3[861] = 20'h22bbc; cos_rom_3[862] = 20'h23100; cos_rom_3[863] = 20'h2363f;
        cos_rom_3[864] = 20'h23b78; cos_rom_3[865] = 20'h240ac; cos_rom_3[866] = 20'h245db; cos_rom_3[867] = 20'h24b03;
        cos_rom_3[868] = 20'h25027; cos_rom_3[869] = 20'h25544; cos_rom_3[870] = 20'h25a5c; cos_rom_3[871] = 20'h25f6d;
        cos_rom_3[872] = 20'h26479; cos_rom_3[873] = 20'h26980; cos_rom_3[874] = 20'h26e80; cos_rom_3[875] = 20'h2737a;
        cos_rom_3[876] = 20'h2786e; cos_rom_3[877] = 20'h27d5c; cos_rom_3[878] = 20'h28244; cos_rom_3[879] = 20'h28725;
        cos_rom_3[880] = 20'h28c01; cos_rom_3[881] = 20'h290d6; cos_rom_3[882] = 20'h295a5; cos_rom_3[883] = 20'h29a6d;
        cos_rom_3[884] = 20'h29f2f; cos_rom_3[885] = 20'h2a3eb; cos_rom_3[886] = 20'h2a8a0; cos_rom_3[887] = 20'h2ad4e;
        cos_rom_3[888] = 20'h2b1f6; cos_rom_3[889] = 20'h2b697; cos_rom_3[890] = 20'h2bb32; cos_rom_3[891] = 20'h2bfc6;
        cos_rom_3[892] = 20'h2c453; cos_rom_3[893] = 20'h2c8d9; cos_rom_3[894] = 20'h2cd58; cos_rom_3[895] = 20'h2d1d0;
        cos_rom_3[896] = 20'h2d642; cos_rom_3[897] = 20'h2daac; cos_rom_3[898] = 20'h2df10; cos_rom_3[899] = 20'h2e36c;
        cos_rom_3[900] = 20'h2e7c1; cos_rom_3[901] = 20'h2ec0f; cos_rom_3[902] = 20'h2f056; cos_rom_3[903] = 20'h2f496;
        cos_rom_3[904] = 20'h2f8ce; cos_rom_3[905] = 20'h2fcff; cos_rom_3[906] = 20'h30128; cos_rom_3[907] = 20'h3054a;
        cos_rom_3[908] = 20'h30965; cos_rom_3[909] = 20'h30d78; cos_rom_3[910] = 20'h31184; cos_rom_3[911] = 20'h31588;
        cos_rom_3[912] = 20'h31984; cos_rom_3[913] = 20'h31d79; cos_rom_3[914] = 20'h32166; cos_rom_3[915] = 20'h3254c;
        cos_rom_3[916] = 20'h32929; cos_rom_3[917] = 20'h32cff; cos_rom_3[918] = 20'h330cd; cos_rom_3[919] = 20'h33493;
        cos_rom_3[920] = 20'h33852; cos_rom_3[921] = 20'h33c08; cos_rom_3[922] = 20'h33fb6; cos_rom_3[923] = 20'h3435d;
        cos_rom_3[924] = 20'h346fb; cos_rom_3[925] = 20'h34a91; cos_rom_3[926] = 20'h34e1f; cos_rom_3[927] = 20'h351a5;
        cos_rom_3[928] = 20'h35523; cos_rom_3[929] = 20'h35898; cos_rom_3[930] = 20'h35c05; cos_rom_3[931] = 20'h35f6a;
        cos_rom_3[932] = 20'h362c7; cos_rom_3[933] = 20'h3661b; cos_rom_3[934] = 20'h36967; cos_rom_3[935] = 20'h36caa;
        cos_rom_3[936] = 20'h36fe5; cos_rom_3[937] = 20'h37318; cos_rom_3[938] = 20'h37642; cos_rom_3[939] = 20'h37963;
        cos_rom_3[940] = 20'h37c7c; cos_rom_3[941] = 20'h37f8d; cos_rom_3[942] = 20'h38294; cos_rom_3[943] = 20'h38593;
        cos_rom_3[944] = 20'h38889; cos_rom_3[945] = 20'h38b77; cos_rom_3[946] = 20'h38e5c; cos_rom_3[947] = 20'h39138;
        cos_rom_3[948] = 20'h3940b; cos_rom_3[949] = 20'h396d6; cos_rom_3[950] = 20'h39997; cos_rom_3[951] = 20'h39c50;
        cos_rom_3[952] = 20'h39f00; cos_rom_3[953] = 20'h3a1a7; cos_rom_3[954] = 20'h3a444; cos_rom_3[955] = 20'h3a6d9;
        cos_rom_3[956] = 20'h3a965; cos_rom_3[957] = 20'h3abe8; cos_rom_3[958] = 20'h3ae62; cos_rom_3[959] = 20'h3b0d3;
        cos_rom_3[960] = 20'h3b33a; cos_rom_3[961] = 20'h3b599; cos_rom_3[962] = 20'h3b7ee; cos_rom_3[963] = 20'h3ba3a;
        cos_rom_3[964] = 20'h3bc7d; cos_rom_3[965] = 20'h3beb7; cos_rom_3[966] = 20'h3c0e7; cos_rom_3[967] = 20'h3c30f;
        cos_rom_3[968] = 20'h3c52d; cos_rom_3[969] = 20'h3c741; cos_rom_3[970] = 20'h3c94d; cos_rom_3[971] = 20'h3cb4f;
        cos_rom_3[972] = 20'h3cd47; cos_rom_3[973] = 20'h3cf36; cos_rom_3[974] = 20'h3d11c; cos_rom_3[975] = 20'h3d2f9;
        cos_rom_3[976] = 20'h3d4cc; cos_rom_3[977] = 20'h3d695; cos_rom_3[978] = 20'h3d855; cos_rom_3[979] = 20'h3da0c;
        cos_rom_3[980] = 20'h3dbb9; cos_rom_3[981] = 20'h3dd5d; cos_rom_3[982] = 20'h3def7; cos_rom_3[983] = 20'h3e087;
        cos_rom_3[984] = 20'h3e20e; cos_rom_3[985] = 20'h3e38b; cos_rom_3[986] = 20'h3e4ff; cos_rom_3[987] = 20'h3e669;
        cos_rom_3[988] = 20'h3e7ca; cos_rom_3[989] = 20'h3e920; cos_rom_3[990] = 20'h3ea6e; cos_rom_3[991] = 20'h3ebb1;
        cos_rom_3[992] = 20'h3eceb; cos_rom_3[993] = 20'h3ee1b; cos_rom_3[994] = 20'h3ef42; cos_rom_3[995] = 20'h3f05f;
        cos_rom_3[996] = 20'h3f172; cos_rom_3[997] = 20'h3f27b; cos_rom_3[998] = 20'h3f37b; cos_rom_3[999] = 20'h3f470;
        cos_rom_3[1000] = 20'h3f55c; cos_rom_3[1001] = 20'h3f63f; cos_rom_3[1002] = 20'h3f717; cos_rom_3[1003] = 20'h3f7e6;
        cos_rom_3[1004] = 20'h3f8ab; cos_rom_3[1005] = 20'h3f966; cos_rom_3[1006] = 20'h3fa18; cos_rom_3[1007] = 20'h3fabf;
        cos_rom_3[1008] = 20'h3fb5d; cos_rom_3[1009] = 20'h3fbf1; cos_rom_3[1010] = 20'h3fc7b; cos_rom_3[1011] = 20'h3fcfb;
        cos_rom_3[1012] = 20'h3fd72; cos_rom_3[1013] = 20'h3fdde; cos_rom_3[1014] = 20'h3fe41; cos_rom_3[1015] = 20'h3fe9a;
        cos_rom_3[1016] = 20'h3fee9; cos_rom_3[1017] = 20'h3ff2e; cos_rom_3[1018] = 20'h3ff69; cos_rom_3[1019] = 20'h3ff9b;
        cos_rom_3[1020] = 20'h3ffc2; cos_rom_3[1021] = 20'h3ffe0; cos_rom_3[1022] = 20'h3fff4; cos_rom_3[1023] = 20'h3fffe;
    end

    // ---- stage 0 ----
    // dot_l
    wire signed [0:-16] dot_l_n6 = {1'b0, phi_lt} - {1'b0, phi_p}; // s17f16
    wire [-1:-16] dot_l_delta = dot_l_n6[-1:-16]; // u16f16
    wire [0:-16] dot_l_n8 = {1'b0, theta_lt} + {1'b0, theta_p}; // u17f16
    wire [-1:-16] dot_l_sum = dot_l_n8[-1:-16]; // u16f16
    wire signed [0:-16] dot_l_n10 = {1'b0, theta_lt} - {1'b0, theta_p}; // s17f16
    wire [-1:-16] dot_l_difference = dot_l_n10[-1:-16]; // u16f16
    // dot_l.cos
    wire [9:0] dot_l_cos_n12 = dot_l_sum[-1:-10]; // u10f0
    wire [9:0] dot_l_cos_n14 = dot_l_difference[-1:-10]; // u10f0
    wire [9:0] dot_l_cos_n16 = dot_l_delta[-1:-10]; // u10f0
    // dot_h
    wire signed [0:-16] dot_h_n25 = {1'b0, phi_ht} - {1'b0, phi_p}; // s17f16
    wire [-1:-16] dot_h_delta = dot_h_n25[-1:-16]; // u16f16
    wire [0:-16] dot_h_n27 = {1'b0, theta_ht} + {1'b0, theta_p}; // u17f16
    wire [-1:-16] dot_h_sum = dot_h_n27[-1:-16]; // u16f16
    wire signed [0:-16] dot_h_n29 = {1'b0, theta_ht} - {1'b0, theta_p}; // s17f16
    wire [-1:-16] dot_h_difference = dot_h_n29[-1:-16]; // u16f16
    // dot_h.cos
    wire [9:0] dot_h_cos_n31 = dot_h_sum[-1:-10]; // u10f0
    wire [9:0] dot_h_cos_n33 = dot_h_difference[-1:-10]; // u10f0
    wire [9:0] dot_h_cos_n35 = dot_h_delta[-1:-10]; // u10f0
    // (unit)
    wire n44 = 1'b0; // u1f0
    wire [-1:-16] n53 = 16'hb333; // u16f16
    wire [-1:-16] n54 = 16'h199a; // u16f16
    wire [-1:-16] n65 = 16'h4ccd; // u16f16
    wire [-1:-16] n66 = 16'h0; // u16f16

    reg [19:0] cos_row;
    reg [19:0] cos_row_2;
    reg [19:0] cos_row_3;
    reg [19:0] cos_row_4;
    reg [19:0] cos_row_5;
    reg [19:0] cos_row_6;
    always @(posedge clk)
        if (ce) begin
            cos_row <= cos_rom[dot_l_cos_n12];
            cos_row_2 <= cos_rom[dot_l_cos_n14];
            cos_row_3 <= cos_rom_2[dot_l_cos_n16];
            cos_row_4 <= cos_rom_2[dot_h_cos_n31];
            cos_row_5 <= cos_rom_3[dot_h_cos_n33];
            cos_row_6 <= cos_rom_3[dot_h_cos_n35];
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // dot_l.cos
    wire signed [1:-18] dot_l_cos_cos_sum = cos_row; // s20f18
    wire signed [1:-18] dot_l_cos_cos_difference = cos_row_2; // s20f18
    wire signed [1:-18] dot_l_cos_cos_delta = cos_row_3; // s20f18
    // dot_l
    wire signed [2:-18] dot_l_n18 = {dot_l_cos_cos_sum[1], dot_l_cos_cos_sum} + {dot_l_cos_cos_difference[1], dot_l_cos_cos_difference}; // s21f18
    wire signed [1:-19] dot_l_n19 = dot_l_n18; // s21f19
    wire signed [2:-18] dot_l_n20 = {dot_l_cos_cos_difference[1], dot_l_cos_cos_difference} - {dot_l_cos_cos_sum[1], dot_l_cos_cos_sum}; // s21f18
    wire signed [1:-19] dot_l_n21 = dot_l_n20; // s21f19
    // dot_h.cos
    wire signed [1:-18] dot_h_cos_cos_sum = cos_row_4; // s20f18
    wire signed [1:-18] dot_h_cos_cos_difference = cos_row_5; // s20f18
    wire signed [1:-18] dot_h_cos_cos_delta = cos_row_6; // s20f18
    // dot_h
    wire signed [2:-18] dot_h_n37 = {dot_h_cos_cos_sum[1], dot_h_cos_cos_sum} + {dot_h_cos_cos_difference[1], dot_h_cos_cos_difference}; // s21f18
    wire signed [1:-19] dot_h_n38 = dot_h_n37; // s21f19
    wire signed [2:-18] dot_h_n39 = {dot_h_cos_cos_difference[1], dot_h_cos_cos_difference} - {dot_h_cos_cos_sum[1], dot_h_cos_cos_sum}; // s21f18
    wire signed [1:-19] dot_h_n40 = dot_h_n39; // s21f19

    reg signed [1:-18] dot_l_cos_cos_delta_s2; // s20f18
    reg signed [1:-19] dot_l_n19_s2; // s21f19
    reg signed [1:-19] dot_l_n21_s2; // s21f19
    reg signed [1:-18] dot_h_cos_cos_delta_s2; // s20f18
    reg signed [1:-19] dot_h_n38_s2; // s21f19
    reg signed [1:-19] dot_h_n40_s2; // s21f19
    always @(posedge clk)
        if (ce) begin
            dot_l_cos_cos_delta_s2 <= dot_l_cos_cos_delta;
            dot_l_n19_s2 <= dot_l_n19;
            dot_l_n21_s2 <= dot_l_n21;
            dot_h_cos_cos_delta_s2 <= dot_h_cos_cos_delta;
            dot_h_n38_s2 <= dot_h_n38;
            dot_h_n40_s2 <= dot_h_n40;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // dot_l
    wire signed [3:-37] dot_l_n22 = dot_l_n21_s2 * dot_l_cos_cos_delta_s2; // s41f37
    // dot_h
    wire signed [3:-37] dot_h_n41 = dot_h_n40_s2 * dot_h_cos_cos_delta_s2; // s41f37

    reg signed [1:-19] dot_l_n19_s3; // s21f19
    reg signed [3:-37] dot_l_n22_s3; // s41f37
    reg signed [1:-19] dot_h_n38_s3; // s21f19
    reg signed [3:-37] dot_h_n41_s3; // s41f37
    always @(posedge clk)
        if (ce) begin
            dot_l_n19_s3 <= dot_l_n19_s2;
            dot_l_n22_s3 <= dot_l_n22;
            dot_h_n38_s3 <= dot_h_n38_s2;
            dot_h_n41_s3 <= dot_h_n41;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // dot_l
    wire signed [4:-37] dot_l_n23 = {{3{dot_l_n19_s3[1]}}, dot_l_n19_s3, 18'h0} + {dot_l_n22_s3[3], dot_l_n22_s3}; // s42f37
    // (unit)
    wire signed [5:-37] dot_l_sum_2 = {dot_l_n23[4], dot_l_n23} + 43'h100000;
    wire signed [5:-16] dot_l_cut = dot_l_sum_2[5:-16];
    wire dot_l_over = ~dot_l_cut[5] & (|dot_l_cut[4:1]);
    wire dot_l_under = dot_l_cut[5] & ~(&dot_l_cut[4:1]);
    wire signed [1:-16] dot_l = dot_l_over ? 18'h1ffff : dot_l_under ? 18'h20000 : dot_l_cut[1:-16]; // s18f16
    // dot_h
    wire signed [4:-37] dot_h_n42 = {{3{dot_h_n38_s3[1]}}, dot_h_n38_s3, 18'h0} + {dot_h_n41_s3[3], dot_h_n41_s3}; // s42f37
    // (unit)
    wire signed [5:-37] dot_h_sum_2 = {dot_h_n42[4], dot_h_n42} + 43'h100000;
    wire signed [5:-16] dot_h_cut = dot_h_sum_2[5:-16];
    wire dot_h_over = ~dot_h_cut[5] & (|dot_h_cut[4:1]);
    wire dot_h_under = dot_h_cut[5] & ~(&dot_h_cut[4:1]);
    wire signed [1:-16] dot_h = dot_h_over ? 18'h1ffff : dot_h_under ? 18'h20000 : dot_h_cut[1:-16]; // s18f16
    wire n45 = dot_l[1]; // u1f0
    wire signed [1:-16] n46 = n45 ? {1'b0, n44, 16'h0} : dot_l; // s18f16
    wire diffuse_index_under = n46[1];
    wire [0:-16] diffuse_index = diffuse_index_under ? 17'h0 : n46[0:-16]; // u17f16
    wire n48 = diffuse_index[0]; // u1f0
    wire [15:0] n49 = diffuse_index[-1:-16]; // u16f0
    wire [-1:-16] n50 = n49; // u16f16
    // diffuse
    wire [9:0] diffuse_n51 = n50[-1:-10]; // u10f0
    // (unit)
    wire n57 = dot_h[1]; // u1f0
    wire signed [1:-16] n58 = n57 ? {1'b0, n44, 16'h0} : dot_h; // s18f16
    wire specular_index_under = n58[1];
    wire [0:-16] specular_index = specular_index_under ? 17'h0 : n58[0:-16]; // u17f16
    wire n60 = specular_index[0]; // u1f0
    wire [15:0] n61 = specular_index[-1:-16]; // u16f0
    wire [-1:-16] n62 = n61; // u16f16
    // specular
    wire [9:0] specular_n63 = n62[-1:-10]; // u10f0

    reg n45_s4; // u1f0
    reg n48_s4; // u1f0
    reg [9:0] diffuse_n51_s4; // u10f0
    reg n57_s4; // u1f0
    reg n60_s4; // u1f0
    reg [9:0] specular_n63_s4; // u10f0
    always @(posedge clk)
        if (ce) begin
            n45_s4 <= n45;
            n48_s4 <= n48;
            diffuse_n51_s4 <= diffuse_n51;
            n57_s4 <= n57;
            n60_s4 <= n60;
            specular_n63_s4 <= specular_n63;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----

    reg n45_s5; // u1f0
    reg n48_s5; // u1f0
    reg [15:0] diffuse_row;
    reg n57_s5; // u1f0
    reg n60_s5; // u1f0
    reg [15:0] specular_row;
    always @(posedge clk)
        if (ce) begin
            n45_s5 <= n45_s4;
            n48_s5 <= n48_s4;
            diffuse_row <= diffuse_rom[diffuse_n51_s4];
            n57_s5 <= n57_s4;
            n60_s5 <= n60_s4;
            specular_row <= specular_rom[specular_n63_s4];
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // diffuse
    wire [-1:-16] diffuse_n52 = diffuse_row; // u16f16
    // (unit)
    wire [-1:-16] n55 = n48_s5 ? n53 : diffuse_n52; // u16f16
    wire [-1:-16] diffuse_next = n45_s5 ? n54 : n55; // u16f16
    // specular
    wire [-1:-16] specular_n64 = specular_row; // u16f16
    // (unit)
    wire [-1:-16] n67 = n60_s5 ? n65 : specular_n64; // u16f16
    wire [-1:-16] specular_next = n57_s5 ? n66 : n67; // u16f16
    wire [0:-16] n69 = {1'b0, diffuse_next} + {1'b0, specular_next}; // u17f16
    wire intensity_next_over = |n69[0];
    wire [-1:-16] intensity_next = intensity_next_over ? 16'hffff : n69[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            diffuse <= diffuse_next;
            specular <= specular_next;
            intensity <= intensity_next;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;
    assign valid_out = valid_s6;

    // ---- stage 6 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        dot_l_n6[0],
        dot_l_delta[-11:-16],
        dot_l_n8[0],
        dot_l_sum[-11:-16],
        dot_l_n10[0],
        dot_l_difference[-11:-16],
        dot_h_n25[0],
        dot_h_delta[-11:-16],
        dot_h_n27[0],
        dot_h_sum[-11:-16],
        dot_h_n29[0],
        dot_h_difference[-11:-16],
        dot_l_sum_2[-17:-37],
        dot_h_sum_2[-17:-37],
        n50[-11:-16],
        n62[-11:-16]};
endmodule
