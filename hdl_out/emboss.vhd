-- emboss: texture coordinates displaced by the direction of a light, for embossing
-- made by fixpath 0.1.0; US 6,980,218; US 7,307,640; GL_NV_texgen_emboss
--   setting=gx frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
--   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
--   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
--   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
--   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
--   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
--   rom=block
-- latency 14 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   ds_texels: mean 5.15e-4 texel, largest seen 4.51e-3 texel at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
--   ds_relative: mean 2.03e-6, largest seen 1.43e-5 over the vector's length times its factor, each at least 1/4, at m0_x=4132 m0_y=-131 m0_z=429 m1_x=133 m1_y=4154 m1_z=-11 m2_x=-428 m2_y=25 m2_z=4134 tangent_x=-10615 tangent_y=137 tangent_z=12480 binormal_x=-202 binormal_y=16379 binormal_z=-351 light_x=26912091 light_y=-19929090 light_z=-1678718 vertex_x=27451608 vertex_y=-19638454 vertex_z=-1458906 s0=-3142235 t0=-300807
--   ds: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
--   dt_texels: mean 5.17e-4 texel, largest seen 5.30e-3 texel at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
--   dt_relative: mean 2.03e-6, largest seen 1.55e-5 over the vector's length times its factor, each at least 1/4, at m0_x=1817 m0_y=-3955 m0_z=169 m1_x=460 m1_y=27 m1_z=-4332 m2_x=3932 m2_y=1825 m2_z=429 tangent_x=6988 tangent_y=-14240 tangent_z=4101 binormal_x=-170 binormal_y=4457 binormal_z=15765 light_x=-9167663 light_y=7142069 light_z=-10596957 vertex_x=-8884124 vertex_y=7444365 vertex_z=-9525055 s0=2333965 t0=3659718
--   dt: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
--   s1: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
--   t1: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at m0_x=4674 m0_y=5079 m0_z=-2162 m1_x=-3514 m1_y=4923 m1_z=3966 m2_x=-4257 m2_y=1512 m2_z=-5648 tangent_x=-2894 tangent_y=-19246 tangent_z=1152 binormal_x=-2531 binormal_y=7271 binormal_z=-13448 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897
-- stated bound on each relative displacement (relative to the vector's length times its factor, each at least 1/4): 5.21e-5
-- stated bound on each displacement: 1.15e-3
-- stated bound on each displacement in texels: 2.93e-1
-- stated bound on each coordinate: 1.15e-3
-- stated bound on each flag and what is passed: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity emboss is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        m0_x : in signed(15 downto 0); -- s16f13
        m0_y : in signed(15 downto 0); -- s16f13
        m0_z : in signed(15 downto 0); -- s16f13
        m1_x : in signed(15 downto 0); -- s16f13
        m1_y : in signed(15 downto 0); -- s16f13
        m1_z : in signed(15 downto 0); -- s16f13
        m2_x : in signed(15 downto 0); -- s16f13
        m2_y : in signed(15 downto 0); -- s16f13
        m2_z : in signed(15 downto 0); -- s16f13
        tangent_x : in signed(15 downto 0); -- s16f14
        tangent_y : in signed(15 downto 0); -- s16f14
        tangent_z : in signed(15 downto 0); -- s16f14
        binormal_x : in signed(15 downto 0); -- s16f14
        binormal_y : in signed(15 downto 0); -- s16f14
        binormal_z : in signed(15 downto 0); -- s16f14
        light_x : in signed(27 downto 0); -- s28f15
        light_y : in signed(27 downto 0); -- s28f15
        light_z : in signed(27 downto 0); -- s28f15
        vertex_x : in signed(27 downto 0); -- s28f15
        vertex_y : in signed(27 downto 0); -- s28f15
        vertex_z : in signed(27 downto 0); -- s28f15
        s0 : in signed(24 downto 0); -- s25f18
        t0 : in signed(24 downto 0); -- s25f18
        valid_out : out std_logic;
        ds : out signed(26 downto 0) := (others => '0'); -- s27f18
        dt : out signed(26 downto 0) := (others => '0'); -- s27f18
        s1 : out signed(24 downto 0) := (others => '0'); -- s25f18
        t1 : out signed(24 downto 0) := (others => '0'); -- s25f18
        degenerate : out unsigned(0 downto 0) := (others => '0') -- u1f0
    );
end entity;

architecture rtl of emboss is
    attribute rom_style : string;

    -- table recip_root: recip_sqrt_base u23f22, recip_sqrt_slope s16f33
    type recip_root_rom_rows is array (0 to 511) of unsigned(38 downto 0);
    constant recip_root_rom : recip_root_rom_rows := (
        39x"7fffe880bf", 39x"7f80a88237", 39x"7f02df83a9", 39x"7e86898513",
        39x"7e0b9c8677", 39x"7d921387d4", 39x"7d19e8892a", 39x"7ca3128a7a",
        39x"7c2d8d8bc4", 39x"7bb9528d08", 39x"7b465a8e47", 39x"7ad4a18f7f",
        39x"7a642090b2", 39x"79f4d391df", 39x"7986b29308", 39x"7919bb942b",
        39x"78ade69549", 39x"78432f9662", 39x"77d9929776", 39x"7771089886",
        39x"77098f9991", 39x"76a3209a98", 39x"763db89b9a", 39x"75d9539c98",
        39x"7575eb9d92", 39x"75137e9e88", 39x"74b2069f7a", 39x"745180a068",
        39x"73f1e8a152", 39x"73933aa239", 39x"733573a31b", 39x"72d88fa3fb",
        39x"727c8aa4d6", 39x"722160a5af", 39x"71c70fa684", 39x"716d93a756",
        39x"7114eaa824", 39x"70bd0ea8f0", 39x"7065fea9b9", 39x"700fb7aa7e",
        39x"6fba35ab41", 39x"6f6576ac00", 39x"6f1177acbd", 39x"6ebe34ad77",
        39x"6e6babae2f", 39x"6e19daaee4", 39x"6dc8beaf96", 39x"6d7854b046",
        39x"6d289ab0f3", 39x"6cd98db19e", 39x"6c8b2bb246", 39x"6c3d71b2ec",
        39x"6bf05db390", 39x"6ba3edb431", 39x"6b581eb4d1", 39x"6b0cefb56e",
        39x"6ac25db609", 39x"6a7866b6a2", 39x"6a2f08b738", 39x"69e640b7cd",
        39x"699e0eb860", 39x"69566eb8f1", 39x"690f5fb980", 39x"68c8e0ba0d",
        39x"6882edba99", 39x"683d86bb22", 39x"67f8a8bbaa", 39x"67b453bc30",
        39x"677083bcb4", 39x"672d37bd37", 39x"66ea6fbdb8", 39x"66a827be38",
        39x"66665fbeb5", 39x"662514bf32", 39x"65e446bfac", 39x"65a3f2c026",
        39x"656419c09d", 39x"6524b6c114", 39x"64e5c9c189", 39x"64a752c1fc",
        39x"64694fc26e", 39x"642bbdc2df", 39x"63ee9cc34e", 39x"63b1eac3bc",
        39x"6375a6c429", 39x"6339cfc495", 39x"62fe64c4ff", 39x"62c363c568",
        39x"6288cbc5d0", 39x"624e9bc636", 39x"6214d1c69c", 39x"61db6dc700",
        39x"61a26dc763", 39x"6169d0c7c5", 39x"613196c826", 39x"60f9bcc886",
        39x"60c242c8e5", 39x"608b26c943", 39x"605469c99f", 39x"601e08c9fb",
        39x"5fe803ca56", 39x"5fb259caaf", 39x"5f7d08cb08", 39x"5f4810cb60",
        39x"5f1370cbb7", 39x"5edf27cc0c", 39x"5eab34cc61", 39x"5e7795ccb6",
        39x"5e444acd09", 39x"5e1153cd5b", 39x"5ddeaecdad", 39x"5dac5bcdfd",
        39x"5d7a58ce4d", 39x"5d48a5ce9c", 39x"5d1741ceea", 39x"5ce62bcf37",
        39x"5cb562cf84", 39x"5c84e6cfd0", 39x"5c54b6d01b", 39x"5c24d0d065",
        39x"5bf536d0ae", 39x"5bc5e4d0f7", 39x"5b96dbd13f", 39x"5b681ad186",
        39x"5b39a0d1cd", 39x"5b0b6dd213", 39x"5add81d258", 39x"5aafd9d29d",
        39x"5a8275d2e1", 39x"5a5556d324", 39x"5a287ad366", 39x"59fbe1d3a8",
        39x"59cf89d3ea", 39x"59a373d42a", 39x"59779dd46a", 39x"594c07d4aa",
        39x"5920b1d4e9", 39x"58f59ad527", 39x"58cac1d565", 39x"58a025d5a2",
        39x"5875c7d5de", 39x"584ba6d61a", 39x"5821c0d656", 39x"57f815d691",
        39x"57cea6d6cb", 39x"57a571d705", 39x"577c76d73e", 39x"5753b4d777",
        39x"572b2ad7af", 39x"5702d9d7e7", 39x"56dac0d81e", 39x"56b2ded855",
        39x"568b33d88b", 39x"5663bed8c1", 39x"563c7fd8f6", 39x"561575d92b",
        39x"55eea0d95f", 39x"55c7ffd993", 39x"55a192d9c7", 39x"557b58d9fa",
        39x"555552da2c", 39x"552f7fda5e", 39x"5509ddda90", 39x"54e46ddac1",
        39x"54bf2edaf2", 39x"549a20db23", 39x"547543db53", 39x"545096db82",
        39x"542c18dbb1", 39x"5407c9dbe0", 39x"53e3a9dc0f", 39x"53bfb8dc3d",
        39x"539bf5dc6a", 39x"53785fdc98", 39x"5354f7dcc5", 39x"5331bcdcf1",
        39x"530eaddd1d", 39x"52ebcadd49", 39x"52c913dd75", 39x"52a688dda0",
        39x"528428ddca", 39x"5261f2ddf5", 39x"523fe7de1f", 39x"521e06de49",
        39x"51fc4fde72", 39x"51dac1de9b", 39x"51b95cdec4", 39x"519820deec",
        39x"51770cdf14", 39x"515621df3c", 39x"51355ddf64", 39x"5114c0df8b",
        39x"50f44bdfb2", 39x"50d3fddfd8", 39x"50b3d5dffe", 39x"5093d4e024",
        39x"5073f8e04a", 39x"505442e06f", 39x"5034b1e095", 39x"501546e0b9",
        39x"4ff600e0de", 39x"4fd6dee102", 39x"4fb7e0e126", 39x"4f9906e14a",
        39x"4f7a50e16d", 39x"4f5bbde190", 39x"4f3d4ee1b3", 39x"4f1f01e1d6",
        39x"4f00d7e1f8", 39x"4ee2cfe21b", 39x"4ec4ebe23c", 39x"4ea727e25e",
        39x"4e8985e280", 39x"4e6c04e2a1", 39x"4e4ea5e2c2", 39x"4e3167e2e2",
        39x"4e1449e303", 39x"4df74ce323", 39x"4dda6ee343", 39x"4dbdb1e363",
        39x"4da114e382", 39x"4d8496e3a1", 39x"4d6838e3c0", 39x"4d4bf8e3df",
        39x"4d2fd7e3fe", 39x"4d13d5e41c", 39x"4cf7f2e43a", 39x"4cdc2ce458",
        39x"4cc084e476", 39x"4ca4fae494", 39x"4c898ee4b1", 39x"4c6e40e4ce",
        39x"4c530ee4eb", 39x"4c37f9e508", 39x"4c1d01e525", 39x"4c0225e541",
        39x"4be766e55d", 39x"4bccc3e579", 39x"4bb23ce595", 39x"4b97d1e5b0",
        39x"4b7d81e5cc", 39x"4b634de5e7", 39x"4b4934e602", 39x"4b2f36e61d",
        39x"4b1553e638", 39x"4afb8be652", 39x"4ae1dde66c", 39x"4ac849e686",
        39x"4aaed0e6a0", 39x"4a9570e6ba", 39x"4a7c2ae6d4", 39x"4a62fee6ed",
        39x"4a49ebe707", 39x"4a30f2e720", 39x"4a1811e739", 39x"49ff4ae751",
        39x"49e69ce76a", 39x"49ce06e783", 39x"49b588e79b", 39x"499d23e7b3",
        39x"4984d6e7cb", 39x"496ca1e7e3", 39x"495484e7fb", 39x"493c7fe812",
        39x"492491e82a", 39x"490cbae841", 39x"48f4fbe858", 39x"48dd53e86f",
        39x"48c5c2e886", 39x"48ae48e89c", 39x"4896e4e8b3", 39x"487f97e8c9",
        39x"486860e8df", 39x"48513fe8f6", 39x"483a35e90c", 39x"482341e921",
        39x"480c62e937", 39x"47f599e94d", 39x"47dee6e962", 39x"47c848e977",
        39x"47b1bfe98d", 39x"479b4be9a2", 39x"4784ede9b6", 39x"476ea4e9cb",
        39x"47586fe9e0", 39x"47424fe9f4", 39x"472c43ea09", 39x"47164cea1d",
        39x"470069ea31", 39x"46ea9bea45", 39x"46d4e0ea59", 39x"46bf39ea6d",
        39x"46a9a6ea81", 39x"469427ea94", 39x"467ebbeaa8", 39x"466963eabb",
        39x"46541feace", 39x"463eedeae2", 39x"4629ceeaf5", 39x"4614c3eb07",
        39x"45ffcaeb1a", 39x"45eae4eb2d", 39x"45d612eb3f", 39x"45c151eb52",
        39x"45aca3eb64", 39x"459807eb76", 39x"45837deb89", 39x"456f06eb9b",
        39x"455aa1ebad", 39x"45464eebbe", 39x"45320cebd0", 39x"451ddcebe2",
        39x"4509beebf3", 39x"44f5b1ec05", 39x"44e1b6ec16", 39x"44cdccec27",
        39x"44b9f3ec38", 39x"44a62cec49", 39x"449275ec5a", 39x"447ecfec6b",
        39x"446b3bec7c", 39x"4457b6ec8d", 39x"444443ec9d", 39x"4430e0ecae",
        39x"441d8eecbe", 39x"440a4decce", 39x"43f71becdf", 39x"43e3f9ecef",
        39x"43d0e8ecff", 39x"43bde7ed0f", 39x"43aaf5ed1f", 39x"439814ed2e",
        39x"438542ed3e", 39x"437280ed4e", 39x"435fceed5d", 39x"434d2bed6d",
        39x"433a98ed7c", 39x"432814ed8b", 39x"43159fed9a", 39x"43033aeda9",
        39x"42f0e3edb8", 39x"42de9cedc7", 39x"42cc63edd6", 39x"42ba39ede5",
        39x"42a81eedf4", 39x"429612ee02", 39x"428414ee11", 39x"427226ee1f",
        39x"426045ee2e", 39x"424e73ee3c", 39x"423cafee4a", 39x"422af9ee59",
        39x"421952ee67", 39x"4207b8ee75", 39x"41f62dee83", 39x"41e4b0ee91",
        39x"41d341ee9e", 39x"41c1dfeeac", 39x"41b08beeba", 39x"419f45eec7",
        39x"418e0ceed5", 39x"417ce1eee2", 39x"416bc3eef0", 39x"415ab3eefd",
        39x"4149b0ef0a", 39x"4138baef18", 39x"4127d2ef25", 39x"4116f7ef32",
        39x"410628ef3f", 39x"40f567ef4c", 39x"40e4b3ef58", 39x"40d40bef65",
        39x"40c370ef72", 39x"40b2e2ef7f", 39x"40a261ef8b", 39x"4091ecef98",
        39x"408185efa4", 39x"407129efb1", 39x"4060d9efbd", 39x"405097efc9",
        39x"404060efd6", 39x"403035efe2", 39x"402017efee", 39x"401005effa",
        39x"3ffffff006", 39x"3ff005f012", 39x"3fe017f01e", 39x"3fd035f02a",
        39x"3fc05ff035", 39x"3fb094f041", 39x"3fa0d5f04d", 39x"3f9122f058",
        39x"3f817af064", 39x"3f71dff06f", 39x"3f624ef07b", 39x"3f52c9f086",
        39x"3f434ff092", 39x"3f33e0f09d", 39x"3f247df0a8", 39x"3f1525f0b3",
        39x"3f05d9f0be", 39x"3ef697f0c9", 39x"3ee760f0d4", 39x"3ed835f0df",
        39x"3ec914f0ea", 39x"3eb9fef0f5", 39x"3eaaf3f100", 39x"3e9bf3f10b",
        39x"3e8cfef115", 39x"3e7e13f120", 39x"3e6f33f12b", 39x"3e605ef135",
        39x"3e5193f140", 39x"3e42d2f14a", 39x"3e341cf155", 39x"3e2571f15f",
        39x"3e16d0f169", 39x"3e0839f173", 39x"3df9acf17e", 39x"3deb2af188",
        39x"3ddcb2f192", 39x"3dce44f19c", 39x"3dbfe0f1a6", 39x"3db186f1b0",
        39x"3da336f1ba", 39x"3d94f0f1c4", 39x"3d86b4f1ce", 39x"3d7882f1d8",
        39x"3d6a5af1e1", 39x"3d5c3bf1eb", 39x"3d4e26f1f5", 39x"3d401bf1fe",
        39x"3d3219f208", 39x"3d2421f212", 39x"3d1633f21b", 39x"3d084ef224",
        39x"3cfa72f22e", 39x"3ceca0f237", 39x"3cded7f241", 39x"3cd118f24a",
        39x"3cc362f253", 39x"3cb5b5f25c", 39x"3ca811f266", 39x"3c9a77f26f",
        39x"3c8ce6f278", 39x"3c7f5ef281", 39x"3c71def28a", 39x"3c6468f293",
        39x"3c56fbf29c", 39x"3c4997f2a5", 39x"3c3c3cf2ae", 39x"3c2eeaf2b6",
        39x"3c21a0f2bf", 39x"3c145ff2c8", 39x"3c0727f2d1", 39x"3bf9f8f2d9",
        39x"3becd1f2e2", 39x"3bdfb2f2eb", 39x"3bd29df2f3", 39x"3bc590f2fc",
        39x"3bb88cf304", 39x"3bab90f30d", 39x"3b9e9df315", 39x"3b91b2f31d",
        39x"3b84cff326", 39x"3b77f5f32e", 39x"3b6b23f336", 39x"3b5e59f33f",
        39x"3b5198f347", 39x"3b44def34f", 39x"3b382df357", 39x"3b2b85f35f",
        39x"3b1ee4f367", 39x"3b124bf36f", 39x"3b05baf377", 39x"3af932f37f",
        39x"3aecb1f387", 39x"3ae038f38f", 39x"3ad3c7f397", 39x"3ac75ef39f",
        39x"3abafdf3a7", 39x"3aaea4f3ae", 39x"3aa252f3b6", 39x"3a9608f3be",
        39x"3a89c6f3c6", 39x"3a7d8cf3cd", 39x"3a7159f3d5", 39x"3a652ef3dc",
        39x"3a590af3e4", 39x"3a4ceef3ec", 39x"3a40d9f3f3", 39x"3a34cdf3fa",
        39x"3a28c7f402", 39x"3a1cc9f409", 39x"3a10d2f411", 39x"3a04e3f418",
        39x"39f8fbf41f", 39x"39ed1af427", 39x"39e141f42e", 39x"39d56ff435",
        39x"39c9a4f43c", 39x"39bde0f444", 39x"39b224f44b", 39x"39a66ef452",
        39x"399ac0f459", 39x"398f19f460", 39x"398379f467", 39x"3977e0f46e",
        39x"396c4ef475", 39x"3960c3f47c", 39x"39553ff483", 39x"3949c1f48a"
    );
    attribute rom_style of recip_root_rom : constant is "block";

    -- Words start at zero: numeric_std warns about comparing or indexing with undefined words.
    -- Valid bits don't, so a bit that a reset misses shows as unknown.
    -- stage 0
    signal t_x_n23 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_x_n24 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_x_n25 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_y_n28 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_y_n29 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_y_n30 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_z_n33 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_z_n34 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_z_n35 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_x_n41 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_x_n42 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_x_n43 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_y_n46 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_y_n47 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_y_n48 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_z_n51 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_z_n52 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_z_n53 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal l_x : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_y : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_z : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_block_n62_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n62 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n63 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n64_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n64 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n65 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n66_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n66 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n67 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n68 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n69 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_largest : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n71 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n72 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n73 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n75 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal l_block_n76 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n77 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n82 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal l_block_n88 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal l_block_n94 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n104 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n105 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n106 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n108 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n109 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n129 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n130 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n131 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n132 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n133 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n149 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n150 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n151 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n152 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n153 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal reciprocal_length_n210 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n225 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal s0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_x_n23_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_x_n24_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_x_n25_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_y_n28_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_y_n29_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_y_n30_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_z_n33_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_z_n34_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal t_z_n35_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_x_n41_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_x_n42_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_x_n43_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_y_n46_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_y_n47_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_y_n48_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_z_n51_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_z_n52_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal b_z_n53_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal l_block_largest_s1 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n72_s1 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n73_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n77_s1 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n106_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n109_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n131_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n133_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n151_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n153_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal valid_s1 : std_logic;
    -- stage 1
    signal t_x_n26 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal t_x_n27 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_y_n31 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal t_y_n32 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_z_n36 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal t_z_n37 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_eye_x_sum : signed(34 downto 0) := (others => '0');
    signal t_eye_x_cut : signed(25 downto 0) := (others => '0');
    signal t_eye_x : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_y_sum : signed(34 downto 0) := (others => '0');
    signal t_eye_y_cut : signed(25 downto 0) := (others => '0');
    signal t_eye_y : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_z_sum : signed(34 downto 0) := (others => '0');
    signal t_eye_z_cut : signed(25 downto 0) := (others => '0');
    signal t_eye_z : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_x_n44 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal b_x_n45 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_y_n49 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal b_y_n50 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_z_n54 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal b_z_n55 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_eye_x_sum : signed(34 downto 0) := (others => '0');
    signal b_eye_x_cut : signed(25 downto 0) := (others => '0');
    signal b_eye_x : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_y_sum : signed(34 downto 0) := (others => '0');
    signal b_eye_y_cut : signed(25 downto 0) := (others => '0');
    signal b_eye_y : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_z_sum : signed(34 downto 0) := (others => '0');
    signal b_eye_z_cut : signed(25 downto 0) := (others => '0');
    signal b_eye_z : signed(25 downto 0) := (others => '0'); -- s26f18
    signal l_block_n74 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n78 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n79 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal l_block_n80 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n81 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal l_block_n83 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n84 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n85 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal l_block_n86 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n87 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal l_block_n89 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n90 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n91 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n93 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal l_block_n95 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n99 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n100 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal l_block_n103 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal s0_s2 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s2 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_eye_x_s2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_y_s2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_z_s2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_x_s2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_y_s2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_z_s2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal l_block_n90_s2 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n91_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n95_s2 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n100_s2 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal l_block_n103_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n106_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n109_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n131_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n133_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n151_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n153_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal l_block_n92 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n96 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n97 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n98 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n101 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal l_block_places : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal l_block_n107 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n110 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n111 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n112 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal l_block_n113 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n114 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n115 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n116 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal l_block_n117 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n118 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n119 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n120 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal l_block_n121 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n122 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n124 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n125 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n126 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n127 : signed(29 downto 0) := (others => '0'); -- s30f0
    signal l_block_x : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_n134 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n135 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal l_block_n136 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n137 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n138 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal l_block_n139 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n140 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n141 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal l_block_n142 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n143 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n144 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n145 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n146 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n147 : signed(29 downto 0) := (others => '0'); -- s30f0
    signal l_block_y : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_n154 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n155 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal l_block_n156 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n157 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n158 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal l_block_n159 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n160 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n161 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal l_block_n162 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n163 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n164 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n165 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n166 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n167 : signed(29 downto 0) := (others => '0'); -- s30f0
    signal l_block_z : signed(29 downto 0) := (others => '0'); -- s30f29
    signal s0_s3 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s3 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_eye_x_s3 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_y_s3 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_z_s3 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_x_s3 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_y_s3 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_z_s3 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal l_block_n103_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_x_s3 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_y_s3 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_z_s3 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal valid_s3 : std_logic;
    -- stage 3
    signal l_norm_x_sum : signed(30 downto 0) := (others => '0');
    signal l_norm_x_cut : signed(18 downto 0) := (others => '0');
    signal l_norm_x_over : unsigned(0 downto 0) := (others => '0');
    signal l_norm_x : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_sum : signed(30 downto 0) := (others => '0');
    signal l_norm_y_cut : signed(18 downto 0) := (others => '0');
    signal l_norm_y_over : unsigned(0 downto 0) := (others => '0');
    signal l_norm_y : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_sum : signed(30 downto 0) := (others => '0');
    signal l_norm_z_cut : signed(18 downto 0) := (others => '0');
    signal l_norm_z_over : unsigned(0 downto 0) := (others => '0');
    signal l_norm_z : signed(17 downto 0) := (others => '0'); -- s18f17
    signal s0_s4 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s4 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_eye_x_s4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_y_s4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_z_s4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_x_s4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_y_s4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_z_s4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal l_block_n103_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_norm_x_s4 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s4 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s4 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal valid_s4 : std_logic;
    -- stage 4
    signal t_dot_l_n172 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal t_dot_l_n173 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal t_dot_l_n174 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal l_dot_l_n178 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n179 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n180 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal b_dot_l_n229 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal b_dot_l_n230 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal b_dot_l_n231 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal s0_s5 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s5 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_dot_l_n172_s5 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal t_dot_l_n173_s5 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal t_dot_l_n174_s5 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal l_dot_l_n178_s5 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n179_s5 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n180_s5 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal b_dot_l_n229_s5 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal b_dot_l_n230_s5 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal b_dot_l_n231_s5 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal valid_s5 : std_logic;
    -- stage 5
    signal t_dot_l_n175 : signed(44 downto 0) := (others => '0'); -- s45f35
    signal t_dot_l_n176 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal l_dot_l_n181 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal l_dot_l_n182 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal b_dot_l_n232 : signed(44 downto 0) := (others => '0'); -- s45f35
    signal b_dot_l_n233 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal s0_s6 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s6 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_dot_l_n176_s6 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal l_dot_l_n182_s6 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal b_dot_l_n233_s6 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal valid_s6 : std_logic;
    -- stage 6
    signal t_l_sum : signed(46 downto 0) := (others => '0');
    signal t_l_cut : signed(31 downto 0) := (others => '0');
    signal t_l : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_square_sum : signed(38 downto 0) := (others => '0');
    signal reciprocal_length_square_cut : signed(24 downto 0) := (others => '0');
    signal reciprocal_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_length_n184 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n185 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n186 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal reciprocal_length_n187 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n188 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal reciprocal_length_n189 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n190 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n191 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal reciprocal_length_n192 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n193 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal reciprocal_length_n194 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n206 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n226 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal b_l_sum : signed(46 downto 0) := (others => '0');
    signal b_l_cut : signed(31 downto 0) := (others => '0');
    signal b_l : signed(31 downto 0) := (others => '0'); -- s32f20
    signal s0_s7 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s7 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_l_s7 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_n190_s7 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n192_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n194_s7 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n206_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n226_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal b_l_s7 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal valid_s7 : std_logic;
    -- stage 7
    signal reciprocal_length_n195 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n196 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_n197 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n198 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal reciprocal_length_n199 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n200 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n201 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n202 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n203 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_length_n204 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n205 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n207 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal reciprocal_length_n208 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_n209 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n211 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal reciprocal_length_n212 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n213 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal reciprocal_length_n214 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_length_n215 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal reciprocal_length_recip_root_n216 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal reciprocal_length_recip_root_n219 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal s0_s8 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s8 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_l_s8 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_n208_s8 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row : unsigned(38 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n219_s8 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_length_n226_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal b_l_s8 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal valid_s8 : std_logic;
    -- stage 8
    signal reciprocal_length_recip_root_n217 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal reciprocal_length_recip_root_n218 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal s0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_l_s9 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_n208_s9 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_recip_root_n217_s9 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal reciprocal_length_recip_root_n218_s9 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal reciprocal_length_recip_root_n219_s9 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_length_n226_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal b_l_s9 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal valid_s9 : std_logic;
    -- stage 9
    signal reciprocal_length_recip_root_n220 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal reciprocal_length_recip_root_n221 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal s0_s10 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s10 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_l_s10 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_n208_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_recip_root_n221_s10 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal reciprocal_length_n226_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal b_l_s10 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal valid_s10 : std_logic;
    -- stage 10
    signal reciprocal_length_recip_root_n222_sum : signed(36 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n222_cut : signed(23 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n222_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n222_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n222 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_length_n223_past : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_n223_count : unsigned(3 downto 0) := (others => '0');
    signal reciprocal_length_n223 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal reciprocal_length_n224 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal reciprocal_length_n227 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal s0_s11 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s11 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_l_s11 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_n227_s11 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal b_l_s11 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal valid_s11 : std_logic;
    -- stage 11
    signal reciprocal_length_reciprocal_length_sum : unsigned(33 downto 0) := (others => '0');
    signal reciprocal_length_reciprocal_length_cut : unsigned(30 downto 0) := (others => '0');
    signal reciprocal_length_reciprocal_length_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_reciprocal_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal s0_s12 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s12 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal t_l_s12 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal reciprocal_length_reciprocal_length_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal b_l_s12 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal valid_s12 : std_logic;
    -- stage 12
    signal ds_product : signed(51 downto 0) := (others => '0'); -- s52f38
    signal dt_product : signed(51 downto 0) := (others => '0'); -- s52f38
    signal s0_s13 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s13 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal l_block_n103_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal ds_product_s13 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal dt_product_s13 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal valid_s13 : std_logic;
    -- stage 13
    signal ds_next_sum : signed(52 downto 0) := (others => '0');
    signal ds_next_cut : signed(32 downto 0) := (others => '0');
    signal ds_next_over : unsigned(0 downto 0) := (others => '0');
    signal ds_next_under : unsigned(0 downto 0) := (others => '0');
    signal ds_next : signed(26 downto 0) := (others => '0'); -- s27f18
    signal s1_sum : signed(27 downto 0) := (others => '0'); -- s28f18
    signal s1_next_over : unsigned(0 downto 0) := (others => '0');
    signal s1_next_under : unsigned(0 downto 0) := (others => '0');
    signal s1_next : signed(24 downto 0) := (others => '0'); -- s25f18
    signal dt_next_sum : signed(52 downto 0) := (others => '0');
    signal dt_next_cut : signed(32 downto 0) := (others => '0');
    signal dt_next_over : unsigned(0 downto 0) := (others => '0');
    signal dt_next_under : unsigned(0 downto 0) := (others => '0');
    signal dt_next : signed(26 downto 0) := (others => '0'); -- s27f18
    signal t1_sum : signed(27 downto 0) := (others => '0'); -- s28f18
    signal t1_next_over : unsigned(0 downto 0) := (others => '0');
    signal t1_next_under : unsigned(0 downto 0) := (others => '0');
    signal t1_next : signed(24 downto 0) := (others => '0'); -- s25f18
    signal valid_s14 : std_logic;
begin

    -- ---- stage 0 ----
    -- t_x
    t_x_n23 <= m0_x * tangent_x;
    t_x_n24 <= m0_y * tangent_y;
    t_x_n25 <= m0_z * tangent_z;
    -- t_y
    t_y_n28 <= m1_x * tangent_x;
    t_y_n29 <= m1_y * tangent_y;
    t_y_n30 <= m1_z * tangent_z;
    -- t_z
    t_z_n33 <= m2_x * tangent_x;
    t_z_n34 <= m2_y * tangent_y;
    t_z_n35 <= m2_z * tangent_z;
    -- b_x
    b_x_n41 <= m0_x * binormal_x;
    b_x_n42 <= m0_y * binormal_y;
    b_x_n43 <= m0_z * binormal_z;
    -- b_y
    b_y_n46 <= m1_x * binormal_x;
    b_y_n47 <= m1_y * binormal_y;
    b_y_n48 <= m1_z * binormal_z;
    -- b_z
    b_z_n51 <= m2_x * binormal_x;
    b_z_n52 <= m2_y * binormal_y;
    b_z_n53 <= m2_z * binormal_z;
    -- (unit)
    l_x <= resize(light_x, 29) - resize(vertex_x, 29);
    l_y <= resize(light_y, 29) - resize(vertex_y, 29);
    l_z <= resize(light_z, 29) - resize(vertex_z, 29);
    -- l_block
    l_block_n62_neg <= unsigned(-l_x);
    l_block_n62 <= l_block_n62_neg when l_x(28) = '1' else unsigned(l_x);
    l_block_n63 <= l_block_n62;
    l_block_n64_neg <= unsigned(-l_y);
    l_block_n64 <= l_block_n64_neg when l_y(28) = '1' else unsigned(l_y);
    l_block_n65 <= l_block_n64;
    l_block_n66_neg <= unsigned(-l_z);
    l_block_n66 <= l_block_n66_neg when l_z(28) = '1' else unsigned(l_z);
    l_block_n67 <= l_block_n66;
    l_block_n68 <= l_block_n63 or l_block_n65;
    l_block_n69 <= l_block_n68 or l_block_n67;
    l_block_largest <= l_block_n69;
    l_block_n71 <= "0";
    l_block_n72 <= l_block_largest;
    l_block_n73 <= l_block_n72(28 downto 13);
    l_block_n75 <= l_block_n72(12 downto 0);
    l_block_n76 <= 16x"0000";
    l_block_n77 <= l_block_n75 & l_block_n76;
    l_block_n82 <= 8x"00";
    l_block_n88 <= 4x"0";
    l_block_n94 <= "00";
    l_block_n104 <= unsigned(l_x(28 downto 28));
    l_block_n105 <= unsigned(l_x);
    l_block_n106 <= l_block_n104 & l_block_n105;
    l_block_n108 <= l_block_n106(13 downto 0);
    l_block_n109 <= l_block_n108 & l_block_n76;
    l_block_n129 <= unsigned(l_y(28 downto 28));
    l_block_n130 <= unsigned(l_y);
    l_block_n131 <= l_block_n129 & l_block_n130;
    l_block_n132 <= l_block_n131(13 downto 0);
    l_block_n133 <= l_block_n132 & l_block_n76;
    l_block_n149 <= unsigned(l_z(28 downto 28));
    l_block_n150 <= unsigned(l_z);
    l_block_n151 <= l_block_n149 & l_block_n150;
    l_block_n152 <= l_block_n151(13 downto 0);
    l_block_n153 <= l_block_n152 & l_block_n76;
    -- reciprocal_length
    reciprocal_length_n210 <= "1";
    reciprocal_length_n225 <= "1";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- t_x
    t_x_n26 <= resize(t_x_n23_s1, 33) + resize(t_x_n24_s1, 33);
    t_x_n27 <= resize(t_x_n26, 34) + resize(t_x_n25_s1, 34);
    -- t_y
    t_y_n31 <= resize(t_y_n28_s1, 33) + resize(t_y_n29_s1, 33);
    t_y_n32 <= resize(t_y_n31, 34) + resize(t_y_n30_s1, 34);
    -- t_z
    t_z_n36 <= resize(t_z_n33_s1, 33) + resize(t_z_n34_s1, 33);
    t_z_n37 <= resize(t_z_n36, 34) + resize(t_z_n35_s1, 34);
    -- (unit)
    t_eye_x_sum <= resize(t_x_n27, 35) + 35x"000000100";
    t_eye_x_cut <= t_eye_x_sum(34 downto 9);
    t_eye_x <= t_eye_x_cut;
    t_eye_y_sum <= resize(t_y_n32, 35) + 35x"000000100";
    t_eye_y_cut <= t_eye_y_sum(34 downto 9);
    t_eye_y <= t_eye_y_cut;
    t_eye_z_sum <= resize(t_z_n37, 35) + 35x"000000100";
    t_eye_z_cut <= t_eye_z_sum(34 downto 9);
    t_eye_z <= t_eye_z_cut;
    -- b_x
    b_x_n44 <= resize(b_x_n41_s1, 33) + resize(b_x_n42_s1, 33);
    b_x_n45 <= resize(b_x_n44, 34) + resize(b_x_n43_s1, 34);
    -- b_y
    b_y_n49 <= resize(b_y_n46_s1, 33) + resize(b_y_n47_s1, 33);
    b_y_n50 <= resize(b_y_n49, 34) + resize(b_y_n48_s1, 34);
    -- b_z
    b_z_n54 <= resize(b_z_n51_s1, 33) + resize(b_z_n52_s1, 33);
    b_z_n55 <= resize(b_z_n54, 34) + resize(b_z_n53_s1, 34);
    -- (unit)
    b_eye_x_sum <= resize(b_x_n45, 35) + 35x"000000100";
    b_eye_x_cut <= b_eye_x_sum(34 downto 9);
    b_eye_x <= b_eye_x_cut;
    b_eye_y_sum <= resize(b_y_n50, 35) + 35x"000000100";
    b_eye_y_cut <= b_eye_y_sum(34 downto 9);
    b_eye_y <= b_eye_y_cut;
    b_eye_z_sum <= resize(b_z_n55, 35) + 35x"000000100";
    b_eye_z_cut <= b_eye_z_sum(34 downto 9);
    b_eye_z <= b_eye_z_cut;
    -- l_block
    l_block_n74 <= "1" when l_block_n73_s1 = resize(l_block_n71, 16) else "0";
    l_block_n78 <= l_block_n77_s1 when l_block_n74(0) = '1' else l_block_n72_s1;
    l_block_n79 <= l_block_n78(28 downto 21);
    l_block_n80 <= "1" when l_block_n79 = resize(l_block_n71, 8) else "0";
    l_block_n81 <= l_block_n78(20 downto 0);
    l_block_n83 <= l_block_n81 & l_block_n82;
    l_block_n84 <= l_block_n83 when l_block_n80(0) = '1' else l_block_n78;
    l_block_n85 <= l_block_n84(28 downto 25);
    l_block_n86 <= "1" when l_block_n85 = resize(l_block_n71, 4) else "0";
    l_block_n87 <= l_block_n84(24 downto 0);
    l_block_n89 <= l_block_n87 & l_block_n88;
    l_block_n90 <= l_block_n89 when l_block_n86(0) = '1' else l_block_n84;
    l_block_n91 <= l_block_n90(28 downto 27);
    l_block_n93 <= l_block_n90(26 downto 0);
    l_block_n95 <= l_block_n93 & l_block_n94;
    l_block_n99 <= l_block_n74 & l_block_n80;
    l_block_n100 <= l_block_n99 & l_block_n86;
    l_block_n103 <= "1" when l_block_largest_s1 = shift_left(resize(l_block_n71, 29), 15) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- l_block
    l_block_n92 <= "1" when l_block_n91_s2 = resize(l_block_n71, 2) else "0";
    l_block_n96 <= l_block_n95_s2 when l_block_n92(0) = '1' else l_block_n90_s2;
    l_block_n97 <= l_block_n96(28 downto 28);
    l_block_n98 <= "1" when l_block_n97 = l_block_n71 else "0";
    l_block_n101 <= l_block_n100_s2 & l_block_n92;
    l_block_places <= l_block_n101 & l_block_n98;
    l_block_n107 <= l_block_places(4 downto 4);
    l_block_n110 <= l_block_n109_s2 when l_block_n107(0) = '1' else l_block_n106_s2;
    l_block_n111 <= l_block_places(3 downto 3);
    l_block_n112 <= l_block_n110(21 downto 0);
    l_block_n113 <= l_block_n112 & l_block_n82;
    l_block_n114 <= l_block_n113 when l_block_n111(0) = '1' else l_block_n110;
    l_block_n115 <= l_block_places(2 downto 2);
    l_block_n116 <= l_block_n114(25 downto 0);
    l_block_n117 <= l_block_n116 & l_block_n88;
    l_block_n118 <= l_block_n117 when l_block_n115(0) = '1' else l_block_n114;
    l_block_n119 <= l_block_places(1 downto 1);
    l_block_n120 <= l_block_n118(27 downto 0);
    l_block_n121 <= l_block_n120 & l_block_n94;
    l_block_n122 <= l_block_n121 when l_block_n119(0) = '1' else l_block_n118;
    l_block_n123 <= l_block_places(0 downto 0);
    l_block_n124 <= l_block_n122(28 downto 0);
    l_block_n125 <= l_block_n124 & l_block_n71;
    l_block_n126 <= l_block_n125 when l_block_n123(0) = '1' else l_block_n122;
    l_block_n127 <= signed(l_block_n126);
    l_block_x <= l_block_n127;
    l_block_n134 <= l_block_n133_s2 when l_block_n107(0) = '1' else l_block_n131_s2;
    l_block_n135 <= l_block_n134(21 downto 0);
    l_block_n136 <= l_block_n135 & l_block_n82;
    l_block_n137 <= l_block_n136 when l_block_n111(0) = '1' else l_block_n134;
    l_block_n138 <= l_block_n137(25 downto 0);
    l_block_n139 <= l_block_n138 & l_block_n88;
    l_block_n140 <= l_block_n139 when l_block_n115(0) = '1' else l_block_n137;
    l_block_n141 <= l_block_n140(27 downto 0);
    l_block_n142 <= l_block_n141 & l_block_n94;
    l_block_n143 <= l_block_n142 when l_block_n119(0) = '1' else l_block_n140;
    l_block_n144 <= l_block_n143(28 downto 0);
    l_block_n145 <= l_block_n144 & l_block_n71;
    l_block_n146 <= l_block_n145 when l_block_n123(0) = '1' else l_block_n143;
    l_block_n147 <= signed(l_block_n146);
    l_block_y <= l_block_n147;
    l_block_n154 <= l_block_n153_s2 when l_block_n107(0) = '1' else l_block_n151_s2;
    l_block_n155 <= l_block_n154(21 downto 0);
    l_block_n156 <= l_block_n155 & l_block_n82;
    l_block_n157 <= l_block_n156 when l_block_n111(0) = '1' else l_block_n154;
    l_block_n158 <= l_block_n157(25 downto 0);
    l_block_n159 <= l_block_n158 & l_block_n88;
    l_block_n160 <= l_block_n159 when l_block_n115(0) = '1' else l_block_n157;
    l_block_n161 <= l_block_n160(27 downto 0);
    l_block_n162 <= l_block_n161 & l_block_n94;
    l_block_n163 <= l_block_n162 when l_block_n119(0) = '1' else l_block_n160;
    l_block_n164 <= l_block_n163(28 downto 0);
    l_block_n165 <= l_block_n164 & l_block_n71;
    l_block_n166 <= l_block_n165 when l_block_n123(0) = '1' else l_block_n163;
    l_block_n167 <= signed(l_block_n166);
    l_block_z <= l_block_n167;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    l_norm_x_sum <= resize(l_block_x_s3, 31) + 31x"00000800";
    l_norm_x_cut <= l_norm_x_sum(30 downto 12);
    l_norm_x_over <= "1" when l_norm_x_cut(18) = '0' and (or l_norm_x_cut(17 downto 17)) = '1' else "0";
    l_norm_x <= 18x"1ffff" when l_norm_x_over(0) = '1' else l_norm_x_cut(17 downto 0);
    l_norm_y_sum <= resize(l_block_y_s3, 31) + 31x"00000800";
    l_norm_y_cut <= l_norm_y_sum(30 downto 12);
    l_norm_y_over <= "1" when l_norm_y_cut(18) = '0' and (or l_norm_y_cut(17 downto 17)) = '1' else "0";
    l_norm_y <= 18x"1ffff" when l_norm_y_over(0) = '1' else l_norm_y_cut(17 downto 0);
    l_norm_z_sum <= resize(l_block_z_s3, 31) + 31x"00000800";
    l_norm_z_cut <= l_norm_z_sum(30 downto 12);
    l_norm_z_over <= "1" when l_norm_z_cut(18) = '0' and (or l_norm_z_cut(17 downto 17)) = '1' else "0";
    l_norm_z <= 18x"1ffff" when l_norm_z_over(0) = '1' else l_norm_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- t_dot_l
    t_dot_l_n172 <= t_eye_x_s4 * l_norm_x_s4;
    t_dot_l_n173 <= t_eye_y_s4 * l_norm_y_s4;
    t_dot_l_n174 <= t_eye_z_s4 * l_norm_z_s4;
    -- l_dot_l
    l_dot_l_n178 <= l_norm_x_s4 * l_norm_x_s4;
    l_dot_l_n179 <= l_norm_y_s4 * l_norm_y_s4;
    l_dot_l_n180 <= l_norm_z_s4 * l_norm_z_s4;
    -- b_dot_l
    b_dot_l_n229 <= b_eye_x_s4 * l_norm_x_s4;
    b_dot_l_n230 <= b_eye_y_s4 * l_norm_y_s4;
    b_dot_l_n231 <= b_eye_z_s4 * l_norm_z_s4;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- t_dot_l
    t_dot_l_n175 <= resize(t_dot_l_n172_s5, 45) + resize(t_dot_l_n173_s5, 45);
    t_dot_l_n176 <= resize(t_dot_l_n175, 46) + resize(t_dot_l_n174_s5, 46);
    -- l_dot_l
    l_dot_l_n181 <= resize(l_dot_l_n178_s5, 37) + resize(l_dot_l_n179_s5, 37);
    l_dot_l_n182 <= resize(l_dot_l_n181, 38) + resize(l_dot_l_n180_s5, 38);
    -- b_dot_l
    b_dot_l_n232 <= resize(b_dot_l_n229_s5, 45) + resize(b_dot_l_n230_s5, 45);
    b_dot_l_n233 <= resize(b_dot_l_n232, 46) + resize(b_dot_l_n231_s5, 46);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s6 <= s0_s5;
                t0_s6 <= t0_s5;
                l_block_n103_s6 <= l_block_n103_s5;
                t_dot_l_n176_s6 <= t_dot_l_n176;
                l_dot_l_n182_s6 <= l_dot_l_n182;
                b_dot_l_n233_s6 <= b_dot_l_n233;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    t_l_sum <= resize(t_dot_l_n176_s6, 47) + 47x"000000004000";
    t_l_cut <= t_l_sum(46 downto 15);
    t_l <= t_l_cut;
    reciprocal_length_square_sum <= resize(l_dot_l_n182_s6, 39) + 39x"0000002000";
    reciprocal_length_square_cut <= reciprocal_length_square_sum(38 downto 14);
    reciprocal_length_square_over <= "1" when reciprocal_length_square_cut(24) = '0' and (or reciprocal_length_square_cut(23 downto 22)) = '1' else "0";
    reciprocal_length_square_under <= unsigned(reciprocal_length_square_cut(24 downto 24));
    reciprocal_length_square <= 22x"3fffff" when reciprocal_length_square_over(0) = '1' else 22x"000000" when reciprocal_length_square_under(0) = '1' else unsigned(reciprocal_length_square_cut(21 downto 0));
    -- reciprocal_length
    reciprocal_length_n184 <= reciprocal_length_square;
    reciprocal_length_n185 <= reciprocal_length_n184;
    reciprocal_length_n186 <= reciprocal_length_n185(21 downto 6);
    reciprocal_length_n187 <= "1" when reciprocal_length_n186 = resize(l_block_n71, 16) else "0";
    reciprocal_length_n188 <= reciprocal_length_n185(5 downto 0);
    reciprocal_length_n189 <= reciprocal_length_n188 & l_block_n76;
    reciprocal_length_n190 <= reciprocal_length_n189 when reciprocal_length_n187(0) = '1' else reciprocal_length_n185;
    reciprocal_length_n191 <= reciprocal_length_n190(21 downto 14);
    reciprocal_length_n192 <= "1" when reciprocal_length_n191 = resize(l_block_n71, 8) else "0";
    reciprocal_length_n193 <= reciprocal_length_n190(13 downto 0);
    reciprocal_length_n194 <= reciprocal_length_n193 & l_block_n82;
    reciprocal_length_n206 <= reciprocal_length_n187 & reciprocal_length_n192;
    reciprocal_length_n226 <= "1" when reciprocal_length_square = shift_left(resize(l_block_n71, 22), 20) else "0";
    -- (unit)
    b_l_sum <= resize(b_dot_l_n233_s6, 47) + 47x"000000004000";
    b_l_cut <= b_l_sum(46 downto 15);
    b_l <= b_l_cut;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- reciprocal_length
    reciprocal_length_n195 <= reciprocal_length_n194_s7 when reciprocal_length_n192_s7(0) = '1' else reciprocal_length_n190_s7;
    reciprocal_length_n196 <= reciprocal_length_n195(21 downto 18);
    reciprocal_length_n197 <= "1" when reciprocal_length_n196 = resize(l_block_n71, 4) else "0";
    reciprocal_length_n198 <= reciprocal_length_n195(17 downto 0);
    reciprocal_length_n199 <= reciprocal_length_n198 & l_block_n88;
    reciprocal_length_n200 <= reciprocal_length_n199 when reciprocal_length_n197(0) = '1' else reciprocal_length_n195;
    reciprocal_length_n201 <= reciprocal_length_n200(21 downto 20);
    reciprocal_length_n202 <= "1" when reciprocal_length_n201 = resize(l_block_n71, 2) else "0";
    reciprocal_length_n203 <= reciprocal_length_n200(19 downto 0);
    reciprocal_length_n204 <= reciprocal_length_n203 & l_block_n94;
    reciprocal_length_n205 <= reciprocal_length_n204 when reciprocal_length_n202(0) = '1' else reciprocal_length_n200;
    reciprocal_length_n207 <= reciprocal_length_n206_s7 & reciprocal_length_n197;
    reciprocal_length_n208 <= reciprocal_length_n207 & reciprocal_length_n202;
    reciprocal_length_n209 <= reciprocal_length_n205(21 downto 20);
    reciprocal_length_n211 <= signed(resize(reciprocal_length_n209, 3)) - signed(resize(reciprocal_length_n210, 3));
    reciprocal_length_n212 <= unsigned(reciprocal_length_n211(1 downto 0));
    reciprocal_length_n213 <= reciprocal_length_n205(19 downto 2);
    reciprocal_length_n214 <= reciprocal_length_n212 & reciprocal_length_n213;
    reciprocal_length_n215 <= reciprocal_length_n214;
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n216 <= reciprocal_length_n215(19 downto 11);
    reciprocal_length_recip_root_n219 <= reciprocal_length_n215(10 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s8 <= s0_s7;
                t0_s8 <= t0_s7;
                l_block_n103_s8 <= l_block_n103_s7;
                t_l_s8 <= t_l_s7;
                reciprocal_length_n208_s8 <= reciprocal_length_n208;
                recip_root_row <= recip_root_rom(to_integer(reciprocal_length_recip_root_n216));
                reciprocal_length_recip_root_n219_s8 <= reciprocal_length_recip_root_n219;
                reciprocal_length_n226_s8 <= reciprocal_length_n226_s7;
                b_l_s8 <= b_l_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n217 <= recip_root_row(38 downto 16);
    reciprocal_length_recip_root_n218 <= signed(recip_root_row(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n220 <= resize(reciprocal_length_recip_root_n218_s9 * signed('0' & reciprocal_length_recip_root_n219_s9), 27);
    reciprocal_length_recip_root_n221 <= signed(shift_left(resize(reciprocal_length_recip_root_n217_s9, 36), 11)) + resize(reciprocal_length_recip_root_n220, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s10 <= s0_s9;
                t0_s10 <= t0_s9;
                l_block_n103_s10 <= l_block_n103_s9;
                t_l_s10 <= t_l_s9;
                reciprocal_length_n208_s10 <= reciprocal_length_n208_s9;
                reciprocal_length_recip_root_n221_s10 <= reciprocal_length_recip_root_n221;
                reciprocal_length_n226_s10 <= reciprocal_length_n226_s9;
                b_l_s10 <= b_l_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n222_sum <= resize(reciprocal_length_recip_root_n221_s10, 37) + 37x"0000001000";
    reciprocal_length_recip_root_n222_cut <= reciprocal_length_recip_root_n222_sum(36 downto 13);
    reciprocal_length_recip_root_n222_over <= "1" when reciprocal_length_recip_root_n222_cut(23) = '0' and (or reciprocal_length_recip_root_n222_cut(22 downto 22)) = '1' else "0";
    reciprocal_length_recip_root_n222_under <= unsigned(reciprocal_length_recip_root_n222_cut(23 downto 23));
    reciprocal_length_recip_root_n222 <= 22x"3fffff" when reciprocal_length_recip_root_n222_over(0) = '1' else 22x"000000" when reciprocal_length_recip_root_n222_under(0) = '1' else unsigned(reciprocal_length_recip_root_n222_cut(21 downto 0));
    -- reciprocal_length
    reciprocal_length_n223_past <= "1" when 4x"b" < reciprocal_length_n208_s10 else "0";
    reciprocal_length_n223_count <= 4x"b" when reciprocal_length_n223_past(0) = '1' else reciprocal_length_n208_s10;
    reciprocal_length_n223 <= shift_left(resize(reciprocal_length_recip_root_n222, 33), to_integer(reciprocal_length_n223_count));
    reciprocal_length_n224 <= reciprocal_length_n223;
    reciprocal_length_n227 <= shift_left(resize(reciprocal_length_n225, 33), 23) when reciprocal_length_n226_s10(0) = '1' else reciprocal_length_n224;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s11 <= s0_s10;
                t0_s11 <= t0_s10;
                l_block_n103_s11 <= l_block_n103_s10;
                t_l_s11 <= t_l_s10;
                reciprocal_length_n227_s11 <= reciprocal_length_n227;
                b_l_s11 <= b_l_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- reciprocal_length
    reciprocal_length_reciprocal_length_sum <= resize(reciprocal_length_n227_s11, 34) + 34x"000000004";
    reciprocal_length_reciprocal_length_cut <= reciprocal_length_reciprocal_length_sum(33 downto 3);
    reciprocal_length_reciprocal_length_over <= "1" when (or reciprocal_length_reciprocal_length_cut(30 downto 20)) = '1' else "0";
    reciprocal_length_reciprocal_length <= 20x"fffff" when reciprocal_length_reciprocal_length_over(0) = '1' else reciprocal_length_reciprocal_length_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s12 <= s0_s11;
                t0_s12 <= t0_s11;
                l_block_n103_s12 <= l_block_n103_s11;
                t_l_s12 <= t_l_s11;
                reciprocal_length_reciprocal_length_s12 <= reciprocal_length_reciprocal_length;
                b_l_s12 <= b_l_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    ds_product <= resize(t_l_s12 * signed('0' & reciprocal_length_reciprocal_length_s12), 52);
    dt_product <= resize(b_l_s12 * signed('0' & reciprocal_length_reciprocal_length_s12), 52);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s13 <= s0_s12;
                t0_s13 <= t0_s12;
                l_block_n103_s13 <= l_block_n103_s12;
                ds_product_s13 <= ds_product;
                dt_product_s13 <= dt_product;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    ds_next_sum <= resize(ds_product_s13, 53) + 53x"00000000080000";
    ds_next_cut <= ds_next_sum(52 downto 20);
    ds_next_over <= "1" when ds_next_cut(32) = '0' and (or ds_next_cut(31 downto 26)) = '1' else "0";
    ds_next_under <= "1" when ds_next_cut(32) = '1' and (and ds_next_cut(31 downto 26)) = '0' else "0";
    ds_next <= 27x"3ffffff" when ds_next_over(0) = '1' else 27x"4000000" when ds_next_under(0) = '1' else ds_next_cut(26 downto 0);
    s1_sum <= resize(s0_s13, 28) + resize(ds_next, 28);
    s1_next_over <= "1" when s1_sum(27) = '0' and (or s1_sum(26 downto 24)) = '1' else "0";
    s1_next_under <= "1" when s1_sum(27) = '1' and (and s1_sum(26 downto 24)) = '0' else "0";
    s1_next <= 25x"0ffffff" when s1_next_over(0) = '1' else 25x"1000000" when s1_next_under(0) = '1' else s1_sum(24 downto 0);
    dt_next_sum <= resize(dt_product_s13, 53) + 53x"00000000080000";
    dt_next_cut <= dt_next_sum(52 downto 20);
    dt_next_over <= "1" when dt_next_cut(32) = '0' and (or dt_next_cut(31 downto 26)) = '1' else "0";
    dt_next_under <= "1" when dt_next_cut(32) = '1' and (and dt_next_cut(31 downto 26)) = '0' else "0";
    dt_next <= 27x"3ffffff" when dt_next_over(0) = '1' else 27x"4000000" when dt_next_under(0) = '1' else dt_next_cut(26 downto 0);
    t1_sum <= resize(t0_s13, 28) + resize(dt_next, 28);
    t1_next_over <= "1" when t1_sum(27) = '0' and (or t1_sum(26 downto 24)) = '1' else "0";
    t1_next_under <= "1" when t1_sum(27) = '1' and (and t1_sum(26 downto 24)) = '0' else "0";
    t1_next <= 25x"0ffffff" when t1_next_over(0) = '1' else 25x"1000000" when t1_next_under(0) = '1' else t1_sum(24 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                degenerate <= l_block_n103_s13;
                ds <= ds_next;
                s1 <= s1_next;
                dt <= dt_next;
                t1 <= t1_next;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----

    valid_out <= valid_s14;
end architecture;
