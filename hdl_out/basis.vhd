-- basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
-- made by fixpath 0.1.0; seed 002 (GL_NV_texgen_emboss), section 2.10.4
--   component_bits=16 guard_bits=0 norm_bits=18 dot_frac_bits=20 root_scheme=linear
--   root_addr_bits=9 root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 17 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   t_angle: mean 2.57e-5 rad, largest seen 9.63e-5 rad at normal_x=8380 normal_y=9641 normal_z=-7349 ct_x=13930 ct_y=3067 ct_z=4821
--   t_dot: mean 3.53e-5, largest seen 9.39e-5 at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
--   t_x: mean 1.77e-5, largest seen 7.84e-5 (1.3 ulp) at normal_x=9018 normal_y=13214 normal_z=12085 ct_x=-15544 ct_y=-6937 ct_z=8164
--   t_y: mean 1.77e-5, largest seen 7.49e-5 (1.2 ulp) at normal_x=-17534 normal_y=-897 normal_z=-9433 ct_x=8013 ct_y=-16499 ct_z=5940
--   t_z: mean 1.78e-5, largest seen 7.66e-5 (1.3 ulp) at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
--   bn_angle: mean 2.32e-5 rad, largest seen 5.60e-5 rad at normal_x=-10642 normal_y=-5666 normal_z=-5953 ct_x=1726 ct_y=-1464 ct_z=13894
--   bn_dot: mean 2.95e-5, largest seen 5.63e-5 at normal_x=-3329 normal_y=13424 normal_z=8156 ct_x=-4182 ct_y=-3328 ct_z=18276
--   bn_x: mean 1.53e-5, largest seen 3.77e-5 (0.6 ulp) at normal_x=-15816 normal_y=-754 normal_z=-9817 ct_x=-2394 ct_y=16948 ct_z=5363
--   bn_y: mean 1.53e-5, largest seen 3.75e-5 (0.6 ulp) at normal_x=16418 normal_y=-5802 normal_z=-2767 ct_x=-7596 ct_y=-14180 ct_z=-5075
--   bn_z: mean 1.54e-5, largest seen 3.67e-5 (0.6 ulp) at normal_x=4888 normal_y=-14943 normal_z=10350 ct_x=-4569 ct_y=10830 ct_z=11114
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152
-- stated bound on each binormal: 8.03e-5
-- stated bound on each tangent: 3.31e-4
-- stated bound on each flag: 0.00e0
-- renamed, since a language or another word has the name:
--   bn_x is bn_x_2
--   bn_y is bn_y_2
--   bn_z is bn_z_2
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity basis is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        normal_x : in signed(15 downto 0); -- s16f14
        normal_y : in signed(15 downto 0); -- s16f14
        normal_z : in signed(15 downto 0); -- s16f14
        ct_x : in signed(15 downto 0); -- s16f14
        ct_y : in signed(15 downto 0); -- s16f14
        ct_z : in signed(15 downto 0); -- s16f14
        valid_out : out std_logic;
        t_x : out signed(16 downto 0) := (others => '0'); -- s17f14
        t_y : out signed(16 downto 0) := (others => '0'); -- s17f14
        t_z : out signed(16 downto 0) := (others => '0'); -- s17f14
        bn_x : out signed(15 downto 0) := (others => '0'); -- s16f14
        bn_y : out signed(15 downto 0) := (others => '0'); -- s16f14
        bn_z : out signed(15 downto 0) := (others => '0'); -- s16f14
        degenerate : out unsigned(0 downto 0) := (others => '0') -- u1f0
    );
end entity;

architecture rtl of basis is
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

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal n_cross_ct_n6 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n7 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n9 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n10 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n12 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n13 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_n24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n29 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n35 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal bn_n41 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal bn_n47 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_n53 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n174 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n189 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal normal_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal n_cross_ct_n6_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n7_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n9_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n10_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n12_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n13_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal valid_s1 : std_logic;
    -- stage 1
    signal n_cross_ct_n8 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal n_cross_ct_n11 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal n_cross_ct_n14 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal bn_n15_neg : unsigned(32 downto 0) := (others => '0');
    signal bn_n15 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n16 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n17_neg : unsigned(32 downto 0) := (others => '0');
    signal bn_n17 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n18 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n19_neg : unsigned(32 downto 0) := (others => '0');
    signal bn_n19 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n20 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n21 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n22 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_largest : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n25 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n26 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n28 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n30 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n64 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n65 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n66 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n68 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n69 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n93 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n94 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n95 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n96 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n97 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n116 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n117 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n118 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n119 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n120 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal normal_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_largest_s2 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n25_s2 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n26_s2 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n30_s2 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n66_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n69_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n95_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n97_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n118_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n120_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal bn_n27 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n31 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n32 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal bn_n33 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n34 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal bn_n36 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n37 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n38 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal bn_n39 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n40 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal bn_n42 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n58 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n59 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal bn_n63 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n37_s3 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n39_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n42_s3 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n59_s3 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal bn_n63_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n66_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n69_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n95_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n97_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n118_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n120_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal bn_n43 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n44 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_n45 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n46 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal bn_n48 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n49 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n50 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n51 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n52 : unsigned(30 downto 0) := (others => '0'); -- u31f0
    signal bn_n54 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n55 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n56 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n57 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n60 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_n61 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal bn_places : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal bn_n67 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n70 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n71 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n72 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_n73 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n74 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n75 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n76 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal bn_n77 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n79 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n83 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n87 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n98 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n99 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_n100 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n101 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n102 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal bn_n103 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n121 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n122 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_n123 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n124 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n125 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal bn_n126 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal normal_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n74_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n75_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n77_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n79_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n83_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n87_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n101_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n103_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n124_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n126_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal bn_n78 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n80 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal bn_n81 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n82 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n84 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n85 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n86 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n88 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n89 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n90 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n91 : signed(33 downto 0) := (others => '0'); -- s34f0
    signal bn_x_2 : signed(33 downto 0) := (others => '0'); -- s34f33
    signal bn_n104 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n105 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal bn_n106 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n107 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n108 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n109 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n110 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n111 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n112 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n113 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n114 : signed(33 downto 0) := (others => '0'); -- s34f0
    signal bn_y_2 : signed(33 downto 0) := (others => '0'); -- s34f33
    signal bn_n127 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n128 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal bn_n129 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n130 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n131 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n132 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n133 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n134 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n135 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n136 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n137 : signed(33 downto 0) := (others => '0'); -- s34f0
    signal bn_z_2 : signed(33 downto 0) := (others => '0'); -- s34f33
    signal bn_norm_x_sum : signed(34 downto 0) := (others => '0');
    signal bn_norm_x_cut : signed(18 downto 0) := (others => '0');
    signal bn_norm_x_over : unsigned(0 downto 0) := (others => '0');
    signal bn_norm_x : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_sum : signed(34 downto 0) := (others => '0');
    signal bn_norm_y_cut : signed(18 downto 0) := (others => '0');
    signal bn_norm_y_over : unsigned(0 downto 0) := (others => '0');
    signal bn_norm_y : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_sum : signed(34 downto 0) := (others => '0');
    signal bn_norm_z_cut : signed(18 downto 0) := (others => '0');
    signal bn_norm_z_over : unsigned(0 downto 0) := (others => '0');
    signal bn_norm_z : signed(17 downto 0) := (others => '0'); -- s18f17
    signal normal_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal valid_s5 : std_logic;
    -- stage 5
    signal bn_square_n142 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n143 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n144 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal normal_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_square_n142_s6 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n143_s6 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n144_s6 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal valid_s6 : std_logic;
    -- stage 6
    signal bn_square_n145 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal bn_square_n146 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal normal_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_square_n146_s7 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal valid_s7 : std_logic;
    -- stage 7
    signal bn_length_square_sum : signed(38 downto 0) := (others => '0');
    signal bn_length_square_cut : signed(24 downto 0) := (others => '0');
    signal bn_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal bn_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal bn_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal bn_length_n148 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n149 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n150 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal bn_length_n151 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n152 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal bn_length_n153 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n154 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n155 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal bn_length_n156 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n157 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal bn_length_n158 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n170 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n190 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n154_s8 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n156_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n158_s8 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n170_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n190_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal bn_length_n159 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n160 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_n161 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n162 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_length_n163 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n164 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n165 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n166 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n167 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal bn_length_n168 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n169 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n171 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal bn_length_n172 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_n173 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n175 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal bn_length_n176 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n177 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_length_n178 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal bn_length_n179 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal bn_length_recip_root_n180 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal bn_length_recip_root_n183 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal normal_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n172_s9 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row : unsigned(38 downto 0) := (others => '0');
    signal bn_length_recip_root_n183_s9 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal bn_length_n190_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal bn_length_recip_root_n181 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal bn_length_recip_root_n182 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal normal_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n172_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_recip_root_n181_s10 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal bn_length_recip_root_n182_s10 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal bn_length_recip_root_n183_s10 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal bn_length_n190_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s10 : std_logic;
    -- stage 10
    signal bn_length_recip_root_n184 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal bn_length_recip_root_n185 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal normal_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n172_s11 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_recip_root_n185_s11 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal bn_length_n190_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s11 : std_logic;
    -- stage 11
    signal bn_length_recip_root_n186_sum : signed(36 downto 0) := (others => '0');
    signal bn_length_recip_root_n186_cut : signed(23 downto 0) := (others => '0');
    signal bn_length_recip_root_n186_over : unsigned(0 downto 0) := (others => '0');
    signal bn_length_recip_root_n186_under : unsigned(0 downto 0) := (others => '0');
    signal bn_length_recip_root_n186 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal bn_length_n187_past : unsigned(0 downto 0) := (others => '0');
    signal bn_length_n187_count : unsigned(3 downto 0) := (others => '0');
    signal bn_length_n187 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal bn_length_n188 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal bn_length_n191 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal normal_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n191_s12 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal valid_s12 : std_logic;
    -- stage 12
    signal bn_length_bn_length_sum : unsigned(33 downto 0) := (others => '0');
    signal bn_length_bn_length_cut : unsigned(30 downto 0) := (others => '0');
    signal bn_length_bn_length_over : unsigned(0 downto 0) := (others => '0');
    signal bn_length_bn_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal normal_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_bn_length_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal valid_s13 : std_logic;
    -- stage 13
    signal n193 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n195 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n197 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal normal_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n193_s14 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n195_s14 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n197_s14 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal valid_s14 : std_logic;
    -- stage 14
    signal bn_unit_x_sum : signed(38 downto 0) := (others => '0');
    signal bn_unit_x_cut : signed(17 downto 0) := (others => '0');
    signal bn_unit_x_over : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_x_under : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_x : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_unit_y_sum : signed(38 downto 0) := (others => '0');
    signal bn_unit_y_cut : signed(17 downto 0) := (others => '0');
    signal bn_unit_y_over : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_y_under : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_y : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_unit_z_sum : signed(38 downto 0) := (others => '0');
    signal bn_unit_z_cut : signed(17 downto 0) := (others => '0');
    signal bn_unit_z_over : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_z_under : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_z : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_n63_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_unit_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_unit_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_unit_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal valid_s15 : std_logic;
    -- stage 15
    signal bn_cross_n_n199 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n200 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n202 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n203 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n205 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n206 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_n63_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_unit_x_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_unit_y_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_unit_z_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal bn_cross_n_n199_s16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n200_s16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n202_s16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n203_s16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n205_s16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_cross_n_n206_s16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal valid_s16 : std_logic;
    -- stage 16
    signal bn_cross_n_n201 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal bn_cross_n_n204 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal bn_cross_n_n207 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal n208_sum : signed(33 downto 0) := (others => '0');
    signal n208_cut : signed(19 downto 0) := (others => '0');
    signal n208 : signed(19 downto 0) := (others => '0'); -- s20f14
    signal n209_sum : signed(33 downto 0) := (others => '0');
    signal n209_cut : signed(19 downto 0) := (others => '0');
    signal n209 : signed(19 downto 0) := (others => '0'); -- s20f14
    signal n210_sum : signed(33 downto 0) := (others => '0');
    signal n210_cut : signed(19 downto 0) := (others => '0');
    signal n210 : signed(19 downto 0) := (others => '0'); -- s20f14
    signal n211_over : unsigned(0 downto 0) := (others => '0');
    signal n211_under : unsigned(0 downto 0) := (others => '0');
    signal n211 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal n212_over : unsigned(0 downto 0) := (others => '0');
    signal n212_under : unsigned(0 downto 0) := (others => '0');
    signal n212 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal n213_over : unsigned(0 downto 0) := (others => '0');
    signal n213_under : unsigned(0 downto 0) := (others => '0');
    signal n213 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal valid_s17 : std_logic;
begin

    -- ---- stage 0 ----
    -- n_cross_ct
    n_cross_ct_n6 <= normal_y * ct_z;
    n_cross_ct_n7 <= normal_z * ct_y;
    n_cross_ct_n9 <= normal_z * ct_x;
    n_cross_ct_n10 <= normal_x * ct_z;
    n_cross_ct_n12 <= normal_x * ct_y;
    n_cross_ct_n13 <= normal_y * ct_x;
    -- bn
    bn_n24 <= "0";
    bn_n29 <= 32x"00000000";
    bn_n35 <= 16x"0000";
    bn_n41 <= 8x"00";
    bn_n47 <= 4x"0";
    bn_n53 <= "00";
    -- bn_length
    bn_length_n174 <= "1";
    bn_length_n189 <= "1";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s1 <= normal_x;
                normal_y_s1 <= normal_y;
                normal_z_s1 <= normal_z;
                n_cross_ct_n6_s1 <= n_cross_ct_n6;
                n_cross_ct_n7_s1 <= n_cross_ct_n7;
                n_cross_ct_n9_s1 <= n_cross_ct_n9;
                n_cross_ct_n10_s1 <= n_cross_ct_n10;
                n_cross_ct_n12_s1 <= n_cross_ct_n12;
                n_cross_ct_n13_s1 <= n_cross_ct_n13;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- n_cross_ct
    n_cross_ct_n8 <= resize(n_cross_ct_n6_s1, 33) - resize(n_cross_ct_n7_s1, 33);
    n_cross_ct_n11 <= resize(n_cross_ct_n9_s1, 33) - resize(n_cross_ct_n10_s1, 33);
    n_cross_ct_n14 <= resize(n_cross_ct_n12_s1, 33) - resize(n_cross_ct_n13_s1, 33);
    -- bn
    bn_n15_neg <= unsigned(-n_cross_ct_n8);
    bn_n15 <= bn_n15_neg when n_cross_ct_n8(32) = '1' else unsigned(n_cross_ct_n8);
    bn_n16 <= bn_n15;
    bn_n17_neg <= unsigned(-n_cross_ct_n11);
    bn_n17 <= bn_n17_neg when n_cross_ct_n11(32) = '1' else unsigned(n_cross_ct_n11);
    bn_n18 <= bn_n17;
    bn_n19_neg <= unsigned(-n_cross_ct_n14);
    bn_n19 <= bn_n19_neg when n_cross_ct_n14(32) = '1' else unsigned(n_cross_ct_n14);
    bn_n20 <= bn_n19;
    bn_n21 <= bn_n16 or bn_n18;
    bn_n22 <= bn_n21 or bn_n20;
    bn_largest <= bn_n22;
    bn_n25 <= bn_largest;
    bn_n26 <= bn_n25(32 downto 1);
    bn_n28 <= bn_n25(0 downto 0);
    bn_n30 <= bn_n28 & bn_n29;
    bn_n64 <= unsigned(n_cross_ct_n8(32 downto 32));
    bn_n65 <= unsigned(n_cross_ct_n8);
    bn_n66 <= bn_n64 & bn_n65;
    bn_n68 <= bn_n66(1 downto 0);
    bn_n69 <= bn_n68 & bn_n29;
    bn_n93 <= unsigned(n_cross_ct_n11(32 downto 32));
    bn_n94 <= unsigned(n_cross_ct_n11);
    bn_n95 <= bn_n93 & bn_n94;
    bn_n96 <= bn_n95(1 downto 0);
    bn_n97 <= bn_n96 & bn_n29;
    bn_n116 <= unsigned(n_cross_ct_n14(32 downto 32));
    bn_n117 <= unsigned(n_cross_ct_n14);
    bn_n118 <= bn_n116 & bn_n117;
    bn_n119 <= bn_n118(1 downto 0);
    bn_n120 <= bn_n119 & bn_n29;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s2 <= normal_x_s1;
                normal_y_s2 <= normal_y_s1;
                normal_z_s2 <= normal_z_s1;
                bn_largest_s2 <= bn_largest;
                bn_n25_s2 <= bn_n25;
                bn_n26_s2 <= bn_n26;
                bn_n30_s2 <= bn_n30;
                bn_n66_s2 <= bn_n66;
                bn_n69_s2 <= bn_n69;
                bn_n95_s2 <= bn_n95;
                bn_n97_s2 <= bn_n97;
                bn_n118_s2 <= bn_n118;
                bn_n120_s2 <= bn_n120;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- bn
    bn_n27 <= "1" when bn_n26_s2 = resize(bn_n24, 32) else "0";
    bn_n31 <= bn_n30_s2 when bn_n27(0) = '1' else bn_n25_s2;
    bn_n32 <= bn_n31(32 downto 17);
    bn_n33 <= "1" when bn_n32 = resize(bn_n24, 16) else "0";
    bn_n34 <= bn_n31(16 downto 0);
    bn_n36 <= bn_n34 & bn_n35;
    bn_n37 <= bn_n36 when bn_n33(0) = '1' else bn_n31;
    bn_n38 <= bn_n37(32 downto 25);
    bn_n39 <= "1" when bn_n38 = resize(bn_n24, 8) else "0";
    bn_n40 <= bn_n37(24 downto 0);
    bn_n42 <= bn_n40 & bn_n41;
    bn_n58 <= bn_n27 & bn_n33;
    bn_n59 <= bn_n58 & bn_n39;
    bn_n63 <= "1" when bn_largest_s2 = shift_left(resize(bn_n24, 33), 28) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s3 <= normal_x_s2;
                normal_y_s3 <= normal_y_s2;
                normal_z_s3 <= normal_z_s2;
                bn_n37_s3 <= bn_n37;
                bn_n39_s3 <= bn_n39;
                bn_n42_s3 <= bn_n42;
                bn_n59_s3 <= bn_n59;
                bn_n63_s3 <= bn_n63;
                bn_n66_s3 <= bn_n66_s2;
                bn_n69_s3 <= bn_n69_s2;
                bn_n95_s3 <= bn_n95_s2;
                bn_n97_s3 <= bn_n97_s2;
                bn_n118_s3 <= bn_n118_s2;
                bn_n120_s3 <= bn_n120_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- bn
    bn_n43 <= bn_n42_s3 when bn_n39_s3(0) = '1' else bn_n37_s3;
    bn_n44 <= bn_n43(32 downto 29);
    bn_n45 <= "1" when bn_n44 = resize(bn_n24, 4) else "0";
    bn_n46 <= bn_n43(28 downto 0);
    bn_n48 <= bn_n46 & bn_n47;
    bn_n49 <= bn_n48 when bn_n45(0) = '1' else bn_n43;
    bn_n50 <= bn_n49(32 downto 31);
    bn_n51 <= "1" when bn_n50 = resize(bn_n24, 2) else "0";
    bn_n52 <= bn_n49(30 downto 0);
    bn_n54 <= bn_n52 & bn_n53;
    bn_n55 <= bn_n54 when bn_n51(0) = '1' else bn_n49;
    bn_n56 <= bn_n55(32 downto 32);
    bn_n57 <= "1" when bn_n56 = bn_n24 else "0";
    bn_n60 <= bn_n59_s3 & bn_n45;
    bn_n61 <= bn_n60 & bn_n51;
    bn_places <= bn_n61 & bn_n57;
    bn_n67 <= bn_places(5 downto 5);
    bn_n70 <= bn_n69_s3 when bn_n67(0) = '1' else bn_n66_s3;
    bn_n71 <= bn_places(4 downto 4);
    bn_n72 <= bn_n70(17 downto 0);
    bn_n73 <= bn_n72 & bn_n35;
    bn_n74 <= bn_n73 when bn_n71(0) = '1' else bn_n70;
    bn_n75 <= bn_places(3 downto 3);
    bn_n76 <= bn_n74(25 downto 0);
    bn_n77 <= bn_n76 & bn_n41;
    bn_n79 <= bn_places(2 downto 2);
    bn_n83 <= bn_places(1 downto 1);
    bn_n87 <= bn_places(0 downto 0);
    bn_n98 <= bn_n97_s3 when bn_n67(0) = '1' else bn_n95_s3;
    bn_n99 <= bn_n98(17 downto 0);
    bn_n100 <= bn_n99 & bn_n35;
    bn_n101 <= bn_n100 when bn_n71(0) = '1' else bn_n98;
    bn_n102 <= bn_n101(25 downto 0);
    bn_n103 <= bn_n102 & bn_n41;
    bn_n121 <= bn_n120_s3 when bn_n67(0) = '1' else bn_n118_s3;
    bn_n122 <= bn_n121(17 downto 0);
    bn_n123 <= bn_n122 & bn_n35;
    bn_n124 <= bn_n123 when bn_n71(0) = '1' else bn_n121;
    bn_n125 <= bn_n124(25 downto 0);
    bn_n126 <= bn_n125 & bn_n41;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s4 <= normal_x_s3;
                normal_y_s4 <= normal_y_s3;
                normal_z_s4 <= normal_z_s3;
                bn_n63_s4 <= bn_n63_s3;
                bn_n74_s4 <= bn_n74;
                bn_n75_s4 <= bn_n75;
                bn_n77_s4 <= bn_n77;
                bn_n79_s4 <= bn_n79;
                bn_n83_s4 <= bn_n83;
                bn_n87_s4 <= bn_n87;
                bn_n101_s4 <= bn_n101;
                bn_n103_s4 <= bn_n103;
                bn_n124_s4 <= bn_n124;
                bn_n126_s4 <= bn_n126;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- bn
    bn_n78 <= bn_n77_s4 when bn_n75_s4(0) = '1' else bn_n74_s4;
    bn_n80 <= bn_n78(29 downto 0);
    bn_n81 <= bn_n80 & bn_n47;
    bn_n82 <= bn_n81 when bn_n79_s4(0) = '1' else bn_n78;
    bn_n84 <= bn_n82(31 downto 0);
    bn_n85 <= bn_n84 & bn_n53;
    bn_n86 <= bn_n85 when bn_n83_s4(0) = '1' else bn_n82;
    bn_n88 <= bn_n86(32 downto 0);
    bn_n89 <= bn_n88 & bn_n24;
    bn_n90 <= bn_n89 when bn_n87_s4(0) = '1' else bn_n86;
    bn_n91 <= signed(bn_n90);
    bn_x_2 <= bn_n91;
    bn_n104 <= bn_n103_s4 when bn_n75_s4(0) = '1' else bn_n101_s4;
    bn_n105 <= bn_n104(29 downto 0);
    bn_n106 <= bn_n105 & bn_n47;
    bn_n107 <= bn_n106 when bn_n79_s4(0) = '1' else bn_n104;
    bn_n108 <= bn_n107(31 downto 0);
    bn_n109 <= bn_n108 & bn_n53;
    bn_n110 <= bn_n109 when bn_n83_s4(0) = '1' else bn_n107;
    bn_n111 <= bn_n110(32 downto 0);
    bn_n112 <= bn_n111 & bn_n24;
    bn_n113 <= bn_n112 when bn_n87_s4(0) = '1' else bn_n110;
    bn_n114 <= signed(bn_n113);
    bn_y_2 <= bn_n114;
    bn_n127 <= bn_n126_s4 when bn_n75_s4(0) = '1' else bn_n124_s4;
    bn_n128 <= bn_n127(29 downto 0);
    bn_n129 <= bn_n128 & bn_n47;
    bn_n130 <= bn_n129 when bn_n79_s4(0) = '1' else bn_n127;
    bn_n131 <= bn_n130(31 downto 0);
    bn_n132 <= bn_n131 & bn_n53;
    bn_n133 <= bn_n132 when bn_n83_s4(0) = '1' else bn_n130;
    bn_n134 <= bn_n133(32 downto 0);
    bn_n135 <= bn_n134 & bn_n24;
    bn_n136 <= bn_n135 when bn_n87_s4(0) = '1' else bn_n133;
    bn_n137 <= signed(bn_n136);
    bn_z_2 <= bn_n137;
    -- (unit)
    bn_norm_x_sum <= resize(bn_x_2, 35) + 35x"000008000";
    bn_norm_x_cut <= bn_norm_x_sum(34 downto 16);
    bn_norm_x_over <= "1" when bn_norm_x_cut(18) = '0' and (or bn_norm_x_cut(17 downto 17)) = '1' else "0";
    bn_norm_x <= 18x"1ffff" when bn_norm_x_over(0) = '1' else bn_norm_x_cut(17 downto 0);
    bn_norm_y_sum <= resize(bn_y_2, 35) + 35x"000008000";
    bn_norm_y_cut <= bn_norm_y_sum(34 downto 16);
    bn_norm_y_over <= "1" when bn_norm_y_cut(18) = '0' and (or bn_norm_y_cut(17 downto 17)) = '1' else "0";
    bn_norm_y <= 18x"1ffff" when bn_norm_y_over(0) = '1' else bn_norm_y_cut(17 downto 0);
    bn_norm_z_sum <= resize(bn_z_2, 35) + 35x"000008000";
    bn_norm_z_cut <= bn_norm_z_sum(34 downto 16);
    bn_norm_z_over <= "1" when bn_norm_z_cut(18) = '0' and (or bn_norm_z_cut(17 downto 17)) = '1' else "0";
    bn_norm_z <= 18x"1ffff" when bn_norm_z_over(0) = '1' else bn_norm_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s5 <= normal_x_s4;
                normal_y_s5 <= normal_y_s4;
                normal_z_s5 <= normal_z_s4;
                bn_n63_s5 <= bn_n63_s4;
                bn_norm_x_s5 <= bn_norm_x;
                bn_norm_y_s5 <= bn_norm_y;
                bn_norm_z_s5 <= bn_norm_z;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- bn_square
    bn_square_n142 <= bn_norm_x_s5 * bn_norm_x_s5;
    bn_square_n143 <= bn_norm_y_s5 * bn_norm_y_s5;
    bn_square_n144 <= bn_norm_z_s5 * bn_norm_z_s5;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s6 <= normal_x_s5;
                normal_y_s6 <= normal_y_s5;
                normal_z_s6 <= normal_z_s5;
                bn_n63_s6 <= bn_n63_s5;
                bn_norm_x_s6 <= bn_norm_x_s5;
                bn_norm_y_s6 <= bn_norm_y_s5;
                bn_norm_z_s6 <= bn_norm_z_s5;
                bn_square_n142_s6 <= bn_square_n142;
                bn_square_n143_s6 <= bn_square_n143;
                bn_square_n144_s6 <= bn_square_n144;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- bn_square
    bn_square_n145 <= resize(bn_square_n142_s6, 37) + resize(bn_square_n143_s6, 37);
    bn_square_n146 <= resize(bn_square_n145, 38) + resize(bn_square_n144_s6, 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s7 <= normal_x_s6;
                normal_y_s7 <= normal_y_s6;
                normal_z_s7 <= normal_z_s6;
                bn_n63_s7 <= bn_n63_s6;
                bn_norm_x_s7 <= bn_norm_x_s6;
                bn_norm_y_s7 <= bn_norm_y_s6;
                bn_norm_z_s7 <= bn_norm_z_s6;
                bn_square_n146_s7 <= bn_square_n146;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    bn_length_square_sum <= resize(bn_square_n146_s7, 39) + 39x"0000002000";
    bn_length_square_cut <= bn_length_square_sum(38 downto 14);
    bn_length_square_over <= "1" when bn_length_square_cut(24) = '0' and (or bn_length_square_cut(23 downto 22)) = '1' else "0";
    bn_length_square_under <= unsigned(bn_length_square_cut(24 downto 24));
    bn_length_square <= 22x"3fffff" when bn_length_square_over(0) = '1' else 22x"000000" when bn_length_square_under(0) = '1' else unsigned(bn_length_square_cut(21 downto 0));
    -- bn_length
    bn_length_n148 <= bn_length_square;
    bn_length_n149 <= bn_length_n148;
    bn_length_n150 <= bn_length_n149(21 downto 6);
    bn_length_n151 <= "1" when bn_length_n150 = resize(bn_n24, 16) else "0";
    bn_length_n152 <= bn_length_n149(5 downto 0);
    bn_length_n153 <= bn_length_n152 & bn_n35;
    bn_length_n154 <= bn_length_n153 when bn_length_n151(0) = '1' else bn_length_n149;
    bn_length_n155 <= bn_length_n154(21 downto 14);
    bn_length_n156 <= "1" when bn_length_n155 = resize(bn_n24, 8) else "0";
    bn_length_n157 <= bn_length_n154(13 downto 0);
    bn_length_n158 <= bn_length_n157 & bn_n41;
    bn_length_n170 <= bn_length_n151 & bn_length_n156;
    bn_length_n190 <= "1" when bn_length_square = shift_left(resize(bn_n24, 22), 20) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s8 <= normal_x_s7;
                normal_y_s8 <= normal_y_s7;
                normal_z_s8 <= normal_z_s7;
                bn_n63_s8 <= bn_n63_s7;
                bn_norm_x_s8 <= bn_norm_x_s7;
                bn_norm_y_s8 <= bn_norm_y_s7;
                bn_norm_z_s8 <= bn_norm_z_s7;
                bn_length_n154_s8 <= bn_length_n154;
                bn_length_n156_s8 <= bn_length_n156;
                bn_length_n158_s8 <= bn_length_n158;
                bn_length_n170_s8 <= bn_length_n170;
                bn_length_n190_s8 <= bn_length_n190;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- bn_length
    bn_length_n159 <= bn_length_n158_s8 when bn_length_n156_s8(0) = '1' else bn_length_n154_s8;
    bn_length_n160 <= bn_length_n159(21 downto 18);
    bn_length_n161 <= "1" when bn_length_n160 = resize(bn_n24, 4) else "0";
    bn_length_n162 <= bn_length_n159(17 downto 0);
    bn_length_n163 <= bn_length_n162 & bn_n47;
    bn_length_n164 <= bn_length_n163 when bn_length_n161(0) = '1' else bn_length_n159;
    bn_length_n165 <= bn_length_n164(21 downto 20);
    bn_length_n166 <= "1" when bn_length_n165 = resize(bn_n24, 2) else "0";
    bn_length_n167 <= bn_length_n164(19 downto 0);
    bn_length_n168 <= bn_length_n167 & bn_n53;
    bn_length_n169 <= bn_length_n168 when bn_length_n166(0) = '1' else bn_length_n164;
    bn_length_n171 <= bn_length_n170_s8 & bn_length_n161;
    bn_length_n172 <= bn_length_n171 & bn_length_n166;
    bn_length_n173 <= bn_length_n169(21 downto 20);
    bn_length_n175 <= signed(resize(bn_length_n173, 3)) - signed(resize(bn_length_n174, 3));
    bn_length_n176 <= unsigned(bn_length_n175(1 downto 0));
    bn_length_n177 <= bn_length_n169(19 downto 2);
    bn_length_n178 <= bn_length_n176 & bn_length_n177;
    bn_length_n179 <= bn_length_n178;
    -- bn_length.recip_root
    bn_length_recip_root_n180 <= bn_length_n179(19 downto 11);
    bn_length_recip_root_n183 <= bn_length_n179(10 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s9 <= normal_x_s8;
                normal_y_s9 <= normal_y_s8;
                normal_z_s9 <= normal_z_s8;
                bn_n63_s9 <= bn_n63_s8;
                bn_norm_x_s9 <= bn_norm_x_s8;
                bn_norm_y_s9 <= bn_norm_y_s8;
                bn_norm_z_s9 <= bn_norm_z_s8;
                bn_length_n172_s9 <= bn_length_n172;
                recip_root_row <= recip_root_rom(to_integer(bn_length_recip_root_n180));
                bn_length_recip_root_n183_s9 <= bn_length_recip_root_n183;
                bn_length_n190_s9 <= bn_length_n190_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- bn_length.recip_root
    bn_length_recip_root_n181 <= recip_root_row(38 downto 16);
    bn_length_recip_root_n182 <= signed(recip_root_row(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s10 <= normal_x_s9;
                normal_y_s10 <= normal_y_s9;
                normal_z_s10 <= normal_z_s9;
                bn_n63_s10 <= bn_n63_s9;
                bn_norm_x_s10 <= bn_norm_x_s9;
                bn_norm_y_s10 <= bn_norm_y_s9;
                bn_norm_z_s10 <= bn_norm_z_s9;
                bn_length_n172_s10 <= bn_length_n172_s9;
                bn_length_recip_root_n181_s10 <= bn_length_recip_root_n181;
                bn_length_recip_root_n182_s10 <= bn_length_recip_root_n182;
                bn_length_recip_root_n183_s10 <= bn_length_recip_root_n183_s9;
                bn_length_n190_s10 <= bn_length_n190_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- bn_length.recip_root
    bn_length_recip_root_n184 <= resize(bn_length_recip_root_n182_s10 * signed('0' & bn_length_recip_root_n183_s10), 27);
    bn_length_recip_root_n185 <= signed(shift_left(resize(bn_length_recip_root_n181_s10, 36), 11)) + resize(bn_length_recip_root_n184, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s11 <= normal_x_s10;
                normal_y_s11 <= normal_y_s10;
                normal_z_s11 <= normal_z_s10;
                bn_n63_s11 <= bn_n63_s10;
                bn_norm_x_s11 <= bn_norm_x_s10;
                bn_norm_y_s11 <= bn_norm_y_s10;
                bn_norm_z_s11 <= bn_norm_z_s10;
                bn_length_n172_s11 <= bn_length_n172_s10;
                bn_length_recip_root_n185_s11 <= bn_length_recip_root_n185;
                bn_length_n190_s11 <= bn_length_n190_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- bn_length.recip_root
    bn_length_recip_root_n186_sum <= resize(bn_length_recip_root_n185_s11, 37) + 37x"0000001000";
    bn_length_recip_root_n186_cut <= bn_length_recip_root_n186_sum(36 downto 13);
    bn_length_recip_root_n186_over <= "1" when bn_length_recip_root_n186_cut(23) = '0' and (or bn_length_recip_root_n186_cut(22 downto 22)) = '1' else "0";
    bn_length_recip_root_n186_under <= unsigned(bn_length_recip_root_n186_cut(23 downto 23));
    bn_length_recip_root_n186 <= 22x"3fffff" when bn_length_recip_root_n186_over(0) = '1' else 22x"000000" when bn_length_recip_root_n186_under(0) = '1' else unsigned(bn_length_recip_root_n186_cut(21 downto 0));
    -- bn_length
    bn_length_n187_past <= "1" when 4x"b" < bn_length_n172_s11 else "0";
    bn_length_n187_count <= 4x"b" when bn_length_n187_past(0) = '1' else bn_length_n172_s11;
    bn_length_n187 <= shift_left(resize(bn_length_recip_root_n186, 33), to_integer(bn_length_n187_count));
    bn_length_n188 <= bn_length_n187;
    bn_length_n191 <= shift_left(resize(bn_length_n189, 33), 23) when bn_length_n190_s11(0) = '1' else bn_length_n188;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s12 <= normal_x_s11;
                normal_y_s12 <= normal_y_s11;
                normal_z_s12 <= normal_z_s11;
                bn_n63_s12 <= bn_n63_s11;
                bn_norm_x_s12 <= bn_norm_x_s11;
                bn_norm_y_s12 <= bn_norm_y_s11;
                bn_norm_z_s12 <= bn_norm_z_s11;
                bn_length_n191_s12 <= bn_length_n191;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- bn_length
    bn_length_bn_length_sum <= resize(bn_length_n191_s12, 34) + 34x"000000004";
    bn_length_bn_length_cut <= bn_length_bn_length_sum(33 downto 3);
    bn_length_bn_length_over <= "1" when (or bn_length_bn_length_cut(30 downto 20)) = '1' else "0";
    bn_length_bn_length <= 20x"fffff" when bn_length_bn_length_over(0) = '1' else bn_length_bn_length_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s13 <= normal_x_s12;
                normal_y_s13 <= normal_y_s12;
                normal_z_s13 <= normal_z_s12;
                bn_n63_s13 <= bn_n63_s12;
                bn_norm_x_s13 <= bn_norm_x_s12;
                bn_norm_y_s13 <= bn_norm_y_s12;
                bn_norm_z_s13 <= bn_norm_z_s12;
                bn_length_bn_length_s13 <= bn_length_bn_length;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    n193 <= resize(bn_norm_x_s13 * signed('0' & bn_length_bn_length_s13), 38);
    n195 <= resize(bn_norm_y_s13 * signed('0' & bn_length_bn_length_s13), 38);
    n197 <= resize(bn_norm_z_s13 * signed('0' & bn_length_bn_length_s13), 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s14 <= normal_x_s13;
                normal_y_s14 <= normal_y_s13;
                normal_z_s14 <= normal_z_s13;
                bn_n63_s14 <= bn_n63_s13;
                n193_s14 <= n193;
                n195_s14 <= n195;
                n197_s14 <= n197;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    bn_unit_x_sum <= resize(n193_s14, 39) + 39x"0000100000";
    bn_unit_x_cut <= bn_unit_x_sum(38 downto 21);
    bn_unit_x_over <= "1" when bn_unit_x_cut(17) = '0' and (or bn_unit_x_cut(16 downto 15)) = '1' else "0";
    bn_unit_x_under <= "1" when bn_unit_x_cut(17) = '1' and (and bn_unit_x_cut(16 downto 15)) = '0' else "0";
    bn_unit_x <= 16x"7fff" when bn_unit_x_over(0) = '1' else 16x"8000" when bn_unit_x_under(0) = '1' else bn_unit_x_cut(15 downto 0);
    bn_unit_y_sum <= resize(n195_s14, 39) + 39x"0000100000";
    bn_unit_y_cut <= bn_unit_y_sum(38 downto 21);
    bn_unit_y_over <= "1" when bn_unit_y_cut(17) = '0' and (or bn_unit_y_cut(16 downto 15)) = '1' else "0";
    bn_unit_y_under <= "1" when bn_unit_y_cut(17) = '1' and (and bn_unit_y_cut(16 downto 15)) = '0' else "0";
    bn_unit_y <= 16x"7fff" when bn_unit_y_over(0) = '1' else 16x"8000" when bn_unit_y_under(0) = '1' else bn_unit_y_cut(15 downto 0);
    bn_unit_z_sum <= resize(n197_s14, 39) + 39x"0000100000";
    bn_unit_z_cut <= bn_unit_z_sum(38 downto 21);
    bn_unit_z_over <= "1" when bn_unit_z_cut(17) = '0' and (or bn_unit_z_cut(16 downto 15)) = '1' else "0";
    bn_unit_z_under <= "1" when bn_unit_z_cut(17) = '1' and (and bn_unit_z_cut(16 downto 15)) = '0' else "0";
    bn_unit_z <= 16x"7fff" when bn_unit_z_over(0) = '1' else 16x"8000" when bn_unit_z_under(0) = '1' else bn_unit_z_cut(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s15 <= normal_x_s14;
                normal_y_s15 <= normal_y_s14;
                normal_z_s15 <= normal_z_s14;
                bn_n63_s15 <= bn_n63_s14;
                bn_unit_x_s15 <= bn_unit_x;
                bn_unit_y_s15 <= bn_unit_y;
                bn_unit_z_s15 <= bn_unit_z;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- bn_cross_n
    bn_cross_n_n199 <= bn_unit_y_s15 * normal_z_s15;
    bn_cross_n_n200 <= bn_unit_z_s15 * normal_y_s15;
    bn_cross_n_n202 <= bn_unit_z_s15 * normal_x_s15;
    bn_cross_n_n203 <= bn_unit_x_s15 * normal_z_s15;
    bn_cross_n_n205 <= bn_unit_x_s15 * normal_y_s15;
    bn_cross_n_n206 <= bn_unit_y_s15 * normal_x_s15;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                bn_n63_s16 <= bn_n63_s15;
                bn_unit_x_s16 <= bn_unit_x_s15;
                bn_unit_y_s16 <= bn_unit_y_s15;
                bn_unit_z_s16 <= bn_unit_z_s15;
                bn_cross_n_n199_s16 <= bn_cross_n_n199;
                bn_cross_n_n200_s16 <= bn_cross_n_n200;
                bn_cross_n_n202_s16 <= bn_cross_n_n202;
                bn_cross_n_n203_s16 <= bn_cross_n_n203;
                bn_cross_n_n205_s16 <= bn_cross_n_n205;
                bn_cross_n_n206_s16 <= bn_cross_n_n206;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- bn_cross_n
    bn_cross_n_n201 <= resize(bn_cross_n_n199_s16, 33) - resize(bn_cross_n_n200_s16, 33);
    bn_cross_n_n204 <= resize(bn_cross_n_n202_s16, 33) - resize(bn_cross_n_n203_s16, 33);
    bn_cross_n_n207 <= resize(bn_cross_n_n205_s16, 33) - resize(bn_cross_n_n206_s16, 33);
    -- (unit)
    n208_sum <= resize(bn_cross_n_n201, 34) + 34x"000002000";
    n208_cut <= n208_sum(33 downto 14);
    n208 <= n208_cut;
    n209_sum <= resize(bn_cross_n_n204, 34) + 34x"000002000";
    n209_cut <= n209_sum(33 downto 14);
    n209 <= n209_cut;
    n210_sum <= resize(bn_cross_n_n207, 34) + 34x"000002000";
    n210_cut <= n210_sum(33 downto 14);
    n210 <= n210_cut;
    n211_over <= "1" when n208(19) = '0' and (or n208(18 downto 16)) = '1' else "0";
    n211_under <= "1" when n208(19) = '1' and (and n208(18 downto 16)) = '0' else "0";
    n211 <= 17x"0ffff" when n211_over(0) = '1' else 17x"10000" when n211_under(0) = '1' else n208(16 downto 0);
    n212_over <= "1" when n209(19) = '0' and (or n209(18 downto 16)) = '1' else "0";
    n212_under <= "1" when n209(19) = '1' and (and n209(18 downto 16)) = '0' else "0";
    n212 <= 17x"0ffff" when n212_over(0) = '1' else 17x"10000" when n212_under(0) = '1' else n209(16 downto 0);
    n213_over <= "1" when n210(19) = '0' and (or n210(18 downto 16)) = '1' else "0";
    n213_under <= "1" when n210(19) = '1' and (and n210(18 downto 16)) = '0' else "0";
    n213 <= 17x"0ffff" when n213_over(0) = '1' else 17x"10000" when n213_under(0) = '1' else n210(16 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                degenerate <= bn_n63_s16;
                bn_x <= bn_unit_x_s16;
                bn_y <= bn_unit_y_s16;
                bn_z <= bn_unit_z_s16;
                t_x <= n211;
                t_y <= n212;
                t_z <= n213;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----

    valid_out <= valid_s17;
end architecture;
