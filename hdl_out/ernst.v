// ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
// made by fixpath 0.1.0; Ernst et al. 1998, as seed 001 (Lee et al.) counts it in Table 1 and section 4.3
//   normalise=divide divider=non-restoring root=digits frac_bits=16 guard_bits=2 rounding=half-up
//   table_addr_bits=10 scheme=direct recip_addr_bits=auto root_addr_bits=auto highlight=on
//   specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3
//   exponent=32 period_ps=5000 stages=auto rom=block
// latency 33 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   intensity: mean 7.10e-5, largest seen 4.39e-3 (287.8 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
//   diffuse: mean 7.90e-6, largest seen 3.38e-5 (2.2 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
//   specular: mean 6.51e-5, largest seen 4.37e-3 (286.6 ulp) at l_x=-17621 l_y=-12812 l_z=61809 h_x=-42849 h_y=10989 h_z=48354 n_x=-27841 n_y=44144 n_z=39637 t_x=42357 t_y=-15868 t_z=47424 b_x=41542 b_y=45765 b_z=-21790 p_x=6319 p_y=-31430 p_z=57160
//   dot_l: mean 5.51e-6, largest seen 2.58e-5 (1.7 ulp) at l_x=8189 l_y=37211 l_z=53322 h_x=11330 h_y=-3065 h_z=64476 n_x=11403 n_y=-35489 n_z=53903 t_x=59242 t_y=-15956 t_z=-23038 b_x=25599 b_y=52734 b_z=29304 p_x=3824 p_y=43866 p_z=48539
//   dot_h: mean 5.55e-6, largest seen 2.64e-5 (1.7 ulp) at l_x=28436 l_y=58436 l_z=-8465 h_x=56347 h_y=29067 h_z=-16587 n_x=7268 n_y=55465 n_z=-34143 t_x=-16808 t_y=-31594 t_z=-54902 b_x=-62926 b_y=14846 b_z=10722 p_x=17769 p_y=-44293 p_z=44914
//   lt_angle: mean 5.96e-6 rad, largest seen 1.52e-5 rad at l_x=-46104 l_y=2218 l_z=46524 h_x=-34894 h_y=-9840 h_z=54594 n_x=-8835 n_y=57118 n_z=30893 t_x=27988 t_y=31483 t_z=-50204 b_x=-58597 b_y=6425 b_z=-28637 p_x=-41292 p_y=29455 p_z=41501
//   lt_dot: mean 7.58e-6, largest seen 1.60e-5 at l_x=-51507 l_y=24581 l_z=-32215 h_x=-48499 h_y=-39070 h_z=-20406 n_x=-49786 n_y=-42007 n_z=7192 t_x=-40759 t_y=43701 t_z=-26905 b_x=12449 b_y=-24912 b_z=-59324 p_x=18646 p_y=26903 p_z=56776
//   lt_x: mean 3.93e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-15279 l_y=5067 l_z=63528 h_x=29170 h_y=-18014 h_z=55853 n_x=53184 n_y=30871 n_z=22658 t_x=9050 t_y=-47812 t_z=43899 b_x=37209 b_y=-32496 b_z=-43064 p_x=30395 p_y=-14945 p_z=56105
//   lt_y: mean 3.92e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-33544 l_y=8570 l_z=55645 h_x=3237 h_y=45027 h_z=47509 n_x=51579 n_y=35193 n_z=-19899 t_x=-23525 t_y=-107 t_z=-61168 b_x=-32880 b_y=55285 b_z=12549 p_x=35175 p_y=37290 p_z=40831
//   lt_z: mean 3.90e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=60216 l_y=-731 l_z=25854 h_x=28155 h_y=-38009 h_z=45360 n_x=49800 n_y=-42419 n_z=3954 t_x=-7689 t_y=-2967 t_z=65016 b_x=-41903 b_y=-49868 b_z=-7231 p_x=38689 p_y=13334 p_z=51189
//   ht_angle: mean 5.97e-6 rad, largest seen 1.55e-5 rad at l_x=-42413 l_y=5315 l_z=-49678 h_x=-49190 h_y=10077 h_z=-42117 n_x=31825 n_y=43565 n_z=-37205 t_x=52333 t_y=-39424 t_z=-1398 b_x=-23310 b_y=-29031 b_z=-53933 p_x=41501 p_y=24164 p_z=44595
//   ht_dot: mean 7.59e-6, largest seen 1.61e-5 at l_x=39313 l_y=33020 l_z=40732 h_x=45349 h_y=44689 h_z=15535 n_x=-37342 n_y=44334 n_z=30579 t_x=53162 t_y=24386 t_z=29565 b_x=8622 b_y=41651 b_z=-49858 p_x=-25251 p_y=-37777 p_z=47226
//   ht_x: mean 3.92e-6, largest seen 1.07e-5 (0.7 ulp) at l_x=39149 l_y=-824 l_z=-52551 h_x=24132 h_y=-60683 h_z=-5494 n_x=-27035 n_y=-45260 n_z=-38931 t_x=-59525 t_y=17166 t_z=21378 b_x=-4566 b_y=44180 b_z=-48190 p_x=-12132 p_y=43147 p_z=47813
//   ht_y: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=32246 l_y=-33688 l_z=-46046 h_x=26934 h_y=-37639 h_z=-46399 n_x=15761 n_y=17121 n_z=-61265 t_x=59086 t_y=-27325 t_z=7564 b_x=-23568 b_y=-57054 b_z=-22007 p_x=-27119 p_y=36491 p_z=47201
//   ht_z: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=-37898 l_y=-11533 l_z=52209 h_x=-54011 h_y=-33479 h_z=-16030 n_x=-19265 n_y=-61659 n_z=-11046 t_x=-4008 t_y=12746 t_z=-64159 b_x=62512 b_y=-18185 b_z=-7518 p_x=10839 p_y=-28061 p_z=58224
// stated bound on each dot: 7.02e-5
// stated bound on each diffuse: 8.02e-5
// stated bound on each specular: 5.24e-3
// stated bound on each intensity: 5.33e-3
// stated bound on each component: 1.81e-5
// bounds hold for L and H in the texture frame, and N', from 1/2 to 2 long
module ernst (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [1:-16] l_x, // s18f16
    input  wire signed [1:-16] l_y, // s18f16
    input  wire signed [1:-16] l_z, // s18f16
    input  wire signed [1:-16] h_x, // s18f16
    input  wire signed [1:-16] h_y, // s18f16
    input  wire signed [1:-16] h_z, // s18f16
    input  wire signed [1:-16] n_x, // s18f16
    input  wire signed [1:-16] n_y, // s18f16
    input  wire signed [1:-16] n_z, // s18f16
    input  wire signed [1:-16] t_x, // s18f16
    input  wire signed [1:-16] t_y, // s18f16
    input  wire signed [1:-16] t_z, // s18f16
    input  wire signed [1:-16] b_x, // s18f16
    input  wire signed [1:-16] b_y, // s18f16
    input  wire signed [1:-16] b_z, // s18f16
    input  wire signed [1:-16] p_x, // s18f16
    input  wire signed [1:-16] p_y, // s18f16
    input  wire signed [1:-16] p_z, // s18f16
    output wire valid_out,
    output reg  [-1:-16] intensity, // u16f16
    output reg  [-1:-16] diffuse, // u16f16
    output reg  [-1:-16] specular // u16f16
);

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

    // ---- stage 0 ----
    // setup.light
    wire signed [3:-32] setup_light_n18 = t_x * l_x; // s36f32
    wire signed [3:-32] setup_light_n19 = t_y * l_y; // s36f32
    wire signed [3:-32] setup_light_n20 = t_z * l_z; // s36f32
    wire signed [3:-32] setup_light_n24 = b_x * l_x; // s36f32
    wire signed [3:-32] setup_light_n25 = b_y * l_y; // s36f32
    wire signed [3:-32] setup_light_n26 = b_z * l_z; // s36f32
    wire signed [3:-32] setup_light_n30 = n_x * l_x; // s36f32
    wire signed [3:-32] setup_light_n31 = n_y * l_y; // s36f32
    wire signed [3:-32] setup_light_n32 = n_z * l_z; // s36f32
    // setup.light.length
    wire setup_light_length_n42 = 1'b1; // u1f0
    wire setup_light_length_n43 = 1'b0; // u1f0
    wire [1:0] setup_light_length_n327 = {setup_light_length_n43, setup_light_length_n43}; // u2f0
    // setup.light.unit_x
    wire setup_light_unit_x_n343 = 1'b1; // u1e1
    wire [22:0] setup_light_unit_x_n388 = 23'h0; // u23f0
    wire setup_light_unit_x_n396 = setup_light_length_n43 ^ setup_light_length_n42; // u1f0
    // setup.half
    wire signed [3:-32] setup_half_n989 = t_x * h_x; // s36f32
    wire signed [3:-32] setup_half_n990 = t_y * h_y; // s36f32
    wire signed [3:-32] setup_half_n991 = t_z * h_z; // s36f32
    wire signed [3:-32] setup_half_n995 = b_x * h_x; // s36f32
    wire signed [3:-32] setup_half_n996 = b_y * h_y; // s36f32
    wire signed [3:-32] setup_half_n997 = b_z * h_z; // s36f32
    wire signed [3:-32] setup_half_n1001 = n_x * h_x; // s36f32
    wire signed [3:-32] setup_half_n1002 = n_y * h_y; // s36f32
    wire signed [3:-32] setup_half_n1003 = n_z * h_z; // s36f32
    // setup.bump
    wire signed [3:-32] setup_bump_n1954 = p_x * p_x; // s36f32
    wire signed [3:-32] setup_bump_n1955 = p_y * p_y; // s36f32
    wire signed [3:-32] setup_bump_n1956 = p_z * p_z; // s36f32
    // setup.bump.unit_x
    wire [1:-16] setup_bump_unit_x_n2215_neg = -p_x;
    wire [1:-16] setup_bump_unit_x_n2215 = p_x[1] ? setup_bump_unit_x_n2215_neg : p_x; // u18f16
    wire setup_bump_unit_x_n2217 = setup_bump_unit_x_n2215[1]; // u1f0
    wire setup_bump_unit_x_n2218 = setup_bump_unit_x_n2215[0]; // u1f0
    wire setup_bump_unit_x_n2219 = setup_bump_unit_x_n2215[-1]; // u1f0
    wire setup_bump_unit_x_n2220 = setup_bump_unit_x_n2215[-2]; // u1f0
    wire setup_bump_unit_x_n2221 = setup_bump_unit_x_n2215[-3]; // u1f0
    wire setup_bump_unit_x_n2222 = setup_bump_unit_x_n2215[-4]; // u1f0
    wire setup_bump_unit_x_n2223 = setup_bump_unit_x_n2215[-5]; // u1f0
    wire setup_bump_unit_x_n2224 = setup_bump_unit_x_n2215[-6]; // u1f0
    wire setup_bump_unit_x_n2225 = setup_bump_unit_x_n2215[-7]; // u1f0
    wire setup_bump_unit_x_n2226 = setup_bump_unit_x_n2215[-8]; // u1f0
    wire setup_bump_unit_x_n2227 = setup_bump_unit_x_n2215[-9]; // u1f0
    wire setup_bump_unit_x_n2228 = setup_bump_unit_x_n2215[-10]; // u1f0
    wire setup_bump_unit_x_n2229 = setup_bump_unit_x_n2215[-11]; // u1f0
    wire setup_bump_unit_x_n2230 = setup_bump_unit_x_n2215[-12]; // u1f0
    wire setup_bump_unit_x_n2231 = setup_bump_unit_x_n2215[-13]; // u1f0
    wire setup_bump_unit_x_n2232 = setup_bump_unit_x_n2215[-14]; // u1f0
    wire setup_bump_unit_x_n2233 = setup_bump_unit_x_n2215[-15]; // u1f0
    wire setup_bump_unit_x_n2234 = setup_bump_unit_x_n2215[-16]; // u1f0
    wire [1:0] setup_bump_unit_x_n2235 = {setup_bump_unit_x_n2217, setup_bump_unit_x_n2218}; // u2f0
    wire [2:0] setup_bump_unit_x_n2236 = {setup_bump_unit_x_n2235, setup_bump_unit_x_n2219}; // u3f0
    wire [3:0] setup_bump_unit_x_n2237 = {setup_bump_unit_x_n2236, setup_bump_unit_x_n2220}; // u4f0
    wire [4:0] setup_bump_unit_x_n2238 = {setup_bump_unit_x_n2237, setup_bump_unit_x_n2221}; // u5f0
    wire [5:0] setup_bump_unit_x_n2239 = {setup_bump_unit_x_n2238, setup_bump_unit_x_n2222}; // u6f0
    wire [6:0] setup_bump_unit_x_n2240 = {setup_bump_unit_x_n2239, setup_bump_unit_x_n2223}; // u7f0
    wire [7:0] setup_bump_unit_x_n2241 = {setup_bump_unit_x_n2240, setup_bump_unit_x_n2224}; // u8f0
    wire [8:0] setup_bump_unit_x_n2242 = {setup_bump_unit_x_n2241, setup_bump_unit_x_n2225}; // u9f0
    wire [9:0] setup_bump_unit_x_n2243 = {setup_bump_unit_x_n2242, setup_bump_unit_x_n2226}; // u10f0
    wire [10:0] setup_bump_unit_x_n2244 = {setup_bump_unit_x_n2243, setup_bump_unit_x_n2227}; // u11f0
    wire [11:0] setup_bump_unit_x_n2245 = {setup_bump_unit_x_n2244, setup_bump_unit_x_n2228}; // u12f0
    wire [12:0] setup_bump_unit_x_n2246 = {setup_bump_unit_x_n2245, setup_bump_unit_x_n2229}; // u13f0
    wire [13:0] setup_bump_unit_x_n2247 = {setup_bump_unit_x_n2246, setup_bump_unit_x_n2230}; // u14f0
    wire [14:0] setup_bump_unit_x_n2248 = {setup_bump_unit_x_n2247, setup_bump_unit_x_n2231}; // u15f0
    wire [15:0] setup_bump_unit_x_n2249 = {setup_bump_unit_x_n2248, setup_bump_unit_x_n2232}; // u16f0
    wire [16:0] setup_bump_unit_x_n2250 = {setup_bump_unit_x_n2249, setup_bump_unit_x_n2233}; // u17f0
    wire [17:0] setup_bump_unit_x_n2251 = {setup_bump_unit_x_n2250, setup_bump_unit_x_n2234}; // u18f0
    wire [40:0] setup_bump_unit_x_n2254 = {setup_light_unit_x_n388, setup_bump_unit_x_n2251}; // u41f0
    wire [22:0] setup_bump_unit_x_n2255 = setup_bump_unit_x_n2254[22:0]; // u23f0
    wire signed [23:0] setup_bump_unit_x_n2256 = {1'b0, setup_bump_unit_x_n2255}; // s24f0
    wire [23:0] setup_bump_unit_x_n2257 = setup_bump_unit_x_n2256; // u24f0
    wire [24:0] setup_bump_unit_x_n2258 = {setup_bump_unit_x_n2257, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2259 = setup_bump_unit_x_n2258; // s25f0
    wire setup_bump_unit_x_n2417 = setup_bump_unit_x_n2215 == {1'b0, setup_light_length_n43, 16'h0}; // u1f0
    wire setup_bump_unit_x_n2419 = p_x[1]; // u1f0
    // setup.bump.unit_y
    wire [1:-16] setup_bump_unit_y_n2423_neg = -p_y;
    wire [1:-16] setup_bump_unit_y_n2423 = p_y[1] ? setup_bump_unit_y_n2423_neg : p_y; // u18f16
    wire setup_bump_unit_y_n2424 = setup_bump_unit_y_n2423[1]; // u1f0
    wire setup_bump_unit_y_n2425 = setup_bump_unit_y_n2423[0]; // u1f0
    wire setup_bump_unit_y_n2426 = setup_bump_unit_y_n2423[-1]; // u1f0
    wire setup_bump_unit_y_n2427 = setup_bump_unit_y_n2423[-2]; // u1f0
    wire setup_bump_unit_y_n2428 = setup_bump_unit_y_n2423[-3]; // u1f0
    wire setup_bump_unit_y_n2429 = setup_bump_unit_y_n2423[-4]; // u1f0
    wire setup_bump_unit_y_n2430 = setup_bump_unit_y_n2423[-5]; // u1f0
    wire setup_bump_unit_y_n2431 = setup_bump_unit_y_n2423[-6]; // u1f0
    wire setup_bump_unit_y_n2432 = setup_bump_unit_y_n2423[-7]; // u1f0
    wire setup_bump_unit_y_n2433 = setup_bump_unit_y_n2423[-8]; // u1f0
    wire setup_bump_unit_y_n2434 = setup_bump_unit_y_n2423[-9]; // u1f0
    wire setup_bump_unit_y_n2435 = setup_bump_unit_y_n2423[-10]; // u1f0
    wire setup_bump_unit_y_n2436 = setup_bump_unit_y_n2423[-11]; // u1f0
    wire setup_bump_unit_y_n2437 = setup_bump_unit_y_n2423[-12]; // u1f0
    wire setup_bump_unit_y_n2438 = setup_bump_unit_y_n2423[-13]; // u1f0
    wire setup_bump_unit_y_n2439 = setup_bump_unit_y_n2423[-14]; // u1f0
    wire setup_bump_unit_y_n2440 = setup_bump_unit_y_n2423[-15]; // u1f0
    wire setup_bump_unit_y_n2441 = setup_bump_unit_y_n2423[-16]; // u1f0
    wire [1:0] setup_bump_unit_y_n2442 = {setup_bump_unit_y_n2424, setup_bump_unit_y_n2425}; // u2f0
    wire [2:0] setup_bump_unit_y_n2443 = {setup_bump_unit_y_n2442, setup_bump_unit_y_n2426}; // u3f0
    wire [3:0] setup_bump_unit_y_n2444 = {setup_bump_unit_y_n2443, setup_bump_unit_y_n2427}; // u4f0
    wire [4:0] setup_bump_unit_y_n2445 = {setup_bump_unit_y_n2444, setup_bump_unit_y_n2428}; // u5f0
    wire [5:0] setup_bump_unit_y_n2446 = {setup_bump_unit_y_n2445, setup_bump_unit_y_n2429}; // u6f0
    wire [6:0] setup_bump_unit_y_n2447 = {setup_bump_unit_y_n2446, setup_bump_unit_y_n2430}; // u7f0
    wire [7:0] setup_bump_unit_y_n2448 = {setup_bump_unit_y_n2447, setup_bump_unit_y_n2431}; // u8f0
    wire [8:0] setup_bump_unit_y_n2449 = {setup_bump_unit_y_n2448, setup_bump_unit_y_n2432}; // u9f0
    wire [9:0] setup_bump_unit_y_n2450 = {setup_bump_unit_y_n2449, setup_bump_unit_y_n2433}; // u10f0
    wire [10:0] setup_bump_unit_y_n2451 = {setup_bump_unit_y_n2450, setup_bump_unit_y_n2434}; // u11f0
    wire [11:0] setup_bump_unit_y_n2452 = {setup_bump_unit_y_n2451, setup_bump_unit_y_n2435}; // u12f0
    wire [12:0] setup_bump_unit_y_n2453 = {setup_bump_unit_y_n2452, setup_bump_unit_y_n2436}; // u13f0
    wire [13:0] setup_bump_unit_y_n2454 = {setup_bump_unit_y_n2453, setup_bump_unit_y_n2437}; // u14f0
    wire [14:0] setup_bump_unit_y_n2455 = {setup_bump_unit_y_n2454, setup_bump_unit_y_n2438}; // u15f0
    wire [15:0] setup_bump_unit_y_n2456 = {setup_bump_unit_y_n2455, setup_bump_unit_y_n2439}; // u16f0
    wire [16:0] setup_bump_unit_y_n2457 = {setup_bump_unit_y_n2456, setup_bump_unit_y_n2440}; // u17f0
    wire [17:0] setup_bump_unit_y_n2458 = {setup_bump_unit_y_n2457, setup_bump_unit_y_n2441}; // u18f0
    wire [40:0] setup_bump_unit_y_n2461 = {setup_light_unit_x_n388, setup_bump_unit_y_n2458}; // u41f0
    wire [22:0] setup_bump_unit_y_n2462 = setup_bump_unit_y_n2461[22:0]; // u23f0
    wire signed [23:0] setup_bump_unit_y_n2463 = {1'b0, setup_bump_unit_y_n2462}; // s24f0
    wire [23:0] setup_bump_unit_y_n2464 = setup_bump_unit_y_n2463; // u24f0
    wire [24:0] setup_bump_unit_y_n2465 = {setup_bump_unit_y_n2464, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2466 = setup_bump_unit_y_n2465; // s25f0
    wire setup_bump_unit_y_n2623 = setup_bump_unit_y_n2423 == {1'b0, setup_light_length_n43, 16'h0}; // u1f0
    wire setup_bump_unit_y_n2625 = p_y[1]; // u1f0
    // setup.bump.unit_z
    wire [1:-16] setup_bump_unit_z_n2629_neg = -p_z;
    wire [1:-16] setup_bump_unit_z_n2629 = p_z[1] ? setup_bump_unit_z_n2629_neg : p_z; // u18f16
    wire setup_bump_unit_z_n2630 = setup_bump_unit_z_n2629[1]; // u1f0
    wire setup_bump_unit_z_n2631 = setup_bump_unit_z_n2629[0]; // u1f0
    wire setup_bump_unit_z_n2632 = setup_bump_unit_z_n2629[-1]; // u1f0
    wire setup_bump_unit_z_n2633 = setup_bump_unit_z_n2629[-2]; // u1f0
    wire setup_bump_unit_z_n2634 = setup_bump_unit_z_n2629[-3]; // u1f0
    wire setup_bump_unit_z_n2635 = setup_bump_unit_z_n2629[-4]; // u1f0
    wire setup_bump_unit_z_n2636 = setup_bump_unit_z_n2629[-5]; // u1f0
    wire setup_bump_unit_z_n2637 = setup_bump_unit_z_n2629[-6]; // u1f0
    wire setup_bump_unit_z_n2638 = setup_bump_unit_z_n2629[-7]; // u1f0
    wire setup_bump_unit_z_n2639 = setup_bump_unit_z_n2629[-8]; // u1f0
    wire setup_bump_unit_z_n2640 = setup_bump_unit_z_n2629[-9]; // u1f0
    wire setup_bump_unit_z_n2641 = setup_bump_unit_z_n2629[-10]; // u1f0
    wire setup_bump_unit_z_n2642 = setup_bump_unit_z_n2629[-11]; // u1f0
    wire setup_bump_unit_z_n2643 = setup_bump_unit_z_n2629[-12]; // u1f0
    wire setup_bump_unit_z_n2644 = setup_bump_unit_z_n2629[-13]; // u1f0
    wire setup_bump_unit_z_n2645 = setup_bump_unit_z_n2629[-14]; // u1f0
    wire setup_bump_unit_z_n2646 = setup_bump_unit_z_n2629[-15]; // u1f0
    wire setup_bump_unit_z_n2647 = setup_bump_unit_z_n2629[-16]; // u1f0
    wire [1:0] setup_bump_unit_z_n2648 = {setup_bump_unit_z_n2630, setup_bump_unit_z_n2631}; // u2f0
    wire [2:0] setup_bump_unit_z_n2649 = {setup_bump_unit_z_n2648, setup_bump_unit_z_n2632}; // u3f0
    wire [3:0] setup_bump_unit_z_n2650 = {setup_bump_unit_z_n2649, setup_bump_unit_z_n2633}; // u4f0
    wire [4:0] setup_bump_unit_z_n2651 = {setup_bump_unit_z_n2650, setup_bump_unit_z_n2634}; // u5f0
    wire [5:0] setup_bump_unit_z_n2652 = {setup_bump_unit_z_n2651, setup_bump_unit_z_n2635}; // u6f0
    wire [6:0] setup_bump_unit_z_n2653 = {setup_bump_unit_z_n2652, setup_bump_unit_z_n2636}; // u7f0
    wire [7:0] setup_bump_unit_z_n2654 = {setup_bump_unit_z_n2653, setup_bump_unit_z_n2637}; // u8f0
    wire [8:0] setup_bump_unit_z_n2655 = {setup_bump_unit_z_n2654, setup_bump_unit_z_n2638}; // u9f0
    wire [9:0] setup_bump_unit_z_n2656 = {setup_bump_unit_z_n2655, setup_bump_unit_z_n2639}; // u10f0
    wire [10:0] setup_bump_unit_z_n2657 = {setup_bump_unit_z_n2656, setup_bump_unit_z_n2640}; // u11f0
    wire [11:0] setup_bump_unit_z_n2658 = {setup_bump_unit_z_n2657, setup_bump_unit_z_n2641}; // u12f0
    wire [12:0] setup_bump_unit_z_n2659 = {setup_bump_unit_z_n2658, setup_bump_unit_z_n2642}; // u13f0
    wire [13:0] setup_bump_unit_z_n2660 = {setup_bump_unit_z_n2659, setup_bump_unit_z_n2643}; // u14f0
    wire [14:0] setup_bump_unit_z_n2661 = {setup_bump_unit_z_n2660, setup_bump_unit_z_n2644}; // u15f0
    wire [15:0] setup_bump_unit_z_n2662 = {setup_bump_unit_z_n2661, setup_bump_unit_z_n2645}; // u16f0
    wire [16:0] setup_bump_unit_z_n2663 = {setup_bump_unit_z_n2662, setup_bump_unit_z_n2646}; // u17f0
    wire [17:0] setup_bump_unit_z_n2664 = {setup_bump_unit_z_n2663, setup_bump_unit_z_n2647}; // u18f0
    wire [40:0] setup_bump_unit_z_n2667 = {setup_light_unit_x_n388, setup_bump_unit_z_n2664}; // u41f0
    wire [22:0] setup_bump_unit_z_n2668 = setup_bump_unit_z_n2667[22:0]; // u23f0
    wire signed [23:0] setup_bump_unit_z_n2669 = {1'b0, setup_bump_unit_z_n2668}; // s24f0
    wire [23:0] setup_bump_unit_z_n2670 = setup_bump_unit_z_n2669; // u24f0
    wire [24:0] setup_bump_unit_z_n2671 = {setup_bump_unit_z_n2670, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2672 = setup_bump_unit_z_n2671; // s25f0
    wire setup_bump_unit_z_n2829 = setup_bump_unit_z_n2629 == {1'b0, setup_light_length_n43, 16'h0}; // u1f0
    wire setup_bump_unit_z_n2831 = p_z[1]; // u1f0
    // diffuse
    wire [0:-16] diffuse_n2850 = 17'h10000; // u17f16
    wire [0:-16] diffuse_n2853 = 17'h999a; // u17f16
    wire [0:-16] diffuse_n2854 = 17'h199a; // u17f16
    // (unit)
    wire [-1:-16] n2866 = 16'h4ccd; // u16f16
    wire [-1:-16] n2867 = 16'h0; // u16f16

    reg signed [3:-32] setup_light_n18_s1; // s36f32
    reg signed [3:-32] setup_light_n19_s1; // s36f32
    reg signed [3:-32] setup_light_n20_s1; // s36f32
    reg signed [3:-32] setup_light_n24_s1; // s36f32
    reg signed [3:-32] setup_light_n25_s1; // s36f32
    reg signed [3:-32] setup_light_n26_s1; // s36f32
    reg signed [3:-32] setup_light_n30_s1; // s36f32
    reg signed [3:-32] setup_light_n31_s1; // s36f32
    reg signed [3:-32] setup_light_n32_s1; // s36f32
    reg [1:0] setup_light_length_n327_s1; // u2f0
    reg setup_light_unit_x_n396_s1; // u1f0
    reg signed [3:-32] setup_half_n989_s1; // s36f32
    reg signed [3:-32] setup_half_n990_s1; // s36f32
    reg signed [3:-32] setup_half_n991_s1; // s36f32
    reg signed [3:-32] setup_half_n995_s1; // s36f32
    reg signed [3:-32] setup_half_n996_s1; // s36f32
    reg signed [3:-32] setup_half_n997_s1; // s36f32
    reg signed [3:-32] setup_half_n1001_s1; // s36f32
    reg signed [3:-32] setup_half_n1002_s1; // s36f32
    reg signed [3:-32] setup_half_n1003_s1; // s36f32
    reg signed [3:-32] setup_bump_n1954_s1; // s36f32
    reg signed [3:-32] setup_bump_n1955_s1; // s36f32
    reg signed [3:-32] setup_bump_n1956_s1; // s36f32
    reg [17:0] setup_bump_unit_x_n2251_s1; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s1; // s25f0
    reg setup_bump_unit_x_n2417_s1; // u1f0
    reg setup_bump_unit_x_n2419_s1; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s1; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s1; // s25f0
    reg setup_bump_unit_y_n2623_s1; // u1f0
    reg setup_bump_unit_y_n2625_s1; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s1; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s1; // s25f0
    reg setup_bump_unit_z_n2829_s1; // u1f0
    reg setup_bump_unit_z_n2831_s1; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_n18_s1 <= setup_light_n18;
            setup_light_n19_s1 <= setup_light_n19;
            setup_light_n20_s1 <= setup_light_n20;
            setup_light_n24_s1 <= setup_light_n24;
            setup_light_n25_s1 <= setup_light_n25;
            setup_light_n26_s1 <= setup_light_n26;
            setup_light_n30_s1 <= setup_light_n30;
            setup_light_n31_s1 <= setup_light_n31;
            setup_light_n32_s1 <= setup_light_n32;
            setup_light_length_n327_s1 <= setup_light_length_n327;
            setup_light_unit_x_n396_s1 <= setup_light_unit_x_n396;
            setup_half_n989_s1 <= setup_half_n989;
            setup_half_n990_s1 <= setup_half_n990;
            setup_half_n991_s1 <= setup_half_n991;
            setup_half_n995_s1 <= setup_half_n995;
            setup_half_n996_s1 <= setup_half_n996;
            setup_half_n997_s1 <= setup_half_n997;
            setup_half_n1001_s1 <= setup_half_n1001;
            setup_half_n1002_s1 <= setup_half_n1002;
            setup_half_n1003_s1 <= setup_half_n1003;
            setup_bump_n1954_s1 <= setup_bump_n1954;
            setup_bump_n1955_s1 <= setup_bump_n1955;
            setup_bump_n1956_s1 <= setup_bump_n1956;
            setup_bump_unit_x_n2251_s1 <= setup_bump_unit_x_n2251;
            setup_bump_unit_x_n2259_s1 <= setup_bump_unit_x_n2259;
            setup_bump_unit_x_n2417_s1 <= setup_bump_unit_x_n2417;
            setup_bump_unit_x_n2419_s1 <= setup_bump_unit_x_n2419;
            setup_bump_unit_y_n2458_s1 <= setup_bump_unit_y_n2458;
            setup_bump_unit_y_n2466_s1 <= setup_bump_unit_y_n2466;
            setup_bump_unit_y_n2623_s1 <= setup_bump_unit_y_n2623;
            setup_bump_unit_y_n2625_s1 <= setup_bump_unit_y_n2625;
            setup_bump_unit_z_n2664_s1 <= setup_bump_unit_z_n2664;
            setup_bump_unit_z_n2672_s1 <= setup_bump_unit_z_n2672;
            setup_bump_unit_z_n2829_s1 <= setup_bump_unit_z_n2829;
            setup_bump_unit_z_n2831_s1 <= setup_bump_unit_z_n2831;
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // setup.light
    wire signed [4:-32] setup_light_n21 = {setup_light_n18_s1[3], setup_light_n18_s1} + {setup_light_n19_s1[3], setup_light_n19_s1}; // s37f32
    wire signed [5:-32] setup_light_n22 = {setup_light_n21[4], setup_light_n21} + {{2{setup_light_n20_s1[3]}}, setup_light_n20_s1}; // s38f32
    wire signed [4:-32] setup_light_n27 = {setup_light_n24_s1[3], setup_light_n24_s1} + {setup_light_n25_s1[3], setup_light_n25_s1}; // s37f32
    wire signed [5:-32] setup_light_n28 = {setup_light_n27[4], setup_light_n27} + {{2{setup_light_n26_s1[3]}}, setup_light_n26_s1}; // s38f32
    wire signed [4:-32] setup_light_n33 = {setup_light_n30_s1[3], setup_light_n30_s1} + {setup_light_n31_s1[3], setup_light_n31_s1}; // s37f32
    wire signed [5:-32] setup_light_n34 = {setup_light_n33[4], setup_light_n33} + {{2{setup_light_n32_s1[3]}}, setup_light_n32_s1}; // s38f32
    // setup.half
    wire signed [4:-32] setup_half_n992 = {setup_half_n989_s1[3], setup_half_n989_s1} + {setup_half_n990_s1[3], setup_half_n990_s1}; // s37f32
    wire signed [5:-32] setup_half_n993 = {setup_half_n992[4], setup_half_n992} + {{2{setup_half_n991_s1[3]}}, setup_half_n991_s1}; // s38f32
    wire signed [4:-32] setup_half_n998 = {setup_half_n995_s1[3], setup_half_n995_s1} + {setup_half_n996_s1[3], setup_half_n996_s1}; // s37f32
    wire signed [5:-32] setup_half_n999 = {setup_half_n998[4], setup_half_n998} + {{2{setup_half_n997_s1[3]}}, setup_half_n997_s1}; // s38f32
    wire signed [4:-32] setup_half_n1004 = {setup_half_n1001_s1[3], setup_half_n1001_s1} + {setup_half_n1002_s1[3], setup_half_n1002_s1}; // s37f32
    wire signed [5:-32] setup_half_n1005 = {setup_half_n1004[4], setup_half_n1004} + {{2{setup_half_n1003_s1[3]}}, setup_half_n1003_s1}; // s38f32
    // setup.bump
    wire signed [4:-32] setup_bump_n1957 = {setup_bump_n1954_s1[3], setup_bump_n1954_s1} + {setup_bump_n1955_s1[3], setup_bump_n1955_s1}; // s37f32
    wire signed [5:-32] setup_bump_n1958 = {setup_bump_n1957[4], setup_bump_n1957} + {{2{setup_bump_n1956_s1[3]}}, setup_bump_n1956_s1}; // s38f32
    wire setup_bump_square_under = setup_bump_n1958[5];
    wire [4:-32] setup_bump_square = setup_bump_square_under ? 37'h0 : setup_bump_n1958[4:-32]; // u37f32
    // setup.bump.length
    wire setup_bump_length_n1960 = setup_bump_square[4]; // u1f0
    wire [1:0] setup_bump_length_n1961 = {setup_light_length_n43, setup_bump_length_n1960}; // u2f0
    wire signed [2:0] setup_bump_length_n1962 = {1'b0, setup_bump_length_n1961} - {2'h0, setup_light_length_n42}; // s3f0
    wire setup_bump_length_n1963 = setup_bump_length_n1962[2]; // u1f0
    wire setup_bump_length_n1967 = setup_bump_square[3]; // u1f0
    wire setup_bump_length_n1968 = setup_bump_square[2]; // u1f0
    wire [1:0] setup_bump_length_n1969 = {setup_bump_length_n1967, setup_bump_length_n1968}; // u2f0
    wire setup_bump_length_n1979 = setup_bump_square[1]; // u1f0
    wire setup_bump_length_n1980 = setup_bump_square[0]; // u1f0
    wire [1:0] setup_bump_length_n1981 = {setup_bump_length_n1979, setup_bump_length_n1980}; // u2f0
    wire setup_bump_length_n1991 = setup_bump_square[-1]; // u1f0
    wire setup_bump_length_n1992 = setup_bump_square[-2]; // u1f0
    wire [1:0] setup_bump_length_n1993 = {setup_bump_length_n1991, setup_bump_length_n1992}; // u2f0
    wire setup_bump_length_n2003 = setup_bump_square[-3]; // u1f0
    wire setup_bump_length_n2004 = setup_bump_square[-4]; // u1f0
    wire [1:0] setup_bump_length_n2005 = {setup_bump_length_n2003, setup_bump_length_n2004}; // u2f0
    wire setup_bump_length_n2015 = setup_bump_square[-5]; // u1f0
    wire setup_bump_length_n2016 = setup_bump_square[-6]; // u1f0
    wire [1:0] setup_bump_length_n2017 = {setup_bump_length_n2015, setup_bump_length_n2016}; // u2f0
    wire setup_bump_length_n2027 = setup_bump_square[-7]; // u1f0
    wire setup_bump_length_n2028 = setup_bump_square[-8]; // u1f0
    wire [1:0] setup_bump_length_n2029 = {setup_bump_length_n2027, setup_bump_length_n2028}; // u2f0
    wire setup_bump_length_n2039 = setup_bump_square[-9]; // u1f0
    wire setup_bump_length_n2040 = setup_bump_square[-10]; // u1f0
    wire [1:0] setup_bump_length_n2041 = {setup_bump_length_n2039, setup_bump_length_n2040}; // u2f0
    wire setup_bump_length_n2051 = setup_bump_square[-11]; // u1f0
    wire setup_bump_length_n2052 = setup_bump_square[-12]; // u1f0
    wire [1:0] setup_bump_length_n2053 = {setup_bump_length_n2051, setup_bump_length_n2052}; // u2f0
    wire setup_bump_length_n2063 = setup_bump_square[-13]; // u1f0
    wire setup_bump_length_n2064 = setup_bump_square[-14]; // u1f0
    wire [1:0] setup_bump_length_n2065 = {setup_bump_length_n2063, setup_bump_length_n2064}; // u2f0
    wire setup_bump_length_n2075 = setup_bump_square[-15]; // u1f0
    wire setup_bump_length_n2076 = setup_bump_square[-16]; // u1f0
    wire [1:0] setup_bump_length_n2077 = {setup_bump_length_n2075, setup_bump_length_n2076}; // u2f0
    wire setup_bump_length_n2087 = setup_bump_square[-17]; // u1f0
    wire setup_bump_length_n2088 = setup_bump_square[-18]; // u1f0
    wire [1:0] setup_bump_length_n2089 = {setup_bump_length_n2087, setup_bump_length_n2088}; // u2f0
    wire setup_bump_length_n2099 = setup_bump_square[-19]; // u1f0
    wire setup_bump_length_n2100 = setup_bump_square[-20]; // u1f0
    wire [1:0] setup_bump_length_n2101 = {setup_bump_length_n2099, setup_bump_length_n2100}; // u2f0
    wire setup_bump_length_n2111 = setup_bump_square[-21]; // u1f0
    wire setup_bump_length_n2112 = setup_bump_square[-22]; // u1f0
    wire [1:0] setup_bump_length_n2113 = {setup_bump_length_n2111, setup_bump_length_n2112}; // u2f0
    wire setup_bump_length_n2123 = setup_bump_square[-23]; // u1f0
    wire setup_bump_length_n2124 = setup_bump_square[-24]; // u1f0
    wire [1:0] setup_bump_length_n2125 = {setup_bump_length_n2123, setup_bump_length_n2124}; // u2f0
    wire setup_bump_length_n2135 = setup_bump_square[-25]; // u1f0
    wire setup_bump_length_n2136 = setup_bump_square[-26]; // u1f0
    wire [1:0] setup_bump_length_n2137 = {setup_bump_length_n2135, setup_bump_length_n2136}; // u2f0
    wire setup_bump_length_n2147 = setup_bump_square[-27]; // u1f0
    wire setup_bump_length_n2148 = setup_bump_square[-28]; // u1f0
    wire [1:0] setup_bump_length_n2149 = {setup_bump_length_n2147, setup_bump_length_n2148}; // u2f0
    wire setup_bump_length_n2159 = setup_bump_square[-29]; // u1f0
    wire setup_bump_length_n2160 = setup_bump_square[-30]; // u1f0
    wire [1:0] setup_bump_length_n2161 = {setup_bump_length_n2159, setup_bump_length_n2160}; // u2f0
    wire setup_bump_length_n2171 = setup_bump_square[-31]; // u1f0
    wire setup_bump_length_n2172 = setup_bump_square[-32]; // u1f0
    wire [1:0] setup_bump_length_n2173 = {setup_bump_length_n2171, setup_bump_length_n2172}; // u2f0

    reg signed [5:-32] setup_light_n22_s2; // s38f32
    reg signed [5:-32] setup_light_n28_s2; // s38f32
    reg signed [5:-32] setup_light_n34_s2; // s38f32
    reg [1:0] setup_light_length_n327_s2; // u2f0
    reg setup_light_unit_x_n396_s2; // u1f0
    reg signed [5:-32] setup_half_n993_s2; // s38f32
    reg signed [5:-32] setup_half_n999_s2; // s38f32
    reg signed [5:-32] setup_half_n1005_s2; // s38f32
    reg [1:0] setup_bump_length_n1961_s2; // u2f0
    reg signed [2:0] setup_bump_length_n1962_s2; // s3f0
    reg setup_bump_length_n1963_s2; // u1f0
    reg [1:0] setup_bump_length_n1969_s2; // u2f0
    reg [1:0] setup_bump_length_n1981_s2; // u2f0
    reg [1:0] setup_bump_length_n1993_s2; // u2f0
    reg [1:0] setup_bump_length_n2005_s2; // u2f0
    reg [1:0] setup_bump_length_n2017_s2; // u2f0
    reg [1:0] setup_bump_length_n2029_s2; // u2f0
    reg [1:0] setup_bump_length_n2041_s2; // u2f0
    reg [1:0] setup_bump_length_n2053_s2; // u2f0
    reg [1:0] setup_bump_length_n2065_s2; // u2f0
    reg [1:0] setup_bump_length_n2077_s2; // u2f0
    reg [1:0] setup_bump_length_n2089_s2; // u2f0
    reg [1:0] setup_bump_length_n2101_s2; // u2f0
    reg [1:0] setup_bump_length_n2113_s2; // u2f0
    reg [1:0] setup_bump_length_n2125_s2; // u2f0
    reg [1:0] setup_bump_length_n2137_s2; // u2f0
    reg [1:0] setup_bump_length_n2149_s2; // u2f0
    reg [1:0] setup_bump_length_n2161_s2; // u2f0
    reg [1:0] setup_bump_length_n2173_s2; // u2f0
    reg [17:0] setup_bump_unit_x_n2251_s2; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s2; // s25f0
    reg setup_bump_unit_x_n2417_s2; // u1f0
    reg setup_bump_unit_x_n2419_s2; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s2; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s2; // s25f0
    reg setup_bump_unit_y_n2623_s2; // u1f0
    reg setup_bump_unit_y_n2625_s2; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s2; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s2; // s25f0
    reg setup_bump_unit_z_n2829_s2; // u1f0
    reg setup_bump_unit_z_n2831_s2; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_n22_s2 <= setup_light_n22;
            setup_light_n28_s2 <= setup_light_n28;
            setup_light_n34_s2 <= setup_light_n34;
            setup_light_length_n327_s2 <= setup_light_length_n327_s1;
            setup_light_unit_x_n396_s2 <= setup_light_unit_x_n396_s1;
            setup_half_n993_s2 <= setup_half_n993;
            setup_half_n999_s2 <= setup_half_n999;
            setup_half_n1005_s2 <= setup_half_n1005;
            setup_bump_length_n1961_s2 <= setup_bump_length_n1961;
            setup_bump_length_n1962_s2 <= setup_bump_length_n1962;
            setup_bump_length_n1963_s2 <= setup_bump_length_n1963;
            setup_bump_length_n1969_s2 <= setup_bump_length_n1969;
            setup_bump_length_n1981_s2 <= setup_bump_length_n1981;
            setup_bump_length_n1993_s2 <= setup_bump_length_n1993;
            setup_bump_length_n2005_s2 <= setup_bump_length_n2005;
            setup_bump_length_n2017_s2 <= setup_bump_length_n2017;
            setup_bump_length_n2029_s2 <= setup_bump_length_n2029;
            setup_bump_length_n2041_s2 <= setup_bump_length_n2041;
            setup_bump_length_n2053_s2 <= setup_bump_length_n2053;
            setup_bump_length_n2065_s2 <= setup_bump_length_n2065;
            setup_bump_length_n2077_s2 <= setup_bump_length_n2077;
            setup_bump_length_n2089_s2 <= setup_bump_length_n2089;
            setup_bump_length_n2101_s2 <= setup_bump_length_n2101;
            setup_bump_length_n2113_s2 <= setup_bump_length_n2113;
            setup_bump_length_n2125_s2 <= setup_bump_length_n2125;
            setup_bump_length_n2137_s2 <= setup_bump_length_n2137;
            setup_bump_length_n2149_s2 <= setup_bump_length_n2149;
            setup_bump_length_n2161_s2 <= setup_bump_length_n2161;
            setup_bump_length_n2173_s2 <= setup_bump_length_n2173;
            setup_bump_unit_x_n2251_s2 <= setup_bump_unit_x_n2251_s1;
            setup_bump_unit_x_n2259_s2 <= setup_bump_unit_x_n2259_s1;
            setup_bump_unit_x_n2417_s2 <= setup_bump_unit_x_n2417_s1;
            setup_bump_unit_x_n2419_s2 <= setup_bump_unit_x_n2419_s1;
            setup_bump_unit_y_n2458_s2 <= setup_bump_unit_y_n2458_s1;
            setup_bump_unit_y_n2466_s2 <= setup_bump_unit_y_n2466_s1;
            setup_bump_unit_y_n2623_s2 <= setup_bump_unit_y_n2623_s1;
            setup_bump_unit_y_n2625_s2 <= setup_bump_unit_y_n2625_s1;
            setup_bump_unit_z_n2664_s2 <= setup_bump_unit_z_n2664_s1;
            setup_bump_unit_z_n2672_s2 <= setup_bump_unit_z_n2672_s1;
            setup_bump_unit_z_n2829_s2 <= setup_bump_unit_z_n2829_s1;
            setup_bump_unit_z_n2831_s2 <= setup_bump_unit_z_n2831_s1;
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // setup.light
    wire signed [6:-32] setup_light_frame_x_sum = {setup_light_n22_s2[5], setup_light_n22_s2} + 39'h2000;
    wire signed [6:-18] setup_light_frame_x_cut = setup_light_frame_x_sum[6:-18];
    wire setup_light_frame_x_over = ~setup_light_frame_x_cut[6] & (|setup_light_frame_x_cut[5:4]);
    wire setup_light_frame_x_under = setup_light_frame_x_cut[6] & ~(&setup_light_frame_x_cut[5:4]);
    wire signed [4:-18] setup_light_frame_x = setup_light_frame_x_over ? 23'h3fffff : setup_light_frame_x_under ? 23'h400000 : setup_light_frame_x_cut[4:-18]; // s23f18
    wire signed [6:-32] setup_light_frame_y_sum = {setup_light_n28_s2[5], setup_light_n28_s2} + 39'h2000;
    wire signed [6:-18] setup_light_frame_y_cut = setup_light_frame_y_sum[6:-18];
    wire setup_light_frame_y_over = ~setup_light_frame_y_cut[6] & (|setup_light_frame_y_cut[5:4]);
    wire setup_light_frame_y_under = setup_light_frame_y_cut[6] & ~(&setup_light_frame_y_cut[5:4]);
    wire signed [4:-18] setup_light_frame_y = setup_light_frame_y_over ? 23'h3fffff : setup_light_frame_y_under ? 23'h400000 : setup_light_frame_y_cut[4:-18]; // s23f18
    wire signed [6:-32] setup_light_frame_z_sum = {setup_light_n34_s2[5], setup_light_n34_s2} + 39'h2000;
    wire signed [6:-18] setup_light_frame_z_cut = setup_light_frame_z_sum[6:-18];
    wire setup_light_frame_z_over = ~setup_light_frame_z_cut[6] & (|setup_light_frame_z_cut[5:4]);
    wire setup_light_frame_z_under = setup_light_frame_z_cut[6] & ~(&setup_light_frame_z_cut[5:4]);
    wire signed [4:-18] setup_light_frame_z = setup_light_frame_z_over ? 23'h3fffff : setup_light_frame_z_under ? 23'h400000 : setup_light_frame_z_cut[4:-18]; // s23f18
    // setup.light.unit_x
    wire [4:-18] setup_light_unit_x_n342_neg = -setup_light_frame_x;
    wire [4:-18] setup_light_unit_x_n342 = setup_light_frame_x[4] ? setup_light_unit_x_n342_neg : setup_light_frame_x; // u23f18
    wire setup_light_unit_x_n345 = setup_light_unit_x_n342[4]; // u1f0
    wire setup_light_unit_x_n346 = setup_light_unit_x_n342[3]; // u1f0
    wire setup_light_unit_x_n347 = setup_light_unit_x_n342[2]; // u1f0
    wire setup_light_unit_x_n348 = setup_light_unit_x_n342[1]; // u1f0
    wire setup_light_unit_x_n349 = setup_light_unit_x_n342[0]; // u1f0
    wire setup_light_unit_x_n350 = setup_light_unit_x_n342[-1]; // u1f0
    wire setup_light_unit_x_n351 = setup_light_unit_x_n342[-2]; // u1f0
    wire setup_light_unit_x_n352 = setup_light_unit_x_n342[-3]; // u1f0
    wire setup_light_unit_x_n353 = setup_light_unit_x_n342[-4]; // u1f0
    wire setup_light_unit_x_n354 = setup_light_unit_x_n342[-5]; // u1f0
    wire setup_light_unit_x_n355 = setup_light_unit_x_n342[-6]; // u1f0
    wire setup_light_unit_x_n356 = setup_light_unit_x_n342[-7]; // u1f0
    wire setup_light_unit_x_n357 = setup_light_unit_x_n342[-8]; // u1f0
    wire setup_light_unit_x_n358 = setup_light_unit_x_n342[-9]; // u1f0
    wire setup_light_unit_x_n359 = setup_light_unit_x_n342[-10]; // u1f0
    wire setup_light_unit_x_n360 = setup_light_unit_x_n342[-11]; // u1f0
    wire setup_light_unit_x_n361 = setup_light_unit_x_n342[-12]; // u1f0
    wire setup_light_unit_x_n362 = setup_light_unit_x_n342[-13]; // u1f0
    wire setup_light_unit_x_n363 = setup_light_unit_x_n342[-14]; // u1f0
    wire setup_light_unit_x_n364 = setup_light_unit_x_n342[-15]; // u1f0
    wire setup_light_unit_x_n365 = setup_light_unit_x_n342[-16]; // u1f0
    wire [1:0] setup_light_unit_x_n366 = {setup_light_unit_x_n345, setup_light_unit_x_n346}; // u2f0
    wire [2:0] setup_light_unit_x_n367 = {setup_light_unit_x_n366, setup_light_unit_x_n347}; // u3f0
    wire [3:0] setup_light_unit_x_n368 = {setup_light_unit_x_n367, setup_light_unit_x_n348}; // u4f0
    wire [4:0] setup_light_unit_x_n369 = {setup_light_unit_x_n368, setup_light_unit_x_n349}; // u5f0
    wire [5:0] setup_light_unit_x_n370 = {setup_light_unit_x_n369, setup_light_unit_x_n350}; // u6f0
    wire [6:0] setup_light_unit_x_n371 = {setup_light_unit_x_n370, setup_light_unit_x_n351}; // u7f0
    wire [7:0] setup_light_unit_x_n372 = {setup_light_unit_x_n371, setup_light_unit_x_n352}; // u8f0
    wire [8:0] setup_light_unit_x_n373 = {setup_light_unit_x_n372, setup_light_unit_x_n353}; // u9f0
    wire [9:0] setup_light_unit_x_n374 = {setup_light_unit_x_n373, setup_light_unit_x_n354}; // u10f0
    wire [10:0] setup_light_unit_x_n375 = {setup_light_unit_x_n374, setup_light_unit_x_n355}; // u11f0
    wire [11:0] setup_light_unit_x_n376 = {setup_light_unit_x_n375, setup_light_unit_x_n356}; // u12f0
    wire [12:0] setup_light_unit_x_n377 = {setup_light_unit_x_n376, setup_light_unit_x_n357}; // u13f0
    wire [13:0] setup_light_unit_x_n378 = {setup_light_unit_x_n377, setup_light_unit_x_n358}; // u14f0
    wire [14:0] setup_light_unit_x_n379 = {setup_light_unit_x_n378, setup_light_unit_x_n359}; // u15f0
    wire [15:0] setup_light_unit_x_n380 = {setup_light_unit_x_n379, setup_light_unit_x_n360}; // u16f0
    wire [16:0] setup_light_unit_x_n381 = {setup_light_unit_x_n380, setup_light_unit_x_n361}; // u17f0
    wire [17:0] setup_light_unit_x_n382 = {setup_light_unit_x_n381, setup_light_unit_x_n362}; // u18f0
    wire [18:0] setup_light_unit_x_n383 = {setup_light_unit_x_n382, setup_light_unit_x_n363}; // u19f0
    wire [19:0] setup_light_unit_x_n384 = {setup_light_unit_x_n383, setup_light_unit_x_n364}; // u20f0
    wire [20:0] setup_light_unit_x_n385 = {setup_light_unit_x_n384, setup_light_unit_x_n365}; // u21f0
    wire [43:0] setup_light_unit_x_n389 = {setup_light_unit_x_n388, setup_light_unit_x_n385}; // u44f0
    wire [22:0] setup_light_unit_x_n390 = setup_light_unit_x_n389[22:0]; // u23f0
    wire signed [23:0] setup_light_unit_x_n391 = {1'b0, setup_light_unit_x_n390}; // s24f0
    wire [23:0] setup_light_unit_x_n392 = setup_light_unit_x_n391; // u24f0
    wire setup_light_unit_x_n393 = setup_light_unit_x_n342[-17]; // u1f0
    wire [24:0] setup_light_unit_x_n394 = {setup_light_unit_x_n392, setup_light_unit_x_n393}; // u25f0
    wire signed [24:0] setup_light_unit_x_n395 = setup_light_unit_x_n394; // s25f0
    wire setup_light_unit_x_n402 = setup_light_unit_x_n342[-18]; // u1f0
    wire setup_light_unit_x_n555 = setup_light_unit_x_n342 == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_light_unit_x_n557 = setup_light_frame_x[4]; // u1f0
    // setup.light.unit_y
    wire [4:-18] setup_light_unit_y_n561_neg = -setup_light_frame_y;
    wire [4:-18] setup_light_unit_y_n561 = setup_light_frame_y[4] ? setup_light_unit_y_n561_neg : setup_light_frame_y; // u23f18
    wire setup_light_unit_y_n562 = setup_light_unit_y_n561[4]; // u1f0
    wire setup_light_unit_y_n563 = setup_light_unit_y_n561[3]; // u1f0
    wire setup_light_unit_y_n564 = setup_light_unit_y_n561[2]; // u1f0
    wire setup_light_unit_y_n565 = setup_light_unit_y_n561[1]; // u1f0
    wire setup_light_unit_y_n566 = setup_light_unit_y_n561[0]; // u1f0
    wire setup_light_unit_y_n567 = setup_light_unit_y_n561[-1]; // u1f0
    wire setup_light_unit_y_n568 = setup_light_unit_y_n561[-2]; // u1f0
    wire setup_light_unit_y_n569 = setup_light_unit_y_n561[-3]; // u1f0
    wire setup_light_unit_y_n570 = setup_light_unit_y_n561[-4]; // u1f0
    wire setup_light_unit_y_n571 = setup_light_unit_y_n561[-5]; // u1f0
    wire setup_light_unit_y_n572 = setup_light_unit_y_n561[-6]; // u1f0
    wire setup_light_unit_y_n573 = setup_light_unit_y_n561[-7]; // u1f0
    wire setup_light_unit_y_n574 = setup_light_unit_y_n561[-8]; // u1f0
    wire setup_light_unit_y_n575 = setup_light_unit_y_n561[-9]; // u1f0
    wire setup_light_unit_y_n576 = setup_light_unit_y_n561[-10]; // u1f0
    wire setup_light_unit_y_n577 = setup_light_unit_y_n561[-11]; // u1f0
    wire setup_light_unit_y_n578 = setup_light_unit_y_n561[-12]; // u1f0
    wire setup_light_unit_y_n579 = setup_light_unit_y_n561[-13]; // u1f0
    wire setup_light_unit_y_n580 = setup_light_unit_y_n561[-14]; // u1f0
    wire setup_light_unit_y_n581 = setup_light_unit_y_n561[-15]; // u1f0
    wire setup_light_unit_y_n582 = setup_light_unit_y_n561[-16]; // u1f0
    wire [1:0] setup_light_unit_y_n583 = {setup_light_unit_y_n562, setup_light_unit_y_n563}; // u2f0
    wire [2:0] setup_light_unit_y_n584 = {setup_light_unit_y_n583, setup_light_unit_y_n564}; // u3f0
    wire [3:0] setup_light_unit_y_n585 = {setup_light_unit_y_n584, setup_light_unit_y_n565}; // u4f0
    wire [4:0] setup_light_unit_y_n586 = {setup_light_unit_y_n585, setup_light_unit_y_n566}; // u5f0
    wire [5:0] setup_light_unit_y_n587 = {setup_light_unit_y_n586, setup_light_unit_y_n567}; // u6f0
    wire [6:0] setup_light_unit_y_n588 = {setup_light_unit_y_n587, setup_light_unit_y_n568}; // u7f0
    wire [7:0] setup_light_unit_y_n589 = {setup_light_unit_y_n588, setup_light_unit_y_n569}; // u8f0
    wire [8:0] setup_light_unit_y_n590 = {setup_light_unit_y_n589, setup_light_unit_y_n570}; // u9f0
    wire [9:0] setup_light_unit_y_n591 = {setup_light_unit_y_n590, setup_light_unit_y_n571}; // u10f0
    wire [10:0] setup_light_unit_y_n592 = {setup_light_unit_y_n591, setup_light_unit_y_n572}; // u11f0
    wire [11:0] setup_light_unit_y_n593 = {setup_light_unit_y_n592, setup_light_unit_y_n573}; // u12f0
    wire [12:0] setup_light_unit_y_n594 = {setup_light_unit_y_n593, setup_light_unit_y_n574}; // u13f0
    wire [13:0] setup_light_unit_y_n595 = {setup_light_unit_y_n594, setup_light_unit_y_n575}; // u14f0
    wire [14:0] setup_light_unit_y_n596 = {setup_light_unit_y_n595, setup_light_unit_y_n576}; // u15f0
    wire [15:0] setup_light_unit_y_n597 = {setup_light_unit_y_n596, setup_light_unit_y_n577}; // u16f0
    wire [16:0] setup_light_unit_y_n598 = {setup_light_unit_y_n597, setup_light_unit_y_n578}; // u17f0
    wire [17:0] setup_light_unit_y_n599 = {setup_light_unit_y_n598, setup_light_unit_y_n579}; // u18f0
    wire [18:0] setup_light_unit_y_n600 = {setup_light_unit_y_n599, setup_light_unit_y_n580}; // u19f0
    wire [19:0] setup_light_unit_y_n601 = {setup_light_unit_y_n600, setup_light_unit_y_n581}; // u20f0
    wire [20:0] setup_light_unit_y_n602 = {setup_light_unit_y_n601, setup_light_unit_y_n582}; // u21f0
    wire [43:0] setup_light_unit_y_n605 = {setup_light_unit_x_n388, setup_light_unit_y_n602}; // u44f0
    wire [22:0] setup_light_unit_y_n606 = setup_light_unit_y_n605[22:0]; // u23f0
    wire signed [23:0] setup_light_unit_y_n607 = {1'b0, setup_light_unit_y_n606}; // s24f0
    wire [23:0] setup_light_unit_y_n608 = setup_light_unit_y_n607; // u24f0
    wire setup_light_unit_y_n609 = setup_light_unit_y_n561[-17]; // u1f0
    wire [24:0] setup_light_unit_y_n610 = {setup_light_unit_y_n608, setup_light_unit_y_n609}; // u25f0
    wire signed [24:0] setup_light_unit_y_n611 = setup_light_unit_y_n610; // s25f0
    wire setup_light_unit_y_n617 = setup_light_unit_y_n561[-18]; // u1f0
    wire setup_light_unit_y_n769 = setup_light_unit_y_n561 == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_light_unit_y_n771 = setup_light_frame_y[4]; // u1f0
    // setup.light.unit_z
    wire [4:-18] setup_light_unit_z_n775_neg = -setup_light_frame_z;
    wire [4:-18] setup_light_unit_z_n775 = setup_light_frame_z[4] ? setup_light_unit_z_n775_neg : setup_light_frame_z; // u23f18
    wire setup_light_unit_z_n776 = setup_light_unit_z_n775[4]; // u1f0
    wire setup_light_unit_z_n777 = setup_light_unit_z_n775[3]; // u1f0
    wire setup_light_unit_z_n778 = setup_light_unit_z_n775[2]; // u1f0
    wire setup_light_unit_z_n779 = setup_light_unit_z_n775[1]; // u1f0
    wire setup_light_unit_z_n780 = setup_light_unit_z_n775[0]; // u1f0
    wire setup_light_unit_z_n781 = setup_light_unit_z_n775[-1]; // u1f0
    wire setup_light_unit_z_n782 = setup_light_unit_z_n775[-2]; // u1f0
    wire setup_light_unit_z_n783 = setup_light_unit_z_n775[-3]; // u1f0
    wire setup_light_unit_z_n784 = setup_light_unit_z_n775[-4]; // u1f0
    wire setup_light_unit_z_n785 = setup_light_unit_z_n775[-5]; // u1f0
    wire setup_light_unit_z_n786 = setup_light_unit_z_n775[-6]; // u1f0
    wire setup_light_unit_z_n787 = setup_light_unit_z_n775[-7]; // u1f0
    wire setup_light_unit_z_n788 = setup_light_unit_z_n775[-8]; // u1f0
    wire setup_light_unit_z_n789 = setup_light_unit_z_n775[-9]; // u1f0
    wire setup_light_unit_z_n790 = setup_light_unit_z_n775[-10]; // u1f0
    wire setup_light_unit_z_n791 = setup_light_unit_z_n775[-11]; // u1f0
    wire setup_light_unit_z_n792 = setup_light_unit_z_n775[-12]; // u1f0
    wire setup_light_unit_z_n793 = setup_light_unit_z_n775[-13]; // u1f0
    wire setup_light_unit_z_n794 = setup_light_unit_z_n775[-14]; // u1f0
    wire setup_light_unit_z_n795 = setup_light_unit_z_n775[-15]; // u1f0
    wire setup_light_unit_z_n796 = setup_light_unit_z_n775[-16]; // u1f0
    wire [1:0] setup_light_unit_z_n797 = {setup_light_unit_z_n776, setup_light_unit_z_n777}; // u2f0
    wire [2:0] setup_light_unit_z_n798 = {setup_light_unit_z_n797, setup_light_unit_z_n778}; // u3f0
    wire [3:0] setup_light_unit_z_n799 = {setup_light_unit_z_n798, setup_light_unit_z_n779}; // u4f0
    wire [4:0] setup_light_unit_z_n800 = {setup_light_unit_z_n799, setup_light_unit_z_n780}; // u5f0
    wire [5:0] setup_light_unit_z_n801 = {setup_light_unit_z_n800, setup_light_unit_z_n781}; // u6f0
    wire [6:0] setup_light_unit_z_n802 = {setup_light_unit_z_n801, setup_light_unit_z_n782}; // u7f0
    wire [7:0] setup_light_unit_z_n803 = {setup_light_unit_z_n802, setup_light_unit_z_n783}; // u8f0
    wire [8:0] setup_light_unit_z_n804 = {setup_light_unit_z_n803, setup_light_unit_z_n784}; // u9f0
    wire [9:0] setup_light_unit_z_n805 = {setup_light_unit_z_n804, setup_light_unit_z_n785}; // u10f0
    wire [10:0] setup_light_unit_z_n806 = {setup_light_unit_z_n805, setup_light_unit_z_n786}; // u11f0
    wire [11:0] setup_light_unit_z_n807 = {setup_light_unit_z_n806, setup_light_unit_z_n787}; // u12f0
    wire [12:0] setup_light_unit_z_n808 = {setup_light_unit_z_n807, setup_light_unit_z_n788}; // u13f0
    wire [13:0] setup_light_unit_z_n809 = {setup_light_unit_z_n808, setup_light_unit_z_n789}; // u14f0
    wire [14:0] setup_light_unit_z_n810 = {setup_light_unit_z_n809, setup_light_unit_z_n790}; // u15f0
    wire [15:0] setup_light_unit_z_n811 = {setup_light_unit_z_n810, setup_light_unit_z_n791}; // u16f0
    wire [16:0] setup_light_unit_z_n812 = {setup_light_unit_z_n811, setup_light_unit_z_n792}; // u17f0
    wire [17:0] setup_light_unit_z_n813 = {setup_light_unit_z_n812, setup_light_unit_z_n793}; // u18f0
    wire [18:0] setup_light_unit_z_n814 = {setup_light_unit_z_n813, setup_light_unit_z_n794}; // u19f0
    wire [19:0] setup_light_unit_z_n815 = {setup_light_unit_z_n814, setup_light_unit_z_n795}; // u20f0
    wire [20:0] setup_light_unit_z_n816 = {setup_light_unit_z_n815, setup_light_unit_z_n796}; // u21f0
    wire [43:0] setup_light_unit_z_n819 = {setup_light_unit_x_n388, setup_light_unit_z_n816}; // u44f0
    wire [22:0] setup_light_unit_z_n820 = setup_light_unit_z_n819[22:0]; // u23f0
    wire signed [23:0] setup_light_unit_z_n821 = {1'b0, setup_light_unit_z_n820}; // s24f0
    wire [23:0] setup_light_unit_z_n822 = setup_light_unit_z_n821; // u24f0
    wire setup_light_unit_z_n823 = setup_light_unit_z_n775[-17]; // u1f0
    wire [24:0] setup_light_unit_z_n824 = {setup_light_unit_z_n822, setup_light_unit_z_n823}; // u25f0
    wire signed [24:0] setup_light_unit_z_n825 = setup_light_unit_z_n824; // s25f0
    wire setup_light_unit_z_n831 = setup_light_unit_z_n775[-18]; // u1f0
    wire setup_light_unit_z_n983 = setup_light_unit_z_n775 == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_light_unit_z_n985 = setup_light_frame_z[4]; // u1f0
    // setup.half
    wire signed [6:-32] setup_half_frame_x_sum = {setup_half_n993_s2[5], setup_half_n993_s2} + 39'h2000;
    wire signed [6:-18] setup_half_frame_x_cut = setup_half_frame_x_sum[6:-18];
    wire setup_half_frame_x_over = ~setup_half_frame_x_cut[6] & (|setup_half_frame_x_cut[5:4]);
    wire setup_half_frame_x_under = setup_half_frame_x_cut[6] & ~(&setup_half_frame_x_cut[5:4]);
    wire signed [4:-18] setup_half_frame_x = setup_half_frame_x_over ? 23'h3fffff : setup_half_frame_x_under ? 23'h400000 : setup_half_frame_x_cut[4:-18]; // s23f18
    wire signed [6:-32] setup_half_frame_y_sum = {setup_half_n999_s2[5], setup_half_n999_s2} + 39'h2000;
    wire signed [6:-18] setup_half_frame_y_cut = setup_half_frame_y_sum[6:-18];
    wire setup_half_frame_y_over = ~setup_half_frame_y_cut[6] & (|setup_half_frame_y_cut[5:4]);
    wire setup_half_frame_y_under = setup_half_frame_y_cut[6] & ~(&setup_half_frame_y_cut[5:4]);
    wire signed [4:-18] setup_half_frame_y = setup_half_frame_y_over ? 23'h3fffff : setup_half_frame_y_under ? 23'h400000 : setup_half_frame_y_cut[4:-18]; // s23f18
    wire signed [6:-32] setup_half_frame_z_sum = {setup_half_n1005_s2[5], setup_half_n1005_s2} + 39'h2000;
    wire signed [6:-18] setup_half_frame_z_cut = setup_half_frame_z_sum[6:-18];
    wire setup_half_frame_z_over = ~setup_half_frame_z_cut[6] & (|setup_half_frame_z_cut[5:4]);
    wire setup_half_frame_z_under = setup_half_frame_z_cut[6] & ~(&setup_half_frame_z_cut[5:4]);
    wire signed [4:-18] setup_half_frame_z = setup_half_frame_z_over ? 23'h3fffff : setup_half_frame_z_under ? 23'h400000 : setup_half_frame_z_cut[4:-18]; // s23f18
    // setup.half.unit_x
    wire [4:-18] setup_half_unit_x_n1310_neg = -setup_half_frame_x;
    wire [4:-18] setup_half_unit_x_n1310 = setup_half_frame_x[4] ? setup_half_unit_x_n1310_neg : setup_half_frame_x; // u23f18
    wire setup_half_unit_x_n1312 = setup_half_unit_x_n1310[4]; // u1f0
    wire setup_half_unit_x_n1313 = setup_half_unit_x_n1310[3]; // u1f0
    wire setup_half_unit_x_n1314 = setup_half_unit_x_n1310[2]; // u1f0
    wire setup_half_unit_x_n1315 = setup_half_unit_x_n1310[1]; // u1f0
    wire setup_half_unit_x_n1316 = setup_half_unit_x_n1310[0]; // u1f0
    wire setup_half_unit_x_n1317 = setup_half_unit_x_n1310[-1]; // u1f0
    wire setup_half_unit_x_n1318 = setup_half_unit_x_n1310[-2]; // u1f0
    wire setup_half_unit_x_n1319 = setup_half_unit_x_n1310[-3]; // u1f0
    wire setup_half_unit_x_n1320 = setup_half_unit_x_n1310[-4]; // u1f0
    wire setup_half_unit_x_n1321 = setup_half_unit_x_n1310[-5]; // u1f0
    wire setup_half_unit_x_n1322 = setup_half_unit_x_n1310[-6]; // u1f0
    wire setup_half_unit_x_n1323 = setup_half_unit_x_n1310[-7]; // u1f0
    wire setup_half_unit_x_n1324 = setup_half_unit_x_n1310[-8]; // u1f0
    wire setup_half_unit_x_n1325 = setup_half_unit_x_n1310[-9]; // u1f0
    wire setup_half_unit_x_n1326 = setup_half_unit_x_n1310[-10]; // u1f0
    wire setup_half_unit_x_n1327 = setup_half_unit_x_n1310[-11]; // u1f0
    wire setup_half_unit_x_n1328 = setup_half_unit_x_n1310[-12]; // u1f0
    wire setup_half_unit_x_n1329 = setup_half_unit_x_n1310[-13]; // u1f0
    wire setup_half_unit_x_n1330 = setup_half_unit_x_n1310[-14]; // u1f0
    wire setup_half_unit_x_n1331 = setup_half_unit_x_n1310[-15]; // u1f0
    wire setup_half_unit_x_n1332 = setup_half_unit_x_n1310[-16]; // u1f0
    wire [1:0] setup_half_unit_x_n1333 = {setup_half_unit_x_n1312, setup_half_unit_x_n1313}; // u2f0
    wire [2:0] setup_half_unit_x_n1334 = {setup_half_unit_x_n1333, setup_half_unit_x_n1314}; // u3f0
    wire [3:0] setup_half_unit_x_n1335 = {setup_half_unit_x_n1334, setup_half_unit_x_n1315}; // u4f0
    wire [4:0] setup_half_unit_x_n1336 = {setup_half_unit_x_n1335, setup_half_unit_x_n1316}; // u5f0
    wire [5:0] setup_half_unit_x_n1337 = {setup_half_unit_x_n1336, setup_half_unit_x_n1317}; // u6f0
    wire [6:0] setup_half_unit_x_n1338 = {setup_half_unit_x_n1337, setup_half_unit_x_n1318}; // u7f0
    wire [7:0] setup_half_unit_x_n1339 = {setup_half_unit_x_n1338, setup_half_unit_x_n1319}; // u8f0
    wire [8:0] setup_half_unit_x_n1340 = {setup_half_unit_x_n1339, setup_half_unit_x_n1320}; // u9f0
    wire [9:0] setup_half_unit_x_n1341 = {setup_half_unit_x_n1340, setup_half_unit_x_n1321}; // u10f0
    wire [10:0] setup_half_unit_x_n1342 = {setup_half_unit_x_n1341, setup_half_unit_x_n1322}; // u11f0
    wire [11:0] setup_half_unit_x_n1343 = {setup_half_unit_x_n1342, setup_half_unit_x_n1323}; // u12f0
    wire [12:0] setup_half_unit_x_n1344 = {setup_half_unit_x_n1343, setup_half_unit_x_n1324}; // u13f0
    wire [13:0] setup_half_unit_x_n1345 = {setup_half_unit_x_n1344, setup_half_unit_x_n1325}; // u14f0
    wire [14:0] setup_half_unit_x_n1346 = {setup_half_unit_x_n1345, setup_half_unit_x_n1326}; // u15f0
    wire [15:0] setup_half_unit_x_n1347 = {setup_half_unit_x_n1346, setup_half_unit_x_n1327}; // u16f0
    wire [16:0] setup_half_unit_x_n1348 = {setup_half_unit_x_n1347, setup_half_unit_x_n1328}; // u17f0
    wire [17:0] setup_half_unit_x_n1349 = {setup_half_unit_x_n1348, setup_half_unit_x_n1329}; // u18f0
    wire [18:0] setup_half_unit_x_n1350 = {setup_half_unit_x_n1349, setup_half_unit_x_n1330}; // u19f0
    wire [19:0] setup_half_unit_x_n1351 = {setup_half_unit_x_n1350, setup_half_unit_x_n1331}; // u20f0
    wire [20:0] setup_half_unit_x_n1352 = {setup_half_unit_x_n1351, setup_half_unit_x_n1332}; // u21f0
    wire [43:0] setup_half_unit_x_n1355 = {setup_light_unit_x_n388, setup_half_unit_x_n1352}; // u44f0
    wire [22:0] setup_half_unit_x_n1356 = setup_half_unit_x_n1355[22:0]; // u23f0
    wire signed [23:0] setup_half_unit_x_n1357 = {1'b0, setup_half_unit_x_n1356}; // s24f0
    wire [23:0] setup_half_unit_x_n1358 = setup_half_unit_x_n1357; // u24f0
    wire setup_half_unit_x_n1359 = setup_half_unit_x_n1310[-17]; // u1f0
    wire [24:0] setup_half_unit_x_n1360 = {setup_half_unit_x_n1358, setup_half_unit_x_n1359}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1361 = setup_half_unit_x_n1360; // s25f0
    wire setup_half_unit_x_n1367 = setup_half_unit_x_n1310[-18]; // u1f0
    wire setup_half_unit_x_n1520 = setup_half_unit_x_n1310 == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_half_unit_x_n1522 = setup_half_frame_x[4]; // u1f0
    // setup.half.unit_y
    wire [4:-18] setup_half_unit_y_n1526_neg = -setup_half_frame_y;
    wire [4:-18] setup_half_unit_y_n1526 = setup_half_frame_y[4] ? setup_half_unit_y_n1526_neg : setup_half_frame_y; // u23f18
    wire setup_half_unit_y_n1527 = setup_half_unit_y_n1526[4]; // u1f0
    wire setup_half_unit_y_n1528 = setup_half_unit_y_n1526[3]; // u1f0
    wire setup_half_unit_y_n1529 = setup_half_unit_y_n1526[2]; // u1f0
    wire setup_half_unit_y_n1530 = setup_half_unit_y_n1526[1]; // u1f0
    wire setup_half_unit_y_n1531 = setup_half_unit_y_n1526[0]; // u1f0
    wire setup_half_unit_y_n1532 = setup_half_unit_y_n1526[-1]; // u1f0
    wire setup_half_unit_y_n1533 = setup_half_unit_y_n1526[-2]; // u1f0
    wire setup_half_unit_y_n1534 = setup_half_unit_y_n1526[-3]; // u1f0
    wire setup_half_unit_y_n1535 = setup_half_unit_y_n1526[-4]; // u1f0
    wire setup_half_unit_y_n1536 = setup_half_unit_y_n1526[-5]; // u1f0
    wire setup_half_unit_y_n1537 = setup_half_unit_y_n1526[-6]; // u1f0
    wire setup_half_unit_y_n1538 = setup_half_unit_y_n1526[-7]; // u1f0
    wire setup_half_unit_y_n1539 = setup_half_unit_y_n1526[-8]; // u1f0
    wire setup_half_unit_y_n1540 = setup_half_unit_y_n1526[-9]; // u1f0
    wire setup_half_unit_y_n1541 = setup_half_unit_y_n1526[-10]; // u1f0
    wire setup_half_unit_y_n1542 = setup_half_unit_y_n1526[-11]; // u1f0
    wire setup_half_unit_y_n1543 = setup_half_unit_y_n1526[-12]; // u1f0
    wire setup_half_unit_y_n1544 = setup_half_unit_y_n1526[-13]; // u1f0
    wire setup_half_unit_y_n1545 = setup_half_unit_y_n1526[-14]; // u1f0
    wire setup_half_unit_y_n1546 = setup_half_unit_y_n1526[-15]; // u1f0
    wire setup_half_unit_y_n1547 = setup_half_unit_y_n1526[-16]; // u1f0
    wire [1:0] setup_half_unit_y_n1548 = {setup_half_unit_y_n1527, setup_half_unit_y_n1528}; // u2f0
    wire [2:0] setup_half_unit_y_n1549 = {setup_half_unit_y_n1548, setup_half_unit_y_n1529}; // u3f0
    wire [3:0] setup_half_unit_y_n1550 = {setup_half_unit_y_n1549, setup_half_unit_y_n1530}; // u4f0
    wire [4:0] setup_half_unit_y_n1551 = {setup_half_unit_y_n1550, setup_half_unit_y_n1531}; // u5f0
    wire [5:0] setup_half_unit_y_n1552 = {setup_half_unit_y_n1551, setup_half_unit_y_n1532}; // u6f0
    wire [6:0] setup_half_unit_y_n1553 = {setup_half_unit_y_n1552, setup_half_unit_y_n1533}; // u7f0
    wire [7:0] setup_half_unit_y_n1554 = {setup_half_unit_y_n1553, setup_half_unit_y_n1534}; // u8f0
    wire [8:0] setup_half_unit_y_n1555 = {setup_half_unit_y_n1554, setup_half_unit_y_n1535}; // u9f0
    wire [9:0] setup_half_unit_y_n1556 = {setup_half_unit_y_n1555, setup_half_unit_y_n1536}; // u10f0
    wire [10:0] setup_half_unit_y_n1557 = {setup_half_unit_y_n1556, setup_half_unit_y_n1537}; // u11f0
    wire [11:0] setup_half_unit_y_n1558 = {setup_half_unit_y_n1557, setup_half_unit_y_n1538}; // u12f0
    wire [12:0] setup_half_unit_y_n1559 = {setup_half_unit_y_n1558, setup_half_unit_y_n1539}; // u13f0
    wire [13:0] setup_half_unit_y_n1560 = {setup_half_unit_y_n1559, setup_half_unit_y_n1540}; // u14f0
    wire [14:0] setup_half_unit_y_n1561 = {setup_half_unit_y_n1560, setup_half_unit_y_n1541}; // u15f0
    wire [15:0] setup_half_unit_y_n1562 = {setup_half_unit_y_n1561, setup_half_unit_y_n1542}; // u16f0
    wire [16:0] setup_half_unit_y_n1563 = {setup_half_unit_y_n1562, setup_half_unit_y_n1543}; // u17f0
    wire [17:0] setup_half_unit_y_n1564 = {setup_half_unit_y_n1563, setup_half_unit_y_n1544}; // u18f0
    wire [18:0] setup_half_unit_y_n1565 = {setup_half_unit_y_n1564, setup_half_unit_y_n1545}; // u19f0
    wire [19:0] setup_half_unit_y_n1566 = {setup_half_unit_y_n1565, setup_half_unit_y_n1546}; // u20f0
    wire [20:0] setup_half_unit_y_n1567 = {setup_half_unit_y_n1566, setup_half_unit_y_n1547}; // u21f0
    wire [43:0] setup_half_unit_y_n1570 = {setup_light_unit_x_n388, setup_half_unit_y_n1567}; // u44f0
    wire [22:0] setup_half_unit_y_n1571 = setup_half_unit_y_n1570[22:0]; // u23f0
    wire signed [23:0] setup_half_unit_y_n1572 = {1'b0, setup_half_unit_y_n1571}; // s24f0
    wire [23:0] setup_half_unit_y_n1573 = setup_half_unit_y_n1572; // u24f0
    wire setup_half_unit_y_n1574 = setup_half_unit_y_n1526[-17]; // u1f0
    wire [24:0] setup_half_unit_y_n1575 = {setup_half_unit_y_n1573, setup_half_unit_y_n1574}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1576 = setup_half_unit_y_n1575; // s25f0
    wire setup_half_unit_y_n1582 = setup_half_unit_y_n1526[-18]; // u1f0
    wire setup_half_unit_y_n1734 = setup_half_unit_y_n1526 == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_half_unit_y_n1736 = setup_half_frame_y[4]; // u1f0
    // setup.half.unit_z
    wire [4:-18] setup_half_unit_z_n1740_neg = -setup_half_frame_z;
    wire [4:-18] setup_half_unit_z_n1740 = setup_half_frame_z[4] ? setup_half_unit_z_n1740_neg : setup_half_frame_z; // u23f18
    wire setup_half_unit_z_n1741 = setup_half_unit_z_n1740[4]; // u1f0
    wire setup_half_unit_z_n1742 = setup_half_unit_z_n1740[3]; // u1f0
    wire setup_half_unit_z_n1743 = setup_half_unit_z_n1740[2]; // u1f0
    wire setup_half_unit_z_n1744 = setup_half_unit_z_n1740[1]; // u1f0
    wire setup_half_unit_z_n1745 = setup_half_unit_z_n1740[0]; // u1f0
    wire setup_half_unit_z_n1746 = setup_half_unit_z_n1740[-1]; // u1f0
    wire setup_half_unit_z_n1747 = setup_half_unit_z_n1740[-2]; // u1f0
    wire setup_half_unit_z_n1748 = setup_half_unit_z_n1740[-3]; // u1f0
    wire setup_half_unit_z_n1749 = setup_half_unit_z_n1740[-4]; // u1f0
    wire setup_half_unit_z_n1750 = setup_half_unit_z_n1740[-5]; // u1f0
    wire setup_half_unit_z_n1751 = setup_half_unit_z_n1740[-6]; // u1f0
    wire setup_half_unit_z_n1752 = setup_half_unit_z_n1740[-7]; // u1f0
    wire setup_half_unit_z_n1753 = setup_half_unit_z_n1740[-8]; // u1f0
    wire setup_half_unit_z_n1754 = setup_half_unit_z_n1740[-9]; // u1f0
    wire setup_half_unit_z_n1755 = setup_half_unit_z_n1740[-10]; // u1f0
    wire setup_half_unit_z_n1756 = setup_half_unit_z_n1740[-11]; // u1f0
    wire setup_half_unit_z_n1757 = setup_half_unit_z_n1740[-12]; // u1f0
    wire setup_half_unit_z_n1758 = setup_half_unit_z_n1740[-13]; // u1f0
    wire setup_half_unit_z_n1759 = setup_half_unit_z_n1740[-14]; // u1f0
    wire setup_half_unit_z_n1760 = setup_half_unit_z_n1740[-15]; // u1f0
    wire setup_half_unit_z_n1761 = setup_half_unit_z_n1740[-16]; // u1f0
    wire [1:0] setup_half_unit_z_n1762 = {setup_half_unit_z_n1741, setup_half_unit_z_n1742}; // u2f0
    wire [2:0] setup_half_unit_z_n1763 = {setup_half_unit_z_n1762, setup_half_unit_z_n1743}; // u3f0
    wire [3:0] setup_half_unit_z_n1764 = {setup_half_unit_z_n1763, setup_half_unit_z_n1744}; // u4f0
    wire [4:0] setup_half_unit_z_n1765 = {setup_half_unit_z_n1764, setup_half_unit_z_n1745}; // u5f0
    wire [5:0] setup_half_unit_z_n1766 = {setup_half_unit_z_n1765, setup_half_unit_z_n1746}; // u6f0
    wire [6:0] setup_half_unit_z_n1767 = {setup_half_unit_z_n1766, setup_half_unit_z_n1747}; // u7f0
    wire [7:0] setup_half_unit_z_n1768 = {setup_half_unit_z_n1767, setup_half_unit_z_n1748}; // u8f0
    wire [8:0] setup_half_unit_z_n1769 = {setup_half_unit_z_n1768, setup_half_unit_z_n1749}; // u9f0
    wire [9:0] setup_half_unit_z_n1770 = {setup_half_unit_z_n1769, setup_half_unit_z_n1750}; // u10f0
    wire [10:0] setup_half_unit_z_n1771 = {setup_half_unit_z_n1770, setup_half_unit_z_n1751}; // u11f0
    wire [11:0] setup_half_unit_z_n1772 = {setup_half_unit_z_n1771, setup_half_unit_z_n1752}; // u12f0
    wire [12:0] setup_half_unit_z_n1773 = {setup_half_unit_z_n1772, setup_half_unit_z_n1753}; // u13f0
    wire [13:0] setup_half_unit_z_n1774 = {setup_half_unit_z_n1773, setup_half_unit_z_n1754}; // u14f0
    wire [14:0] setup_half_unit_z_n1775 = {setup_half_unit_z_n1774, setup_half_unit_z_n1755}; // u15f0
    wire [15:0] setup_half_unit_z_n1776 = {setup_half_unit_z_n1775, setup_half_unit_z_n1756}; // u16f0
    wire [16:0] setup_half_unit_z_n1777 = {setup_half_unit_z_n1776, setup_half_unit_z_n1757}; // u17f0
    wire [17:0] setup_half_unit_z_n1778 = {setup_half_unit_z_n1777, setup_half_unit_z_n1758}; // u18f0
    wire [18:0] setup_half_unit_z_n1779 = {setup_half_unit_z_n1778, setup_half_unit_z_n1759}; // u19f0
    wire [19:0] setup_half_unit_z_n1780 = {setup_half_unit_z_n1779, setup_half_unit_z_n1760}; // u20f0
    wire [20:0] setup_half_unit_z_n1781 = {setup_half_unit_z_n1780, setup_half_unit_z_n1761}; // u21f0
    wire [43:0] setup_half_unit_z_n1784 = {setup_light_unit_x_n388, setup_half_unit_z_n1781}; // u44f0
    wire [22:0] setup_half_unit_z_n1785 = setup_half_unit_z_n1784[22:0]; // u23f0
    wire signed [23:0] setup_half_unit_z_n1786 = {1'b0, setup_half_unit_z_n1785}; // s24f0
    wire [23:0] setup_half_unit_z_n1787 = setup_half_unit_z_n1786; // u24f0
    wire setup_half_unit_z_n1788 = setup_half_unit_z_n1740[-17]; // u1f0
    wire [24:0] setup_half_unit_z_n1789 = {setup_half_unit_z_n1787, setup_half_unit_z_n1788}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1790 = setup_half_unit_z_n1789; // s25f0
    wire setup_half_unit_z_n1796 = setup_half_unit_z_n1740[-18]; // u1f0
    wire setup_half_unit_z_n1948 = setup_half_unit_z_n1740 == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_half_unit_z_n1950 = setup_half_frame_z[4]; // u1f0
    // setup.bump.length
    wire signed [2:0] setup_bump_length_n1964 = setup_bump_length_n1963_s2 ? {1'b0, setup_bump_length_n1961_s2} : setup_bump_length_n1962_s2; // s3f0
    wire [1:0] setup_bump_length_n1965 = setup_bump_length_n1964[1:0]; // u2f0
    wire setup_bump_length_n1966 = setup_bump_length_n1963_s2 ^ setup_light_length_n42; // u1f0
    wire [3:0] setup_bump_length_n1970 = {setup_bump_length_n1965, setup_bump_length_n1969_s2}; // u4f0
    wire [1:0] setup_bump_length_n1971 = {setup_bump_length_n1966, setup_light_length_n43}; // u2f0
    wire [2:0] setup_bump_length_n1972 = {setup_bump_length_n1971, setup_light_length_n42}; // u3f0
    wire signed [4:0] setup_bump_length_n1973 = {1'b0, setup_bump_length_n1970} - {2'h0, setup_bump_length_n1972}; // s5f0
    wire setup_bump_length_n1974 = setup_bump_length_n1973[4]; // u1f0
    wire signed [4:0] setup_bump_length_n1975 = setup_bump_length_n1974 ? {1'b0, setup_bump_length_n1970} : setup_bump_length_n1973; // s5f0
    wire [2:0] setup_bump_length_n1976 = setup_bump_length_n1975[2:0]; // u3f0
    wire setup_bump_length_n1977 = setup_bump_length_n1974 ^ setup_light_length_n42; // u1f0
    wire [1:0] setup_bump_length_n1978 = {setup_bump_length_n1966, setup_bump_length_n1977}; // u2f0
    wire [4:0] setup_bump_length_n1982 = {setup_bump_length_n1976, setup_bump_length_n1981_s2}; // u5f0
    wire [2:0] setup_bump_length_n1983 = {setup_bump_length_n1978, setup_light_length_n43}; // u3f0
    wire [3:0] setup_bump_length_n1984 = {setup_bump_length_n1983, setup_light_length_n42}; // u4f0
    wire signed [5:0] setup_bump_length_n1985 = {1'b0, setup_bump_length_n1982} - {2'h0, setup_bump_length_n1984}; // s6f0
    wire setup_bump_length_n1986 = setup_bump_length_n1985[5]; // u1f0
    wire signed [5:0] setup_bump_length_n1987 = setup_bump_length_n1986 ? {1'b0, setup_bump_length_n1982} : setup_bump_length_n1985; // s6f0
    wire [3:0] setup_bump_length_n1988 = setup_bump_length_n1987[3:0]; // u4f0
    wire setup_bump_length_n1989 = setup_bump_length_n1986 ^ setup_light_length_n42; // u1f0
    wire [2:0] setup_bump_length_n1990 = {setup_bump_length_n1978, setup_bump_length_n1989}; // u3f0
    wire [5:0] setup_bump_length_n1994 = {setup_bump_length_n1988, setup_bump_length_n1993_s2}; // u6f0
    wire [3:0] setup_bump_length_n1995 = {setup_bump_length_n1990, setup_light_length_n43}; // u4f0
    wire [4:0] setup_bump_length_n1996 = {setup_bump_length_n1995, setup_light_length_n42}; // u5f0
    wire signed [6:0] setup_bump_length_n1997 = {1'b0, setup_bump_length_n1994} - {2'h0, setup_bump_length_n1996}; // s7f0
    wire setup_bump_length_n1998 = setup_bump_length_n1997[6]; // u1f0
    wire signed [6:0] setup_bump_length_n1999 = setup_bump_length_n1998 ? {1'b0, setup_bump_length_n1994} : setup_bump_length_n1997; // s7f0
    wire [4:0] setup_bump_length_n2000 = setup_bump_length_n1999[4:0]; // u5f0
    wire setup_bump_length_n2001 = setup_bump_length_n1998 ^ setup_light_length_n42; // u1f0
    wire [3:0] setup_bump_length_n2002 = {setup_bump_length_n1990, setup_bump_length_n2001}; // u4f0
    wire [6:0] setup_bump_length_n2006 = {setup_bump_length_n2000, setup_bump_length_n2005_s2}; // u7f0
    wire [4:0] setup_bump_length_n2007 = {setup_bump_length_n2002, setup_light_length_n43}; // u5f0
    wire [5:0] setup_bump_length_n2008 = {setup_bump_length_n2007, setup_light_length_n42}; // u6f0

    reg signed [4:-18] setup_light_frame_x_s3; // s23f18
    reg signed [4:-18] setup_light_frame_y_s3; // s23f18
    reg signed [4:-18] setup_light_frame_z_s3; // s23f18
    reg [1:0] setup_light_length_n327_s3; // u2f0
    reg [20:0] setup_light_unit_x_n385_s3; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s3; // s25f0
    reg setup_light_unit_x_n396_s3; // u1f0
    reg setup_light_unit_x_n402_s3; // u1f0
    reg setup_light_unit_x_n555_s3; // u1f0
    reg setup_light_unit_x_n557_s3; // u1f0
    reg [20:0] setup_light_unit_y_n602_s3; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s3; // s25f0
    reg setup_light_unit_y_n617_s3; // u1f0
    reg setup_light_unit_y_n769_s3; // u1f0
    reg setup_light_unit_y_n771_s3; // u1f0
    reg [20:0] setup_light_unit_z_n816_s3; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s3; // s25f0
    reg setup_light_unit_z_n831_s3; // u1f0
    reg setup_light_unit_z_n983_s3; // u1f0
    reg setup_light_unit_z_n985_s3; // u1f0
    reg signed [4:-18] setup_half_frame_x_s3; // s23f18
    reg signed [4:-18] setup_half_frame_y_s3; // s23f18
    reg signed [4:-18] setup_half_frame_z_s3; // s23f18
    reg [20:0] setup_half_unit_x_n1352_s3; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s3; // s25f0
    reg setup_half_unit_x_n1367_s3; // u1f0
    reg setup_half_unit_x_n1520_s3; // u1f0
    reg setup_half_unit_x_n1522_s3; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s3; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s3; // s25f0
    reg setup_half_unit_y_n1582_s3; // u1f0
    reg setup_half_unit_y_n1734_s3; // u1f0
    reg setup_half_unit_y_n1736_s3; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s3; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s3; // s25f0
    reg setup_half_unit_z_n1796_s3; // u1f0
    reg setup_half_unit_z_n1948_s3; // u1f0
    reg setup_half_unit_z_n1950_s3; // u1f0
    reg [3:0] setup_bump_length_n2002_s3; // u4f0
    reg [6:0] setup_bump_length_n2006_s3; // u7f0
    reg [5:0] setup_bump_length_n2008_s3; // u6f0
    reg [1:0] setup_bump_length_n2017_s3; // u2f0
    reg [1:0] setup_bump_length_n2029_s3; // u2f0
    reg [1:0] setup_bump_length_n2041_s3; // u2f0
    reg [1:0] setup_bump_length_n2053_s3; // u2f0
    reg [1:0] setup_bump_length_n2065_s3; // u2f0
    reg [1:0] setup_bump_length_n2077_s3; // u2f0
    reg [1:0] setup_bump_length_n2089_s3; // u2f0
    reg [1:0] setup_bump_length_n2101_s3; // u2f0
    reg [1:0] setup_bump_length_n2113_s3; // u2f0
    reg [1:0] setup_bump_length_n2125_s3; // u2f0
    reg [1:0] setup_bump_length_n2137_s3; // u2f0
    reg [1:0] setup_bump_length_n2149_s3; // u2f0
    reg [1:0] setup_bump_length_n2161_s3; // u2f0
    reg [1:0] setup_bump_length_n2173_s3; // u2f0
    reg [17:0] setup_bump_unit_x_n2251_s3; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s3; // s25f0
    reg setup_bump_unit_x_n2417_s3; // u1f0
    reg setup_bump_unit_x_n2419_s3; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s3; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s3; // s25f0
    reg setup_bump_unit_y_n2623_s3; // u1f0
    reg setup_bump_unit_y_n2625_s3; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s3; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s3; // s25f0
    reg setup_bump_unit_z_n2829_s3; // u1f0
    reg setup_bump_unit_z_n2831_s3; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_frame_x_s3 <= setup_light_frame_x;
            setup_light_frame_y_s3 <= setup_light_frame_y;
            setup_light_frame_z_s3 <= setup_light_frame_z;
            setup_light_length_n327_s3 <= setup_light_length_n327_s2;
            setup_light_unit_x_n385_s3 <= setup_light_unit_x_n385;
            setup_light_unit_x_n395_s3 <= setup_light_unit_x_n395;
            setup_light_unit_x_n396_s3 <= setup_light_unit_x_n396_s2;
            setup_light_unit_x_n402_s3 <= setup_light_unit_x_n402;
            setup_light_unit_x_n555_s3 <= setup_light_unit_x_n555;
            setup_light_unit_x_n557_s3 <= setup_light_unit_x_n557;
            setup_light_unit_y_n602_s3 <= setup_light_unit_y_n602;
            setup_light_unit_y_n611_s3 <= setup_light_unit_y_n611;
            setup_light_unit_y_n617_s3 <= setup_light_unit_y_n617;
            setup_light_unit_y_n769_s3 <= setup_light_unit_y_n769;
            setup_light_unit_y_n771_s3 <= setup_light_unit_y_n771;
            setup_light_unit_z_n816_s3 <= setup_light_unit_z_n816;
            setup_light_unit_z_n825_s3 <= setup_light_unit_z_n825;
            setup_light_unit_z_n831_s3 <= setup_light_unit_z_n831;
            setup_light_unit_z_n983_s3 <= setup_light_unit_z_n983;
            setup_light_unit_z_n985_s3 <= setup_light_unit_z_n985;
            setup_half_frame_x_s3 <= setup_half_frame_x;
            setup_half_frame_y_s3 <= setup_half_frame_y;
            setup_half_frame_z_s3 <= setup_half_frame_z;
            setup_half_unit_x_n1352_s3 <= setup_half_unit_x_n1352;
            setup_half_unit_x_n1361_s3 <= setup_half_unit_x_n1361;
            setup_half_unit_x_n1367_s3 <= setup_half_unit_x_n1367;
            setup_half_unit_x_n1520_s3 <= setup_half_unit_x_n1520;
            setup_half_unit_x_n1522_s3 <= setup_half_unit_x_n1522;
            setup_half_unit_y_n1567_s3 <= setup_half_unit_y_n1567;
            setup_half_unit_y_n1576_s3 <= setup_half_unit_y_n1576;
            setup_half_unit_y_n1582_s3 <= setup_half_unit_y_n1582;
            setup_half_unit_y_n1734_s3 <= setup_half_unit_y_n1734;
            setup_half_unit_y_n1736_s3 <= setup_half_unit_y_n1736;
            setup_half_unit_z_n1781_s3 <= setup_half_unit_z_n1781;
            setup_half_unit_z_n1790_s3 <= setup_half_unit_z_n1790;
            setup_half_unit_z_n1796_s3 <= setup_half_unit_z_n1796;
            setup_half_unit_z_n1948_s3 <= setup_half_unit_z_n1948;
            setup_half_unit_z_n1950_s3 <= setup_half_unit_z_n1950;
            setup_bump_length_n2002_s3 <= setup_bump_length_n2002;
            setup_bump_length_n2006_s3 <= setup_bump_length_n2006;
            setup_bump_length_n2008_s3 <= setup_bump_length_n2008;
            setup_bump_length_n2017_s3 <= setup_bump_length_n2017_s2;
            setup_bump_length_n2029_s3 <= setup_bump_length_n2029_s2;
            setup_bump_length_n2041_s3 <= setup_bump_length_n2041_s2;
            setup_bump_length_n2053_s3 <= setup_bump_length_n2053_s2;
            setup_bump_length_n2065_s3 <= setup_bump_length_n2065_s2;
            setup_bump_length_n2077_s3 <= setup_bump_length_n2077_s2;
            setup_bump_length_n2089_s3 <= setup_bump_length_n2089_s2;
            setup_bump_length_n2101_s3 <= setup_bump_length_n2101_s2;
            setup_bump_length_n2113_s3 <= setup_bump_length_n2113_s2;
            setup_bump_length_n2125_s3 <= setup_bump_length_n2125_s2;
            setup_bump_length_n2137_s3 <= setup_bump_length_n2137_s2;
            setup_bump_length_n2149_s3 <= setup_bump_length_n2149_s2;
            setup_bump_length_n2161_s3 <= setup_bump_length_n2161_s2;
            setup_bump_length_n2173_s3 <= setup_bump_length_n2173_s2;
            setup_bump_unit_x_n2251_s3 <= setup_bump_unit_x_n2251_s2;
            setup_bump_unit_x_n2259_s3 <= setup_bump_unit_x_n2259_s2;
            setup_bump_unit_x_n2417_s3 <= setup_bump_unit_x_n2417_s2;
            setup_bump_unit_x_n2419_s3 <= setup_bump_unit_x_n2419_s2;
            setup_bump_unit_y_n2458_s3 <= setup_bump_unit_y_n2458_s2;
            setup_bump_unit_y_n2466_s3 <= setup_bump_unit_y_n2466_s2;
            setup_bump_unit_y_n2623_s3 <= setup_bump_unit_y_n2623_s2;
            setup_bump_unit_y_n2625_s3 <= setup_bump_unit_y_n2625_s2;
            setup_bump_unit_z_n2664_s3 <= setup_bump_unit_z_n2664_s2;
            setup_bump_unit_z_n2672_s3 <= setup_bump_unit_z_n2672_s2;
            setup_bump_unit_z_n2829_s3 <= setup_bump_unit_z_n2829_s2;
            setup_bump_unit_z_n2831_s3 <= setup_bump_unit_z_n2831_s2;
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // setup.light
    wire signed [9:-36] setup_light_n36 = setup_light_frame_x_s3 * setup_light_frame_x_s3; // s46f36
    wire signed [9:-36] setup_light_n37 = setup_light_frame_y_s3 * setup_light_frame_y_s3; // s46f36
    wire signed [9:-36] setup_light_n38 = setup_light_frame_z_s3 * setup_light_frame_z_s3; // s46f36
    // setup.half
    wire signed [9:-36] setup_half_n1007 = setup_half_frame_x_s3 * setup_half_frame_x_s3; // s46f36
    wire signed [9:-36] setup_half_n1008 = setup_half_frame_y_s3 * setup_half_frame_y_s3; // s46f36
    wire signed [9:-36] setup_half_n1009 = setup_half_frame_z_s3 * setup_half_frame_z_s3; // s46f36
    // setup.bump.length
    wire signed [7:0] setup_bump_length_n2009 = {1'b0, setup_bump_length_n2006_s3} - {2'h0, setup_bump_length_n2008_s3}; // s8f0
    wire setup_bump_length_n2010 = setup_bump_length_n2009[7]; // u1f0
    wire signed [7:0] setup_bump_length_n2011 = setup_bump_length_n2010 ? {1'b0, setup_bump_length_n2006_s3} : setup_bump_length_n2009; // s8f0
    wire [5:0] setup_bump_length_n2012 = setup_bump_length_n2011[5:0]; // u6f0
    wire setup_bump_length_n2013 = setup_bump_length_n2010 ^ setup_light_length_n42; // u1f0
    wire [4:0] setup_bump_length_n2014 = {setup_bump_length_n2002_s3, setup_bump_length_n2013}; // u5f0
    wire [7:0] setup_bump_length_n2018 = {setup_bump_length_n2012, setup_bump_length_n2017_s3}; // u8f0
    wire [5:0] setup_bump_length_n2019 = {setup_bump_length_n2014, setup_light_length_n43}; // u6f0
    wire [6:0] setup_bump_length_n2020 = {setup_bump_length_n2019, setup_light_length_n42}; // u7f0
    wire signed [8:0] setup_bump_length_n2021 = {1'b0, setup_bump_length_n2018} - {2'h0, setup_bump_length_n2020}; // s9f0
    wire setup_bump_length_n2022 = setup_bump_length_n2021[8]; // u1f0
    wire signed [8:0] setup_bump_length_n2023 = setup_bump_length_n2022 ? {1'b0, setup_bump_length_n2018} : setup_bump_length_n2021; // s9f0
    wire [6:0] setup_bump_length_n2024 = setup_bump_length_n2023[6:0]; // u7f0
    wire setup_bump_length_n2025 = setup_bump_length_n2022 ^ setup_light_length_n42; // u1f0
    wire [5:0] setup_bump_length_n2026 = {setup_bump_length_n2014, setup_bump_length_n2025}; // u6f0
    wire [8:0] setup_bump_length_n2030 = {setup_bump_length_n2024, setup_bump_length_n2029_s3}; // u9f0
    wire [6:0] setup_bump_length_n2031 = {setup_bump_length_n2026, setup_light_length_n43}; // u7f0
    wire [7:0] setup_bump_length_n2032 = {setup_bump_length_n2031, setup_light_length_n42}; // u8f0
    wire signed [9:0] setup_bump_length_n2033 = {1'b0, setup_bump_length_n2030} - {2'h0, setup_bump_length_n2032}; // s10f0
    wire setup_bump_length_n2034 = setup_bump_length_n2033[9]; // u1f0
    wire signed [9:0] setup_bump_length_n2035 = setup_bump_length_n2034 ? {1'b0, setup_bump_length_n2030} : setup_bump_length_n2033; // s10f0
    wire [7:0] setup_bump_length_n2036 = setup_bump_length_n2035[7:0]; // u8f0
    wire setup_bump_length_n2037 = setup_bump_length_n2034 ^ setup_light_length_n42; // u1f0
    wire [6:0] setup_bump_length_n2038 = {setup_bump_length_n2026, setup_bump_length_n2037}; // u7f0
    wire [9:0] setup_bump_length_n2042 = {setup_bump_length_n2036, setup_bump_length_n2041_s3}; // u10f0
    wire [7:0] setup_bump_length_n2043 = {setup_bump_length_n2038, setup_light_length_n43}; // u8f0
    wire [8:0] setup_bump_length_n2044 = {setup_bump_length_n2043, setup_light_length_n42}; // u9f0

    reg signed [9:-36] setup_light_n36_s4; // s46f36
    reg signed [9:-36] setup_light_n37_s4; // s46f36
    reg signed [9:-36] setup_light_n38_s4; // s46f36
    reg [1:0] setup_light_length_n327_s4; // u2f0
    reg [20:0] setup_light_unit_x_n385_s4; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s4; // s25f0
    reg setup_light_unit_x_n396_s4; // u1f0
    reg setup_light_unit_x_n402_s4; // u1f0
    reg setup_light_unit_x_n555_s4; // u1f0
    reg setup_light_unit_x_n557_s4; // u1f0
    reg [20:0] setup_light_unit_y_n602_s4; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s4; // s25f0
    reg setup_light_unit_y_n617_s4; // u1f0
    reg setup_light_unit_y_n769_s4; // u1f0
    reg setup_light_unit_y_n771_s4; // u1f0
    reg [20:0] setup_light_unit_z_n816_s4; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s4; // s25f0
    reg setup_light_unit_z_n831_s4; // u1f0
    reg setup_light_unit_z_n983_s4; // u1f0
    reg setup_light_unit_z_n985_s4; // u1f0
    reg signed [9:-36] setup_half_n1007_s4; // s46f36
    reg signed [9:-36] setup_half_n1008_s4; // s46f36
    reg signed [9:-36] setup_half_n1009_s4; // s46f36
    reg [20:0] setup_half_unit_x_n1352_s4; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s4; // s25f0
    reg setup_half_unit_x_n1367_s4; // u1f0
    reg setup_half_unit_x_n1520_s4; // u1f0
    reg setup_half_unit_x_n1522_s4; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s4; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s4; // s25f0
    reg setup_half_unit_y_n1582_s4; // u1f0
    reg setup_half_unit_y_n1734_s4; // u1f0
    reg setup_half_unit_y_n1736_s4; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s4; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s4; // s25f0
    reg setup_half_unit_z_n1796_s4; // u1f0
    reg setup_half_unit_z_n1948_s4; // u1f0
    reg setup_half_unit_z_n1950_s4; // u1f0
    reg [6:0] setup_bump_length_n2038_s4; // u7f0
    reg [9:0] setup_bump_length_n2042_s4; // u10f0
    reg [8:0] setup_bump_length_n2044_s4; // u9f0
    reg [1:0] setup_bump_length_n2053_s4; // u2f0
    reg [1:0] setup_bump_length_n2065_s4; // u2f0
    reg [1:0] setup_bump_length_n2077_s4; // u2f0
    reg [1:0] setup_bump_length_n2089_s4; // u2f0
    reg [1:0] setup_bump_length_n2101_s4; // u2f0
    reg [1:0] setup_bump_length_n2113_s4; // u2f0
    reg [1:0] setup_bump_length_n2125_s4; // u2f0
    reg [1:0] setup_bump_length_n2137_s4; // u2f0
    reg [1:0] setup_bump_length_n2149_s4; // u2f0
    reg [1:0] setup_bump_length_n2161_s4; // u2f0
    reg [1:0] setup_bump_length_n2173_s4; // u2f0
    reg [17:0] setup_bump_unit_x_n2251_s4; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s4; // s25f0
    reg setup_bump_unit_x_n2417_s4; // u1f0
    reg setup_bump_unit_x_n2419_s4; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s4; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s4; // s25f0
    reg setup_bump_unit_y_n2623_s4; // u1f0
    reg setup_bump_unit_y_n2625_s4; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s4; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s4; // s25f0
    reg setup_bump_unit_z_n2829_s4; // u1f0
    reg setup_bump_unit_z_n2831_s4; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_n36_s4 <= setup_light_n36;
            setup_light_n37_s4 <= setup_light_n37;
            setup_light_n38_s4 <= setup_light_n38;
            setup_light_length_n327_s4 <= setup_light_length_n327_s3;
            setup_light_unit_x_n385_s4 <= setup_light_unit_x_n385_s3;
            setup_light_unit_x_n395_s4 <= setup_light_unit_x_n395_s3;
            setup_light_unit_x_n396_s4 <= setup_light_unit_x_n396_s3;
            setup_light_unit_x_n402_s4 <= setup_light_unit_x_n402_s3;
            setup_light_unit_x_n555_s4 <= setup_light_unit_x_n555_s3;
            setup_light_unit_x_n557_s4 <= setup_light_unit_x_n557_s3;
            setup_light_unit_y_n602_s4 <= setup_light_unit_y_n602_s3;
            setup_light_unit_y_n611_s4 <= setup_light_unit_y_n611_s3;
            setup_light_unit_y_n617_s4 <= setup_light_unit_y_n617_s3;
            setup_light_unit_y_n769_s4 <= setup_light_unit_y_n769_s3;
            setup_light_unit_y_n771_s4 <= setup_light_unit_y_n771_s3;
            setup_light_unit_z_n816_s4 <= setup_light_unit_z_n816_s3;
            setup_light_unit_z_n825_s4 <= setup_light_unit_z_n825_s3;
            setup_light_unit_z_n831_s4 <= setup_light_unit_z_n831_s3;
            setup_light_unit_z_n983_s4 <= setup_light_unit_z_n983_s3;
            setup_light_unit_z_n985_s4 <= setup_light_unit_z_n985_s3;
            setup_half_n1007_s4 <= setup_half_n1007;
            setup_half_n1008_s4 <= setup_half_n1008;
            setup_half_n1009_s4 <= setup_half_n1009;
            setup_half_unit_x_n1352_s4 <= setup_half_unit_x_n1352_s3;
            setup_half_unit_x_n1361_s4 <= setup_half_unit_x_n1361_s3;
            setup_half_unit_x_n1367_s4 <= setup_half_unit_x_n1367_s3;
            setup_half_unit_x_n1520_s4 <= setup_half_unit_x_n1520_s3;
            setup_half_unit_x_n1522_s4 <= setup_half_unit_x_n1522_s3;
            setup_half_unit_y_n1567_s4 <= setup_half_unit_y_n1567_s3;
            setup_half_unit_y_n1576_s4 <= setup_half_unit_y_n1576_s3;
            setup_half_unit_y_n1582_s4 <= setup_half_unit_y_n1582_s3;
            setup_half_unit_y_n1734_s4 <= setup_half_unit_y_n1734_s3;
            setup_half_unit_y_n1736_s4 <= setup_half_unit_y_n1736_s3;
            setup_half_unit_z_n1781_s4 <= setup_half_unit_z_n1781_s3;
            setup_half_unit_z_n1790_s4 <= setup_half_unit_z_n1790_s3;
            setup_half_unit_z_n1796_s4 <= setup_half_unit_z_n1796_s3;
            setup_half_unit_z_n1948_s4 <= setup_half_unit_z_n1948_s3;
            setup_half_unit_z_n1950_s4 <= setup_half_unit_z_n1950_s3;
            setup_bump_length_n2038_s4 <= setup_bump_length_n2038;
            setup_bump_length_n2042_s4 <= setup_bump_length_n2042;
            setup_bump_length_n2044_s4 <= setup_bump_length_n2044;
            setup_bump_length_n2053_s4 <= setup_bump_length_n2053_s3;
            setup_bump_length_n2065_s4 <= setup_bump_length_n2065_s3;
            setup_bump_length_n2077_s4 <= setup_bump_length_n2077_s3;
            setup_bump_length_n2089_s4 <= setup_bump_length_n2089_s3;
            setup_bump_length_n2101_s4 <= setup_bump_length_n2101_s3;
            setup_bump_length_n2113_s4 <= setup_bump_length_n2113_s3;
            setup_bump_length_n2125_s4 <= setup_bump_length_n2125_s3;
            setup_bump_length_n2137_s4 <= setup_bump_length_n2137_s3;
            setup_bump_length_n2149_s4 <= setup_bump_length_n2149_s3;
            setup_bump_length_n2161_s4 <= setup_bump_length_n2161_s3;
            setup_bump_length_n2173_s4 <= setup_bump_length_n2173_s3;
            setup_bump_unit_x_n2251_s4 <= setup_bump_unit_x_n2251_s3;
            setup_bump_unit_x_n2259_s4 <= setup_bump_unit_x_n2259_s3;
            setup_bump_unit_x_n2417_s4 <= setup_bump_unit_x_n2417_s3;
            setup_bump_unit_x_n2419_s4 <= setup_bump_unit_x_n2419_s3;
            setup_bump_unit_y_n2458_s4 <= setup_bump_unit_y_n2458_s3;
            setup_bump_unit_y_n2466_s4 <= setup_bump_unit_y_n2466_s3;
            setup_bump_unit_y_n2623_s4 <= setup_bump_unit_y_n2623_s3;
            setup_bump_unit_y_n2625_s4 <= setup_bump_unit_y_n2625_s3;
            setup_bump_unit_z_n2664_s4 <= setup_bump_unit_z_n2664_s3;
            setup_bump_unit_z_n2672_s4 <= setup_bump_unit_z_n2672_s3;
            setup_bump_unit_z_n2829_s4 <= setup_bump_unit_z_n2829_s3;
            setup_bump_unit_z_n2831_s4 <= setup_bump_unit_z_n2831_s3;
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // setup.light
    wire signed [10:-36] setup_light_n39 = {setup_light_n36_s4[9], setup_light_n36_s4} + {setup_light_n37_s4[9], setup_light_n37_s4}; // s47f36
    wire signed [11:-36] setup_light_n40 = {setup_light_n39[10], setup_light_n39} + {{2{setup_light_n38_s4[9]}}, setup_light_n38_s4}; // s48f36
    wire setup_light_square_under = setup_light_n40[11];
    wire [10:-36] setup_light_square = setup_light_square_under ? 47'h0 : setup_light_n40[10:-36]; // u47f36
    // setup.light.length
    wire setup_light_length_n44 = setup_light_square[10]; // u1f0
    wire [1:0] setup_light_length_n45 = {setup_light_length_n43, setup_light_length_n44}; // u2f0
    wire setup_light_length_n51 = setup_light_square[9]; // u1f0
    wire setup_light_length_n52 = setup_light_square[8]; // u1f0
    wire [1:0] setup_light_length_n53 = {setup_light_length_n51, setup_light_length_n52}; // u2f0
    wire setup_light_length_n63 = setup_light_square[7]; // u1f0
    wire setup_light_length_n64 = setup_light_square[6]; // u1f0
    wire [1:0] setup_light_length_n65 = {setup_light_length_n63, setup_light_length_n64}; // u2f0
    wire setup_light_length_n75 = setup_light_square[5]; // u1f0
    wire setup_light_length_n76 = setup_light_square[4]; // u1f0
    wire [1:0] setup_light_length_n77 = {setup_light_length_n75, setup_light_length_n76}; // u2f0
    wire setup_light_length_n87 = setup_light_square[3]; // u1f0
    wire setup_light_length_n88 = setup_light_square[2]; // u1f0
    wire [1:0] setup_light_length_n89 = {setup_light_length_n87, setup_light_length_n88}; // u2f0
    wire setup_light_length_n99 = setup_light_square[1]; // u1f0
    wire setup_light_length_n100 = setup_light_square[0]; // u1f0
    wire [1:0] setup_light_length_n101 = {setup_light_length_n99, setup_light_length_n100}; // u2f0
    wire setup_light_length_n111 = setup_light_square[-1]; // u1f0
    wire setup_light_length_n112 = setup_light_square[-2]; // u1f0
    wire [1:0] setup_light_length_n113 = {setup_light_length_n111, setup_light_length_n112}; // u2f0
    wire setup_light_length_n123 = setup_light_square[-3]; // u1f0
    wire setup_light_length_n124 = setup_light_square[-4]; // u1f0
    wire [1:0] setup_light_length_n125 = {setup_light_length_n123, setup_light_length_n124}; // u2f0
    wire setup_light_length_n135 = setup_light_square[-5]; // u1f0
    wire setup_light_length_n136 = setup_light_square[-6]; // u1f0
    wire [1:0] setup_light_length_n137 = {setup_light_length_n135, setup_light_length_n136}; // u2f0
    wire setup_light_length_n147 = setup_light_square[-7]; // u1f0
    wire setup_light_length_n148 = setup_light_square[-8]; // u1f0
    wire [1:0] setup_light_length_n149 = {setup_light_length_n147, setup_light_length_n148}; // u2f0
    wire setup_light_length_n159 = setup_light_square[-9]; // u1f0
    wire setup_light_length_n160 = setup_light_square[-10]; // u1f0
    wire [1:0] setup_light_length_n161 = {setup_light_length_n159, setup_light_length_n160}; // u2f0
    wire setup_light_length_n171 = setup_light_square[-11]; // u1f0
    wire setup_light_length_n172 = setup_light_square[-12]; // u1f0
    wire [1:0] setup_light_length_n173 = {setup_light_length_n171, setup_light_length_n172}; // u2f0
    wire setup_light_length_n183 = setup_light_square[-13]; // u1f0
    wire setup_light_length_n184 = setup_light_square[-14]; // u1f0
    wire [1:0] setup_light_length_n185 = {setup_light_length_n183, setup_light_length_n184}; // u2f0
    wire setup_light_length_n195 = setup_light_square[-15]; // u1f0
    wire setup_light_length_n196 = setup_light_square[-16]; // u1f0
    wire [1:0] setup_light_length_n197 = {setup_light_length_n195, setup_light_length_n196}; // u2f0
    wire setup_light_length_n207 = setup_light_square[-17]; // u1f0
    wire setup_light_length_n208 = setup_light_square[-18]; // u1f0
    wire [1:0] setup_light_length_n209 = {setup_light_length_n207, setup_light_length_n208}; // u2f0
    wire setup_light_length_n219 = setup_light_square[-19]; // u1f0
    wire setup_light_length_n220 = setup_light_square[-20]; // u1f0
    wire [1:0] setup_light_length_n221 = {setup_light_length_n219, setup_light_length_n220}; // u2f0
    wire setup_light_length_n231 = setup_light_square[-21]; // u1f0
    wire setup_light_length_n232 = setup_light_square[-22]; // u1f0
    wire [1:0] setup_light_length_n233 = {setup_light_length_n231, setup_light_length_n232}; // u2f0
    wire setup_light_length_n243 = setup_light_square[-23]; // u1f0
    wire setup_light_length_n244 = setup_light_square[-24]; // u1f0
    wire [1:0] setup_light_length_n245 = {setup_light_length_n243, setup_light_length_n244}; // u2f0
    wire setup_light_length_n255 = setup_light_square[-25]; // u1f0
    wire setup_light_length_n256 = setup_light_square[-26]; // u1f0
    wire [1:0] setup_light_length_n257 = {setup_light_length_n255, setup_light_length_n256}; // u2f0
    wire setup_light_length_n267 = setup_light_square[-27]; // u1f0
    wire setup_light_length_n268 = setup_light_square[-28]; // u1f0
    wire [1:0] setup_light_length_n269 = {setup_light_length_n267, setup_light_length_n268}; // u2f0
    wire setup_light_length_n279 = setup_light_square[-29]; // u1f0
    wire setup_light_length_n280 = setup_light_square[-30]; // u1f0
    wire [1:0] setup_light_length_n281 = {setup_light_length_n279, setup_light_length_n280}; // u2f0
    wire setup_light_length_n291 = setup_light_square[-31]; // u1f0
    wire setup_light_length_n292 = setup_light_square[-32]; // u1f0
    wire [1:0] setup_light_length_n293 = {setup_light_length_n291, setup_light_length_n292}; // u2f0
    wire setup_light_length_n303 = setup_light_square[-33]; // u1f0
    wire setup_light_length_n304 = setup_light_square[-34]; // u1f0
    wire [1:0] setup_light_length_n305 = {setup_light_length_n303, setup_light_length_n304}; // u2f0
    wire setup_light_length_n315 = setup_light_square[-35]; // u1f0
    wire setup_light_length_n316 = setup_light_square[-36]; // u1f0
    wire [1:0] setup_light_length_n317 = {setup_light_length_n315, setup_light_length_n316}; // u2f0
    // setup.half
    wire signed [10:-36] setup_half_n1010 = {setup_half_n1007_s4[9], setup_half_n1007_s4} + {setup_half_n1008_s4[9], setup_half_n1008_s4}; // s47f36
    wire signed [11:-36] setup_half_n1011 = {setup_half_n1010[10], setup_half_n1010} + {{2{setup_half_n1009_s4[9]}}, setup_half_n1009_s4}; // s48f36
    wire setup_half_square_under = setup_half_n1011[11];
    wire [10:-36] setup_half_square = setup_half_square_under ? 47'h0 : setup_half_n1011[10:-36]; // u47f36
    // setup.half.length
    wire setup_half_length_n1013 = setup_half_square[10]; // u1f0
    wire [1:0] setup_half_length_n1014 = {setup_light_length_n43, setup_half_length_n1013}; // u2f0
    wire setup_half_length_n1020 = setup_half_square[9]; // u1f0
    wire setup_half_length_n1021 = setup_half_square[8]; // u1f0
    wire [1:0] setup_half_length_n1022 = {setup_half_length_n1020, setup_half_length_n1021}; // u2f0
    wire setup_half_length_n1032 = setup_half_square[7]; // u1f0
    wire setup_half_length_n1033 = setup_half_square[6]; // u1f0
    wire [1:0] setup_half_length_n1034 = {setup_half_length_n1032, setup_half_length_n1033}; // u2f0
    wire setup_half_length_n1044 = setup_half_square[5]; // u1f0
    wire setup_half_length_n1045 = setup_half_square[4]; // u1f0
    wire [1:0] setup_half_length_n1046 = {setup_half_length_n1044, setup_half_length_n1045}; // u2f0
    wire setup_half_length_n1056 = setup_half_square[3]; // u1f0
    wire setup_half_length_n1057 = setup_half_square[2]; // u1f0
    wire [1:0] setup_half_length_n1058 = {setup_half_length_n1056, setup_half_length_n1057}; // u2f0
    wire setup_half_length_n1068 = setup_half_square[1]; // u1f0
    wire setup_half_length_n1069 = setup_half_square[0]; // u1f0
    wire [1:0] setup_half_length_n1070 = {setup_half_length_n1068, setup_half_length_n1069}; // u2f0
    wire setup_half_length_n1080 = setup_half_square[-1]; // u1f0
    wire setup_half_length_n1081 = setup_half_square[-2]; // u1f0
    wire [1:0] setup_half_length_n1082 = {setup_half_length_n1080, setup_half_length_n1081}; // u2f0
    wire setup_half_length_n1092 = setup_half_square[-3]; // u1f0
    wire setup_half_length_n1093 = setup_half_square[-4]; // u1f0
    wire [1:0] setup_half_length_n1094 = {setup_half_length_n1092, setup_half_length_n1093}; // u2f0
    wire setup_half_length_n1104 = setup_half_square[-5]; // u1f0
    wire setup_half_length_n1105 = setup_half_square[-6]; // u1f0
    wire [1:0] setup_half_length_n1106 = {setup_half_length_n1104, setup_half_length_n1105}; // u2f0
    wire setup_half_length_n1116 = setup_half_square[-7]; // u1f0
    wire setup_half_length_n1117 = setup_half_square[-8]; // u1f0
    wire [1:0] setup_half_length_n1118 = {setup_half_length_n1116, setup_half_length_n1117}; // u2f0
    wire setup_half_length_n1128 = setup_half_square[-9]; // u1f0
    wire setup_half_length_n1129 = setup_half_square[-10]; // u1f0
    wire [1:0] setup_half_length_n1130 = {setup_half_length_n1128, setup_half_length_n1129}; // u2f0
    wire setup_half_length_n1140 = setup_half_square[-11]; // u1f0
    wire setup_half_length_n1141 = setup_half_square[-12]; // u1f0
    wire [1:0] setup_half_length_n1142 = {setup_half_length_n1140, setup_half_length_n1141}; // u2f0
    wire setup_half_length_n1152 = setup_half_square[-13]; // u1f0
    wire setup_half_length_n1153 = setup_half_square[-14]; // u1f0
    wire [1:0] setup_half_length_n1154 = {setup_half_length_n1152, setup_half_length_n1153}; // u2f0
    wire setup_half_length_n1164 = setup_half_square[-15]; // u1f0
    wire setup_half_length_n1165 = setup_half_square[-16]; // u1f0
    wire [1:0] setup_half_length_n1166 = {setup_half_length_n1164, setup_half_length_n1165}; // u2f0
    wire setup_half_length_n1176 = setup_half_square[-17]; // u1f0
    wire setup_half_length_n1177 = setup_half_square[-18]; // u1f0
    wire [1:0] setup_half_length_n1178 = {setup_half_length_n1176, setup_half_length_n1177}; // u2f0
    wire setup_half_length_n1188 = setup_half_square[-19]; // u1f0
    wire setup_half_length_n1189 = setup_half_square[-20]; // u1f0
    wire [1:0] setup_half_length_n1190 = {setup_half_length_n1188, setup_half_length_n1189}; // u2f0
    wire setup_half_length_n1200 = setup_half_square[-21]; // u1f0
    wire setup_half_length_n1201 = setup_half_square[-22]; // u1f0
    wire [1:0] setup_half_length_n1202 = {setup_half_length_n1200, setup_half_length_n1201}; // u2f0
    wire setup_half_length_n1212 = setup_half_square[-23]; // u1f0
    wire setup_half_length_n1213 = setup_half_square[-24]; // u1f0
    wire [1:0] setup_half_length_n1214 = {setup_half_length_n1212, setup_half_length_n1213}; // u2f0
    wire setup_half_length_n1224 = setup_half_square[-25]; // u1f0
    wire setup_half_length_n1225 = setup_half_square[-26]; // u1f0
    wire [1:0] setup_half_length_n1226 = {setup_half_length_n1224, setup_half_length_n1225}; // u2f0
    wire setup_half_length_n1236 = setup_half_square[-27]; // u1f0
    wire setup_half_length_n1237 = setup_half_square[-28]; // u1f0
    wire [1:0] setup_half_length_n1238 = {setup_half_length_n1236, setup_half_length_n1237}; // u2f0
    wire setup_half_length_n1248 = setup_half_square[-29]; // u1f0
    wire setup_half_length_n1249 = setup_half_square[-30]; // u1f0
    wire [1:0] setup_half_length_n1250 = {setup_half_length_n1248, setup_half_length_n1249}; // u2f0
    wire setup_half_length_n1260 = setup_half_square[-31]; // u1f0
    wire setup_half_length_n1261 = setup_half_square[-32]; // u1f0
    wire [1:0] setup_half_length_n1262 = {setup_half_length_n1260, setup_half_length_n1261}; // u2f0
    wire setup_half_length_n1272 = setup_half_square[-33]; // u1f0
    wire setup_half_length_n1273 = setup_half_square[-34]; // u1f0
    wire [1:0] setup_half_length_n1274 = {setup_half_length_n1272, setup_half_length_n1273}; // u2f0
    wire setup_half_length_n1284 = setup_half_square[-35]; // u1f0
    wire setup_half_length_n1285 = setup_half_square[-36]; // u1f0
    wire [1:0] setup_half_length_n1286 = {setup_half_length_n1284, setup_half_length_n1285}; // u2f0
    // setup.bump.length
    wire signed [10:0] setup_bump_length_n2045 = {1'b0, setup_bump_length_n2042_s4} - {2'h0, setup_bump_length_n2044_s4}; // s11f0
    wire setup_bump_length_n2046 = setup_bump_length_n2045[10]; // u1f0
    wire signed [10:0] setup_bump_length_n2047 = setup_bump_length_n2046 ? {1'b0, setup_bump_length_n2042_s4} : setup_bump_length_n2045; // s11f0
    wire [8:0] setup_bump_length_n2048 = setup_bump_length_n2047[8:0]; // u9f0
    wire setup_bump_length_n2049 = setup_bump_length_n2046 ^ setup_light_length_n42; // u1f0
    wire [7:0] setup_bump_length_n2050 = {setup_bump_length_n2038_s4, setup_bump_length_n2049}; // u8f0
    wire [10:0] setup_bump_length_n2054 = {setup_bump_length_n2048, setup_bump_length_n2053_s4}; // u11f0
    wire [8:0] setup_bump_length_n2055 = {setup_bump_length_n2050, setup_light_length_n43}; // u9f0
    wire [9:0] setup_bump_length_n2056 = {setup_bump_length_n2055, setup_light_length_n42}; // u10f0
    wire signed [11:0] setup_bump_length_n2057 = {1'b0, setup_bump_length_n2054} - {2'h0, setup_bump_length_n2056}; // s12f0
    wire setup_bump_length_n2058 = setup_bump_length_n2057[11]; // u1f0
    wire signed [11:0] setup_bump_length_n2059 = setup_bump_length_n2058 ? {1'b0, setup_bump_length_n2054} : setup_bump_length_n2057; // s12f0
    wire [9:0] setup_bump_length_n2060 = setup_bump_length_n2059[9:0]; // u10f0
    wire setup_bump_length_n2061 = setup_bump_length_n2058 ^ setup_light_length_n42; // u1f0
    wire [8:0] setup_bump_length_n2062 = {setup_bump_length_n2050, setup_bump_length_n2061}; // u9f0
    wire [11:0] setup_bump_length_n2066 = {setup_bump_length_n2060, setup_bump_length_n2065_s4}; // u12f0
    wire [9:0] setup_bump_length_n2067 = {setup_bump_length_n2062, setup_light_length_n43}; // u10f0
    wire [10:0] setup_bump_length_n2068 = {setup_bump_length_n2067, setup_light_length_n42}; // u11f0
    wire signed [12:0] setup_bump_length_n2069 = {1'b0, setup_bump_length_n2066} - {2'h0, setup_bump_length_n2068}; // s13f0
    wire setup_bump_length_n2070 = setup_bump_length_n2069[12]; // u1f0
    wire signed [12:0] setup_bump_length_n2071 = setup_bump_length_n2070 ? {1'b0, setup_bump_length_n2066} : setup_bump_length_n2069; // s13f0
    wire [10:0] setup_bump_length_n2072 = setup_bump_length_n2071[10:0]; // u11f0
    wire setup_bump_length_n2073 = setup_bump_length_n2070 ^ setup_light_length_n42; // u1f0
    wire [9:0] setup_bump_length_n2074 = {setup_bump_length_n2062, setup_bump_length_n2073}; // u10f0
    wire [12:0] setup_bump_length_n2078 = {setup_bump_length_n2072, setup_bump_length_n2077_s4}; // u13f0
    wire [10:0] setup_bump_length_n2079 = {setup_bump_length_n2074, setup_light_length_n43}; // u11f0
    wire [11:0] setup_bump_length_n2080 = {setup_bump_length_n2079, setup_light_length_n42}; // u12f0

    reg [1:0] setup_light_length_n45_s5; // u2f0
    reg [1:0] setup_light_length_n53_s5; // u2f0
    reg [1:0] setup_light_length_n65_s5; // u2f0
    reg [1:0] setup_light_length_n77_s5; // u2f0
    reg [1:0] setup_light_length_n89_s5; // u2f0
    reg [1:0] setup_light_length_n101_s5; // u2f0
    reg [1:0] setup_light_length_n113_s5; // u2f0
    reg [1:0] setup_light_length_n125_s5; // u2f0
    reg [1:0] setup_light_length_n137_s5; // u2f0
    reg [1:0] setup_light_length_n149_s5; // u2f0
    reg [1:0] setup_light_length_n161_s5; // u2f0
    reg [1:0] setup_light_length_n173_s5; // u2f0
    reg [1:0] setup_light_length_n185_s5; // u2f0
    reg [1:0] setup_light_length_n197_s5; // u2f0
    reg [1:0] setup_light_length_n209_s5; // u2f0
    reg [1:0] setup_light_length_n221_s5; // u2f0
    reg [1:0] setup_light_length_n233_s5; // u2f0
    reg [1:0] setup_light_length_n245_s5; // u2f0
    reg [1:0] setup_light_length_n257_s5; // u2f0
    reg [1:0] setup_light_length_n269_s5; // u2f0
    reg [1:0] setup_light_length_n281_s5; // u2f0
    reg [1:0] setup_light_length_n293_s5; // u2f0
    reg [1:0] setup_light_length_n305_s5; // u2f0
    reg [1:0] setup_light_length_n317_s5; // u2f0
    reg [1:0] setup_light_length_n327_s5; // u2f0
    reg [20:0] setup_light_unit_x_n385_s5; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s5; // s25f0
    reg setup_light_unit_x_n396_s5; // u1f0
    reg setup_light_unit_x_n402_s5; // u1f0
    reg setup_light_unit_x_n555_s5; // u1f0
    reg setup_light_unit_x_n557_s5; // u1f0
    reg [20:0] setup_light_unit_y_n602_s5; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s5; // s25f0
    reg setup_light_unit_y_n617_s5; // u1f0
    reg setup_light_unit_y_n769_s5; // u1f0
    reg setup_light_unit_y_n771_s5; // u1f0
    reg [20:0] setup_light_unit_z_n816_s5; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s5; // s25f0
    reg setup_light_unit_z_n831_s5; // u1f0
    reg setup_light_unit_z_n983_s5; // u1f0
    reg setup_light_unit_z_n985_s5; // u1f0
    reg [1:0] setup_half_length_n1014_s5; // u2f0
    reg [1:0] setup_half_length_n1022_s5; // u2f0
    reg [1:0] setup_half_length_n1034_s5; // u2f0
    reg [1:0] setup_half_length_n1046_s5; // u2f0
    reg [1:0] setup_half_length_n1058_s5; // u2f0
    reg [1:0] setup_half_length_n1070_s5; // u2f0
    reg [1:0] setup_half_length_n1082_s5; // u2f0
    reg [1:0] setup_half_length_n1094_s5; // u2f0
    reg [1:0] setup_half_length_n1106_s5; // u2f0
    reg [1:0] setup_half_length_n1118_s5; // u2f0
    reg [1:0] setup_half_length_n1130_s5; // u2f0
    reg [1:0] setup_half_length_n1142_s5; // u2f0
    reg [1:0] setup_half_length_n1154_s5; // u2f0
    reg [1:0] setup_half_length_n1166_s5; // u2f0
    reg [1:0] setup_half_length_n1178_s5; // u2f0
    reg [1:0] setup_half_length_n1190_s5; // u2f0
    reg [1:0] setup_half_length_n1202_s5; // u2f0
    reg [1:0] setup_half_length_n1214_s5; // u2f0
    reg [1:0] setup_half_length_n1226_s5; // u2f0
    reg [1:0] setup_half_length_n1238_s5; // u2f0
    reg [1:0] setup_half_length_n1250_s5; // u2f0
    reg [1:0] setup_half_length_n1262_s5; // u2f0
    reg [1:0] setup_half_length_n1274_s5; // u2f0
    reg [1:0] setup_half_length_n1286_s5; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s5; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s5; // s25f0
    reg setup_half_unit_x_n1367_s5; // u1f0
    reg setup_half_unit_x_n1520_s5; // u1f0
    reg setup_half_unit_x_n1522_s5; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s5; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s5; // s25f0
    reg setup_half_unit_y_n1582_s5; // u1f0
    reg setup_half_unit_y_n1734_s5; // u1f0
    reg setup_half_unit_y_n1736_s5; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s5; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s5; // s25f0
    reg setup_half_unit_z_n1796_s5; // u1f0
    reg setup_half_unit_z_n1948_s5; // u1f0
    reg setup_half_unit_z_n1950_s5; // u1f0
    reg [9:0] setup_bump_length_n2074_s5; // u10f0
    reg [12:0] setup_bump_length_n2078_s5; // u13f0
    reg [11:0] setup_bump_length_n2080_s5; // u12f0
    reg [1:0] setup_bump_length_n2089_s5; // u2f0
    reg [1:0] setup_bump_length_n2101_s5; // u2f0
    reg [1:0] setup_bump_length_n2113_s5; // u2f0
    reg [1:0] setup_bump_length_n2125_s5; // u2f0
    reg [1:0] setup_bump_length_n2137_s5; // u2f0
    reg [1:0] setup_bump_length_n2149_s5; // u2f0
    reg [1:0] setup_bump_length_n2161_s5; // u2f0
    reg [1:0] setup_bump_length_n2173_s5; // u2f0
    reg [17:0] setup_bump_unit_x_n2251_s5; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s5; // s25f0
    reg setup_bump_unit_x_n2417_s5; // u1f0
    reg setup_bump_unit_x_n2419_s5; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s5; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s5; // s25f0
    reg setup_bump_unit_y_n2623_s5; // u1f0
    reg setup_bump_unit_y_n2625_s5; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s5; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s5; // s25f0
    reg setup_bump_unit_z_n2829_s5; // u1f0
    reg setup_bump_unit_z_n2831_s5; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n45_s5 <= setup_light_length_n45;
            setup_light_length_n53_s5 <= setup_light_length_n53;
            setup_light_length_n65_s5 <= setup_light_length_n65;
            setup_light_length_n77_s5 <= setup_light_length_n77;
            setup_light_length_n89_s5 <= setup_light_length_n89;
            setup_light_length_n101_s5 <= setup_light_length_n101;
            setup_light_length_n113_s5 <= setup_light_length_n113;
            setup_light_length_n125_s5 <= setup_light_length_n125;
            setup_light_length_n137_s5 <= setup_light_length_n137;
            setup_light_length_n149_s5 <= setup_light_length_n149;
            setup_light_length_n161_s5 <= setup_light_length_n161;
            setup_light_length_n173_s5 <= setup_light_length_n173;
            setup_light_length_n185_s5 <= setup_light_length_n185;
            setup_light_length_n197_s5 <= setup_light_length_n197;
            setup_light_length_n209_s5 <= setup_light_length_n209;
            setup_light_length_n221_s5 <= setup_light_length_n221;
            setup_light_length_n233_s5 <= setup_light_length_n233;
            setup_light_length_n245_s5 <= setup_light_length_n245;
            setup_light_length_n257_s5 <= setup_light_length_n257;
            setup_light_length_n269_s5 <= setup_light_length_n269;
            setup_light_length_n281_s5 <= setup_light_length_n281;
            setup_light_length_n293_s5 <= setup_light_length_n293;
            setup_light_length_n305_s5 <= setup_light_length_n305;
            setup_light_length_n317_s5 <= setup_light_length_n317;
            setup_light_length_n327_s5 <= setup_light_length_n327_s4;
            setup_light_unit_x_n385_s5 <= setup_light_unit_x_n385_s4;
            setup_light_unit_x_n395_s5 <= setup_light_unit_x_n395_s4;
            setup_light_unit_x_n396_s5 <= setup_light_unit_x_n396_s4;
            setup_light_unit_x_n402_s5 <= setup_light_unit_x_n402_s4;
            setup_light_unit_x_n555_s5 <= setup_light_unit_x_n555_s4;
            setup_light_unit_x_n557_s5 <= setup_light_unit_x_n557_s4;
            setup_light_unit_y_n602_s5 <= setup_light_unit_y_n602_s4;
            setup_light_unit_y_n611_s5 <= setup_light_unit_y_n611_s4;
            setup_light_unit_y_n617_s5 <= setup_light_unit_y_n617_s4;
            setup_light_unit_y_n769_s5 <= setup_light_unit_y_n769_s4;
            setup_light_unit_y_n771_s5 <= setup_light_unit_y_n771_s4;
            setup_light_unit_z_n816_s5 <= setup_light_unit_z_n816_s4;
            setup_light_unit_z_n825_s5 <= setup_light_unit_z_n825_s4;
            setup_light_unit_z_n831_s5 <= setup_light_unit_z_n831_s4;
            setup_light_unit_z_n983_s5 <= setup_light_unit_z_n983_s4;
            setup_light_unit_z_n985_s5 <= setup_light_unit_z_n985_s4;
            setup_half_length_n1014_s5 <= setup_half_length_n1014;
            setup_half_length_n1022_s5 <= setup_half_length_n1022;
            setup_half_length_n1034_s5 <= setup_half_length_n1034;
            setup_half_length_n1046_s5 <= setup_half_length_n1046;
            setup_half_length_n1058_s5 <= setup_half_length_n1058;
            setup_half_length_n1070_s5 <= setup_half_length_n1070;
            setup_half_length_n1082_s5 <= setup_half_length_n1082;
            setup_half_length_n1094_s5 <= setup_half_length_n1094;
            setup_half_length_n1106_s5 <= setup_half_length_n1106;
            setup_half_length_n1118_s5 <= setup_half_length_n1118;
            setup_half_length_n1130_s5 <= setup_half_length_n1130;
            setup_half_length_n1142_s5 <= setup_half_length_n1142;
            setup_half_length_n1154_s5 <= setup_half_length_n1154;
            setup_half_length_n1166_s5 <= setup_half_length_n1166;
            setup_half_length_n1178_s5 <= setup_half_length_n1178;
            setup_half_length_n1190_s5 <= setup_half_length_n1190;
            setup_half_length_n1202_s5 <= setup_half_length_n1202;
            setup_half_length_n1214_s5 <= setup_half_length_n1214;
            setup_half_length_n1226_s5 <= setup_half_length_n1226;
            setup_half_length_n1238_s5 <= setup_half_length_n1238;
            setup_half_length_n1250_s5 <= setup_half_length_n1250;
            setup_half_length_n1262_s5 <= setup_half_length_n1262;
            setup_half_length_n1274_s5 <= setup_half_length_n1274;
            setup_half_length_n1286_s5 <= setup_half_length_n1286;
            setup_half_unit_x_n1352_s5 <= setup_half_unit_x_n1352_s4;
            setup_half_unit_x_n1361_s5 <= setup_half_unit_x_n1361_s4;
            setup_half_unit_x_n1367_s5 <= setup_half_unit_x_n1367_s4;
            setup_half_unit_x_n1520_s5 <= setup_half_unit_x_n1520_s4;
            setup_half_unit_x_n1522_s5 <= setup_half_unit_x_n1522_s4;
            setup_half_unit_y_n1567_s5 <= setup_half_unit_y_n1567_s4;
            setup_half_unit_y_n1576_s5 <= setup_half_unit_y_n1576_s4;
            setup_half_unit_y_n1582_s5 <= setup_half_unit_y_n1582_s4;
            setup_half_unit_y_n1734_s5 <= setup_half_unit_y_n1734_s4;
            setup_half_unit_y_n1736_s5 <= setup_half_unit_y_n1736_s4;
            setup_half_unit_z_n1781_s5 <= setup_half_unit_z_n1781_s4;
            setup_half_unit_z_n1790_s5 <= setup_half_unit_z_n1790_s4;
            setup_half_unit_z_n1796_s5 <= setup_half_unit_z_n1796_s4;
            setup_half_unit_z_n1948_s5 <= setup_half_unit_z_n1948_s4;
            setup_half_unit_z_n1950_s5 <= setup_half_unit_z_n1950_s4;
            setup_bump_length_n2074_s5 <= setup_bump_length_n2074;
            setup_bump_length_n2078_s5 <= setup_bump_length_n2078;
            setup_bump_length_n2080_s5 <= setup_bump_length_n2080;
            setup_bump_length_n2089_s5 <= setup_bump_length_n2089_s4;
            setup_bump_length_n2101_s5 <= setup_bump_length_n2101_s4;
            setup_bump_length_n2113_s5 <= setup_bump_length_n2113_s4;
            setup_bump_length_n2125_s5 <= setup_bump_length_n2125_s4;
            setup_bump_length_n2137_s5 <= setup_bump_length_n2137_s4;
            setup_bump_length_n2149_s5 <= setup_bump_length_n2149_s4;
            setup_bump_length_n2161_s5 <= setup_bump_length_n2161_s4;
            setup_bump_length_n2173_s5 <= setup_bump_length_n2173_s4;
            setup_bump_unit_x_n2251_s5 <= setup_bump_unit_x_n2251_s4;
            setup_bump_unit_x_n2259_s5 <= setup_bump_unit_x_n2259_s4;
            setup_bump_unit_x_n2417_s5 <= setup_bump_unit_x_n2417_s4;
            setup_bump_unit_x_n2419_s5 <= setup_bump_unit_x_n2419_s4;
            setup_bump_unit_y_n2458_s5 <= setup_bump_unit_y_n2458_s4;
            setup_bump_unit_y_n2466_s5 <= setup_bump_unit_y_n2466_s4;
            setup_bump_unit_y_n2623_s5 <= setup_bump_unit_y_n2623_s4;
            setup_bump_unit_y_n2625_s5 <= setup_bump_unit_y_n2625_s4;
            setup_bump_unit_z_n2664_s5 <= setup_bump_unit_z_n2664_s4;
            setup_bump_unit_z_n2672_s5 <= setup_bump_unit_z_n2672_s4;
            setup_bump_unit_z_n2829_s5 <= setup_bump_unit_z_n2829_s4;
            setup_bump_unit_z_n2831_s5 <= setup_bump_unit_z_n2831_s4;
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // setup.light.length
    wire signed [2:0] setup_light_length_n46 = {1'b0, setup_light_length_n45_s5} - {2'h0, setup_light_length_n42}; // s3f0
    wire setup_light_length_n47 = setup_light_length_n46[2]; // u1f0
    wire signed [2:0] setup_light_length_n48 = setup_light_length_n47 ? {1'b0, setup_light_length_n45_s5} : setup_light_length_n46; // s3f0
    wire [1:0] setup_light_length_n49 = setup_light_length_n48[1:0]; // u2f0
    wire setup_light_length_n50 = setup_light_length_n47 ^ setup_light_length_n42; // u1f0
    wire [3:0] setup_light_length_n54 = {setup_light_length_n49, setup_light_length_n53_s5}; // u4f0
    wire [1:0] setup_light_length_n55 = {setup_light_length_n50, setup_light_length_n43}; // u2f0
    wire [2:0] setup_light_length_n56 = {setup_light_length_n55, setup_light_length_n42}; // u3f0
    wire signed [4:0] setup_light_length_n57 = {1'b0, setup_light_length_n54} - {2'h0, setup_light_length_n56}; // s5f0
    wire setup_light_length_n58 = setup_light_length_n57[4]; // u1f0
    wire signed [4:0] setup_light_length_n59 = setup_light_length_n58 ? {1'b0, setup_light_length_n54} : setup_light_length_n57; // s5f0
    wire [2:0] setup_light_length_n60 = setup_light_length_n59[2:0]; // u3f0
    wire setup_light_length_n61 = setup_light_length_n58 ^ setup_light_length_n42; // u1f0
    wire [1:0] setup_light_length_n62 = {setup_light_length_n50, setup_light_length_n61}; // u2f0
    wire [4:0] setup_light_length_n66 = {setup_light_length_n60, setup_light_length_n65_s5}; // u5f0
    wire [2:0] setup_light_length_n67 = {setup_light_length_n62, setup_light_length_n43}; // u3f0
    wire [3:0] setup_light_length_n68 = {setup_light_length_n67, setup_light_length_n42}; // u4f0
    wire signed [5:0] setup_light_length_n69 = {1'b0, setup_light_length_n66} - {2'h0, setup_light_length_n68}; // s6f0
    wire setup_light_length_n70 = setup_light_length_n69[5]; // u1f0
    wire signed [5:0] setup_light_length_n71 = setup_light_length_n70 ? {1'b0, setup_light_length_n66} : setup_light_length_n69; // s6f0
    wire [3:0] setup_light_length_n72 = setup_light_length_n71[3:0]; // u4f0
    wire setup_light_length_n73 = setup_light_length_n70 ^ setup_light_length_n42; // u1f0
    wire [2:0] setup_light_length_n74 = {setup_light_length_n62, setup_light_length_n73}; // u3f0
    wire [5:0] setup_light_length_n78 = {setup_light_length_n72, setup_light_length_n77_s5}; // u6f0
    wire [3:0] setup_light_length_n79 = {setup_light_length_n74, setup_light_length_n43}; // u4f0
    wire [4:0] setup_light_length_n80 = {setup_light_length_n79, setup_light_length_n42}; // u5f0
    wire signed [6:0] setup_light_length_n81 = {1'b0, setup_light_length_n78} - {2'h0, setup_light_length_n80}; // s7f0
    wire setup_light_length_n82 = setup_light_length_n81[6]; // u1f0
    // setup.half.length
    wire signed [2:0] setup_half_length_n1015 = {1'b0, setup_half_length_n1014_s5} - {2'h0, setup_light_length_n42}; // s3f0
    wire setup_half_length_n1016 = setup_half_length_n1015[2]; // u1f0
    wire signed [2:0] setup_half_length_n1017 = setup_half_length_n1016 ? {1'b0, setup_half_length_n1014_s5} : setup_half_length_n1015; // s3f0
    wire [1:0] setup_half_length_n1018 = setup_half_length_n1017[1:0]; // u2f0
    wire setup_half_length_n1019 = setup_half_length_n1016 ^ setup_light_length_n42; // u1f0
    wire [3:0] setup_half_length_n1023 = {setup_half_length_n1018, setup_half_length_n1022_s5}; // u4f0
    wire [1:0] setup_half_length_n1024 = {setup_half_length_n1019, setup_light_length_n43}; // u2f0
    wire [2:0] setup_half_length_n1025 = {setup_half_length_n1024, setup_light_length_n42}; // u3f0
    wire signed [4:0] setup_half_length_n1026 = {1'b0, setup_half_length_n1023} - {2'h0, setup_half_length_n1025}; // s5f0
    wire setup_half_length_n1027 = setup_half_length_n1026[4]; // u1f0
    wire signed [4:0] setup_half_length_n1028 = setup_half_length_n1027 ? {1'b0, setup_half_length_n1023} : setup_half_length_n1026; // s5f0
    wire [2:0] setup_half_length_n1029 = setup_half_length_n1028[2:0]; // u3f0
    wire setup_half_length_n1030 = setup_half_length_n1027 ^ setup_light_length_n42; // u1f0
    wire [1:0] setup_half_length_n1031 = {setup_half_length_n1019, setup_half_length_n1030}; // u2f0
    wire [4:0] setup_half_length_n1035 = {setup_half_length_n1029, setup_half_length_n1034_s5}; // u5f0
    wire [2:0] setup_half_length_n1036 = {setup_half_length_n1031, setup_light_length_n43}; // u3f0
    wire [3:0] setup_half_length_n1037 = {setup_half_length_n1036, setup_light_length_n42}; // u4f0
    wire signed [5:0] setup_half_length_n1038 = {1'b0, setup_half_length_n1035} - {2'h0, setup_half_length_n1037}; // s6f0
    wire setup_half_length_n1039 = setup_half_length_n1038[5]; // u1f0
    wire signed [5:0] setup_half_length_n1040 = setup_half_length_n1039 ? {1'b0, setup_half_length_n1035} : setup_half_length_n1038; // s6f0
    wire [3:0] setup_half_length_n1041 = setup_half_length_n1040[3:0]; // u4f0
    wire setup_half_length_n1042 = setup_half_length_n1039 ^ setup_light_length_n42; // u1f0
    wire [2:0] setup_half_length_n1043 = {setup_half_length_n1031, setup_half_length_n1042}; // u3f0
    wire [5:0] setup_half_length_n1047 = {setup_half_length_n1041, setup_half_length_n1046_s5}; // u6f0
    wire [3:0] setup_half_length_n1048 = {setup_half_length_n1043, setup_light_length_n43}; // u4f0
    wire [4:0] setup_half_length_n1049 = {setup_half_length_n1048, setup_light_length_n42}; // u5f0
    wire signed [6:0] setup_half_length_n1050 = {1'b0, setup_half_length_n1047} - {2'h0, setup_half_length_n1049}; // s7f0
    wire setup_half_length_n1051 = setup_half_length_n1050[6]; // u1f0
    // setup.bump.length
    wire signed [13:0] setup_bump_length_n2081 = {1'b0, setup_bump_length_n2078_s5} - {2'h0, setup_bump_length_n2080_s5}; // s14f0
    wire setup_bump_length_n2082 = setup_bump_length_n2081[13]; // u1f0
    wire signed [13:0] setup_bump_length_n2083 = setup_bump_length_n2082 ? {1'b0, setup_bump_length_n2078_s5} : setup_bump_length_n2081; // s14f0
    wire [11:0] setup_bump_length_n2084 = setup_bump_length_n2083[11:0]; // u12f0
    wire setup_bump_length_n2085 = setup_bump_length_n2082 ^ setup_light_length_n42; // u1f0
    wire [10:0] setup_bump_length_n2086 = {setup_bump_length_n2074_s5, setup_bump_length_n2085}; // u11f0
    wire [13:0] setup_bump_length_n2090 = {setup_bump_length_n2084, setup_bump_length_n2089_s5}; // u14f0
    wire [11:0] setup_bump_length_n2091 = {setup_bump_length_n2086, setup_light_length_n43}; // u12f0
    wire [12:0] setup_bump_length_n2092 = {setup_bump_length_n2091, setup_light_length_n42}; // u13f0
    wire signed [14:0] setup_bump_length_n2093 = {1'b0, setup_bump_length_n2090} - {2'h0, setup_bump_length_n2092}; // s15f0
    wire setup_bump_length_n2094 = setup_bump_length_n2093[14]; // u1f0
    wire signed [14:0] setup_bump_length_n2095 = setup_bump_length_n2094 ? {1'b0, setup_bump_length_n2090} : setup_bump_length_n2093; // s15f0
    wire [12:0] setup_bump_length_n2096 = setup_bump_length_n2095[12:0]; // u13f0
    wire setup_bump_length_n2097 = setup_bump_length_n2094 ^ setup_light_length_n42; // u1f0
    wire [11:0] setup_bump_length_n2098 = {setup_bump_length_n2086, setup_bump_length_n2097}; // u12f0
    wire [14:0] setup_bump_length_n2102 = {setup_bump_length_n2096, setup_bump_length_n2101_s5}; // u15f0
    wire [12:0] setup_bump_length_n2103 = {setup_bump_length_n2098, setup_light_length_n43}; // u13f0
    wire [13:0] setup_bump_length_n2104 = {setup_bump_length_n2103, setup_light_length_n42}; // u14f0
    wire signed [15:0] setup_bump_length_n2105 = {1'b0, setup_bump_length_n2102} - {2'h0, setup_bump_length_n2104}; // s16f0
    wire setup_bump_length_n2106 = setup_bump_length_n2105[15]; // u1f0
    wire signed [15:0] setup_bump_length_n2107 = setup_bump_length_n2106 ? {1'b0, setup_bump_length_n2102} : setup_bump_length_n2105; // s16f0
    wire [13:0] setup_bump_length_n2108 = setup_bump_length_n2107[13:0]; // u14f0
    wire setup_bump_length_n2109 = setup_bump_length_n2106 ^ setup_light_length_n42; // u1f0
    wire [12:0] setup_bump_length_n2110 = {setup_bump_length_n2098, setup_bump_length_n2109}; // u13f0
    wire [15:0] setup_bump_length_n2114 = {setup_bump_length_n2108, setup_bump_length_n2113_s5}; // u16f0
    wire [13:0] setup_bump_length_n2115 = {setup_bump_length_n2110, setup_light_length_n43}; // u14f0
    wire [14:0] setup_bump_length_n2116 = {setup_bump_length_n2115, setup_light_length_n42}; // u15f0

    reg [2:0] setup_light_length_n74_s6; // u3f0
    reg [5:0] setup_light_length_n78_s6; // u6f0
    reg signed [6:0] setup_light_length_n81_s6; // s7f0
    reg setup_light_length_n82_s6; // u1f0
    reg [1:0] setup_light_length_n89_s6; // u2f0
    reg [1:0] setup_light_length_n101_s6; // u2f0
    reg [1:0] setup_light_length_n113_s6; // u2f0
    reg [1:0] setup_light_length_n125_s6; // u2f0
    reg [1:0] setup_light_length_n137_s6; // u2f0
    reg [1:0] setup_light_length_n149_s6; // u2f0
    reg [1:0] setup_light_length_n161_s6; // u2f0
    reg [1:0] setup_light_length_n173_s6; // u2f0
    reg [1:0] setup_light_length_n185_s6; // u2f0
    reg [1:0] setup_light_length_n197_s6; // u2f0
    reg [1:0] setup_light_length_n209_s6; // u2f0
    reg [1:0] setup_light_length_n221_s6; // u2f0
    reg [1:0] setup_light_length_n233_s6; // u2f0
    reg [1:0] setup_light_length_n245_s6; // u2f0
    reg [1:0] setup_light_length_n257_s6; // u2f0
    reg [1:0] setup_light_length_n269_s6; // u2f0
    reg [1:0] setup_light_length_n281_s6; // u2f0
    reg [1:0] setup_light_length_n293_s6; // u2f0
    reg [1:0] setup_light_length_n305_s6; // u2f0
    reg [1:0] setup_light_length_n317_s6; // u2f0
    reg [1:0] setup_light_length_n327_s6; // u2f0
    reg [20:0] setup_light_unit_x_n385_s6; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s6; // s25f0
    reg setup_light_unit_x_n396_s6; // u1f0
    reg setup_light_unit_x_n402_s6; // u1f0
    reg setup_light_unit_x_n555_s6; // u1f0
    reg setup_light_unit_x_n557_s6; // u1f0
    reg [20:0] setup_light_unit_y_n602_s6; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s6; // s25f0
    reg setup_light_unit_y_n617_s6; // u1f0
    reg setup_light_unit_y_n769_s6; // u1f0
    reg setup_light_unit_y_n771_s6; // u1f0
    reg [20:0] setup_light_unit_z_n816_s6; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s6; // s25f0
    reg setup_light_unit_z_n831_s6; // u1f0
    reg setup_light_unit_z_n983_s6; // u1f0
    reg setup_light_unit_z_n985_s6; // u1f0
    reg [2:0] setup_half_length_n1043_s6; // u3f0
    reg [5:0] setup_half_length_n1047_s6; // u6f0
    reg signed [6:0] setup_half_length_n1050_s6; // s7f0
    reg setup_half_length_n1051_s6; // u1f0
    reg [1:0] setup_half_length_n1058_s6; // u2f0
    reg [1:0] setup_half_length_n1070_s6; // u2f0
    reg [1:0] setup_half_length_n1082_s6; // u2f0
    reg [1:0] setup_half_length_n1094_s6; // u2f0
    reg [1:0] setup_half_length_n1106_s6; // u2f0
    reg [1:0] setup_half_length_n1118_s6; // u2f0
    reg [1:0] setup_half_length_n1130_s6; // u2f0
    reg [1:0] setup_half_length_n1142_s6; // u2f0
    reg [1:0] setup_half_length_n1154_s6; // u2f0
    reg [1:0] setup_half_length_n1166_s6; // u2f0
    reg [1:0] setup_half_length_n1178_s6; // u2f0
    reg [1:0] setup_half_length_n1190_s6; // u2f0
    reg [1:0] setup_half_length_n1202_s6; // u2f0
    reg [1:0] setup_half_length_n1214_s6; // u2f0
    reg [1:0] setup_half_length_n1226_s6; // u2f0
    reg [1:0] setup_half_length_n1238_s6; // u2f0
    reg [1:0] setup_half_length_n1250_s6; // u2f0
    reg [1:0] setup_half_length_n1262_s6; // u2f0
    reg [1:0] setup_half_length_n1274_s6; // u2f0
    reg [1:0] setup_half_length_n1286_s6; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s6; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s6; // s25f0
    reg setup_half_unit_x_n1367_s6; // u1f0
    reg setup_half_unit_x_n1520_s6; // u1f0
    reg setup_half_unit_x_n1522_s6; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s6; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s6; // s25f0
    reg setup_half_unit_y_n1582_s6; // u1f0
    reg setup_half_unit_y_n1734_s6; // u1f0
    reg setup_half_unit_y_n1736_s6; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s6; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s6; // s25f0
    reg setup_half_unit_z_n1796_s6; // u1f0
    reg setup_half_unit_z_n1948_s6; // u1f0
    reg setup_half_unit_z_n1950_s6; // u1f0
    reg [12:0] setup_bump_length_n2110_s6; // u13f0
    reg [15:0] setup_bump_length_n2114_s6; // u16f0
    reg [14:0] setup_bump_length_n2116_s6; // u15f0
    reg [1:0] setup_bump_length_n2125_s6; // u2f0
    reg [1:0] setup_bump_length_n2137_s6; // u2f0
    reg [1:0] setup_bump_length_n2149_s6; // u2f0
    reg [1:0] setup_bump_length_n2161_s6; // u2f0
    reg [1:0] setup_bump_length_n2173_s6; // u2f0
    reg [17:0] setup_bump_unit_x_n2251_s6; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s6; // s25f0
    reg setup_bump_unit_x_n2417_s6; // u1f0
    reg setup_bump_unit_x_n2419_s6; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s6; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s6; // s25f0
    reg setup_bump_unit_y_n2623_s6; // u1f0
    reg setup_bump_unit_y_n2625_s6; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s6; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s6; // s25f0
    reg setup_bump_unit_z_n2829_s6; // u1f0
    reg setup_bump_unit_z_n2831_s6; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n74_s6 <= setup_light_length_n74;
            setup_light_length_n78_s6 <= setup_light_length_n78;
            setup_light_length_n81_s6 <= setup_light_length_n81;
            setup_light_length_n82_s6 <= setup_light_length_n82;
            setup_light_length_n89_s6 <= setup_light_length_n89_s5;
            setup_light_length_n101_s6 <= setup_light_length_n101_s5;
            setup_light_length_n113_s6 <= setup_light_length_n113_s5;
            setup_light_length_n125_s6 <= setup_light_length_n125_s5;
            setup_light_length_n137_s6 <= setup_light_length_n137_s5;
            setup_light_length_n149_s6 <= setup_light_length_n149_s5;
            setup_light_length_n161_s6 <= setup_light_length_n161_s5;
            setup_light_length_n173_s6 <= setup_light_length_n173_s5;
            setup_light_length_n185_s6 <= setup_light_length_n185_s5;
            setup_light_length_n197_s6 <= setup_light_length_n197_s5;
            setup_light_length_n209_s6 <= setup_light_length_n209_s5;
            setup_light_length_n221_s6 <= setup_light_length_n221_s5;
            setup_light_length_n233_s6 <= setup_light_length_n233_s5;
            setup_light_length_n245_s6 <= setup_light_length_n245_s5;
            setup_light_length_n257_s6 <= setup_light_length_n257_s5;
            setup_light_length_n269_s6 <= setup_light_length_n269_s5;
            setup_light_length_n281_s6 <= setup_light_length_n281_s5;
            setup_light_length_n293_s6 <= setup_light_length_n293_s5;
            setup_light_length_n305_s6 <= setup_light_length_n305_s5;
            setup_light_length_n317_s6 <= setup_light_length_n317_s5;
            setup_light_length_n327_s6 <= setup_light_length_n327_s5;
            setup_light_unit_x_n385_s6 <= setup_light_unit_x_n385_s5;
            setup_light_unit_x_n395_s6 <= setup_light_unit_x_n395_s5;
            setup_light_unit_x_n396_s6 <= setup_light_unit_x_n396_s5;
            setup_light_unit_x_n402_s6 <= setup_light_unit_x_n402_s5;
            setup_light_unit_x_n555_s6 <= setup_light_unit_x_n555_s5;
            setup_light_unit_x_n557_s6 <= setup_light_unit_x_n557_s5;
            setup_light_unit_y_n602_s6 <= setup_light_unit_y_n602_s5;
            setup_light_unit_y_n611_s6 <= setup_light_unit_y_n611_s5;
            setup_light_unit_y_n617_s6 <= setup_light_unit_y_n617_s5;
            setup_light_unit_y_n769_s6 <= setup_light_unit_y_n769_s5;
            setup_light_unit_y_n771_s6 <= setup_light_unit_y_n771_s5;
            setup_light_unit_z_n816_s6 <= setup_light_unit_z_n816_s5;
            setup_light_unit_z_n825_s6 <= setup_light_unit_z_n825_s5;
            setup_light_unit_z_n831_s6 <= setup_light_unit_z_n831_s5;
            setup_light_unit_z_n983_s6 <= setup_light_unit_z_n983_s5;
            setup_light_unit_z_n985_s6 <= setup_light_unit_z_n985_s5;
            setup_half_length_n1043_s6 <= setup_half_length_n1043;
            setup_half_length_n1047_s6 <= setup_half_length_n1047;
            setup_half_length_n1050_s6 <= setup_half_length_n1050;
            setup_half_length_n1051_s6 <= setup_half_length_n1051;
            setup_half_length_n1058_s6 <= setup_half_length_n1058_s5;
            setup_half_length_n1070_s6 <= setup_half_length_n1070_s5;
            setup_half_length_n1082_s6 <= setup_half_length_n1082_s5;
            setup_half_length_n1094_s6 <= setup_half_length_n1094_s5;
            setup_half_length_n1106_s6 <= setup_half_length_n1106_s5;
            setup_half_length_n1118_s6 <= setup_half_length_n1118_s5;
            setup_half_length_n1130_s6 <= setup_half_length_n1130_s5;
            setup_half_length_n1142_s6 <= setup_half_length_n1142_s5;
            setup_half_length_n1154_s6 <= setup_half_length_n1154_s5;
            setup_half_length_n1166_s6 <= setup_half_length_n1166_s5;
            setup_half_length_n1178_s6 <= setup_half_length_n1178_s5;
            setup_half_length_n1190_s6 <= setup_half_length_n1190_s5;
            setup_half_length_n1202_s6 <= setup_half_length_n1202_s5;
            setup_half_length_n1214_s6 <= setup_half_length_n1214_s5;
            setup_half_length_n1226_s6 <= setup_half_length_n1226_s5;
            setup_half_length_n1238_s6 <= setup_half_length_n1238_s5;
            setup_half_length_n1250_s6 <= setup_half_length_n1250_s5;
            setup_half_length_n1262_s6 <= setup_half_length_n1262_s5;
            setup_half_length_n1274_s6 <= setup_half_length_n1274_s5;
            setup_half_length_n1286_s6 <= setup_half_length_n1286_s5;
            setup_half_unit_x_n1352_s6 <= setup_half_unit_x_n1352_s5;
            setup_half_unit_x_n1361_s6 <= setup_half_unit_x_n1361_s5;
            setup_half_unit_x_n1367_s6 <= setup_half_unit_x_n1367_s5;
            setup_half_unit_x_n1520_s6 <= setup_half_unit_x_n1520_s5;
            setup_half_unit_x_n1522_s6 <= setup_half_unit_x_n1522_s5;
            setup_half_unit_y_n1567_s6 <= setup_half_unit_y_n1567_s5;
            setup_half_unit_y_n1576_s6 <= setup_half_unit_y_n1576_s5;
            setup_half_unit_y_n1582_s6 <= setup_half_unit_y_n1582_s5;
            setup_half_unit_y_n1734_s6 <= setup_half_unit_y_n1734_s5;
            setup_half_unit_y_n1736_s6 <= setup_half_unit_y_n1736_s5;
            setup_half_unit_z_n1781_s6 <= setup_half_unit_z_n1781_s5;
            setup_half_unit_z_n1790_s6 <= setup_half_unit_z_n1790_s5;
            setup_half_unit_z_n1796_s6 <= setup_half_unit_z_n1796_s5;
            setup_half_unit_z_n1948_s6 <= setup_half_unit_z_n1948_s5;
            setup_half_unit_z_n1950_s6 <= setup_half_unit_z_n1950_s5;
            setup_bump_length_n2110_s6 <= setup_bump_length_n2110;
            setup_bump_length_n2114_s6 <= setup_bump_length_n2114;
            setup_bump_length_n2116_s6 <= setup_bump_length_n2116;
            setup_bump_length_n2125_s6 <= setup_bump_length_n2125_s5;
            setup_bump_length_n2137_s6 <= setup_bump_length_n2137_s5;
            setup_bump_length_n2149_s6 <= setup_bump_length_n2149_s5;
            setup_bump_length_n2161_s6 <= setup_bump_length_n2161_s5;
            setup_bump_length_n2173_s6 <= setup_bump_length_n2173_s5;
            setup_bump_unit_x_n2251_s6 <= setup_bump_unit_x_n2251_s5;
            setup_bump_unit_x_n2259_s6 <= setup_bump_unit_x_n2259_s5;
            setup_bump_unit_x_n2417_s6 <= setup_bump_unit_x_n2417_s5;
            setup_bump_unit_x_n2419_s6 <= setup_bump_unit_x_n2419_s5;
            setup_bump_unit_y_n2458_s6 <= setup_bump_unit_y_n2458_s5;
            setup_bump_unit_y_n2466_s6 <= setup_bump_unit_y_n2466_s5;
            setup_bump_unit_y_n2623_s6 <= setup_bump_unit_y_n2623_s5;
            setup_bump_unit_y_n2625_s6 <= setup_bump_unit_y_n2625_s5;
            setup_bump_unit_z_n2664_s6 <= setup_bump_unit_z_n2664_s5;
            setup_bump_unit_z_n2672_s6 <= setup_bump_unit_z_n2672_s5;
            setup_bump_unit_z_n2829_s6 <= setup_bump_unit_z_n2829_s5;
            setup_bump_unit_z_n2831_s6 <= setup_bump_unit_z_n2831_s5;
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // setup.light.length
    wire signed [6:0] setup_light_length_n83 = setup_light_length_n82_s6 ? {1'b0, setup_light_length_n78_s6} : setup_light_length_n81_s6; // s7f0
    wire [4:0] setup_light_length_n84 = setup_light_length_n83[4:0]; // u5f0
    wire setup_light_length_n85 = setup_light_length_n82_s6 ^ setup_light_length_n42; // u1f0
    wire [3:0] setup_light_length_n86 = {setup_light_length_n74_s6, setup_light_length_n85}; // u4f0
    wire [6:0] setup_light_length_n90 = {setup_light_length_n84, setup_light_length_n89_s6}; // u7f0
    wire [4:0] setup_light_length_n91 = {setup_light_length_n86, setup_light_length_n43}; // u5f0
    wire [5:0] setup_light_length_n92 = {setup_light_length_n91, setup_light_length_n42}; // u6f0
    wire signed [7:0] setup_light_length_n93 = {1'b0, setup_light_length_n90} - {2'h0, setup_light_length_n92}; // s8f0
    wire setup_light_length_n94 = setup_light_length_n93[7]; // u1f0
    wire signed [7:0] setup_light_length_n95 = setup_light_length_n94 ? {1'b0, setup_light_length_n90} : setup_light_length_n93; // s8f0
    wire [5:0] setup_light_length_n96 = setup_light_length_n95[5:0]; // u6f0
    wire setup_light_length_n97 = setup_light_length_n94 ^ setup_light_length_n42; // u1f0
    wire [4:0] setup_light_length_n98 = {setup_light_length_n86, setup_light_length_n97}; // u5f0
    wire [7:0] setup_light_length_n102 = {setup_light_length_n96, setup_light_length_n101_s6}; // u8f0
    wire [5:0] setup_light_length_n103 = {setup_light_length_n98, setup_light_length_n43}; // u6f0
    wire [6:0] setup_light_length_n104 = {setup_light_length_n103, setup_light_length_n42}; // u7f0
    wire signed [8:0] setup_light_length_n105 = {1'b0, setup_light_length_n102} - {2'h0, setup_light_length_n104}; // s9f0
    wire setup_light_length_n106 = setup_light_length_n105[8]; // u1f0
    wire signed [8:0] setup_light_length_n107 = setup_light_length_n106 ? {1'b0, setup_light_length_n102} : setup_light_length_n105; // s9f0
    wire [6:0] setup_light_length_n108 = setup_light_length_n107[6:0]; // u7f0
    wire setup_light_length_n109 = setup_light_length_n106 ^ setup_light_length_n42; // u1f0
    wire [5:0] setup_light_length_n110 = {setup_light_length_n98, setup_light_length_n109}; // u6f0
    wire [8:0] setup_light_length_n114 = {setup_light_length_n108, setup_light_length_n113_s6}; // u9f0
    wire [6:0] setup_light_length_n115 = {setup_light_length_n110, setup_light_length_n43}; // u7f0
    wire [7:0] setup_light_length_n116 = {setup_light_length_n115, setup_light_length_n42}; // u8f0
    wire signed [9:0] setup_light_length_n117 = {1'b0, setup_light_length_n114} - {2'h0, setup_light_length_n116}; // s10f0
    wire setup_light_length_n118 = setup_light_length_n117[9]; // u1f0
    wire signed [9:0] setup_light_length_n119 = setup_light_length_n118 ? {1'b0, setup_light_length_n114} : setup_light_length_n117; // s10f0
    wire [7:0] setup_light_length_n120 = setup_light_length_n119[7:0]; // u8f0
    wire setup_light_length_n121 = setup_light_length_n118 ^ setup_light_length_n42; // u1f0
    wire [6:0] setup_light_length_n122 = {setup_light_length_n110, setup_light_length_n121}; // u7f0
    wire [9:0] setup_light_length_n126 = {setup_light_length_n120, setup_light_length_n125_s6}; // u10f0
    wire [7:0] setup_light_length_n127 = {setup_light_length_n122, setup_light_length_n43}; // u8f0
    wire [8:0] setup_light_length_n128 = {setup_light_length_n127, setup_light_length_n42}; // u9f0
    // setup.half.length
    wire signed [6:0] setup_half_length_n1052 = setup_half_length_n1051_s6 ? {1'b0, setup_half_length_n1047_s6} : setup_half_length_n1050_s6; // s7f0
    wire [4:0] setup_half_length_n1053 = setup_half_length_n1052[4:0]; // u5f0
    wire setup_half_length_n1054 = setup_half_length_n1051_s6 ^ setup_light_length_n42; // u1f0
    wire [3:0] setup_half_length_n1055 = {setup_half_length_n1043_s6, setup_half_length_n1054}; // u4f0
    wire [6:0] setup_half_length_n1059 = {setup_half_length_n1053, setup_half_length_n1058_s6}; // u7f0
    wire [4:0] setup_half_length_n1060 = {setup_half_length_n1055, setup_light_length_n43}; // u5f0
    wire [5:0] setup_half_length_n1061 = {setup_half_length_n1060, setup_light_length_n42}; // u6f0
    wire signed [7:0] setup_half_length_n1062 = {1'b0, setup_half_length_n1059} - {2'h0, setup_half_length_n1061}; // s8f0
    wire setup_half_length_n1063 = setup_half_length_n1062[7]; // u1f0
    wire signed [7:0] setup_half_length_n1064 = setup_half_length_n1063 ? {1'b0, setup_half_length_n1059} : setup_half_length_n1062; // s8f0
    wire [5:0] setup_half_length_n1065 = setup_half_length_n1064[5:0]; // u6f0
    wire setup_half_length_n1066 = setup_half_length_n1063 ^ setup_light_length_n42; // u1f0
    wire [4:0] setup_half_length_n1067 = {setup_half_length_n1055, setup_half_length_n1066}; // u5f0
    wire [7:0] setup_half_length_n1071 = {setup_half_length_n1065, setup_half_length_n1070_s6}; // u8f0
    wire [5:0] setup_half_length_n1072 = {setup_half_length_n1067, setup_light_length_n43}; // u6f0
    wire [6:0] setup_half_length_n1073 = {setup_half_length_n1072, setup_light_length_n42}; // u7f0
    wire signed [8:0] setup_half_length_n1074 = {1'b0, setup_half_length_n1071} - {2'h0, setup_half_length_n1073}; // s9f0
    wire setup_half_length_n1075 = setup_half_length_n1074[8]; // u1f0
    wire signed [8:0] setup_half_length_n1076 = setup_half_length_n1075 ? {1'b0, setup_half_length_n1071} : setup_half_length_n1074; // s9f0
    wire [6:0] setup_half_length_n1077 = setup_half_length_n1076[6:0]; // u7f0
    wire setup_half_length_n1078 = setup_half_length_n1075 ^ setup_light_length_n42; // u1f0
    wire [5:0] setup_half_length_n1079 = {setup_half_length_n1067, setup_half_length_n1078}; // u6f0
    wire [8:0] setup_half_length_n1083 = {setup_half_length_n1077, setup_half_length_n1082_s6}; // u9f0
    wire [6:0] setup_half_length_n1084 = {setup_half_length_n1079, setup_light_length_n43}; // u7f0
    wire [7:0] setup_half_length_n1085 = {setup_half_length_n1084, setup_light_length_n42}; // u8f0
    wire signed [9:0] setup_half_length_n1086 = {1'b0, setup_half_length_n1083} - {2'h0, setup_half_length_n1085}; // s10f0
    wire setup_half_length_n1087 = setup_half_length_n1086[9]; // u1f0
    wire signed [9:0] setup_half_length_n1088 = setup_half_length_n1087 ? {1'b0, setup_half_length_n1083} : setup_half_length_n1086; // s10f0
    wire [7:0] setup_half_length_n1089 = setup_half_length_n1088[7:0]; // u8f0
    wire setup_half_length_n1090 = setup_half_length_n1087 ^ setup_light_length_n42; // u1f0
    wire [6:0] setup_half_length_n1091 = {setup_half_length_n1079, setup_half_length_n1090}; // u7f0
    wire [9:0] setup_half_length_n1095 = {setup_half_length_n1089, setup_half_length_n1094_s6}; // u10f0
    wire [7:0] setup_half_length_n1096 = {setup_half_length_n1091, setup_light_length_n43}; // u8f0
    wire [8:0] setup_half_length_n1097 = {setup_half_length_n1096, setup_light_length_n42}; // u9f0
    // setup.bump.length
    wire signed [16:0] setup_bump_length_n2117 = {1'b0, setup_bump_length_n2114_s6} - {2'h0, setup_bump_length_n2116_s6}; // s17f0
    wire setup_bump_length_n2118 = setup_bump_length_n2117[16]; // u1f0
    wire signed [16:0] setup_bump_length_n2119 = setup_bump_length_n2118 ? {1'b0, setup_bump_length_n2114_s6} : setup_bump_length_n2117; // s17f0
    wire [14:0] setup_bump_length_n2120 = setup_bump_length_n2119[14:0]; // u15f0
    wire setup_bump_length_n2121 = setup_bump_length_n2118 ^ setup_light_length_n42; // u1f0
    wire [13:0] setup_bump_length_n2122 = {setup_bump_length_n2110_s6, setup_bump_length_n2121}; // u14f0
    wire [16:0] setup_bump_length_n2126 = {setup_bump_length_n2120, setup_bump_length_n2125_s6}; // u17f0
    wire [14:0] setup_bump_length_n2127 = {setup_bump_length_n2122, setup_light_length_n43}; // u15f0
    wire [15:0] setup_bump_length_n2128 = {setup_bump_length_n2127, setup_light_length_n42}; // u16f0
    wire signed [17:0] setup_bump_length_n2129 = {1'b0, setup_bump_length_n2126} - {2'h0, setup_bump_length_n2128}; // s18f0
    wire setup_bump_length_n2130 = setup_bump_length_n2129[17]; // u1f0
    wire signed [17:0] setup_bump_length_n2131 = setup_bump_length_n2130 ? {1'b0, setup_bump_length_n2126} : setup_bump_length_n2129; // s18f0
    wire [15:0] setup_bump_length_n2132 = setup_bump_length_n2131[15:0]; // u16f0
    wire setup_bump_length_n2133 = setup_bump_length_n2130 ^ setup_light_length_n42; // u1f0
    wire [14:0] setup_bump_length_n2134 = {setup_bump_length_n2122, setup_bump_length_n2133}; // u15f0
    wire [17:0] setup_bump_length_n2138 = {setup_bump_length_n2132, setup_bump_length_n2137_s6}; // u18f0
    wire [15:0] setup_bump_length_n2139 = {setup_bump_length_n2134, setup_light_length_n43}; // u16f0
    wire [16:0] setup_bump_length_n2140 = {setup_bump_length_n2139, setup_light_length_n42}; // u17f0
    wire signed [18:0] setup_bump_length_n2141 = {1'b0, setup_bump_length_n2138} - {2'h0, setup_bump_length_n2140}; // s19f0
    wire setup_bump_length_n2142 = setup_bump_length_n2141[18]; // u1f0

    reg [6:0] setup_light_length_n122_s7; // u7f0
    reg [9:0] setup_light_length_n126_s7; // u10f0
    reg [8:0] setup_light_length_n128_s7; // u9f0
    reg [1:0] setup_light_length_n137_s7; // u2f0
    reg [1:0] setup_light_length_n149_s7; // u2f0
    reg [1:0] setup_light_length_n161_s7; // u2f0
    reg [1:0] setup_light_length_n173_s7; // u2f0
    reg [1:0] setup_light_length_n185_s7; // u2f0
    reg [1:0] setup_light_length_n197_s7; // u2f0
    reg [1:0] setup_light_length_n209_s7; // u2f0
    reg [1:0] setup_light_length_n221_s7; // u2f0
    reg [1:0] setup_light_length_n233_s7; // u2f0
    reg [1:0] setup_light_length_n245_s7; // u2f0
    reg [1:0] setup_light_length_n257_s7; // u2f0
    reg [1:0] setup_light_length_n269_s7; // u2f0
    reg [1:0] setup_light_length_n281_s7; // u2f0
    reg [1:0] setup_light_length_n293_s7; // u2f0
    reg [1:0] setup_light_length_n305_s7; // u2f0
    reg [1:0] setup_light_length_n317_s7; // u2f0
    reg [1:0] setup_light_length_n327_s7; // u2f0
    reg [20:0] setup_light_unit_x_n385_s7; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s7; // s25f0
    reg setup_light_unit_x_n396_s7; // u1f0
    reg setup_light_unit_x_n402_s7; // u1f0
    reg setup_light_unit_x_n555_s7; // u1f0
    reg setup_light_unit_x_n557_s7; // u1f0
    reg [20:0] setup_light_unit_y_n602_s7; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s7; // s25f0
    reg setup_light_unit_y_n617_s7; // u1f0
    reg setup_light_unit_y_n769_s7; // u1f0
    reg setup_light_unit_y_n771_s7; // u1f0
    reg [20:0] setup_light_unit_z_n816_s7; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s7; // s25f0
    reg setup_light_unit_z_n831_s7; // u1f0
    reg setup_light_unit_z_n983_s7; // u1f0
    reg setup_light_unit_z_n985_s7; // u1f0
    reg [6:0] setup_half_length_n1091_s7; // u7f0
    reg [9:0] setup_half_length_n1095_s7; // u10f0
    reg [8:0] setup_half_length_n1097_s7; // u9f0
    reg [1:0] setup_half_length_n1106_s7; // u2f0
    reg [1:0] setup_half_length_n1118_s7; // u2f0
    reg [1:0] setup_half_length_n1130_s7; // u2f0
    reg [1:0] setup_half_length_n1142_s7; // u2f0
    reg [1:0] setup_half_length_n1154_s7; // u2f0
    reg [1:0] setup_half_length_n1166_s7; // u2f0
    reg [1:0] setup_half_length_n1178_s7; // u2f0
    reg [1:0] setup_half_length_n1190_s7; // u2f0
    reg [1:0] setup_half_length_n1202_s7; // u2f0
    reg [1:0] setup_half_length_n1214_s7; // u2f0
    reg [1:0] setup_half_length_n1226_s7; // u2f0
    reg [1:0] setup_half_length_n1238_s7; // u2f0
    reg [1:0] setup_half_length_n1250_s7; // u2f0
    reg [1:0] setup_half_length_n1262_s7; // u2f0
    reg [1:0] setup_half_length_n1274_s7; // u2f0
    reg [1:0] setup_half_length_n1286_s7; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s7; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s7; // s25f0
    reg setup_half_unit_x_n1367_s7; // u1f0
    reg setup_half_unit_x_n1520_s7; // u1f0
    reg setup_half_unit_x_n1522_s7; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s7; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s7; // s25f0
    reg setup_half_unit_y_n1582_s7; // u1f0
    reg setup_half_unit_y_n1734_s7; // u1f0
    reg setup_half_unit_y_n1736_s7; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s7; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s7; // s25f0
    reg setup_half_unit_z_n1796_s7; // u1f0
    reg setup_half_unit_z_n1948_s7; // u1f0
    reg setup_half_unit_z_n1950_s7; // u1f0
    reg [14:0] setup_bump_length_n2134_s7; // u15f0
    reg [17:0] setup_bump_length_n2138_s7; // u18f0
    reg signed [18:0] setup_bump_length_n2141_s7; // s19f0
    reg setup_bump_length_n2142_s7; // u1f0
    reg [1:0] setup_bump_length_n2149_s7; // u2f0
    reg [1:0] setup_bump_length_n2161_s7; // u2f0
    reg [1:0] setup_bump_length_n2173_s7; // u2f0
    reg [17:0] setup_bump_unit_x_n2251_s7; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s7; // s25f0
    reg setup_bump_unit_x_n2417_s7; // u1f0
    reg setup_bump_unit_x_n2419_s7; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s7; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s7; // s25f0
    reg setup_bump_unit_y_n2623_s7; // u1f0
    reg setup_bump_unit_y_n2625_s7; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s7; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s7; // s25f0
    reg setup_bump_unit_z_n2829_s7; // u1f0
    reg setup_bump_unit_z_n2831_s7; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n122_s7 <= setup_light_length_n122;
            setup_light_length_n126_s7 <= setup_light_length_n126;
            setup_light_length_n128_s7 <= setup_light_length_n128;
            setup_light_length_n137_s7 <= setup_light_length_n137_s6;
            setup_light_length_n149_s7 <= setup_light_length_n149_s6;
            setup_light_length_n161_s7 <= setup_light_length_n161_s6;
            setup_light_length_n173_s7 <= setup_light_length_n173_s6;
            setup_light_length_n185_s7 <= setup_light_length_n185_s6;
            setup_light_length_n197_s7 <= setup_light_length_n197_s6;
            setup_light_length_n209_s7 <= setup_light_length_n209_s6;
            setup_light_length_n221_s7 <= setup_light_length_n221_s6;
            setup_light_length_n233_s7 <= setup_light_length_n233_s6;
            setup_light_length_n245_s7 <= setup_light_length_n245_s6;
            setup_light_length_n257_s7 <= setup_light_length_n257_s6;
            setup_light_length_n269_s7 <= setup_light_length_n269_s6;
            setup_light_length_n281_s7 <= setup_light_length_n281_s6;
            setup_light_length_n293_s7 <= setup_light_length_n293_s6;
            setup_light_length_n305_s7 <= setup_light_length_n305_s6;
            setup_light_length_n317_s7 <= setup_light_length_n317_s6;
            setup_light_length_n327_s7 <= setup_light_length_n327_s6;
            setup_light_unit_x_n385_s7 <= setup_light_unit_x_n385_s6;
            setup_light_unit_x_n395_s7 <= setup_light_unit_x_n395_s6;
            setup_light_unit_x_n396_s7 <= setup_light_unit_x_n396_s6;
            setup_light_unit_x_n402_s7 <= setup_light_unit_x_n402_s6;
            setup_light_unit_x_n555_s7 <= setup_light_unit_x_n555_s6;
            setup_light_unit_x_n557_s7 <= setup_light_unit_x_n557_s6;
            setup_light_unit_y_n602_s7 <= setup_light_unit_y_n602_s6;
            setup_light_unit_y_n611_s7 <= setup_light_unit_y_n611_s6;
            setup_light_unit_y_n617_s7 <= setup_light_unit_y_n617_s6;
            setup_light_unit_y_n769_s7 <= setup_light_unit_y_n769_s6;
            setup_light_unit_y_n771_s7 <= setup_light_unit_y_n771_s6;
            setup_light_unit_z_n816_s7 <= setup_light_unit_z_n816_s6;
            setup_light_unit_z_n825_s7 <= setup_light_unit_z_n825_s6;
            setup_light_unit_z_n831_s7 <= setup_light_unit_z_n831_s6;
            setup_light_unit_z_n983_s7 <= setup_light_unit_z_n983_s6;
            setup_light_unit_z_n985_s7 <= setup_light_unit_z_n985_s6;
            setup_half_length_n1091_s7 <= setup_half_length_n1091;
            setup_half_length_n1095_s7 <= setup_half_length_n1095;
            setup_half_length_n1097_s7 <= setup_half_length_n1097;
            setup_half_length_n1106_s7 <= setup_half_length_n1106_s6;
            setup_half_length_n1118_s7 <= setup_half_length_n1118_s6;
            setup_half_length_n1130_s7 <= setup_half_length_n1130_s6;
            setup_half_length_n1142_s7 <= setup_half_length_n1142_s6;
            setup_half_length_n1154_s7 <= setup_half_length_n1154_s6;
            setup_half_length_n1166_s7 <= setup_half_length_n1166_s6;
            setup_half_length_n1178_s7 <= setup_half_length_n1178_s6;
            setup_half_length_n1190_s7 <= setup_half_length_n1190_s6;
            setup_half_length_n1202_s7 <= setup_half_length_n1202_s6;
            setup_half_length_n1214_s7 <= setup_half_length_n1214_s6;
            setup_half_length_n1226_s7 <= setup_half_length_n1226_s6;
            setup_half_length_n1238_s7 <= setup_half_length_n1238_s6;
            setup_half_length_n1250_s7 <= setup_half_length_n1250_s6;
            setup_half_length_n1262_s7 <= setup_half_length_n1262_s6;
            setup_half_length_n1274_s7 <= setup_half_length_n1274_s6;
            setup_half_length_n1286_s7 <= setup_half_length_n1286_s6;
            setup_half_unit_x_n1352_s7 <= setup_half_unit_x_n1352_s6;
            setup_half_unit_x_n1361_s7 <= setup_half_unit_x_n1361_s6;
            setup_half_unit_x_n1367_s7 <= setup_half_unit_x_n1367_s6;
            setup_half_unit_x_n1520_s7 <= setup_half_unit_x_n1520_s6;
            setup_half_unit_x_n1522_s7 <= setup_half_unit_x_n1522_s6;
            setup_half_unit_y_n1567_s7 <= setup_half_unit_y_n1567_s6;
            setup_half_unit_y_n1576_s7 <= setup_half_unit_y_n1576_s6;
            setup_half_unit_y_n1582_s7 <= setup_half_unit_y_n1582_s6;
            setup_half_unit_y_n1734_s7 <= setup_half_unit_y_n1734_s6;
            setup_half_unit_y_n1736_s7 <= setup_half_unit_y_n1736_s6;
            setup_half_unit_z_n1781_s7 <= setup_half_unit_z_n1781_s6;
            setup_half_unit_z_n1790_s7 <= setup_half_unit_z_n1790_s6;
            setup_half_unit_z_n1796_s7 <= setup_half_unit_z_n1796_s6;
            setup_half_unit_z_n1948_s7 <= setup_half_unit_z_n1948_s6;
            setup_half_unit_z_n1950_s7 <= setup_half_unit_z_n1950_s6;
            setup_bump_length_n2134_s7 <= setup_bump_length_n2134;
            setup_bump_length_n2138_s7 <= setup_bump_length_n2138;
            setup_bump_length_n2141_s7 <= setup_bump_length_n2141;
            setup_bump_length_n2142_s7 <= setup_bump_length_n2142;
            setup_bump_length_n2149_s7 <= setup_bump_length_n2149_s6;
            setup_bump_length_n2161_s7 <= setup_bump_length_n2161_s6;
            setup_bump_length_n2173_s7 <= setup_bump_length_n2173_s6;
            setup_bump_unit_x_n2251_s7 <= setup_bump_unit_x_n2251_s6;
            setup_bump_unit_x_n2259_s7 <= setup_bump_unit_x_n2259_s6;
            setup_bump_unit_x_n2417_s7 <= setup_bump_unit_x_n2417_s6;
            setup_bump_unit_x_n2419_s7 <= setup_bump_unit_x_n2419_s6;
            setup_bump_unit_y_n2458_s7 <= setup_bump_unit_y_n2458_s6;
            setup_bump_unit_y_n2466_s7 <= setup_bump_unit_y_n2466_s6;
            setup_bump_unit_y_n2623_s7 <= setup_bump_unit_y_n2623_s6;
            setup_bump_unit_y_n2625_s7 <= setup_bump_unit_y_n2625_s6;
            setup_bump_unit_z_n2664_s7 <= setup_bump_unit_z_n2664_s6;
            setup_bump_unit_z_n2672_s7 <= setup_bump_unit_z_n2672_s6;
            setup_bump_unit_z_n2829_s7 <= setup_bump_unit_z_n2829_s6;
            setup_bump_unit_z_n2831_s7 <= setup_bump_unit_z_n2831_s6;
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // setup.light.length
    wire signed [10:0] setup_light_length_n129 = {1'b0, setup_light_length_n126_s7} - {2'h0, setup_light_length_n128_s7}; // s11f0
    wire setup_light_length_n130 = setup_light_length_n129[10]; // u1f0
    wire signed [10:0] setup_light_length_n131 = setup_light_length_n130 ? {1'b0, setup_light_length_n126_s7} : setup_light_length_n129; // s11f0
    wire [8:0] setup_light_length_n132 = setup_light_length_n131[8:0]; // u9f0
    wire setup_light_length_n133 = setup_light_length_n130 ^ setup_light_length_n42; // u1f0
    wire [7:0] setup_light_length_n134 = {setup_light_length_n122_s7, setup_light_length_n133}; // u8f0
    wire [10:0] setup_light_length_n138 = {setup_light_length_n132, setup_light_length_n137_s7}; // u11f0
    wire [8:0] setup_light_length_n139 = {setup_light_length_n134, setup_light_length_n43}; // u9f0
    wire [9:0] setup_light_length_n140 = {setup_light_length_n139, setup_light_length_n42}; // u10f0
    wire signed [11:0] setup_light_length_n141 = {1'b0, setup_light_length_n138} - {2'h0, setup_light_length_n140}; // s12f0
    wire setup_light_length_n142 = setup_light_length_n141[11]; // u1f0
    wire signed [11:0] setup_light_length_n143 = setup_light_length_n142 ? {1'b0, setup_light_length_n138} : setup_light_length_n141; // s12f0
    wire [9:0] setup_light_length_n144 = setup_light_length_n143[9:0]; // u10f0
    wire setup_light_length_n145 = setup_light_length_n142 ^ setup_light_length_n42; // u1f0
    wire [8:0] setup_light_length_n146 = {setup_light_length_n134, setup_light_length_n145}; // u9f0
    wire [11:0] setup_light_length_n150 = {setup_light_length_n144, setup_light_length_n149_s7}; // u12f0
    wire [9:0] setup_light_length_n151 = {setup_light_length_n146, setup_light_length_n43}; // u10f0
    wire [10:0] setup_light_length_n152 = {setup_light_length_n151, setup_light_length_n42}; // u11f0
    wire signed [12:0] setup_light_length_n153 = {1'b0, setup_light_length_n150} - {2'h0, setup_light_length_n152}; // s13f0
    wire setup_light_length_n154 = setup_light_length_n153[12]; // u1f0
    wire signed [12:0] setup_light_length_n155 = setup_light_length_n154 ? {1'b0, setup_light_length_n150} : setup_light_length_n153; // s13f0
    wire [10:0] setup_light_length_n156 = setup_light_length_n155[10:0]; // u11f0
    wire setup_light_length_n157 = setup_light_length_n154 ^ setup_light_length_n42; // u1f0
    wire [9:0] setup_light_length_n158 = {setup_light_length_n146, setup_light_length_n157}; // u10f0
    wire [12:0] setup_light_length_n162 = {setup_light_length_n156, setup_light_length_n161_s7}; // u13f0
    wire [10:0] setup_light_length_n163 = {setup_light_length_n158, setup_light_length_n43}; // u11f0
    wire [11:0] setup_light_length_n164 = {setup_light_length_n163, setup_light_length_n42}; // u12f0
    // setup.half.length
    wire signed [10:0] setup_half_length_n1098 = {1'b0, setup_half_length_n1095_s7} - {2'h0, setup_half_length_n1097_s7}; // s11f0
    wire setup_half_length_n1099 = setup_half_length_n1098[10]; // u1f0
    wire signed [10:0] setup_half_length_n1100 = setup_half_length_n1099 ? {1'b0, setup_half_length_n1095_s7} : setup_half_length_n1098; // s11f0
    wire [8:0] setup_half_length_n1101 = setup_half_length_n1100[8:0]; // u9f0
    wire setup_half_length_n1102 = setup_half_length_n1099 ^ setup_light_length_n42; // u1f0
    wire [7:0] setup_half_length_n1103 = {setup_half_length_n1091_s7, setup_half_length_n1102}; // u8f0
    wire [10:0] setup_half_length_n1107 = {setup_half_length_n1101, setup_half_length_n1106_s7}; // u11f0
    wire [8:0] setup_half_length_n1108 = {setup_half_length_n1103, setup_light_length_n43}; // u9f0
    wire [9:0] setup_half_length_n1109 = {setup_half_length_n1108, setup_light_length_n42}; // u10f0
    wire signed [11:0] setup_half_length_n1110 = {1'b0, setup_half_length_n1107} - {2'h0, setup_half_length_n1109}; // s12f0
    wire setup_half_length_n1111 = setup_half_length_n1110[11]; // u1f0
    wire signed [11:0] setup_half_length_n1112 = setup_half_length_n1111 ? {1'b0, setup_half_length_n1107} : setup_half_length_n1110; // s12f0
    wire [9:0] setup_half_length_n1113 = setup_half_length_n1112[9:0]; // u10f0
    wire setup_half_length_n1114 = setup_half_length_n1111 ^ setup_light_length_n42; // u1f0
    wire [8:0] setup_half_length_n1115 = {setup_half_length_n1103, setup_half_length_n1114}; // u9f0
    wire [11:0] setup_half_length_n1119 = {setup_half_length_n1113, setup_half_length_n1118_s7}; // u12f0
    wire [9:0] setup_half_length_n1120 = {setup_half_length_n1115, setup_light_length_n43}; // u10f0
    wire [10:0] setup_half_length_n1121 = {setup_half_length_n1120, setup_light_length_n42}; // u11f0
    wire signed [12:0] setup_half_length_n1122 = {1'b0, setup_half_length_n1119} - {2'h0, setup_half_length_n1121}; // s13f0
    wire setup_half_length_n1123 = setup_half_length_n1122[12]; // u1f0
    wire signed [12:0] setup_half_length_n1124 = setup_half_length_n1123 ? {1'b0, setup_half_length_n1119} : setup_half_length_n1122; // s13f0
    wire [10:0] setup_half_length_n1125 = setup_half_length_n1124[10:0]; // u11f0
    wire setup_half_length_n1126 = setup_half_length_n1123 ^ setup_light_length_n42; // u1f0
    wire [9:0] setup_half_length_n1127 = {setup_half_length_n1115, setup_half_length_n1126}; // u10f0
    wire [12:0] setup_half_length_n1131 = {setup_half_length_n1125, setup_half_length_n1130_s7}; // u13f0
    wire [10:0] setup_half_length_n1132 = {setup_half_length_n1127, setup_light_length_n43}; // u11f0
    wire [11:0] setup_half_length_n1133 = {setup_half_length_n1132, setup_light_length_n42}; // u12f0
    // setup.bump.length
    wire signed [18:0] setup_bump_length_n2143 = setup_bump_length_n2142_s7 ? {1'b0, setup_bump_length_n2138_s7} : setup_bump_length_n2141_s7; // s19f0
    wire [16:0] setup_bump_length_n2144 = setup_bump_length_n2143[16:0]; // u17f0
    wire setup_bump_length_n2145 = setup_bump_length_n2142_s7 ^ setup_light_length_n42; // u1f0
    wire [15:0] setup_bump_length_n2146 = {setup_bump_length_n2134_s7, setup_bump_length_n2145}; // u16f0
    wire [18:0] setup_bump_length_n2150 = {setup_bump_length_n2144, setup_bump_length_n2149_s7}; // u19f0
    wire [16:0] setup_bump_length_n2151 = {setup_bump_length_n2146, setup_light_length_n43}; // u17f0
    wire [17:0] setup_bump_length_n2152 = {setup_bump_length_n2151, setup_light_length_n42}; // u18f0
    wire signed [19:0] setup_bump_length_n2153 = {1'b0, setup_bump_length_n2150} - {2'h0, setup_bump_length_n2152}; // s20f0
    wire setup_bump_length_n2154 = setup_bump_length_n2153[19]; // u1f0
    wire signed [19:0] setup_bump_length_n2155 = setup_bump_length_n2154 ? {1'b0, setup_bump_length_n2150} : setup_bump_length_n2153; // s20f0
    wire [17:0] setup_bump_length_n2156 = setup_bump_length_n2155[17:0]; // u18f0
    wire setup_bump_length_n2157 = setup_bump_length_n2154 ^ setup_light_length_n42; // u1f0
    wire [16:0] setup_bump_length_n2158 = {setup_bump_length_n2146, setup_bump_length_n2157}; // u17f0
    wire [19:0] setup_bump_length_n2162 = {setup_bump_length_n2156, setup_bump_length_n2161_s7}; // u20f0
    wire [17:0] setup_bump_length_n2163 = {setup_bump_length_n2158, setup_light_length_n43}; // u18f0
    wire [18:0] setup_bump_length_n2164 = {setup_bump_length_n2163, setup_light_length_n42}; // u19f0
    wire signed [20:0] setup_bump_length_n2165 = {1'b0, setup_bump_length_n2162} - {2'h0, setup_bump_length_n2164}; // s21f0
    wire setup_bump_length_n2166 = setup_bump_length_n2165[20]; // u1f0
    wire signed [20:0] setup_bump_length_n2167 = setup_bump_length_n2166 ? {1'b0, setup_bump_length_n2162} : setup_bump_length_n2165; // s21f0
    wire [18:0] setup_bump_length_n2168 = setup_bump_length_n2167[18:0]; // u19f0
    wire setup_bump_length_n2169 = setup_bump_length_n2166 ^ setup_light_length_n42; // u1f0
    wire [17:0] setup_bump_length_n2170 = {setup_bump_length_n2158, setup_bump_length_n2169}; // u18f0
    wire [20:0] setup_bump_length_n2174 = {setup_bump_length_n2168, setup_bump_length_n2173_s7}; // u21f0
    wire [18:0] setup_bump_length_n2175 = {setup_bump_length_n2170, setup_light_length_n43}; // u19f0
    wire [19:0] setup_bump_length_n2176 = {setup_bump_length_n2175, setup_light_length_n42}; // u20f0

    reg [9:0] setup_light_length_n158_s8; // u10f0
    reg [12:0] setup_light_length_n162_s8; // u13f0
    reg [11:0] setup_light_length_n164_s8; // u12f0
    reg [1:0] setup_light_length_n173_s8; // u2f0
    reg [1:0] setup_light_length_n185_s8; // u2f0
    reg [1:0] setup_light_length_n197_s8; // u2f0
    reg [1:0] setup_light_length_n209_s8; // u2f0
    reg [1:0] setup_light_length_n221_s8; // u2f0
    reg [1:0] setup_light_length_n233_s8; // u2f0
    reg [1:0] setup_light_length_n245_s8; // u2f0
    reg [1:0] setup_light_length_n257_s8; // u2f0
    reg [1:0] setup_light_length_n269_s8; // u2f0
    reg [1:0] setup_light_length_n281_s8; // u2f0
    reg [1:0] setup_light_length_n293_s8; // u2f0
    reg [1:0] setup_light_length_n305_s8; // u2f0
    reg [1:0] setup_light_length_n317_s8; // u2f0
    reg [1:0] setup_light_length_n327_s8; // u2f0
    reg [20:0] setup_light_unit_x_n385_s8; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s8; // s25f0
    reg setup_light_unit_x_n396_s8; // u1f0
    reg setup_light_unit_x_n402_s8; // u1f0
    reg setup_light_unit_x_n555_s8; // u1f0
    reg setup_light_unit_x_n557_s8; // u1f0
    reg [20:0] setup_light_unit_y_n602_s8; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s8; // s25f0
    reg setup_light_unit_y_n617_s8; // u1f0
    reg setup_light_unit_y_n769_s8; // u1f0
    reg setup_light_unit_y_n771_s8; // u1f0
    reg [20:0] setup_light_unit_z_n816_s8; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s8; // s25f0
    reg setup_light_unit_z_n831_s8; // u1f0
    reg setup_light_unit_z_n983_s8; // u1f0
    reg setup_light_unit_z_n985_s8; // u1f0
    reg [9:0] setup_half_length_n1127_s8; // u10f0
    reg [12:0] setup_half_length_n1131_s8; // u13f0
    reg [11:0] setup_half_length_n1133_s8; // u12f0
    reg [1:0] setup_half_length_n1142_s8; // u2f0
    reg [1:0] setup_half_length_n1154_s8; // u2f0
    reg [1:0] setup_half_length_n1166_s8; // u2f0
    reg [1:0] setup_half_length_n1178_s8; // u2f0
    reg [1:0] setup_half_length_n1190_s8; // u2f0
    reg [1:0] setup_half_length_n1202_s8; // u2f0
    reg [1:0] setup_half_length_n1214_s8; // u2f0
    reg [1:0] setup_half_length_n1226_s8; // u2f0
    reg [1:0] setup_half_length_n1238_s8; // u2f0
    reg [1:0] setup_half_length_n1250_s8; // u2f0
    reg [1:0] setup_half_length_n1262_s8; // u2f0
    reg [1:0] setup_half_length_n1274_s8; // u2f0
    reg [1:0] setup_half_length_n1286_s8; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s8; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s8; // s25f0
    reg setup_half_unit_x_n1367_s8; // u1f0
    reg setup_half_unit_x_n1520_s8; // u1f0
    reg setup_half_unit_x_n1522_s8; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s8; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s8; // s25f0
    reg setup_half_unit_y_n1582_s8; // u1f0
    reg setup_half_unit_y_n1734_s8; // u1f0
    reg setup_half_unit_y_n1736_s8; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s8; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s8; // s25f0
    reg setup_half_unit_z_n1796_s8; // u1f0
    reg setup_half_unit_z_n1948_s8; // u1f0
    reg setup_half_unit_z_n1950_s8; // u1f0
    reg [17:0] setup_bump_length_n2170_s8; // u18f0
    reg [20:0] setup_bump_length_n2174_s8; // u21f0
    reg [19:0] setup_bump_length_n2176_s8; // u20f0
    reg [17:0] setup_bump_unit_x_n2251_s8; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s8; // s25f0
    reg setup_bump_unit_x_n2417_s8; // u1f0
    reg setup_bump_unit_x_n2419_s8; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s8; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s8; // s25f0
    reg setup_bump_unit_y_n2623_s8; // u1f0
    reg setup_bump_unit_y_n2625_s8; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s8; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s8; // s25f0
    reg setup_bump_unit_z_n2829_s8; // u1f0
    reg setup_bump_unit_z_n2831_s8; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n158_s8 <= setup_light_length_n158;
            setup_light_length_n162_s8 <= setup_light_length_n162;
            setup_light_length_n164_s8 <= setup_light_length_n164;
            setup_light_length_n173_s8 <= setup_light_length_n173_s7;
            setup_light_length_n185_s8 <= setup_light_length_n185_s7;
            setup_light_length_n197_s8 <= setup_light_length_n197_s7;
            setup_light_length_n209_s8 <= setup_light_length_n209_s7;
            setup_light_length_n221_s8 <= setup_light_length_n221_s7;
            setup_light_length_n233_s8 <= setup_light_length_n233_s7;
            setup_light_length_n245_s8 <= setup_light_length_n245_s7;
            setup_light_length_n257_s8 <= setup_light_length_n257_s7;
            setup_light_length_n269_s8 <= setup_light_length_n269_s7;
            setup_light_length_n281_s8 <= setup_light_length_n281_s7;
            setup_light_length_n293_s8 <= setup_light_length_n293_s7;
            setup_light_length_n305_s8 <= setup_light_length_n305_s7;
            setup_light_length_n317_s8 <= setup_light_length_n317_s7;
            setup_light_length_n327_s8 <= setup_light_length_n327_s7;
            setup_light_unit_x_n385_s8 <= setup_light_unit_x_n385_s7;
            setup_light_unit_x_n395_s8 <= setup_light_unit_x_n395_s7;
            setup_light_unit_x_n396_s8 <= setup_light_unit_x_n396_s7;
            setup_light_unit_x_n402_s8 <= setup_light_unit_x_n402_s7;
            setup_light_unit_x_n555_s8 <= setup_light_unit_x_n555_s7;
            setup_light_unit_x_n557_s8 <= setup_light_unit_x_n557_s7;
            setup_light_unit_y_n602_s8 <= setup_light_unit_y_n602_s7;
            setup_light_unit_y_n611_s8 <= setup_light_unit_y_n611_s7;
            setup_light_unit_y_n617_s8 <= setup_light_unit_y_n617_s7;
            setup_light_unit_y_n769_s8 <= setup_light_unit_y_n769_s7;
            setup_light_unit_y_n771_s8 <= setup_light_unit_y_n771_s7;
            setup_light_unit_z_n816_s8 <= setup_light_unit_z_n816_s7;
            setup_light_unit_z_n825_s8 <= setup_light_unit_z_n825_s7;
            setup_light_unit_z_n831_s8 <= setup_light_unit_z_n831_s7;
            setup_light_unit_z_n983_s8 <= setup_light_unit_z_n983_s7;
            setup_light_unit_z_n985_s8 <= setup_light_unit_z_n985_s7;
            setup_half_length_n1127_s8 <= setup_half_length_n1127;
            setup_half_length_n1131_s8 <= setup_half_length_n1131;
            setup_half_length_n1133_s8 <= setup_half_length_n1133;
            setup_half_length_n1142_s8 <= setup_half_length_n1142_s7;
            setup_half_length_n1154_s8 <= setup_half_length_n1154_s7;
            setup_half_length_n1166_s8 <= setup_half_length_n1166_s7;
            setup_half_length_n1178_s8 <= setup_half_length_n1178_s7;
            setup_half_length_n1190_s8 <= setup_half_length_n1190_s7;
            setup_half_length_n1202_s8 <= setup_half_length_n1202_s7;
            setup_half_length_n1214_s8 <= setup_half_length_n1214_s7;
            setup_half_length_n1226_s8 <= setup_half_length_n1226_s7;
            setup_half_length_n1238_s8 <= setup_half_length_n1238_s7;
            setup_half_length_n1250_s8 <= setup_half_length_n1250_s7;
            setup_half_length_n1262_s8 <= setup_half_length_n1262_s7;
            setup_half_length_n1274_s8 <= setup_half_length_n1274_s7;
            setup_half_length_n1286_s8 <= setup_half_length_n1286_s7;
            setup_half_unit_x_n1352_s8 <= setup_half_unit_x_n1352_s7;
            setup_half_unit_x_n1361_s8 <= setup_half_unit_x_n1361_s7;
            setup_half_unit_x_n1367_s8 <= setup_half_unit_x_n1367_s7;
            setup_half_unit_x_n1520_s8 <= setup_half_unit_x_n1520_s7;
            setup_half_unit_x_n1522_s8 <= setup_half_unit_x_n1522_s7;
            setup_half_unit_y_n1567_s8 <= setup_half_unit_y_n1567_s7;
            setup_half_unit_y_n1576_s8 <= setup_half_unit_y_n1576_s7;
            setup_half_unit_y_n1582_s8 <= setup_half_unit_y_n1582_s7;
            setup_half_unit_y_n1734_s8 <= setup_half_unit_y_n1734_s7;
            setup_half_unit_y_n1736_s8 <= setup_half_unit_y_n1736_s7;
            setup_half_unit_z_n1781_s8 <= setup_half_unit_z_n1781_s7;
            setup_half_unit_z_n1790_s8 <= setup_half_unit_z_n1790_s7;
            setup_half_unit_z_n1796_s8 <= setup_half_unit_z_n1796_s7;
            setup_half_unit_z_n1948_s8 <= setup_half_unit_z_n1948_s7;
            setup_half_unit_z_n1950_s8 <= setup_half_unit_z_n1950_s7;
            setup_bump_length_n2170_s8 <= setup_bump_length_n2170;
            setup_bump_length_n2174_s8 <= setup_bump_length_n2174;
            setup_bump_length_n2176_s8 <= setup_bump_length_n2176;
            setup_bump_unit_x_n2251_s8 <= setup_bump_unit_x_n2251_s7;
            setup_bump_unit_x_n2259_s8 <= setup_bump_unit_x_n2259_s7;
            setup_bump_unit_x_n2417_s8 <= setup_bump_unit_x_n2417_s7;
            setup_bump_unit_x_n2419_s8 <= setup_bump_unit_x_n2419_s7;
            setup_bump_unit_y_n2458_s8 <= setup_bump_unit_y_n2458_s7;
            setup_bump_unit_y_n2466_s8 <= setup_bump_unit_y_n2466_s7;
            setup_bump_unit_y_n2623_s8 <= setup_bump_unit_y_n2623_s7;
            setup_bump_unit_y_n2625_s8 <= setup_bump_unit_y_n2625_s7;
            setup_bump_unit_z_n2664_s8 <= setup_bump_unit_z_n2664_s7;
            setup_bump_unit_z_n2672_s8 <= setup_bump_unit_z_n2672_s7;
            setup_bump_unit_z_n2829_s8 <= setup_bump_unit_z_n2829_s7;
            setup_bump_unit_z_n2831_s8 <= setup_bump_unit_z_n2831_s7;
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // setup.light.length
    wire signed [13:0] setup_light_length_n165 = {1'b0, setup_light_length_n162_s8} - {2'h0, setup_light_length_n164_s8}; // s14f0
    wire setup_light_length_n166 = setup_light_length_n165[13]; // u1f0
    wire signed [13:0] setup_light_length_n167 = setup_light_length_n166 ? {1'b0, setup_light_length_n162_s8} : setup_light_length_n165; // s14f0
    wire [11:0] setup_light_length_n168 = setup_light_length_n167[11:0]; // u12f0
    wire setup_light_length_n169 = setup_light_length_n166 ^ setup_light_length_n42; // u1f0
    wire [10:0] setup_light_length_n170 = {setup_light_length_n158_s8, setup_light_length_n169}; // u11f0
    wire [13:0] setup_light_length_n174 = {setup_light_length_n168, setup_light_length_n173_s8}; // u14f0
    wire [11:0] setup_light_length_n175 = {setup_light_length_n170, setup_light_length_n43}; // u12f0
    wire [12:0] setup_light_length_n176 = {setup_light_length_n175, setup_light_length_n42}; // u13f0
    wire signed [14:0] setup_light_length_n177 = {1'b0, setup_light_length_n174} - {2'h0, setup_light_length_n176}; // s15f0
    wire setup_light_length_n178 = setup_light_length_n177[14]; // u1f0
    wire signed [14:0] setup_light_length_n179 = setup_light_length_n178 ? {1'b0, setup_light_length_n174} : setup_light_length_n177; // s15f0
    wire [12:0] setup_light_length_n180 = setup_light_length_n179[12:0]; // u13f0
    wire setup_light_length_n181 = setup_light_length_n178 ^ setup_light_length_n42; // u1f0
    wire [11:0] setup_light_length_n182 = {setup_light_length_n170, setup_light_length_n181}; // u12f0
    wire [14:0] setup_light_length_n186 = {setup_light_length_n180, setup_light_length_n185_s8}; // u15f0
    wire [12:0] setup_light_length_n187 = {setup_light_length_n182, setup_light_length_n43}; // u13f0
    wire [13:0] setup_light_length_n188 = {setup_light_length_n187, setup_light_length_n42}; // u14f0
    wire signed [15:0] setup_light_length_n189 = {1'b0, setup_light_length_n186} - {2'h0, setup_light_length_n188}; // s16f0
    wire setup_light_length_n190 = setup_light_length_n189[15]; // u1f0
    wire signed [15:0] setup_light_length_n191 = setup_light_length_n190 ? {1'b0, setup_light_length_n186} : setup_light_length_n189; // s16f0
    wire [13:0] setup_light_length_n192 = setup_light_length_n191[13:0]; // u14f0
    wire setup_light_length_n193 = setup_light_length_n190 ^ setup_light_length_n42; // u1f0
    wire [12:0] setup_light_length_n194 = {setup_light_length_n182, setup_light_length_n193}; // u13f0
    wire [15:0] setup_light_length_n198 = {setup_light_length_n192, setup_light_length_n197_s8}; // u16f0
    wire [13:0] setup_light_length_n199 = {setup_light_length_n194, setup_light_length_n43}; // u14f0
    wire [14:0] setup_light_length_n200 = {setup_light_length_n199, setup_light_length_n42}; // u15f0
    // setup.half.length
    wire signed [13:0] setup_half_length_n1134 = {1'b0, setup_half_length_n1131_s8} - {2'h0, setup_half_length_n1133_s8}; // s14f0
    wire setup_half_length_n1135 = setup_half_length_n1134[13]; // u1f0
    wire signed [13:0] setup_half_length_n1136 = setup_half_length_n1135 ? {1'b0, setup_half_length_n1131_s8} : setup_half_length_n1134; // s14f0
    wire [11:0] setup_half_length_n1137 = setup_half_length_n1136[11:0]; // u12f0
    wire setup_half_length_n1138 = setup_half_length_n1135 ^ setup_light_length_n42; // u1f0
    wire [10:0] setup_half_length_n1139 = {setup_half_length_n1127_s8, setup_half_length_n1138}; // u11f0
    wire [13:0] setup_half_length_n1143 = {setup_half_length_n1137, setup_half_length_n1142_s8}; // u14f0
    wire [11:0] setup_half_length_n1144 = {setup_half_length_n1139, setup_light_length_n43}; // u12f0
    wire [12:0] setup_half_length_n1145 = {setup_half_length_n1144, setup_light_length_n42}; // u13f0
    wire signed [14:0] setup_half_length_n1146 = {1'b0, setup_half_length_n1143} - {2'h0, setup_half_length_n1145}; // s15f0
    wire setup_half_length_n1147 = setup_half_length_n1146[14]; // u1f0
    wire signed [14:0] setup_half_length_n1148 = setup_half_length_n1147 ? {1'b0, setup_half_length_n1143} : setup_half_length_n1146; // s15f0
    wire [12:0] setup_half_length_n1149 = setup_half_length_n1148[12:0]; // u13f0
    wire setup_half_length_n1150 = setup_half_length_n1147 ^ setup_light_length_n42; // u1f0
    wire [11:0] setup_half_length_n1151 = {setup_half_length_n1139, setup_half_length_n1150}; // u12f0
    wire [14:0] setup_half_length_n1155 = {setup_half_length_n1149, setup_half_length_n1154_s8}; // u15f0
    wire [12:0] setup_half_length_n1156 = {setup_half_length_n1151, setup_light_length_n43}; // u13f0
    wire [13:0] setup_half_length_n1157 = {setup_half_length_n1156, setup_light_length_n42}; // u14f0
    wire signed [15:0] setup_half_length_n1158 = {1'b0, setup_half_length_n1155} - {2'h0, setup_half_length_n1157}; // s16f0
    wire setup_half_length_n1159 = setup_half_length_n1158[15]; // u1f0
    wire signed [15:0] setup_half_length_n1160 = setup_half_length_n1159 ? {1'b0, setup_half_length_n1155} : setup_half_length_n1158; // s16f0
    wire [13:0] setup_half_length_n1161 = setup_half_length_n1160[13:0]; // u14f0
    wire setup_half_length_n1162 = setup_half_length_n1159 ^ setup_light_length_n42; // u1f0
    wire [12:0] setup_half_length_n1163 = {setup_half_length_n1151, setup_half_length_n1162}; // u13f0
    wire [15:0] setup_half_length_n1167 = {setup_half_length_n1161, setup_half_length_n1166_s8}; // u16f0
    wire [13:0] setup_half_length_n1168 = {setup_half_length_n1163, setup_light_length_n43}; // u14f0
    wire [14:0] setup_half_length_n1169 = {setup_half_length_n1168, setup_light_length_n42}; // u15f0
    // setup.bump.length
    wire signed [21:0] setup_bump_length_n2177 = {1'b0, setup_bump_length_n2174_s8} - {2'h0, setup_bump_length_n2176_s8}; // s22f0
    wire setup_bump_length_n2178 = setup_bump_length_n2177[21]; // u1f0
    wire signed [21:0] setup_bump_length_n2179 = setup_bump_length_n2178 ? {1'b0, setup_bump_length_n2174_s8} : setup_bump_length_n2177; // s22f0
    wire [19:0] setup_bump_length_n2180 = setup_bump_length_n2179[19:0]; // u20f0
    wire setup_bump_length_n2181 = setup_bump_length_n2178 ^ setup_light_length_n42; // u1f0
    wire [18:0] setup_bump_length_n2182 = {setup_bump_length_n2170_s8, setup_bump_length_n2181}; // u19f0
    wire [21:0] setup_bump_length_n2183 = {setup_bump_length_n2180, setup_light_length_n327_s8}; // u22f0
    wire [19:0] setup_bump_length_n2184 = {setup_bump_length_n2182, setup_light_length_n43}; // u20f0
    wire [20:0] setup_bump_length_n2185 = {setup_bump_length_n2184, setup_light_length_n42}; // u21f0
    wire signed [22:0] setup_bump_length_n2186 = {1'b0, setup_bump_length_n2183} - {2'h0, setup_bump_length_n2185}; // s23f0
    wire setup_bump_length_n2187 = setup_bump_length_n2186[22]; // u1f0
    wire signed [22:0] setup_bump_length_n2188 = setup_bump_length_n2187 ? {1'b0, setup_bump_length_n2183} : setup_bump_length_n2186; // s23f0
    wire [20:0] setup_bump_length_n2189 = setup_bump_length_n2188[20:0]; // u21f0
    wire setup_bump_length_n2190 = setup_bump_length_n2187 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_bump_length_n2191 = {setup_bump_length_n2182, setup_bump_length_n2190}; // u20f0
    wire [22:0] setup_bump_length_n2192 = {setup_bump_length_n2189, setup_light_length_n327_s8}; // u23f0
    wire [20:0] setup_bump_length_n2193 = {setup_bump_length_n2191, setup_light_length_n43}; // u21f0
    wire [21:0] setup_bump_length_n2194 = {setup_bump_length_n2193, setup_light_length_n42}; // u22f0

    reg [12:0] setup_light_length_n194_s9; // u13f0
    reg [15:0] setup_light_length_n198_s9; // u16f0
    reg [14:0] setup_light_length_n200_s9; // u15f0
    reg [1:0] setup_light_length_n209_s9; // u2f0
    reg [1:0] setup_light_length_n221_s9; // u2f0
    reg [1:0] setup_light_length_n233_s9; // u2f0
    reg [1:0] setup_light_length_n245_s9; // u2f0
    reg [1:0] setup_light_length_n257_s9; // u2f0
    reg [1:0] setup_light_length_n269_s9; // u2f0
    reg [1:0] setup_light_length_n281_s9; // u2f0
    reg [1:0] setup_light_length_n293_s9; // u2f0
    reg [1:0] setup_light_length_n305_s9; // u2f0
    reg [1:0] setup_light_length_n317_s9; // u2f0
    reg [1:0] setup_light_length_n327_s9; // u2f0
    reg [20:0] setup_light_unit_x_n385_s9; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s9; // s25f0
    reg setup_light_unit_x_n396_s9; // u1f0
    reg setup_light_unit_x_n402_s9; // u1f0
    reg setup_light_unit_x_n555_s9; // u1f0
    reg setup_light_unit_x_n557_s9; // u1f0
    reg [20:0] setup_light_unit_y_n602_s9; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s9; // s25f0
    reg setup_light_unit_y_n617_s9; // u1f0
    reg setup_light_unit_y_n769_s9; // u1f0
    reg setup_light_unit_y_n771_s9; // u1f0
    reg [20:0] setup_light_unit_z_n816_s9; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s9; // s25f0
    reg setup_light_unit_z_n831_s9; // u1f0
    reg setup_light_unit_z_n983_s9; // u1f0
    reg setup_light_unit_z_n985_s9; // u1f0
    reg [12:0] setup_half_length_n1163_s9; // u13f0
    reg [15:0] setup_half_length_n1167_s9; // u16f0
    reg [14:0] setup_half_length_n1169_s9; // u15f0
    reg [1:0] setup_half_length_n1178_s9; // u2f0
    reg [1:0] setup_half_length_n1190_s9; // u2f0
    reg [1:0] setup_half_length_n1202_s9; // u2f0
    reg [1:0] setup_half_length_n1214_s9; // u2f0
    reg [1:0] setup_half_length_n1226_s9; // u2f0
    reg [1:0] setup_half_length_n1238_s9; // u2f0
    reg [1:0] setup_half_length_n1250_s9; // u2f0
    reg [1:0] setup_half_length_n1262_s9; // u2f0
    reg [1:0] setup_half_length_n1274_s9; // u2f0
    reg [1:0] setup_half_length_n1286_s9; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s9; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s9; // s25f0
    reg setup_half_unit_x_n1367_s9; // u1f0
    reg setup_half_unit_x_n1520_s9; // u1f0
    reg setup_half_unit_x_n1522_s9; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s9; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s9; // s25f0
    reg setup_half_unit_y_n1582_s9; // u1f0
    reg setup_half_unit_y_n1734_s9; // u1f0
    reg setup_half_unit_y_n1736_s9; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s9; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s9; // s25f0
    reg setup_half_unit_z_n1796_s9; // u1f0
    reg setup_half_unit_z_n1948_s9; // u1f0
    reg setup_half_unit_z_n1950_s9; // u1f0
    reg [19:0] setup_bump_length_n2191_s9; // u20f0
    reg [22:0] setup_bump_length_n2192_s9; // u23f0
    reg [21:0] setup_bump_length_n2194_s9; // u22f0
    reg [17:0] setup_bump_unit_x_n2251_s9; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s9; // s25f0
    reg setup_bump_unit_x_n2417_s9; // u1f0
    reg setup_bump_unit_x_n2419_s9; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s9; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s9; // s25f0
    reg setup_bump_unit_y_n2623_s9; // u1f0
    reg setup_bump_unit_y_n2625_s9; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s9; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s9; // s25f0
    reg setup_bump_unit_z_n2829_s9; // u1f0
    reg setup_bump_unit_z_n2831_s9; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n194_s9 <= setup_light_length_n194;
            setup_light_length_n198_s9 <= setup_light_length_n198;
            setup_light_length_n200_s9 <= setup_light_length_n200;
            setup_light_length_n209_s9 <= setup_light_length_n209_s8;
            setup_light_length_n221_s9 <= setup_light_length_n221_s8;
            setup_light_length_n233_s9 <= setup_light_length_n233_s8;
            setup_light_length_n245_s9 <= setup_light_length_n245_s8;
            setup_light_length_n257_s9 <= setup_light_length_n257_s8;
            setup_light_length_n269_s9 <= setup_light_length_n269_s8;
            setup_light_length_n281_s9 <= setup_light_length_n281_s8;
            setup_light_length_n293_s9 <= setup_light_length_n293_s8;
            setup_light_length_n305_s9 <= setup_light_length_n305_s8;
            setup_light_length_n317_s9 <= setup_light_length_n317_s8;
            setup_light_length_n327_s9 <= setup_light_length_n327_s8;
            setup_light_unit_x_n385_s9 <= setup_light_unit_x_n385_s8;
            setup_light_unit_x_n395_s9 <= setup_light_unit_x_n395_s8;
            setup_light_unit_x_n396_s9 <= setup_light_unit_x_n396_s8;
            setup_light_unit_x_n402_s9 <= setup_light_unit_x_n402_s8;
            setup_light_unit_x_n555_s9 <= setup_light_unit_x_n555_s8;
            setup_light_unit_x_n557_s9 <= setup_light_unit_x_n557_s8;
            setup_light_unit_y_n602_s9 <= setup_light_unit_y_n602_s8;
            setup_light_unit_y_n611_s9 <= setup_light_unit_y_n611_s8;
            setup_light_unit_y_n617_s9 <= setup_light_unit_y_n617_s8;
            setup_light_unit_y_n769_s9 <= setup_light_unit_y_n769_s8;
            setup_light_unit_y_n771_s9 <= setup_light_unit_y_n771_s8;
            setup_light_unit_z_n816_s9 <= setup_light_unit_z_n816_s8;
            setup_light_unit_z_n825_s9 <= setup_light_unit_z_n825_s8;
            setup_light_unit_z_n831_s9 <= setup_light_unit_z_n831_s8;
            setup_light_unit_z_n983_s9 <= setup_light_unit_z_n983_s8;
            setup_light_unit_z_n985_s9 <= setup_light_unit_z_n985_s8;
            setup_half_length_n1163_s9 <= setup_half_length_n1163;
            setup_half_length_n1167_s9 <= setup_half_length_n1167;
            setup_half_length_n1169_s9 <= setup_half_length_n1169;
            setup_half_length_n1178_s9 <= setup_half_length_n1178_s8;
            setup_half_length_n1190_s9 <= setup_half_length_n1190_s8;
            setup_half_length_n1202_s9 <= setup_half_length_n1202_s8;
            setup_half_length_n1214_s9 <= setup_half_length_n1214_s8;
            setup_half_length_n1226_s9 <= setup_half_length_n1226_s8;
            setup_half_length_n1238_s9 <= setup_half_length_n1238_s8;
            setup_half_length_n1250_s9 <= setup_half_length_n1250_s8;
            setup_half_length_n1262_s9 <= setup_half_length_n1262_s8;
            setup_half_length_n1274_s9 <= setup_half_length_n1274_s8;
            setup_half_length_n1286_s9 <= setup_half_length_n1286_s8;
            setup_half_unit_x_n1352_s9 <= setup_half_unit_x_n1352_s8;
            setup_half_unit_x_n1361_s9 <= setup_half_unit_x_n1361_s8;
            setup_half_unit_x_n1367_s9 <= setup_half_unit_x_n1367_s8;
            setup_half_unit_x_n1520_s9 <= setup_half_unit_x_n1520_s8;
            setup_half_unit_x_n1522_s9 <= setup_half_unit_x_n1522_s8;
            setup_half_unit_y_n1567_s9 <= setup_half_unit_y_n1567_s8;
            setup_half_unit_y_n1576_s9 <= setup_half_unit_y_n1576_s8;
            setup_half_unit_y_n1582_s9 <= setup_half_unit_y_n1582_s8;
            setup_half_unit_y_n1734_s9 <= setup_half_unit_y_n1734_s8;
            setup_half_unit_y_n1736_s9 <= setup_half_unit_y_n1736_s8;
            setup_half_unit_z_n1781_s9 <= setup_half_unit_z_n1781_s8;
            setup_half_unit_z_n1790_s9 <= setup_half_unit_z_n1790_s8;
            setup_half_unit_z_n1796_s9 <= setup_half_unit_z_n1796_s8;
            setup_half_unit_z_n1948_s9 <= setup_half_unit_z_n1948_s8;
            setup_half_unit_z_n1950_s9 <= setup_half_unit_z_n1950_s8;
            setup_bump_length_n2191_s9 <= setup_bump_length_n2191;
            setup_bump_length_n2192_s9 <= setup_bump_length_n2192;
            setup_bump_length_n2194_s9 <= setup_bump_length_n2194;
            setup_bump_unit_x_n2251_s9 <= setup_bump_unit_x_n2251_s8;
            setup_bump_unit_x_n2259_s9 <= setup_bump_unit_x_n2259_s8;
            setup_bump_unit_x_n2417_s9 <= setup_bump_unit_x_n2417_s8;
            setup_bump_unit_x_n2419_s9 <= setup_bump_unit_x_n2419_s8;
            setup_bump_unit_y_n2458_s9 <= setup_bump_unit_y_n2458_s8;
            setup_bump_unit_y_n2466_s9 <= setup_bump_unit_y_n2466_s8;
            setup_bump_unit_y_n2623_s9 <= setup_bump_unit_y_n2623_s8;
            setup_bump_unit_y_n2625_s9 <= setup_bump_unit_y_n2625_s8;
            setup_bump_unit_z_n2664_s9 <= setup_bump_unit_z_n2664_s8;
            setup_bump_unit_z_n2672_s9 <= setup_bump_unit_z_n2672_s8;
            setup_bump_unit_z_n2829_s9 <= setup_bump_unit_z_n2829_s8;
            setup_bump_unit_z_n2831_s9 <= setup_bump_unit_z_n2831_s8;
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // setup.light.length
    wire signed [16:0] setup_light_length_n201 = {1'b0, setup_light_length_n198_s9} - {2'h0, setup_light_length_n200_s9}; // s17f0
    wire setup_light_length_n202 = setup_light_length_n201[16]; // u1f0
    wire signed [16:0] setup_light_length_n203 = setup_light_length_n202 ? {1'b0, setup_light_length_n198_s9} : setup_light_length_n201; // s17f0
    wire [14:0] setup_light_length_n204 = setup_light_length_n203[14:0]; // u15f0
    wire setup_light_length_n205 = setup_light_length_n202 ^ setup_light_length_n42; // u1f0
    wire [13:0] setup_light_length_n206 = {setup_light_length_n194_s9, setup_light_length_n205}; // u14f0
    wire [16:0] setup_light_length_n210 = {setup_light_length_n204, setup_light_length_n209_s9}; // u17f0
    wire [14:0] setup_light_length_n211 = {setup_light_length_n206, setup_light_length_n43}; // u15f0
    wire [15:0] setup_light_length_n212 = {setup_light_length_n211, setup_light_length_n42}; // u16f0
    wire signed [17:0] setup_light_length_n213 = {1'b0, setup_light_length_n210} - {2'h0, setup_light_length_n212}; // s18f0
    wire setup_light_length_n214 = setup_light_length_n213[17]; // u1f0
    wire signed [17:0] setup_light_length_n215 = setup_light_length_n214 ? {1'b0, setup_light_length_n210} : setup_light_length_n213; // s18f0
    wire [15:0] setup_light_length_n216 = setup_light_length_n215[15:0]; // u16f0
    wire setup_light_length_n217 = setup_light_length_n214 ^ setup_light_length_n42; // u1f0
    wire [14:0] setup_light_length_n218 = {setup_light_length_n206, setup_light_length_n217}; // u15f0
    wire [17:0] setup_light_length_n222 = {setup_light_length_n216, setup_light_length_n221_s9}; // u18f0
    wire [15:0] setup_light_length_n223 = {setup_light_length_n218, setup_light_length_n43}; // u16f0
    wire [16:0] setup_light_length_n224 = {setup_light_length_n223, setup_light_length_n42}; // u17f0
    wire signed [18:0] setup_light_length_n225 = {1'b0, setup_light_length_n222} - {2'h0, setup_light_length_n224}; // s19f0
    wire setup_light_length_n226 = setup_light_length_n225[18]; // u1f0
    // setup.half.length
    wire signed [16:0] setup_half_length_n1170 = {1'b0, setup_half_length_n1167_s9} - {2'h0, setup_half_length_n1169_s9}; // s17f0
    wire setup_half_length_n1171 = setup_half_length_n1170[16]; // u1f0
    wire signed [16:0] setup_half_length_n1172 = setup_half_length_n1171 ? {1'b0, setup_half_length_n1167_s9} : setup_half_length_n1170; // s17f0
    wire [14:0] setup_half_length_n1173 = setup_half_length_n1172[14:0]; // u15f0
    wire setup_half_length_n1174 = setup_half_length_n1171 ^ setup_light_length_n42; // u1f0
    wire [13:0] setup_half_length_n1175 = {setup_half_length_n1163_s9, setup_half_length_n1174}; // u14f0
    wire [16:0] setup_half_length_n1179 = {setup_half_length_n1173, setup_half_length_n1178_s9}; // u17f0
    wire [14:0] setup_half_length_n1180 = {setup_half_length_n1175, setup_light_length_n43}; // u15f0
    wire [15:0] setup_half_length_n1181 = {setup_half_length_n1180, setup_light_length_n42}; // u16f0
    wire signed [17:0] setup_half_length_n1182 = {1'b0, setup_half_length_n1179} - {2'h0, setup_half_length_n1181}; // s18f0
    wire setup_half_length_n1183 = setup_half_length_n1182[17]; // u1f0
    wire signed [17:0] setup_half_length_n1184 = setup_half_length_n1183 ? {1'b0, setup_half_length_n1179} : setup_half_length_n1182; // s18f0
    wire [15:0] setup_half_length_n1185 = setup_half_length_n1184[15:0]; // u16f0
    wire setup_half_length_n1186 = setup_half_length_n1183 ^ setup_light_length_n42; // u1f0
    wire [14:0] setup_half_length_n1187 = {setup_half_length_n1175, setup_half_length_n1186}; // u15f0
    wire [17:0] setup_half_length_n1191 = {setup_half_length_n1185, setup_half_length_n1190_s9}; // u18f0
    wire [15:0] setup_half_length_n1192 = {setup_half_length_n1187, setup_light_length_n43}; // u16f0
    wire [16:0] setup_half_length_n1193 = {setup_half_length_n1192, setup_light_length_n42}; // u17f0
    wire signed [18:0] setup_half_length_n1194 = {1'b0, setup_half_length_n1191} - {2'h0, setup_half_length_n1193}; // s19f0
    wire setup_half_length_n1195 = setup_half_length_n1194[18]; // u1f0
    // setup.bump.length
    wire signed [23:0] setup_bump_length_n2195 = {1'b0, setup_bump_length_n2192_s9} - {2'h0, setup_bump_length_n2194_s9}; // s24f0
    wire setup_bump_length_n2196 = setup_bump_length_n2195[23]; // u1f0
    wire signed [23:0] setup_bump_length_n2197 = setup_bump_length_n2196 ? {1'b0, setup_bump_length_n2192_s9} : setup_bump_length_n2195; // s24f0
    wire [21:0] setup_bump_length_n2198 = setup_bump_length_n2197[21:0]; // u22f0
    wire setup_bump_length_n2199 = setup_bump_length_n2196 ^ setup_light_length_n42; // u1f0
    wire [20:0] setup_bump_length_n2200 = {setup_bump_length_n2191_s9, setup_bump_length_n2199}; // u21f0
    wire [23:0] setup_bump_length_n2201 = {setup_bump_length_n2198, setup_light_length_n327_s9}; // u24f0
    wire [21:0] setup_bump_length_n2202 = {setup_bump_length_n2200, setup_light_length_n43}; // u22f0
    wire [22:0] setup_bump_length_n2203 = {setup_bump_length_n2202, setup_light_length_n42}; // u23f0
    wire signed [24:0] setup_bump_length_n2204 = {1'b0, setup_bump_length_n2201} - {2'h0, setup_bump_length_n2203}; // s25f0
    wire setup_bump_length_n2205 = setup_bump_length_n2204[24]; // u1f0
    wire signed [24:0] setup_bump_length_n2206 = setup_bump_length_n2205 ? {1'b0, setup_bump_length_n2201} : setup_bump_length_n2204; // s25f0
    wire [22:0] setup_bump_length_n2207 = setup_bump_length_n2206[22:0]; // u23f0
    wire setup_bump_length_n2208 = setup_bump_length_n2205 ^ setup_light_length_n42; // u1f0
    wire [21:0] setup_bump_length_n2209 = {setup_bump_length_n2200, setup_bump_length_n2208}; // u22f0

    reg [14:0] setup_light_length_n218_s10; // u15f0
    reg [17:0] setup_light_length_n222_s10; // u18f0
    reg signed [18:0] setup_light_length_n225_s10; // s19f0
    reg setup_light_length_n226_s10; // u1f0
    reg [1:0] setup_light_length_n233_s10; // u2f0
    reg [1:0] setup_light_length_n245_s10; // u2f0
    reg [1:0] setup_light_length_n257_s10; // u2f0
    reg [1:0] setup_light_length_n269_s10; // u2f0
    reg [1:0] setup_light_length_n281_s10; // u2f0
    reg [1:0] setup_light_length_n293_s10; // u2f0
    reg [1:0] setup_light_length_n305_s10; // u2f0
    reg [1:0] setup_light_length_n317_s10; // u2f0
    reg [1:0] setup_light_length_n327_s10; // u2f0
    reg [20:0] setup_light_unit_x_n385_s10; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s10; // s25f0
    reg setup_light_unit_x_n396_s10; // u1f0
    reg setup_light_unit_x_n402_s10; // u1f0
    reg setup_light_unit_x_n555_s10; // u1f0
    reg setup_light_unit_x_n557_s10; // u1f0
    reg [20:0] setup_light_unit_y_n602_s10; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s10; // s25f0
    reg setup_light_unit_y_n617_s10; // u1f0
    reg setup_light_unit_y_n769_s10; // u1f0
    reg setup_light_unit_y_n771_s10; // u1f0
    reg [20:0] setup_light_unit_z_n816_s10; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s10; // s25f0
    reg setup_light_unit_z_n831_s10; // u1f0
    reg setup_light_unit_z_n983_s10; // u1f0
    reg setup_light_unit_z_n985_s10; // u1f0
    reg [14:0] setup_half_length_n1187_s10; // u15f0
    reg [17:0] setup_half_length_n1191_s10; // u18f0
    reg signed [18:0] setup_half_length_n1194_s10; // s19f0
    reg setup_half_length_n1195_s10; // u1f0
    reg [1:0] setup_half_length_n1202_s10; // u2f0
    reg [1:0] setup_half_length_n1214_s10; // u2f0
    reg [1:0] setup_half_length_n1226_s10; // u2f0
    reg [1:0] setup_half_length_n1238_s10; // u2f0
    reg [1:0] setup_half_length_n1250_s10; // u2f0
    reg [1:0] setup_half_length_n1262_s10; // u2f0
    reg [1:0] setup_half_length_n1274_s10; // u2f0
    reg [1:0] setup_half_length_n1286_s10; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s10; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s10; // s25f0
    reg setup_half_unit_x_n1367_s10; // u1f0
    reg setup_half_unit_x_n1520_s10; // u1f0
    reg setup_half_unit_x_n1522_s10; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s10; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s10; // s25f0
    reg setup_half_unit_y_n1582_s10; // u1f0
    reg setup_half_unit_y_n1734_s10; // u1f0
    reg setup_half_unit_y_n1736_s10; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s10; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s10; // s25f0
    reg setup_half_unit_z_n1796_s10; // u1f0
    reg setup_half_unit_z_n1948_s10; // u1f0
    reg setup_half_unit_z_n1950_s10; // u1f0
    reg [22:0] setup_bump_length_n2207_s10; // u23f0
    reg [21:0] setup_bump_length_n2209_s10; // u22f0
    reg [17:0] setup_bump_unit_x_n2251_s10; // u18f0
    reg signed [24:0] setup_bump_unit_x_n2259_s10; // s25f0
    reg setup_bump_unit_x_n2417_s10; // u1f0
    reg setup_bump_unit_x_n2419_s10; // u1f0
    reg [17:0] setup_bump_unit_y_n2458_s10; // u18f0
    reg signed [24:0] setup_bump_unit_y_n2466_s10; // s25f0
    reg setup_bump_unit_y_n2623_s10; // u1f0
    reg setup_bump_unit_y_n2625_s10; // u1f0
    reg [17:0] setup_bump_unit_z_n2664_s10; // u18f0
    reg signed [24:0] setup_bump_unit_z_n2672_s10; // s25f0
    reg setup_bump_unit_z_n2829_s10; // u1f0
    reg setup_bump_unit_z_n2831_s10; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n218_s10 <= setup_light_length_n218;
            setup_light_length_n222_s10 <= setup_light_length_n222;
            setup_light_length_n225_s10 <= setup_light_length_n225;
            setup_light_length_n226_s10 <= setup_light_length_n226;
            setup_light_length_n233_s10 <= setup_light_length_n233_s9;
            setup_light_length_n245_s10 <= setup_light_length_n245_s9;
            setup_light_length_n257_s10 <= setup_light_length_n257_s9;
            setup_light_length_n269_s10 <= setup_light_length_n269_s9;
            setup_light_length_n281_s10 <= setup_light_length_n281_s9;
            setup_light_length_n293_s10 <= setup_light_length_n293_s9;
            setup_light_length_n305_s10 <= setup_light_length_n305_s9;
            setup_light_length_n317_s10 <= setup_light_length_n317_s9;
            setup_light_length_n327_s10 <= setup_light_length_n327_s9;
            setup_light_unit_x_n385_s10 <= setup_light_unit_x_n385_s9;
            setup_light_unit_x_n395_s10 <= setup_light_unit_x_n395_s9;
            setup_light_unit_x_n396_s10 <= setup_light_unit_x_n396_s9;
            setup_light_unit_x_n402_s10 <= setup_light_unit_x_n402_s9;
            setup_light_unit_x_n555_s10 <= setup_light_unit_x_n555_s9;
            setup_light_unit_x_n557_s10 <= setup_light_unit_x_n557_s9;
            setup_light_unit_y_n602_s10 <= setup_light_unit_y_n602_s9;
            setup_light_unit_y_n611_s10 <= setup_light_unit_y_n611_s9;
            setup_light_unit_y_n617_s10 <= setup_light_unit_y_n617_s9;
            setup_light_unit_y_n769_s10 <= setup_light_unit_y_n769_s9;
            setup_light_unit_y_n771_s10 <= setup_light_unit_y_n771_s9;
            setup_light_unit_z_n816_s10 <= setup_light_unit_z_n816_s9;
            setup_light_unit_z_n825_s10 <= setup_light_unit_z_n825_s9;
            setup_light_unit_z_n831_s10 <= setup_light_unit_z_n831_s9;
            setup_light_unit_z_n983_s10 <= setup_light_unit_z_n983_s9;
            setup_light_unit_z_n985_s10 <= setup_light_unit_z_n985_s9;
            setup_half_length_n1187_s10 <= setup_half_length_n1187;
            setup_half_length_n1191_s10 <= setup_half_length_n1191;
            setup_half_length_n1194_s10 <= setup_half_length_n1194;
            setup_half_length_n1195_s10 <= setup_half_length_n1195;
            setup_half_length_n1202_s10 <= setup_half_length_n1202_s9;
            setup_half_length_n1214_s10 <= setup_half_length_n1214_s9;
            setup_half_length_n1226_s10 <= setup_half_length_n1226_s9;
            setup_half_length_n1238_s10 <= setup_half_length_n1238_s9;
            setup_half_length_n1250_s10 <= setup_half_length_n1250_s9;
            setup_half_length_n1262_s10 <= setup_half_length_n1262_s9;
            setup_half_length_n1274_s10 <= setup_half_length_n1274_s9;
            setup_half_length_n1286_s10 <= setup_half_length_n1286_s9;
            setup_half_unit_x_n1352_s10 <= setup_half_unit_x_n1352_s9;
            setup_half_unit_x_n1361_s10 <= setup_half_unit_x_n1361_s9;
            setup_half_unit_x_n1367_s10 <= setup_half_unit_x_n1367_s9;
            setup_half_unit_x_n1520_s10 <= setup_half_unit_x_n1520_s9;
            setup_half_unit_x_n1522_s10 <= setup_half_unit_x_n1522_s9;
            setup_half_unit_y_n1567_s10 <= setup_half_unit_y_n1567_s9;
            setup_half_unit_y_n1576_s10 <= setup_half_unit_y_n1576_s9;
            setup_half_unit_y_n1582_s10 <= setup_half_unit_y_n1582_s9;
            setup_half_unit_y_n1734_s10 <= setup_half_unit_y_n1734_s9;
            setup_half_unit_y_n1736_s10 <= setup_half_unit_y_n1736_s9;
            setup_half_unit_z_n1781_s10 <= setup_half_unit_z_n1781_s9;
            setup_half_unit_z_n1790_s10 <= setup_half_unit_z_n1790_s9;
            setup_half_unit_z_n1796_s10 <= setup_half_unit_z_n1796_s9;
            setup_half_unit_z_n1948_s10 <= setup_half_unit_z_n1948_s9;
            setup_half_unit_z_n1950_s10 <= setup_half_unit_z_n1950_s9;
            setup_bump_length_n2207_s10 <= setup_bump_length_n2207;
            setup_bump_length_n2209_s10 <= setup_bump_length_n2209;
            setup_bump_unit_x_n2251_s10 <= setup_bump_unit_x_n2251_s9;
            setup_bump_unit_x_n2259_s10 <= setup_bump_unit_x_n2259_s9;
            setup_bump_unit_x_n2417_s10 <= setup_bump_unit_x_n2417_s9;
            setup_bump_unit_x_n2419_s10 <= setup_bump_unit_x_n2419_s9;
            setup_bump_unit_y_n2458_s10 <= setup_bump_unit_y_n2458_s9;
            setup_bump_unit_y_n2466_s10 <= setup_bump_unit_y_n2466_s9;
            setup_bump_unit_y_n2623_s10 <= setup_bump_unit_y_n2623_s9;
            setup_bump_unit_y_n2625_s10 <= setup_bump_unit_y_n2625_s9;
            setup_bump_unit_z_n2664_s10 <= setup_bump_unit_z_n2664_s9;
            setup_bump_unit_z_n2672_s10 <= setup_bump_unit_z_n2672_s9;
            setup_bump_unit_z_n2829_s10 <= setup_bump_unit_z_n2829_s9;
            setup_bump_unit_z_n2831_s10 <= setup_bump_unit_z_n2831_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // setup.light.length
    wire signed [18:0] setup_light_length_n227 = setup_light_length_n226_s10 ? {1'b0, setup_light_length_n222_s10} : setup_light_length_n225_s10; // s19f0
    wire [16:0] setup_light_length_n228 = setup_light_length_n227[16:0]; // u17f0
    wire setup_light_length_n229 = setup_light_length_n226_s10 ^ setup_light_length_n42; // u1f0
    wire [15:0] setup_light_length_n230 = {setup_light_length_n218_s10, setup_light_length_n229}; // u16f0
    wire [18:0] setup_light_length_n234 = {setup_light_length_n228, setup_light_length_n233_s10}; // u19f0
    wire [16:0] setup_light_length_n235 = {setup_light_length_n230, setup_light_length_n43}; // u17f0
    wire [17:0] setup_light_length_n236 = {setup_light_length_n235, setup_light_length_n42}; // u18f0
    wire signed [19:0] setup_light_length_n237 = {1'b0, setup_light_length_n234} - {2'h0, setup_light_length_n236}; // s20f0
    wire setup_light_length_n238 = setup_light_length_n237[19]; // u1f0
    wire signed [19:0] setup_light_length_n239 = setup_light_length_n238 ? {1'b0, setup_light_length_n234} : setup_light_length_n237; // s20f0
    wire [17:0] setup_light_length_n240 = setup_light_length_n239[17:0]; // u18f0
    wire setup_light_length_n241 = setup_light_length_n238 ^ setup_light_length_n42; // u1f0
    wire [16:0] setup_light_length_n242 = {setup_light_length_n230, setup_light_length_n241}; // u17f0
    wire [19:0] setup_light_length_n246 = {setup_light_length_n240, setup_light_length_n245_s10}; // u20f0
    wire [17:0] setup_light_length_n247 = {setup_light_length_n242, setup_light_length_n43}; // u18f0
    wire [18:0] setup_light_length_n248 = {setup_light_length_n247, setup_light_length_n42}; // u19f0
    wire signed [20:0] setup_light_length_n249 = {1'b0, setup_light_length_n246} - {2'h0, setup_light_length_n248}; // s21f0
    wire setup_light_length_n250 = setup_light_length_n249[20]; // u1f0
    wire signed [20:0] setup_light_length_n251 = setup_light_length_n250 ? {1'b0, setup_light_length_n246} : setup_light_length_n249; // s21f0
    wire [18:0] setup_light_length_n252 = setup_light_length_n251[18:0]; // u19f0
    wire setup_light_length_n253 = setup_light_length_n250 ^ setup_light_length_n42; // u1f0
    wire [17:0] setup_light_length_n254 = {setup_light_length_n242, setup_light_length_n253}; // u18f0
    wire [20:0] setup_light_length_n258 = {setup_light_length_n252, setup_light_length_n257_s10}; // u21f0
    wire [18:0] setup_light_length_n259 = {setup_light_length_n254, setup_light_length_n43}; // u19f0
    wire [19:0] setup_light_length_n260 = {setup_light_length_n259, setup_light_length_n42}; // u20f0
    // setup.half.length
    wire signed [18:0] setup_half_length_n1196 = setup_half_length_n1195_s10 ? {1'b0, setup_half_length_n1191_s10} : setup_half_length_n1194_s10; // s19f0
    wire [16:0] setup_half_length_n1197 = setup_half_length_n1196[16:0]; // u17f0
    wire setup_half_length_n1198 = setup_half_length_n1195_s10 ^ setup_light_length_n42; // u1f0
    wire [15:0] setup_half_length_n1199 = {setup_half_length_n1187_s10, setup_half_length_n1198}; // u16f0
    wire [18:0] setup_half_length_n1203 = {setup_half_length_n1197, setup_half_length_n1202_s10}; // u19f0
    wire [16:0] setup_half_length_n1204 = {setup_half_length_n1199, setup_light_length_n43}; // u17f0
    wire [17:0] setup_half_length_n1205 = {setup_half_length_n1204, setup_light_length_n42}; // u18f0
    wire signed [19:0] setup_half_length_n1206 = {1'b0, setup_half_length_n1203} - {2'h0, setup_half_length_n1205}; // s20f0
    wire setup_half_length_n1207 = setup_half_length_n1206[19]; // u1f0
    wire signed [19:0] setup_half_length_n1208 = setup_half_length_n1207 ? {1'b0, setup_half_length_n1203} : setup_half_length_n1206; // s20f0
    wire [17:0] setup_half_length_n1209 = setup_half_length_n1208[17:0]; // u18f0
    wire setup_half_length_n1210 = setup_half_length_n1207 ^ setup_light_length_n42; // u1f0
    wire [16:0] setup_half_length_n1211 = {setup_half_length_n1199, setup_half_length_n1210}; // u17f0
    wire [19:0] setup_half_length_n1215 = {setup_half_length_n1209, setup_half_length_n1214_s10}; // u20f0
    wire [17:0] setup_half_length_n1216 = {setup_half_length_n1211, setup_light_length_n43}; // u18f0
    wire [18:0] setup_half_length_n1217 = {setup_half_length_n1216, setup_light_length_n42}; // u19f0
    wire signed [20:0] setup_half_length_n1218 = {1'b0, setup_half_length_n1215} - {2'h0, setup_half_length_n1217}; // s21f0
    wire setup_half_length_n1219 = setup_half_length_n1218[20]; // u1f0
    wire signed [20:0] setup_half_length_n1220 = setup_half_length_n1219 ? {1'b0, setup_half_length_n1215} : setup_half_length_n1218; // s21f0
    wire [18:0] setup_half_length_n1221 = setup_half_length_n1220[18:0]; // u19f0
    wire setup_half_length_n1222 = setup_half_length_n1219 ^ setup_light_length_n42; // u1f0
    wire [17:0] setup_half_length_n1223 = {setup_half_length_n1211, setup_half_length_n1222}; // u18f0
    wire [20:0] setup_half_length_n1227 = {setup_half_length_n1221, setup_half_length_n1226_s10}; // u21f0
    wire [18:0] setup_half_length_n1228 = {setup_half_length_n1223, setup_light_length_n43}; // u19f0
    wire [19:0] setup_half_length_n1229 = {setup_half_length_n1228, setup_light_length_n42}; // u20f0
    // setup.bump.length
    wire setup_bump_length_n2210 = setup_bump_length_n2207_s10 == {22'h0, setup_light_length_n43}; // u1f0
    wire setup_bump_length_n2211 = setup_bump_length_n2210 ^ setup_light_length_n42; // u1f0
    wire [22:0] setup_bump_length_n2212 = {setup_bump_length_n2209_s10, setup_bump_length_n2211}; // u23f0
    wire [2:-20] setup_bump_length_n2213 = setup_bump_length_n2212; // u23f20
    wire [3:-20] setup_bump_length_length_sum = {1'b0, setup_bump_length_n2213} + 24'h2;
    wire [3:-18] setup_bump_length_length_cut = setup_bump_length_length_sum[3:-18];
    wire [4:-18] setup_bump_length_length = {1'b0, setup_bump_length_length_cut}; // u23f18
    // setup.bump.unit_x
    wire [22:0] setup_bump_unit_x_n2216 = setup_bump_length_length; // u23f0
    wire setup_bump_unit_x_n2252 = {5'h0, setup_bump_unit_x_n2251_s10} < setup_bump_unit_x_n2216; // u1f0
    wire [25:0] setup_bump_unit_x_n2260_term = {3'h0, setup_bump_unit_x_n2216} ^ {26{setup_light_unit_x_n396_s10}};
    wire signed [25:0] setup_bump_unit_x_n2260 = {setup_bump_unit_x_n2259_s10[24], setup_bump_unit_x_n2259_s10} + setup_bump_unit_x_n2260_term + {25'h0, setup_light_unit_x_n396_s10}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2261 = setup_bump_unit_x_n2260[23:0]; // s24f0
    wire setup_bump_unit_x_n2262 = setup_bump_unit_x_n2261[23]; // u1f0
    wire [23:0] setup_bump_unit_x_n2264 = setup_bump_unit_x_n2261; // u24f0
    wire [24:0] setup_bump_unit_x_n2265 = {setup_bump_unit_x_n2264, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2266 = setup_bump_unit_x_n2265; // s25f0
    wire setup_bump_unit_x_n2414 = setup_bump_length_length == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    // setup.bump.unit_y
    wire setup_bump_unit_y_n2459 = {5'h0, setup_bump_unit_y_n2458_s10} < setup_bump_unit_x_n2216; // u1f0
    wire [25:0] setup_bump_unit_y_n2467_term = {3'h0, setup_bump_unit_x_n2216} ^ {26{setup_light_unit_x_n396_s10}};
    wire signed [25:0] setup_bump_unit_y_n2467 = {setup_bump_unit_y_n2466_s10[24], setup_bump_unit_y_n2466_s10} + setup_bump_unit_y_n2467_term + {25'h0, setup_light_unit_x_n396_s10}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2468 = setup_bump_unit_y_n2467[23:0]; // s24f0
    wire setup_bump_unit_y_n2469 = setup_bump_unit_y_n2468[23]; // u1f0
    wire [23:0] setup_bump_unit_y_n2471 = setup_bump_unit_y_n2468; // u24f0
    wire [24:0] setup_bump_unit_y_n2472 = {setup_bump_unit_y_n2471, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2473 = setup_bump_unit_y_n2472; // s25f0
    // setup.bump.unit_z
    wire setup_bump_unit_z_n2665 = {5'h0, setup_bump_unit_z_n2664_s10} < setup_bump_unit_x_n2216; // u1f0
    wire [25:0] setup_bump_unit_z_n2673_term = {3'h0, setup_bump_unit_x_n2216} ^ {26{setup_light_unit_x_n396_s10}};
    wire signed [25:0] setup_bump_unit_z_n2673 = {setup_bump_unit_z_n2672_s10[24], setup_bump_unit_z_n2672_s10} + setup_bump_unit_z_n2673_term + {25'h0, setup_light_unit_x_n396_s10}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2674 = setup_bump_unit_z_n2673[23:0]; // s24f0
    wire setup_bump_unit_z_n2675 = setup_bump_unit_z_n2674[23]; // u1f0
    wire [23:0] setup_bump_unit_z_n2677 = setup_bump_unit_z_n2674; // u24f0
    wire [24:0] setup_bump_unit_z_n2678 = {setup_bump_unit_z_n2677, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2679 = setup_bump_unit_z_n2678; // s25f0

    reg [17:0] setup_light_length_n254_s11; // u18f0
    reg [20:0] setup_light_length_n258_s11; // u21f0
    reg [19:0] setup_light_length_n260_s11; // u20f0
    reg [1:0] setup_light_length_n269_s11; // u2f0
    reg [1:0] setup_light_length_n281_s11; // u2f0
    reg [1:0] setup_light_length_n293_s11; // u2f0
    reg [1:0] setup_light_length_n305_s11; // u2f0
    reg [1:0] setup_light_length_n317_s11; // u2f0
    reg [1:0] setup_light_length_n327_s11; // u2f0
    reg [20:0] setup_light_unit_x_n385_s11; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s11; // s25f0
    reg setup_light_unit_x_n396_s11; // u1f0
    reg setup_light_unit_x_n402_s11; // u1f0
    reg setup_light_unit_x_n555_s11; // u1f0
    reg setup_light_unit_x_n557_s11; // u1f0
    reg [20:0] setup_light_unit_y_n602_s11; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s11; // s25f0
    reg setup_light_unit_y_n617_s11; // u1f0
    reg setup_light_unit_y_n769_s11; // u1f0
    reg setup_light_unit_y_n771_s11; // u1f0
    reg [20:0] setup_light_unit_z_n816_s11; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s11; // s25f0
    reg setup_light_unit_z_n831_s11; // u1f0
    reg setup_light_unit_z_n983_s11; // u1f0
    reg setup_light_unit_z_n985_s11; // u1f0
    reg [17:0] setup_half_length_n1223_s11; // u18f0
    reg [20:0] setup_half_length_n1227_s11; // u21f0
    reg [19:0] setup_half_length_n1229_s11; // u20f0
    reg [1:0] setup_half_length_n1238_s11; // u2f0
    reg [1:0] setup_half_length_n1250_s11; // u2f0
    reg [1:0] setup_half_length_n1262_s11; // u2f0
    reg [1:0] setup_half_length_n1274_s11; // u2f0
    reg [1:0] setup_half_length_n1286_s11; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s11; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s11; // s25f0
    reg setup_half_unit_x_n1367_s11; // u1f0
    reg setup_half_unit_x_n1520_s11; // u1f0
    reg setup_half_unit_x_n1522_s11; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s11; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s11; // s25f0
    reg setup_half_unit_y_n1582_s11; // u1f0
    reg setup_half_unit_y_n1734_s11; // u1f0
    reg setup_half_unit_y_n1736_s11; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s11; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s11; // s25f0
    reg setup_half_unit_z_n1796_s11; // u1f0
    reg setup_half_unit_z_n1948_s11; // u1f0
    reg setup_half_unit_z_n1950_s11; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s11; // u23f0
    reg setup_bump_unit_x_n2252_s11; // u1f0
    reg setup_bump_unit_x_n2262_s11; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2266_s11; // s25f0
    reg setup_bump_unit_x_n2414_s11; // u1f0
    reg setup_bump_unit_x_n2417_s11; // u1f0
    reg setup_bump_unit_x_n2419_s11; // u1f0
    reg setup_bump_unit_y_n2459_s11; // u1f0
    reg setup_bump_unit_y_n2469_s11; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2473_s11; // s25f0
    reg setup_bump_unit_y_n2623_s11; // u1f0
    reg setup_bump_unit_y_n2625_s11; // u1f0
    reg setup_bump_unit_z_n2665_s11; // u1f0
    reg setup_bump_unit_z_n2675_s11; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2679_s11; // s25f0
    reg setup_bump_unit_z_n2829_s11; // u1f0
    reg setup_bump_unit_z_n2831_s11; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n254_s11 <= setup_light_length_n254;
            setup_light_length_n258_s11 <= setup_light_length_n258;
            setup_light_length_n260_s11 <= setup_light_length_n260;
            setup_light_length_n269_s11 <= setup_light_length_n269_s10;
            setup_light_length_n281_s11 <= setup_light_length_n281_s10;
            setup_light_length_n293_s11 <= setup_light_length_n293_s10;
            setup_light_length_n305_s11 <= setup_light_length_n305_s10;
            setup_light_length_n317_s11 <= setup_light_length_n317_s10;
            setup_light_length_n327_s11 <= setup_light_length_n327_s10;
            setup_light_unit_x_n385_s11 <= setup_light_unit_x_n385_s10;
            setup_light_unit_x_n395_s11 <= setup_light_unit_x_n395_s10;
            setup_light_unit_x_n396_s11 <= setup_light_unit_x_n396_s10;
            setup_light_unit_x_n402_s11 <= setup_light_unit_x_n402_s10;
            setup_light_unit_x_n555_s11 <= setup_light_unit_x_n555_s10;
            setup_light_unit_x_n557_s11 <= setup_light_unit_x_n557_s10;
            setup_light_unit_y_n602_s11 <= setup_light_unit_y_n602_s10;
            setup_light_unit_y_n611_s11 <= setup_light_unit_y_n611_s10;
            setup_light_unit_y_n617_s11 <= setup_light_unit_y_n617_s10;
            setup_light_unit_y_n769_s11 <= setup_light_unit_y_n769_s10;
            setup_light_unit_y_n771_s11 <= setup_light_unit_y_n771_s10;
            setup_light_unit_z_n816_s11 <= setup_light_unit_z_n816_s10;
            setup_light_unit_z_n825_s11 <= setup_light_unit_z_n825_s10;
            setup_light_unit_z_n831_s11 <= setup_light_unit_z_n831_s10;
            setup_light_unit_z_n983_s11 <= setup_light_unit_z_n983_s10;
            setup_light_unit_z_n985_s11 <= setup_light_unit_z_n985_s10;
            setup_half_length_n1223_s11 <= setup_half_length_n1223;
            setup_half_length_n1227_s11 <= setup_half_length_n1227;
            setup_half_length_n1229_s11 <= setup_half_length_n1229;
            setup_half_length_n1238_s11 <= setup_half_length_n1238_s10;
            setup_half_length_n1250_s11 <= setup_half_length_n1250_s10;
            setup_half_length_n1262_s11 <= setup_half_length_n1262_s10;
            setup_half_length_n1274_s11 <= setup_half_length_n1274_s10;
            setup_half_length_n1286_s11 <= setup_half_length_n1286_s10;
            setup_half_unit_x_n1352_s11 <= setup_half_unit_x_n1352_s10;
            setup_half_unit_x_n1361_s11 <= setup_half_unit_x_n1361_s10;
            setup_half_unit_x_n1367_s11 <= setup_half_unit_x_n1367_s10;
            setup_half_unit_x_n1520_s11 <= setup_half_unit_x_n1520_s10;
            setup_half_unit_x_n1522_s11 <= setup_half_unit_x_n1522_s10;
            setup_half_unit_y_n1567_s11 <= setup_half_unit_y_n1567_s10;
            setup_half_unit_y_n1576_s11 <= setup_half_unit_y_n1576_s10;
            setup_half_unit_y_n1582_s11 <= setup_half_unit_y_n1582_s10;
            setup_half_unit_y_n1734_s11 <= setup_half_unit_y_n1734_s10;
            setup_half_unit_y_n1736_s11 <= setup_half_unit_y_n1736_s10;
            setup_half_unit_z_n1781_s11 <= setup_half_unit_z_n1781_s10;
            setup_half_unit_z_n1790_s11 <= setup_half_unit_z_n1790_s10;
            setup_half_unit_z_n1796_s11 <= setup_half_unit_z_n1796_s10;
            setup_half_unit_z_n1948_s11 <= setup_half_unit_z_n1948_s10;
            setup_half_unit_z_n1950_s11 <= setup_half_unit_z_n1950_s10;
            setup_bump_unit_x_n2216_s11 <= setup_bump_unit_x_n2216;
            setup_bump_unit_x_n2252_s11 <= setup_bump_unit_x_n2252;
            setup_bump_unit_x_n2262_s11 <= setup_bump_unit_x_n2262;
            setup_bump_unit_x_n2266_s11 <= setup_bump_unit_x_n2266;
            setup_bump_unit_x_n2414_s11 <= setup_bump_unit_x_n2414;
            setup_bump_unit_x_n2417_s11 <= setup_bump_unit_x_n2417_s10;
            setup_bump_unit_x_n2419_s11 <= setup_bump_unit_x_n2419_s10;
            setup_bump_unit_y_n2459_s11 <= setup_bump_unit_y_n2459;
            setup_bump_unit_y_n2469_s11 <= setup_bump_unit_y_n2469;
            setup_bump_unit_y_n2473_s11 <= setup_bump_unit_y_n2473;
            setup_bump_unit_y_n2623_s11 <= setup_bump_unit_y_n2623_s10;
            setup_bump_unit_y_n2625_s11 <= setup_bump_unit_y_n2625_s10;
            setup_bump_unit_z_n2665_s11 <= setup_bump_unit_z_n2665;
            setup_bump_unit_z_n2675_s11 <= setup_bump_unit_z_n2675;
            setup_bump_unit_z_n2679_s11 <= setup_bump_unit_z_n2679;
            setup_bump_unit_z_n2829_s11 <= setup_bump_unit_z_n2829_s10;
            setup_bump_unit_z_n2831_s11 <= setup_bump_unit_z_n2831_s10;
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // setup.light.length
    wire signed [21:0] setup_light_length_n261 = {1'b0, setup_light_length_n258_s11} - {2'h0, setup_light_length_n260_s11}; // s22f0
    wire setup_light_length_n262 = setup_light_length_n261[21]; // u1f0
    wire signed [21:0] setup_light_length_n263 = setup_light_length_n262 ? {1'b0, setup_light_length_n258_s11} : setup_light_length_n261; // s22f0
    wire [19:0] setup_light_length_n264 = setup_light_length_n263[19:0]; // u20f0
    wire setup_light_length_n265 = setup_light_length_n262 ^ setup_light_length_n42; // u1f0
    wire [18:0] setup_light_length_n266 = {setup_light_length_n254_s11, setup_light_length_n265}; // u19f0
    wire [21:0] setup_light_length_n270 = {setup_light_length_n264, setup_light_length_n269_s11}; // u22f0
    wire [19:0] setup_light_length_n271 = {setup_light_length_n266, setup_light_length_n43}; // u20f0
    wire [20:0] setup_light_length_n272 = {setup_light_length_n271, setup_light_length_n42}; // u21f0
    wire signed [22:0] setup_light_length_n273 = {1'b0, setup_light_length_n270} - {2'h0, setup_light_length_n272}; // s23f0
    wire setup_light_length_n274 = setup_light_length_n273[22]; // u1f0
    wire signed [22:0] setup_light_length_n275 = setup_light_length_n274 ? {1'b0, setup_light_length_n270} : setup_light_length_n273; // s23f0
    wire [20:0] setup_light_length_n276 = setup_light_length_n275[20:0]; // u21f0
    wire setup_light_length_n277 = setup_light_length_n274 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_light_length_n278 = {setup_light_length_n266, setup_light_length_n277}; // u20f0
    wire [22:0] setup_light_length_n282 = {setup_light_length_n276, setup_light_length_n281_s11}; // u23f0
    wire [20:0] setup_light_length_n283 = {setup_light_length_n278, setup_light_length_n43}; // u21f0
    wire [21:0] setup_light_length_n284 = {setup_light_length_n283, setup_light_length_n42}; // u22f0
    // setup.half.length
    wire signed [21:0] setup_half_length_n1230 = {1'b0, setup_half_length_n1227_s11} - {2'h0, setup_half_length_n1229_s11}; // s22f0
    wire setup_half_length_n1231 = setup_half_length_n1230[21]; // u1f0
    wire signed [21:0] setup_half_length_n1232 = setup_half_length_n1231 ? {1'b0, setup_half_length_n1227_s11} : setup_half_length_n1230; // s22f0
    wire [19:0] setup_half_length_n1233 = setup_half_length_n1232[19:0]; // u20f0
    wire setup_half_length_n1234 = setup_half_length_n1231 ^ setup_light_length_n42; // u1f0
    wire [18:0] setup_half_length_n1235 = {setup_half_length_n1223_s11, setup_half_length_n1234}; // u19f0
    wire [21:0] setup_half_length_n1239 = {setup_half_length_n1233, setup_half_length_n1238_s11}; // u22f0
    wire [19:0] setup_half_length_n1240 = {setup_half_length_n1235, setup_light_length_n43}; // u20f0
    wire [20:0] setup_half_length_n1241 = {setup_half_length_n1240, setup_light_length_n42}; // u21f0
    wire signed [22:0] setup_half_length_n1242 = {1'b0, setup_half_length_n1239} - {2'h0, setup_half_length_n1241}; // s23f0
    wire setup_half_length_n1243 = setup_half_length_n1242[22]; // u1f0
    wire signed [22:0] setup_half_length_n1244 = setup_half_length_n1243 ? {1'b0, setup_half_length_n1239} : setup_half_length_n1242; // s23f0
    wire [20:0] setup_half_length_n1245 = setup_half_length_n1244[20:0]; // u21f0
    wire setup_half_length_n1246 = setup_half_length_n1243 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_half_length_n1247 = {setup_half_length_n1235, setup_half_length_n1246}; // u20f0
    wire [22:0] setup_half_length_n1251 = {setup_half_length_n1245, setup_half_length_n1250_s11}; // u23f0
    wire [20:0] setup_half_length_n1252 = {setup_half_length_n1247, setup_light_length_n43}; // u21f0
    wire [21:0] setup_half_length_n1253 = {setup_half_length_n1252, setup_light_length_n42}; // u22f0
    // setup.bump.unit_x
    wire setup_bump_unit_x_n2253 = setup_bump_unit_x_n2252_s11 ^ setup_light_length_n42; // u1f0
    wire setup_bump_unit_x_n2263 = setup_bump_unit_x_n2262_s11 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_bump_unit_x_n2267_term = {3'h0, setup_bump_unit_x_n2216_s11} ^ {26{setup_bump_unit_x_n2263}};
    wire signed [25:0] setup_bump_unit_x_n2267 = {setup_bump_unit_x_n2266_s11[24], setup_bump_unit_x_n2266_s11} + setup_bump_unit_x_n2267_term + {25'h0, setup_bump_unit_x_n2263}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2268 = setup_bump_unit_x_n2267[23:0]; // s24f0
    wire setup_bump_unit_x_n2269 = setup_bump_unit_x_n2268[23]; // u1f0
    wire setup_bump_unit_x_n2270 = setup_bump_unit_x_n2269 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2271 = setup_bump_unit_x_n2268; // u24f0
    wire [24:0] setup_bump_unit_x_n2272 = {setup_bump_unit_x_n2271, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2273 = setup_bump_unit_x_n2272; // s25f0
    wire [25:0] setup_bump_unit_x_n2274_term = {3'h0, setup_bump_unit_x_n2216_s11} ^ {26{setup_bump_unit_x_n2270}};
    wire signed [25:0] setup_bump_unit_x_n2274 = {setup_bump_unit_x_n2273[24], setup_bump_unit_x_n2273} + setup_bump_unit_x_n2274_term + {25'h0, setup_bump_unit_x_n2270}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2275 = setup_bump_unit_x_n2274[23:0]; // s24f0
    wire setup_bump_unit_x_n2276 = setup_bump_unit_x_n2275[23]; // u1f0
    wire setup_bump_unit_x_n2277 = setup_bump_unit_x_n2276 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2278 = setup_bump_unit_x_n2275; // u24f0
    wire [24:0] setup_bump_unit_x_n2279 = {setup_bump_unit_x_n2278, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2280 = setup_bump_unit_x_n2279; // s25f0
    wire [1:0] setup_bump_unit_x_n2394 = {setup_bump_unit_x_n2263, setup_bump_unit_x_n2270}; // u2f0
    wire [2:0] setup_bump_unit_x_n2395 = {setup_bump_unit_x_n2394, setup_bump_unit_x_n2277}; // u3f0
    wire setup_bump_unit_x_n2415 = setup_bump_unit_x_n2253 | setup_bump_unit_x_n2414_s11; // u1f0
    // setup.bump.unit_y
    wire setup_bump_unit_y_n2460 = setup_bump_unit_y_n2459_s11 ^ setup_light_length_n42; // u1f0
    wire setup_bump_unit_y_n2470 = setup_bump_unit_y_n2469_s11 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_bump_unit_y_n2474_term = {3'h0, setup_bump_unit_x_n2216_s11} ^ {26{setup_bump_unit_y_n2470}};
    wire signed [25:0] setup_bump_unit_y_n2474 = {setup_bump_unit_y_n2473_s11[24], setup_bump_unit_y_n2473_s11} + setup_bump_unit_y_n2474_term + {25'h0, setup_bump_unit_y_n2470}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2475 = setup_bump_unit_y_n2474[23:0]; // s24f0
    wire setup_bump_unit_y_n2476 = setup_bump_unit_y_n2475[23]; // u1f0
    wire setup_bump_unit_y_n2477 = setup_bump_unit_y_n2476 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2478 = setup_bump_unit_y_n2475; // u24f0
    wire [24:0] setup_bump_unit_y_n2479 = {setup_bump_unit_y_n2478, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2480 = setup_bump_unit_y_n2479; // s25f0
    wire [25:0] setup_bump_unit_y_n2481_term = {3'h0, setup_bump_unit_x_n2216_s11} ^ {26{setup_bump_unit_y_n2477}};
    wire signed [25:0] setup_bump_unit_y_n2481 = {setup_bump_unit_y_n2480[24], setup_bump_unit_y_n2480} + setup_bump_unit_y_n2481_term + {25'h0, setup_bump_unit_y_n2477}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2482 = setup_bump_unit_y_n2481[23:0]; // s24f0
    wire setup_bump_unit_y_n2483 = setup_bump_unit_y_n2482[23]; // u1f0
    wire setup_bump_unit_y_n2484 = setup_bump_unit_y_n2483 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2485 = setup_bump_unit_y_n2482; // u24f0
    wire [24:0] setup_bump_unit_y_n2486 = {setup_bump_unit_y_n2485, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2487 = setup_bump_unit_y_n2486; // s25f0
    wire [1:0] setup_bump_unit_y_n2601 = {setup_bump_unit_y_n2470, setup_bump_unit_y_n2477}; // u2f0
    wire [2:0] setup_bump_unit_y_n2602 = {setup_bump_unit_y_n2601, setup_bump_unit_y_n2484}; // u3f0
    wire setup_bump_unit_y_n2621 = setup_bump_unit_y_n2460 | setup_bump_unit_x_n2414_s11; // u1f0
    // setup.bump.unit_z
    wire setup_bump_unit_z_n2666 = setup_bump_unit_z_n2665_s11 ^ setup_light_length_n42; // u1f0
    wire setup_bump_unit_z_n2676 = setup_bump_unit_z_n2675_s11 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_bump_unit_z_n2680_term = {3'h0, setup_bump_unit_x_n2216_s11} ^ {26{setup_bump_unit_z_n2676}};
    wire signed [25:0] setup_bump_unit_z_n2680 = {setup_bump_unit_z_n2679_s11[24], setup_bump_unit_z_n2679_s11} + setup_bump_unit_z_n2680_term + {25'h0, setup_bump_unit_z_n2676}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2681 = setup_bump_unit_z_n2680[23:0]; // s24f0
    wire setup_bump_unit_z_n2682 = setup_bump_unit_z_n2681[23]; // u1f0
    wire setup_bump_unit_z_n2683 = setup_bump_unit_z_n2682 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2684 = setup_bump_unit_z_n2681; // u24f0
    wire [24:0] setup_bump_unit_z_n2685 = {setup_bump_unit_z_n2684, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2686 = setup_bump_unit_z_n2685; // s25f0
    wire [25:0] setup_bump_unit_z_n2687_term = {3'h0, setup_bump_unit_x_n2216_s11} ^ {26{setup_bump_unit_z_n2683}};
    wire signed [25:0] setup_bump_unit_z_n2687 = {setup_bump_unit_z_n2686[24], setup_bump_unit_z_n2686} + setup_bump_unit_z_n2687_term + {25'h0, setup_bump_unit_z_n2683}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2688 = setup_bump_unit_z_n2687[23:0]; // s24f0
    wire setup_bump_unit_z_n2689 = setup_bump_unit_z_n2688[23]; // u1f0
    wire setup_bump_unit_z_n2690 = setup_bump_unit_z_n2689 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2691 = setup_bump_unit_z_n2688; // u24f0
    wire [24:0] setup_bump_unit_z_n2692 = {setup_bump_unit_z_n2691, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2693 = setup_bump_unit_z_n2692; // s25f0
    wire [1:0] setup_bump_unit_z_n2807 = {setup_bump_unit_z_n2676, setup_bump_unit_z_n2683}; // u2f0
    wire [2:0] setup_bump_unit_z_n2808 = {setup_bump_unit_z_n2807, setup_bump_unit_z_n2690}; // u3f0
    wire setup_bump_unit_z_n2827 = setup_bump_unit_z_n2666 | setup_bump_unit_x_n2414_s11; // u1f0

    reg [19:0] setup_light_length_n278_s12; // u20f0
    reg [22:0] setup_light_length_n282_s12; // u23f0
    reg [21:0] setup_light_length_n284_s12; // u22f0
    reg [1:0] setup_light_length_n293_s12; // u2f0
    reg [1:0] setup_light_length_n305_s12; // u2f0
    reg [1:0] setup_light_length_n317_s12; // u2f0
    reg [1:0] setup_light_length_n327_s12; // u2f0
    reg [20:0] setup_light_unit_x_n385_s12; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s12; // s25f0
    reg setup_light_unit_x_n396_s12; // u1f0
    reg setup_light_unit_x_n402_s12; // u1f0
    reg setup_light_unit_x_n555_s12; // u1f0
    reg setup_light_unit_x_n557_s12; // u1f0
    reg [20:0] setup_light_unit_y_n602_s12; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s12; // s25f0
    reg setup_light_unit_y_n617_s12; // u1f0
    reg setup_light_unit_y_n769_s12; // u1f0
    reg setup_light_unit_y_n771_s12; // u1f0
    reg [20:0] setup_light_unit_z_n816_s12; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s12; // s25f0
    reg setup_light_unit_z_n831_s12; // u1f0
    reg setup_light_unit_z_n983_s12; // u1f0
    reg setup_light_unit_z_n985_s12; // u1f0
    reg [19:0] setup_half_length_n1247_s12; // u20f0
    reg [22:0] setup_half_length_n1251_s12; // u23f0
    reg [21:0] setup_half_length_n1253_s12; // u22f0
    reg [1:0] setup_half_length_n1262_s12; // u2f0
    reg [1:0] setup_half_length_n1274_s12; // u2f0
    reg [1:0] setup_half_length_n1286_s12; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s12; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s12; // s25f0
    reg setup_half_unit_x_n1367_s12; // u1f0
    reg setup_half_unit_x_n1520_s12; // u1f0
    reg setup_half_unit_x_n1522_s12; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s12; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s12; // s25f0
    reg setup_half_unit_y_n1582_s12; // u1f0
    reg setup_half_unit_y_n1734_s12; // u1f0
    reg setup_half_unit_y_n1736_s12; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s12; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s12; // s25f0
    reg setup_half_unit_z_n1796_s12; // u1f0
    reg setup_half_unit_z_n1948_s12; // u1f0
    reg setup_half_unit_z_n1950_s12; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s12; // u23f0
    reg setup_bump_unit_x_n2277_s12; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2280_s12; // s25f0
    reg [2:0] setup_bump_unit_x_n2395_s12; // u3f0
    reg setup_bump_unit_x_n2415_s12; // u1f0
    reg setup_bump_unit_x_n2417_s12; // u1f0
    reg setup_bump_unit_x_n2419_s12; // u1f0
    reg setup_bump_unit_y_n2484_s12; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2487_s12; // s25f0
    reg [2:0] setup_bump_unit_y_n2602_s12; // u3f0
    reg setup_bump_unit_y_n2621_s12; // u1f0
    reg setup_bump_unit_y_n2623_s12; // u1f0
    reg setup_bump_unit_y_n2625_s12; // u1f0
    reg setup_bump_unit_z_n2690_s12; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2693_s12; // s25f0
    reg [2:0] setup_bump_unit_z_n2808_s12; // u3f0
    reg setup_bump_unit_z_n2827_s12; // u1f0
    reg setup_bump_unit_z_n2829_s12; // u1f0
    reg setup_bump_unit_z_n2831_s12; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n278_s12 <= setup_light_length_n278;
            setup_light_length_n282_s12 <= setup_light_length_n282;
            setup_light_length_n284_s12 <= setup_light_length_n284;
            setup_light_length_n293_s12 <= setup_light_length_n293_s11;
            setup_light_length_n305_s12 <= setup_light_length_n305_s11;
            setup_light_length_n317_s12 <= setup_light_length_n317_s11;
            setup_light_length_n327_s12 <= setup_light_length_n327_s11;
            setup_light_unit_x_n385_s12 <= setup_light_unit_x_n385_s11;
            setup_light_unit_x_n395_s12 <= setup_light_unit_x_n395_s11;
            setup_light_unit_x_n396_s12 <= setup_light_unit_x_n396_s11;
            setup_light_unit_x_n402_s12 <= setup_light_unit_x_n402_s11;
            setup_light_unit_x_n555_s12 <= setup_light_unit_x_n555_s11;
            setup_light_unit_x_n557_s12 <= setup_light_unit_x_n557_s11;
            setup_light_unit_y_n602_s12 <= setup_light_unit_y_n602_s11;
            setup_light_unit_y_n611_s12 <= setup_light_unit_y_n611_s11;
            setup_light_unit_y_n617_s12 <= setup_light_unit_y_n617_s11;
            setup_light_unit_y_n769_s12 <= setup_light_unit_y_n769_s11;
            setup_light_unit_y_n771_s12 <= setup_light_unit_y_n771_s11;
            setup_light_unit_z_n816_s12 <= setup_light_unit_z_n816_s11;
            setup_light_unit_z_n825_s12 <= setup_light_unit_z_n825_s11;
            setup_light_unit_z_n831_s12 <= setup_light_unit_z_n831_s11;
            setup_light_unit_z_n983_s12 <= setup_light_unit_z_n983_s11;
            setup_light_unit_z_n985_s12 <= setup_light_unit_z_n985_s11;
            setup_half_length_n1247_s12 <= setup_half_length_n1247;
            setup_half_length_n1251_s12 <= setup_half_length_n1251;
            setup_half_length_n1253_s12 <= setup_half_length_n1253;
            setup_half_length_n1262_s12 <= setup_half_length_n1262_s11;
            setup_half_length_n1274_s12 <= setup_half_length_n1274_s11;
            setup_half_length_n1286_s12 <= setup_half_length_n1286_s11;
            setup_half_unit_x_n1352_s12 <= setup_half_unit_x_n1352_s11;
            setup_half_unit_x_n1361_s12 <= setup_half_unit_x_n1361_s11;
            setup_half_unit_x_n1367_s12 <= setup_half_unit_x_n1367_s11;
            setup_half_unit_x_n1520_s12 <= setup_half_unit_x_n1520_s11;
            setup_half_unit_x_n1522_s12 <= setup_half_unit_x_n1522_s11;
            setup_half_unit_y_n1567_s12 <= setup_half_unit_y_n1567_s11;
            setup_half_unit_y_n1576_s12 <= setup_half_unit_y_n1576_s11;
            setup_half_unit_y_n1582_s12 <= setup_half_unit_y_n1582_s11;
            setup_half_unit_y_n1734_s12 <= setup_half_unit_y_n1734_s11;
            setup_half_unit_y_n1736_s12 <= setup_half_unit_y_n1736_s11;
            setup_half_unit_z_n1781_s12 <= setup_half_unit_z_n1781_s11;
            setup_half_unit_z_n1790_s12 <= setup_half_unit_z_n1790_s11;
            setup_half_unit_z_n1796_s12 <= setup_half_unit_z_n1796_s11;
            setup_half_unit_z_n1948_s12 <= setup_half_unit_z_n1948_s11;
            setup_half_unit_z_n1950_s12 <= setup_half_unit_z_n1950_s11;
            setup_bump_unit_x_n2216_s12 <= setup_bump_unit_x_n2216_s11;
            setup_bump_unit_x_n2277_s12 <= setup_bump_unit_x_n2277;
            setup_bump_unit_x_n2280_s12 <= setup_bump_unit_x_n2280;
            setup_bump_unit_x_n2395_s12 <= setup_bump_unit_x_n2395;
            setup_bump_unit_x_n2415_s12 <= setup_bump_unit_x_n2415;
            setup_bump_unit_x_n2417_s12 <= setup_bump_unit_x_n2417_s11;
            setup_bump_unit_x_n2419_s12 <= setup_bump_unit_x_n2419_s11;
            setup_bump_unit_y_n2484_s12 <= setup_bump_unit_y_n2484;
            setup_bump_unit_y_n2487_s12 <= setup_bump_unit_y_n2487;
            setup_bump_unit_y_n2602_s12 <= setup_bump_unit_y_n2602;
            setup_bump_unit_y_n2621_s12 <= setup_bump_unit_y_n2621;
            setup_bump_unit_y_n2623_s12 <= setup_bump_unit_y_n2623_s11;
            setup_bump_unit_y_n2625_s12 <= setup_bump_unit_y_n2625_s11;
            setup_bump_unit_z_n2690_s12 <= setup_bump_unit_z_n2690;
            setup_bump_unit_z_n2693_s12 <= setup_bump_unit_z_n2693;
            setup_bump_unit_z_n2808_s12 <= setup_bump_unit_z_n2808;
            setup_bump_unit_z_n2827_s12 <= setup_bump_unit_z_n2827;
            setup_bump_unit_z_n2829_s12 <= setup_bump_unit_z_n2829_s11;
            setup_bump_unit_z_n2831_s12 <= setup_bump_unit_z_n2831_s11;
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // setup.light.length
    wire signed [23:0] setup_light_length_n285 = {1'b0, setup_light_length_n282_s12} - {2'h0, setup_light_length_n284_s12}; // s24f0
    wire setup_light_length_n286 = setup_light_length_n285[23]; // u1f0
    wire signed [23:0] setup_light_length_n287 = setup_light_length_n286 ? {1'b0, setup_light_length_n282_s12} : setup_light_length_n285; // s24f0
    wire [21:0] setup_light_length_n288 = setup_light_length_n287[21:0]; // u22f0
    wire setup_light_length_n289 = setup_light_length_n286 ^ setup_light_length_n42; // u1f0
    wire [20:0] setup_light_length_n290 = {setup_light_length_n278_s12, setup_light_length_n289}; // u21f0
    wire [23:0] setup_light_length_n294 = {setup_light_length_n288, setup_light_length_n293_s12}; // u24f0
    wire [21:0] setup_light_length_n295 = {setup_light_length_n290, setup_light_length_n43}; // u22f0
    wire [22:0] setup_light_length_n296 = {setup_light_length_n295, setup_light_length_n42}; // u23f0
    wire signed [24:0] setup_light_length_n297 = {1'b0, setup_light_length_n294} - {2'h0, setup_light_length_n296}; // s25f0
    wire setup_light_length_n298 = setup_light_length_n297[24]; // u1f0
    wire signed [24:0] setup_light_length_n299 = setup_light_length_n298 ? {1'b0, setup_light_length_n294} : setup_light_length_n297; // s25f0
    wire [22:0] setup_light_length_n300 = setup_light_length_n299[22:0]; // u23f0
    wire setup_light_length_n301 = setup_light_length_n298 ^ setup_light_length_n42; // u1f0
    wire [21:0] setup_light_length_n302 = {setup_light_length_n290, setup_light_length_n301}; // u22f0
    wire [24:0] setup_light_length_n306 = {setup_light_length_n300, setup_light_length_n305_s12}; // u25f0
    wire [22:0] setup_light_length_n307 = {setup_light_length_n302, setup_light_length_n43}; // u23f0
    wire [23:0] setup_light_length_n308 = {setup_light_length_n307, setup_light_length_n42}; // u24f0
    // setup.half.length
    wire signed [23:0] setup_half_length_n1254 = {1'b0, setup_half_length_n1251_s12} - {2'h0, setup_half_length_n1253_s12}; // s24f0
    wire setup_half_length_n1255 = setup_half_length_n1254[23]; // u1f0
    wire signed [23:0] setup_half_length_n1256 = setup_half_length_n1255 ? {1'b0, setup_half_length_n1251_s12} : setup_half_length_n1254; // s24f0
    wire [21:0] setup_half_length_n1257 = setup_half_length_n1256[21:0]; // u22f0
    wire setup_half_length_n1258 = setup_half_length_n1255 ^ setup_light_length_n42; // u1f0
    wire [20:0] setup_half_length_n1259 = {setup_half_length_n1247_s12, setup_half_length_n1258}; // u21f0
    wire [23:0] setup_half_length_n1263 = {setup_half_length_n1257, setup_half_length_n1262_s12}; // u24f0
    wire [21:0] setup_half_length_n1264 = {setup_half_length_n1259, setup_light_length_n43}; // u22f0
    wire [22:0] setup_half_length_n1265 = {setup_half_length_n1264, setup_light_length_n42}; // u23f0
    wire signed [24:0] setup_half_length_n1266 = {1'b0, setup_half_length_n1263} - {2'h0, setup_half_length_n1265}; // s25f0
    wire setup_half_length_n1267 = setup_half_length_n1266[24]; // u1f0
    wire signed [24:0] setup_half_length_n1268 = setup_half_length_n1267 ? {1'b0, setup_half_length_n1263} : setup_half_length_n1266; // s25f0
    wire [22:0] setup_half_length_n1269 = setup_half_length_n1268[22:0]; // u23f0
    wire setup_half_length_n1270 = setup_half_length_n1267 ^ setup_light_length_n42; // u1f0
    wire [21:0] setup_half_length_n1271 = {setup_half_length_n1259, setup_half_length_n1270}; // u22f0
    wire [24:0] setup_half_length_n1275 = {setup_half_length_n1269, setup_half_length_n1274_s12}; // u25f0
    wire [22:0] setup_half_length_n1276 = {setup_half_length_n1271, setup_light_length_n43}; // u23f0
    wire [23:0] setup_half_length_n1277 = {setup_half_length_n1276, setup_light_length_n42}; // u24f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2281_term = {3'h0, setup_bump_unit_x_n2216_s12} ^ {26{setup_bump_unit_x_n2277_s12}};
    wire signed [25:0] setup_bump_unit_x_n2281 = {setup_bump_unit_x_n2280_s12[24], setup_bump_unit_x_n2280_s12} + setup_bump_unit_x_n2281_term + {25'h0, setup_bump_unit_x_n2277_s12}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2282 = setup_bump_unit_x_n2281[23:0]; // s24f0
    wire setup_bump_unit_x_n2283 = setup_bump_unit_x_n2282[23]; // u1f0
    wire setup_bump_unit_x_n2284 = setup_bump_unit_x_n2283 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2285 = setup_bump_unit_x_n2282; // u24f0
    wire [24:0] setup_bump_unit_x_n2286 = {setup_bump_unit_x_n2285, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2287 = setup_bump_unit_x_n2286; // s25f0
    wire [25:0] setup_bump_unit_x_n2288_term = {3'h0, setup_bump_unit_x_n2216_s12} ^ {26{setup_bump_unit_x_n2284}};
    wire signed [25:0] setup_bump_unit_x_n2288 = {setup_bump_unit_x_n2287[24], setup_bump_unit_x_n2287} + setup_bump_unit_x_n2288_term + {25'h0, setup_bump_unit_x_n2284}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2289 = setup_bump_unit_x_n2288[23:0]; // s24f0
    wire setup_bump_unit_x_n2290 = setup_bump_unit_x_n2289[23]; // u1f0
    wire setup_bump_unit_x_n2291 = setup_bump_unit_x_n2290 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2292 = setup_bump_unit_x_n2289; // u24f0
    wire [24:0] setup_bump_unit_x_n2293 = {setup_bump_unit_x_n2292, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2294 = setup_bump_unit_x_n2293; // s25f0
    wire [3:0] setup_bump_unit_x_n2396 = {setup_bump_unit_x_n2395_s12, setup_bump_unit_x_n2284}; // u4f0
    wire [4:0] setup_bump_unit_x_n2397 = {setup_bump_unit_x_n2396, setup_bump_unit_x_n2291}; // u5f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2488_term = {3'h0, setup_bump_unit_x_n2216_s12} ^ {26{setup_bump_unit_y_n2484_s12}};
    wire signed [25:0] setup_bump_unit_y_n2488 = {setup_bump_unit_y_n2487_s12[24], setup_bump_unit_y_n2487_s12} + setup_bump_unit_y_n2488_term + {25'h0, setup_bump_unit_y_n2484_s12}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2489 = setup_bump_unit_y_n2488[23:0]; // s24f0
    wire setup_bump_unit_y_n2490 = setup_bump_unit_y_n2489[23]; // u1f0
    wire setup_bump_unit_y_n2491 = setup_bump_unit_y_n2490 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2492 = setup_bump_unit_y_n2489; // u24f0
    wire [24:0] setup_bump_unit_y_n2493 = {setup_bump_unit_y_n2492, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2494 = setup_bump_unit_y_n2493; // s25f0
    wire [25:0] setup_bump_unit_y_n2495_term = {3'h0, setup_bump_unit_x_n2216_s12} ^ {26{setup_bump_unit_y_n2491}};
    wire signed [25:0] setup_bump_unit_y_n2495 = {setup_bump_unit_y_n2494[24], setup_bump_unit_y_n2494} + setup_bump_unit_y_n2495_term + {25'h0, setup_bump_unit_y_n2491}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2496 = setup_bump_unit_y_n2495[23:0]; // s24f0
    wire setup_bump_unit_y_n2497 = setup_bump_unit_y_n2496[23]; // u1f0
    wire setup_bump_unit_y_n2498 = setup_bump_unit_y_n2497 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2499 = setup_bump_unit_y_n2496; // u24f0
    wire [24:0] setup_bump_unit_y_n2500 = {setup_bump_unit_y_n2499, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2501 = setup_bump_unit_y_n2500; // s25f0
    wire [3:0] setup_bump_unit_y_n2603 = {setup_bump_unit_y_n2602_s12, setup_bump_unit_y_n2491}; // u4f0
    wire [4:0] setup_bump_unit_y_n2604 = {setup_bump_unit_y_n2603, setup_bump_unit_y_n2498}; // u5f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2694_term = {3'h0, setup_bump_unit_x_n2216_s12} ^ {26{setup_bump_unit_z_n2690_s12}};
    wire signed [25:0] setup_bump_unit_z_n2694 = {setup_bump_unit_z_n2693_s12[24], setup_bump_unit_z_n2693_s12} + setup_bump_unit_z_n2694_term + {25'h0, setup_bump_unit_z_n2690_s12}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2695 = setup_bump_unit_z_n2694[23:0]; // s24f0
    wire setup_bump_unit_z_n2696 = setup_bump_unit_z_n2695[23]; // u1f0
    wire setup_bump_unit_z_n2697 = setup_bump_unit_z_n2696 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2698 = setup_bump_unit_z_n2695; // u24f0
    wire [24:0] setup_bump_unit_z_n2699 = {setup_bump_unit_z_n2698, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2700 = setup_bump_unit_z_n2699; // s25f0
    wire [25:0] setup_bump_unit_z_n2701_term = {3'h0, setup_bump_unit_x_n2216_s12} ^ {26{setup_bump_unit_z_n2697}};
    wire signed [25:0] setup_bump_unit_z_n2701 = {setup_bump_unit_z_n2700[24], setup_bump_unit_z_n2700} + setup_bump_unit_z_n2701_term + {25'h0, setup_bump_unit_z_n2697}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2702 = setup_bump_unit_z_n2701[23:0]; // s24f0
    wire setup_bump_unit_z_n2703 = setup_bump_unit_z_n2702[23]; // u1f0
    wire setup_bump_unit_z_n2704 = setup_bump_unit_z_n2703 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2705 = setup_bump_unit_z_n2702; // u24f0
    wire [24:0] setup_bump_unit_z_n2706 = {setup_bump_unit_z_n2705, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2707 = setup_bump_unit_z_n2706; // s25f0
    wire [3:0] setup_bump_unit_z_n2809 = {setup_bump_unit_z_n2808_s12, setup_bump_unit_z_n2697}; // u4f0
    wire [4:0] setup_bump_unit_z_n2810 = {setup_bump_unit_z_n2809, setup_bump_unit_z_n2704}; // u5f0

    reg [21:0] setup_light_length_n302_s13; // u22f0
    reg [24:0] setup_light_length_n306_s13; // u25f0
    reg [23:0] setup_light_length_n308_s13; // u24f0
    reg [1:0] setup_light_length_n317_s13; // u2f0
    reg [1:0] setup_light_length_n327_s13; // u2f0
    reg [20:0] setup_light_unit_x_n385_s13; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s13; // s25f0
    reg setup_light_unit_x_n396_s13; // u1f0
    reg setup_light_unit_x_n402_s13; // u1f0
    reg setup_light_unit_x_n555_s13; // u1f0
    reg setup_light_unit_x_n557_s13; // u1f0
    reg [20:0] setup_light_unit_y_n602_s13; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s13; // s25f0
    reg setup_light_unit_y_n617_s13; // u1f0
    reg setup_light_unit_y_n769_s13; // u1f0
    reg setup_light_unit_y_n771_s13; // u1f0
    reg [20:0] setup_light_unit_z_n816_s13; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s13; // s25f0
    reg setup_light_unit_z_n831_s13; // u1f0
    reg setup_light_unit_z_n983_s13; // u1f0
    reg setup_light_unit_z_n985_s13; // u1f0
    reg [21:0] setup_half_length_n1271_s13; // u22f0
    reg [24:0] setup_half_length_n1275_s13; // u25f0
    reg [23:0] setup_half_length_n1277_s13; // u24f0
    reg [1:0] setup_half_length_n1286_s13; // u2f0
    reg [20:0] setup_half_unit_x_n1352_s13; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s13; // s25f0
    reg setup_half_unit_x_n1367_s13; // u1f0
    reg setup_half_unit_x_n1520_s13; // u1f0
    reg setup_half_unit_x_n1522_s13; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s13; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s13; // s25f0
    reg setup_half_unit_y_n1582_s13; // u1f0
    reg setup_half_unit_y_n1734_s13; // u1f0
    reg setup_half_unit_y_n1736_s13; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s13; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s13; // s25f0
    reg setup_half_unit_z_n1796_s13; // u1f0
    reg setup_half_unit_z_n1948_s13; // u1f0
    reg setup_half_unit_z_n1950_s13; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s13; // u23f0
    reg setup_bump_unit_x_n2291_s13; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2294_s13; // s25f0
    reg [4:0] setup_bump_unit_x_n2397_s13; // u5f0
    reg setup_bump_unit_x_n2415_s13; // u1f0
    reg setup_bump_unit_x_n2417_s13; // u1f0
    reg setup_bump_unit_x_n2419_s13; // u1f0
    reg setup_bump_unit_y_n2498_s13; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2501_s13; // s25f0
    reg [4:0] setup_bump_unit_y_n2604_s13; // u5f0
    reg setup_bump_unit_y_n2621_s13; // u1f0
    reg setup_bump_unit_y_n2623_s13; // u1f0
    reg setup_bump_unit_y_n2625_s13; // u1f0
    reg setup_bump_unit_z_n2704_s13; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2707_s13; // s25f0
    reg [4:0] setup_bump_unit_z_n2810_s13; // u5f0
    reg setup_bump_unit_z_n2827_s13; // u1f0
    reg setup_bump_unit_z_n2829_s13; // u1f0
    reg setup_bump_unit_z_n2831_s13; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n302_s13 <= setup_light_length_n302;
            setup_light_length_n306_s13 <= setup_light_length_n306;
            setup_light_length_n308_s13 <= setup_light_length_n308;
            setup_light_length_n317_s13 <= setup_light_length_n317_s12;
            setup_light_length_n327_s13 <= setup_light_length_n327_s12;
            setup_light_unit_x_n385_s13 <= setup_light_unit_x_n385_s12;
            setup_light_unit_x_n395_s13 <= setup_light_unit_x_n395_s12;
            setup_light_unit_x_n396_s13 <= setup_light_unit_x_n396_s12;
            setup_light_unit_x_n402_s13 <= setup_light_unit_x_n402_s12;
            setup_light_unit_x_n555_s13 <= setup_light_unit_x_n555_s12;
            setup_light_unit_x_n557_s13 <= setup_light_unit_x_n557_s12;
            setup_light_unit_y_n602_s13 <= setup_light_unit_y_n602_s12;
            setup_light_unit_y_n611_s13 <= setup_light_unit_y_n611_s12;
            setup_light_unit_y_n617_s13 <= setup_light_unit_y_n617_s12;
            setup_light_unit_y_n769_s13 <= setup_light_unit_y_n769_s12;
            setup_light_unit_y_n771_s13 <= setup_light_unit_y_n771_s12;
            setup_light_unit_z_n816_s13 <= setup_light_unit_z_n816_s12;
            setup_light_unit_z_n825_s13 <= setup_light_unit_z_n825_s12;
            setup_light_unit_z_n831_s13 <= setup_light_unit_z_n831_s12;
            setup_light_unit_z_n983_s13 <= setup_light_unit_z_n983_s12;
            setup_light_unit_z_n985_s13 <= setup_light_unit_z_n985_s12;
            setup_half_length_n1271_s13 <= setup_half_length_n1271;
            setup_half_length_n1275_s13 <= setup_half_length_n1275;
            setup_half_length_n1277_s13 <= setup_half_length_n1277;
            setup_half_length_n1286_s13 <= setup_half_length_n1286_s12;
            setup_half_unit_x_n1352_s13 <= setup_half_unit_x_n1352_s12;
            setup_half_unit_x_n1361_s13 <= setup_half_unit_x_n1361_s12;
            setup_half_unit_x_n1367_s13 <= setup_half_unit_x_n1367_s12;
            setup_half_unit_x_n1520_s13 <= setup_half_unit_x_n1520_s12;
            setup_half_unit_x_n1522_s13 <= setup_half_unit_x_n1522_s12;
            setup_half_unit_y_n1567_s13 <= setup_half_unit_y_n1567_s12;
            setup_half_unit_y_n1576_s13 <= setup_half_unit_y_n1576_s12;
            setup_half_unit_y_n1582_s13 <= setup_half_unit_y_n1582_s12;
            setup_half_unit_y_n1734_s13 <= setup_half_unit_y_n1734_s12;
            setup_half_unit_y_n1736_s13 <= setup_half_unit_y_n1736_s12;
            setup_half_unit_z_n1781_s13 <= setup_half_unit_z_n1781_s12;
            setup_half_unit_z_n1790_s13 <= setup_half_unit_z_n1790_s12;
            setup_half_unit_z_n1796_s13 <= setup_half_unit_z_n1796_s12;
            setup_half_unit_z_n1948_s13 <= setup_half_unit_z_n1948_s12;
            setup_half_unit_z_n1950_s13 <= setup_half_unit_z_n1950_s12;
            setup_bump_unit_x_n2216_s13 <= setup_bump_unit_x_n2216_s12;
            setup_bump_unit_x_n2291_s13 <= setup_bump_unit_x_n2291;
            setup_bump_unit_x_n2294_s13 <= setup_bump_unit_x_n2294;
            setup_bump_unit_x_n2397_s13 <= setup_bump_unit_x_n2397;
            setup_bump_unit_x_n2415_s13 <= setup_bump_unit_x_n2415_s12;
            setup_bump_unit_x_n2417_s13 <= setup_bump_unit_x_n2417_s12;
            setup_bump_unit_x_n2419_s13 <= setup_bump_unit_x_n2419_s12;
            setup_bump_unit_y_n2498_s13 <= setup_bump_unit_y_n2498;
            setup_bump_unit_y_n2501_s13 <= setup_bump_unit_y_n2501;
            setup_bump_unit_y_n2604_s13 <= setup_bump_unit_y_n2604;
            setup_bump_unit_y_n2621_s13 <= setup_bump_unit_y_n2621_s12;
            setup_bump_unit_y_n2623_s13 <= setup_bump_unit_y_n2623_s12;
            setup_bump_unit_y_n2625_s13 <= setup_bump_unit_y_n2625_s12;
            setup_bump_unit_z_n2704_s13 <= setup_bump_unit_z_n2704;
            setup_bump_unit_z_n2707_s13 <= setup_bump_unit_z_n2707;
            setup_bump_unit_z_n2810_s13 <= setup_bump_unit_z_n2810;
            setup_bump_unit_z_n2827_s13 <= setup_bump_unit_z_n2827_s12;
            setup_bump_unit_z_n2829_s13 <= setup_bump_unit_z_n2829_s12;
            setup_bump_unit_z_n2831_s13 <= setup_bump_unit_z_n2831_s12;
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // setup.light.length
    wire signed [25:0] setup_light_length_n309 = {1'b0, setup_light_length_n306_s13} - {2'h0, setup_light_length_n308_s13}; // s26f0
    wire setup_light_length_n310 = setup_light_length_n309[25]; // u1f0
    wire signed [25:0] setup_light_length_n311 = setup_light_length_n310 ? {1'b0, setup_light_length_n306_s13} : setup_light_length_n309; // s26f0
    wire [23:0] setup_light_length_n312 = setup_light_length_n311[23:0]; // u24f0
    wire setup_light_length_n313 = setup_light_length_n310 ^ setup_light_length_n42; // u1f0
    wire [22:0] setup_light_length_n314 = {setup_light_length_n302_s13, setup_light_length_n313}; // u23f0
    wire [25:0] setup_light_length_n318 = {setup_light_length_n312, setup_light_length_n317_s13}; // u26f0
    wire [23:0] setup_light_length_n319 = {setup_light_length_n314, setup_light_length_n43}; // u24f0
    wire [24:0] setup_light_length_n320 = {setup_light_length_n319, setup_light_length_n42}; // u25f0
    wire signed [26:0] setup_light_length_n321 = {1'b0, setup_light_length_n318} - {2'h0, setup_light_length_n320}; // s27f0
    wire setup_light_length_n322 = setup_light_length_n321[26]; // u1f0
    wire signed [26:0] setup_light_length_n323 = setup_light_length_n322 ? {1'b0, setup_light_length_n318} : setup_light_length_n321; // s27f0
    wire [24:0] setup_light_length_n324 = setup_light_length_n323[24:0]; // u25f0
    wire setup_light_length_n325 = setup_light_length_n322 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_length_n326 = {setup_light_length_n314, setup_light_length_n325}; // u24f0
    wire [26:0] setup_light_length_n328 = {setup_light_length_n324, setup_light_length_n327_s13}; // u27f0
    wire [24:0] setup_light_length_n329 = {setup_light_length_n326, setup_light_length_n43}; // u25f0
    wire [25:0] setup_light_length_n330 = {setup_light_length_n329, setup_light_length_n42}; // u26f0
    // setup.half.length
    wire signed [25:0] setup_half_length_n1278 = {1'b0, setup_half_length_n1275_s13} - {2'h0, setup_half_length_n1277_s13}; // s26f0
    wire setup_half_length_n1279 = setup_half_length_n1278[25]; // u1f0
    wire signed [25:0] setup_half_length_n1280 = setup_half_length_n1279 ? {1'b0, setup_half_length_n1275_s13} : setup_half_length_n1278; // s26f0
    wire [23:0] setup_half_length_n1281 = setup_half_length_n1280[23:0]; // u24f0
    wire setup_half_length_n1282 = setup_half_length_n1279 ^ setup_light_length_n42; // u1f0
    wire [22:0] setup_half_length_n1283 = {setup_half_length_n1271_s13, setup_half_length_n1282}; // u23f0
    wire [25:0] setup_half_length_n1287 = {setup_half_length_n1281, setup_half_length_n1286_s13}; // u26f0
    wire [23:0] setup_half_length_n1288 = {setup_half_length_n1283, setup_light_length_n43}; // u24f0
    wire [24:0] setup_half_length_n1289 = {setup_half_length_n1288, setup_light_length_n42}; // u25f0
    wire signed [26:0] setup_half_length_n1290 = {1'b0, setup_half_length_n1287} - {2'h0, setup_half_length_n1289}; // s27f0
    wire setup_half_length_n1291 = setup_half_length_n1290[26]; // u1f0
    wire signed [26:0] setup_half_length_n1292 = setup_half_length_n1291 ? {1'b0, setup_half_length_n1287} : setup_half_length_n1290; // s27f0
    wire [24:0] setup_half_length_n1293 = setup_half_length_n1292[24:0]; // u25f0
    wire setup_half_length_n1294 = setup_half_length_n1291 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_length_n1295 = {setup_half_length_n1283, setup_half_length_n1294}; // u24f0
    wire [26:0] setup_half_length_n1296 = {setup_half_length_n1293, setup_light_length_n327_s13}; // u27f0
    wire [24:0] setup_half_length_n1297 = {setup_half_length_n1295, setup_light_length_n43}; // u25f0
    wire [25:0] setup_half_length_n1298 = {setup_half_length_n1297, setup_light_length_n42}; // u26f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2295_term = {3'h0, setup_bump_unit_x_n2216_s13} ^ {26{setup_bump_unit_x_n2291_s13}};
    wire signed [25:0] setup_bump_unit_x_n2295 = {setup_bump_unit_x_n2294_s13[24], setup_bump_unit_x_n2294_s13} + setup_bump_unit_x_n2295_term + {25'h0, setup_bump_unit_x_n2291_s13}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2296 = setup_bump_unit_x_n2295[23:0]; // s24f0
    wire setup_bump_unit_x_n2297 = setup_bump_unit_x_n2296[23]; // u1f0
    wire setup_bump_unit_x_n2298 = setup_bump_unit_x_n2297 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2299 = setup_bump_unit_x_n2296; // u24f0
    wire [24:0] setup_bump_unit_x_n2300 = {setup_bump_unit_x_n2299, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2301 = setup_bump_unit_x_n2300; // s25f0
    wire [25:0] setup_bump_unit_x_n2302_term = {3'h0, setup_bump_unit_x_n2216_s13} ^ {26{setup_bump_unit_x_n2298}};
    wire signed [25:0] setup_bump_unit_x_n2302 = {setup_bump_unit_x_n2301[24], setup_bump_unit_x_n2301} + setup_bump_unit_x_n2302_term + {25'h0, setup_bump_unit_x_n2298}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2303 = setup_bump_unit_x_n2302[23:0]; // s24f0
    wire setup_bump_unit_x_n2304 = setup_bump_unit_x_n2303[23]; // u1f0
    wire setup_bump_unit_x_n2305 = setup_bump_unit_x_n2304 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2306 = setup_bump_unit_x_n2303; // u24f0
    wire [24:0] setup_bump_unit_x_n2307 = {setup_bump_unit_x_n2306, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2308 = setup_bump_unit_x_n2307; // s25f0
    wire [5:0] setup_bump_unit_x_n2398 = {setup_bump_unit_x_n2397_s13, setup_bump_unit_x_n2298}; // u6f0
    wire [6:0] setup_bump_unit_x_n2399 = {setup_bump_unit_x_n2398, setup_bump_unit_x_n2305}; // u7f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2502_term = {3'h0, setup_bump_unit_x_n2216_s13} ^ {26{setup_bump_unit_y_n2498_s13}};
    wire signed [25:0] setup_bump_unit_y_n2502 = {setup_bump_unit_y_n2501_s13[24], setup_bump_unit_y_n2501_s13} + setup_bump_unit_y_n2502_term + {25'h0, setup_bump_unit_y_n2498_s13}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2503 = setup_bump_unit_y_n2502[23:0]; // s24f0
    wire setup_bump_unit_y_n2504 = setup_bump_unit_y_n2503[23]; // u1f0
    wire setup_bump_unit_y_n2505 = setup_bump_unit_y_n2504 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2506 = setup_bump_unit_y_n2503; // u24f0
    wire [24:0] setup_bump_unit_y_n2507 = {setup_bump_unit_y_n2506, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2508 = setup_bump_unit_y_n2507; // s25f0
    wire [25:0] setup_bump_unit_y_n2509_term = {3'h0, setup_bump_unit_x_n2216_s13} ^ {26{setup_bump_unit_y_n2505}};
    wire signed [25:0] setup_bump_unit_y_n2509 = {setup_bump_unit_y_n2508[24], setup_bump_unit_y_n2508} + setup_bump_unit_y_n2509_term + {25'h0, setup_bump_unit_y_n2505}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2510 = setup_bump_unit_y_n2509[23:0]; // s24f0
    wire setup_bump_unit_y_n2511 = setup_bump_unit_y_n2510[23]; // u1f0
    wire setup_bump_unit_y_n2512 = setup_bump_unit_y_n2511 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2513 = setup_bump_unit_y_n2510; // u24f0
    wire [24:0] setup_bump_unit_y_n2514 = {setup_bump_unit_y_n2513, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2515 = setup_bump_unit_y_n2514; // s25f0
    wire [5:0] setup_bump_unit_y_n2605 = {setup_bump_unit_y_n2604_s13, setup_bump_unit_y_n2505}; // u6f0
    wire [6:0] setup_bump_unit_y_n2606 = {setup_bump_unit_y_n2605, setup_bump_unit_y_n2512}; // u7f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2708_term = {3'h0, setup_bump_unit_x_n2216_s13} ^ {26{setup_bump_unit_z_n2704_s13}};
    wire signed [25:0] setup_bump_unit_z_n2708 = {setup_bump_unit_z_n2707_s13[24], setup_bump_unit_z_n2707_s13} + setup_bump_unit_z_n2708_term + {25'h0, setup_bump_unit_z_n2704_s13}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2709 = setup_bump_unit_z_n2708[23:0]; // s24f0
    wire setup_bump_unit_z_n2710 = setup_bump_unit_z_n2709[23]; // u1f0
    wire setup_bump_unit_z_n2711 = setup_bump_unit_z_n2710 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2712 = setup_bump_unit_z_n2709; // u24f0
    wire [24:0] setup_bump_unit_z_n2713 = {setup_bump_unit_z_n2712, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2714 = setup_bump_unit_z_n2713; // s25f0
    wire [25:0] setup_bump_unit_z_n2715_term = {3'h0, setup_bump_unit_x_n2216_s13} ^ {26{setup_bump_unit_z_n2711}};
    wire signed [25:0] setup_bump_unit_z_n2715 = {setup_bump_unit_z_n2714[24], setup_bump_unit_z_n2714} + setup_bump_unit_z_n2715_term + {25'h0, setup_bump_unit_z_n2711}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2716 = setup_bump_unit_z_n2715[23:0]; // s24f0
    wire setup_bump_unit_z_n2717 = setup_bump_unit_z_n2716[23]; // u1f0
    wire setup_bump_unit_z_n2718 = setup_bump_unit_z_n2717 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2719 = setup_bump_unit_z_n2716; // u24f0
    wire [24:0] setup_bump_unit_z_n2720 = {setup_bump_unit_z_n2719, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2721 = setup_bump_unit_z_n2720; // s25f0
    wire [5:0] setup_bump_unit_z_n2811 = {setup_bump_unit_z_n2810_s13, setup_bump_unit_z_n2711}; // u6f0
    wire [6:0] setup_bump_unit_z_n2812 = {setup_bump_unit_z_n2811, setup_bump_unit_z_n2718}; // u7f0

    reg [23:0] setup_light_length_n326_s14; // u24f0
    reg [26:0] setup_light_length_n328_s14; // u27f0
    reg [25:0] setup_light_length_n330_s14; // u26f0
    reg [20:0] setup_light_unit_x_n385_s14; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s14; // s25f0
    reg setup_light_unit_x_n396_s14; // u1f0
    reg setup_light_unit_x_n402_s14; // u1f0
    reg setup_light_unit_x_n555_s14; // u1f0
    reg setup_light_unit_x_n557_s14; // u1f0
    reg [20:0] setup_light_unit_y_n602_s14; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s14; // s25f0
    reg setup_light_unit_y_n617_s14; // u1f0
    reg setup_light_unit_y_n769_s14; // u1f0
    reg setup_light_unit_y_n771_s14; // u1f0
    reg [20:0] setup_light_unit_z_n816_s14; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s14; // s25f0
    reg setup_light_unit_z_n831_s14; // u1f0
    reg setup_light_unit_z_n983_s14; // u1f0
    reg setup_light_unit_z_n985_s14; // u1f0
    reg [23:0] setup_half_length_n1295_s14; // u24f0
    reg [26:0] setup_half_length_n1296_s14; // u27f0
    reg [25:0] setup_half_length_n1298_s14; // u26f0
    reg [20:0] setup_half_unit_x_n1352_s14; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s14; // s25f0
    reg setup_half_unit_x_n1367_s14; // u1f0
    reg setup_half_unit_x_n1520_s14; // u1f0
    reg setup_half_unit_x_n1522_s14; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s14; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s14; // s25f0
    reg setup_half_unit_y_n1582_s14; // u1f0
    reg setup_half_unit_y_n1734_s14; // u1f0
    reg setup_half_unit_y_n1736_s14; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s14; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s14; // s25f0
    reg setup_half_unit_z_n1796_s14; // u1f0
    reg setup_half_unit_z_n1948_s14; // u1f0
    reg setup_half_unit_z_n1950_s14; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s14; // u23f0
    reg setup_bump_unit_x_n2305_s14; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2308_s14; // s25f0
    reg [6:0] setup_bump_unit_x_n2399_s14; // u7f0
    reg setup_bump_unit_x_n2415_s14; // u1f0
    reg setup_bump_unit_x_n2417_s14; // u1f0
    reg setup_bump_unit_x_n2419_s14; // u1f0
    reg setup_bump_unit_y_n2512_s14; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2515_s14; // s25f0
    reg [6:0] setup_bump_unit_y_n2606_s14; // u7f0
    reg setup_bump_unit_y_n2621_s14; // u1f0
    reg setup_bump_unit_y_n2623_s14; // u1f0
    reg setup_bump_unit_y_n2625_s14; // u1f0
    reg setup_bump_unit_z_n2718_s14; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2721_s14; // s25f0
    reg [6:0] setup_bump_unit_z_n2812_s14; // u7f0
    reg setup_bump_unit_z_n2827_s14; // u1f0
    reg setup_bump_unit_z_n2829_s14; // u1f0
    reg setup_bump_unit_z_n2831_s14; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n326_s14 <= setup_light_length_n326;
            setup_light_length_n328_s14 <= setup_light_length_n328;
            setup_light_length_n330_s14 <= setup_light_length_n330;
            setup_light_unit_x_n385_s14 <= setup_light_unit_x_n385_s13;
            setup_light_unit_x_n395_s14 <= setup_light_unit_x_n395_s13;
            setup_light_unit_x_n396_s14 <= setup_light_unit_x_n396_s13;
            setup_light_unit_x_n402_s14 <= setup_light_unit_x_n402_s13;
            setup_light_unit_x_n555_s14 <= setup_light_unit_x_n555_s13;
            setup_light_unit_x_n557_s14 <= setup_light_unit_x_n557_s13;
            setup_light_unit_y_n602_s14 <= setup_light_unit_y_n602_s13;
            setup_light_unit_y_n611_s14 <= setup_light_unit_y_n611_s13;
            setup_light_unit_y_n617_s14 <= setup_light_unit_y_n617_s13;
            setup_light_unit_y_n769_s14 <= setup_light_unit_y_n769_s13;
            setup_light_unit_y_n771_s14 <= setup_light_unit_y_n771_s13;
            setup_light_unit_z_n816_s14 <= setup_light_unit_z_n816_s13;
            setup_light_unit_z_n825_s14 <= setup_light_unit_z_n825_s13;
            setup_light_unit_z_n831_s14 <= setup_light_unit_z_n831_s13;
            setup_light_unit_z_n983_s14 <= setup_light_unit_z_n983_s13;
            setup_light_unit_z_n985_s14 <= setup_light_unit_z_n985_s13;
            setup_half_length_n1295_s14 <= setup_half_length_n1295;
            setup_half_length_n1296_s14 <= setup_half_length_n1296;
            setup_half_length_n1298_s14 <= setup_half_length_n1298;
            setup_half_unit_x_n1352_s14 <= setup_half_unit_x_n1352_s13;
            setup_half_unit_x_n1361_s14 <= setup_half_unit_x_n1361_s13;
            setup_half_unit_x_n1367_s14 <= setup_half_unit_x_n1367_s13;
            setup_half_unit_x_n1520_s14 <= setup_half_unit_x_n1520_s13;
            setup_half_unit_x_n1522_s14 <= setup_half_unit_x_n1522_s13;
            setup_half_unit_y_n1567_s14 <= setup_half_unit_y_n1567_s13;
            setup_half_unit_y_n1576_s14 <= setup_half_unit_y_n1576_s13;
            setup_half_unit_y_n1582_s14 <= setup_half_unit_y_n1582_s13;
            setup_half_unit_y_n1734_s14 <= setup_half_unit_y_n1734_s13;
            setup_half_unit_y_n1736_s14 <= setup_half_unit_y_n1736_s13;
            setup_half_unit_z_n1781_s14 <= setup_half_unit_z_n1781_s13;
            setup_half_unit_z_n1790_s14 <= setup_half_unit_z_n1790_s13;
            setup_half_unit_z_n1796_s14 <= setup_half_unit_z_n1796_s13;
            setup_half_unit_z_n1948_s14 <= setup_half_unit_z_n1948_s13;
            setup_half_unit_z_n1950_s14 <= setup_half_unit_z_n1950_s13;
            setup_bump_unit_x_n2216_s14 <= setup_bump_unit_x_n2216_s13;
            setup_bump_unit_x_n2305_s14 <= setup_bump_unit_x_n2305;
            setup_bump_unit_x_n2308_s14 <= setup_bump_unit_x_n2308;
            setup_bump_unit_x_n2399_s14 <= setup_bump_unit_x_n2399;
            setup_bump_unit_x_n2415_s14 <= setup_bump_unit_x_n2415_s13;
            setup_bump_unit_x_n2417_s14 <= setup_bump_unit_x_n2417_s13;
            setup_bump_unit_x_n2419_s14 <= setup_bump_unit_x_n2419_s13;
            setup_bump_unit_y_n2512_s14 <= setup_bump_unit_y_n2512;
            setup_bump_unit_y_n2515_s14 <= setup_bump_unit_y_n2515;
            setup_bump_unit_y_n2606_s14 <= setup_bump_unit_y_n2606;
            setup_bump_unit_y_n2621_s14 <= setup_bump_unit_y_n2621_s13;
            setup_bump_unit_y_n2623_s14 <= setup_bump_unit_y_n2623_s13;
            setup_bump_unit_y_n2625_s14 <= setup_bump_unit_y_n2625_s13;
            setup_bump_unit_z_n2718_s14 <= setup_bump_unit_z_n2718;
            setup_bump_unit_z_n2721_s14 <= setup_bump_unit_z_n2721;
            setup_bump_unit_z_n2812_s14 <= setup_bump_unit_z_n2812;
            setup_bump_unit_z_n2827_s14 <= setup_bump_unit_z_n2827_s13;
            setup_bump_unit_z_n2829_s14 <= setup_bump_unit_z_n2829_s13;
            setup_bump_unit_z_n2831_s14 <= setup_bump_unit_z_n2831_s13;
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // setup.light.length
    wire signed [27:0] setup_light_length_n331 = {1'b0, setup_light_length_n328_s14} - {2'h0, setup_light_length_n330_s14}; // s28f0
    wire setup_light_length_n332 = setup_light_length_n331[27]; // u1f0
    wire signed [27:0] setup_light_length_n333 = setup_light_length_n332 ? {1'b0, setup_light_length_n328_s14} : setup_light_length_n331; // s28f0
    wire [25:0] setup_light_length_n334 = setup_light_length_n333[25:0]; // u26f0
    wire setup_light_length_n335 = setup_light_length_n332 ^ setup_light_length_n42; // u1f0
    wire [24:0] setup_light_length_n336 = {setup_light_length_n326_s14, setup_light_length_n335}; // u25f0
    wire setup_light_length_n337 = setup_light_length_n334 == {25'h0, setup_light_length_n43}; // u1f0
    wire setup_light_length_n338 = setup_light_length_n337 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_light_length_n339 = {setup_light_length_n336, setup_light_length_n338}; // u26f0
    wire [5:-20] setup_light_length_n340 = setup_light_length_n339; // u26f20
    // setup.half.length
    wire signed [27:0] setup_half_length_n1299 = {1'b0, setup_half_length_n1296_s14} - {2'h0, setup_half_length_n1298_s14}; // s28f0
    wire setup_half_length_n1300 = setup_half_length_n1299[27]; // u1f0
    wire signed [27:0] setup_half_length_n1301 = setup_half_length_n1300 ? {1'b0, setup_half_length_n1296_s14} : setup_half_length_n1299; // s28f0
    wire [25:0] setup_half_length_n1302 = setup_half_length_n1301[25:0]; // u26f0
    wire setup_half_length_n1303 = setup_half_length_n1300 ^ setup_light_length_n42; // u1f0
    wire [24:0] setup_half_length_n1304 = {setup_half_length_n1295_s14, setup_half_length_n1303}; // u25f0
    wire setup_half_length_n1305 = setup_half_length_n1302 == {25'h0, setup_light_length_n43}; // u1f0
    wire setup_half_length_n1306 = setup_half_length_n1305 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_half_length_n1307 = {setup_half_length_n1304, setup_half_length_n1306}; // u26f0
    wire [5:-20] setup_half_length_n1308 = setup_half_length_n1307; // u26f20
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2309_term = {3'h0, setup_bump_unit_x_n2216_s14} ^ {26{setup_bump_unit_x_n2305_s14}};
    wire signed [25:0] setup_bump_unit_x_n2309 = {setup_bump_unit_x_n2308_s14[24], setup_bump_unit_x_n2308_s14} + setup_bump_unit_x_n2309_term + {25'h0, setup_bump_unit_x_n2305_s14}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2310 = setup_bump_unit_x_n2309[23:0]; // s24f0
    wire setup_bump_unit_x_n2311 = setup_bump_unit_x_n2310[23]; // u1f0
    wire setup_bump_unit_x_n2312 = setup_bump_unit_x_n2311 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2313 = setup_bump_unit_x_n2310; // u24f0
    wire [24:0] setup_bump_unit_x_n2314 = {setup_bump_unit_x_n2313, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2315 = setup_bump_unit_x_n2314; // s25f0
    wire [25:0] setup_bump_unit_x_n2316_term = {3'h0, setup_bump_unit_x_n2216_s14} ^ {26{setup_bump_unit_x_n2312}};
    wire signed [25:0] setup_bump_unit_x_n2316 = {setup_bump_unit_x_n2315[24], setup_bump_unit_x_n2315} + setup_bump_unit_x_n2316_term + {25'h0, setup_bump_unit_x_n2312}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2317 = setup_bump_unit_x_n2316[23:0]; // s24f0
    wire setup_bump_unit_x_n2318 = setup_bump_unit_x_n2317[23]; // u1f0
    wire setup_bump_unit_x_n2319 = setup_bump_unit_x_n2318 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2320 = setup_bump_unit_x_n2317; // u24f0
    wire [24:0] setup_bump_unit_x_n2321 = {setup_bump_unit_x_n2320, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2322 = setup_bump_unit_x_n2321; // s25f0
    wire [7:0] setup_bump_unit_x_n2400 = {setup_bump_unit_x_n2399_s14, setup_bump_unit_x_n2312}; // u8f0
    wire [8:0] setup_bump_unit_x_n2401 = {setup_bump_unit_x_n2400, setup_bump_unit_x_n2319}; // u9f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2516_term = {3'h0, setup_bump_unit_x_n2216_s14} ^ {26{setup_bump_unit_y_n2512_s14}};
    wire signed [25:0] setup_bump_unit_y_n2516 = {setup_bump_unit_y_n2515_s14[24], setup_bump_unit_y_n2515_s14} + setup_bump_unit_y_n2516_term + {25'h0, setup_bump_unit_y_n2512_s14}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2517 = setup_bump_unit_y_n2516[23:0]; // s24f0
    wire setup_bump_unit_y_n2518 = setup_bump_unit_y_n2517[23]; // u1f0
    wire setup_bump_unit_y_n2519 = setup_bump_unit_y_n2518 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2520 = setup_bump_unit_y_n2517; // u24f0
    wire [24:0] setup_bump_unit_y_n2521 = {setup_bump_unit_y_n2520, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2522 = setup_bump_unit_y_n2521; // s25f0
    wire [25:0] setup_bump_unit_y_n2523_term = {3'h0, setup_bump_unit_x_n2216_s14} ^ {26{setup_bump_unit_y_n2519}};
    wire signed [25:0] setup_bump_unit_y_n2523 = {setup_bump_unit_y_n2522[24], setup_bump_unit_y_n2522} + setup_bump_unit_y_n2523_term + {25'h0, setup_bump_unit_y_n2519}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2524 = setup_bump_unit_y_n2523[23:0]; // s24f0
    wire setup_bump_unit_y_n2525 = setup_bump_unit_y_n2524[23]; // u1f0
    wire setup_bump_unit_y_n2526 = setup_bump_unit_y_n2525 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2527 = setup_bump_unit_y_n2524; // u24f0
    wire [24:0] setup_bump_unit_y_n2528 = {setup_bump_unit_y_n2527, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2529 = setup_bump_unit_y_n2528; // s25f0
    wire [7:0] setup_bump_unit_y_n2607 = {setup_bump_unit_y_n2606_s14, setup_bump_unit_y_n2519}; // u8f0
    wire [8:0] setup_bump_unit_y_n2608 = {setup_bump_unit_y_n2607, setup_bump_unit_y_n2526}; // u9f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2722_term = {3'h0, setup_bump_unit_x_n2216_s14} ^ {26{setup_bump_unit_z_n2718_s14}};
    wire signed [25:0] setup_bump_unit_z_n2722 = {setup_bump_unit_z_n2721_s14[24], setup_bump_unit_z_n2721_s14} + setup_bump_unit_z_n2722_term + {25'h0, setup_bump_unit_z_n2718_s14}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2723 = setup_bump_unit_z_n2722[23:0]; // s24f0
    wire setup_bump_unit_z_n2724 = setup_bump_unit_z_n2723[23]; // u1f0
    wire setup_bump_unit_z_n2725 = setup_bump_unit_z_n2724 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2726 = setup_bump_unit_z_n2723; // u24f0
    wire [24:0] setup_bump_unit_z_n2727 = {setup_bump_unit_z_n2726, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2728 = setup_bump_unit_z_n2727; // s25f0
    wire [25:0] setup_bump_unit_z_n2729_term = {3'h0, setup_bump_unit_x_n2216_s14} ^ {26{setup_bump_unit_z_n2725}};
    wire signed [25:0] setup_bump_unit_z_n2729 = {setup_bump_unit_z_n2728[24], setup_bump_unit_z_n2728} + setup_bump_unit_z_n2729_term + {25'h0, setup_bump_unit_z_n2725}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2730 = setup_bump_unit_z_n2729[23:0]; // s24f0
    wire setup_bump_unit_z_n2731 = setup_bump_unit_z_n2730[23]; // u1f0
    wire setup_bump_unit_z_n2732 = setup_bump_unit_z_n2731 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2733 = setup_bump_unit_z_n2730; // u24f0
    wire [24:0] setup_bump_unit_z_n2734 = {setup_bump_unit_z_n2733, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2735 = setup_bump_unit_z_n2734; // s25f0
    wire [7:0] setup_bump_unit_z_n2813 = {setup_bump_unit_z_n2812_s14, setup_bump_unit_z_n2725}; // u8f0
    wire [8:0] setup_bump_unit_z_n2814 = {setup_bump_unit_z_n2813, setup_bump_unit_z_n2732}; // u9f0

    reg [5:-20] setup_light_length_n340_s15; // u26f20
    reg [20:0] setup_light_unit_x_n385_s15; // u21f0
    reg signed [24:0] setup_light_unit_x_n395_s15; // s25f0
    reg setup_light_unit_x_n396_s15; // u1f0
    reg setup_light_unit_x_n402_s15; // u1f0
    reg setup_light_unit_x_n555_s15; // u1f0
    reg setup_light_unit_x_n557_s15; // u1f0
    reg [20:0] setup_light_unit_y_n602_s15; // u21f0
    reg signed [24:0] setup_light_unit_y_n611_s15; // s25f0
    reg setup_light_unit_y_n617_s15; // u1f0
    reg setup_light_unit_y_n769_s15; // u1f0
    reg setup_light_unit_y_n771_s15; // u1f0
    reg [20:0] setup_light_unit_z_n816_s15; // u21f0
    reg signed [24:0] setup_light_unit_z_n825_s15; // s25f0
    reg setup_light_unit_z_n831_s15; // u1f0
    reg setup_light_unit_z_n983_s15; // u1f0
    reg setup_light_unit_z_n985_s15; // u1f0
    reg [5:-20] setup_half_length_n1308_s15; // u26f20
    reg [20:0] setup_half_unit_x_n1352_s15; // u21f0
    reg signed [24:0] setup_half_unit_x_n1361_s15; // s25f0
    reg setup_half_unit_x_n1367_s15; // u1f0
    reg setup_half_unit_x_n1520_s15; // u1f0
    reg setup_half_unit_x_n1522_s15; // u1f0
    reg [20:0] setup_half_unit_y_n1567_s15; // u21f0
    reg signed [24:0] setup_half_unit_y_n1576_s15; // s25f0
    reg setup_half_unit_y_n1582_s15; // u1f0
    reg setup_half_unit_y_n1734_s15; // u1f0
    reg setup_half_unit_y_n1736_s15; // u1f0
    reg [20:0] setup_half_unit_z_n1781_s15; // u21f0
    reg signed [24:0] setup_half_unit_z_n1790_s15; // s25f0
    reg setup_half_unit_z_n1796_s15; // u1f0
    reg setup_half_unit_z_n1948_s15; // u1f0
    reg setup_half_unit_z_n1950_s15; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s15; // u23f0
    reg setup_bump_unit_x_n2319_s15; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2322_s15; // s25f0
    reg [8:0] setup_bump_unit_x_n2401_s15; // u9f0
    reg setup_bump_unit_x_n2415_s15; // u1f0
    reg setup_bump_unit_x_n2417_s15; // u1f0
    reg setup_bump_unit_x_n2419_s15; // u1f0
    reg setup_bump_unit_y_n2526_s15; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2529_s15; // s25f0
    reg [8:0] setup_bump_unit_y_n2608_s15; // u9f0
    reg setup_bump_unit_y_n2621_s15; // u1f0
    reg setup_bump_unit_y_n2623_s15; // u1f0
    reg setup_bump_unit_y_n2625_s15; // u1f0
    reg setup_bump_unit_z_n2732_s15; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2735_s15; // s25f0
    reg [8:0] setup_bump_unit_z_n2814_s15; // u9f0
    reg setup_bump_unit_z_n2827_s15; // u1f0
    reg setup_bump_unit_z_n2829_s15; // u1f0
    reg setup_bump_unit_z_n2831_s15; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_length_n340_s15 <= setup_light_length_n340;
            setup_light_unit_x_n385_s15 <= setup_light_unit_x_n385_s14;
            setup_light_unit_x_n395_s15 <= setup_light_unit_x_n395_s14;
            setup_light_unit_x_n396_s15 <= setup_light_unit_x_n396_s14;
            setup_light_unit_x_n402_s15 <= setup_light_unit_x_n402_s14;
            setup_light_unit_x_n555_s15 <= setup_light_unit_x_n555_s14;
            setup_light_unit_x_n557_s15 <= setup_light_unit_x_n557_s14;
            setup_light_unit_y_n602_s15 <= setup_light_unit_y_n602_s14;
            setup_light_unit_y_n611_s15 <= setup_light_unit_y_n611_s14;
            setup_light_unit_y_n617_s15 <= setup_light_unit_y_n617_s14;
            setup_light_unit_y_n769_s15 <= setup_light_unit_y_n769_s14;
            setup_light_unit_y_n771_s15 <= setup_light_unit_y_n771_s14;
            setup_light_unit_z_n816_s15 <= setup_light_unit_z_n816_s14;
            setup_light_unit_z_n825_s15 <= setup_light_unit_z_n825_s14;
            setup_light_unit_z_n831_s15 <= setup_light_unit_z_n831_s14;
            setup_light_unit_z_n983_s15 <= setup_light_unit_z_n983_s14;
            setup_light_unit_z_n985_s15 <= setup_light_unit_z_n985_s14;
            setup_half_length_n1308_s15 <= setup_half_length_n1308;
            setup_half_unit_x_n1352_s15 <= setup_half_unit_x_n1352_s14;
            setup_half_unit_x_n1361_s15 <= setup_half_unit_x_n1361_s14;
            setup_half_unit_x_n1367_s15 <= setup_half_unit_x_n1367_s14;
            setup_half_unit_x_n1520_s15 <= setup_half_unit_x_n1520_s14;
            setup_half_unit_x_n1522_s15 <= setup_half_unit_x_n1522_s14;
            setup_half_unit_y_n1567_s15 <= setup_half_unit_y_n1567_s14;
            setup_half_unit_y_n1576_s15 <= setup_half_unit_y_n1576_s14;
            setup_half_unit_y_n1582_s15 <= setup_half_unit_y_n1582_s14;
            setup_half_unit_y_n1734_s15 <= setup_half_unit_y_n1734_s14;
            setup_half_unit_y_n1736_s15 <= setup_half_unit_y_n1736_s14;
            setup_half_unit_z_n1781_s15 <= setup_half_unit_z_n1781_s14;
            setup_half_unit_z_n1790_s15 <= setup_half_unit_z_n1790_s14;
            setup_half_unit_z_n1796_s15 <= setup_half_unit_z_n1796_s14;
            setup_half_unit_z_n1948_s15 <= setup_half_unit_z_n1948_s14;
            setup_half_unit_z_n1950_s15 <= setup_half_unit_z_n1950_s14;
            setup_bump_unit_x_n2216_s15 <= setup_bump_unit_x_n2216_s14;
            setup_bump_unit_x_n2319_s15 <= setup_bump_unit_x_n2319;
            setup_bump_unit_x_n2322_s15 <= setup_bump_unit_x_n2322;
            setup_bump_unit_x_n2401_s15 <= setup_bump_unit_x_n2401;
            setup_bump_unit_x_n2415_s15 <= setup_bump_unit_x_n2415_s14;
            setup_bump_unit_x_n2417_s15 <= setup_bump_unit_x_n2417_s14;
            setup_bump_unit_x_n2419_s15 <= setup_bump_unit_x_n2419_s14;
            setup_bump_unit_y_n2526_s15 <= setup_bump_unit_y_n2526;
            setup_bump_unit_y_n2529_s15 <= setup_bump_unit_y_n2529;
            setup_bump_unit_y_n2608_s15 <= setup_bump_unit_y_n2608;
            setup_bump_unit_y_n2621_s15 <= setup_bump_unit_y_n2621_s14;
            setup_bump_unit_y_n2623_s15 <= setup_bump_unit_y_n2623_s14;
            setup_bump_unit_y_n2625_s15 <= setup_bump_unit_y_n2625_s14;
            setup_bump_unit_z_n2732_s15 <= setup_bump_unit_z_n2732;
            setup_bump_unit_z_n2735_s15 <= setup_bump_unit_z_n2735;
            setup_bump_unit_z_n2814_s15 <= setup_bump_unit_z_n2814;
            setup_bump_unit_z_n2827_s15 <= setup_bump_unit_z_n2827_s14;
            setup_bump_unit_z_n2829_s15 <= setup_bump_unit_z_n2829_s14;
            setup_bump_unit_z_n2831_s15 <= setup_bump_unit_z_n2831_s14;
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // setup.light.length
    wire [6:-20] setup_light_length_length_sum = {1'b0, setup_light_length_n340_s15} + 27'h2;
    wire [6:-18] setup_light_length_length_cut = setup_light_length_length_sum[6:-18];
    wire setup_light_length_length_over = |setup_light_length_length_cut[6:5];
    wire [4:-18] setup_light_length_length = setup_light_length_length_over ? 23'h7fffff : setup_light_length_length_cut[4:-18]; // u23f18
    // setup.light.unit_x
    wire [22:0] setup_light_unit_x_n344 = setup_light_length_length; // u23f0
    wire setup_light_unit_x_n386 = {2'h0, setup_light_unit_x_n385_s15} < setup_light_unit_x_n344; // u1f0
    wire setup_light_unit_x_n387 = setup_light_unit_x_n386 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_light_unit_x_n397_term = {3'h0, setup_light_unit_x_n344} ^ {26{setup_light_unit_x_n396_s15}};
    wire signed [25:0] setup_light_unit_x_n397 = {setup_light_unit_x_n395_s15[24], setup_light_unit_x_n395_s15} + setup_light_unit_x_n397_term + {25'h0, setup_light_unit_x_n396_s15}; // s26f0
    wire signed [23:0] setup_light_unit_x_n398 = setup_light_unit_x_n397[23:0]; // s24f0
    wire setup_light_unit_x_n399 = setup_light_unit_x_n398[23]; // u1f0
    wire setup_light_unit_x_n400 = setup_light_unit_x_n399 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n401 = setup_light_unit_x_n398; // u24f0
    wire [24:0] setup_light_unit_x_n403 = {setup_light_unit_x_n401, setup_light_unit_x_n402_s15}; // u25f0
    wire signed [24:0] setup_light_unit_x_n404 = setup_light_unit_x_n403; // s25f0
    wire setup_light_unit_x_n552 = setup_light_length_length == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_light_unit_x_n553 = setup_light_unit_x_n387 | setup_light_unit_x_n552; // u1f0
    // setup.light.unit_y
    wire setup_light_unit_y_n603 = {2'h0, setup_light_unit_y_n602_s15} < setup_light_unit_x_n344; // u1f0
    wire setup_light_unit_y_n604 = setup_light_unit_y_n603 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_light_unit_y_n612_term = {3'h0, setup_light_unit_x_n344} ^ {26{setup_light_unit_x_n396_s15}};
    wire signed [25:0] setup_light_unit_y_n612 = {setup_light_unit_y_n611_s15[24], setup_light_unit_y_n611_s15} + setup_light_unit_y_n612_term + {25'h0, setup_light_unit_x_n396_s15}; // s26f0
    wire signed [23:0] setup_light_unit_y_n613 = setup_light_unit_y_n612[23:0]; // s24f0
    wire setup_light_unit_y_n614 = setup_light_unit_y_n613[23]; // u1f0
    wire setup_light_unit_y_n615 = setup_light_unit_y_n614 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n616 = setup_light_unit_y_n613; // u24f0
    wire [24:0] setup_light_unit_y_n618 = {setup_light_unit_y_n616, setup_light_unit_y_n617_s15}; // u25f0
    wire signed [24:0] setup_light_unit_y_n619 = setup_light_unit_y_n618; // s25f0
    wire setup_light_unit_y_n767 = setup_light_unit_y_n604 | setup_light_unit_x_n552; // u1f0
    // setup.light.unit_z
    wire setup_light_unit_z_n817 = {2'h0, setup_light_unit_z_n816_s15} < setup_light_unit_x_n344; // u1f0
    wire setup_light_unit_z_n818 = setup_light_unit_z_n817 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_light_unit_z_n826_term = {3'h0, setup_light_unit_x_n344} ^ {26{setup_light_unit_x_n396_s15}};
    wire signed [25:0] setup_light_unit_z_n826 = {setup_light_unit_z_n825_s15[24], setup_light_unit_z_n825_s15} + setup_light_unit_z_n826_term + {25'h0, setup_light_unit_x_n396_s15}; // s26f0
    wire signed [23:0] setup_light_unit_z_n827 = setup_light_unit_z_n826[23:0]; // s24f0
    wire setup_light_unit_z_n828 = setup_light_unit_z_n827[23]; // u1f0
    wire setup_light_unit_z_n829 = setup_light_unit_z_n828 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n830 = setup_light_unit_z_n827; // u24f0
    wire [24:0] setup_light_unit_z_n832 = {setup_light_unit_z_n830, setup_light_unit_z_n831_s15}; // u25f0
    wire signed [24:0] setup_light_unit_z_n833 = setup_light_unit_z_n832; // s25f0
    wire setup_light_unit_z_n981 = setup_light_unit_z_n818 | setup_light_unit_x_n552; // u1f0
    // setup.half.length
    wire [6:-20] setup_half_length_length_sum = {1'b0, setup_half_length_n1308_s15} + 27'h2;
    wire [6:-18] setup_half_length_length_cut = setup_half_length_length_sum[6:-18];
    wire setup_half_length_length_over = |setup_half_length_length_cut[6:5];
    wire [4:-18] setup_half_length_length = setup_half_length_length_over ? 23'h7fffff : setup_half_length_length_cut[4:-18]; // u23f18
    // setup.half.unit_x
    wire [22:0] setup_half_unit_x_n1311 = setup_half_length_length; // u23f0
    wire setup_half_unit_x_n1353 = {2'h0, setup_half_unit_x_n1352_s15} < setup_half_unit_x_n1311; // u1f0
    wire setup_half_unit_x_n1354 = setup_half_unit_x_n1353 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_half_unit_x_n1362_term = {3'h0, setup_half_unit_x_n1311} ^ {26{setup_light_unit_x_n396_s15}};
    wire signed [25:0] setup_half_unit_x_n1362 = {setup_half_unit_x_n1361_s15[24], setup_half_unit_x_n1361_s15} + setup_half_unit_x_n1362_term + {25'h0, setup_light_unit_x_n396_s15}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1363 = setup_half_unit_x_n1362[23:0]; // s24f0
    wire setup_half_unit_x_n1364 = setup_half_unit_x_n1363[23]; // u1f0
    wire setup_half_unit_x_n1365 = setup_half_unit_x_n1364 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1366 = setup_half_unit_x_n1363; // u24f0
    wire [24:0] setup_half_unit_x_n1368 = {setup_half_unit_x_n1366, setup_half_unit_x_n1367_s15}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1369 = setup_half_unit_x_n1368; // s25f0
    wire setup_half_unit_x_n1517 = setup_half_length_length == {4'h0, setup_light_length_n43, 18'h0}; // u1f0
    wire setup_half_unit_x_n1518 = setup_half_unit_x_n1354 | setup_half_unit_x_n1517; // u1f0
    // setup.half.unit_y
    wire setup_half_unit_y_n1568 = {2'h0, setup_half_unit_y_n1567_s15} < setup_half_unit_x_n1311; // u1f0
    wire setup_half_unit_y_n1569 = setup_half_unit_y_n1568 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_half_unit_y_n1577_term = {3'h0, setup_half_unit_x_n1311} ^ {26{setup_light_unit_x_n396_s15}};
    wire signed [25:0] setup_half_unit_y_n1577 = {setup_half_unit_y_n1576_s15[24], setup_half_unit_y_n1576_s15} + setup_half_unit_y_n1577_term + {25'h0, setup_light_unit_x_n396_s15}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1578 = setup_half_unit_y_n1577[23:0]; // s24f0
    wire setup_half_unit_y_n1579 = setup_half_unit_y_n1578[23]; // u1f0
    wire setup_half_unit_y_n1580 = setup_half_unit_y_n1579 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1581 = setup_half_unit_y_n1578; // u24f0
    wire [24:0] setup_half_unit_y_n1583 = {setup_half_unit_y_n1581, setup_half_unit_y_n1582_s15}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1584 = setup_half_unit_y_n1583; // s25f0
    wire setup_half_unit_y_n1732 = setup_half_unit_y_n1569 | setup_half_unit_x_n1517; // u1f0
    // setup.half.unit_z
    wire setup_half_unit_z_n1782 = {2'h0, setup_half_unit_z_n1781_s15} < setup_half_unit_x_n1311; // u1f0
    wire setup_half_unit_z_n1783 = setup_half_unit_z_n1782 ^ setup_light_length_n42; // u1f0
    wire [25:0] setup_half_unit_z_n1791_term = {3'h0, setup_half_unit_x_n1311} ^ {26{setup_light_unit_x_n396_s15}};
    wire signed [25:0] setup_half_unit_z_n1791 = {setup_half_unit_z_n1790_s15[24], setup_half_unit_z_n1790_s15} + setup_half_unit_z_n1791_term + {25'h0, setup_light_unit_x_n396_s15}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1792 = setup_half_unit_z_n1791[23:0]; // s24f0
    wire setup_half_unit_z_n1793 = setup_half_unit_z_n1792[23]; // u1f0
    wire setup_half_unit_z_n1794 = setup_half_unit_z_n1793 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1795 = setup_half_unit_z_n1792; // u24f0
    wire [24:0] setup_half_unit_z_n1797 = {setup_half_unit_z_n1795, setup_half_unit_z_n1796_s15}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1798 = setup_half_unit_z_n1797; // s25f0
    wire setup_half_unit_z_n1946 = setup_half_unit_z_n1783 | setup_half_unit_x_n1517; // u1f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2323_term = {3'h0, setup_bump_unit_x_n2216_s15} ^ {26{setup_bump_unit_x_n2319_s15}};
    wire signed [25:0] setup_bump_unit_x_n2323 = {setup_bump_unit_x_n2322_s15[24], setup_bump_unit_x_n2322_s15} + setup_bump_unit_x_n2323_term + {25'h0, setup_bump_unit_x_n2319_s15}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2324 = setup_bump_unit_x_n2323[23:0]; // s24f0
    wire setup_bump_unit_x_n2325 = setup_bump_unit_x_n2324[23]; // u1f0
    wire setup_bump_unit_x_n2326 = setup_bump_unit_x_n2325 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2327 = setup_bump_unit_x_n2324; // u24f0
    wire [24:0] setup_bump_unit_x_n2328 = {setup_bump_unit_x_n2327, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2329 = setup_bump_unit_x_n2328; // s25f0
    wire [25:0] setup_bump_unit_x_n2330_term = {3'h0, setup_bump_unit_x_n2216_s15} ^ {26{setup_bump_unit_x_n2326}};
    wire signed [25:0] setup_bump_unit_x_n2330 = {setup_bump_unit_x_n2329[24], setup_bump_unit_x_n2329} + setup_bump_unit_x_n2330_term + {25'h0, setup_bump_unit_x_n2326}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2331 = setup_bump_unit_x_n2330[23:0]; // s24f0
    wire setup_bump_unit_x_n2332 = setup_bump_unit_x_n2331[23]; // u1f0
    wire setup_bump_unit_x_n2333 = setup_bump_unit_x_n2332 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2334 = setup_bump_unit_x_n2331; // u24f0
    wire [24:0] setup_bump_unit_x_n2335 = {setup_bump_unit_x_n2334, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2336 = setup_bump_unit_x_n2335; // s25f0
    wire [9:0] setup_bump_unit_x_n2402 = {setup_bump_unit_x_n2401_s15, setup_bump_unit_x_n2326}; // u10f0
    wire [10:0] setup_bump_unit_x_n2403 = {setup_bump_unit_x_n2402, setup_bump_unit_x_n2333}; // u11f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2530_term = {3'h0, setup_bump_unit_x_n2216_s15} ^ {26{setup_bump_unit_y_n2526_s15}};
    wire signed [25:0] setup_bump_unit_y_n2530 = {setup_bump_unit_y_n2529_s15[24], setup_bump_unit_y_n2529_s15} + setup_bump_unit_y_n2530_term + {25'h0, setup_bump_unit_y_n2526_s15}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2531 = setup_bump_unit_y_n2530[23:0]; // s24f0
    wire setup_bump_unit_y_n2532 = setup_bump_unit_y_n2531[23]; // u1f0
    wire setup_bump_unit_y_n2533 = setup_bump_unit_y_n2532 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2534 = setup_bump_unit_y_n2531; // u24f0
    wire [24:0] setup_bump_unit_y_n2535 = {setup_bump_unit_y_n2534, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2536 = setup_bump_unit_y_n2535; // s25f0
    wire [25:0] setup_bump_unit_y_n2537_term = {3'h0, setup_bump_unit_x_n2216_s15} ^ {26{setup_bump_unit_y_n2533}};
    wire signed [25:0] setup_bump_unit_y_n2537 = {setup_bump_unit_y_n2536[24], setup_bump_unit_y_n2536} + setup_bump_unit_y_n2537_term + {25'h0, setup_bump_unit_y_n2533}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2538 = setup_bump_unit_y_n2537[23:0]; // s24f0
    wire setup_bump_unit_y_n2539 = setup_bump_unit_y_n2538[23]; // u1f0
    wire setup_bump_unit_y_n2540 = setup_bump_unit_y_n2539 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2541 = setup_bump_unit_y_n2538; // u24f0
    wire [24:0] setup_bump_unit_y_n2542 = {setup_bump_unit_y_n2541, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2543 = setup_bump_unit_y_n2542; // s25f0
    wire [9:0] setup_bump_unit_y_n2609 = {setup_bump_unit_y_n2608_s15, setup_bump_unit_y_n2533}; // u10f0
    wire [10:0] setup_bump_unit_y_n2610 = {setup_bump_unit_y_n2609, setup_bump_unit_y_n2540}; // u11f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2736_term = {3'h0, setup_bump_unit_x_n2216_s15} ^ {26{setup_bump_unit_z_n2732_s15}};
    wire signed [25:0] setup_bump_unit_z_n2736 = {setup_bump_unit_z_n2735_s15[24], setup_bump_unit_z_n2735_s15} + setup_bump_unit_z_n2736_term + {25'h0, setup_bump_unit_z_n2732_s15}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2737 = setup_bump_unit_z_n2736[23:0]; // s24f0
    wire setup_bump_unit_z_n2738 = setup_bump_unit_z_n2737[23]; // u1f0
    wire setup_bump_unit_z_n2739 = setup_bump_unit_z_n2738 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2740 = setup_bump_unit_z_n2737; // u24f0
    wire [24:0] setup_bump_unit_z_n2741 = {setup_bump_unit_z_n2740, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2742 = setup_bump_unit_z_n2741; // s25f0
    wire [25:0] setup_bump_unit_z_n2743_term = {3'h0, setup_bump_unit_x_n2216_s15} ^ {26{setup_bump_unit_z_n2739}};
    wire signed [25:0] setup_bump_unit_z_n2743 = {setup_bump_unit_z_n2742[24], setup_bump_unit_z_n2742} + setup_bump_unit_z_n2743_term + {25'h0, setup_bump_unit_z_n2739}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2744 = setup_bump_unit_z_n2743[23:0]; // s24f0
    wire setup_bump_unit_z_n2745 = setup_bump_unit_z_n2744[23]; // u1f0
    wire setup_bump_unit_z_n2746 = setup_bump_unit_z_n2745 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2747 = setup_bump_unit_z_n2744; // u24f0
    wire [24:0] setup_bump_unit_z_n2748 = {setup_bump_unit_z_n2747, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2749 = setup_bump_unit_z_n2748; // s25f0
    wire [9:0] setup_bump_unit_z_n2815 = {setup_bump_unit_z_n2814_s15, setup_bump_unit_z_n2739}; // u10f0
    wire [10:0] setup_bump_unit_z_n2816 = {setup_bump_unit_z_n2815, setup_bump_unit_z_n2746}; // u11f0

    reg [22:0] setup_light_unit_x_n344_s16; // u23f0
    reg setup_light_unit_x_n400_s16; // u1f0
    reg signed [24:0] setup_light_unit_x_n404_s16; // s25f0
    reg setup_light_unit_x_n553_s16; // u1f0
    reg setup_light_unit_x_n555_s16; // u1f0
    reg setup_light_unit_x_n557_s16; // u1f0
    reg setup_light_unit_y_n615_s16; // u1f0
    reg signed [24:0] setup_light_unit_y_n619_s16; // s25f0
    reg setup_light_unit_y_n767_s16; // u1f0
    reg setup_light_unit_y_n769_s16; // u1f0
    reg setup_light_unit_y_n771_s16; // u1f0
    reg setup_light_unit_z_n829_s16; // u1f0
    reg signed [24:0] setup_light_unit_z_n833_s16; // s25f0
    reg setup_light_unit_z_n981_s16; // u1f0
    reg setup_light_unit_z_n983_s16; // u1f0
    reg setup_light_unit_z_n985_s16; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s16; // u23f0
    reg setup_half_unit_x_n1365_s16; // u1f0
    reg signed [24:0] setup_half_unit_x_n1369_s16; // s25f0
    reg setup_half_unit_x_n1518_s16; // u1f0
    reg setup_half_unit_x_n1520_s16; // u1f0
    reg setup_half_unit_x_n1522_s16; // u1f0
    reg setup_half_unit_y_n1580_s16; // u1f0
    reg signed [24:0] setup_half_unit_y_n1584_s16; // s25f0
    reg setup_half_unit_y_n1732_s16; // u1f0
    reg setup_half_unit_y_n1734_s16; // u1f0
    reg setup_half_unit_y_n1736_s16; // u1f0
    reg setup_half_unit_z_n1794_s16; // u1f0
    reg signed [24:0] setup_half_unit_z_n1798_s16; // s25f0
    reg setup_half_unit_z_n1946_s16; // u1f0
    reg setup_half_unit_z_n1948_s16; // u1f0
    reg setup_half_unit_z_n1950_s16; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s16; // u23f0
    reg setup_bump_unit_x_n2333_s16; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2336_s16; // s25f0
    reg [10:0] setup_bump_unit_x_n2403_s16; // u11f0
    reg setup_bump_unit_x_n2415_s16; // u1f0
    reg setup_bump_unit_x_n2417_s16; // u1f0
    reg setup_bump_unit_x_n2419_s16; // u1f0
    reg setup_bump_unit_y_n2540_s16; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2543_s16; // s25f0
    reg [10:0] setup_bump_unit_y_n2610_s16; // u11f0
    reg setup_bump_unit_y_n2621_s16; // u1f0
    reg setup_bump_unit_y_n2623_s16; // u1f0
    reg setup_bump_unit_y_n2625_s16; // u1f0
    reg setup_bump_unit_z_n2746_s16; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2749_s16; // s25f0
    reg [10:0] setup_bump_unit_z_n2816_s16; // u11f0
    reg setup_bump_unit_z_n2827_s16; // u1f0
    reg setup_bump_unit_z_n2829_s16; // u1f0
    reg setup_bump_unit_z_n2831_s16; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s16 <= setup_light_unit_x_n344;
            setup_light_unit_x_n400_s16 <= setup_light_unit_x_n400;
            setup_light_unit_x_n404_s16 <= setup_light_unit_x_n404;
            setup_light_unit_x_n553_s16 <= setup_light_unit_x_n553;
            setup_light_unit_x_n555_s16 <= setup_light_unit_x_n555_s15;
            setup_light_unit_x_n557_s16 <= setup_light_unit_x_n557_s15;
            setup_light_unit_y_n615_s16 <= setup_light_unit_y_n615;
            setup_light_unit_y_n619_s16 <= setup_light_unit_y_n619;
            setup_light_unit_y_n767_s16 <= setup_light_unit_y_n767;
            setup_light_unit_y_n769_s16 <= setup_light_unit_y_n769_s15;
            setup_light_unit_y_n771_s16 <= setup_light_unit_y_n771_s15;
            setup_light_unit_z_n829_s16 <= setup_light_unit_z_n829;
            setup_light_unit_z_n833_s16 <= setup_light_unit_z_n833;
            setup_light_unit_z_n981_s16 <= setup_light_unit_z_n981;
            setup_light_unit_z_n983_s16 <= setup_light_unit_z_n983_s15;
            setup_light_unit_z_n985_s16 <= setup_light_unit_z_n985_s15;
            setup_half_unit_x_n1311_s16 <= setup_half_unit_x_n1311;
            setup_half_unit_x_n1365_s16 <= setup_half_unit_x_n1365;
            setup_half_unit_x_n1369_s16 <= setup_half_unit_x_n1369;
            setup_half_unit_x_n1518_s16 <= setup_half_unit_x_n1518;
            setup_half_unit_x_n1520_s16 <= setup_half_unit_x_n1520_s15;
            setup_half_unit_x_n1522_s16 <= setup_half_unit_x_n1522_s15;
            setup_half_unit_y_n1580_s16 <= setup_half_unit_y_n1580;
            setup_half_unit_y_n1584_s16 <= setup_half_unit_y_n1584;
            setup_half_unit_y_n1732_s16 <= setup_half_unit_y_n1732;
            setup_half_unit_y_n1734_s16 <= setup_half_unit_y_n1734_s15;
            setup_half_unit_y_n1736_s16 <= setup_half_unit_y_n1736_s15;
            setup_half_unit_z_n1794_s16 <= setup_half_unit_z_n1794;
            setup_half_unit_z_n1798_s16 <= setup_half_unit_z_n1798;
            setup_half_unit_z_n1946_s16 <= setup_half_unit_z_n1946;
            setup_half_unit_z_n1948_s16 <= setup_half_unit_z_n1948_s15;
            setup_half_unit_z_n1950_s16 <= setup_half_unit_z_n1950_s15;
            setup_bump_unit_x_n2216_s16 <= setup_bump_unit_x_n2216_s15;
            setup_bump_unit_x_n2333_s16 <= setup_bump_unit_x_n2333;
            setup_bump_unit_x_n2336_s16 <= setup_bump_unit_x_n2336;
            setup_bump_unit_x_n2403_s16 <= setup_bump_unit_x_n2403;
            setup_bump_unit_x_n2415_s16 <= setup_bump_unit_x_n2415_s15;
            setup_bump_unit_x_n2417_s16 <= setup_bump_unit_x_n2417_s15;
            setup_bump_unit_x_n2419_s16 <= setup_bump_unit_x_n2419_s15;
            setup_bump_unit_y_n2540_s16 <= setup_bump_unit_y_n2540;
            setup_bump_unit_y_n2543_s16 <= setup_bump_unit_y_n2543;
            setup_bump_unit_y_n2610_s16 <= setup_bump_unit_y_n2610;
            setup_bump_unit_y_n2621_s16 <= setup_bump_unit_y_n2621_s15;
            setup_bump_unit_y_n2623_s16 <= setup_bump_unit_y_n2623_s15;
            setup_bump_unit_y_n2625_s16 <= setup_bump_unit_y_n2625_s15;
            setup_bump_unit_z_n2746_s16 <= setup_bump_unit_z_n2746;
            setup_bump_unit_z_n2749_s16 <= setup_bump_unit_z_n2749;
            setup_bump_unit_z_n2816_s16 <= setup_bump_unit_z_n2816;
            setup_bump_unit_z_n2827_s16 <= setup_bump_unit_z_n2827_s15;
            setup_bump_unit_z_n2829_s16 <= setup_bump_unit_z_n2829_s15;
            setup_bump_unit_z_n2831_s16 <= setup_bump_unit_z_n2831_s15;
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n405_term = {3'h0, setup_light_unit_x_n344_s16} ^ {26{setup_light_unit_x_n400_s16}};
    wire signed [25:0] setup_light_unit_x_n405 = {setup_light_unit_x_n404_s16[24], setup_light_unit_x_n404_s16} + setup_light_unit_x_n405_term + {25'h0, setup_light_unit_x_n400_s16}; // s26f0
    wire signed [23:0] setup_light_unit_x_n406 = setup_light_unit_x_n405[23:0]; // s24f0
    wire setup_light_unit_x_n407 = setup_light_unit_x_n406[23]; // u1f0
    wire setup_light_unit_x_n408 = setup_light_unit_x_n407 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n409 = setup_light_unit_x_n406; // u24f0
    wire [24:0] setup_light_unit_x_n410 = {setup_light_unit_x_n409, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n411 = setup_light_unit_x_n410; // s25f0
    wire [25:0] setup_light_unit_x_n412_term = {3'h0, setup_light_unit_x_n344_s16} ^ {26{setup_light_unit_x_n408}};
    wire signed [25:0] setup_light_unit_x_n412 = {setup_light_unit_x_n411[24], setup_light_unit_x_n411} + setup_light_unit_x_n412_term + {25'h0, setup_light_unit_x_n408}; // s26f0
    wire signed [23:0] setup_light_unit_x_n413 = setup_light_unit_x_n412[23:0]; // s24f0
    wire setup_light_unit_x_n414 = setup_light_unit_x_n413[23]; // u1f0
    wire setup_light_unit_x_n415 = setup_light_unit_x_n414 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n416 = setup_light_unit_x_n413; // u24f0
    wire [24:0] setup_light_unit_x_n417 = {setup_light_unit_x_n416, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n418 = setup_light_unit_x_n417; // s25f0
    wire [1:0] setup_light_unit_x_n532 = {setup_light_unit_x_n400_s16, setup_light_unit_x_n408}; // u2f0
    wire [2:0] setup_light_unit_x_n533 = {setup_light_unit_x_n532, setup_light_unit_x_n415}; // u3f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n620_term = {3'h0, setup_light_unit_x_n344_s16} ^ {26{setup_light_unit_y_n615_s16}};
    wire signed [25:0] setup_light_unit_y_n620 = {setup_light_unit_y_n619_s16[24], setup_light_unit_y_n619_s16} + setup_light_unit_y_n620_term + {25'h0, setup_light_unit_y_n615_s16}; // s26f0
    wire signed [23:0] setup_light_unit_y_n621 = setup_light_unit_y_n620[23:0]; // s24f0
    wire setup_light_unit_y_n622 = setup_light_unit_y_n621[23]; // u1f0
    wire setup_light_unit_y_n623 = setup_light_unit_y_n622 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n624 = setup_light_unit_y_n621; // u24f0
    wire [24:0] setup_light_unit_y_n625 = {setup_light_unit_y_n624, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n626 = setup_light_unit_y_n625; // s25f0
    wire [25:0] setup_light_unit_y_n627_term = {3'h0, setup_light_unit_x_n344_s16} ^ {26{setup_light_unit_y_n623}};
    wire signed [25:0] setup_light_unit_y_n627 = {setup_light_unit_y_n626[24], setup_light_unit_y_n626} + setup_light_unit_y_n627_term + {25'h0, setup_light_unit_y_n623}; // s26f0
    wire signed [23:0] setup_light_unit_y_n628 = setup_light_unit_y_n627[23:0]; // s24f0
    wire setup_light_unit_y_n629 = setup_light_unit_y_n628[23]; // u1f0
    wire setup_light_unit_y_n630 = setup_light_unit_y_n629 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n631 = setup_light_unit_y_n628; // u24f0
    wire [24:0] setup_light_unit_y_n632 = {setup_light_unit_y_n631, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n633 = setup_light_unit_y_n632; // s25f0
    wire [1:0] setup_light_unit_y_n747 = {setup_light_unit_y_n615_s16, setup_light_unit_y_n623}; // u2f0
    wire [2:0] setup_light_unit_y_n748 = {setup_light_unit_y_n747, setup_light_unit_y_n630}; // u3f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n834_term = {3'h0, setup_light_unit_x_n344_s16} ^ {26{setup_light_unit_z_n829_s16}};
    wire signed [25:0] setup_light_unit_z_n834 = {setup_light_unit_z_n833_s16[24], setup_light_unit_z_n833_s16} + setup_light_unit_z_n834_term + {25'h0, setup_light_unit_z_n829_s16}; // s26f0
    wire signed [23:0] setup_light_unit_z_n835 = setup_light_unit_z_n834[23:0]; // s24f0
    wire setup_light_unit_z_n836 = setup_light_unit_z_n835[23]; // u1f0
    wire setup_light_unit_z_n837 = setup_light_unit_z_n836 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n838 = setup_light_unit_z_n835; // u24f0
    wire [24:0] setup_light_unit_z_n839 = {setup_light_unit_z_n838, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n840 = setup_light_unit_z_n839; // s25f0
    wire [25:0] setup_light_unit_z_n841_term = {3'h0, setup_light_unit_x_n344_s16} ^ {26{setup_light_unit_z_n837}};
    wire signed [25:0] setup_light_unit_z_n841 = {setup_light_unit_z_n840[24], setup_light_unit_z_n840} + setup_light_unit_z_n841_term + {25'h0, setup_light_unit_z_n837}; // s26f0
    wire signed [23:0] setup_light_unit_z_n842 = setup_light_unit_z_n841[23:0]; // s24f0
    wire setup_light_unit_z_n843 = setup_light_unit_z_n842[23]; // u1f0
    wire setup_light_unit_z_n844 = setup_light_unit_z_n843 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n845 = setup_light_unit_z_n842; // u24f0
    wire [24:0] setup_light_unit_z_n846 = {setup_light_unit_z_n845, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n847 = setup_light_unit_z_n846; // s25f0
    wire [1:0] setup_light_unit_z_n961 = {setup_light_unit_z_n829_s16, setup_light_unit_z_n837}; // u2f0
    wire [2:0] setup_light_unit_z_n962 = {setup_light_unit_z_n961, setup_light_unit_z_n844}; // u3f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1370_term = {3'h0, setup_half_unit_x_n1311_s16} ^ {26{setup_half_unit_x_n1365_s16}};
    wire signed [25:0] setup_half_unit_x_n1370 = {setup_half_unit_x_n1369_s16[24], setup_half_unit_x_n1369_s16} + setup_half_unit_x_n1370_term + {25'h0, setup_half_unit_x_n1365_s16}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1371 = setup_half_unit_x_n1370[23:0]; // s24f0
    wire setup_half_unit_x_n1372 = setup_half_unit_x_n1371[23]; // u1f0
    wire setup_half_unit_x_n1373 = setup_half_unit_x_n1372 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1374 = setup_half_unit_x_n1371; // u24f0
    wire [24:0] setup_half_unit_x_n1375 = {setup_half_unit_x_n1374, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1376 = setup_half_unit_x_n1375; // s25f0
    wire [25:0] setup_half_unit_x_n1377_term = {3'h0, setup_half_unit_x_n1311_s16} ^ {26{setup_half_unit_x_n1373}};
    wire signed [25:0] setup_half_unit_x_n1377 = {setup_half_unit_x_n1376[24], setup_half_unit_x_n1376} + setup_half_unit_x_n1377_term + {25'h0, setup_half_unit_x_n1373}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1378 = setup_half_unit_x_n1377[23:0]; // s24f0
    wire setup_half_unit_x_n1379 = setup_half_unit_x_n1378[23]; // u1f0
    wire setup_half_unit_x_n1380 = setup_half_unit_x_n1379 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1381 = setup_half_unit_x_n1378; // u24f0
    wire [24:0] setup_half_unit_x_n1382 = {setup_half_unit_x_n1381, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1383 = setup_half_unit_x_n1382; // s25f0
    wire [1:0] setup_half_unit_x_n1497 = {setup_half_unit_x_n1365_s16, setup_half_unit_x_n1373}; // u2f0
    wire [2:0] setup_half_unit_x_n1498 = {setup_half_unit_x_n1497, setup_half_unit_x_n1380}; // u3f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1585_term = {3'h0, setup_half_unit_x_n1311_s16} ^ {26{setup_half_unit_y_n1580_s16}};
    wire signed [25:0] setup_half_unit_y_n1585 = {setup_half_unit_y_n1584_s16[24], setup_half_unit_y_n1584_s16} + setup_half_unit_y_n1585_term + {25'h0, setup_half_unit_y_n1580_s16}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1586 = setup_half_unit_y_n1585[23:0]; // s24f0
    wire setup_half_unit_y_n1587 = setup_half_unit_y_n1586[23]; // u1f0
    wire setup_half_unit_y_n1588 = setup_half_unit_y_n1587 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1589 = setup_half_unit_y_n1586; // u24f0
    wire [24:0] setup_half_unit_y_n1590 = {setup_half_unit_y_n1589, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1591 = setup_half_unit_y_n1590; // s25f0
    wire [25:0] setup_half_unit_y_n1592_term = {3'h0, setup_half_unit_x_n1311_s16} ^ {26{setup_half_unit_y_n1588}};
    wire signed [25:0] setup_half_unit_y_n1592 = {setup_half_unit_y_n1591[24], setup_half_unit_y_n1591} + setup_half_unit_y_n1592_term + {25'h0, setup_half_unit_y_n1588}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1593 = setup_half_unit_y_n1592[23:0]; // s24f0
    wire setup_half_unit_y_n1594 = setup_half_unit_y_n1593[23]; // u1f0
    wire setup_half_unit_y_n1595 = setup_half_unit_y_n1594 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1596 = setup_half_unit_y_n1593; // u24f0
    wire [24:0] setup_half_unit_y_n1597 = {setup_half_unit_y_n1596, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1598 = setup_half_unit_y_n1597; // s25f0
    wire [1:0] setup_half_unit_y_n1712 = {setup_half_unit_y_n1580_s16, setup_half_unit_y_n1588}; // u2f0
    wire [2:0] setup_half_unit_y_n1713 = {setup_half_unit_y_n1712, setup_half_unit_y_n1595}; // u3f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1799_term = {3'h0, setup_half_unit_x_n1311_s16} ^ {26{setup_half_unit_z_n1794_s16}};
    wire signed [25:0] setup_half_unit_z_n1799 = {setup_half_unit_z_n1798_s16[24], setup_half_unit_z_n1798_s16} + setup_half_unit_z_n1799_term + {25'h0, setup_half_unit_z_n1794_s16}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1800 = setup_half_unit_z_n1799[23:0]; // s24f0
    wire setup_half_unit_z_n1801 = setup_half_unit_z_n1800[23]; // u1f0
    wire setup_half_unit_z_n1802 = setup_half_unit_z_n1801 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1803 = setup_half_unit_z_n1800; // u24f0
    wire [24:0] setup_half_unit_z_n1804 = {setup_half_unit_z_n1803, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1805 = setup_half_unit_z_n1804; // s25f0
    wire [25:0] setup_half_unit_z_n1806_term = {3'h0, setup_half_unit_x_n1311_s16} ^ {26{setup_half_unit_z_n1802}};
    wire signed [25:0] setup_half_unit_z_n1806 = {setup_half_unit_z_n1805[24], setup_half_unit_z_n1805} + setup_half_unit_z_n1806_term + {25'h0, setup_half_unit_z_n1802}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1807 = setup_half_unit_z_n1806[23:0]; // s24f0
    wire setup_half_unit_z_n1808 = setup_half_unit_z_n1807[23]; // u1f0
    wire setup_half_unit_z_n1809 = setup_half_unit_z_n1808 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1810 = setup_half_unit_z_n1807; // u24f0
    wire [24:0] setup_half_unit_z_n1811 = {setup_half_unit_z_n1810, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1812 = setup_half_unit_z_n1811; // s25f0
    wire [1:0] setup_half_unit_z_n1926 = {setup_half_unit_z_n1794_s16, setup_half_unit_z_n1802}; // u2f0
    wire [2:0] setup_half_unit_z_n1927 = {setup_half_unit_z_n1926, setup_half_unit_z_n1809}; // u3f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2337_term = {3'h0, setup_bump_unit_x_n2216_s16} ^ {26{setup_bump_unit_x_n2333_s16}};
    wire signed [25:0] setup_bump_unit_x_n2337 = {setup_bump_unit_x_n2336_s16[24], setup_bump_unit_x_n2336_s16} + setup_bump_unit_x_n2337_term + {25'h0, setup_bump_unit_x_n2333_s16}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2338 = setup_bump_unit_x_n2337[23:0]; // s24f0
    wire setup_bump_unit_x_n2339 = setup_bump_unit_x_n2338[23]; // u1f0
    wire setup_bump_unit_x_n2340 = setup_bump_unit_x_n2339 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2341 = setup_bump_unit_x_n2338; // u24f0
    wire [24:0] setup_bump_unit_x_n2342 = {setup_bump_unit_x_n2341, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2343 = setup_bump_unit_x_n2342; // s25f0
    wire [25:0] setup_bump_unit_x_n2344_term = {3'h0, setup_bump_unit_x_n2216_s16} ^ {26{setup_bump_unit_x_n2340}};
    wire signed [25:0] setup_bump_unit_x_n2344 = {setup_bump_unit_x_n2343[24], setup_bump_unit_x_n2343} + setup_bump_unit_x_n2344_term + {25'h0, setup_bump_unit_x_n2340}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2345 = setup_bump_unit_x_n2344[23:0]; // s24f0
    wire setup_bump_unit_x_n2346 = setup_bump_unit_x_n2345[23]; // u1f0
    wire setup_bump_unit_x_n2347 = setup_bump_unit_x_n2346 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2348 = setup_bump_unit_x_n2345; // u24f0
    wire [24:0] setup_bump_unit_x_n2349 = {setup_bump_unit_x_n2348, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2350 = setup_bump_unit_x_n2349; // s25f0
    wire [11:0] setup_bump_unit_x_n2404 = {setup_bump_unit_x_n2403_s16, setup_bump_unit_x_n2340}; // u12f0
    wire [12:0] setup_bump_unit_x_n2405 = {setup_bump_unit_x_n2404, setup_bump_unit_x_n2347}; // u13f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2544_term = {3'h0, setup_bump_unit_x_n2216_s16} ^ {26{setup_bump_unit_y_n2540_s16}};
    wire signed [25:0] setup_bump_unit_y_n2544 = {setup_bump_unit_y_n2543_s16[24], setup_bump_unit_y_n2543_s16} + setup_bump_unit_y_n2544_term + {25'h0, setup_bump_unit_y_n2540_s16}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2545 = setup_bump_unit_y_n2544[23:0]; // s24f0
    wire setup_bump_unit_y_n2546 = setup_bump_unit_y_n2545[23]; // u1f0
    wire setup_bump_unit_y_n2547 = setup_bump_unit_y_n2546 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2548 = setup_bump_unit_y_n2545; // u24f0
    wire [24:0] setup_bump_unit_y_n2549 = {setup_bump_unit_y_n2548, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2550 = setup_bump_unit_y_n2549; // s25f0
    wire [25:0] setup_bump_unit_y_n2551_term = {3'h0, setup_bump_unit_x_n2216_s16} ^ {26{setup_bump_unit_y_n2547}};
    wire signed [25:0] setup_bump_unit_y_n2551 = {setup_bump_unit_y_n2550[24], setup_bump_unit_y_n2550} + setup_bump_unit_y_n2551_term + {25'h0, setup_bump_unit_y_n2547}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2552 = setup_bump_unit_y_n2551[23:0]; // s24f0
    wire setup_bump_unit_y_n2553 = setup_bump_unit_y_n2552[23]; // u1f0
    wire setup_bump_unit_y_n2554 = setup_bump_unit_y_n2553 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2555 = setup_bump_unit_y_n2552; // u24f0
    wire [24:0] setup_bump_unit_y_n2556 = {setup_bump_unit_y_n2555, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2557 = setup_bump_unit_y_n2556; // s25f0
    wire [11:0] setup_bump_unit_y_n2611 = {setup_bump_unit_y_n2610_s16, setup_bump_unit_y_n2547}; // u12f0
    wire [12:0] setup_bump_unit_y_n2612 = {setup_bump_unit_y_n2611, setup_bump_unit_y_n2554}; // u13f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2750_term = {3'h0, setup_bump_unit_x_n2216_s16} ^ {26{setup_bump_unit_z_n2746_s16}};
    wire signed [25:0] setup_bump_unit_z_n2750 = {setup_bump_unit_z_n2749_s16[24], setup_bump_unit_z_n2749_s16} + setup_bump_unit_z_n2750_term + {25'h0, setup_bump_unit_z_n2746_s16}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2751 = setup_bump_unit_z_n2750[23:0]; // s24f0
    wire setup_bump_unit_z_n2752 = setup_bump_unit_z_n2751[23]; // u1f0
    wire setup_bump_unit_z_n2753 = setup_bump_unit_z_n2752 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2754 = setup_bump_unit_z_n2751; // u24f0
    wire [24:0] setup_bump_unit_z_n2755 = {setup_bump_unit_z_n2754, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2756 = setup_bump_unit_z_n2755; // s25f0
    wire [25:0] setup_bump_unit_z_n2757_term = {3'h0, setup_bump_unit_x_n2216_s16} ^ {26{setup_bump_unit_z_n2753}};
    wire signed [25:0] setup_bump_unit_z_n2757 = {setup_bump_unit_z_n2756[24], setup_bump_unit_z_n2756} + setup_bump_unit_z_n2757_term + {25'h0, setup_bump_unit_z_n2753}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2758 = setup_bump_unit_z_n2757[23:0]; // s24f0
    wire setup_bump_unit_z_n2759 = setup_bump_unit_z_n2758[23]; // u1f0
    wire setup_bump_unit_z_n2760 = setup_bump_unit_z_n2759 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2761 = setup_bump_unit_z_n2758; // u24f0
    wire [24:0] setup_bump_unit_z_n2762 = {setup_bump_unit_z_n2761, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2763 = setup_bump_unit_z_n2762; // s25f0
    wire [11:0] setup_bump_unit_z_n2817 = {setup_bump_unit_z_n2816_s16, setup_bump_unit_z_n2753}; // u12f0
    wire [12:0] setup_bump_unit_z_n2818 = {setup_bump_unit_z_n2817, setup_bump_unit_z_n2760}; // u13f0

    reg [22:0] setup_light_unit_x_n344_s17; // u23f0
    reg setup_light_unit_x_n415_s17; // u1f0
    reg signed [24:0] setup_light_unit_x_n418_s17; // s25f0
    reg [2:0] setup_light_unit_x_n533_s17; // u3f0
    reg setup_light_unit_x_n553_s17; // u1f0
    reg setup_light_unit_x_n555_s17; // u1f0
    reg setup_light_unit_x_n557_s17; // u1f0
    reg setup_light_unit_y_n630_s17; // u1f0
    reg signed [24:0] setup_light_unit_y_n633_s17; // s25f0
    reg [2:0] setup_light_unit_y_n748_s17; // u3f0
    reg setup_light_unit_y_n767_s17; // u1f0
    reg setup_light_unit_y_n769_s17; // u1f0
    reg setup_light_unit_y_n771_s17; // u1f0
    reg setup_light_unit_z_n844_s17; // u1f0
    reg signed [24:0] setup_light_unit_z_n847_s17; // s25f0
    reg [2:0] setup_light_unit_z_n962_s17; // u3f0
    reg setup_light_unit_z_n981_s17; // u1f0
    reg setup_light_unit_z_n983_s17; // u1f0
    reg setup_light_unit_z_n985_s17; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s17; // u23f0
    reg setup_half_unit_x_n1380_s17; // u1f0
    reg signed [24:0] setup_half_unit_x_n1383_s17; // s25f0
    reg [2:0] setup_half_unit_x_n1498_s17; // u3f0
    reg setup_half_unit_x_n1518_s17; // u1f0
    reg setup_half_unit_x_n1520_s17; // u1f0
    reg setup_half_unit_x_n1522_s17; // u1f0
    reg setup_half_unit_y_n1595_s17; // u1f0
    reg signed [24:0] setup_half_unit_y_n1598_s17; // s25f0
    reg [2:0] setup_half_unit_y_n1713_s17; // u3f0
    reg setup_half_unit_y_n1732_s17; // u1f0
    reg setup_half_unit_y_n1734_s17; // u1f0
    reg setup_half_unit_y_n1736_s17; // u1f0
    reg setup_half_unit_z_n1809_s17; // u1f0
    reg signed [24:0] setup_half_unit_z_n1812_s17; // s25f0
    reg [2:0] setup_half_unit_z_n1927_s17; // u3f0
    reg setup_half_unit_z_n1946_s17; // u1f0
    reg setup_half_unit_z_n1948_s17; // u1f0
    reg setup_half_unit_z_n1950_s17; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s17; // u23f0
    reg setup_bump_unit_x_n2347_s17; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2350_s17; // s25f0
    reg [12:0] setup_bump_unit_x_n2405_s17; // u13f0
    reg setup_bump_unit_x_n2415_s17; // u1f0
    reg setup_bump_unit_x_n2417_s17; // u1f0
    reg setup_bump_unit_x_n2419_s17; // u1f0
    reg setup_bump_unit_y_n2554_s17; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2557_s17; // s25f0
    reg [12:0] setup_bump_unit_y_n2612_s17; // u13f0
    reg setup_bump_unit_y_n2621_s17; // u1f0
    reg setup_bump_unit_y_n2623_s17; // u1f0
    reg setup_bump_unit_y_n2625_s17; // u1f0
    reg setup_bump_unit_z_n2760_s17; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2763_s17; // s25f0
    reg [12:0] setup_bump_unit_z_n2818_s17; // u13f0
    reg setup_bump_unit_z_n2827_s17; // u1f0
    reg setup_bump_unit_z_n2829_s17; // u1f0
    reg setup_bump_unit_z_n2831_s17; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s17 <= setup_light_unit_x_n344_s16;
            setup_light_unit_x_n415_s17 <= setup_light_unit_x_n415;
            setup_light_unit_x_n418_s17 <= setup_light_unit_x_n418;
            setup_light_unit_x_n533_s17 <= setup_light_unit_x_n533;
            setup_light_unit_x_n553_s17 <= setup_light_unit_x_n553_s16;
            setup_light_unit_x_n555_s17 <= setup_light_unit_x_n555_s16;
            setup_light_unit_x_n557_s17 <= setup_light_unit_x_n557_s16;
            setup_light_unit_y_n630_s17 <= setup_light_unit_y_n630;
            setup_light_unit_y_n633_s17 <= setup_light_unit_y_n633;
            setup_light_unit_y_n748_s17 <= setup_light_unit_y_n748;
            setup_light_unit_y_n767_s17 <= setup_light_unit_y_n767_s16;
            setup_light_unit_y_n769_s17 <= setup_light_unit_y_n769_s16;
            setup_light_unit_y_n771_s17 <= setup_light_unit_y_n771_s16;
            setup_light_unit_z_n844_s17 <= setup_light_unit_z_n844;
            setup_light_unit_z_n847_s17 <= setup_light_unit_z_n847;
            setup_light_unit_z_n962_s17 <= setup_light_unit_z_n962;
            setup_light_unit_z_n981_s17 <= setup_light_unit_z_n981_s16;
            setup_light_unit_z_n983_s17 <= setup_light_unit_z_n983_s16;
            setup_light_unit_z_n985_s17 <= setup_light_unit_z_n985_s16;
            setup_half_unit_x_n1311_s17 <= setup_half_unit_x_n1311_s16;
            setup_half_unit_x_n1380_s17 <= setup_half_unit_x_n1380;
            setup_half_unit_x_n1383_s17 <= setup_half_unit_x_n1383;
            setup_half_unit_x_n1498_s17 <= setup_half_unit_x_n1498;
            setup_half_unit_x_n1518_s17 <= setup_half_unit_x_n1518_s16;
            setup_half_unit_x_n1520_s17 <= setup_half_unit_x_n1520_s16;
            setup_half_unit_x_n1522_s17 <= setup_half_unit_x_n1522_s16;
            setup_half_unit_y_n1595_s17 <= setup_half_unit_y_n1595;
            setup_half_unit_y_n1598_s17 <= setup_half_unit_y_n1598;
            setup_half_unit_y_n1713_s17 <= setup_half_unit_y_n1713;
            setup_half_unit_y_n1732_s17 <= setup_half_unit_y_n1732_s16;
            setup_half_unit_y_n1734_s17 <= setup_half_unit_y_n1734_s16;
            setup_half_unit_y_n1736_s17 <= setup_half_unit_y_n1736_s16;
            setup_half_unit_z_n1809_s17 <= setup_half_unit_z_n1809;
            setup_half_unit_z_n1812_s17 <= setup_half_unit_z_n1812;
            setup_half_unit_z_n1927_s17 <= setup_half_unit_z_n1927;
            setup_half_unit_z_n1946_s17 <= setup_half_unit_z_n1946_s16;
            setup_half_unit_z_n1948_s17 <= setup_half_unit_z_n1948_s16;
            setup_half_unit_z_n1950_s17 <= setup_half_unit_z_n1950_s16;
            setup_bump_unit_x_n2216_s17 <= setup_bump_unit_x_n2216_s16;
            setup_bump_unit_x_n2347_s17 <= setup_bump_unit_x_n2347;
            setup_bump_unit_x_n2350_s17 <= setup_bump_unit_x_n2350;
            setup_bump_unit_x_n2405_s17 <= setup_bump_unit_x_n2405;
            setup_bump_unit_x_n2415_s17 <= setup_bump_unit_x_n2415_s16;
            setup_bump_unit_x_n2417_s17 <= setup_bump_unit_x_n2417_s16;
            setup_bump_unit_x_n2419_s17 <= setup_bump_unit_x_n2419_s16;
            setup_bump_unit_y_n2554_s17 <= setup_bump_unit_y_n2554;
            setup_bump_unit_y_n2557_s17 <= setup_bump_unit_y_n2557;
            setup_bump_unit_y_n2612_s17 <= setup_bump_unit_y_n2612;
            setup_bump_unit_y_n2621_s17 <= setup_bump_unit_y_n2621_s16;
            setup_bump_unit_y_n2623_s17 <= setup_bump_unit_y_n2623_s16;
            setup_bump_unit_y_n2625_s17 <= setup_bump_unit_y_n2625_s16;
            setup_bump_unit_z_n2760_s17 <= setup_bump_unit_z_n2760;
            setup_bump_unit_z_n2763_s17 <= setup_bump_unit_z_n2763;
            setup_bump_unit_z_n2818_s17 <= setup_bump_unit_z_n2818;
            setup_bump_unit_z_n2827_s17 <= setup_bump_unit_z_n2827_s16;
            setup_bump_unit_z_n2829_s17 <= setup_bump_unit_z_n2829_s16;
            setup_bump_unit_z_n2831_s17 <= setup_bump_unit_z_n2831_s16;
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n419_term = {3'h0, setup_light_unit_x_n344_s17} ^ {26{setup_light_unit_x_n415_s17}};
    wire signed [25:0] setup_light_unit_x_n419 = {setup_light_unit_x_n418_s17[24], setup_light_unit_x_n418_s17} + setup_light_unit_x_n419_term + {25'h0, setup_light_unit_x_n415_s17}; // s26f0
    wire signed [23:0] setup_light_unit_x_n420 = setup_light_unit_x_n419[23:0]; // s24f0
    wire setup_light_unit_x_n421 = setup_light_unit_x_n420[23]; // u1f0
    wire setup_light_unit_x_n422 = setup_light_unit_x_n421 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n423 = setup_light_unit_x_n420; // u24f0
    wire [24:0] setup_light_unit_x_n424 = {setup_light_unit_x_n423, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n425 = setup_light_unit_x_n424; // s25f0
    wire [25:0] setup_light_unit_x_n426_term = {3'h0, setup_light_unit_x_n344_s17} ^ {26{setup_light_unit_x_n422}};
    wire signed [25:0] setup_light_unit_x_n426 = {setup_light_unit_x_n425[24], setup_light_unit_x_n425} + setup_light_unit_x_n426_term + {25'h0, setup_light_unit_x_n422}; // s26f0
    wire signed [23:0] setup_light_unit_x_n427 = setup_light_unit_x_n426[23:0]; // s24f0
    wire setup_light_unit_x_n428 = setup_light_unit_x_n427[23]; // u1f0
    wire setup_light_unit_x_n429 = setup_light_unit_x_n428 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n430 = setup_light_unit_x_n427; // u24f0
    wire [24:0] setup_light_unit_x_n431 = {setup_light_unit_x_n430, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n432 = setup_light_unit_x_n431; // s25f0
    wire [3:0] setup_light_unit_x_n534 = {setup_light_unit_x_n533_s17, setup_light_unit_x_n422}; // u4f0
    wire [4:0] setup_light_unit_x_n535 = {setup_light_unit_x_n534, setup_light_unit_x_n429}; // u5f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n634_term = {3'h0, setup_light_unit_x_n344_s17} ^ {26{setup_light_unit_y_n630_s17}};
    wire signed [25:0] setup_light_unit_y_n634 = {setup_light_unit_y_n633_s17[24], setup_light_unit_y_n633_s17} + setup_light_unit_y_n634_term + {25'h0, setup_light_unit_y_n630_s17}; // s26f0
    wire signed [23:0] setup_light_unit_y_n635 = setup_light_unit_y_n634[23:0]; // s24f0
    wire setup_light_unit_y_n636 = setup_light_unit_y_n635[23]; // u1f0
    wire setup_light_unit_y_n637 = setup_light_unit_y_n636 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n638 = setup_light_unit_y_n635; // u24f0
    wire [24:0] setup_light_unit_y_n639 = {setup_light_unit_y_n638, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n640 = setup_light_unit_y_n639; // s25f0
    wire [25:0] setup_light_unit_y_n641_term = {3'h0, setup_light_unit_x_n344_s17} ^ {26{setup_light_unit_y_n637}};
    wire signed [25:0] setup_light_unit_y_n641 = {setup_light_unit_y_n640[24], setup_light_unit_y_n640} + setup_light_unit_y_n641_term + {25'h0, setup_light_unit_y_n637}; // s26f0
    wire signed [23:0] setup_light_unit_y_n642 = setup_light_unit_y_n641[23:0]; // s24f0
    wire setup_light_unit_y_n643 = setup_light_unit_y_n642[23]; // u1f0
    wire setup_light_unit_y_n644 = setup_light_unit_y_n643 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n645 = setup_light_unit_y_n642; // u24f0
    wire [24:0] setup_light_unit_y_n646 = {setup_light_unit_y_n645, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n647 = setup_light_unit_y_n646; // s25f0
    wire [3:0] setup_light_unit_y_n749 = {setup_light_unit_y_n748_s17, setup_light_unit_y_n637}; // u4f0
    wire [4:0] setup_light_unit_y_n750 = {setup_light_unit_y_n749, setup_light_unit_y_n644}; // u5f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n848_term = {3'h0, setup_light_unit_x_n344_s17} ^ {26{setup_light_unit_z_n844_s17}};
    wire signed [25:0] setup_light_unit_z_n848 = {setup_light_unit_z_n847_s17[24], setup_light_unit_z_n847_s17} + setup_light_unit_z_n848_term + {25'h0, setup_light_unit_z_n844_s17}; // s26f0
    wire signed [23:0] setup_light_unit_z_n849 = setup_light_unit_z_n848[23:0]; // s24f0
    wire setup_light_unit_z_n850 = setup_light_unit_z_n849[23]; // u1f0
    wire setup_light_unit_z_n851 = setup_light_unit_z_n850 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n852 = setup_light_unit_z_n849; // u24f0
    wire [24:0] setup_light_unit_z_n853 = {setup_light_unit_z_n852, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n854 = setup_light_unit_z_n853; // s25f0
    wire [25:0] setup_light_unit_z_n855_term = {3'h0, setup_light_unit_x_n344_s17} ^ {26{setup_light_unit_z_n851}};
    wire signed [25:0] setup_light_unit_z_n855 = {setup_light_unit_z_n854[24], setup_light_unit_z_n854} + setup_light_unit_z_n855_term + {25'h0, setup_light_unit_z_n851}; // s26f0
    wire signed [23:0] setup_light_unit_z_n856 = setup_light_unit_z_n855[23:0]; // s24f0
    wire setup_light_unit_z_n857 = setup_light_unit_z_n856[23]; // u1f0
    wire setup_light_unit_z_n858 = setup_light_unit_z_n857 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n859 = setup_light_unit_z_n856; // u24f0
    wire [24:0] setup_light_unit_z_n860 = {setup_light_unit_z_n859, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n861 = setup_light_unit_z_n860; // s25f0
    wire [3:0] setup_light_unit_z_n963 = {setup_light_unit_z_n962_s17, setup_light_unit_z_n851}; // u4f0
    wire [4:0] setup_light_unit_z_n964 = {setup_light_unit_z_n963, setup_light_unit_z_n858}; // u5f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1384_term = {3'h0, setup_half_unit_x_n1311_s17} ^ {26{setup_half_unit_x_n1380_s17}};
    wire signed [25:0] setup_half_unit_x_n1384 = {setup_half_unit_x_n1383_s17[24], setup_half_unit_x_n1383_s17} + setup_half_unit_x_n1384_term + {25'h0, setup_half_unit_x_n1380_s17}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1385 = setup_half_unit_x_n1384[23:0]; // s24f0
    wire setup_half_unit_x_n1386 = setup_half_unit_x_n1385[23]; // u1f0
    wire setup_half_unit_x_n1387 = setup_half_unit_x_n1386 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1388 = setup_half_unit_x_n1385; // u24f0
    wire [24:0] setup_half_unit_x_n1389 = {setup_half_unit_x_n1388, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1390 = setup_half_unit_x_n1389; // s25f0
    wire [25:0] setup_half_unit_x_n1391_term = {3'h0, setup_half_unit_x_n1311_s17} ^ {26{setup_half_unit_x_n1387}};
    wire signed [25:0] setup_half_unit_x_n1391 = {setup_half_unit_x_n1390[24], setup_half_unit_x_n1390} + setup_half_unit_x_n1391_term + {25'h0, setup_half_unit_x_n1387}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1392 = setup_half_unit_x_n1391[23:0]; // s24f0
    wire setup_half_unit_x_n1393 = setup_half_unit_x_n1392[23]; // u1f0
    wire setup_half_unit_x_n1394 = setup_half_unit_x_n1393 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1395 = setup_half_unit_x_n1392; // u24f0
    wire [24:0] setup_half_unit_x_n1396 = {setup_half_unit_x_n1395, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1397 = setup_half_unit_x_n1396; // s25f0
    wire [3:0] setup_half_unit_x_n1499 = {setup_half_unit_x_n1498_s17, setup_half_unit_x_n1387}; // u4f0
    wire [4:0] setup_half_unit_x_n1500 = {setup_half_unit_x_n1499, setup_half_unit_x_n1394}; // u5f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1599_term = {3'h0, setup_half_unit_x_n1311_s17} ^ {26{setup_half_unit_y_n1595_s17}};
    wire signed [25:0] setup_half_unit_y_n1599 = {setup_half_unit_y_n1598_s17[24], setup_half_unit_y_n1598_s17} + setup_half_unit_y_n1599_term + {25'h0, setup_half_unit_y_n1595_s17}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1600 = setup_half_unit_y_n1599[23:0]; // s24f0
    wire setup_half_unit_y_n1601 = setup_half_unit_y_n1600[23]; // u1f0
    wire setup_half_unit_y_n1602 = setup_half_unit_y_n1601 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1603 = setup_half_unit_y_n1600; // u24f0
    wire [24:0] setup_half_unit_y_n1604 = {setup_half_unit_y_n1603, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1605 = setup_half_unit_y_n1604; // s25f0
    wire [25:0] setup_half_unit_y_n1606_term = {3'h0, setup_half_unit_x_n1311_s17} ^ {26{setup_half_unit_y_n1602}};
    wire signed [25:0] setup_half_unit_y_n1606 = {setup_half_unit_y_n1605[24], setup_half_unit_y_n1605} + setup_half_unit_y_n1606_term + {25'h0, setup_half_unit_y_n1602}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1607 = setup_half_unit_y_n1606[23:0]; // s24f0
    wire setup_half_unit_y_n1608 = setup_half_unit_y_n1607[23]; // u1f0
    wire setup_half_unit_y_n1609 = setup_half_unit_y_n1608 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1610 = setup_half_unit_y_n1607; // u24f0
    wire [24:0] setup_half_unit_y_n1611 = {setup_half_unit_y_n1610, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1612 = setup_half_unit_y_n1611; // s25f0
    wire [3:0] setup_half_unit_y_n1714 = {setup_half_unit_y_n1713_s17, setup_half_unit_y_n1602}; // u4f0
    wire [4:0] setup_half_unit_y_n1715 = {setup_half_unit_y_n1714, setup_half_unit_y_n1609}; // u5f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1813_term = {3'h0, setup_half_unit_x_n1311_s17} ^ {26{setup_half_unit_z_n1809_s17}};
    wire signed [25:0] setup_half_unit_z_n1813 = {setup_half_unit_z_n1812_s17[24], setup_half_unit_z_n1812_s17} + setup_half_unit_z_n1813_term + {25'h0, setup_half_unit_z_n1809_s17}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1814 = setup_half_unit_z_n1813[23:0]; // s24f0
    wire setup_half_unit_z_n1815 = setup_half_unit_z_n1814[23]; // u1f0
    wire setup_half_unit_z_n1816 = setup_half_unit_z_n1815 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1817 = setup_half_unit_z_n1814; // u24f0
    wire [24:0] setup_half_unit_z_n1818 = {setup_half_unit_z_n1817, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1819 = setup_half_unit_z_n1818; // s25f0
    wire [25:0] setup_half_unit_z_n1820_term = {3'h0, setup_half_unit_x_n1311_s17} ^ {26{setup_half_unit_z_n1816}};
    wire signed [25:0] setup_half_unit_z_n1820 = {setup_half_unit_z_n1819[24], setup_half_unit_z_n1819} + setup_half_unit_z_n1820_term + {25'h0, setup_half_unit_z_n1816}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1821 = setup_half_unit_z_n1820[23:0]; // s24f0
    wire setup_half_unit_z_n1822 = setup_half_unit_z_n1821[23]; // u1f0
    wire setup_half_unit_z_n1823 = setup_half_unit_z_n1822 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1824 = setup_half_unit_z_n1821; // u24f0
    wire [24:0] setup_half_unit_z_n1825 = {setup_half_unit_z_n1824, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1826 = setup_half_unit_z_n1825; // s25f0
    wire [3:0] setup_half_unit_z_n1928 = {setup_half_unit_z_n1927_s17, setup_half_unit_z_n1816}; // u4f0
    wire [4:0] setup_half_unit_z_n1929 = {setup_half_unit_z_n1928, setup_half_unit_z_n1823}; // u5f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2351_term = {3'h0, setup_bump_unit_x_n2216_s17} ^ {26{setup_bump_unit_x_n2347_s17}};
    wire signed [25:0] setup_bump_unit_x_n2351 = {setup_bump_unit_x_n2350_s17[24], setup_bump_unit_x_n2350_s17} + setup_bump_unit_x_n2351_term + {25'h0, setup_bump_unit_x_n2347_s17}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2352 = setup_bump_unit_x_n2351[23:0]; // s24f0
    wire setup_bump_unit_x_n2353 = setup_bump_unit_x_n2352[23]; // u1f0
    wire setup_bump_unit_x_n2354 = setup_bump_unit_x_n2353 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2355 = setup_bump_unit_x_n2352; // u24f0
    wire [24:0] setup_bump_unit_x_n2356 = {setup_bump_unit_x_n2355, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2357 = setup_bump_unit_x_n2356; // s25f0
    wire [25:0] setup_bump_unit_x_n2358_term = {3'h0, setup_bump_unit_x_n2216_s17} ^ {26{setup_bump_unit_x_n2354}};
    wire signed [25:0] setup_bump_unit_x_n2358 = {setup_bump_unit_x_n2357[24], setup_bump_unit_x_n2357} + setup_bump_unit_x_n2358_term + {25'h0, setup_bump_unit_x_n2354}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2359 = setup_bump_unit_x_n2358[23:0]; // s24f0
    wire setup_bump_unit_x_n2360 = setup_bump_unit_x_n2359[23]; // u1f0
    wire setup_bump_unit_x_n2361 = setup_bump_unit_x_n2360 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2362 = setup_bump_unit_x_n2359; // u24f0
    wire [24:0] setup_bump_unit_x_n2363 = {setup_bump_unit_x_n2362, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2364 = setup_bump_unit_x_n2363; // s25f0
    wire [13:0] setup_bump_unit_x_n2406 = {setup_bump_unit_x_n2405_s17, setup_bump_unit_x_n2354}; // u14f0
    wire [14:0] setup_bump_unit_x_n2407 = {setup_bump_unit_x_n2406, setup_bump_unit_x_n2361}; // u15f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2558_term = {3'h0, setup_bump_unit_x_n2216_s17} ^ {26{setup_bump_unit_y_n2554_s17}};
    wire signed [25:0] setup_bump_unit_y_n2558 = {setup_bump_unit_y_n2557_s17[24], setup_bump_unit_y_n2557_s17} + setup_bump_unit_y_n2558_term + {25'h0, setup_bump_unit_y_n2554_s17}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2559 = setup_bump_unit_y_n2558[23:0]; // s24f0
    wire setup_bump_unit_y_n2560 = setup_bump_unit_y_n2559[23]; // u1f0
    wire setup_bump_unit_y_n2561 = setup_bump_unit_y_n2560 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2562 = setup_bump_unit_y_n2559; // u24f0
    wire [24:0] setup_bump_unit_y_n2563 = {setup_bump_unit_y_n2562, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2564 = setup_bump_unit_y_n2563; // s25f0
    wire [25:0] setup_bump_unit_y_n2565_term = {3'h0, setup_bump_unit_x_n2216_s17} ^ {26{setup_bump_unit_y_n2561}};
    wire signed [25:0] setup_bump_unit_y_n2565 = {setup_bump_unit_y_n2564[24], setup_bump_unit_y_n2564} + setup_bump_unit_y_n2565_term + {25'h0, setup_bump_unit_y_n2561}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2566 = setup_bump_unit_y_n2565[23:0]; // s24f0
    wire setup_bump_unit_y_n2567 = setup_bump_unit_y_n2566[23]; // u1f0
    wire setup_bump_unit_y_n2568 = setup_bump_unit_y_n2567 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2569 = setup_bump_unit_y_n2566; // u24f0
    wire [24:0] setup_bump_unit_y_n2570 = {setup_bump_unit_y_n2569, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2571 = setup_bump_unit_y_n2570; // s25f0
    wire [13:0] setup_bump_unit_y_n2613 = {setup_bump_unit_y_n2612_s17, setup_bump_unit_y_n2561}; // u14f0
    wire [14:0] setup_bump_unit_y_n2614 = {setup_bump_unit_y_n2613, setup_bump_unit_y_n2568}; // u15f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2764_term = {3'h0, setup_bump_unit_x_n2216_s17} ^ {26{setup_bump_unit_z_n2760_s17}};
    wire signed [25:0] setup_bump_unit_z_n2764 = {setup_bump_unit_z_n2763_s17[24], setup_bump_unit_z_n2763_s17} + setup_bump_unit_z_n2764_term + {25'h0, setup_bump_unit_z_n2760_s17}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2765 = setup_bump_unit_z_n2764[23:0]; // s24f0
    wire setup_bump_unit_z_n2766 = setup_bump_unit_z_n2765[23]; // u1f0
    wire setup_bump_unit_z_n2767 = setup_bump_unit_z_n2766 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2768 = setup_bump_unit_z_n2765; // u24f0
    wire [24:0] setup_bump_unit_z_n2769 = {setup_bump_unit_z_n2768, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2770 = setup_bump_unit_z_n2769; // s25f0
    wire [25:0] setup_bump_unit_z_n2771_term = {3'h0, setup_bump_unit_x_n2216_s17} ^ {26{setup_bump_unit_z_n2767}};
    wire signed [25:0] setup_bump_unit_z_n2771 = {setup_bump_unit_z_n2770[24], setup_bump_unit_z_n2770} + setup_bump_unit_z_n2771_term + {25'h0, setup_bump_unit_z_n2767}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2772 = setup_bump_unit_z_n2771[23:0]; // s24f0
    wire setup_bump_unit_z_n2773 = setup_bump_unit_z_n2772[23]; // u1f0
    wire setup_bump_unit_z_n2774 = setup_bump_unit_z_n2773 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2775 = setup_bump_unit_z_n2772; // u24f0
    wire [24:0] setup_bump_unit_z_n2776 = {setup_bump_unit_z_n2775, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2777 = setup_bump_unit_z_n2776; // s25f0
    wire [13:0] setup_bump_unit_z_n2819 = {setup_bump_unit_z_n2818_s17, setup_bump_unit_z_n2767}; // u14f0
    wire [14:0] setup_bump_unit_z_n2820 = {setup_bump_unit_z_n2819, setup_bump_unit_z_n2774}; // u15f0

    reg [22:0] setup_light_unit_x_n344_s18; // u23f0
    reg setup_light_unit_x_n429_s18; // u1f0
    reg signed [24:0] setup_light_unit_x_n432_s18; // s25f0
    reg [4:0] setup_light_unit_x_n535_s18; // u5f0
    reg setup_light_unit_x_n553_s18; // u1f0
    reg setup_light_unit_x_n555_s18; // u1f0
    reg setup_light_unit_x_n557_s18; // u1f0
    reg setup_light_unit_y_n644_s18; // u1f0
    reg signed [24:0] setup_light_unit_y_n647_s18; // s25f0
    reg [4:0] setup_light_unit_y_n750_s18; // u5f0
    reg setup_light_unit_y_n767_s18; // u1f0
    reg setup_light_unit_y_n769_s18; // u1f0
    reg setup_light_unit_y_n771_s18; // u1f0
    reg setup_light_unit_z_n858_s18; // u1f0
    reg signed [24:0] setup_light_unit_z_n861_s18; // s25f0
    reg [4:0] setup_light_unit_z_n964_s18; // u5f0
    reg setup_light_unit_z_n981_s18; // u1f0
    reg setup_light_unit_z_n983_s18; // u1f0
    reg setup_light_unit_z_n985_s18; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s18; // u23f0
    reg setup_half_unit_x_n1394_s18; // u1f0
    reg signed [24:0] setup_half_unit_x_n1397_s18; // s25f0
    reg [4:0] setup_half_unit_x_n1500_s18; // u5f0
    reg setup_half_unit_x_n1518_s18; // u1f0
    reg setup_half_unit_x_n1520_s18; // u1f0
    reg setup_half_unit_x_n1522_s18; // u1f0
    reg setup_half_unit_y_n1609_s18; // u1f0
    reg signed [24:0] setup_half_unit_y_n1612_s18; // s25f0
    reg [4:0] setup_half_unit_y_n1715_s18; // u5f0
    reg setup_half_unit_y_n1732_s18; // u1f0
    reg setup_half_unit_y_n1734_s18; // u1f0
    reg setup_half_unit_y_n1736_s18; // u1f0
    reg setup_half_unit_z_n1823_s18; // u1f0
    reg signed [24:0] setup_half_unit_z_n1826_s18; // s25f0
    reg [4:0] setup_half_unit_z_n1929_s18; // u5f0
    reg setup_half_unit_z_n1946_s18; // u1f0
    reg setup_half_unit_z_n1948_s18; // u1f0
    reg setup_half_unit_z_n1950_s18; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s18; // u23f0
    reg setup_bump_unit_x_n2361_s18; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2364_s18; // s25f0
    reg [14:0] setup_bump_unit_x_n2407_s18; // u15f0
    reg setup_bump_unit_x_n2415_s18; // u1f0
    reg setup_bump_unit_x_n2417_s18; // u1f0
    reg setup_bump_unit_x_n2419_s18; // u1f0
    reg setup_bump_unit_y_n2568_s18; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2571_s18; // s25f0
    reg [14:0] setup_bump_unit_y_n2614_s18; // u15f0
    reg setup_bump_unit_y_n2621_s18; // u1f0
    reg setup_bump_unit_y_n2623_s18; // u1f0
    reg setup_bump_unit_y_n2625_s18; // u1f0
    reg setup_bump_unit_z_n2774_s18; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2777_s18; // s25f0
    reg [14:0] setup_bump_unit_z_n2820_s18; // u15f0
    reg setup_bump_unit_z_n2827_s18; // u1f0
    reg setup_bump_unit_z_n2829_s18; // u1f0
    reg setup_bump_unit_z_n2831_s18; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s18 <= setup_light_unit_x_n344_s17;
            setup_light_unit_x_n429_s18 <= setup_light_unit_x_n429;
            setup_light_unit_x_n432_s18 <= setup_light_unit_x_n432;
            setup_light_unit_x_n535_s18 <= setup_light_unit_x_n535;
            setup_light_unit_x_n553_s18 <= setup_light_unit_x_n553_s17;
            setup_light_unit_x_n555_s18 <= setup_light_unit_x_n555_s17;
            setup_light_unit_x_n557_s18 <= setup_light_unit_x_n557_s17;
            setup_light_unit_y_n644_s18 <= setup_light_unit_y_n644;
            setup_light_unit_y_n647_s18 <= setup_light_unit_y_n647;
            setup_light_unit_y_n750_s18 <= setup_light_unit_y_n750;
            setup_light_unit_y_n767_s18 <= setup_light_unit_y_n767_s17;
            setup_light_unit_y_n769_s18 <= setup_light_unit_y_n769_s17;
            setup_light_unit_y_n771_s18 <= setup_light_unit_y_n771_s17;
            setup_light_unit_z_n858_s18 <= setup_light_unit_z_n858;
            setup_light_unit_z_n861_s18 <= setup_light_unit_z_n861;
            setup_light_unit_z_n964_s18 <= setup_light_unit_z_n964;
            setup_light_unit_z_n981_s18 <= setup_light_unit_z_n981_s17;
            setup_light_unit_z_n983_s18 <= setup_light_unit_z_n983_s17;
            setup_light_unit_z_n985_s18 <= setup_light_unit_z_n985_s17;
            setup_half_unit_x_n1311_s18 <= setup_half_unit_x_n1311_s17;
            setup_half_unit_x_n1394_s18 <= setup_half_unit_x_n1394;
            setup_half_unit_x_n1397_s18 <= setup_half_unit_x_n1397;
            setup_half_unit_x_n1500_s18 <= setup_half_unit_x_n1500;
            setup_half_unit_x_n1518_s18 <= setup_half_unit_x_n1518_s17;
            setup_half_unit_x_n1520_s18 <= setup_half_unit_x_n1520_s17;
            setup_half_unit_x_n1522_s18 <= setup_half_unit_x_n1522_s17;
            setup_half_unit_y_n1609_s18 <= setup_half_unit_y_n1609;
            setup_half_unit_y_n1612_s18 <= setup_half_unit_y_n1612;
            setup_half_unit_y_n1715_s18 <= setup_half_unit_y_n1715;
            setup_half_unit_y_n1732_s18 <= setup_half_unit_y_n1732_s17;
            setup_half_unit_y_n1734_s18 <= setup_half_unit_y_n1734_s17;
            setup_half_unit_y_n1736_s18 <= setup_half_unit_y_n1736_s17;
            setup_half_unit_z_n1823_s18 <= setup_half_unit_z_n1823;
            setup_half_unit_z_n1826_s18 <= setup_half_unit_z_n1826;
            setup_half_unit_z_n1929_s18 <= setup_half_unit_z_n1929;
            setup_half_unit_z_n1946_s18 <= setup_half_unit_z_n1946_s17;
            setup_half_unit_z_n1948_s18 <= setup_half_unit_z_n1948_s17;
            setup_half_unit_z_n1950_s18 <= setup_half_unit_z_n1950_s17;
            setup_bump_unit_x_n2216_s18 <= setup_bump_unit_x_n2216_s17;
            setup_bump_unit_x_n2361_s18 <= setup_bump_unit_x_n2361;
            setup_bump_unit_x_n2364_s18 <= setup_bump_unit_x_n2364;
            setup_bump_unit_x_n2407_s18 <= setup_bump_unit_x_n2407;
            setup_bump_unit_x_n2415_s18 <= setup_bump_unit_x_n2415_s17;
            setup_bump_unit_x_n2417_s18 <= setup_bump_unit_x_n2417_s17;
            setup_bump_unit_x_n2419_s18 <= setup_bump_unit_x_n2419_s17;
            setup_bump_unit_y_n2568_s18 <= setup_bump_unit_y_n2568;
            setup_bump_unit_y_n2571_s18 <= setup_bump_unit_y_n2571;
            setup_bump_unit_y_n2614_s18 <= setup_bump_unit_y_n2614;
            setup_bump_unit_y_n2621_s18 <= setup_bump_unit_y_n2621_s17;
            setup_bump_unit_y_n2623_s18 <= setup_bump_unit_y_n2623_s17;
            setup_bump_unit_y_n2625_s18 <= setup_bump_unit_y_n2625_s17;
            setup_bump_unit_z_n2774_s18 <= setup_bump_unit_z_n2774;
            setup_bump_unit_z_n2777_s18 <= setup_bump_unit_z_n2777;
            setup_bump_unit_z_n2820_s18 <= setup_bump_unit_z_n2820;
            setup_bump_unit_z_n2827_s18 <= setup_bump_unit_z_n2827_s17;
            setup_bump_unit_z_n2829_s18 <= setup_bump_unit_z_n2829_s17;
            setup_bump_unit_z_n2831_s18 <= setup_bump_unit_z_n2831_s17;
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n433_term = {3'h0, setup_light_unit_x_n344_s18} ^ {26{setup_light_unit_x_n429_s18}};
    wire signed [25:0] setup_light_unit_x_n433 = {setup_light_unit_x_n432_s18[24], setup_light_unit_x_n432_s18} + setup_light_unit_x_n433_term + {25'h0, setup_light_unit_x_n429_s18}; // s26f0
    wire signed [23:0] setup_light_unit_x_n434 = setup_light_unit_x_n433[23:0]; // s24f0
    wire setup_light_unit_x_n435 = setup_light_unit_x_n434[23]; // u1f0
    wire setup_light_unit_x_n436 = setup_light_unit_x_n435 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n437 = setup_light_unit_x_n434; // u24f0
    wire [24:0] setup_light_unit_x_n438 = {setup_light_unit_x_n437, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n439 = setup_light_unit_x_n438; // s25f0
    wire [25:0] setup_light_unit_x_n440_term = {3'h0, setup_light_unit_x_n344_s18} ^ {26{setup_light_unit_x_n436}};
    wire signed [25:0] setup_light_unit_x_n440 = {setup_light_unit_x_n439[24], setup_light_unit_x_n439} + setup_light_unit_x_n440_term + {25'h0, setup_light_unit_x_n436}; // s26f0
    wire signed [23:0] setup_light_unit_x_n441 = setup_light_unit_x_n440[23:0]; // s24f0
    wire setup_light_unit_x_n442 = setup_light_unit_x_n441[23]; // u1f0
    wire setup_light_unit_x_n443 = setup_light_unit_x_n442 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n444 = setup_light_unit_x_n441; // u24f0
    wire [24:0] setup_light_unit_x_n445 = {setup_light_unit_x_n444, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n446 = setup_light_unit_x_n445; // s25f0
    wire [5:0] setup_light_unit_x_n536 = {setup_light_unit_x_n535_s18, setup_light_unit_x_n436}; // u6f0
    wire [6:0] setup_light_unit_x_n537 = {setup_light_unit_x_n536, setup_light_unit_x_n443}; // u7f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n648_term = {3'h0, setup_light_unit_x_n344_s18} ^ {26{setup_light_unit_y_n644_s18}};
    wire signed [25:0] setup_light_unit_y_n648 = {setup_light_unit_y_n647_s18[24], setup_light_unit_y_n647_s18} + setup_light_unit_y_n648_term + {25'h0, setup_light_unit_y_n644_s18}; // s26f0
    wire signed [23:0] setup_light_unit_y_n649 = setup_light_unit_y_n648[23:0]; // s24f0
    wire setup_light_unit_y_n650 = setup_light_unit_y_n649[23]; // u1f0
    wire setup_light_unit_y_n651 = setup_light_unit_y_n650 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n652 = setup_light_unit_y_n649; // u24f0
    wire [24:0] setup_light_unit_y_n653 = {setup_light_unit_y_n652, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n654 = setup_light_unit_y_n653; // s25f0
    wire [25:0] setup_light_unit_y_n655_term = {3'h0, setup_light_unit_x_n344_s18} ^ {26{setup_light_unit_y_n651}};
    wire signed [25:0] setup_light_unit_y_n655 = {setup_light_unit_y_n654[24], setup_light_unit_y_n654} + setup_light_unit_y_n655_term + {25'h0, setup_light_unit_y_n651}; // s26f0
    wire signed [23:0] setup_light_unit_y_n656 = setup_light_unit_y_n655[23:0]; // s24f0
    wire setup_light_unit_y_n657 = setup_light_unit_y_n656[23]; // u1f0
    wire setup_light_unit_y_n658 = setup_light_unit_y_n657 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n659 = setup_light_unit_y_n656; // u24f0
    wire [24:0] setup_light_unit_y_n660 = {setup_light_unit_y_n659, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n661 = setup_light_unit_y_n660; // s25f0
    wire [5:0] setup_light_unit_y_n751 = {setup_light_unit_y_n750_s18, setup_light_unit_y_n651}; // u6f0
    wire [6:0] setup_light_unit_y_n752 = {setup_light_unit_y_n751, setup_light_unit_y_n658}; // u7f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n862_term = {3'h0, setup_light_unit_x_n344_s18} ^ {26{setup_light_unit_z_n858_s18}};
    wire signed [25:0] setup_light_unit_z_n862 = {setup_light_unit_z_n861_s18[24], setup_light_unit_z_n861_s18} + setup_light_unit_z_n862_term + {25'h0, setup_light_unit_z_n858_s18}; // s26f0
    wire signed [23:0] setup_light_unit_z_n863 = setup_light_unit_z_n862[23:0]; // s24f0
    wire setup_light_unit_z_n864 = setup_light_unit_z_n863[23]; // u1f0
    wire setup_light_unit_z_n865 = setup_light_unit_z_n864 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n866 = setup_light_unit_z_n863; // u24f0
    wire [24:0] setup_light_unit_z_n867 = {setup_light_unit_z_n866, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n868 = setup_light_unit_z_n867; // s25f0
    wire [25:0] setup_light_unit_z_n869_term = {3'h0, setup_light_unit_x_n344_s18} ^ {26{setup_light_unit_z_n865}};
    wire signed [25:0] setup_light_unit_z_n869 = {setup_light_unit_z_n868[24], setup_light_unit_z_n868} + setup_light_unit_z_n869_term + {25'h0, setup_light_unit_z_n865}; // s26f0
    wire signed [23:0] setup_light_unit_z_n870 = setup_light_unit_z_n869[23:0]; // s24f0
    wire setup_light_unit_z_n871 = setup_light_unit_z_n870[23]; // u1f0
    wire setup_light_unit_z_n872 = setup_light_unit_z_n871 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n873 = setup_light_unit_z_n870; // u24f0
    wire [24:0] setup_light_unit_z_n874 = {setup_light_unit_z_n873, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n875 = setup_light_unit_z_n874; // s25f0
    wire [5:0] setup_light_unit_z_n965 = {setup_light_unit_z_n964_s18, setup_light_unit_z_n865}; // u6f0
    wire [6:0] setup_light_unit_z_n966 = {setup_light_unit_z_n965, setup_light_unit_z_n872}; // u7f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1398_term = {3'h0, setup_half_unit_x_n1311_s18} ^ {26{setup_half_unit_x_n1394_s18}};
    wire signed [25:0] setup_half_unit_x_n1398 = {setup_half_unit_x_n1397_s18[24], setup_half_unit_x_n1397_s18} + setup_half_unit_x_n1398_term + {25'h0, setup_half_unit_x_n1394_s18}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1399 = setup_half_unit_x_n1398[23:0]; // s24f0
    wire setup_half_unit_x_n1400 = setup_half_unit_x_n1399[23]; // u1f0
    wire setup_half_unit_x_n1401 = setup_half_unit_x_n1400 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1402 = setup_half_unit_x_n1399; // u24f0
    wire [24:0] setup_half_unit_x_n1403 = {setup_half_unit_x_n1402, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1404 = setup_half_unit_x_n1403; // s25f0
    wire [25:0] setup_half_unit_x_n1405_term = {3'h0, setup_half_unit_x_n1311_s18} ^ {26{setup_half_unit_x_n1401}};
    wire signed [25:0] setup_half_unit_x_n1405 = {setup_half_unit_x_n1404[24], setup_half_unit_x_n1404} + setup_half_unit_x_n1405_term + {25'h0, setup_half_unit_x_n1401}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1406 = setup_half_unit_x_n1405[23:0]; // s24f0
    wire setup_half_unit_x_n1407 = setup_half_unit_x_n1406[23]; // u1f0
    wire setup_half_unit_x_n1408 = setup_half_unit_x_n1407 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1409 = setup_half_unit_x_n1406; // u24f0
    wire [24:0] setup_half_unit_x_n1410 = {setup_half_unit_x_n1409, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1411 = setup_half_unit_x_n1410; // s25f0
    wire [5:0] setup_half_unit_x_n1501 = {setup_half_unit_x_n1500_s18, setup_half_unit_x_n1401}; // u6f0
    wire [6:0] setup_half_unit_x_n1502 = {setup_half_unit_x_n1501, setup_half_unit_x_n1408}; // u7f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1613_term = {3'h0, setup_half_unit_x_n1311_s18} ^ {26{setup_half_unit_y_n1609_s18}};
    wire signed [25:0] setup_half_unit_y_n1613 = {setup_half_unit_y_n1612_s18[24], setup_half_unit_y_n1612_s18} + setup_half_unit_y_n1613_term + {25'h0, setup_half_unit_y_n1609_s18}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1614 = setup_half_unit_y_n1613[23:0]; // s24f0
    wire setup_half_unit_y_n1615 = setup_half_unit_y_n1614[23]; // u1f0
    wire setup_half_unit_y_n1616 = setup_half_unit_y_n1615 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1617 = setup_half_unit_y_n1614; // u24f0
    wire [24:0] setup_half_unit_y_n1618 = {setup_half_unit_y_n1617, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1619 = setup_half_unit_y_n1618; // s25f0
    wire [25:0] setup_half_unit_y_n1620_term = {3'h0, setup_half_unit_x_n1311_s18} ^ {26{setup_half_unit_y_n1616}};
    wire signed [25:0] setup_half_unit_y_n1620 = {setup_half_unit_y_n1619[24], setup_half_unit_y_n1619} + setup_half_unit_y_n1620_term + {25'h0, setup_half_unit_y_n1616}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1621 = setup_half_unit_y_n1620[23:0]; // s24f0
    wire setup_half_unit_y_n1622 = setup_half_unit_y_n1621[23]; // u1f0
    wire setup_half_unit_y_n1623 = setup_half_unit_y_n1622 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1624 = setup_half_unit_y_n1621; // u24f0
    wire [24:0] setup_half_unit_y_n1625 = {setup_half_unit_y_n1624, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1626 = setup_half_unit_y_n1625; // s25f0
    wire [5:0] setup_half_unit_y_n1716 = {setup_half_unit_y_n1715_s18, setup_half_unit_y_n1616}; // u6f0
    wire [6:0] setup_half_unit_y_n1717 = {setup_half_unit_y_n1716, setup_half_unit_y_n1623}; // u7f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1827_term = {3'h0, setup_half_unit_x_n1311_s18} ^ {26{setup_half_unit_z_n1823_s18}};
    wire signed [25:0] setup_half_unit_z_n1827 = {setup_half_unit_z_n1826_s18[24], setup_half_unit_z_n1826_s18} + setup_half_unit_z_n1827_term + {25'h0, setup_half_unit_z_n1823_s18}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1828 = setup_half_unit_z_n1827[23:0]; // s24f0
    wire setup_half_unit_z_n1829 = setup_half_unit_z_n1828[23]; // u1f0
    wire setup_half_unit_z_n1830 = setup_half_unit_z_n1829 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1831 = setup_half_unit_z_n1828; // u24f0
    wire [24:0] setup_half_unit_z_n1832 = {setup_half_unit_z_n1831, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1833 = setup_half_unit_z_n1832; // s25f0
    wire [25:0] setup_half_unit_z_n1834_term = {3'h0, setup_half_unit_x_n1311_s18} ^ {26{setup_half_unit_z_n1830}};
    wire signed [25:0] setup_half_unit_z_n1834 = {setup_half_unit_z_n1833[24], setup_half_unit_z_n1833} + setup_half_unit_z_n1834_term + {25'h0, setup_half_unit_z_n1830}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1835 = setup_half_unit_z_n1834[23:0]; // s24f0
    wire setup_half_unit_z_n1836 = setup_half_unit_z_n1835[23]; // u1f0
    wire setup_half_unit_z_n1837 = setup_half_unit_z_n1836 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1838 = setup_half_unit_z_n1835; // u24f0
    wire [24:0] setup_half_unit_z_n1839 = {setup_half_unit_z_n1838, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1840 = setup_half_unit_z_n1839; // s25f0
    wire [5:0] setup_half_unit_z_n1930 = {setup_half_unit_z_n1929_s18, setup_half_unit_z_n1830}; // u6f0
    wire [6:0] setup_half_unit_z_n1931 = {setup_half_unit_z_n1930, setup_half_unit_z_n1837}; // u7f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2365_term = {3'h0, setup_bump_unit_x_n2216_s18} ^ {26{setup_bump_unit_x_n2361_s18}};
    wire signed [25:0] setup_bump_unit_x_n2365 = {setup_bump_unit_x_n2364_s18[24], setup_bump_unit_x_n2364_s18} + setup_bump_unit_x_n2365_term + {25'h0, setup_bump_unit_x_n2361_s18}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2366 = setup_bump_unit_x_n2365[23:0]; // s24f0
    wire setup_bump_unit_x_n2367 = setup_bump_unit_x_n2366[23]; // u1f0
    wire setup_bump_unit_x_n2368 = setup_bump_unit_x_n2367 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2369 = setup_bump_unit_x_n2366; // u24f0
    wire [24:0] setup_bump_unit_x_n2370 = {setup_bump_unit_x_n2369, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2371 = setup_bump_unit_x_n2370; // s25f0
    wire [25:0] setup_bump_unit_x_n2372_term = {3'h0, setup_bump_unit_x_n2216_s18} ^ {26{setup_bump_unit_x_n2368}};
    wire signed [25:0] setup_bump_unit_x_n2372 = {setup_bump_unit_x_n2371[24], setup_bump_unit_x_n2371} + setup_bump_unit_x_n2372_term + {25'h0, setup_bump_unit_x_n2368}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2373 = setup_bump_unit_x_n2372[23:0]; // s24f0
    wire setup_bump_unit_x_n2374 = setup_bump_unit_x_n2373[23]; // u1f0
    wire setup_bump_unit_x_n2375 = setup_bump_unit_x_n2374 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2376 = setup_bump_unit_x_n2373; // u24f0
    wire [24:0] setup_bump_unit_x_n2377 = {setup_bump_unit_x_n2376, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2378 = setup_bump_unit_x_n2377; // s25f0
    wire [15:0] setup_bump_unit_x_n2408 = {setup_bump_unit_x_n2407_s18, setup_bump_unit_x_n2368}; // u16f0
    wire [16:0] setup_bump_unit_x_n2409 = {setup_bump_unit_x_n2408, setup_bump_unit_x_n2375}; // u17f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2572_term = {3'h0, setup_bump_unit_x_n2216_s18} ^ {26{setup_bump_unit_y_n2568_s18}};
    wire signed [25:0] setup_bump_unit_y_n2572 = {setup_bump_unit_y_n2571_s18[24], setup_bump_unit_y_n2571_s18} + setup_bump_unit_y_n2572_term + {25'h0, setup_bump_unit_y_n2568_s18}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2573 = setup_bump_unit_y_n2572[23:0]; // s24f0
    wire setup_bump_unit_y_n2574 = setup_bump_unit_y_n2573[23]; // u1f0
    wire setup_bump_unit_y_n2575 = setup_bump_unit_y_n2574 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2576 = setup_bump_unit_y_n2573; // u24f0
    wire [24:0] setup_bump_unit_y_n2577 = {setup_bump_unit_y_n2576, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2578 = setup_bump_unit_y_n2577; // s25f0
    wire [25:0] setup_bump_unit_y_n2579_term = {3'h0, setup_bump_unit_x_n2216_s18} ^ {26{setup_bump_unit_y_n2575}};
    wire signed [25:0] setup_bump_unit_y_n2579 = {setup_bump_unit_y_n2578[24], setup_bump_unit_y_n2578} + setup_bump_unit_y_n2579_term + {25'h0, setup_bump_unit_y_n2575}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2580 = setup_bump_unit_y_n2579[23:0]; // s24f0
    wire setup_bump_unit_y_n2581 = setup_bump_unit_y_n2580[23]; // u1f0
    wire setup_bump_unit_y_n2582 = setup_bump_unit_y_n2581 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2583 = setup_bump_unit_y_n2580; // u24f0
    wire [24:0] setup_bump_unit_y_n2584 = {setup_bump_unit_y_n2583, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2585 = setup_bump_unit_y_n2584; // s25f0
    wire [15:0] setup_bump_unit_y_n2615 = {setup_bump_unit_y_n2614_s18, setup_bump_unit_y_n2575}; // u16f0
    wire [16:0] setup_bump_unit_y_n2616 = {setup_bump_unit_y_n2615, setup_bump_unit_y_n2582}; // u17f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2778_term = {3'h0, setup_bump_unit_x_n2216_s18} ^ {26{setup_bump_unit_z_n2774_s18}};
    wire signed [25:0] setup_bump_unit_z_n2778 = {setup_bump_unit_z_n2777_s18[24], setup_bump_unit_z_n2777_s18} + setup_bump_unit_z_n2778_term + {25'h0, setup_bump_unit_z_n2774_s18}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2779 = setup_bump_unit_z_n2778[23:0]; // s24f0
    wire setup_bump_unit_z_n2780 = setup_bump_unit_z_n2779[23]; // u1f0
    wire setup_bump_unit_z_n2781 = setup_bump_unit_z_n2780 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2782 = setup_bump_unit_z_n2779; // u24f0
    wire [24:0] setup_bump_unit_z_n2783 = {setup_bump_unit_z_n2782, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2784 = setup_bump_unit_z_n2783; // s25f0
    wire [25:0] setup_bump_unit_z_n2785_term = {3'h0, setup_bump_unit_x_n2216_s18} ^ {26{setup_bump_unit_z_n2781}};
    wire signed [25:0] setup_bump_unit_z_n2785 = {setup_bump_unit_z_n2784[24], setup_bump_unit_z_n2784} + setup_bump_unit_z_n2785_term + {25'h0, setup_bump_unit_z_n2781}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2786 = setup_bump_unit_z_n2785[23:0]; // s24f0
    wire setup_bump_unit_z_n2787 = setup_bump_unit_z_n2786[23]; // u1f0
    wire setup_bump_unit_z_n2788 = setup_bump_unit_z_n2787 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2789 = setup_bump_unit_z_n2786; // u24f0
    wire [24:0] setup_bump_unit_z_n2790 = {setup_bump_unit_z_n2789, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2791 = setup_bump_unit_z_n2790; // s25f0
    wire [15:0] setup_bump_unit_z_n2821 = {setup_bump_unit_z_n2820_s18, setup_bump_unit_z_n2781}; // u16f0
    wire [16:0] setup_bump_unit_z_n2822 = {setup_bump_unit_z_n2821, setup_bump_unit_z_n2788}; // u17f0

    reg [22:0] setup_light_unit_x_n344_s19; // u23f0
    reg setup_light_unit_x_n443_s19; // u1f0
    reg signed [24:0] setup_light_unit_x_n446_s19; // s25f0
    reg [6:0] setup_light_unit_x_n537_s19; // u7f0
    reg setup_light_unit_x_n553_s19; // u1f0
    reg setup_light_unit_x_n555_s19; // u1f0
    reg setup_light_unit_x_n557_s19; // u1f0
    reg setup_light_unit_y_n658_s19; // u1f0
    reg signed [24:0] setup_light_unit_y_n661_s19; // s25f0
    reg [6:0] setup_light_unit_y_n752_s19; // u7f0
    reg setup_light_unit_y_n767_s19; // u1f0
    reg setup_light_unit_y_n769_s19; // u1f0
    reg setup_light_unit_y_n771_s19; // u1f0
    reg setup_light_unit_z_n872_s19; // u1f0
    reg signed [24:0] setup_light_unit_z_n875_s19; // s25f0
    reg [6:0] setup_light_unit_z_n966_s19; // u7f0
    reg setup_light_unit_z_n981_s19; // u1f0
    reg setup_light_unit_z_n983_s19; // u1f0
    reg setup_light_unit_z_n985_s19; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s19; // u23f0
    reg setup_half_unit_x_n1408_s19; // u1f0
    reg signed [24:0] setup_half_unit_x_n1411_s19; // s25f0
    reg [6:0] setup_half_unit_x_n1502_s19; // u7f0
    reg setup_half_unit_x_n1518_s19; // u1f0
    reg setup_half_unit_x_n1520_s19; // u1f0
    reg setup_half_unit_x_n1522_s19; // u1f0
    reg setup_half_unit_y_n1623_s19; // u1f0
    reg signed [24:0] setup_half_unit_y_n1626_s19; // s25f0
    reg [6:0] setup_half_unit_y_n1717_s19; // u7f0
    reg setup_half_unit_y_n1732_s19; // u1f0
    reg setup_half_unit_y_n1734_s19; // u1f0
    reg setup_half_unit_y_n1736_s19; // u1f0
    reg setup_half_unit_z_n1837_s19; // u1f0
    reg signed [24:0] setup_half_unit_z_n1840_s19; // s25f0
    reg [6:0] setup_half_unit_z_n1931_s19; // u7f0
    reg setup_half_unit_z_n1946_s19; // u1f0
    reg setup_half_unit_z_n1948_s19; // u1f0
    reg setup_half_unit_z_n1950_s19; // u1f0
    reg [22:0] setup_bump_unit_x_n2216_s19; // u23f0
    reg setup_bump_unit_x_n2375_s19; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2378_s19; // s25f0
    reg [16:0] setup_bump_unit_x_n2409_s19; // u17f0
    reg setup_bump_unit_x_n2415_s19; // u1f0
    reg setup_bump_unit_x_n2417_s19; // u1f0
    reg setup_bump_unit_x_n2419_s19; // u1f0
    reg setup_bump_unit_y_n2582_s19; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2585_s19; // s25f0
    reg [16:0] setup_bump_unit_y_n2616_s19; // u17f0
    reg setup_bump_unit_y_n2621_s19; // u1f0
    reg setup_bump_unit_y_n2623_s19; // u1f0
    reg setup_bump_unit_y_n2625_s19; // u1f0
    reg setup_bump_unit_z_n2788_s19; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2791_s19; // s25f0
    reg [16:0] setup_bump_unit_z_n2822_s19; // u17f0
    reg setup_bump_unit_z_n2827_s19; // u1f0
    reg setup_bump_unit_z_n2829_s19; // u1f0
    reg setup_bump_unit_z_n2831_s19; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s19 <= setup_light_unit_x_n344_s18;
            setup_light_unit_x_n443_s19 <= setup_light_unit_x_n443;
            setup_light_unit_x_n446_s19 <= setup_light_unit_x_n446;
            setup_light_unit_x_n537_s19 <= setup_light_unit_x_n537;
            setup_light_unit_x_n553_s19 <= setup_light_unit_x_n553_s18;
            setup_light_unit_x_n555_s19 <= setup_light_unit_x_n555_s18;
            setup_light_unit_x_n557_s19 <= setup_light_unit_x_n557_s18;
            setup_light_unit_y_n658_s19 <= setup_light_unit_y_n658;
            setup_light_unit_y_n661_s19 <= setup_light_unit_y_n661;
            setup_light_unit_y_n752_s19 <= setup_light_unit_y_n752;
            setup_light_unit_y_n767_s19 <= setup_light_unit_y_n767_s18;
            setup_light_unit_y_n769_s19 <= setup_light_unit_y_n769_s18;
            setup_light_unit_y_n771_s19 <= setup_light_unit_y_n771_s18;
            setup_light_unit_z_n872_s19 <= setup_light_unit_z_n872;
            setup_light_unit_z_n875_s19 <= setup_light_unit_z_n875;
            setup_light_unit_z_n966_s19 <= setup_light_unit_z_n966;
            setup_light_unit_z_n981_s19 <= setup_light_unit_z_n981_s18;
            setup_light_unit_z_n983_s19 <= setup_light_unit_z_n983_s18;
            setup_light_unit_z_n985_s19 <= setup_light_unit_z_n985_s18;
            setup_half_unit_x_n1311_s19 <= setup_half_unit_x_n1311_s18;
            setup_half_unit_x_n1408_s19 <= setup_half_unit_x_n1408;
            setup_half_unit_x_n1411_s19 <= setup_half_unit_x_n1411;
            setup_half_unit_x_n1502_s19 <= setup_half_unit_x_n1502;
            setup_half_unit_x_n1518_s19 <= setup_half_unit_x_n1518_s18;
            setup_half_unit_x_n1520_s19 <= setup_half_unit_x_n1520_s18;
            setup_half_unit_x_n1522_s19 <= setup_half_unit_x_n1522_s18;
            setup_half_unit_y_n1623_s19 <= setup_half_unit_y_n1623;
            setup_half_unit_y_n1626_s19 <= setup_half_unit_y_n1626;
            setup_half_unit_y_n1717_s19 <= setup_half_unit_y_n1717;
            setup_half_unit_y_n1732_s19 <= setup_half_unit_y_n1732_s18;
            setup_half_unit_y_n1734_s19 <= setup_half_unit_y_n1734_s18;
            setup_half_unit_y_n1736_s19 <= setup_half_unit_y_n1736_s18;
            setup_half_unit_z_n1837_s19 <= setup_half_unit_z_n1837;
            setup_half_unit_z_n1840_s19 <= setup_half_unit_z_n1840;
            setup_half_unit_z_n1931_s19 <= setup_half_unit_z_n1931;
            setup_half_unit_z_n1946_s19 <= setup_half_unit_z_n1946_s18;
            setup_half_unit_z_n1948_s19 <= setup_half_unit_z_n1948_s18;
            setup_half_unit_z_n1950_s19 <= setup_half_unit_z_n1950_s18;
            setup_bump_unit_x_n2216_s19 <= setup_bump_unit_x_n2216_s18;
            setup_bump_unit_x_n2375_s19 <= setup_bump_unit_x_n2375;
            setup_bump_unit_x_n2378_s19 <= setup_bump_unit_x_n2378;
            setup_bump_unit_x_n2409_s19 <= setup_bump_unit_x_n2409;
            setup_bump_unit_x_n2415_s19 <= setup_bump_unit_x_n2415_s18;
            setup_bump_unit_x_n2417_s19 <= setup_bump_unit_x_n2417_s18;
            setup_bump_unit_x_n2419_s19 <= setup_bump_unit_x_n2419_s18;
            setup_bump_unit_y_n2582_s19 <= setup_bump_unit_y_n2582;
            setup_bump_unit_y_n2585_s19 <= setup_bump_unit_y_n2585;
            setup_bump_unit_y_n2616_s19 <= setup_bump_unit_y_n2616;
            setup_bump_unit_y_n2621_s19 <= setup_bump_unit_y_n2621_s18;
            setup_bump_unit_y_n2623_s19 <= setup_bump_unit_y_n2623_s18;
            setup_bump_unit_y_n2625_s19 <= setup_bump_unit_y_n2625_s18;
            setup_bump_unit_z_n2788_s19 <= setup_bump_unit_z_n2788;
            setup_bump_unit_z_n2791_s19 <= setup_bump_unit_z_n2791;
            setup_bump_unit_z_n2822_s19 <= setup_bump_unit_z_n2822;
            setup_bump_unit_z_n2827_s19 <= setup_bump_unit_z_n2827_s18;
            setup_bump_unit_z_n2829_s19 <= setup_bump_unit_z_n2829_s18;
            setup_bump_unit_z_n2831_s19 <= setup_bump_unit_z_n2831_s18;
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n447_term = {3'h0, setup_light_unit_x_n344_s19} ^ {26{setup_light_unit_x_n443_s19}};
    wire signed [25:0] setup_light_unit_x_n447 = {setup_light_unit_x_n446_s19[24], setup_light_unit_x_n446_s19} + setup_light_unit_x_n447_term + {25'h0, setup_light_unit_x_n443_s19}; // s26f0
    wire signed [23:0] setup_light_unit_x_n448 = setup_light_unit_x_n447[23:0]; // s24f0
    wire setup_light_unit_x_n449 = setup_light_unit_x_n448[23]; // u1f0
    wire setup_light_unit_x_n450 = setup_light_unit_x_n449 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n451 = setup_light_unit_x_n448; // u24f0
    wire [24:0] setup_light_unit_x_n452 = {setup_light_unit_x_n451, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n453 = setup_light_unit_x_n452; // s25f0
    wire [25:0] setup_light_unit_x_n454_term = {3'h0, setup_light_unit_x_n344_s19} ^ {26{setup_light_unit_x_n450}};
    wire signed [25:0] setup_light_unit_x_n454 = {setup_light_unit_x_n453[24], setup_light_unit_x_n453} + setup_light_unit_x_n454_term + {25'h0, setup_light_unit_x_n450}; // s26f0
    wire signed [23:0] setup_light_unit_x_n455 = setup_light_unit_x_n454[23:0]; // s24f0
    wire setup_light_unit_x_n456 = setup_light_unit_x_n455[23]; // u1f0
    wire setup_light_unit_x_n457 = setup_light_unit_x_n456 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n458 = setup_light_unit_x_n455; // u24f0
    wire [24:0] setup_light_unit_x_n459 = {setup_light_unit_x_n458, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n460 = setup_light_unit_x_n459; // s25f0
    wire [7:0] setup_light_unit_x_n538 = {setup_light_unit_x_n537_s19, setup_light_unit_x_n450}; // u8f0
    wire [8:0] setup_light_unit_x_n539 = {setup_light_unit_x_n538, setup_light_unit_x_n457}; // u9f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n662_term = {3'h0, setup_light_unit_x_n344_s19} ^ {26{setup_light_unit_y_n658_s19}};
    wire signed [25:0] setup_light_unit_y_n662 = {setup_light_unit_y_n661_s19[24], setup_light_unit_y_n661_s19} + setup_light_unit_y_n662_term + {25'h0, setup_light_unit_y_n658_s19}; // s26f0
    wire signed [23:0] setup_light_unit_y_n663 = setup_light_unit_y_n662[23:0]; // s24f0
    wire setup_light_unit_y_n664 = setup_light_unit_y_n663[23]; // u1f0
    wire setup_light_unit_y_n665 = setup_light_unit_y_n664 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n666 = setup_light_unit_y_n663; // u24f0
    wire [24:0] setup_light_unit_y_n667 = {setup_light_unit_y_n666, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n668 = setup_light_unit_y_n667; // s25f0
    wire [25:0] setup_light_unit_y_n669_term = {3'h0, setup_light_unit_x_n344_s19} ^ {26{setup_light_unit_y_n665}};
    wire signed [25:0] setup_light_unit_y_n669 = {setup_light_unit_y_n668[24], setup_light_unit_y_n668} + setup_light_unit_y_n669_term + {25'h0, setup_light_unit_y_n665}; // s26f0
    wire signed [23:0] setup_light_unit_y_n670 = setup_light_unit_y_n669[23:0]; // s24f0
    wire setup_light_unit_y_n671 = setup_light_unit_y_n670[23]; // u1f0
    wire setup_light_unit_y_n672 = setup_light_unit_y_n671 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n673 = setup_light_unit_y_n670; // u24f0
    wire [24:0] setup_light_unit_y_n674 = {setup_light_unit_y_n673, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n675 = setup_light_unit_y_n674; // s25f0
    wire [7:0] setup_light_unit_y_n753 = {setup_light_unit_y_n752_s19, setup_light_unit_y_n665}; // u8f0
    wire [8:0] setup_light_unit_y_n754 = {setup_light_unit_y_n753, setup_light_unit_y_n672}; // u9f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n876_term = {3'h0, setup_light_unit_x_n344_s19} ^ {26{setup_light_unit_z_n872_s19}};
    wire signed [25:0] setup_light_unit_z_n876 = {setup_light_unit_z_n875_s19[24], setup_light_unit_z_n875_s19} + setup_light_unit_z_n876_term + {25'h0, setup_light_unit_z_n872_s19}; // s26f0
    wire signed [23:0] setup_light_unit_z_n877 = setup_light_unit_z_n876[23:0]; // s24f0
    wire setup_light_unit_z_n878 = setup_light_unit_z_n877[23]; // u1f0
    wire setup_light_unit_z_n879 = setup_light_unit_z_n878 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n880 = setup_light_unit_z_n877; // u24f0
    wire [24:0] setup_light_unit_z_n881 = {setup_light_unit_z_n880, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n882 = setup_light_unit_z_n881; // s25f0
    wire [25:0] setup_light_unit_z_n883_term = {3'h0, setup_light_unit_x_n344_s19} ^ {26{setup_light_unit_z_n879}};
    wire signed [25:0] setup_light_unit_z_n883 = {setup_light_unit_z_n882[24], setup_light_unit_z_n882} + setup_light_unit_z_n883_term + {25'h0, setup_light_unit_z_n879}; // s26f0
    wire signed [23:0] setup_light_unit_z_n884 = setup_light_unit_z_n883[23:0]; // s24f0
    wire setup_light_unit_z_n885 = setup_light_unit_z_n884[23]; // u1f0
    wire setup_light_unit_z_n886 = setup_light_unit_z_n885 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n887 = setup_light_unit_z_n884; // u24f0
    wire [24:0] setup_light_unit_z_n888 = {setup_light_unit_z_n887, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n889 = setup_light_unit_z_n888; // s25f0
    wire [7:0] setup_light_unit_z_n967 = {setup_light_unit_z_n966_s19, setup_light_unit_z_n879}; // u8f0
    wire [8:0] setup_light_unit_z_n968 = {setup_light_unit_z_n967, setup_light_unit_z_n886}; // u9f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1412_term = {3'h0, setup_half_unit_x_n1311_s19} ^ {26{setup_half_unit_x_n1408_s19}};
    wire signed [25:0] setup_half_unit_x_n1412 = {setup_half_unit_x_n1411_s19[24], setup_half_unit_x_n1411_s19} + setup_half_unit_x_n1412_term + {25'h0, setup_half_unit_x_n1408_s19}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1413 = setup_half_unit_x_n1412[23:0]; // s24f0
    wire setup_half_unit_x_n1414 = setup_half_unit_x_n1413[23]; // u1f0
    wire setup_half_unit_x_n1415 = setup_half_unit_x_n1414 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1416 = setup_half_unit_x_n1413; // u24f0
    wire [24:0] setup_half_unit_x_n1417 = {setup_half_unit_x_n1416, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1418 = setup_half_unit_x_n1417; // s25f0
    wire [25:0] setup_half_unit_x_n1419_term = {3'h0, setup_half_unit_x_n1311_s19} ^ {26{setup_half_unit_x_n1415}};
    wire signed [25:0] setup_half_unit_x_n1419 = {setup_half_unit_x_n1418[24], setup_half_unit_x_n1418} + setup_half_unit_x_n1419_term + {25'h0, setup_half_unit_x_n1415}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1420 = setup_half_unit_x_n1419[23:0]; // s24f0
    wire setup_half_unit_x_n1421 = setup_half_unit_x_n1420[23]; // u1f0
    wire setup_half_unit_x_n1422 = setup_half_unit_x_n1421 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1423 = setup_half_unit_x_n1420; // u24f0
    wire [24:0] setup_half_unit_x_n1424 = {setup_half_unit_x_n1423, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1425 = setup_half_unit_x_n1424; // s25f0
    wire [7:0] setup_half_unit_x_n1503 = {setup_half_unit_x_n1502_s19, setup_half_unit_x_n1415}; // u8f0
    wire [8:0] setup_half_unit_x_n1504 = {setup_half_unit_x_n1503, setup_half_unit_x_n1422}; // u9f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1627_term = {3'h0, setup_half_unit_x_n1311_s19} ^ {26{setup_half_unit_y_n1623_s19}};
    wire signed [25:0] setup_half_unit_y_n1627 = {setup_half_unit_y_n1626_s19[24], setup_half_unit_y_n1626_s19} + setup_half_unit_y_n1627_term + {25'h0, setup_half_unit_y_n1623_s19}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1628 = setup_half_unit_y_n1627[23:0]; // s24f0
    wire setup_half_unit_y_n1629 = setup_half_unit_y_n1628[23]; // u1f0
    wire setup_half_unit_y_n1630 = setup_half_unit_y_n1629 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1631 = setup_half_unit_y_n1628; // u24f0
    wire [24:0] setup_half_unit_y_n1632 = {setup_half_unit_y_n1631, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1633 = setup_half_unit_y_n1632; // s25f0
    wire [25:0] setup_half_unit_y_n1634_term = {3'h0, setup_half_unit_x_n1311_s19} ^ {26{setup_half_unit_y_n1630}};
    wire signed [25:0] setup_half_unit_y_n1634 = {setup_half_unit_y_n1633[24], setup_half_unit_y_n1633} + setup_half_unit_y_n1634_term + {25'h0, setup_half_unit_y_n1630}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1635 = setup_half_unit_y_n1634[23:0]; // s24f0
    wire setup_half_unit_y_n1636 = setup_half_unit_y_n1635[23]; // u1f0
    wire setup_half_unit_y_n1637 = setup_half_unit_y_n1636 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1638 = setup_half_unit_y_n1635; // u24f0
    wire [24:0] setup_half_unit_y_n1639 = {setup_half_unit_y_n1638, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1640 = setup_half_unit_y_n1639; // s25f0
    wire [7:0] setup_half_unit_y_n1718 = {setup_half_unit_y_n1717_s19, setup_half_unit_y_n1630}; // u8f0
    wire [8:0] setup_half_unit_y_n1719 = {setup_half_unit_y_n1718, setup_half_unit_y_n1637}; // u9f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1841_term = {3'h0, setup_half_unit_x_n1311_s19} ^ {26{setup_half_unit_z_n1837_s19}};
    wire signed [25:0] setup_half_unit_z_n1841 = {setup_half_unit_z_n1840_s19[24], setup_half_unit_z_n1840_s19} + setup_half_unit_z_n1841_term + {25'h0, setup_half_unit_z_n1837_s19}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1842 = setup_half_unit_z_n1841[23:0]; // s24f0
    wire setup_half_unit_z_n1843 = setup_half_unit_z_n1842[23]; // u1f0
    wire setup_half_unit_z_n1844 = setup_half_unit_z_n1843 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1845 = setup_half_unit_z_n1842; // u24f0
    wire [24:0] setup_half_unit_z_n1846 = {setup_half_unit_z_n1845, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1847 = setup_half_unit_z_n1846; // s25f0
    wire [25:0] setup_half_unit_z_n1848_term = {3'h0, setup_half_unit_x_n1311_s19} ^ {26{setup_half_unit_z_n1844}};
    wire signed [25:0] setup_half_unit_z_n1848 = {setup_half_unit_z_n1847[24], setup_half_unit_z_n1847} + setup_half_unit_z_n1848_term + {25'h0, setup_half_unit_z_n1844}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1849 = setup_half_unit_z_n1848[23:0]; // s24f0
    wire setup_half_unit_z_n1850 = setup_half_unit_z_n1849[23]; // u1f0
    wire setup_half_unit_z_n1851 = setup_half_unit_z_n1850 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1852 = setup_half_unit_z_n1849; // u24f0
    wire [24:0] setup_half_unit_z_n1853 = {setup_half_unit_z_n1852, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1854 = setup_half_unit_z_n1853; // s25f0
    wire [7:0] setup_half_unit_z_n1932 = {setup_half_unit_z_n1931_s19, setup_half_unit_z_n1844}; // u8f0
    wire [8:0] setup_half_unit_z_n1933 = {setup_half_unit_z_n1932, setup_half_unit_z_n1851}; // u9f0
    // setup.bump.unit_x
    wire [25:0] setup_bump_unit_x_n2379_term = {3'h0, setup_bump_unit_x_n2216_s19} ^ {26{setup_bump_unit_x_n2375_s19}};
    wire signed [25:0] setup_bump_unit_x_n2379 = {setup_bump_unit_x_n2378_s19[24], setup_bump_unit_x_n2378_s19} + setup_bump_unit_x_n2379_term + {25'h0, setup_bump_unit_x_n2375_s19}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2380 = setup_bump_unit_x_n2379[23:0]; // s24f0
    wire setup_bump_unit_x_n2381 = setup_bump_unit_x_n2380[23]; // u1f0
    wire setup_bump_unit_x_n2382 = setup_bump_unit_x_n2381 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_x_n2383 = setup_bump_unit_x_n2380; // u24f0
    wire [24:0] setup_bump_unit_x_n2384 = {setup_bump_unit_x_n2383, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_x_n2385 = setup_bump_unit_x_n2384; // s25f0
    wire [25:0] setup_bump_unit_x_n2386_term = {3'h0, setup_bump_unit_x_n2216_s19} ^ {26{setup_bump_unit_x_n2382}};
    wire signed [25:0] setup_bump_unit_x_n2386 = {setup_bump_unit_x_n2385[24], setup_bump_unit_x_n2385} + setup_bump_unit_x_n2386_term + {25'h0, setup_bump_unit_x_n2382}; // s26f0
    wire signed [23:0] setup_bump_unit_x_n2387 = setup_bump_unit_x_n2386[23:0]; // s24f0
    wire setup_bump_unit_x_n2388 = setup_bump_unit_x_n2387[23]; // u1f0
    wire setup_bump_unit_x_n2389 = setup_bump_unit_x_n2388 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_bump_unit_x_n2390 = {setup_bump_unit_x_n2387[23], setup_bump_unit_x_n2387} + {2'h0, setup_bump_unit_x_n2216_s19}; // s25f0
    wire [17:0] setup_bump_unit_x_n2410 = {setup_bump_unit_x_n2409_s19, setup_bump_unit_x_n2382}; // u18f0
    wire [18:0] setup_bump_unit_x_n2411 = {setup_bump_unit_x_n2410, setup_bump_unit_x_n2389}; // u19f0
    // setup.bump.unit_y
    wire [25:0] setup_bump_unit_y_n2586_term = {3'h0, setup_bump_unit_x_n2216_s19} ^ {26{setup_bump_unit_y_n2582_s19}};
    wire signed [25:0] setup_bump_unit_y_n2586 = {setup_bump_unit_y_n2585_s19[24], setup_bump_unit_y_n2585_s19} + setup_bump_unit_y_n2586_term + {25'h0, setup_bump_unit_y_n2582_s19}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2587 = setup_bump_unit_y_n2586[23:0]; // s24f0
    wire setup_bump_unit_y_n2588 = setup_bump_unit_y_n2587[23]; // u1f0
    wire setup_bump_unit_y_n2589 = setup_bump_unit_y_n2588 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_y_n2590 = setup_bump_unit_y_n2587; // u24f0
    wire [24:0] setup_bump_unit_y_n2591 = {setup_bump_unit_y_n2590, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_y_n2592 = setup_bump_unit_y_n2591; // s25f0
    wire [25:0] setup_bump_unit_y_n2593_term = {3'h0, setup_bump_unit_x_n2216_s19} ^ {26{setup_bump_unit_y_n2589}};
    wire signed [25:0] setup_bump_unit_y_n2593 = {setup_bump_unit_y_n2592[24], setup_bump_unit_y_n2592} + setup_bump_unit_y_n2593_term + {25'h0, setup_bump_unit_y_n2589}; // s26f0
    wire signed [23:0] setup_bump_unit_y_n2594 = setup_bump_unit_y_n2593[23:0]; // s24f0
    wire setup_bump_unit_y_n2595 = setup_bump_unit_y_n2594[23]; // u1f0
    wire setup_bump_unit_y_n2596 = setup_bump_unit_y_n2595 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_bump_unit_y_n2597 = {setup_bump_unit_y_n2594[23], setup_bump_unit_y_n2594} + {2'h0, setup_bump_unit_x_n2216_s19}; // s25f0
    wire [17:0] setup_bump_unit_y_n2617 = {setup_bump_unit_y_n2616_s19, setup_bump_unit_y_n2589}; // u18f0
    wire [18:0] setup_bump_unit_y_n2618 = {setup_bump_unit_y_n2617, setup_bump_unit_y_n2596}; // u19f0
    // setup.bump.unit_z
    wire [25:0] setup_bump_unit_z_n2792_term = {3'h0, setup_bump_unit_x_n2216_s19} ^ {26{setup_bump_unit_z_n2788_s19}};
    wire signed [25:0] setup_bump_unit_z_n2792 = {setup_bump_unit_z_n2791_s19[24], setup_bump_unit_z_n2791_s19} + setup_bump_unit_z_n2792_term + {25'h0, setup_bump_unit_z_n2788_s19}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2793 = setup_bump_unit_z_n2792[23:0]; // s24f0
    wire setup_bump_unit_z_n2794 = setup_bump_unit_z_n2793[23]; // u1f0
    wire setup_bump_unit_z_n2795 = setup_bump_unit_z_n2794 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_bump_unit_z_n2796 = setup_bump_unit_z_n2793; // u24f0
    wire [24:0] setup_bump_unit_z_n2797 = {setup_bump_unit_z_n2796, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_bump_unit_z_n2798 = setup_bump_unit_z_n2797; // s25f0
    wire [25:0] setup_bump_unit_z_n2799_term = {3'h0, setup_bump_unit_x_n2216_s19} ^ {26{setup_bump_unit_z_n2795}};
    wire signed [25:0] setup_bump_unit_z_n2799 = {setup_bump_unit_z_n2798[24], setup_bump_unit_z_n2798} + setup_bump_unit_z_n2799_term + {25'h0, setup_bump_unit_z_n2795}; // s26f0
    wire signed [23:0] setup_bump_unit_z_n2800 = setup_bump_unit_z_n2799[23:0]; // s24f0
    wire setup_bump_unit_z_n2801 = setup_bump_unit_z_n2800[23]; // u1f0
    wire setup_bump_unit_z_n2802 = setup_bump_unit_z_n2801 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_bump_unit_z_n2803 = {setup_bump_unit_z_n2800[23], setup_bump_unit_z_n2800} + {2'h0, setup_bump_unit_x_n2216_s19}; // s25f0
    wire [17:0] setup_bump_unit_z_n2823 = {setup_bump_unit_z_n2822_s19, setup_bump_unit_z_n2795}; // u18f0
    wire [18:0] setup_bump_unit_z_n2824 = {setup_bump_unit_z_n2823, setup_bump_unit_z_n2802}; // u19f0

    reg [22:0] setup_light_unit_x_n344_s20; // u23f0
    reg setup_light_unit_x_n457_s20; // u1f0
    reg signed [24:0] setup_light_unit_x_n460_s20; // s25f0
    reg [8:0] setup_light_unit_x_n539_s20; // u9f0
    reg setup_light_unit_x_n553_s20; // u1f0
    reg setup_light_unit_x_n555_s20; // u1f0
    reg setup_light_unit_x_n557_s20; // u1f0
    reg setup_light_unit_y_n672_s20; // u1f0
    reg signed [24:0] setup_light_unit_y_n675_s20; // s25f0
    reg [8:0] setup_light_unit_y_n754_s20; // u9f0
    reg setup_light_unit_y_n767_s20; // u1f0
    reg setup_light_unit_y_n769_s20; // u1f0
    reg setup_light_unit_y_n771_s20; // u1f0
    reg setup_light_unit_z_n886_s20; // u1f0
    reg signed [24:0] setup_light_unit_z_n889_s20; // s25f0
    reg [8:0] setup_light_unit_z_n968_s20; // u9f0
    reg setup_light_unit_z_n981_s20; // u1f0
    reg setup_light_unit_z_n983_s20; // u1f0
    reg setup_light_unit_z_n985_s20; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s20; // u23f0
    reg setup_half_unit_x_n1422_s20; // u1f0
    reg signed [24:0] setup_half_unit_x_n1425_s20; // s25f0
    reg [8:0] setup_half_unit_x_n1504_s20; // u9f0
    reg setup_half_unit_x_n1518_s20; // u1f0
    reg setup_half_unit_x_n1520_s20; // u1f0
    reg setup_half_unit_x_n1522_s20; // u1f0
    reg setup_half_unit_y_n1637_s20; // u1f0
    reg signed [24:0] setup_half_unit_y_n1640_s20; // s25f0
    reg [8:0] setup_half_unit_y_n1719_s20; // u9f0
    reg setup_half_unit_y_n1732_s20; // u1f0
    reg setup_half_unit_y_n1734_s20; // u1f0
    reg setup_half_unit_y_n1736_s20; // u1f0
    reg setup_half_unit_z_n1851_s20; // u1f0
    reg signed [24:0] setup_half_unit_z_n1854_s20; // s25f0
    reg [8:0] setup_half_unit_z_n1933_s20; // u9f0
    reg setup_half_unit_z_n1946_s20; // u1f0
    reg setup_half_unit_z_n1948_s20; // u1f0
    reg setup_half_unit_z_n1950_s20; // u1f0
    reg signed [23:0] setup_bump_unit_x_n2387_s20; // s24f0
    reg setup_bump_unit_x_n2388_s20; // u1f0
    reg signed [24:0] setup_bump_unit_x_n2390_s20; // s25f0
    reg [18:0] setup_bump_unit_x_n2411_s20; // u19f0
    reg setup_bump_unit_x_n2415_s20; // u1f0
    reg setup_bump_unit_x_n2417_s20; // u1f0
    reg setup_bump_unit_x_n2419_s20; // u1f0
    reg signed [23:0] setup_bump_unit_y_n2594_s20; // s24f0
    reg setup_bump_unit_y_n2595_s20; // u1f0
    reg signed [24:0] setup_bump_unit_y_n2597_s20; // s25f0
    reg [18:0] setup_bump_unit_y_n2618_s20; // u19f0
    reg setup_bump_unit_y_n2621_s20; // u1f0
    reg setup_bump_unit_y_n2623_s20; // u1f0
    reg setup_bump_unit_y_n2625_s20; // u1f0
    reg signed [23:0] setup_bump_unit_z_n2800_s20; // s24f0
    reg setup_bump_unit_z_n2801_s20; // u1f0
    reg signed [24:0] setup_bump_unit_z_n2803_s20; // s25f0
    reg [18:0] setup_bump_unit_z_n2824_s20; // u19f0
    reg setup_bump_unit_z_n2827_s20; // u1f0
    reg setup_bump_unit_z_n2829_s20; // u1f0
    reg setup_bump_unit_z_n2831_s20; // u1f0
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s20 <= setup_light_unit_x_n344_s19;
            setup_light_unit_x_n457_s20 <= setup_light_unit_x_n457;
            setup_light_unit_x_n460_s20 <= setup_light_unit_x_n460;
            setup_light_unit_x_n539_s20 <= setup_light_unit_x_n539;
            setup_light_unit_x_n553_s20 <= setup_light_unit_x_n553_s19;
            setup_light_unit_x_n555_s20 <= setup_light_unit_x_n555_s19;
            setup_light_unit_x_n557_s20 <= setup_light_unit_x_n557_s19;
            setup_light_unit_y_n672_s20 <= setup_light_unit_y_n672;
            setup_light_unit_y_n675_s20 <= setup_light_unit_y_n675;
            setup_light_unit_y_n754_s20 <= setup_light_unit_y_n754;
            setup_light_unit_y_n767_s20 <= setup_light_unit_y_n767_s19;
            setup_light_unit_y_n769_s20 <= setup_light_unit_y_n769_s19;
            setup_light_unit_y_n771_s20 <= setup_light_unit_y_n771_s19;
            setup_light_unit_z_n886_s20 <= setup_light_unit_z_n886;
            setup_light_unit_z_n889_s20 <= setup_light_unit_z_n889;
            setup_light_unit_z_n968_s20 <= setup_light_unit_z_n968;
            setup_light_unit_z_n981_s20 <= setup_light_unit_z_n981_s19;
            setup_light_unit_z_n983_s20 <= setup_light_unit_z_n983_s19;
            setup_light_unit_z_n985_s20 <= setup_light_unit_z_n985_s19;
            setup_half_unit_x_n1311_s20 <= setup_half_unit_x_n1311_s19;
            setup_half_unit_x_n1422_s20 <= setup_half_unit_x_n1422;
            setup_half_unit_x_n1425_s20 <= setup_half_unit_x_n1425;
            setup_half_unit_x_n1504_s20 <= setup_half_unit_x_n1504;
            setup_half_unit_x_n1518_s20 <= setup_half_unit_x_n1518_s19;
            setup_half_unit_x_n1520_s20 <= setup_half_unit_x_n1520_s19;
            setup_half_unit_x_n1522_s20 <= setup_half_unit_x_n1522_s19;
            setup_half_unit_y_n1637_s20 <= setup_half_unit_y_n1637;
            setup_half_unit_y_n1640_s20 <= setup_half_unit_y_n1640;
            setup_half_unit_y_n1719_s20 <= setup_half_unit_y_n1719;
            setup_half_unit_y_n1732_s20 <= setup_half_unit_y_n1732_s19;
            setup_half_unit_y_n1734_s20 <= setup_half_unit_y_n1734_s19;
            setup_half_unit_y_n1736_s20 <= setup_half_unit_y_n1736_s19;
            setup_half_unit_z_n1851_s20 <= setup_half_unit_z_n1851;
            setup_half_unit_z_n1854_s20 <= setup_half_unit_z_n1854;
            setup_half_unit_z_n1933_s20 <= setup_half_unit_z_n1933;
            setup_half_unit_z_n1946_s20 <= setup_half_unit_z_n1946_s19;
            setup_half_unit_z_n1948_s20 <= setup_half_unit_z_n1948_s19;
            setup_half_unit_z_n1950_s20 <= setup_half_unit_z_n1950_s19;
            setup_bump_unit_x_n2387_s20 <= setup_bump_unit_x_n2387;
            setup_bump_unit_x_n2388_s20 <= setup_bump_unit_x_n2388;
            setup_bump_unit_x_n2390_s20 <= setup_bump_unit_x_n2390;
            setup_bump_unit_x_n2411_s20 <= setup_bump_unit_x_n2411;
            setup_bump_unit_x_n2415_s20 <= setup_bump_unit_x_n2415_s19;
            setup_bump_unit_x_n2417_s20 <= setup_bump_unit_x_n2417_s19;
            setup_bump_unit_x_n2419_s20 <= setup_bump_unit_x_n2419_s19;
            setup_bump_unit_y_n2594_s20 <= setup_bump_unit_y_n2594;
            setup_bump_unit_y_n2595_s20 <= setup_bump_unit_y_n2595;
            setup_bump_unit_y_n2597_s20 <= setup_bump_unit_y_n2597;
            setup_bump_unit_y_n2618_s20 <= setup_bump_unit_y_n2618;
            setup_bump_unit_y_n2621_s20 <= setup_bump_unit_y_n2621_s19;
            setup_bump_unit_y_n2623_s20 <= setup_bump_unit_y_n2623_s19;
            setup_bump_unit_y_n2625_s20 <= setup_bump_unit_y_n2625_s19;
            setup_bump_unit_z_n2800_s20 <= setup_bump_unit_z_n2800;
            setup_bump_unit_z_n2801_s20 <= setup_bump_unit_z_n2801;
            setup_bump_unit_z_n2803_s20 <= setup_bump_unit_z_n2803;
            setup_bump_unit_z_n2824_s20 <= setup_bump_unit_z_n2824;
            setup_bump_unit_z_n2827_s20 <= setup_bump_unit_z_n2827_s19;
            setup_bump_unit_z_n2829_s20 <= setup_bump_unit_z_n2829_s19;
            setup_bump_unit_z_n2831_s20 <= setup_bump_unit_z_n2831_s19;
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n461_term = {3'h0, setup_light_unit_x_n344_s20} ^ {26{setup_light_unit_x_n457_s20}};
    wire signed [25:0] setup_light_unit_x_n461 = {setup_light_unit_x_n460_s20[24], setup_light_unit_x_n460_s20} + setup_light_unit_x_n461_term + {25'h0, setup_light_unit_x_n457_s20}; // s26f0
    wire signed [23:0] setup_light_unit_x_n462 = setup_light_unit_x_n461[23:0]; // s24f0
    wire setup_light_unit_x_n463 = setup_light_unit_x_n462[23]; // u1f0
    wire setup_light_unit_x_n464 = setup_light_unit_x_n463 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n465 = setup_light_unit_x_n462; // u24f0
    wire [24:0] setup_light_unit_x_n466 = {setup_light_unit_x_n465, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n467 = setup_light_unit_x_n466; // s25f0
    wire [25:0] setup_light_unit_x_n468_term = {3'h0, setup_light_unit_x_n344_s20} ^ {26{setup_light_unit_x_n464}};
    wire signed [25:0] setup_light_unit_x_n468 = {setup_light_unit_x_n467[24], setup_light_unit_x_n467} + setup_light_unit_x_n468_term + {25'h0, setup_light_unit_x_n464}; // s26f0
    wire signed [23:0] setup_light_unit_x_n469 = setup_light_unit_x_n468[23:0]; // s24f0
    wire setup_light_unit_x_n470 = setup_light_unit_x_n469[23]; // u1f0
    wire setup_light_unit_x_n471 = setup_light_unit_x_n470 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n472 = setup_light_unit_x_n469; // u24f0
    wire [24:0] setup_light_unit_x_n473 = {setup_light_unit_x_n472, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n474 = setup_light_unit_x_n473; // s25f0
    wire [9:0] setup_light_unit_x_n540 = {setup_light_unit_x_n539_s20, setup_light_unit_x_n464}; // u10f0
    wire [10:0] setup_light_unit_x_n541 = {setup_light_unit_x_n540, setup_light_unit_x_n471}; // u11f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n676_term = {3'h0, setup_light_unit_x_n344_s20} ^ {26{setup_light_unit_y_n672_s20}};
    wire signed [25:0] setup_light_unit_y_n676 = {setup_light_unit_y_n675_s20[24], setup_light_unit_y_n675_s20} + setup_light_unit_y_n676_term + {25'h0, setup_light_unit_y_n672_s20}; // s26f0
    wire signed [23:0] setup_light_unit_y_n677 = setup_light_unit_y_n676[23:0]; // s24f0
    wire setup_light_unit_y_n678 = setup_light_unit_y_n677[23]; // u1f0
    wire setup_light_unit_y_n679 = setup_light_unit_y_n678 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n680 = setup_light_unit_y_n677; // u24f0
    wire [24:0] setup_light_unit_y_n681 = {setup_light_unit_y_n680, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n682 = setup_light_unit_y_n681; // s25f0
    wire [25:0] setup_light_unit_y_n683_term = {3'h0, setup_light_unit_x_n344_s20} ^ {26{setup_light_unit_y_n679}};
    wire signed [25:0] setup_light_unit_y_n683 = {setup_light_unit_y_n682[24], setup_light_unit_y_n682} + setup_light_unit_y_n683_term + {25'h0, setup_light_unit_y_n679}; // s26f0
    wire signed [23:0] setup_light_unit_y_n684 = setup_light_unit_y_n683[23:0]; // s24f0
    wire setup_light_unit_y_n685 = setup_light_unit_y_n684[23]; // u1f0
    wire setup_light_unit_y_n686 = setup_light_unit_y_n685 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n687 = setup_light_unit_y_n684; // u24f0
    wire [24:0] setup_light_unit_y_n688 = {setup_light_unit_y_n687, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n689 = setup_light_unit_y_n688; // s25f0
    wire [9:0] setup_light_unit_y_n755 = {setup_light_unit_y_n754_s20, setup_light_unit_y_n679}; // u10f0
    wire [10:0] setup_light_unit_y_n756 = {setup_light_unit_y_n755, setup_light_unit_y_n686}; // u11f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n890_term = {3'h0, setup_light_unit_x_n344_s20} ^ {26{setup_light_unit_z_n886_s20}};
    wire signed [25:0] setup_light_unit_z_n890 = {setup_light_unit_z_n889_s20[24], setup_light_unit_z_n889_s20} + setup_light_unit_z_n890_term + {25'h0, setup_light_unit_z_n886_s20}; // s26f0
    wire signed [23:0] setup_light_unit_z_n891 = setup_light_unit_z_n890[23:0]; // s24f0
    wire setup_light_unit_z_n892 = setup_light_unit_z_n891[23]; // u1f0
    wire setup_light_unit_z_n893 = setup_light_unit_z_n892 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n894 = setup_light_unit_z_n891; // u24f0
    wire [24:0] setup_light_unit_z_n895 = {setup_light_unit_z_n894, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n896 = setup_light_unit_z_n895; // s25f0
    wire [25:0] setup_light_unit_z_n897_term = {3'h0, setup_light_unit_x_n344_s20} ^ {26{setup_light_unit_z_n893}};
    wire signed [25:0] setup_light_unit_z_n897 = {setup_light_unit_z_n896[24], setup_light_unit_z_n896} + setup_light_unit_z_n897_term + {25'h0, setup_light_unit_z_n893}; // s26f0
    wire signed [23:0] setup_light_unit_z_n898 = setup_light_unit_z_n897[23:0]; // s24f0
    wire setup_light_unit_z_n899 = setup_light_unit_z_n898[23]; // u1f0
    wire setup_light_unit_z_n900 = setup_light_unit_z_n899 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n901 = setup_light_unit_z_n898; // u24f0
    wire [24:0] setup_light_unit_z_n902 = {setup_light_unit_z_n901, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n903 = setup_light_unit_z_n902; // s25f0
    wire [9:0] setup_light_unit_z_n969 = {setup_light_unit_z_n968_s20, setup_light_unit_z_n893}; // u10f0
    wire [10:0] setup_light_unit_z_n970 = {setup_light_unit_z_n969, setup_light_unit_z_n900}; // u11f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1426_term = {3'h0, setup_half_unit_x_n1311_s20} ^ {26{setup_half_unit_x_n1422_s20}};
    wire signed [25:0] setup_half_unit_x_n1426 = {setup_half_unit_x_n1425_s20[24], setup_half_unit_x_n1425_s20} + setup_half_unit_x_n1426_term + {25'h0, setup_half_unit_x_n1422_s20}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1427 = setup_half_unit_x_n1426[23:0]; // s24f0
    wire setup_half_unit_x_n1428 = setup_half_unit_x_n1427[23]; // u1f0
    wire setup_half_unit_x_n1429 = setup_half_unit_x_n1428 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1430 = setup_half_unit_x_n1427; // u24f0
    wire [24:0] setup_half_unit_x_n1431 = {setup_half_unit_x_n1430, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1432 = setup_half_unit_x_n1431; // s25f0
    wire [25:0] setup_half_unit_x_n1433_term = {3'h0, setup_half_unit_x_n1311_s20} ^ {26{setup_half_unit_x_n1429}};
    wire signed [25:0] setup_half_unit_x_n1433 = {setup_half_unit_x_n1432[24], setup_half_unit_x_n1432} + setup_half_unit_x_n1433_term + {25'h0, setup_half_unit_x_n1429}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1434 = setup_half_unit_x_n1433[23:0]; // s24f0
    wire setup_half_unit_x_n1435 = setup_half_unit_x_n1434[23]; // u1f0
    wire setup_half_unit_x_n1436 = setup_half_unit_x_n1435 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1437 = setup_half_unit_x_n1434; // u24f0
    wire [24:0] setup_half_unit_x_n1438 = {setup_half_unit_x_n1437, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1439 = setup_half_unit_x_n1438; // s25f0
    wire [9:0] setup_half_unit_x_n1505 = {setup_half_unit_x_n1504_s20, setup_half_unit_x_n1429}; // u10f0
    wire [10:0] setup_half_unit_x_n1506 = {setup_half_unit_x_n1505, setup_half_unit_x_n1436}; // u11f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1641_term = {3'h0, setup_half_unit_x_n1311_s20} ^ {26{setup_half_unit_y_n1637_s20}};
    wire signed [25:0] setup_half_unit_y_n1641 = {setup_half_unit_y_n1640_s20[24], setup_half_unit_y_n1640_s20} + setup_half_unit_y_n1641_term + {25'h0, setup_half_unit_y_n1637_s20}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1642 = setup_half_unit_y_n1641[23:0]; // s24f0
    wire setup_half_unit_y_n1643 = setup_half_unit_y_n1642[23]; // u1f0
    wire setup_half_unit_y_n1644 = setup_half_unit_y_n1643 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1645 = setup_half_unit_y_n1642; // u24f0
    wire [24:0] setup_half_unit_y_n1646 = {setup_half_unit_y_n1645, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1647 = setup_half_unit_y_n1646; // s25f0
    wire [25:0] setup_half_unit_y_n1648_term = {3'h0, setup_half_unit_x_n1311_s20} ^ {26{setup_half_unit_y_n1644}};
    wire signed [25:0] setup_half_unit_y_n1648 = {setup_half_unit_y_n1647[24], setup_half_unit_y_n1647} + setup_half_unit_y_n1648_term + {25'h0, setup_half_unit_y_n1644}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1649 = setup_half_unit_y_n1648[23:0]; // s24f0
    wire setup_half_unit_y_n1650 = setup_half_unit_y_n1649[23]; // u1f0
    wire setup_half_unit_y_n1651 = setup_half_unit_y_n1650 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1652 = setup_half_unit_y_n1649; // u24f0
    wire [24:0] setup_half_unit_y_n1653 = {setup_half_unit_y_n1652, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1654 = setup_half_unit_y_n1653; // s25f0
    wire [9:0] setup_half_unit_y_n1720 = {setup_half_unit_y_n1719_s20, setup_half_unit_y_n1644}; // u10f0
    wire [10:0] setup_half_unit_y_n1721 = {setup_half_unit_y_n1720, setup_half_unit_y_n1651}; // u11f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1855_term = {3'h0, setup_half_unit_x_n1311_s20} ^ {26{setup_half_unit_z_n1851_s20}};
    wire signed [25:0] setup_half_unit_z_n1855 = {setup_half_unit_z_n1854_s20[24], setup_half_unit_z_n1854_s20} + setup_half_unit_z_n1855_term + {25'h0, setup_half_unit_z_n1851_s20}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1856 = setup_half_unit_z_n1855[23:0]; // s24f0
    wire setup_half_unit_z_n1857 = setup_half_unit_z_n1856[23]; // u1f0
    wire setup_half_unit_z_n1858 = setup_half_unit_z_n1857 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1859 = setup_half_unit_z_n1856; // u24f0
    wire [24:0] setup_half_unit_z_n1860 = {setup_half_unit_z_n1859, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1861 = setup_half_unit_z_n1860; // s25f0
    wire [25:0] setup_half_unit_z_n1862_term = {3'h0, setup_half_unit_x_n1311_s20} ^ {26{setup_half_unit_z_n1858}};
    wire signed [25:0] setup_half_unit_z_n1862 = {setup_half_unit_z_n1861[24], setup_half_unit_z_n1861} + setup_half_unit_z_n1862_term + {25'h0, setup_half_unit_z_n1858}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1863 = setup_half_unit_z_n1862[23:0]; // s24f0
    wire setup_half_unit_z_n1864 = setup_half_unit_z_n1863[23]; // u1f0
    wire setup_half_unit_z_n1865 = setup_half_unit_z_n1864 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1866 = setup_half_unit_z_n1863; // u24f0
    wire [24:0] setup_half_unit_z_n1867 = {setup_half_unit_z_n1866, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1868 = setup_half_unit_z_n1867; // s25f0
    wire [9:0] setup_half_unit_z_n1934 = {setup_half_unit_z_n1933_s20, setup_half_unit_z_n1858}; // u10f0
    wire [10:0] setup_half_unit_z_n1935 = {setup_half_unit_z_n1934, setup_half_unit_z_n1865}; // u11f0
    // setup.bump.unit_x
    wire signed [24:0] setup_bump_unit_x_n2391 = setup_bump_unit_x_n2388_s20 ? setup_bump_unit_x_n2390_s20 : {setup_bump_unit_x_n2387_s20[23], setup_bump_unit_x_n2387_s20}; // s25f0
    wire setup_bump_unit_x_n2392 = setup_bump_unit_x_n2391 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_bump_unit_x_n2393 = setup_bump_unit_x_n2392 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_bump_unit_x_n2412 = {setup_bump_unit_x_n2411_s20, setup_bump_unit_x_n2393}; // u20f0
    wire [1:-18] setup_bump_unit_x_n2413 = setup_bump_unit_x_n2412; // u20f18
    wire [1:-18] setup_bump_unit_x_n2416 = setup_bump_unit_x_n2415_s20 ? {setup_light_unit_x_n343, 19'h0} : setup_bump_unit_x_n2413; // u20f18
    wire [1:-18] setup_bump_unit_x_n2418 = setup_bump_unit_x_n2417_s20 ? {1'b0, setup_light_length_n43, 18'h0} : setup_bump_unit_x_n2416; // u20f18
    wire signed [2:-18] setup_bump_unit_x_n2420 = -{1'b0, setup_bump_unit_x_n2418}; // s21f18
    // setup.bump.unit_y
    wire signed [24:0] setup_bump_unit_y_n2598 = setup_bump_unit_y_n2595_s20 ? setup_bump_unit_y_n2597_s20 : {setup_bump_unit_y_n2594_s20[23], setup_bump_unit_y_n2594_s20}; // s25f0
    wire setup_bump_unit_y_n2599 = setup_bump_unit_y_n2598 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_bump_unit_y_n2600 = setup_bump_unit_y_n2599 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_bump_unit_y_n2619 = {setup_bump_unit_y_n2618_s20, setup_bump_unit_y_n2600}; // u20f0
    wire [1:-18] setup_bump_unit_y_n2620 = setup_bump_unit_y_n2619; // u20f18
    wire [1:-18] setup_bump_unit_y_n2622 = setup_bump_unit_y_n2621_s20 ? {setup_light_unit_x_n343, 19'h0} : setup_bump_unit_y_n2620; // u20f18
    wire [1:-18] setup_bump_unit_y_n2624 = setup_bump_unit_y_n2623_s20 ? {1'b0, setup_light_length_n43, 18'h0} : setup_bump_unit_y_n2622; // u20f18
    wire signed [2:-18] setup_bump_unit_y_n2626 = -{1'b0, setup_bump_unit_y_n2624}; // s21f18
    // setup.bump.unit_z
    wire signed [24:0] setup_bump_unit_z_n2804 = setup_bump_unit_z_n2801_s20 ? setup_bump_unit_z_n2803_s20 : {setup_bump_unit_z_n2800_s20[23], setup_bump_unit_z_n2800_s20}; // s25f0
    wire setup_bump_unit_z_n2805 = setup_bump_unit_z_n2804 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_bump_unit_z_n2806 = setup_bump_unit_z_n2805 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_bump_unit_z_n2825 = {setup_bump_unit_z_n2824_s20, setup_bump_unit_z_n2806}; // u20f0
    wire [1:-18] setup_bump_unit_z_n2826 = setup_bump_unit_z_n2825; // u20f18
    wire [1:-18] setup_bump_unit_z_n2828 = setup_bump_unit_z_n2827_s20 ? {setup_light_unit_x_n343, 19'h0} : setup_bump_unit_z_n2826; // u20f18
    wire [1:-18] setup_bump_unit_z_n2830 = setup_bump_unit_z_n2829_s20 ? {1'b0, setup_light_length_n43, 18'h0} : setup_bump_unit_z_n2828; // u20f18
    wire signed [2:-18] setup_bump_unit_z_n2832 = -{1'b0, setup_bump_unit_z_n2830}; // s21f18

    reg [22:0] setup_light_unit_x_n344_s21; // u23f0
    reg setup_light_unit_x_n471_s21; // u1f0
    reg signed [24:0] setup_light_unit_x_n474_s21; // s25f0
    reg [10:0] setup_light_unit_x_n541_s21; // u11f0
    reg setup_light_unit_x_n553_s21; // u1f0
    reg setup_light_unit_x_n555_s21; // u1f0
    reg setup_light_unit_x_n557_s21; // u1f0
    reg setup_light_unit_y_n686_s21; // u1f0
    reg signed [24:0] setup_light_unit_y_n689_s21; // s25f0
    reg [10:0] setup_light_unit_y_n756_s21; // u11f0
    reg setup_light_unit_y_n767_s21; // u1f0
    reg setup_light_unit_y_n769_s21; // u1f0
    reg setup_light_unit_y_n771_s21; // u1f0
    reg setup_light_unit_z_n900_s21; // u1f0
    reg signed [24:0] setup_light_unit_z_n903_s21; // s25f0
    reg [10:0] setup_light_unit_z_n970_s21; // u11f0
    reg setup_light_unit_z_n981_s21; // u1f0
    reg setup_light_unit_z_n983_s21; // u1f0
    reg setup_light_unit_z_n985_s21; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s21; // u23f0
    reg setup_half_unit_x_n1436_s21; // u1f0
    reg signed [24:0] setup_half_unit_x_n1439_s21; // s25f0
    reg [10:0] setup_half_unit_x_n1506_s21; // u11f0
    reg setup_half_unit_x_n1518_s21; // u1f0
    reg setup_half_unit_x_n1520_s21; // u1f0
    reg setup_half_unit_x_n1522_s21; // u1f0
    reg setup_half_unit_y_n1651_s21; // u1f0
    reg signed [24:0] setup_half_unit_y_n1654_s21; // s25f0
    reg [10:0] setup_half_unit_y_n1721_s21; // u11f0
    reg setup_half_unit_y_n1732_s21; // u1f0
    reg setup_half_unit_y_n1734_s21; // u1f0
    reg setup_half_unit_y_n1736_s21; // u1f0
    reg setup_half_unit_z_n1865_s21; // u1f0
    reg signed [24:0] setup_half_unit_z_n1868_s21; // s25f0
    reg [10:0] setup_half_unit_z_n1935_s21; // u11f0
    reg setup_half_unit_z_n1946_s21; // u1f0
    reg setup_half_unit_z_n1948_s21; // u1f0
    reg setup_half_unit_z_n1950_s21; // u1f0
    reg [1:-18] setup_bump_unit_x_n2418_s21; // u20f18
    reg setup_bump_unit_x_n2419_s21; // u1f0
    reg signed [2:-18] setup_bump_unit_x_n2420_s21; // s21f18
    reg [1:-18] setup_bump_unit_y_n2624_s21; // u20f18
    reg setup_bump_unit_y_n2625_s21; // u1f0
    reg signed [2:-18] setup_bump_unit_y_n2626_s21; // s21f18
    reg [1:-18] setup_bump_unit_z_n2830_s21; // u20f18
    reg setup_bump_unit_z_n2831_s21; // u1f0
    reg signed [2:-18] setup_bump_unit_z_n2832_s21; // s21f18
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s21 <= setup_light_unit_x_n344_s20;
            setup_light_unit_x_n471_s21 <= setup_light_unit_x_n471;
            setup_light_unit_x_n474_s21 <= setup_light_unit_x_n474;
            setup_light_unit_x_n541_s21 <= setup_light_unit_x_n541;
            setup_light_unit_x_n553_s21 <= setup_light_unit_x_n553_s20;
            setup_light_unit_x_n555_s21 <= setup_light_unit_x_n555_s20;
            setup_light_unit_x_n557_s21 <= setup_light_unit_x_n557_s20;
            setup_light_unit_y_n686_s21 <= setup_light_unit_y_n686;
            setup_light_unit_y_n689_s21 <= setup_light_unit_y_n689;
            setup_light_unit_y_n756_s21 <= setup_light_unit_y_n756;
            setup_light_unit_y_n767_s21 <= setup_light_unit_y_n767_s20;
            setup_light_unit_y_n769_s21 <= setup_light_unit_y_n769_s20;
            setup_light_unit_y_n771_s21 <= setup_light_unit_y_n771_s20;
            setup_light_unit_z_n900_s21 <= setup_light_unit_z_n900;
            setup_light_unit_z_n903_s21 <= setup_light_unit_z_n903;
            setup_light_unit_z_n970_s21 <= setup_light_unit_z_n970;
            setup_light_unit_z_n981_s21 <= setup_light_unit_z_n981_s20;
            setup_light_unit_z_n983_s21 <= setup_light_unit_z_n983_s20;
            setup_light_unit_z_n985_s21 <= setup_light_unit_z_n985_s20;
            setup_half_unit_x_n1311_s21 <= setup_half_unit_x_n1311_s20;
            setup_half_unit_x_n1436_s21 <= setup_half_unit_x_n1436;
            setup_half_unit_x_n1439_s21 <= setup_half_unit_x_n1439;
            setup_half_unit_x_n1506_s21 <= setup_half_unit_x_n1506;
            setup_half_unit_x_n1518_s21 <= setup_half_unit_x_n1518_s20;
            setup_half_unit_x_n1520_s21 <= setup_half_unit_x_n1520_s20;
            setup_half_unit_x_n1522_s21 <= setup_half_unit_x_n1522_s20;
            setup_half_unit_y_n1651_s21 <= setup_half_unit_y_n1651;
            setup_half_unit_y_n1654_s21 <= setup_half_unit_y_n1654;
            setup_half_unit_y_n1721_s21 <= setup_half_unit_y_n1721;
            setup_half_unit_y_n1732_s21 <= setup_half_unit_y_n1732_s20;
            setup_half_unit_y_n1734_s21 <= setup_half_unit_y_n1734_s20;
            setup_half_unit_y_n1736_s21 <= setup_half_unit_y_n1736_s20;
            setup_half_unit_z_n1865_s21 <= setup_half_unit_z_n1865;
            setup_half_unit_z_n1868_s21 <= setup_half_unit_z_n1868;
            setup_half_unit_z_n1935_s21 <= setup_half_unit_z_n1935;
            setup_half_unit_z_n1946_s21 <= setup_half_unit_z_n1946_s20;
            setup_half_unit_z_n1948_s21 <= setup_half_unit_z_n1948_s20;
            setup_half_unit_z_n1950_s21 <= setup_half_unit_z_n1950_s20;
            setup_bump_unit_x_n2418_s21 <= setup_bump_unit_x_n2418;
            setup_bump_unit_x_n2419_s21 <= setup_bump_unit_x_n2419_s20;
            setup_bump_unit_x_n2420_s21 <= setup_bump_unit_x_n2420;
            setup_bump_unit_y_n2624_s21 <= setup_bump_unit_y_n2624;
            setup_bump_unit_y_n2625_s21 <= setup_bump_unit_y_n2625_s20;
            setup_bump_unit_y_n2626_s21 <= setup_bump_unit_y_n2626;
            setup_bump_unit_z_n2830_s21 <= setup_bump_unit_z_n2830;
            setup_bump_unit_z_n2831_s21 <= setup_bump_unit_z_n2831_s20;
            setup_bump_unit_z_n2832_s21 <= setup_bump_unit_z_n2832;
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;

    // ---- stage 21 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n475_term = {3'h0, setup_light_unit_x_n344_s21} ^ {26{setup_light_unit_x_n471_s21}};
    wire signed [25:0] setup_light_unit_x_n475 = {setup_light_unit_x_n474_s21[24], setup_light_unit_x_n474_s21} + setup_light_unit_x_n475_term + {25'h0, setup_light_unit_x_n471_s21}; // s26f0
    wire signed [23:0] setup_light_unit_x_n476 = setup_light_unit_x_n475[23:0]; // s24f0
    wire setup_light_unit_x_n477 = setup_light_unit_x_n476[23]; // u1f0
    wire setup_light_unit_x_n478 = setup_light_unit_x_n477 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n479 = setup_light_unit_x_n476; // u24f0
    wire [24:0] setup_light_unit_x_n480 = {setup_light_unit_x_n479, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n481 = setup_light_unit_x_n480; // s25f0
    wire [25:0] setup_light_unit_x_n482_term = {3'h0, setup_light_unit_x_n344_s21} ^ {26{setup_light_unit_x_n478}};
    wire signed [25:0] setup_light_unit_x_n482 = {setup_light_unit_x_n481[24], setup_light_unit_x_n481} + setup_light_unit_x_n482_term + {25'h0, setup_light_unit_x_n478}; // s26f0
    wire signed [23:0] setup_light_unit_x_n483 = setup_light_unit_x_n482[23:0]; // s24f0
    wire setup_light_unit_x_n484 = setup_light_unit_x_n483[23]; // u1f0
    wire setup_light_unit_x_n485 = setup_light_unit_x_n484 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n486 = setup_light_unit_x_n483; // u24f0
    wire [24:0] setup_light_unit_x_n487 = {setup_light_unit_x_n486, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n488 = setup_light_unit_x_n487; // s25f0
    wire [11:0] setup_light_unit_x_n542 = {setup_light_unit_x_n541_s21, setup_light_unit_x_n478}; // u12f0
    wire [12:0] setup_light_unit_x_n543 = {setup_light_unit_x_n542, setup_light_unit_x_n485}; // u13f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n690_term = {3'h0, setup_light_unit_x_n344_s21} ^ {26{setup_light_unit_y_n686_s21}};
    wire signed [25:0] setup_light_unit_y_n690 = {setup_light_unit_y_n689_s21[24], setup_light_unit_y_n689_s21} + setup_light_unit_y_n690_term + {25'h0, setup_light_unit_y_n686_s21}; // s26f0
    wire signed [23:0] setup_light_unit_y_n691 = setup_light_unit_y_n690[23:0]; // s24f0
    wire setup_light_unit_y_n692 = setup_light_unit_y_n691[23]; // u1f0
    wire setup_light_unit_y_n693 = setup_light_unit_y_n692 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n694 = setup_light_unit_y_n691; // u24f0
    wire [24:0] setup_light_unit_y_n695 = {setup_light_unit_y_n694, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n696 = setup_light_unit_y_n695; // s25f0
    wire [25:0] setup_light_unit_y_n697_term = {3'h0, setup_light_unit_x_n344_s21} ^ {26{setup_light_unit_y_n693}};
    wire signed [25:0] setup_light_unit_y_n697 = {setup_light_unit_y_n696[24], setup_light_unit_y_n696} + setup_light_unit_y_n697_term + {25'h0, setup_light_unit_y_n693}; // s26f0
    wire signed [23:0] setup_light_unit_y_n698 = setup_light_unit_y_n697[23:0]; // s24f0
    wire setup_light_unit_y_n699 = setup_light_unit_y_n698[23]; // u1f0
    wire setup_light_unit_y_n700 = setup_light_unit_y_n699 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n701 = setup_light_unit_y_n698; // u24f0
    wire [24:0] setup_light_unit_y_n702 = {setup_light_unit_y_n701, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n703 = setup_light_unit_y_n702; // s25f0
    wire [11:0] setup_light_unit_y_n757 = {setup_light_unit_y_n756_s21, setup_light_unit_y_n693}; // u12f0
    wire [12:0] setup_light_unit_y_n758 = {setup_light_unit_y_n757, setup_light_unit_y_n700}; // u13f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n904_term = {3'h0, setup_light_unit_x_n344_s21} ^ {26{setup_light_unit_z_n900_s21}};
    wire signed [25:0] setup_light_unit_z_n904 = {setup_light_unit_z_n903_s21[24], setup_light_unit_z_n903_s21} + setup_light_unit_z_n904_term + {25'h0, setup_light_unit_z_n900_s21}; // s26f0
    wire signed [23:0] setup_light_unit_z_n905 = setup_light_unit_z_n904[23:0]; // s24f0
    wire setup_light_unit_z_n906 = setup_light_unit_z_n905[23]; // u1f0
    wire setup_light_unit_z_n907 = setup_light_unit_z_n906 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n908 = setup_light_unit_z_n905; // u24f0
    wire [24:0] setup_light_unit_z_n909 = {setup_light_unit_z_n908, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n910 = setup_light_unit_z_n909; // s25f0
    wire [25:0] setup_light_unit_z_n911_term = {3'h0, setup_light_unit_x_n344_s21} ^ {26{setup_light_unit_z_n907}};
    wire signed [25:0] setup_light_unit_z_n911 = {setup_light_unit_z_n910[24], setup_light_unit_z_n910} + setup_light_unit_z_n911_term + {25'h0, setup_light_unit_z_n907}; // s26f0
    wire signed [23:0] setup_light_unit_z_n912 = setup_light_unit_z_n911[23:0]; // s24f0
    wire setup_light_unit_z_n913 = setup_light_unit_z_n912[23]; // u1f0
    wire setup_light_unit_z_n914 = setup_light_unit_z_n913 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n915 = setup_light_unit_z_n912; // u24f0
    wire [24:0] setup_light_unit_z_n916 = {setup_light_unit_z_n915, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n917 = setup_light_unit_z_n916; // s25f0
    wire [11:0] setup_light_unit_z_n971 = {setup_light_unit_z_n970_s21, setup_light_unit_z_n907}; // u12f0
    wire [12:0] setup_light_unit_z_n972 = {setup_light_unit_z_n971, setup_light_unit_z_n914}; // u13f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1440_term = {3'h0, setup_half_unit_x_n1311_s21} ^ {26{setup_half_unit_x_n1436_s21}};
    wire signed [25:0] setup_half_unit_x_n1440 = {setup_half_unit_x_n1439_s21[24], setup_half_unit_x_n1439_s21} + setup_half_unit_x_n1440_term + {25'h0, setup_half_unit_x_n1436_s21}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1441 = setup_half_unit_x_n1440[23:0]; // s24f0
    wire setup_half_unit_x_n1442 = setup_half_unit_x_n1441[23]; // u1f0
    wire setup_half_unit_x_n1443 = setup_half_unit_x_n1442 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1444 = setup_half_unit_x_n1441; // u24f0
    wire [24:0] setup_half_unit_x_n1445 = {setup_half_unit_x_n1444, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1446 = setup_half_unit_x_n1445; // s25f0
    wire [25:0] setup_half_unit_x_n1447_term = {3'h0, setup_half_unit_x_n1311_s21} ^ {26{setup_half_unit_x_n1443}};
    wire signed [25:0] setup_half_unit_x_n1447 = {setup_half_unit_x_n1446[24], setup_half_unit_x_n1446} + setup_half_unit_x_n1447_term + {25'h0, setup_half_unit_x_n1443}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1448 = setup_half_unit_x_n1447[23:0]; // s24f0
    wire setup_half_unit_x_n1449 = setup_half_unit_x_n1448[23]; // u1f0
    wire setup_half_unit_x_n1450 = setup_half_unit_x_n1449 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1451 = setup_half_unit_x_n1448; // u24f0
    wire [24:0] setup_half_unit_x_n1452 = {setup_half_unit_x_n1451, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1453 = setup_half_unit_x_n1452; // s25f0
    wire [11:0] setup_half_unit_x_n1507 = {setup_half_unit_x_n1506_s21, setup_half_unit_x_n1443}; // u12f0
    wire [12:0] setup_half_unit_x_n1508 = {setup_half_unit_x_n1507, setup_half_unit_x_n1450}; // u13f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1655_term = {3'h0, setup_half_unit_x_n1311_s21} ^ {26{setup_half_unit_y_n1651_s21}};
    wire signed [25:0] setup_half_unit_y_n1655 = {setup_half_unit_y_n1654_s21[24], setup_half_unit_y_n1654_s21} + setup_half_unit_y_n1655_term + {25'h0, setup_half_unit_y_n1651_s21}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1656 = setup_half_unit_y_n1655[23:0]; // s24f0
    wire setup_half_unit_y_n1657 = setup_half_unit_y_n1656[23]; // u1f0
    wire setup_half_unit_y_n1658 = setup_half_unit_y_n1657 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1659 = setup_half_unit_y_n1656; // u24f0
    wire [24:0] setup_half_unit_y_n1660 = {setup_half_unit_y_n1659, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1661 = setup_half_unit_y_n1660; // s25f0
    wire [25:0] setup_half_unit_y_n1662_term = {3'h0, setup_half_unit_x_n1311_s21} ^ {26{setup_half_unit_y_n1658}};
    wire signed [25:0] setup_half_unit_y_n1662 = {setup_half_unit_y_n1661[24], setup_half_unit_y_n1661} + setup_half_unit_y_n1662_term + {25'h0, setup_half_unit_y_n1658}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1663 = setup_half_unit_y_n1662[23:0]; // s24f0
    wire setup_half_unit_y_n1664 = setup_half_unit_y_n1663[23]; // u1f0
    wire setup_half_unit_y_n1665 = setup_half_unit_y_n1664 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1666 = setup_half_unit_y_n1663; // u24f0
    wire [24:0] setup_half_unit_y_n1667 = {setup_half_unit_y_n1666, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1668 = setup_half_unit_y_n1667; // s25f0
    wire [11:0] setup_half_unit_y_n1722 = {setup_half_unit_y_n1721_s21, setup_half_unit_y_n1658}; // u12f0
    wire [12:0] setup_half_unit_y_n1723 = {setup_half_unit_y_n1722, setup_half_unit_y_n1665}; // u13f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1869_term = {3'h0, setup_half_unit_x_n1311_s21} ^ {26{setup_half_unit_z_n1865_s21}};
    wire signed [25:0] setup_half_unit_z_n1869 = {setup_half_unit_z_n1868_s21[24], setup_half_unit_z_n1868_s21} + setup_half_unit_z_n1869_term + {25'h0, setup_half_unit_z_n1865_s21}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1870 = setup_half_unit_z_n1869[23:0]; // s24f0
    wire setup_half_unit_z_n1871 = setup_half_unit_z_n1870[23]; // u1f0
    wire setup_half_unit_z_n1872 = setup_half_unit_z_n1871 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1873 = setup_half_unit_z_n1870; // u24f0
    wire [24:0] setup_half_unit_z_n1874 = {setup_half_unit_z_n1873, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1875 = setup_half_unit_z_n1874; // s25f0
    wire [25:0] setup_half_unit_z_n1876_term = {3'h0, setup_half_unit_x_n1311_s21} ^ {26{setup_half_unit_z_n1872}};
    wire signed [25:0] setup_half_unit_z_n1876 = {setup_half_unit_z_n1875[24], setup_half_unit_z_n1875} + setup_half_unit_z_n1876_term + {25'h0, setup_half_unit_z_n1872}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1877 = setup_half_unit_z_n1876[23:0]; // s24f0
    wire setup_half_unit_z_n1878 = setup_half_unit_z_n1877[23]; // u1f0
    wire setup_half_unit_z_n1879 = setup_half_unit_z_n1878 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1880 = setup_half_unit_z_n1877; // u24f0
    wire [24:0] setup_half_unit_z_n1881 = {setup_half_unit_z_n1880, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1882 = setup_half_unit_z_n1881; // s25f0
    wire [11:0] setup_half_unit_z_n1936 = {setup_half_unit_z_n1935_s21, setup_half_unit_z_n1872}; // u12f0
    wire [12:0] setup_half_unit_z_n1937 = {setup_half_unit_z_n1936, setup_half_unit_z_n1879}; // u13f0
    // setup.bump.unit_x
    wire signed [2:-18] setup_bump_unit_x_n2421 = setup_bump_unit_x_n2419_s21 ? setup_bump_unit_x_n2420_s21 : {1'b0, setup_bump_unit_x_n2418_s21}; // s21f18
    wire signed [3:-18] setup_bump_unit_x_x_sum = {setup_bump_unit_x_n2421[2], setup_bump_unit_x_n2421} + 22'h2;
    wire signed [3:-16] setup_bump_unit_x_x_cut = setup_bump_unit_x_x_sum[3:-16];
    wire setup_bump_unit_x_x_over = ~setup_bump_unit_x_x_cut[3] & (|setup_bump_unit_x_x_cut[2:1]);
    wire setup_bump_unit_x_x_under = setup_bump_unit_x_x_cut[3] & ~(&setup_bump_unit_x_x_cut[2:1]);
    wire signed [1:-16] setup_bump_unit_x_x = setup_bump_unit_x_x_over ? 18'h1ffff : setup_bump_unit_x_x_under ? 18'h20000 : setup_bump_unit_x_x_cut[1:-16]; // s18f16
    // setup.bump.unit_y
    wire signed [2:-18] setup_bump_unit_y_n2627 = setup_bump_unit_y_n2625_s21 ? setup_bump_unit_y_n2626_s21 : {1'b0, setup_bump_unit_y_n2624_s21}; // s21f18
    wire signed [3:-18] setup_bump_unit_y_y_sum = {setup_bump_unit_y_n2627[2], setup_bump_unit_y_n2627} + 22'h2;
    wire signed [3:-16] setup_bump_unit_y_y_cut = setup_bump_unit_y_y_sum[3:-16];
    wire setup_bump_unit_y_y_over = ~setup_bump_unit_y_y_cut[3] & (|setup_bump_unit_y_y_cut[2:1]);
    wire setup_bump_unit_y_y_under = setup_bump_unit_y_y_cut[3] & ~(&setup_bump_unit_y_y_cut[2:1]);
    wire signed [1:-16] setup_bump_unit_y_y = setup_bump_unit_y_y_over ? 18'h1ffff : setup_bump_unit_y_y_under ? 18'h20000 : setup_bump_unit_y_y_cut[1:-16]; // s18f16
    // setup.bump.unit_z
    wire signed [2:-18] setup_bump_unit_z_n2833 = setup_bump_unit_z_n2831_s21 ? setup_bump_unit_z_n2832_s21 : {1'b0, setup_bump_unit_z_n2830_s21}; // s21f18
    wire signed [3:-18] setup_bump_unit_z_z_sum = {setup_bump_unit_z_n2833[2], setup_bump_unit_z_n2833} + 22'h2;
    wire signed [3:-16] setup_bump_unit_z_z_cut = setup_bump_unit_z_z_sum[3:-16];
    wire setup_bump_unit_z_z_over = ~setup_bump_unit_z_z_cut[3] & (|setup_bump_unit_z_z_cut[2:1]);
    wire setup_bump_unit_z_z_under = setup_bump_unit_z_z_cut[3] & ~(&setup_bump_unit_z_z_cut[2:1]);
    wire signed [1:-16] setup_bump_unit_z_z = setup_bump_unit_z_z_over ? 18'h1ffff : setup_bump_unit_z_z_under ? 18'h20000 : setup_bump_unit_z_z_cut[1:-16]; // s18f16

    reg [22:0] setup_light_unit_x_n344_s22; // u23f0
    reg setup_light_unit_x_n485_s22; // u1f0
    reg signed [24:0] setup_light_unit_x_n488_s22; // s25f0
    reg [12:0] setup_light_unit_x_n543_s22; // u13f0
    reg setup_light_unit_x_n553_s22; // u1f0
    reg setup_light_unit_x_n555_s22; // u1f0
    reg setup_light_unit_x_n557_s22; // u1f0
    reg setup_light_unit_y_n700_s22; // u1f0
    reg signed [24:0] setup_light_unit_y_n703_s22; // s25f0
    reg [12:0] setup_light_unit_y_n758_s22; // u13f0
    reg setup_light_unit_y_n767_s22; // u1f0
    reg setup_light_unit_y_n769_s22; // u1f0
    reg setup_light_unit_y_n771_s22; // u1f0
    reg setup_light_unit_z_n914_s22; // u1f0
    reg signed [24:0] setup_light_unit_z_n917_s22; // s25f0
    reg [12:0] setup_light_unit_z_n972_s22; // u13f0
    reg setup_light_unit_z_n981_s22; // u1f0
    reg setup_light_unit_z_n983_s22; // u1f0
    reg setup_light_unit_z_n985_s22; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s22; // u23f0
    reg setup_half_unit_x_n1450_s22; // u1f0
    reg signed [24:0] setup_half_unit_x_n1453_s22; // s25f0
    reg [12:0] setup_half_unit_x_n1508_s22; // u13f0
    reg setup_half_unit_x_n1518_s22; // u1f0
    reg setup_half_unit_x_n1520_s22; // u1f0
    reg setup_half_unit_x_n1522_s22; // u1f0
    reg setup_half_unit_y_n1665_s22; // u1f0
    reg signed [24:0] setup_half_unit_y_n1668_s22; // s25f0
    reg [12:0] setup_half_unit_y_n1723_s22; // u13f0
    reg setup_half_unit_y_n1732_s22; // u1f0
    reg setup_half_unit_y_n1734_s22; // u1f0
    reg setup_half_unit_y_n1736_s22; // u1f0
    reg setup_half_unit_z_n1879_s22; // u1f0
    reg signed [24:0] setup_half_unit_z_n1882_s22; // s25f0
    reg [12:0] setup_half_unit_z_n1937_s22; // u13f0
    reg setup_half_unit_z_n1946_s22; // u1f0
    reg setup_half_unit_z_n1948_s22; // u1f0
    reg setup_half_unit_z_n1950_s22; // u1f0
    reg signed [1:-16] setup_bump_unit_x_x_s22; // s18f16
    reg signed [1:-16] setup_bump_unit_y_y_s22; // s18f16
    reg signed [1:-16] setup_bump_unit_z_z_s22; // s18f16
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s22 <= setup_light_unit_x_n344_s21;
            setup_light_unit_x_n485_s22 <= setup_light_unit_x_n485;
            setup_light_unit_x_n488_s22 <= setup_light_unit_x_n488;
            setup_light_unit_x_n543_s22 <= setup_light_unit_x_n543;
            setup_light_unit_x_n553_s22 <= setup_light_unit_x_n553_s21;
            setup_light_unit_x_n555_s22 <= setup_light_unit_x_n555_s21;
            setup_light_unit_x_n557_s22 <= setup_light_unit_x_n557_s21;
            setup_light_unit_y_n700_s22 <= setup_light_unit_y_n700;
            setup_light_unit_y_n703_s22 <= setup_light_unit_y_n703;
            setup_light_unit_y_n758_s22 <= setup_light_unit_y_n758;
            setup_light_unit_y_n767_s22 <= setup_light_unit_y_n767_s21;
            setup_light_unit_y_n769_s22 <= setup_light_unit_y_n769_s21;
            setup_light_unit_y_n771_s22 <= setup_light_unit_y_n771_s21;
            setup_light_unit_z_n914_s22 <= setup_light_unit_z_n914;
            setup_light_unit_z_n917_s22 <= setup_light_unit_z_n917;
            setup_light_unit_z_n972_s22 <= setup_light_unit_z_n972;
            setup_light_unit_z_n981_s22 <= setup_light_unit_z_n981_s21;
            setup_light_unit_z_n983_s22 <= setup_light_unit_z_n983_s21;
            setup_light_unit_z_n985_s22 <= setup_light_unit_z_n985_s21;
            setup_half_unit_x_n1311_s22 <= setup_half_unit_x_n1311_s21;
            setup_half_unit_x_n1450_s22 <= setup_half_unit_x_n1450;
            setup_half_unit_x_n1453_s22 <= setup_half_unit_x_n1453;
            setup_half_unit_x_n1508_s22 <= setup_half_unit_x_n1508;
            setup_half_unit_x_n1518_s22 <= setup_half_unit_x_n1518_s21;
            setup_half_unit_x_n1520_s22 <= setup_half_unit_x_n1520_s21;
            setup_half_unit_x_n1522_s22 <= setup_half_unit_x_n1522_s21;
            setup_half_unit_y_n1665_s22 <= setup_half_unit_y_n1665;
            setup_half_unit_y_n1668_s22 <= setup_half_unit_y_n1668;
            setup_half_unit_y_n1723_s22 <= setup_half_unit_y_n1723;
            setup_half_unit_y_n1732_s22 <= setup_half_unit_y_n1732_s21;
            setup_half_unit_y_n1734_s22 <= setup_half_unit_y_n1734_s21;
            setup_half_unit_y_n1736_s22 <= setup_half_unit_y_n1736_s21;
            setup_half_unit_z_n1879_s22 <= setup_half_unit_z_n1879;
            setup_half_unit_z_n1882_s22 <= setup_half_unit_z_n1882;
            setup_half_unit_z_n1937_s22 <= setup_half_unit_z_n1937;
            setup_half_unit_z_n1946_s22 <= setup_half_unit_z_n1946_s21;
            setup_half_unit_z_n1948_s22 <= setup_half_unit_z_n1948_s21;
            setup_half_unit_z_n1950_s22 <= setup_half_unit_z_n1950_s21;
            setup_bump_unit_x_x_s22 <= setup_bump_unit_x_x;
            setup_bump_unit_y_y_s22 <= setup_bump_unit_y_y;
            setup_bump_unit_z_z_s22 <= setup_bump_unit_z_z;
        end
    reg valid_s22;
    always @(posedge clk)
        if (rst) valid_s22 <= 1'b0;
        else if (ce) valid_s22 <= valid_s21;

    // ---- stage 22 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n489_term = {3'h0, setup_light_unit_x_n344_s22} ^ {26{setup_light_unit_x_n485_s22}};
    wire signed [25:0] setup_light_unit_x_n489 = {setup_light_unit_x_n488_s22[24], setup_light_unit_x_n488_s22} + setup_light_unit_x_n489_term + {25'h0, setup_light_unit_x_n485_s22}; // s26f0
    wire signed [23:0] setup_light_unit_x_n490 = setup_light_unit_x_n489[23:0]; // s24f0
    wire setup_light_unit_x_n491 = setup_light_unit_x_n490[23]; // u1f0
    wire setup_light_unit_x_n492 = setup_light_unit_x_n491 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n493 = setup_light_unit_x_n490; // u24f0
    wire [24:0] setup_light_unit_x_n494 = {setup_light_unit_x_n493, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n495 = setup_light_unit_x_n494; // s25f0
    wire [25:0] setup_light_unit_x_n496_term = {3'h0, setup_light_unit_x_n344_s22} ^ {26{setup_light_unit_x_n492}};
    wire signed [25:0] setup_light_unit_x_n496 = {setup_light_unit_x_n495[24], setup_light_unit_x_n495} + setup_light_unit_x_n496_term + {25'h0, setup_light_unit_x_n492}; // s26f0
    wire signed [23:0] setup_light_unit_x_n497 = setup_light_unit_x_n496[23:0]; // s24f0
    wire setup_light_unit_x_n498 = setup_light_unit_x_n497[23]; // u1f0
    wire setup_light_unit_x_n499 = setup_light_unit_x_n498 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n500 = setup_light_unit_x_n497; // u24f0
    wire [24:0] setup_light_unit_x_n501 = {setup_light_unit_x_n500, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n502 = setup_light_unit_x_n501; // s25f0
    wire [13:0] setup_light_unit_x_n544 = {setup_light_unit_x_n543_s22, setup_light_unit_x_n492}; // u14f0
    wire [14:0] setup_light_unit_x_n545 = {setup_light_unit_x_n544, setup_light_unit_x_n499}; // u15f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n704_term = {3'h0, setup_light_unit_x_n344_s22} ^ {26{setup_light_unit_y_n700_s22}};
    wire signed [25:0] setup_light_unit_y_n704 = {setup_light_unit_y_n703_s22[24], setup_light_unit_y_n703_s22} + setup_light_unit_y_n704_term + {25'h0, setup_light_unit_y_n700_s22}; // s26f0
    wire signed [23:0] setup_light_unit_y_n705 = setup_light_unit_y_n704[23:0]; // s24f0
    wire setup_light_unit_y_n706 = setup_light_unit_y_n705[23]; // u1f0
    wire setup_light_unit_y_n707 = setup_light_unit_y_n706 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n708 = setup_light_unit_y_n705; // u24f0
    wire [24:0] setup_light_unit_y_n709 = {setup_light_unit_y_n708, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n710 = setup_light_unit_y_n709; // s25f0
    wire [25:0] setup_light_unit_y_n711_term = {3'h0, setup_light_unit_x_n344_s22} ^ {26{setup_light_unit_y_n707}};
    wire signed [25:0] setup_light_unit_y_n711 = {setup_light_unit_y_n710[24], setup_light_unit_y_n710} + setup_light_unit_y_n711_term + {25'h0, setup_light_unit_y_n707}; // s26f0
    wire signed [23:0] setup_light_unit_y_n712 = setup_light_unit_y_n711[23:0]; // s24f0
    wire setup_light_unit_y_n713 = setup_light_unit_y_n712[23]; // u1f0
    wire setup_light_unit_y_n714 = setup_light_unit_y_n713 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n715 = setup_light_unit_y_n712; // u24f0
    wire [24:0] setup_light_unit_y_n716 = {setup_light_unit_y_n715, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n717 = setup_light_unit_y_n716; // s25f0
    wire [13:0] setup_light_unit_y_n759 = {setup_light_unit_y_n758_s22, setup_light_unit_y_n707}; // u14f0
    wire [14:0] setup_light_unit_y_n760 = {setup_light_unit_y_n759, setup_light_unit_y_n714}; // u15f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n918_term = {3'h0, setup_light_unit_x_n344_s22} ^ {26{setup_light_unit_z_n914_s22}};
    wire signed [25:0] setup_light_unit_z_n918 = {setup_light_unit_z_n917_s22[24], setup_light_unit_z_n917_s22} + setup_light_unit_z_n918_term + {25'h0, setup_light_unit_z_n914_s22}; // s26f0
    wire signed [23:0] setup_light_unit_z_n919 = setup_light_unit_z_n918[23:0]; // s24f0
    wire setup_light_unit_z_n920 = setup_light_unit_z_n919[23]; // u1f0
    wire setup_light_unit_z_n921 = setup_light_unit_z_n920 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n922 = setup_light_unit_z_n919; // u24f0
    wire [24:0] setup_light_unit_z_n923 = {setup_light_unit_z_n922, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n924 = setup_light_unit_z_n923; // s25f0
    wire [25:0] setup_light_unit_z_n925_term = {3'h0, setup_light_unit_x_n344_s22} ^ {26{setup_light_unit_z_n921}};
    wire signed [25:0] setup_light_unit_z_n925 = {setup_light_unit_z_n924[24], setup_light_unit_z_n924} + setup_light_unit_z_n925_term + {25'h0, setup_light_unit_z_n921}; // s26f0
    wire signed [23:0] setup_light_unit_z_n926 = setup_light_unit_z_n925[23:0]; // s24f0
    wire setup_light_unit_z_n927 = setup_light_unit_z_n926[23]; // u1f0
    wire setup_light_unit_z_n928 = setup_light_unit_z_n927 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n929 = setup_light_unit_z_n926; // u24f0
    wire [24:0] setup_light_unit_z_n930 = {setup_light_unit_z_n929, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n931 = setup_light_unit_z_n930; // s25f0
    wire [13:0] setup_light_unit_z_n973 = {setup_light_unit_z_n972_s22, setup_light_unit_z_n921}; // u14f0
    wire [14:0] setup_light_unit_z_n974 = {setup_light_unit_z_n973, setup_light_unit_z_n928}; // u15f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1454_term = {3'h0, setup_half_unit_x_n1311_s22} ^ {26{setup_half_unit_x_n1450_s22}};
    wire signed [25:0] setup_half_unit_x_n1454 = {setup_half_unit_x_n1453_s22[24], setup_half_unit_x_n1453_s22} + setup_half_unit_x_n1454_term + {25'h0, setup_half_unit_x_n1450_s22}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1455 = setup_half_unit_x_n1454[23:0]; // s24f0
    wire setup_half_unit_x_n1456 = setup_half_unit_x_n1455[23]; // u1f0
    wire setup_half_unit_x_n1457 = setup_half_unit_x_n1456 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1458 = setup_half_unit_x_n1455; // u24f0
    wire [24:0] setup_half_unit_x_n1459 = {setup_half_unit_x_n1458, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1460 = setup_half_unit_x_n1459; // s25f0
    wire [25:0] setup_half_unit_x_n1461_term = {3'h0, setup_half_unit_x_n1311_s22} ^ {26{setup_half_unit_x_n1457}};
    wire signed [25:0] setup_half_unit_x_n1461 = {setup_half_unit_x_n1460[24], setup_half_unit_x_n1460} + setup_half_unit_x_n1461_term + {25'h0, setup_half_unit_x_n1457}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1462 = setup_half_unit_x_n1461[23:0]; // s24f0
    wire setup_half_unit_x_n1463 = setup_half_unit_x_n1462[23]; // u1f0
    wire setup_half_unit_x_n1464 = setup_half_unit_x_n1463 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1465 = setup_half_unit_x_n1462; // u24f0
    wire [24:0] setup_half_unit_x_n1466 = {setup_half_unit_x_n1465, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1467 = setup_half_unit_x_n1466; // s25f0
    wire [13:0] setup_half_unit_x_n1509 = {setup_half_unit_x_n1508_s22, setup_half_unit_x_n1457}; // u14f0
    wire [14:0] setup_half_unit_x_n1510 = {setup_half_unit_x_n1509, setup_half_unit_x_n1464}; // u15f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1669_term = {3'h0, setup_half_unit_x_n1311_s22} ^ {26{setup_half_unit_y_n1665_s22}};
    wire signed [25:0] setup_half_unit_y_n1669 = {setup_half_unit_y_n1668_s22[24], setup_half_unit_y_n1668_s22} + setup_half_unit_y_n1669_term + {25'h0, setup_half_unit_y_n1665_s22}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1670 = setup_half_unit_y_n1669[23:0]; // s24f0
    wire setup_half_unit_y_n1671 = setup_half_unit_y_n1670[23]; // u1f0
    wire setup_half_unit_y_n1672 = setup_half_unit_y_n1671 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1673 = setup_half_unit_y_n1670; // u24f0
    wire [24:0] setup_half_unit_y_n1674 = {setup_half_unit_y_n1673, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1675 = setup_half_unit_y_n1674; // s25f0
    wire [25:0] setup_half_unit_y_n1676_term = {3'h0, setup_half_unit_x_n1311_s22} ^ {26{setup_half_unit_y_n1672}};
    wire signed [25:0] setup_half_unit_y_n1676 = {setup_half_unit_y_n1675[24], setup_half_unit_y_n1675} + setup_half_unit_y_n1676_term + {25'h0, setup_half_unit_y_n1672}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1677 = setup_half_unit_y_n1676[23:0]; // s24f0
    wire setup_half_unit_y_n1678 = setup_half_unit_y_n1677[23]; // u1f0
    wire setup_half_unit_y_n1679 = setup_half_unit_y_n1678 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1680 = setup_half_unit_y_n1677; // u24f0
    wire [24:0] setup_half_unit_y_n1681 = {setup_half_unit_y_n1680, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1682 = setup_half_unit_y_n1681; // s25f0
    wire [13:0] setup_half_unit_y_n1724 = {setup_half_unit_y_n1723_s22, setup_half_unit_y_n1672}; // u14f0
    wire [14:0] setup_half_unit_y_n1725 = {setup_half_unit_y_n1724, setup_half_unit_y_n1679}; // u15f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1883_term = {3'h0, setup_half_unit_x_n1311_s22} ^ {26{setup_half_unit_z_n1879_s22}};
    wire signed [25:0] setup_half_unit_z_n1883 = {setup_half_unit_z_n1882_s22[24], setup_half_unit_z_n1882_s22} + setup_half_unit_z_n1883_term + {25'h0, setup_half_unit_z_n1879_s22}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1884 = setup_half_unit_z_n1883[23:0]; // s24f0
    wire setup_half_unit_z_n1885 = setup_half_unit_z_n1884[23]; // u1f0
    wire setup_half_unit_z_n1886 = setup_half_unit_z_n1885 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1887 = setup_half_unit_z_n1884; // u24f0
    wire [24:0] setup_half_unit_z_n1888 = {setup_half_unit_z_n1887, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1889 = setup_half_unit_z_n1888; // s25f0
    wire [25:0] setup_half_unit_z_n1890_term = {3'h0, setup_half_unit_x_n1311_s22} ^ {26{setup_half_unit_z_n1886}};
    wire signed [25:0] setup_half_unit_z_n1890 = {setup_half_unit_z_n1889[24], setup_half_unit_z_n1889} + setup_half_unit_z_n1890_term + {25'h0, setup_half_unit_z_n1886}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1891 = setup_half_unit_z_n1890[23:0]; // s24f0
    wire setup_half_unit_z_n1892 = setup_half_unit_z_n1891[23]; // u1f0
    wire setup_half_unit_z_n1893 = setup_half_unit_z_n1892 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1894 = setup_half_unit_z_n1891; // u24f0
    wire [24:0] setup_half_unit_z_n1895 = {setup_half_unit_z_n1894, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1896 = setup_half_unit_z_n1895; // s25f0
    wire [13:0] setup_half_unit_z_n1938 = {setup_half_unit_z_n1937_s22, setup_half_unit_z_n1886}; // u14f0
    wire [14:0] setup_half_unit_z_n1939 = {setup_half_unit_z_n1938, setup_half_unit_z_n1893}; // u15f0

    reg [22:0] setup_light_unit_x_n344_s23; // u23f0
    reg setup_light_unit_x_n499_s23; // u1f0
    reg signed [24:0] setup_light_unit_x_n502_s23; // s25f0
    reg [14:0] setup_light_unit_x_n545_s23; // u15f0
    reg setup_light_unit_x_n553_s23; // u1f0
    reg setup_light_unit_x_n555_s23; // u1f0
    reg setup_light_unit_x_n557_s23; // u1f0
    reg setup_light_unit_y_n714_s23; // u1f0
    reg signed [24:0] setup_light_unit_y_n717_s23; // s25f0
    reg [14:0] setup_light_unit_y_n760_s23; // u15f0
    reg setup_light_unit_y_n767_s23; // u1f0
    reg setup_light_unit_y_n769_s23; // u1f0
    reg setup_light_unit_y_n771_s23; // u1f0
    reg setup_light_unit_z_n928_s23; // u1f0
    reg signed [24:0] setup_light_unit_z_n931_s23; // s25f0
    reg [14:0] setup_light_unit_z_n974_s23; // u15f0
    reg setup_light_unit_z_n981_s23; // u1f0
    reg setup_light_unit_z_n983_s23; // u1f0
    reg setup_light_unit_z_n985_s23; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s23; // u23f0
    reg setup_half_unit_x_n1464_s23; // u1f0
    reg signed [24:0] setup_half_unit_x_n1467_s23; // s25f0
    reg [14:0] setup_half_unit_x_n1510_s23; // u15f0
    reg setup_half_unit_x_n1518_s23; // u1f0
    reg setup_half_unit_x_n1520_s23; // u1f0
    reg setup_half_unit_x_n1522_s23; // u1f0
    reg setup_half_unit_y_n1679_s23; // u1f0
    reg signed [24:0] setup_half_unit_y_n1682_s23; // s25f0
    reg [14:0] setup_half_unit_y_n1725_s23; // u15f0
    reg setup_half_unit_y_n1732_s23; // u1f0
    reg setup_half_unit_y_n1734_s23; // u1f0
    reg setup_half_unit_y_n1736_s23; // u1f0
    reg setup_half_unit_z_n1893_s23; // u1f0
    reg signed [24:0] setup_half_unit_z_n1896_s23; // s25f0
    reg [14:0] setup_half_unit_z_n1939_s23; // u15f0
    reg setup_half_unit_z_n1946_s23; // u1f0
    reg setup_half_unit_z_n1948_s23; // u1f0
    reg setup_half_unit_z_n1950_s23; // u1f0
    reg signed [1:-16] setup_bump_unit_x_x_s23; // s18f16
    reg signed [1:-16] setup_bump_unit_y_y_s23; // s18f16
    reg signed [1:-16] setup_bump_unit_z_z_s23; // s18f16
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s23 <= setup_light_unit_x_n344_s22;
            setup_light_unit_x_n499_s23 <= setup_light_unit_x_n499;
            setup_light_unit_x_n502_s23 <= setup_light_unit_x_n502;
            setup_light_unit_x_n545_s23 <= setup_light_unit_x_n545;
            setup_light_unit_x_n553_s23 <= setup_light_unit_x_n553_s22;
            setup_light_unit_x_n555_s23 <= setup_light_unit_x_n555_s22;
            setup_light_unit_x_n557_s23 <= setup_light_unit_x_n557_s22;
            setup_light_unit_y_n714_s23 <= setup_light_unit_y_n714;
            setup_light_unit_y_n717_s23 <= setup_light_unit_y_n717;
            setup_light_unit_y_n760_s23 <= setup_light_unit_y_n760;
            setup_light_unit_y_n767_s23 <= setup_light_unit_y_n767_s22;
            setup_light_unit_y_n769_s23 <= setup_light_unit_y_n769_s22;
            setup_light_unit_y_n771_s23 <= setup_light_unit_y_n771_s22;
            setup_light_unit_z_n928_s23 <= setup_light_unit_z_n928;
            setup_light_unit_z_n931_s23 <= setup_light_unit_z_n931;
            setup_light_unit_z_n974_s23 <= setup_light_unit_z_n974;
            setup_light_unit_z_n981_s23 <= setup_light_unit_z_n981_s22;
            setup_light_unit_z_n983_s23 <= setup_light_unit_z_n983_s22;
            setup_light_unit_z_n985_s23 <= setup_light_unit_z_n985_s22;
            setup_half_unit_x_n1311_s23 <= setup_half_unit_x_n1311_s22;
            setup_half_unit_x_n1464_s23 <= setup_half_unit_x_n1464;
            setup_half_unit_x_n1467_s23 <= setup_half_unit_x_n1467;
            setup_half_unit_x_n1510_s23 <= setup_half_unit_x_n1510;
            setup_half_unit_x_n1518_s23 <= setup_half_unit_x_n1518_s22;
            setup_half_unit_x_n1520_s23 <= setup_half_unit_x_n1520_s22;
            setup_half_unit_x_n1522_s23 <= setup_half_unit_x_n1522_s22;
            setup_half_unit_y_n1679_s23 <= setup_half_unit_y_n1679;
            setup_half_unit_y_n1682_s23 <= setup_half_unit_y_n1682;
            setup_half_unit_y_n1725_s23 <= setup_half_unit_y_n1725;
            setup_half_unit_y_n1732_s23 <= setup_half_unit_y_n1732_s22;
            setup_half_unit_y_n1734_s23 <= setup_half_unit_y_n1734_s22;
            setup_half_unit_y_n1736_s23 <= setup_half_unit_y_n1736_s22;
            setup_half_unit_z_n1893_s23 <= setup_half_unit_z_n1893;
            setup_half_unit_z_n1896_s23 <= setup_half_unit_z_n1896;
            setup_half_unit_z_n1939_s23 <= setup_half_unit_z_n1939;
            setup_half_unit_z_n1946_s23 <= setup_half_unit_z_n1946_s22;
            setup_half_unit_z_n1948_s23 <= setup_half_unit_z_n1948_s22;
            setup_half_unit_z_n1950_s23 <= setup_half_unit_z_n1950_s22;
            setup_bump_unit_x_x_s23 <= setup_bump_unit_x_x_s22;
            setup_bump_unit_y_y_s23 <= setup_bump_unit_y_y_s22;
            setup_bump_unit_z_z_s23 <= setup_bump_unit_z_z_s22;
        end
    reg valid_s23;
    always @(posedge clk)
        if (rst) valid_s23 <= 1'b0;
        else if (ce) valid_s23 <= valid_s22;

    // ---- stage 23 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n503_term = {3'h0, setup_light_unit_x_n344_s23} ^ {26{setup_light_unit_x_n499_s23}};
    wire signed [25:0] setup_light_unit_x_n503 = {setup_light_unit_x_n502_s23[24], setup_light_unit_x_n502_s23} + setup_light_unit_x_n503_term + {25'h0, setup_light_unit_x_n499_s23}; // s26f0
    wire signed [23:0] setup_light_unit_x_n504 = setup_light_unit_x_n503[23:0]; // s24f0
    wire setup_light_unit_x_n505 = setup_light_unit_x_n504[23]; // u1f0
    wire setup_light_unit_x_n506 = setup_light_unit_x_n505 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n507 = setup_light_unit_x_n504; // u24f0
    wire [24:0] setup_light_unit_x_n508 = {setup_light_unit_x_n507, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n509 = setup_light_unit_x_n508; // s25f0
    wire [25:0] setup_light_unit_x_n510_term = {3'h0, setup_light_unit_x_n344_s23} ^ {26{setup_light_unit_x_n506}};
    wire signed [25:0] setup_light_unit_x_n510 = {setup_light_unit_x_n509[24], setup_light_unit_x_n509} + setup_light_unit_x_n510_term + {25'h0, setup_light_unit_x_n506}; // s26f0
    wire signed [23:0] setup_light_unit_x_n511 = setup_light_unit_x_n510[23:0]; // s24f0
    wire setup_light_unit_x_n512 = setup_light_unit_x_n511[23]; // u1f0
    wire setup_light_unit_x_n513 = setup_light_unit_x_n512 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n514 = setup_light_unit_x_n511; // u24f0
    wire [24:0] setup_light_unit_x_n515 = {setup_light_unit_x_n514, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n516 = setup_light_unit_x_n515; // s25f0
    wire [15:0] setup_light_unit_x_n546 = {setup_light_unit_x_n545_s23, setup_light_unit_x_n506}; // u16f0
    wire [16:0] setup_light_unit_x_n547 = {setup_light_unit_x_n546, setup_light_unit_x_n513}; // u17f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n718_term = {3'h0, setup_light_unit_x_n344_s23} ^ {26{setup_light_unit_y_n714_s23}};
    wire signed [25:0] setup_light_unit_y_n718 = {setup_light_unit_y_n717_s23[24], setup_light_unit_y_n717_s23} + setup_light_unit_y_n718_term + {25'h0, setup_light_unit_y_n714_s23}; // s26f0
    wire signed [23:0] setup_light_unit_y_n719 = setup_light_unit_y_n718[23:0]; // s24f0
    wire setup_light_unit_y_n720 = setup_light_unit_y_n719[23]; // u1f0
    wire setup_light_unit_y_n721 = setup_light_unit_y_n720 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n722 = setup_light_unit_y_n719; // u24f0
    wire [24:0] setup_light_unit_y_n723 = {setup_light_unit_y_n722, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n724 = setup_light_unit_y_n723; // s25f0
    wire [25:0] setup_light_unit_y_n725_term = {3'h0, setup_light_unit_x_n344_s23} ^ {26{setup_light_unit_y_n721}};
    wire signed [25:0] setup_light_unit_y_n725 = {setup_light_unit_y_n724[24], setup_light_unit_y_n724} + setup_light_unit_y_n725_term + {25'h0, setup_light_unit_y_n721}; // s26f0
    wire signed [23:0] setup_light_unit_y_n726 = setup_light_unit_y_n725[23:0]; // s24f0
    wire setup_light_unit_y_n727 = setup_light_unit_y_n726[23]; // u1f0
    wire setup_light_unit_y_n728 = setup_light_unit_y_n727 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n729 = setup_light_unit_y_n726; // u24f0
    wire [24:0] setup_light_unit_y_n730 = {setup_light_unit_y_n729, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n731 = setup_light_unit_y_n730; // s25f0
    wire [15:0] setup_light_unit_y_n761 = {setup_light_unit_y_n760_s23, setup_light_unit_y_n721}; // u16f0
    wire [16:0] setup_light_unit_y_n762 = {setup_light_unit_y_n761, setup_light_unit_y_n728}; // u17f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n932_term = {3'h0, setup_light_unit_x_n344_s23} ^ {26{setup_light_unit_z_n928_s23}};
    wire signed [25:0] setup_light_unit_z_n932 = {setup_light_unit_z_n931_s23[24], setup_light_unit_z_n931_s23} + setup_light_unit_z_n932_term + {25'h0, setup_light_unit_z_n928_s23}; // s26f0
    wire signed [23:0] setup_light_unit_z_n933 = setup_light_unit_z_n932[23:0]; // s24f0
    wire setup_light_unit_z_n934 = setup_light_unit_z_n933[23]; // u1f0
    wire setup_light_unit_z_n935 = setup_light_unit_z_n934 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n936 = setup_light_unit_z_n933; // u24f0
    wire [24:0] setup_light_unit_z_n937 = {setup_light_unit_z_n936, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n938 = setup_light_unit_z_n937; // s25f0
    wire [25:0] setup_light_unit_z_n939_term = {3'h0, setup_light_unit_x_n344_s23} ^ {26{setup_light_unit_z_n935}};
    wire signed [25:0] setup_light_unit_z_n939 = {setup_light_unit_z_n938[24], setup_light_unit_z_n938} + setup_light_unit_z_n939_term + {25'h0, setup_light_unit_z_n935}; // s26f0
    wire signed [23:0] setup_light_unit_z_n940 = setup_light_unit_z_n939[23:0]; // s24f0
    wire setup_light_unit_z_n941 = setup_light_unit_z_n940[23]; // u1f0
    wire setup_light_unit_z_n942 = setup_light_unit_z_n941 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n943 = setup_light_unit_z_n940; // u24f0
    wire [24:0] setup_light_unit_z_n944 = {setup_light_unit_z_n943, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n945 = setup_light_unit_z_n944; // s25f0
    wire [15:0] setup_light_unit_z_n975 = {setup_light_unit_z_n974_s23, setup_light_unit_z_n935}; // u16f0
    wire [16:0] setup_light_unit_z_n976 = {setup_light_unit_z_n975, setup_light_unit_z_n942}; // u17f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1468_term = {3'h0, setup_half_unit_x_n1311_s23} ^ {26{setup_half_unit_x_n1464_s23}};
    wire signed [25:0] setup_half_unit_x_n1468 = {setup_half_unit_x_n1467_s23[24], setup_half_unit_x_n1467_s23} + setup_half_unit_x_n1468_term + {25'h0, setup_half_unit_x_n1464_s23}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1469 = setup_half_unit_x_n1468[23:0]; // s24f0
    wire setup_half_unit_x_n1470 = setup_half_unit_x_n1469[23]; // u1f0
    wire setup_half_unit_x_n1471 = setup_half_unit_x_n1470 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1472 = setup_half_unit_x_n1469; // u24f0
    wire [24:0] setup_half_unit_x_n1473 = {setup_half_unit_x_n1472, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1474 = setup_half_unit_x_n1473; // s25f0
    wire [25:0] setup_half_unit_x_n1475_term = {3'h0, setup_half_unit_x_n1311_s23} ^ {26{setup_half_unit_x_n1471}};
    wire signed [25:0] setup_half_unit_x_n1475 = {setup_half_unit_x_n1474[24], setup_half_unit_x_n1474} + setup_half_unit_x_n1475_term + {25'h0, setup_half_unit_x_n1471}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1476 = setup_half_unit_x_n1475[23:0]; // s24f0
    wire setup_half_unit_x_n1477 = setup_half_unit_x_n1476[23]; // u1f0
    wire setup_half_unit_x_n1478 = setup_half_unit_x_n1477 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1479 = setup_half_unit_x_n1476; // u24f0
    wire [24:0] setup_half_unit_x_n1480 = {setup_half_unit_x_n1479, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1481 = setup_half_unit_x_n1480; // s25f0
    wire [15:0] setup_half_unit_x_n1511 = {setup_half_unit_x_n1510_s23, setup_half_unit_x_n1471}; // u16f0
    wire [16:0] setup_half_unit_x_n1512 = {setup_half_unit_x_n1511, setup_half_unit_x_n1478}; // u17f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1683_term = {3'h0, setup_half_unit_x_n1311_s23} ^ {26{setup_half_unit_y_n1679_s23}};
    wire signed [25:0] setup_half_unit_y_n1683 = {setup_half_unit_y_n1682_s23[24], setup_half_unit_y_n1682_s23} + setup_half_unit_y_n1683_term + {25'h0, setup_half_unit_y_n1679_s23}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1684 = setup_half_unit_y_n1683[23:0]; // s24f0
    wire setup_half_unit_y_n1685 = setup_half_unit_y_n1684[23]; // u1f0
    wire setup_half_unit_y_n1686 = setup_half_unit_y_n1685 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1687 = setup_half_unit_y_n1684; // u24f0
    wire [24:0] setup_half_unit_y_n1688 = {setup_half_unit_y_n1687, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1689 = setup_half_unit_y_n1688; // s25f0
    wire [25:0] setup_half_unit_y_n1690_term = {3'h0, setup_half_unit_x_n1311_s23} ^ {26{setup_half_unit_y_n1686}};
    wire signed [25:0] setup_half_unit_y_n1690 = {setup_half_unit_y_n1689[24], setup_half_unit_y_n1689} + setup_half_unit_y_n1690_term + {25'h0, setup_half_unit_y_n1686}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1691 = setup_half_unit_y_n1690[23:0]; // s24f0
    wire setup_half_unit_y_n1692 = setup_half_unit_y_n1691[23]; // u1f0
    wire setup_half_unit_y_n1693 = setup_half_unit_y_n1692 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1694 = setup_half_unit_y_n1691; // u24f0
    wire [24:0] setup_half_unit_y_n1695 = {setup_half_unit_y_n1694, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1696 = setup_half_unit_y_n1695; // s25f0
    wire [15:0] setup_half_unit_y_n1726 = {setup_half_unit_y_n1725_s23, setup_half_unit_y_n1686}; // u16f0
    wire [16:0] setup_half_unit_y_n1727 = {setup_half_unit_y_n1726, setup_half_unit_y_n1693}; // u17f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1897_term = {3'h0, setup_half_unit_x_n1311_s23} ^ {26{setup_half_unit_z_n1893_s23}};
    wire signed [25:0] setup_half_unit_z_n1897 = {setup_half_unit_z_n1896_s23[24], setup_half_unit_z_n1896_s23} + setup_half_unit_z_n1897_term + {25'h0, setup_half_unit_z_n1893_s23}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1898 = setup_half_unit_z_n1897[23:0]; // s24f0
    wire setup_half_unit_z_n1899 = setup_half_unit_z_n1898[23]; // u1f0
    wire setup_half_unit_z_n1900 = setup_half_unit_z_n1899 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1901 = setup_half_unit_z_n1898; // u24f0
    wire [24:0] setup_half_unit_z_n1902 = {setup_half_unit_z_n1901, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1903 = setup_half_unit_z_n1902; // s25f0
    wire [25:0] setup_half_unit_z_n1904_term = {3'h0, setup_half_unit_x_n1311_s23} ^ {26{setup_half_unit_z_n1900}};
    wire signed [25:0] setup_half_unit_z_n1904 = {setup_half_unit_z_n1903[24], setup_half_unit_z_n1903} + setup_half_unit_z_n1904_term + {25'h0, setup_half_unit_z_n1900}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1905 = setup_half_unit_z_n1904[23:0]; // s24f0
    wire setup_half_unit_z_n1906 = setup_half_unit_z_n1905[23]; // u1f0
    wire setup_half_unit_z_n1907 = setup_half_unit_z_n1906 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1908 = setup_half_unit_z_n1905; // u24f0
    wire [24:0] setup_half_unit_z_n1909 = {setup_half_unit_z_n1908, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1910 = setup_half_unit_z_n1909; // s25f0
    wire [15:0] setup_half_unit_z_n1940 = {setup_half_unit_z_n1939_s23, setup_half_unit_z_n1900}; // u16f0
    wire [16:0] setup_half_unit_z_n1941 = {setup_half_unit_z_n1940, setup_half_unit_z_n1907}; // u17f0

    reg [22:0] setup_light_unit_x_n344_s24; // u23f0
    reg setup_light_unit_x_n513_s24; // u1f0
    reg signed [24:0] setup_light_unit_x_n516_s24; // s25f0
    reg [16:0] setup_light_unit_x_n547_s24; // u17f0
    reg setup_light_unit_x_n553_s24; // u1f0
    reg setup_light_unit_x_n555_s24; // u1f0
    reg setup_light_unit_x_n557_s24; // u1f0
    reg setup_light_unit_y_n728_s24; // u1f0
    reg signed [24:0] setup_light_unit_y_n731_s24; // s25f0
    reg [16:0] setup_light_unit_y_n762_s24; // u17f0
    reg setup_light_unit_y_n767_s24; // u1f0
    reg setup_light_unit_y_n769_s24; // u1f0
    reg setup_light_unit_y_n771_s24; // u1f0
    reg setup_light_unit_z_n942_s24; // u1f0
    reg signed [24:0] setup_light_unit_z_n945_s24; // s25f0
    reg [16:0] setup_light_unit_z_n976_s24; // u17f0
    reg setup_light_unit_z_n981_s24; // u1f0
    reg setup_light_unit_z_n983_s24; // u1f0
    reg setup_light_unit_z_n985_s24; // u1f0
    reg [22:0] setup_half_unit_x_n1311_s24; // u23f0
    reg setup_half_unit_x_n1478_s24; // u1f0
    reg signed [24:0] setup_half_unit_x_n1481_s24; // s25f0
    reg [16:0] setup_half_unit_x_n1512_s24; // u17f0
    reg setup_half_unit_x_n1518_s24; // u1f0
    reg setup_half_unit_x_n1520_s24; // u1f0
    reg setup_half_unit_x_n1522_s24; // u1f0
    reg setup_half_unit_y_n1693_s24; // u1f0
    reg signed [24:0] setup_half_unit_y_n1696_s24; // s25f0
    reg [16:0] setup_half_unit_y_n1727_s24; // u17f0
    reg setup_half_unit_y_n1732_s24; // u1f0
    reg setup_half_unit_y_n1734_s24; // u1f0
    reg setup_half_unit_y_n1736_s24; // u1f0
    reg setup_half_unit_z_n1907_s24; // u1f0
    reg signed [24:0] setup_half_unit_z_n1910_s24; // s25f0
    reg [16:0] setup_half_unit_z_n1941_s24; // u17f0
    reg setup_half_unit_z_n1946_s24; // u1f0
    reg setup_half_unit_z_n1948_s24; // u1f0
    reg setup_half_unit_z_n1950_s24; // u1f0
    reg signed [1:-16] setup_bump_unit_x_x_s24; // s18f16
    reg signed [1:-16] setup_bump_unit_y_y_s24; // s18f16
    reg signed [1:-16] setup_bump_unit_z_z_s24; // s18f16
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n344_s24 <= setup_light_unit_x_n344_s23;
            setup_light_unit_x_n513_s24 <= setup_light_unit_x_n513;
            setup_light_unit_x_n516_s24 <= setup_light_unit_x_n516;
            setup_light_unit_x_n547_s24 <= setup_light_unit_x_n547;
            setup_light_unit_x_n553_s24 <= setup_light_unit_x_n553_s23;
            setup_light_unit_x_n555_s24 <= setup_light_unit_x_n555_s23;
            setup_light_unit_x_n557_s24 <= setup_light_unit_x_n557_s23;
            setup_light_unit_y_n728_s24 <= setup_light_unit_y_n728;
            setup_light_unit_y_n731_s24 <= setup_light_unit_y_n731;
            setup_light_unit_y_n762_s24 <= setup_light_unit_y_n762;
            setup_light_unit_y_n767_s24 <= setup_light_unit_y_n767_s23;
            setup_light_unit_y_n769_s24 <= setup_light_unit_y_n769_s23;
            setup_light_unit_y_n771_s24 <= setup_light_unit_y_n771_s23;
            setup_light_unit_z_n942_s24 <= setup_light_unit_z_n942;
            setup_light_unit_z_n945_s24 <= setup_light_unit_z_n945;
            setup_light_unit_z_n976_s24 <= setup_light_unit_z_n976;
            setup_light_unit_z_n981_s24 <= setup_light_unit_z_n981_s23;
            setup_light_unit_z_n983_s24 <= setup_light_unit_z_n983_s23;
            setup_light_unit_z_n985_s24 <= setup_light_unit_z_n985_s23;
            setup_half_unit_x_n1311_s24 <= setup_half_unit_x_n1311_s23;
            setup_half_unit_x_n1478_s24 <= setup_half_unit_x_n1478;
            setup_half_unit_x_n1481_s24 <= setup_half_unit_x_n1481;
            setup_half_unit_x_n1512_s24 <= setup_half_unit_x_n1512;
            setup_half_unit_x_n1518_s24 <= setup_half_unit_x_n1518_s23;
            setup_half_unit_x_n1520_s24 <= setup_half_unit_x_n1520_s23;
            setup_half_unit_x_n1522_s24 <= setup_half_unit_x_n1522_s23;
            setup_half_unit_y_n1693_s24 <= setup_half_unit_y_n1693;
            setup_half_unit_y_n1696_s24 <= setup_half_unit_y_n1696;
            setup_half_unit_y_n1727_s24 <= setup_half_unit_y_n1727;
            setup_half_unit_y_n1732_s24 <= setup_half_unit_y_n1732_s23;
            setup_half_unit_y_n1734_s24 <= setup_half_unit_y_n1734_s23;
            setup_half_unit_y_n1736_s24 <= setup_half_unit_y_n1736_s23;
            setup_half_unit_z_n1907_s24 <= setup_half_unit_z_n1907;
            setup_half_unit_z_n1910_s24 <= setup_half_unit_z_n1910;
            setup_half_unit_z_n1941_s24 <= setup_half_unit_z_n1941;
            setup_half_unit_z_n1946_s24 <= setup_half_unit_z_n1946_s23;
            setup_half_unit_z_n1948_s24 <= setup_half_unit_z_n1948_s23;
            setup_half_unit_z_n1950_s24 <= setup_half_unit_z_n1950_s23;
            setup_bump_unit_x_x_s24 <= setup_bump_unit_x_x_s23;
            setup_bump_unit_y_y_s24 <= setup_bump_unit_y_y_s23;
            setup_bump_unit_z_z_s24 <= setup_bump_unit_z_z_s23;
        end
    reg valid_s24;
    always @(posedge clk)
        if (rst) valid_s24 <= 1'b0;
        else if (ce) valid_s24 <= valid_s23;

    // ---- stage 24 ----
    // setup.light.unit_x
    wire [25:0] setup_light_unit_x_n517_term = {3'h0, setup_light_unit_x_n344_s24} ^ {26{setup_light_unit_x_n513_s24}};
    wire signed [25:0] setup_light_unit_x_n517 = {setup_light_unit_x_n516_s24[24], setup_light_unit_x_n516_s24} + setup_light_unit_x_n517_term + {25'h0, setup_light_unit_x_n513_s24}; // s26f0
    wire signed [23:0] setup_light_unit_x_n518 = setup_light_unit_x_n517[23:0]; // s24f0
    wire setup_light_unit_x_n519 = setup_light_unit_x_n518[23]; // u1f0
    wire setup_light_unit_x_n520 = setup_light_unit_x_n519 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_x_n521 = setup_light_unit_x_n518; // u24f0
    wire [24:0] setup_light_unit_x_n522 = {setup_light_unit_x_n521, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_x_n523 = setup_light_unit_x_n522; // s25f0
    wire [25:0] setup_light_unit_x_n524_term = {3'h0, setup_light_unit_x_n344_s24} ^ {26{setup_light_unit_x_n520}};
    wire signed [25:0] setup_light_unit_x_n524 = {setup_light_unit_x_n523[24], setup_light_unit_x_n523} + setup_light_unit_x_n524_term + {25'h0, setup_light_unit_x_n520}; // s26f0
    wire signed [23:0] setup_light_unit_x_n525 = setup_light_unit_x_n524[23:0]; // s24f0
    wire setup_light_unit_x_n526 = setup_light_unit_x_n525[23]; // u1f0
    wire setup_light_unit_x_n527 = setup_light_unit_x_n526 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_light_unit_x_n528 = {setup_light_unit_x_n525[23], setup_light_unit_x_n525} + {2'h0, setup_light_unit_x_n344_s24}; // s25f0
    wire [17:0] setup_light_unit_x_n548 = {setup_light_unit_x_n547_s24, setup_light_unit_x_n520}; // u18f0
    wire [18:0] setup_light_unit_x_n549 = {setup_light_unit_x_n548, setup_light_unit_x_n527}; // u19f0
    // setup.light.unit_y
    wire [25:0] setup_light_unit_y_n732_term = {3'h0, setup_light_unit_x_n344_s24} ^ {26{setup_light_unit_y_n728_s24}};
    wire signed [25:0] setup_light_unit_y_n732 = {setup_light_unit_y_n731_s24[24], setup_light_unit_y_n731_s24} + setup_light_unit_y_n732_term + {25'h0, setup_light_unit_y_n728_s24}; // s26f0
    wire signed [23:0] setup_light_unit_y_n733 = setup_light_unit_y_n732[23:0]; // s24f0
    wire setup_light_unit_y_n734 = setup_light_unit_y_n733[23]; // u1f0
    wire setup_light_unit_y_n735 = setup_light_unit_y_n734 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_y_n736 = setup_light_unit_y_n733; // u24f0
    wire [24:0] setup_light_unit_y_n737 = {setup_light_unit_y_n736, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_y_n738 = setup_light_unit_y_n737; // s25f0
    wire [25:0] setup_light_unit_y_n739_term = {3'h0, setup_light_unit_x_n344_s24} ^ {26{setup_light_unit_y_n735}};
    wire signed [25:0] setup_light_unit_y_n739 = {setup_light_unit_y_n738[24], setup_light_unit_y_n738} + setup_light_unit_y_n739_term + {25'h0, setup_light_unit_y_n735}; // s26f0
    wire signed [23:0] setup_light_unit_y_n740 = setup_light_unit_y_n739[23:0]; // s24f0
    wire setup_light_unit_y_n741 = setup_light_unit_y_n740[23]; // u1f0
    wire setup_light_unit_y_n742 = setup_light_unit_y_n741 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_light_unit_y_n743 = {setup_light_unit_y_n740[23], setup_light_unit_y_n740} + {2'h0, setup_light_unit_x_n344_s24}; // s25f0
    wire [17:0] setup_light_unit_y_n763 = {setup_light_unit_y_n762_s24, setup_light_unit_y_n735}; // u18f0
    wire [18:0] setup_light_unit_y_n764 = {setup_light_unit_y_n763, setup_light_unit_y_n742}; // u19f0
    // setup.light.unit_z
    wire [25:0] setup_light_unit_z_n946_term = {3'h0, setup_light_unit_x_n344_s24} ^ {26{setup_light_unit_z_n942_s24}};
    wire signed [25:0] setup_light_unit_z_n946 = {setup_light_unit_z_n945_s24[24], setup_light_unit_z_n945_s24} + setup_light_unit_z_n946_term + {25'h0, setup_light_unit_z_n942_s24}; // s26f0
    wire signed [23:0] setup_light_unit_z_n947 = setup_light_unit_z_n946[23:0]; // s24f0
    wire setup_light_unit_z_n948 = setup_light_unit_z_n947[23]; // u1f0
    wire setup_light_unit_z_n949 = setup_light_unit_z_n948 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_light_unit_z_n950 = setup_light_unit_z_n947; // u24f0
    wire [24:0] setup_light_unit_z_n951 = {setup_light_unit_z_n950, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_light_unit_z_n952 = setup_light_unit_z_n951; // s25f0
    wire [25:0] setup_light_unit_z_n953_term = {3'h0, setup_light_unit_x_n344_s24} ^ {26{setup_light_unit_z_n949}};
    wire signed [25:0] setup_light_unit_z_n953 = {setup_light_unit_z_n952[24], setup_light_unit_z_n952} + setup_light_unit_z_n953_term + {25'h0, setup_light_unit_z_n949}; // s26f0
    wire signed [23:0] setup_light_unit_z_n954 = setup_light_unit_z_n953[23:0]; // s24f0
    wire setup_light_unit_z_n955 = setup_light_unit_z_n954[23]; // u1f0
    wire setup_light_unit_z_n956 = setup_light_unit_z_n955 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_light_unit_z_n957 = {setup_light_unit_z_n954[23], setup_light_unit_z_n954} + {2'h0, setup_light_unit_x_n344_s24}; // s25f0
    wire [17:0] setup_light_unit_z_n977 = {setup_light_unit_z_n976_s24, setup_light_unit_z_n949}; // u18f0
    wire [18:0] setup_light_unit_z_n978 = {setup_light_unit_z_n977, setup_light_unit_z_n956}; // u19f0
    // setup.half.unit_x
    wire [25:0] setup_half_unit_x_n1482_term = {3'h0, setup_half_unit_x_n1311_s24} ^ {26{setup_half_unit_x_n1478_s24}};
    wire signed [25:0] setup_half_unit_x_n1482 = {setup_half_unit_x_n1481_s24[24], setup_half_unit_x_n1481_s24} + setup_half_unit_x_n1482_term + {25'h0, setup_half_unit_x_n1478_s24}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1483 = setup_half_unit_x_n1482[23:0]; // s24f0
    wire setup_half_unit_x_n1484 = setup_half_unit_x_n1483[23]; // u1f0
    wire setup_half_unit_x_n1485 = setup_half_unit_x_n1484 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_x_n1486 = setup_half_unit_x_n1483; // u24f0
    wire [24:0] setup_half_unit_x_n1487 = {setup_half_unit_x_n1486, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_x_n1488 = setup_half_unit_x_n1487; // s25f0
    wire [25:0] setup_half_unit_x_n1489_term = {3'h0, setup_half_unit_x_n1311_s24} ^ {26{setup_half_unit_x_n1485}};
    wire signed [25:0] setup_half_unit_x_n1489 = {setup_half_unit_x_n1488[24], setup_half_unit_x_n1488} + setup_half_unit_x_n1489_term + {25'h0, setup_half_unit_x_n1485}; // s26f0
    wire signed [23:0] setup_half_unit_x_n1490 = setup_half_unit_x_n1489[23:0]; // s24f0
    wire setup_half_unit_x_n1491 = setup_half_unit_x_n1490[23]; // u1f0
    wire setup_half_unit_x_n1492 = setup_half_unit_x_n1491 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_half_unit_x_n1493 = {setup_half_unit_x_n1490[23], setup_half_unit_x_n1490} + {2'h0, setup_half_unit_x_n1311_s24}; // s25f0
    wire [17:0] setup_half_unit_x_n1513 = {setup_half_unit_x_n1512_s24, setup_half_unit_x_n1485}; // u18f0
    wire [18:0] setup_half_unit_x_n1514 = {setup_half_unit_x_n1513, setup_half_unit_x_n1492}; // u19f0
    // setup.half.unit_y
    wire [25:0] setup_half_unit_y_n1697_term = {3'h0, setup_half_unit_x_n1311_s24} ^ {26{setup_half_unit_y_n1693_s24}};
    wire signed [25:0] setup_half_unit_y_n1697 = {setup_half_unit_y_n1696_s24[24], setup_half_unit_y_n1696_s24} + setup_half_unit_y_n1697_term + {25'h0, setup_half_unit_y_n1693_s24}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1698 = setup_half_unit_y_n1697[23:0]; // s24f0
    wire setup_half_unit_y_n1699 = setup_half_unit_y_n1698[23]; // u1f0
    wire setup_half_unit_y_n1700 = setup_half_unit_y_n1699 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_y_n1701 = setup_half_unit_y_n1698; // u24f0
    wire [24:0] setup_half_unit_y_n1702 = {setup_half_unit_y_n1701, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_y_n1703 = setup_half_unit_y_n1702; // s25f0
    wire [25:0] setup_half_unit_y_n1704_term = {3'h0, setup_half_unit_x_n1311_s24} ^ {26{setup_half_unit_y_n1700}};
    wire signed [25:0] setup_half_unit_y_n1704 = {setup_half_unit_y_n1703[24], setup_half_unit_y_n1703} + setup_half_unit_y_n1704_term + {25'h0, setup_half_unit_y_n1700}; // s26f0
    wire signed [23:0] setup_half_unit_y_n1705 = setup_half_unit_y_n1704[23:0]; // s24f0
    wire setup_half_unit_y_n1706 = setup_half_unit_y_n1705[23]; // u1f0
    wire setup_half_unit_y_n1707 = setup_half_unit_y_n1706 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_half_unit_y_n1708 = {setup_half_unit_y_n1705[23], setup_half_unit_y_n1705} + {2'h0, setup_half_unit_x_n1311_s24}; // s25f0
    wire [17:0] setup_half_unit_y_n1728 = {setup_half_unit_y_n1727_s24, setup_half_unit_y_n1700}; // u18f0
    wire [18:0] setup_half_unit_y_n1729 = {setup_half_unit_y_n1728, setup_half_unit_y_n1707}; // u19f0
    // setup.half.unit_z
    wire [25:0] setup_half_unit_z_n1911_term = {3'h0, setup_half_unit_x_n1311_s24} ^ {26{setup_half_unit_z_n1907_s24}};
    wire signed [25:0] setup_half_unit_z_n1911 = {setup_half_unit_z_n1910_s24[24], setup_half_unit_z_n1910_s24} + setup_half_unit_z_n1911_term + {25'h0, setup_half_unit_z_n1907_s24}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1912 = setup_half_unit_z_n1911[23:0]; // s24f0
    wire setup_half_unit_z_n1913 = setup_half_unit_z_n1912[23]; // u1f0
    wire setup_half_unit_z_n1914 = setup_half_unit_z_n1913 ^ setup_light_length_n42; // u1f0
    wire [23:0] setup_half_unit_z_n1915 = setup_half_unit_z_n1912; // u24f0
    wire [24:0] setup_half_unit_z_n1916 = {setup_half_unit_z_n1915, setup_light_length_n43}; // u25f0
    wire signed [24:0] setup_half_unit_z_n1917 = setup_half_unit_z_n1916; // s25f0
    wire [25:0] setup_half_unit_z_n1918_term = {3'h0, setup_half_unit_x_n1311_s24} ^ {26{setup_half_unit_z_n1914}};
    wire signed [25:0] setup_half_unit_z_n1918 = {setup_half_unit_z_n1917[24], setup_half_unit_z_n1917} + setup_half_unit_z_n1918_term + {25'h0, setup_half_unit_z_n1914}; // s26f0
    wire signed [23:0] setup_half_unit_z_n1919 = setup_half_unit_z_n1918[23:0]; // s24f0
    wire setup_half_unit_z_n1920 = setup_half_unit_z_n1919[23]; // u1f0
    wire setup_half_unit_z_n1921 = setup_half_unit_z_n1920 ^ setup_light_length_n42; // u1f0
    wire signed [24:0] setup_half_unit_z_n1922 = {setup_half_unit_z_n1919[23], setup_half_unit_z_n1919} + {2'h0, setup_half_unit_x_n1311_s24}; // s25f0
    wire [17:0] setup_half_unit_z_n1942 = {setup_half_unit_z_n1941_s24, setup_half_unit_z_n1914}; // u18f0
    wire [18:0] setup_half_unit_z_n1943 = {setup_half_unit_z_n1942, setup_half_unit_z_n1921}; // u19f0

    reg signed [23:0] setup_light_unit_x_n525_s25; // s24f0
    reg setup_light_unit_x_n526_s25; // u1f0
    reg signed [24:0] setup_light_unit_x_n528_s25; // s25f0
    reg [18:0] setup_light_unit_x_n549_s25; // u19f0
    reg setup_light_unit_x_n553_s25; // u1f0
    reg setup_light_unit_x_n555_s25; // u1f0
    reg setup_light_unit_x_n557_s25; // u1f0
    reg signed [23:0] setup_light_unit_y_n740_s25; // s24f0
    reg setup_light_unit_y_n741_s25; // u1f0
    reg signed [24:0] setup_light_unit_y_n743_s25; // s25f0
    reg [18:0] setup_light_unit_y_n764_s25; // u19f0
    reg setup_light_unit_y_n767_s25; // u1f0
    reg setup_light_unit_y_n769_s25; // u1f0
    reg setup_light_unit_y_n771_s25; // u1f0
    reg signed [23:0] setup_light_unit_z_n954_s25; // s24f0
    reg setup_light_unit_z_n955_s25; // u1f0
    reg signed [24:0] setup_light_unit_z_n957_s25; // s25f0
    reg [18:0] setup_light_unit_z_n978_s25; // u19f0
    reg setup_light_unit_z_n981_s25; // u1f0
    reg setup_light_unit_z_n983_s25; // u1f0
    reg setup_light_unit_z_n985_s25; // u1f0
    reg signed [23:0] setup_half_unit_x_n1490_s25; // s24f0
    reg setup_half_unit_x_n1491_s25; // u1f0
    reg signed [24:0] setup_half_unit_x_n1493_s25; // s25f0
    reg [18:0] setup_half_unit_x_n1514_s25; // u19f0
    reg setup_half_unit_x_n1518_s25; // u1f0
    reg setup_half_unit_x_n1520_s25; // u1f0
    reg setup_half_unit_x_n1522_s25; // u1f0
    reg signed [23:0] setup_half_unit_y_n1705_s25; // s24f0
    reg setup_half_unit_y_n1706_s25; // u1f0
    reg signed [24:0] setup_half_unit_y_n1708_s25; // s25f0
    reg [18:0] setup_half_unit_y_n1729_s25; // u19f0
    reg setup_half_unit_y_n1732_s25; // u1f0
    reg setup_half_unit_y_n1734_s25; // u1f0
    reg setup_half_unit_y_n1736_s25; // u1f0
    reg signed [23:0] setup_half_unit_z_n1919_s25; // s24f0
    reg setup_half_unit_z_n1920_s25; // u1f0
    reg signed [24:0] setup_half_unit_z_n1922_s25; // s25f0
    reg [18:0] setup_half_unit_z_n1943_s25; // u19f0
    reg setup_half_unit_z_n1946_s25; // u1f0
    reg setup_half_unit_z_n1948_s25; // u1f0
    reg setup_half_unit_z_n1950_s25; // u1f0
    reg signed [1:-16] setup_bump_unit_x_x_s25; // s18f16
    reg signed [1:-16] setup_bump_unit_y_y_s25; // s18f16
    reg signed [1:-16] setup_bump_unit_z_z_s25; // s18f16
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n525_s25 <= setup_light_unit_x_n525;
            setup_light_unit_x_n526_s25 <= setup_light_unit_x_n526;
            setup_light_unit_x_n528_s25 <= setup_light_unit_x_n528;
            setup_light_unit_x_n549_s25 <= setup_light_unit_x_n549;
            setup_light_unit_x_n553_s25 <= setup_light_unit_x_n553_s24;
            setup_light_unit_x_n555_s25 <= setup_light_unit_x_n555_s24;
            setup_light_unit_x_n557_s25 <= setup_light_unit_x_n557_s24;
            setup_light_unit_y_n740_s25 <= setup_light_unit_y_n740;
            setup_light_unit_y_n741_s25 <= setup_light_unit_y_n741;
            setup_light_unit_y_n743_s25 <= setup_light_unit_y_n743;
            setup_light_unit_y_n764_s25 <= setup_light_unit_y_n764;
            setup_light_unit_y_n767_s25 <= setup_light_unit_y_n767_s24;
            setup_light_unit_y_n769_s25 <= setup_light_unit_y_n769_s24;
            setup_light_unit_y_n771_s25 <= setup_light_unit_y_n771_s24;
            setup_light_unit_z_n954_s25 <= setup_light_unit_z_n954;
            setup_light_unit_z_n955_s25 <= setup_light_unit_z_n955;
            setup_light_unit_z_n957_s25 <= setup_light_unit_z_n957;
            setup_light_unit_z_n978_s25 <= setup_light_unit_z_n978;
            setup_light_unit_z_n981_s25 <= setup_light_unit_z_n981_s24;
            setup_light_unit_z_n983_s25 <= setup_light_unit_z_n983_s24;
            setup_light_unit_z_n985_s25 <= setup_light_unit_z_n985_s24;
            setup_half_unit_x_n1490_s25 <= setup_half_unit_x_n1490;
            setup_half_unit_x_n1491_s25 <= setup_half_unit_x_n1491;
            setup_half_unit_x_n1493_s25 <= setup_half_unit_x_n1493;
            setup_half_unit_x_n1514_s25 <= setup_half_unit_x_n1514;
            setup_half_unit_x_n1518_s25 <= setup_half_unit_x_n1518_s24;
            setup_half_unit_x_n1520_s25 <= setup_half_unit_x_n1520_s24;
            setup_half_unit_x_n1522_s25 <= setup_half_unit_x_n1522_s24;
            setup_half_unit_y_n1705_s25 <= setup_half_unit_y_n1705;
            setup_half_unit_y_n1706_s25 <= setup_half_unit_y_n1706;
            setup_half_unit_y_n1708_s25 <= setup_half_unit_y_n1708;
            setup_half_unit_y_n1729_s25 <= setup_half_unit_y_n1729;
            setup_half_unit_y_n1732_s25 <= setup_half_unit_y_n1732_s24;
            setup_half_unit_y_n1734_s25 <= setup_half_unit_y_n1734_s24;
            setup_half_unit_y_n1736_s25 <= setup_half_unit_y_n1736_s24;
            setup_half_unit_z_n1919_s25 <= setup_half_unit_z_n1919;
            setup_half_unit_z_n1920_s25 <= setup_half_unit_z_n1920;
            setup_half_unit_z_n1922_s25 <= setup_half_unit_z_n1922;
            setup_half_unit_z_n1943_s25 <= setup_half_unit_z_n1943;
            setup_half_unit_z_n1946_s25 <= setup_half_unit_z_n1946_s24;
            setup_half_unit_z_n1948_s25 <= setup_half_unit_z_n1948_s24;
            setup_half_unit_z_n1950_s25 <= setup_half_unit_z_n1950_s24;
            setup_bump_unit_x_x_s25 <= setup_bump_unit_x_x_s24;
            setup_bump_unit_y_y_s25 <= setup_bump_unit_y_y_s24;
            setup_bump_unit_z_z_s25 <= setup_bump_unit_z_z_s24;
        end
    reg valid_s25;
    always @(posedge clk)
        if (rst) valid_s25 <= 1'b0;
        else if (ce) valid_s25 <= valid_s24;

    // ---- stage 25 ----
    // setup.light.unit_x
    wire signed [24:0] setup_light_unit_x_n529 = setup_light_unit_x_n526_s25 ? setup_light_unit_x_n528_s25 : {setup_light_unit_x_n525_s25[23], setup_light_unit_x_n525_s25}; // s25f0
    wire setup_light_unit_x_n530 = setup_light_unit_x_n529 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_light_unit_x_n531 = setup_light_unit_x_n530 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_light_unit_x_n550 = {setup_light_unit_x_n549_s25, setup_light_unit_x_n531}; // u20f0
    wire [1:-18] setup_light_unit_x_n551 = setup_light_unit_x_n550; // u20f18
    wire [1:-18] setup_light_unit_x_n554 = setup_light_unit_x_n553_s25 ? {setup_light_unit_x_n343, 19'h0} : setup_light_unit_x_n551; // u20f18
    wire [1:-18] setup_light_unit_x_n556 = setup_light_unit_x_n555_s25 ? {1'b0, setup_light_length_n43, 18'h0} : setup_light_unit_x_n554; // u20f18
    wire signed [2:-18] setup_light_unit_x_n558 = -{1'b0, setup_light_unit_x_n556}; // s21f18
    // setup.light.unit_y
    wire signed [24:0] setup_light_unit_y_n744 = setup_light_unit_y_n741_s25 ? setup_light_unit_y_n743_s25 : {setup_light_unit_y_n740_s25[23], setup_light_unit_y_n740_s25}; // s25f0
    wire setup_light_unit_y_n745 = setup_light_unit_y_n744 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_light_unit_y_n746 = setup_light_unit_y_n745 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_light_unit_y_n765 = {setup_light_unit_y_n764_s25, setup_light_unit_y_n746}; // u20f0
    wire [1:-18] setup_light_unit_y_n766 = setup_light_unit_y_n765; // u20f18
    wire [1:-18] setup_light_unit_y_n768 = setup_light_unit_y_n767_s25 ? {setup_light_unit_x_n343, 19'h0} : setup_light_unit_y_n766; // u20f18
    wire [1:-18] setup_light_unit_y_n770 = setup_light_unit_y_n769_s25 ? {1'b0, setup_light_length_n43, 18'h0} : setup_light_unit_y_n768; // u20f18
    wire signed [2:-18] setup_light_unit_y_n772 = -{1'b0, setup_light_unit_y_n770}; // s21f18
    // setup.light.unit_z
    wire signed [24:0] setup_light_unit_z_n958 = setup_light_unit_z_n955_s25 ? setup_light_unit_z_n957_s25 : {setup_light_unit_z_n954_s25[23], setup_light_unit_z_n954_s25}; // s25f0
    wire setup_light_unit_z_n959 = setup_light_unit_z_n958 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_light_unit_z_n960 = setup_light_unit_z_n959 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_light_unit_z_n979 = {setup_light_unit_z_n978_s25, setup_light_unit_z_n960}; // u20f0
    wire [1:-18] setup_light_unit_z_n980 = setup_light_unit_z_n979; // u20f18
    wire [1:-18] setup_light_unit_z_n982 = setup_light_unit_z_n981_s25 ? {setup_light_unit_x_n343, 19'h0} : setup_light_unit_z_n980; // u20f18
    wire [1:-18] setup_light_unit_z_n984 = setup_light_unit_z_n983_s25 ? {1'b0, setup_light_length_n43, 18'h0} : setup_light_unit_z_n982; // u20f18
    wire signed [2:-18] setup_light_unit_z_n986 = -{1'b0, setup_light_unit_z_n984}; // s21f18
    // setup.half.unit_x
    wire signed [24:0] setup_half_unit_x_n1494 = setup_half_unit_x_n1491_s25 ? setup_half_unit_x_n1493_s25 : {setup_half_unit_x_n1490_s25[23], setup_half_unit_x_n1490_s25}; // s25f0
    wire setup_half_unit_x_n1495 = setup_half_unit_x_n1494 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_half_unit_x_n1496 = setup_half_unit_x_n1495 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_half_unit_x_n1515 = {setup_half_unit_x_n1514_s25, setup_half_unit_x_n1496}; // u20f0
    wire [1:-18] setup_half_unit_x_n1516 = setup_half_unit_x_n1515; // u20f18
    wire [1:-18] setup_half_unit_x_n1519 = setup_half_unit_x_n1518_s25 ? {setup_light_unit_x_n343, 19'h0} : setup_half_unit_x_n1516; // u20f18
    wire [1:-18] setup_half_unit_x_n1521 = setup_half_unit_x_n1520_s25 ? {1'b0, setup_light_length_n43, 18'h0} : setup_half_unit_x_n1519; // u20f18
    wire signed [2:-18] setup_half_unit_x_n1523 = -{1'b0, setup_half_unit_x_n1521}; // s21f18
    // setup.half.unit_y
    wire signed [24:0] setup_half_unit_y_n1709 = setup_half_unit_y_n1706_s25 ? setup_half_unit_y_n1708_s25 : {setup_half_unit_y_n1705_s25[23], setup_half_unit_y_n1705_s25}; // s25f0
    wire setup_half_unit_y_n1710 = setup_half_unit_y_n1709 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_half_unit_y_n1711 = setup_half_unit_y_n1710 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_half_unit_y_n1730 = {setup_half_unit_y_n1729_s25, setup_half_unit_y_n1711}; // u20f0
    wire [1:-18] setup_half_unit_y_n1731 = setup_half_unit_y_n1730; // u20f18
    wire [1:-18] setup_half_unit_y_n1733 = setup_half_unit_y_n1732_s25 ? {setup_light_unit_x_n343, 19'h0} : setup_half_unit_y_n1731; // u20f18
    wire [1:-18] setup_half_unit_y_n1735 = setup_half_unit_y_n1734_s25 ? {1'b0, setup_light_length_n43, 18'h0} : setup_half_unit_y_n1733; // u20f18
    wire signed [2:-18] setup_half_unit_y_n1737 = -{1'b0, setup_half_unit_y_n1735}; // s21f18
    // setup.half.unit_z
    wire signed [24:0] setup_half_unit_z_n1923 = setup_half_unit_z_n1920_s25 ? setup_half_unit_z_n1922_s25 : {setup_half_unit_z_n1919_s25[23], setup_half_unit_z_n1919_s25}; // s25f0
    wire setup_half_unit_z_n1924 = setup_half_unit_z_n1923 == {24'h0, setup_light_length_n43}; // u1f0
    wire setup_half_unit_z_n1925 = setup_half_unit_z_n1924 ^ setup_light_length_n42; // u1f0
    wire [19:0] setup_half_unit_z_n1944 = {setup_half_unit_z_n1943_s25, setup_half_unit_z_n1925}; // u20f0
    wire [1:-18] setup_half_unit_z_n1945 = setup_half_unit_z_n1944; // u20f18
    wire [1:-18] setup_half_unit_z_n1947 = setup_half_unit_z_n1946_s25 ? {setup_light_unit_x_n343, 19'h0} : setup_half_unit_z_n1945; // u20f18
    wire [1:-18] setup_half_unit_z_n1949 = setup_half_unit_z_n1948_s25 ? {1'b0, setup_light_length_n43, 18'h0} : setup_half_unit_z_n1947; // u20f18
    wire signed [2:-18] setup_half_unit_z_n1951 = -{1'b0, setup_half_unit_z_n1949}; // s21f18

    reg [1:-18] setup_light_unit_x_n556_s26; // u20f18
    reg setup_light_unit_x_n557_s26; // u1f0
    reg signed [2:-18] setup_light_unit_x_n558_s26; // s21f18
    reg [1:-18] setup_light_unit_y_n770_s26; // u20f18
    reg setup_light_unit_y_n771_s26; // u1f0
    reg signed [2:-18] setup_light_unit_y_n772_s26; // s21f18
    reg [1:-18] setup_light_unit_z_n984_s26; // u20f18
    reg setup_light_unit_z_n985_s26; // u1f0
    reg signed [2:-18] setup_light_unit_z_n986_s26; // s21f18
    reg [1:-18] setup_half_unit_x_n1521_s26; // u20f18
    reg setup_half_unit_x_n1522_s26; // u1f0
    reg signed [2:-18] setup_half_unit_x_n1523_s26; // s21f18
    reg [1:-18] setup_half_unit_y_n1735_s26; // u20f18
    reg setup_half_unit_y_n1736_s26; // u1f0
    reg signed [2:-18] setup_half_unit_y_n1737_s26; // s21f18
    reg [1:-18] setup_half_unit_z_n1949_s26; // u20f18
    reg setup_half_unit_z_n1950_s26; // u1f0
    reg signed [2:-18] setup_half_unit_z_n1951_s26; // s21f18
    reg signed [1:-16] setup_bump_unit_x_x_s26; // s18f16
    reg signed [1:-16] setup_bump_unit_y_y_s26; // s18f16
    reg signed [1:-16] setup_bump_unit_z_z_s26; // s18f16
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_n556_s26 <= setup_light_unit_x_n556;
            setup_light_unit_x_n557_s26 <= setup_light_unit_x_n557_s25;
            setup_light_unit_x_n558_s26 <= setup_light_unit_x_n558;
            setup_light_unit_y_n770_s26 <= setup_light_unit_y_n770;
            setup_light_unit_y_n771_s26 <= setup_light_unit_y_n771_s25;
            setup_light_unit_y_n772_s26 <= setup_light_unit_y_n772;
            setup_light_unit_z_n984_s26 <= setup_light_unit_z_n984;
            setup_light_unit_z_n985_s26 <= setup_light_unit_z_n985_s25;
            setup_light_unit_z_n986_s26 <= setup_light_unit_z_n986;
            setup_half_unit_x_n1521_s26 <= setup_half_unit_x_n1521;
            setup_half_unit_x_n1522_s26 <= setup_half_unit_x_n1522_s25;
            setup_half_unit_x_n1523_s26 <= setup_half_unit_x_n1523;
            setup_half_unit_y_n1735_s26 <= setup_half_unit_y_n1735;
            setup_half_unit_y_n1736_s26 <= setup_half_unit_y_n1736_s25;
            setup_half_unit_y_n1737_s26 <= setup_half_unit_y_n1737;
            setup_half_unit_z_n1949_s26 <= setup_half_unit_z_n1949;
            setup_half_unit_z_n1950_s26 <= setup_half_unit_z_n1950_s25;
            setup_half_unit_z_n1951_s26 <= setup_half_unit_z_n1951;
            setup_bump_unit_x_x_s26 <= setup_bump_unit_x_x_s25;
            setup_bump_unit_y_y_s26 <= setup_bump_unit_y_y_s25;
            setup_bump_unit_z_z_s26 <= setup_bump_unit_z_z_s25;
        end
    reg valid_s26;
    always @(posedge clk)
        if (rst) valid_s26 <= 1'b0;
        else if (ce) valid_s26 <= valid_s25;

    // ---- stage 26 ----
    // setup.light.unit_x
    wire signed [2:-18] setup_light_unit_x_n559 = setup_light_unit_x_n557_s26 ? setup_light_unit_x_n558_s26 : {1'b0, setup_light_unit_x_n556_s26}; // s21f18
    wire signed [3:-18] setup_light_unit_x_x_sum = {setup_light_unit_x_n559[2], setup_light_unit_x_n559} + 22'h2;
    wire signed [3:-16] setup_light_unit_x_x_cut = setup_light_unit_x_x_sum[3:-16];
    wire setup_light_unit_x_x_over = ~setup_light_unit_x_x_cut[3] & (|setup_light_unit_x_x_cut[2:1]);
    wire setup_light_unit_x_x_under = setup_light_unit_x_x_cut[3] & ~(&setup_light_unit_x_x_cut[2:1]);
    wire signed [1:-16] setup_light_unit_x_x = setup_light_unit_x_x_over ? 18'h1ffff : setup_light_unit_x_x_under ? 18'h20000 : setup_light_unit_x_x_cut[1:-16]; // s18f16
    // setup.light.unit_y
    wire signed [2:-18] setup_light_unit_y_n773 = setup_light_unit_y_n771_s26 ? setup_light_unit_y_n772_s26 : {1'b0, setup_light_unit_y_n770_s26}; // s21f18
    wire signed [3:-18] setup_light_unit_y_y_sum = {setup_light_unit_y_n773[2], setup_light_unit_y_n773} + 22'h2;
    wire signed [3:-16] setup_light_unit_y_y_cut = setup_light_unit_y_y_sum[3:-16];
    wire setup_light_unit_y_y_over = ~setup_light_unit_y_y_cut[3] & (|setup_light_unit_y_y_cut[2:1]);
    wire setup_light_unit_y_y_under = setup_light_unit_y_y_cut[3] & ~(&setup_light_unit_y_y_cut[2:1]);
    wire signed [1:-16] setup_light_unit_y_y = setup_light_unit_y_y_over ? 18'h1ffff : setup_light_unit_y_y_under ? 18'h20000 : setup_light_unit_y_y_cut[1:-16]; // s18f16
    // setup.light.unit_z
    wire signed [2:-18] setup_light_unit_z_n987 = setup_light_unit_z_n985_s26 ? setup_light_unit_z_n986_s26 : {1'b0, setup_light_unit_z_n984_s26}; // s21f18
    wire signed [3:-18] setup_light_unit_z_z_sum = {setup_light_unit_z_n987[2], setup_light_unit_z_n987} + 22'h2;
    wire signed [3:-16] setup_light_unit_z_z_cut = setup_light_unit_z_z_sum[3:-16];
    wire setup_light_unit_z_z_over = ~setup_light_unit_z_z_cut[3] & (|setup_light_unit_z_z_cut[2:1]);
    wire setup_light_unit_z_z_under = setup_light_unit_z_z_cut[3] & ~(&setup_light_unit_z_z_cut[2:1]);
    wire signed [1:-16] setup_light_unit_z_z = setup_light_unit_z_z_over ? 18'h1ffff : setup_light_unit_z_z_under ? 18'h20000 : setup_light_unit_z_z_cut[1:-16]; // s18f16
    // setup.half.unit_x
    wire signed [2:-18] setup_half_unit_x_n1524 = setup_half_unit_x_n1522_s26 ? setup_half_unit_x_n1523_s26 : {1'b0, setup_half_unit_x_n1521_s26}; // s21f18
    wire signed [3:-18] setup_half_unit_x_x_sum = {setup_half_unit_x_n1524[2], setup_half_unit_x_n1524} + 22'h2;
    wire signed [3:-16] setup_half_unit_x_x_cut = setup_half_unit_x_x_sum[3:-16];
    wire setup_half_unit_x_x_over = ~setup_half_unit_x_x_cut[3] & (|setup_half_unit_x_x_cut[2:1]);
    wire setup_half_unit_x_x_under = setup_half_unit_x_x_cut[3] & ~(&setup_half_unit_x_x_cut[2:1]);
    wire signed [1:-16] setup_half_unit_x_x = setup_half_unit_x_x_over ? 18'h1ffff : setup_half_unit_x_x_under ? 18'h20000 : setup_half_unit_x_x_cut[1:-16]; // s18f16
    // setup.half.unit_y
    wire signed [2:-18] setup_half_unit_y_n1738 = setup_half_unit_y_n1736_s26 ? setup_half_unit_y_n1737_s26 : {1'b0, setup_half_unit_y_n1735_s26}; // s21f18
    wire signed [3:-18] setup_half_unit_y_y_sum = {setup_half_unit_y_n1738[2], setup_half_unit_y_n1738} + 22'h2;
    wire signed [3:-16] setup_half_unit_y_y_cut = setup_half_unit_y_y_sum[3:-16];
    wire setup_half_unit_y_y_over = ~setup_half_unit_y_y_cut[3] & (|setup_half_unit_y_y_cut[2:1]);
    wire setup_half_unit_y_y_under = setup_half_unit_y_y_cut[3] & ~(&setup_half_unit_y_y_cut[2:1]);
    wire signed [1:-16] setup_half_unit_y_y = setup_half_unit_y_y_over ? 18'h1ffff : setup_half_unit_y_y_under ? 18'h20000 : setup_half_unit_y_y_cut[1:-16]; // s18f16
    // setup.half.unit_z
    wire signed [2:-18] setup_half_unit_z_n1952 = setup_half_unit_z_n1950_s26 ? setup_half_unit_z_n1951_s26 : {1'b0, setup_half_unit_z_n1949_s26}; // s21f18
    wire signed [3:-18] setup_half_unit_z_z_sum = {setup_half_unit_z_n1952[2], setup_half_unit_z_n1952} + 22'h2;
    wire signed [3:-16] setup_half_unit_z_z_cut = setup_half_unit_z_z_sum[3:-16];
    wire setup_half_unit_z_z_over = ~setup_half_unit_z_z_cut[3] & (|setup_half_unit_z_z_cut[2:1]);
    wire setup_half_unit_z_z_under = setup_half_unit_z_z_cut[3] & ~(&setup_half_unit_z_z_cut[2:1]);
    wire signed [1:-16] setup_half_unit_z_z = setup_half_unit_z_z_over ? 18'h1ffff : setup_half_unit_z_z_under ? 18'h20000 : setup_half_unit_z_z_cut[1:-16]; // s18f16

    reg signed [1:-16] setup_light_unit_x_x_s27; // s18f16
    reg signed [1:-16] setup_light_unit_y_y_s27; // s18f16
    reg signed [1:-16] setup_light_unit_z_z_s27; // s18f16
    reg signed [1:-16] setup_half_unit_x_x_s27; // s18f16
    reg signed [1:-16] setup_half_unit_y_y_s27; // s18f16
    reg signed [1:-16] setup_half_unit_z_z_s27; // s18f16
    reg signed [1:-16] setup_bump_unit_x_x_s27; // s18f16
    reg signed [1:-16] setup_bump_unit_y_y_s27; // s18f16
    reg signed [1:-16] setup_bump_unit_z_z_s27; // s18f16
    always @(posedge clk)
        if (ce) begin
            setup_light_unit_x_x_s27 <= setup_light_unit_x_x;
            setup_light_unit_y_y_s27 <= setup_light_unit_y_y;
            setup_light_unit_z_z_s27 <= setup_light_unit_z_z;
            setup_half_unit_x_x_s27 <= setup_half_unit_x_x;
            setup_half_unit_y_y_s27 <= setup_half_unit_y_y;
            setup_half_unit_z_z_s27 <= setup_half_unit_z_z;
            setup_bump_unit_x_x_s27 <= setup_bump_unit_x_x_s26;
            setup_bump_unit_y_y_s27 <= setup_bump_unit_y_y_s26;
            setup_bump_unit_z_z_s27 <= setup_bump_unit_z_z_s26;
        end
    reg valid_s27;
    always @(posedge clk)
        if (rst) valid_s27 <= 1'b0;
        else if (ce) valid_s27 <= valid_s26;

    // ---- stage 27 ----
    // dot_l
    wire signed [3:-32] dot_l_n2835 = setup_light_unit_x_x_s27 * setup_bump_unit_x_x_s27; // s36f32
    wire signed [3:-32] dot_l_n2836 = setup_light_unit_y_y_s27 * setup_bump_unit_y_y_s27; // s36f32
    wire signed [3:-32] dot_l_n2837 = setup_light_unit_z_z_s27 * setup_bump_unit_z_z_s27; // s36f32
    // dot_h
    wire signed [3:-32] dot_h_n2841 = setup_half_unit_x_x_s27 * setup_bump_unit_x_x_s27; // s36f32
    wire signed [3:-32] dot_h_n2842 = setup_half_unit_y_y_s27 * setup_bump_unit_y_y_s27; // s36f32
    wire signed [3:-32] dot_h_n2843 = setup_half_unit_z_z_s27 * setup_bump_unit_z_z_s27; // s36f32

    reg signed [3:-32] dot_l_n2835_s28; // s36f32
    reg signed [3:-32] dot_l_n2836_s28; // s36f32
    reg signed [3:-32] dot_l_n2837_s28; // s36f32
    reg signed [3:-32] dot_h_n2841_s28; // s36f32
    reg signed [3:-32] dot_h_n2842_s28; // s36f32
    reg signed [3:-32] dot_h_n2843_s28; // s36f32
    always @(posedge clk)
        if (ce) begin
            dot_l_n2835_s28 <= dot_l_n2835;
            dot_l_n2836_s28 <= dot_l_n2836;
            dot_l_n2837_s28 <= dot_l_n2837;
            dot_h_n2841_s28 <= dot_h_n2841;
            dot_h_n2842_s28 <= dot_h_n2842;
            dot_h_n2843_s28 <= dot_h_n2843;
        end
    reg valid_s28;
    always @(posedge clk)
        if (rst) valid_s28 <= 1'b0;
        else if (ce) valid_s28 <= valid_s27;

    // ---- stage 28 ----
    // dot_l
    wire signed [4:-32] dot_l_n2838 = {dot_l_n2835_s28[3], dot_l_n2835_s28} + {dot_l_n2836_s28[3], dot_l_n2836_s28}; // s37f32
    wire signed [5:-32] dot_l_n2839 = {dot_l_n2838[4], dot_l_n2838} + {{2{dot_l_n2837_s28[3]}}, dot_l_n2837_s28}; // s38f32
    // dot_h
    wire signed [4:-32] dot_h_n2844 = {dot_h_n2841_s28[3], dot_h_n2841_s28} + {dot_h_n2842_s28[3], dot_h_n2842_s28}; // s37f32
    wire signed [5:-32] dot_h_n2845 = {dot_h_n2844[4], dot_h_n2844} + {{2{dot_h_n2843_s28[3]}}, dot_h_n2843_s28}; // s38f32

    reg signed [5:-32] dot_l_n2839_s29; // s38f32
    reg signed [5:-32] dot_h_n2845_s29; // s38f32
    always @(posedge clk)
        if (ce) begin
            dot_l_n2839_s29 <= dot_l_n2839;
            dot_h_n2845_s29 <= dot_h_n2845;
        end
    reg valid_s29;
    always @(posedge clk)
        if (rst) valid_s29 <= 1'b0;
        else if (ce) valid_s29 <= valid_s28;

    // ---- stage 29 ----
    wire signed [6:-32] dot_l_sum = {dot_l_n2839_s29[5], dot_l_n2839_s29} + 39'h8000;
    wire signed [6:-16] dot_l_cut = dot_l_sum[6:-16];
    wire dot_l_over = ~dot_l_cut[6] & (|dot_l_cut[5:4]);
    wire dot_l_under = dot_l_cut[6] & ~(&dot_l_cut[5:4]);
    wire signed [4:-16] dot_l = dot_l_over ? 21'hfffff : dot_l_under ? 21'h100000 : dot_l_cut[4:-16]; // s21f16
    wire signed [6:-32] dot_h_sum = {dot_h_n2845_s29[5], dot_h_n2845_s29} + 39'h8000;
    wire signed [6:-16] dot_h_cut = dot_h_sum[6:-16];
    wire dot_h_over = ~dot_h_cut[6] & (|dot_h_cut[5:4]);
    wire dot_h_under = dot_h_cut[6] & ~(&dot_h_cut[5:4]);
    wire signed [4:-16] dot_h = dot_h_over ? 21'hfffff : dot_h_under ? 21'h100000 : dot_h_cut[4:-16]; // s21f16
    // diffuse
    wire diffuse_n2847 = dot_l[4]; // u1f0
    wire signed [4:-16] diffuse_n2848 = diffuse_n2847 ? {4'h0, setup_light_length_n43, 16'h0} : dot_l; // s21f16
    wire diffuse_n2849_over = ~diffuse_n2848[4] & (|diffuse_n2848[3:1]);
    wire diffuse_n2849_under = diffuse_n2848[4];
    wire [0:-16] diffuse_n2849 = diffuse_n2849_over ? 17'h1ffff : diffuse_n2849_under ? 17'h0 : diffuse_n2848[0:-16]; // u17f16
    wire diffuse_n2851 = diffuse_n2850 < diffuse_n2849; // u1f0
    wire [0:-16] diffuse_n2852 = diffuse_n2851 ? diffuse_n2850 : diffuse_n2849; // u17f16
    // (unit)
    wire n2858 = dot_h[4]; // u1f0
    wire signed [4:-16] n2859 = n2858 ? {4'h0, setup_light_length_n43, 16'h0} : dot_h; // s21f16
    wire specular_index_over = ~n2859[4] & (|n2859[3:1]);
    wire specular_index_under = n2859[4];
    wire [0:-16] specular_index = specular_index_over ? 17'h1ffff : specular_index_under ? 17'h0 : n2859[0:-16]; // u17f16
    wire n2861 = specular_index[0]; // u1f0
    wire [15:0] n2862 = specular_index[-1:-16]; // u16f0
    wire [-1:-16] n2863 = n2862; // u16f16
    // specular
    wire [9:0] specular_n2864 = n2863[-1:-10]; // u10f0

    reg [0:-16] diffuse_n2852_s30; // u17f16
    reg n2858_s30; // u1f0
    reg n2861_s30; // u1f0
    reg [15:0] specular_row;
    always @(posedge clk)
        if (ce) begin
            diffuse_n2852_s30 <= diffuse_n2852;
            n2858_s30 <= n2858;
            n2861_s30 <= n2861;
            specular_row <= specular_rom[specular_n2864];
        end
    reg valid_s30;
    always @(posedge clk)
        if (rst) valid_s30 <= 1'b0;
        else if (ce) valid_s30 <= valid_s29;

    // ---- stage 30 ----
    // diffuse
    wire [1:-32] diffuse_n2855 = diffuse_n2852_s30 * diffuse_n2853; // u34f32
    // specular
    wire [-1:-16] specular_n2865 = specular_row; // u16f16
    // (unit)
    wire [-1:-16] n2868 = n2861_s30 ? n2866 : specular_n2865; // u16f16
    wire [-1:-16] specular_next = n2858_s30 ? n2867 : n2868; // u16f16

    reg [1:-32] diffuse_n2855_s31; // u34f32
    reg [-1:-16] specular_next_s31; // u16f16
    always @(posedge clk)
        if (ce) begin
            diffuse_n2855_s31 <= diffuse_n2855;
            specular_next_s31 <= specular_next;
        end
    reg valid_s31;
    always @(posedge clk)
        if (rst) valid_s31 <= 1'b0;
        else if (ce) valid_s31 <= valid_s30;

    // ---- stage 31 ----
    // diffuse
    wire [2:-32] diffuse_n2856 = {1'b0, diffuse_n2855_s31} + {2'h0, diffuse_n2854, 16'h0}; // u35f32
    wire [3:-32] diffuse_diffuse_sum = {1'b0, diffuse_n2856} + 36'h8000;
    wire [3:-16] diffuse_diffuse_cut = diffuse_diffuse_sum[3:-16];
    wire diffuse_diffuse_over = |diffuse_diffuse_cut[3:0];
    wire [-1:-16] diffuse_diffuse = diffuse_diffuse_over ? 16'hffff : diffuse_diffuse_cut[-1:-16]; // u16f16
    // (unit)
    wire [0:-16] n2870 = {1'b0, diffuse_diffuse} + {1'b0, specular_next_s31}; // u17f16

    reg [-1:-16] diffuse_diffuse_s32; // u16f16
    reg [-1:-16] specular_next_s32; // u16f16
    reg [0:-16] n2870_s32; // u17f16
    always @(posedge clk)
        if (ce) begin
            diffuse_diffuse_s32 <= diffuse_diffuse;
            specular_next_s32 <= specular_next_s31;
            n2870_s32 <= n2870;
        end
    reg valid_s32;
    always @(posedge clk)
        if (rst) valid_s32 <= 1'b0;
        else if (ce) valid_s32 <= valid_s31;

    // ---- stage 32 ----
    wire intensity_next_over = |n2870_s32[0];
    wire [-1:-16] intensity_next = intensity_next_over ? 16'hffff : n2870_s32[-1:-16]; // u16f16

    always @(posedge clk)
        if (ce) begin
            diffuse <= diffuse_diffuse_s32;
            specular <= specular_next_s32;
            intensity <= intensity_next;
        end
    reg valid_s33;
    always @(posedge clk)
        if (rst) valid_s33 <= 1'b0;
        else if (ce) valid_s33 <= valid_s32;
    assign valid_out = valid_s33;

    // ---- stage 33 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        setup_bump_unit_x_n2254[40:23],
        setup_bump_unit_y_n2461[40:23],
        setup_bump_unit_z_n2667[40:23],
        setup_light_frame_x_sum[-19:-32],
        setup_light_frame_y_sum[-19:-32],
        setup_light_frame_z_sum[-19:-32],
        setup_light_unit_x_n389[43:23],
        setup_light_unit_y_n605[43:23],
        setup_light_unit_z_n819[43:23],
        setup_half_frame_x_sum[-19:-32],
        setup_half_frame_y_sum[-19:-32],
        setup_half_frame_z_sum[-19:-32],
        setup_half_unit_x_n1355[43:23],
        setup_half_unit_y_n1570[43:23],
        setup_half_unit_z_n1784[43:23],
        setup_bump_length_n1964[2],
        setup_bump_length_n1975[4:3],
        setup_bump_length_n1987[5:4],
        setup_bump_length_n1999[6:5],
        setup_bump_length_n2011[7:6],
        setup_bump_length_n2023[8:7],
        setup_bump_length_n2035[9:8],
        setup_bump_length_n2047[10:9],
        setup_bump_length_n2059[11:10],
        setup_bump_length_n2071[12:11],
        setup_light_length_n48[2],
        setup_light_length_n59[4:3],
        setup_light_length_n71[5:4],
        setup_half_length_n1017[2],
        setup_half_length_n1028[4:3],
        setup_half_length_n1040[5:4],
        setup_bump_length_n2083[13:12],
        setup_bump_length_n2095[14:13],
        setup_bump_length_n2107[15:14],
        setup_light_length_n83[6:5],
        setup_light_length_n95[7:6],
        setup_light_length_n107[8:7],
        setup_light_length_n119[9:8],
        setup_half_length_n1052[6:5],
        setup_half_length_n1064[7:6],
        setup_half_length_n1076[8:7],
        setup_half_length_n1088[9:8],
        setup_bump_length_n2119[16:15],
        setup_bump_length_n2131[17:16],
        setup_light_length_n131[10:9],
        setup_light_length_n143[11:10],
        setup_light_length_n155[12:11],
        setup_half_length_n1100[10:9],
        setup_half_length_n1112[11:10],
        setup_half_length_n1124[12:11],
        setup_bump_length_n2143[18:17],
        setup_bump_length_n2155[19:18],
        setup_bump_length_n2167[20:19],
        setup_light_length_n167[13:12],
        setup_light_length_n179[14:13],
        setup_light_length_n191[15:14],
        setup_half_length_n1136[13:12],
        setup_half_length_n1148[14:13],
        setup_half_length_n1160[15:14],
        setup_bump_length_n2179[21:20],
        setup_bump_length_n2188[22:21],
        setup_light_length_n203[16:15],
        setup_light_length_n215[17:16],
        setup_half_length_n1172[16:15],
        setup_half_length_n1184[17:16],
        setup_bump_length_n2197[23:22],
        setup_bump_length_n2206[24:23],
        setup_light_length_n227[18:17],
        setup_light_length_n239[19:18],
        setup_light_length_n251[20:19],
        setup_half_length_n1196[18:17],
        setup_half_length_n1208[19:18],
        setup_half_length_n1220[20:19],
        setup_bump_length_length_sum[-19:-20],
        setup_bump_unit_x_n2260[25:24],
        setup_bump_unit_y_n2467[25:24],
        setup_bump_unit_z_n2673[25:24],
        setup_light_length_n263[21:20],
        setup_light_length_n275[22:21],
        setup_half_length_n1232[21:20],
        setup_half_length_n1244[22:21],
        setup_bump_unit_x_n2267[25:24],
        setup_bump_unit_x_n2274[25:24],
        setup_bump_unit_y_n2474[25:24],
        setup_bump_unit_y_n2481[25:24],
        setup_bump_unit_z_n2680[25:24],
        setup_bump_unit_z_n2687[25:24],
        setup_light_length_n287[23:22],
        setup_light_length_n299[24:23],
        setup_half_length_n1256[23:22],
        setup_half_length_n1268[24:23],
        setup_bump_unit_x_n2281[25:24],
        setup_bump_unit_x_n2288[25:24],
        setup_bump_unit_y_n2488[25:24],
        setup_bump_unit_y_n2495[25:24],
        setup_bump_unit_z_n2694[25:24],
        setup_bump_unit_z_n2701[25:24],
        setup_light_length_n311[25:24],
        setup_light_length_n323[26:25],
        setup_half_length_n1280[25:24],
        setup_half_length_n1292[26:25],
        setup_bump_unit_x_n2295[25:24],
        setup_bump_unit_x_n2302[25:24],
        setup_bump_unit_y_n2502[25:24],
        setup_bump_unit_y_n2509[25:24],
        setup_bump_unit_z_n2708[25:24],
        setup_bump_unit_z_n2715[25:24],
        setup_light_length_n333[27:26],
        setup_half_length_n1301[27:26],
        setup_bump_unit_x_n2309[25:24],
        setup_bump_unit_x_n2316[25:24],
        setup_bump_unit_y_n2516[25:24],
        setup_bump_unit_y_n2523[25:24],
        setup_bump_unit_z_n2722[25:24],
        setup_bump_unit_z_n2729[25:24],
        setup_light_length_length_sum[-19:-20],
        setup_light_unit_x_n397[25:24],
        setup_light_unit_y_n612[25:24],
        setup_light_unit_z_n826[25:24],
        setup_half_length_length_sum[-19:-20],
        setup_half_unit_x_n1362[25:24],
        setup_half_unit_y_n1577[25:24],
        setup_half_unit_z_n1791[25:24],
        setup_bump_unit_x_n2323[25:24],
        setup_bump_unit_x_n2330[25:24],
        setup_bump_unit_y_n2530[25:24],
        setup_bump_unit_y_n2537[25:24],
        setup_bump_unit_z_n2736[25:24],
        setup_bump_unit_z_n2743[25:24],
        setup_light_unit_x_n405[25:24],
        setup_light_unit_x_n412[25:24],
        setup_light_unit_y_n620[25:24],
        setup_light_unit_y_n627[25:24],
        setup_light_unit_z_n834[25:24],
        setup_light_unit_z_n841[25:24],
        setup_half_unit_x_n1370[25:24],
        setup_half_unit_x_n1377[25:24],
        setup_half_unit_y_n1585[25:24],
        setup_half_unit_y_n1592[25:24],
        setup_half_unit_z_n1799[25:24],
        setup_half_unit_z_n1806[25:24],
        setup_bump_unit_x_n2337[25:24],
        setup_bump_unit_x_n2344[25:24],
        setup_bump_unit_y_n2544[25:24],
        setup_bump_unit_y_n2551[25:24],
        setup_bump_unit_z_n2750[25:24],
        setup_bump_unit_z_n2757[25:24],
        setup_light_unit_x_n419[25:24],
        setup_light_unit_x_n426[25:24],
        setup_light_unit_y_n634[25:24],
        setup_light_unit_y_n641[25:24],
        setup_light_unit_z_n848[25:24],
        setup_light_unit_z_n855[25:24],
        setup_half_unit_x_n1384[25:24],
        setup_half_unit_x_n1391[25:24],
        setup_half_unit_y_n1599[25:24],
        setup_half_unit_y_n1606[25:24],
        setup_half_unit_z_n1813[25:24],
        setup_half_unit_z_n1820[25:24],
        setup_bump_unit_x_n2351[25:24],
        setup_bump_unit_x_n2358[25:24],
        setup_bump_unit_y_n2558[25:24],
        setup_bump_unit_y_n2565[25:24],
        setup_bump_unit_z_n2764[25:24],
        setup_bump_unit_z_n2771[25:24],
        setup_light_unit_x_n433[25:24],
        setup_light_unit_x_n440[25:24],
        setup_light_unit_y_n648[25:24],
        setup_light_unit_y_n655[25:24],
        setup_light_unit_z_n862[25:24],
        setup_light_unit_z_n869[25:24],
        setup_half_unit_x_n1398[25:24],
        setup_half_unit_x_n1405[25:24],
        setup_half_unit_y_n1613[25:24],
        setup_half_unit_y_n1620[25:24],
        setup_half_unit_z_n1827[25:24],
        setup_half_unit_z_n1834[25:24],
        setup_bump_unit_x_n2365[25:24],
        setup_bump_unit_x_n2372[25:24],
        setup_bump_unit_y_n2572[25:24],
        setup_bump_unit_y_n2579[25:24],
        setup_bump_unit_z_n2778[25:24],
        setup_bump_unit_z_n2785[25:24],
        setup_light_unit_x_n447[25:24],
        setup_light_unit_x_n454[25:24],
        setup_light_unit_y_n662[25:24],
        setup_light_unit_y_n669[25:24],
        setup_light_unit_z_n876[25:24],
        setup_light_unit_z_n883[25:24],
        setup_half_unit_x_n1412[25:24],
        setup_half_unit_x_n1419[25:24],
        setup_half_unit_y_n1627[25:24],
        setup_half_unit_y_n1634[25:24],
        setup_half_unit_z_n1841[25:24],
        setup_half_unit_z_n1848[25:24],
        setup_bump_unit_x_n2379[25:24],
        setup_bump_unit_x_n2386[25:24],
        setup_bump_unit_y_n2586[25:24],
        setup_bump_unit_y_n2593[25:24],
        setup_bump_unit_z_n2792[25:24],
        setup_bump_unit_z_n2799[25:24],
        setup_light_unit_x_n461[25:24],
        setup_light_unit_x_n468[25:24],
        setup_light_unit_y_n676[25:24],
        setup_light_unit_y_n683[25:24],
        setup_light_unit_z_n890[25:24],
        setup_light_unit_z_n897[25:24],
        setup_half_unit_x_n1426[25:24],
        setup_half_unit_x_n1433[25:24],
        setup_half_unit_y_n1641[25:24],
        setup_half_unit_y_n1648[25:24],
        setup_half_unit_z_n1855[25:24],
        setup_half_unit_z_n1862[25:24],
        setup_light_unit_x_n475[25:24],
        setup_light_unit_x_n482[25:24],
        setup_light_unit_y_n690[25:24],
        setup_light_unit_y_n697[25:24],
        setup_light_unit_z_n904[25:24],
        setup_light_unit_z_n911[25:24],
        setup_half_unit_x_n1440[25:24],
        setup_half_unit_x_n1447[25:24],
        setup_half_unit_y_n1655[25:24],
        setup_half_unit_y_n1662[25:24],
        setup_half_unit_z_n1869[25:24],
        setup_half_unit_z_n1876[25:24],
        setup_bump_unit_x_x_sum[-17:-18],
        setup_bump_unit_y_y_sum[-17:-18],
        setup_bump_unit_z_z_sum[-17:-18],
        setup_light_unit_x_n489[25:24],
        setup_light_unit_x_n496[25:24],
        setup_light_unit_y_n704[25:24],
        setup_light_unit_y_n711[25:24],
        setup_light_unit_z_n918[25:24],
        setup_light_unit_z_n925[25:24],
        setup_half_unit_x_n1454[25:24],
        setup_half_unit_x_n1461[25:24],
        setup_half_unit_y_n1669[25:24],
        setup_half_unit_y_n1676[25:24],
        setup_half_unit_z_n1883[25:24],
        setup_half_unit_z_n1890[25:24],
        setup_light_unit_x_n503[25:24],
        setup_light_unit_x_n510[25:24],
        setup_light_unit_y_n718[25:24],
        setup_light_unit_y_n725[25:24],
        setup_light_unit_z_n932[25:24],
        setup_light_unit_z_n939[25:24],
        setup_half_unit_x_n1468[25:24],
        setup_half_unit_x_n1475[25:24],
        setup_half_unit_y_n1683[25:24],
        setup_half_unit_y_n1690[25:24],
        setup_half_unit_z_n1897[25:24],
        setup_half_unit_z_n1904[25:24],
        setup_light_unit_x_n517[25:24],
        setup_light_unit_x_n524[25:24],
        setup_light_unit_y_n732[25:24],
        setup_light_unit_y_n739[25:24],
        setup_light_unit_z_n946[25:24],
        setup_light_unit_z_n953[25:24],
        setup_half_unit_x_n1482[25:24],
        setup_half_unit_x_n1489[25:24],
        setup_half_unit_y_n1697[25:24],
        setup_half_unit_y_n1704[25:24],
        setup_half_unit_z_n1911[25:24],
        setup_half_unit_z_n1918[25:24],
        setup_light_unit_x_x_sum[-17:-18],
        setup_light_unit_y_y_sum[-17:-18],
        setup_light_unit_z_z_sum[-17:-18],
        setup_half_unit_x_x_sum[-17:-18],
        setup_half_unit_y_y_sum[-17:-18],
        setup_half_unit_z_z_sum[-17:-18],
        dot_l_sum[-17:-32],
        dot_h_sum[-17:-32],
        n2863[-11:-16],
        diffuse_diffuse_sum[-17:-32]};
endmodule
