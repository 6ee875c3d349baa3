// rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
// made by fixpath 0.1.0; the inverse square root unit of US 6,980,218, FIG. 8
//   input_bits=20 input_frac_bits=18 root_int_bits=9 root_scheme=linear root_addr_bits=9
//   root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
// latency 6 cycles, interval 1 cycle; tables read on the clock
// errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst case:
//   r_relative: mean 1.23e-6, largest seen 4.83e-6 over the result, at a=269281
//   r_scaled: mean 9.98e-7, largest seen 4.76e-6 over the result, at least 1, at a=269281
//   r: mean 5.17e-5, largest seen 1.46e-3 (383.0 ulp) at a=1
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at a=155754
// stated bound on each relative (relative to the result): 1.37e-5
// stated bound on each scaled (relative to the result, at least 1): 1.18e-5
// stated bound on each absolute: 5.08e-3
// stated bound on each flag: 0.00e0
module rsqrt (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire [1:-18] a, // u20f18
    output wire valid_out,
    output reg  [8:-18] r, // u27f18
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
    // reciprocal_root
    wire [19:0] reciprocal_root_n1 = a; // u20f0
    wire reciprocal_root_n2 = 1'b0; // u1f0
    wire [19:0] reciprocal_root_n3 = reciprocal_root_n1; // u20f0
    wire [15:0] reciprocal_root_n4 = reciprocal_root_n3[19:4]; // u16f0
    wire reciprocal_root_n5 = reciprocal_root_n4 == {15'h0, reciprocal_root_n2}; // u1f0
    wire [3:0] reciprocal_root_n6 = reciprocal_root_n3[3:0]; // u4f0
    wire [15:0] reciprocal_root_n7 = 16'h0; // u16f0
    wire [19:0] reciprocal_root_n8 = {reciprocal_root_n6, reciprocal_root_n7}; // u20f0
    wire [19:0] reciprocal_root_n9 = reciprocal_root_n5 ? reciprocal_root_n8 : reciprocal_root_n3; // u20f0
    wire [7:0] reciprocal_root_n10 = reciprocal_root_n9[19:12]; // u8f0
    wire reciprocal_root_n11 = reciprocal_root_n10 == {7'h0, reciprocal_root_n2}; // u1f0
    wire [11:0] reciprocal_root_n12 = reciprocal_root_n9[11:0]; // u12f0
    wire [7:0] reciprocal_root_n13 = 8'h0; // u8f0
    wire [19:0] reciprocal_root_n14 = {reciprocal_root_n12, reciprocal_root_n13}; // u20f0
    wire [19:0] reciprocal_root_n15 = reciprocal_root_n11 ? reciprocal_root_n14 : reciprocal_root_n9; // u20f0
    wire [3:0] reciprocal_root_n16 = reciprocal_root_n15[19:16]; // u4f0
    wire reciprocal_root_n17 = reciprocal_root_n16 == {3'h0, reciprocal_root_n2}; // u1f0
    wire [15:0] reciprocal_root_n18 = reciprocal_root_n15[15:0]; // u16f0
    wire [3:0] reciprocal_root_n19 = 4'h0; // u4f0
    wire [19:0] reciprocal_root_n20 = {reciprocal_root_n18, reciprocal_root_n19}; // u20f0
    wire [19:0] reciprocal_root_n21 = reciprocal_root_n17 ? reciprocal_root_n20 : reciprocal_root_n15; // u20f0
    wire [1:0] reciprocal_root_n22 = reciprocal_root_n21[19:18]; // u2f0
    wire [17:0] reciprocal_root_n24 = reciprocal_root_n21[17:0]; // u18f0
    wire [1:0] reciprocal_root_n25 = 2'h0; // u2f0
    wire [19:0] reciprocal_root_n26 = {reciprocal_root_n24, reciprocal_root_n25}; // u20f0
    wire [1:0] reciprocal_root_n28 = {reciprocal_root_n5, reciprocal_root_n11}; // u2f0
    wire [2:0] reciprocal_root_n29 = {reciprocal_root_n28, reciprocal_root_n17}; // u3f0
    wire reciprocal_root_n32 = 1'b1; // u1f0
    wire reciprocal_root_n47 = 1'b1; // u1e9
    wire reciprocal_root_n48 = a == {1'b0, reciprocal_root_n2, 18'h0}; // u1f0

    reg [19:0] reciprocal_root_n21_s1; // u20f0
    reg [1:0] reciprocal_root_n22_s1; // u2f0
    reg [19:0] reciprocal_root_n26_s1; // u20f0
    reg [2:0] reciprocal_root_n29_s1; // u3f0
    reg reciprocal_root_n48_s1; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n21_s1 <= reciprocal_root_n21;
            reciprocal_root_n22_s1 <= reciprocal_root_n22;
            reciprocal_root_n26_s1 <= reciprocal_root_n26;
            reciprocal_root_n29_s1 <= reciprocal_root_n29;
            reciprocal_root_n48_s1 <= reciprocal_root_n48;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // reciprocal_root
    wire reciprocal_root_n23 = reciprocal_root_n22_s1 == {1'b0, reciprocal_root_n2}; // u1f0
    wire [19:0] reciprocal_root_n27 = reciprocal_root_n23 ? reciprocal_root_n26_s1 : reciprocal_root_n21_s1; // u20f0
    wire [3:0] reciprocal_root_n30 = {reciprocal_root_n29_s1, reciprocal_root_n23}; // u4f0
    wire [1:0] reciprocal_root_n31 = reciprocal_root_n27[19:18]; // u2f0
    wire signed [2:0] reciprocal_root_n33 = {1'b0, reciprocal_root_n31} - {2'h0, reciprocal_root_n32}; // s3f0
    wire [1:0] reciprocal_root_n34 = reciprocal_root_n33[1:0]; // u2f0
    wire [17:0] reciprocal_root_n35 = reciprocal_root_n27[17:0]; // u18f0
    wire [19:0] reciprocal_root_n36 = {reciprocal_root_n34, reciprocal_root_n35}; // u20f0
    wire [-1:-20] reciprocal_root_n37 = reciprocal_root_n36; // u20f20
    // reciprocal_root.recip_root
    wire [8:0] reciprocal_root_recip_root_n38 = reciprocal_root_n37[-1:-9]; // u9f0
    wire [10:0] reciprocal_root_recip_root_n41 = reciprocal_root_n37[-10:-20]; // u11f0

    reg [3:0] reciprocal_root_n30_s2; // u4f0
    reg [38:0] recip_root_row;
    reg [10:0] reciprocal_root_recip_root_n41_s2; // u11f0
    reg reciprocal_root_n48_s2; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s2 <= reciprocal_root_n30;
            recip_root_row <= recip_root_rom[reciprocal_root_recip_root_n38];
            reciprocal_root_recip_root_n41_s2 <= reciprocal_root_recip_root_n41;
            reciprocal_root_n48_s2 <= reciprocal_root_n48_s1;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // reciprocal_root.recip_root
    wire [0:-22] reciprocal_root_recip_root_n39 = recip_root_row[38:16]; // u23f22
    wire signed [-18:-33] reciprocal_root_recip_root_n40 = recip_root_row[15:0]; // s16f33

    reg [3:0] reciprocal_root_n30_s3; // u4f0
    reg [0:-22] reciprocal_root_recip_root_n39_s3; // u23f22
    reg signed [-18:-33] reciprocal_root_recip_root_n40_s3; // s16f33
    reg [10:0] reciprocal_root_recip_root_n41_s3; // u11f0
    reg reciprocal_root_n48_s3; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s3 <= reciprocal_root_n30_s2;
            reciprocal_root_recip_root_n39_s3 <= reciprocal_root_recip_root_n39;
            reciprocal_root_recip_root_n40_s3 <= reciprocal_root_recip_root_n40;
            reciprocal_root_recip_root_n41_s3 <= reciprocal_root_recip_root_n41_s2;
            reciprocal_root_n48_s3 <= reciprocal_root_n48_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // reciprocal_root.recip_root
    wire signed [-7:-33] reciprocal_root_recip_root_n42 = reciprocal_root_recip_root_n40_s3 * $signed({1'b0, reciprocal_root_recip_root_n41_s3}); // s27f33
    wire signed [2:-33] reciprocal_root_recip_root_n43 = {2'h0, reciprocal_root_recip_root_n39_s3, 11'h0} + {{9{reciprocal_root_recip_root_n42[-7]}}, reciprocal_root_recip_root_n42}; // s36f33

    reg [3:0] reciprocal_root_n30_s4; // u4f0
    reg signed [2:-33] reciprocal_root_recip_root_n43_s4; // s36f33
    reg reciprocal_root_n48_s4; // u1f0
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n30_s4 <= reciprocal_root_n30_s3;
            reciprocal_root_recip_root_n43_s4 <= reciprocal_root_recip_root_n43;
            reciprocal_root_n48_s4 <= reciprocal_root_n48_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // reciprocal_root.recip_root
    wire signed [3:-33] reciprocal_root_recip_root_n44_sum = {reciprocal_root_recip_root_n43_s4[2], reciprocal_root_recip_root_n43_s4} + 37'h1000;
    wire signed [3:-20] reciprocal_root_recip_root_n44_cut = reciprocal_root_recip_root_n44_sum[3:-20];
    wire reciprocal_root_recip_root_n44_over = ~reciprocal_root_recip_root_n44_cut[3] & (|reciprocal_root_recip_root_n44_cut[2]);
    wire reciprocal_root_recip_root_n44_under = reciprocal_root_recip_root_n44_cut[3];
    wire [1:-20] reciprocal_root_recip_root_n44 = reciprocal_root_recip_root_n44_over ? 22'h3fffff : reciprocal_root_recip_root_n44_under ? 22'h0 : reciprocal_root_recip_root_n44_cut[1:-20]; // u22f20
    // reciprocal_root
    wire reciprocal_root_n45_past = 4'ha < reciprocal_root_n30_s4;
    wire [3:0] reciprocal_root_n45_count = reciprocal_root_n45_past ? 4'ha : reciprocal_root_n30_s4;
    wire [11:-20] reciprocal_root_n45 = {10'h0, reciprocal_root_recip_root_n44} << reciprocal_root_n45_count; // u32f20
    wire [10:-21] reciprocal_root_n46 = reciprocal_root_n45; // u32f21
    wire [10:-21] reciprocal_root_n49 = reciprocal_root_n48_s4 ? {1'b0, reciprocal_root_n47, 30'h0} : reciprocal_root_n46; // u32f21

    reg reciprocal_root_n48_s5; // u1f0
    reg [10:-21] reciprocal_root_n49_s5; // u32f21
    always @(posedge clk)
        if (ce) begin
            reciprocal_root_n48_s5 <= reciprocal_root_n48_s4;
            reciprocal_root_n49_s5 <= reciprocal_root_n49;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // reciprocal_root
    wire [11:-21] reciprocal_root_n50_sum = {1'b0, reciprocal_root_n49_s5} + 33'h4;
    wire [11:-18] reciprocal_root_n50_cut = reciprocal_root_n50_sum[11:-18];
    wire reciprocal_root_n50_over = |reciprocal_root_n50_cut[11:9];
    wire [8:-18] reciprocal_root_n50 = reciprocal_root_n50_over ? 27'h7ffffff : reciprocal_root_n50_cut[8:-18]; // u27f18
    // (unit)
    wire [8:-18] n51 = reciprocal_root_n48_s5 ? {8'h0, reciprocal_root_n2, 18'h0} : reciprocal_root_n50; // u27f18

    always @(posedge clk)
        if (ce) begin
            degenerate <= reciprocal_root_n48_s5;
            r <= n51;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;
    assign valid_out = valid_s6;

    // ---- stage 6 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        reciprocal_root_n33[2],
        reciprocal_root_recip_root_n44_sum[-21:-33],
        reciprocal_root_n50_sum[-19:-21]};
endmodule
