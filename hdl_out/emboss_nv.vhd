-- emboss: texture coordinates displaced by the direction of a light, for embossing
-- made by fixpath 0.1.0; seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)
--   setting=nv frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
--   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
--   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
--   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
--   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
--   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
--   rom=block
-- latency 25 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   ds_texels: mean 8.34e-4 texel, largest seen 6.81e-3 texel at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
--   ds_relative: mean 2.65e-6, largest seen 1.57e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=16750 normal_y=-6938 normal_z=100 ct_x=370 ct_y=-1703 ct_z=18454 light_x=-21858093 light_y=11862104 light_z=22208289 vertex_x=-20247618 vertex_y=12204548 vertex_z=17798660 s0=2324101 t0=-917458 q0=289204 r0=140514
--   ds: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
--   dt_texels: mean 7.78e-4 texel, largest seen 6.34e-3 texel at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
--   dt_relative: mean 2.48e-6, largest seen 1.69e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=539 normal_y=10101 normal_z=11796 ct_x=-4134 ct_y=-13685 ct_z=9001 light_x=-16348031 light_y=19544902 light_z=11919376 vertex_x=-16890033 vertex_y=19483858 vertex_z=11791741 s0=601665 t0=-1430898 q0=258948 r0=-148469
--   dt: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
--   s1: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
--   t1: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
--   q1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
--   r1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
-- stated bound on each relative displacement (over the vector's length times its factor, each 1/4 where it is less): 1.09e-4
-- stated bound on each displacement: 1.32e-2
-- stated bound on each displacement in texels: 3.38e0
-- stated bound on each coordinate: 1.32e-2
-- stated bound on each flag and what is passed: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity emboss_nv is
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
        light_x : in signed(27 downto 0); -- s28f15
        light_y : in signed(27 downto 0); -- s28f15
        light_z : in signed(27 downto 0); -- s28f15
        vertex_x : in signed(27 downto 0); -- s28f15
        vertex_y : in signed(27 downto 0); -- s28f15
        vertex_z : in signed(27 downto 0); -- s28f15
        s0 : in signed(24 downto 0); -- s25f18
        t0 : in signed(24 downto 0); -- s25f18
        q0 : in signed(24 downto 0); -- s25f18
        r0 : in signed(24 downto 0); -- s25f18
        valid_out : out std_logic;
        ds : out signed(29 downto 0) := (others => '0'); -- s30f18
        dt : out signed(33 downto 0) := (others => '0'); -- s34f18
        s1 : out signed(24 downto 0) := (others => '0'); -- s25f18
        t1 : out signed(24 downto 0) := (others => '0'); -- s25f18
        degenerate : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        q1 : out signed(24 downto 0) := (others => '0'); -- s25f18
        r1 : out signed(24 downto 0) := (others => '0') -- s25f18
    );
end entity;

architecture rtl of emboss_nv is
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
    signal n_cross_ct_n16 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n17 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n19 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n20 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n22 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n23 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal bn_n34 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n39 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n45 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal bn_n51 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal bn_n57 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_n63 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n184 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n199 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal l_x : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_y : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_z : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_block_n224_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n224 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n225 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n226_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n226 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n227 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n228_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n228 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n229 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n230 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n231 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_largest : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n233 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n234 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n236 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal l_block_n237 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n261 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n262 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n263 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n265 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n266 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n286 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n287 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n288 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n289 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n290 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n306 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n307 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n308 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n309 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n310 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal n392 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal n393 : signed(46 downto 0) := (others => '0'); -- s47f38
    signal normal_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal n_cross_ct_n16_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n17_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n19_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n20_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n22_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal n_cross_ct_n23_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal l_block_largest_s1 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n233_s1 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n234_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n237_s1 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n263_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n266_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n288_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n290_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n308_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n310_s1 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal n393_s1 : signed(46 downto 0) := (others => '0'); -- s47f38
    signal valid_s1 : std_logic;
    -- stage 1
    signal n_cross_ct_n18 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal n_cross_ct_n21 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal n_cross_ct_n24 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal bn_n25_neg : unsigned(32 downto 0) := (others => '0');
    signal bn_n25 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n26 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n27_neg : unsigned(32 downto 0) := (others => '0');
    signal bn_n27 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n28 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n29_neg : unsigned(32 downto 0) := (others => '0');
    signal bn_n29 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n30 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n31 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n32 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_largest : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n35 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n36 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n38 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n40 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n74 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n75 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n76 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n78 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n79 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n103 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n104 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n105 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n106 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n107 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n126 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n127 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n128 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n129 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n130 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal l_block_n235 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n238 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n239 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal l_block_n240 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n241 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal l_block_n242 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n243 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n244 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal l_block_n245 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n246 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal l_block_n247 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n248 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n249 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n251 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal l_block_n252 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n256 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n257 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal l_block_n260 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal ks_q_sum : signed(47 downto 0) := (others => '0');
    signal ks_q_cut : signed(29 downto 0) := (others => '0');
    signal ks_q : signed(29 downto 0) := (others => '0'); -- s30f20
    signal normal_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s2 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s2 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s2 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s2 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_largest_s2 : unsigned(32 downto 0) := (others => '0'); -- u33f28
    signal bn_n35_s2 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n36_s2 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n40_s2 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n76_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n79_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n105_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n107_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n128_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n130_s2 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal l_block_n248_s2 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n249_s2 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n252_s2 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n257_s2 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal l_block_n260_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n263_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n266_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n288_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n290_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n308_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n310_s2 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal ks_q_s2 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal valid_s2 : std_logic;
    -- stage 2
    signal bn_n37 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n41 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n42 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal bn_n43 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n44 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal bn_n46 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n47 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n48 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal bn_n49 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n50 : unsigned(24 downto 0) := (others => '0'); -- u25f0
    signal bn_n52 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n68 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n69 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal bn_n73 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n250 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n253 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n254 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n255 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n258 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal l_block_places : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal l_block_n264 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n267 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n268 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n269 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal l_block_n270 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n271 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n272 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n273 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal l_block_n274 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n275 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n276 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n277 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal l_block_n278 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n279 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n280 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n281 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n282 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n283 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n284 : signed(29 downto 0) := (others => '0'); -- s30f0
    signal l_block_x : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_n291 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n292 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal l_block_n293 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n294 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n295 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal l_block_n296 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n297 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n298 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal l_block_n299 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n300 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n301 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n302 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n303 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n304 : signed(29 downto 0) := (others => '0'); -- s30f0
    signal l_block_y : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_n311 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n312 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal l_block_n313 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n314 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n315 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal l_block_n316 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n317 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n318 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal l_block_n319 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n320 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n321 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n322 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n323 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n324 : signed(29 downto 0) := (others => '0'); -- s30f0
    signal l_block_z : signed(29 downto 0) := (others => '0'); -- s30f29
    signal n406 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s3 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s3 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s3 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s3 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_n47_s3 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n49_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n52_s3 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n69_s3 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal bn_n76_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n79_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n105_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n107_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n128_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n130_s3 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal l_block_x_s3 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_y_s3 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_z_s3 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal ks_q_s3 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal bn_n53 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n54 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_n55 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n56 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal bn_n58 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n59 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n60 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_n61 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n62 : unsigned(30 downto 0) := (others => '0'); -- u31f0
    signal bn_n64 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n65 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n66 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n67 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n70 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_n71 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal bn_places : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal bn_n77 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n80 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n81 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n82 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_n83 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n84 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n85 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n86 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal bn_n87 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n89 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n93 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n97 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n108 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n109 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_n110 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n111 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n112 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal bn_n113 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n131 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n132 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_n133 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n134 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n135 : unsigned(25 downto 0) := (others => '0'); -- u26f0
    signal bn_n136 : unsigned(33 downto 0) := (others => '0'); -- u34f0
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
    signal normal_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s4 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s4 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s4 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s4 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_n84_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n85_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n87_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n89_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n93_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n97_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_n111_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n113_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n134_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n136_s4 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal l_norm_x_s4 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s4 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s4 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal ks_q_s4 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal bn_n88 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n90 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal bn_n91 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n92 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n94 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n95 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n96 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n98 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n99 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n100 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n101 : signed(33 downto 0) := (others => '0'); -- s34f0
    signal bn_x : signed(33 downto 0) := (others => '0'); -- s34f33
    signal bn_n114 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n115 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal bn_n116 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n117 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n118 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n119 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n120 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n121 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n122 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n123 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n124 : signed(33 downto 0) := (others => '0'); -- s34f0
    signal bn_y : signed(33 downto 0) := (others => '0'); -- s34f33
    signal bn_n137 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n138 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal bn_n139 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n140 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n141 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal bn_n142 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n143 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n144 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal bn_n145 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n146 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal bn_n147 : signed(33 downto 0) := (others => '0'); -- s34f0
    signal bn_z : signed(33 downto 0) := (others => '0'); -- s34f33
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
    signal l_dot_l_n335 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n336 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n337 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal normal_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s5 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s5 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s5 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s5 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_x_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s5 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_dot_l_n335_s5 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n336_s5 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n337_s5 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal ks_q_s5 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s5 : std_logic;
    -- stage 5
    signal bn_square_n152 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n153 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n154 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_dot_l_n338 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal l_dot_l_n339 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal normal_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s6 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s6 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s6 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s6 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_square_n152_s6 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n153_s6 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal bn_square_n154_s6 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal l_norm_x_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_dot_l_n339_s6 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal ks_q_s6 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s6 : std_logic;
    -- stage 6
    signal bn_square_n155 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal bn_square_n156 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal reciprocal_length_square_sum : signed(38 downto 0) := (others => '0');
    signal reciprocal_length_square_cut : signed(24 downto 0) := (others => '0');
    signal reciprocal_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_length_n341 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n342 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n343 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal reciprocal_length_n344 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n345 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal reciprocal_length_n346 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n347 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n348 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal reciprocal_length_n349 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n350 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal reciprocal_length_n351 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n363 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n381 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s7 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s7 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s7 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s7 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_square_n156_s7 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal l_norm_x_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_n347_s7 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n349_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n351_s7 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n363_s7 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n381_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal ks_q_s7 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal bn_length_square_sum : signed(38 downto 0) := (others => '0');
    signal bn_length_square_cut : signed(24 downto 0) := (others => '0');
    signal bn_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal bn_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal bn_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal bn_length_n158 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n159 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n160 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal bn_length_n161 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n162 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal bn_length_n163 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n164 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n165 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal bn_length_n166 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n167 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal bn_length_n168 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n180 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n200 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n352 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n353 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_n354 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n355 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal reciprocal_length_n356 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n357 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n358 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n359 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n360 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_length_n361 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n362 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal reciprocal_length_n364 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal reciprocal_length_n365 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_n366 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n367 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal reciprocal_length_n368 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n369 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal reciprocal_length_n370 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_length_n371 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal reciprocal_length_recip_root_n372 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal reciprocal_length_recip_root_n375 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal normal_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s8 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s8 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s8 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s8 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n164_s8 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n166_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n168_s8 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n180_s8 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n200_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_norm_x_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_n365_s8 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row : unsigned(38 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n375_s8 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_length_n381_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal ks_q_s8 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal bn_length_n169 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n170 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_n171 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n172 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_length_n173 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n174 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n175 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n176 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bn_length_n177 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal bn_length_n178 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n179 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal bn_length_n181 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal bn_length_n182 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_n183 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n185 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal bn_length_n186 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal bn_length_n187 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal bn_length_n188 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal bn_length_n189 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal bn_length_recip_root_n190 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal bn_length_recip_root_n193 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_length_recip_root_n373 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal reciprocal_length_recip_root_n374 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal normal_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n182_s9 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row_2 : unsigned(38 downto 0) := (others => '0');
    signal bn_length_recip_root_n193_s9 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal bn_length_n200_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_norm_x_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_n365_s9 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_recip_root_n373_s9 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal reciprocal_length_recip_root_n374_s9 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal reciprocal_length_recip_root_n375_s9 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_length_n381_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal ks_q_s9 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal bn_length_recip_root_n191 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal bn_length_recip_root_n192 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal reciprocal_length_recip_root_n376 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal reciprocal_length_recip_root_n377 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal normal_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s10 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s10 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s10 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s10 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n182_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_recip_root_n191_s10 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal bn_length_recip_root_n192_s10 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal bn_length_recip_root_n193_s10 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal bn_length_n200_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_norm_x_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_n365_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_length_recip_root_n377_s10 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal reciprocal_length_n381_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal ks_q_s10 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s10 : std_logic;
    -- stage 10
    signal bn_length_recip_root_n194 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal bn_length_recip_root_n195 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal reciprocal_length_recip_root_n378_sum : signed(36 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n378_cut : signed(23 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n378_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n378_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_recip_root_n378 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_length_n379_past : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_n379_count : unsigned(3 downto 0) := (others => '0');
    signal reciprocal_length_n379 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal reciprocal_length_n380 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal reciprocal_length_n382 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal normal_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s11 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s11 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s11 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s11 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n182_s11 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal bn_length_recip_root_n195_s11 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal bn_length_n200_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_norm_x_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_n382_s11 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal ks_q_s11 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s11 : std_logic;
    -- stage 11
    signal bn_length_recip_root_n196_sum : signed(36 downto 0) := (others => '0');
    signal bn_length_recip_root_n196_cut : signed(23 downto 0) := (others => '0');
    signal bn_length_recip_root_n196_over : unsigned(0 downto 0) := (others => '0');
    signal bn_length_recip_root_n196_under : unsigned(0 downto 0) := (others => '0');
    signal bn_length_recip_root_n196 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal bn_length_n197_past : unsigned(0 downto 0) := (others => '0');
    signal bn_length_n197_count : unsigned(3 downto 0) := (others => '0');
    signal bn_length_n197 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal bn_length_n198 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal bn_length_n201 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal reciprocal_length_reciprocal_length_sum : unsigned(33 downto 0) := (others => '0');
    signal reciprocal_length_reciprocal_length_cut : unsigned(30 downto 0) := (others => '0');
    signal reciprocal_length_reciprocal_length_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_reciprocal_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal normal_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s12 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s12 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s12 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s12 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_n201_s12 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal l_norm_x_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_reciprocal_length_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ks_q_s12 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s12 : std_logic;
    -- stage 12
    signal bn_length_bn_length_sum : unsigned(33 downto 0) := (others => '0');
    signal bn_length_bn_length_cut : unsigned(30 downto 0) := (others => '0');
    signal bn_length_bn_length_over : unsigned(0 downto 0) := (others => '0');
    signal bn_length_bn_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal normal_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s13 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s13 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s13 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s13 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal bn_length_bn_length_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal l_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_reciprocal_length_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ks_q_s13 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s13 : std_logic;
    -- stage 13
    signal n203 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n205 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n207 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal normal_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s14 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s14 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s14 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s14 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal n203_s14 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n205_s14 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal n207_s14 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal l_norm_x_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_reciprocal_length_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ks_q_s14 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s14 : std_logic;
    -- stage 14
    signal bn_unit_x_sum : signed(38 downto 0) := (others => '0');
    signal bn_unit_x_cut : signed(21 downto 0) := (others => '0');
    signal bn_unit_x_over : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_x_under : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal bn_unit_y_sum : signed(38 downto 0) := (others => '0');
    signal bn_unit_y_cut : signed(21 downto 0) := (others => '0');
    signal bn_unit_y_over : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_y_under : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal bn_unit_z_sum : signed(38 downto 0) := (others => '0');
    signal bn_unit_z_cut : signed(21 downto 0) := (others => '0');
    signal bn_unit_z_over : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_z_under : unsigned(0 downto 0) := (others => '0');
    signal bn_unit_z : signed(19 downto 0) := (others => '0'); -- s20f18
    signal normal_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal s0_s15 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s15 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s15 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s15 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_unit_x_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal bn_unit_y_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal bn_unit_z_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal l_norm_x_s15 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s15 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s15 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_reciprocal_length_s15 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ks_q_s15 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s15 : std_logic;
    -- stage 15
    signal bn_cross_n_n209 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n210 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n212 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n213 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n215 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n216 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal b_dot_l_n384 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal b_dot_l_n385 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal b_dot_l_n386 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal s0_s16 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s16 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s16 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s16 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal bn_cross_n_n209_s16 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n210_s16 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n212_s16 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n213_s16 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n215_s16 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal bn_cross_n_n216_s16 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal l_norm_x_s16 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s16 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s16 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_reciprocal_length_s16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal b_dot_l_n384_s16 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal b_dot_l_n385_s16 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal b_dot_l_n386_s16 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal ks_q_s16 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s16 : std_logic;
    -- stage 16
    signal bn_cross_n_n211 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal bn_cross_n_n214 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal bn_cross_n_n217 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal n218_sum : signed(37 downto 0) := (others => '0');
    signal n218_cut : signed(23 downto 0) := (others => '0');
    signal n218 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal n219_sum : signed(37 downto 0) := (others => '0');
    signal n219_cut : signed(23 downto 0) := (others => '0');
    signal n219 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal n220_sum : signed(37 downto 0) := (others => '0');
    signal n220_cut : signed(23 downto 0) := (others => '0');
    signal n220 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal b_dot_l_n387 : signed(38 downto 0) := (others => '0'); -- s39f35
    signal b_dot_l_n388 : signed(39 downto 0) := (others => '0'); -- s40f35
    signal b_l_sum : signed(40 downto 0) := (others => '0');
    signal b_l_cut : signed(25 downto 0) := (others => '0');
    signal b_l : signed(25 downto 0) := (others => '0'); -- s26f20
    signal s0_s17 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s17 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s17 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s17 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal n218_s17 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal n219_s17 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal n220_s17 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal l_norm_x_s17 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s17 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s17 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal reciprocal_length_reciprocal_length_s17 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal b_l_s17 : signed(25 downto 0) := (others => '0'); -- s26f20
    signal ks_q_s17 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s17 : std_logic;
    -- stage 17
    signal t_dot_l_n329 : signed(41 downto 0) := (others => '0'); -- s42f35
    signal t_dot_l_n330 : signed(41 downto 0) := (others => '0'); -- s42f35
    signal t_dot_l_n331 : signed(41 downto 0) := (others => '0'); -- s42f35
    signal ds_product : signed(45 downto 0) := (others => '0'); -- s46f38
    signal s0_s18 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s18 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s18 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s18 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_dot_l_n329_s18 : signed(41 downto 0) := (others => '0'); -- s42f35
    signal t_dot_l_n330_s18 : signed(41 downto 0) := (others => '0'); -- s42f35
    signal t_dot_l_n331_s18 : signed(41 downto 0) := (others => '0'); -- s42f35
    signal reciprocal_length_reciprocal_length_s18 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ds_product_s18 : signed(45 downto 0) := (others => '0'); -- s46f38
    signal ks_q_s18 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s18 : std_logic;
    -- stage 18
    signal t_dot_l_n332 : signed(42 downto 0) := (others => '0'); -- s43f35
    signal t_dot_l_n333 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal ds_unit_sum : signed(46 downto 0) := (others => '0');
    signal ds_unit_cut : signed(28 downto 0) := (others => '0');
    signal ds_unit_over : unsigned(0 downto 0) := (others => '0');
    signal ds_unit_under : unsigned(0 downto 0) := (others => '0');
    signal ds_unit : signed(22 downto 0) := (others => '0'); -- s23f20
    signal s0_s19 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s19 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s19 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s19 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_dot_l_n333_s19 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal reciprocal_length_reciprocal_length_s19 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ds_unit_s19 : signed(22 downto 0) := (others => '0'); -- s23f20
    signal ks_q_s19 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n406_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s19 : std_logic;
    -- stage 19
    signal t_l_sum : signed(44 downto 0) := (others => '0');
    signal t_l_cut : signed(29 downto 0) := (others => '0');
    signal t_l : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n395 : signed(52 downto 0) := (others => '0'); -- s53f40
    signal s0_s20 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s20 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s20 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s20 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_l_s20 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal reciprocal_length_reciprocal_length_s20 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal ks_q_s20 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal n395_s20 : signed(52 downto 0) := (others => '0'); -- s53f40
    signal n406_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s20 : std_logic;
    -- stage 20
    signal ds_next_sum : signed(53 downto 0) := (others => '0');
    signal ds_next_cut : signed(31 downto 0) := (others => '0');
    signal ds_next_over : unsigned(0 downto 0) := (others => '0');
    signal ds_next_under : unsigned(0 downto 0) := (others => '0');
    signal ds_next : signed(29 downto 0) := (others => '0'); -- s30f18
    signal s1_sum : signed(30 downto 0) := (others => '0'); -- s31f18
    signal s1_next_over : unsigned(0 downto 0) := (others => '0');
    signal s1_next_under : unsigned(0 downto 0) := (others => '0');
    signal s1_next : signed(24 downto 0) := (others => '0'); -- s25f18
    signal dt_product : signed(49 downto 0) := (others => '0'); -- s50f38
    signal t0_s21 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s21 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s21 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal ks_q_s21 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal ds_next_s21 : signed(29 downto 0) := (others => '0'); -- s30f18
    signal s1_next_s21 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal dt_product_s21 : signed(49 downto 0) := (others => '0'); -- s50f38
    signal n406_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s21 : std_logic;
    -- stage 21
    signal dt_unit_sum : signed(50 downto 0) := (others => '0');
    signal dt_unit_cut : signed(32 downto 0) := (others => '0');
    signal dt_unit_over : unsigned(0 downto 0) := (others => '0');
    signal dt_unit_under : unsigned(0 downto 0) := (others => '0');
    signal dt_unit : signed(26 downto 0) := (others => '0'); -- s27f20
    signal t0_s22 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s22 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s22 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal ks_q_s22 : signed(29 downto 0) := (others => '0'); -- s30f20
    signal ds_next_s22 : signed(29 downto 0) := (others => '0'); -- s30f18
    signal s1_next_s22 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal dt_unit_s22 : signed(26 downto 0) := (others => '0'); -- s27f20
    signal n406_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s22 : std_logic;
    -- stage 22
    signal n401 : signed(56 downto 0) := (others => '0'); -- s57f40
    signal t0_s23 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s23 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s23 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal ds_next_s23 : signed(29 downto 0) := (others => '0'); -- s30f18
    signal s1_next_s23 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal n401_s23 : signed(56 downto 0) := (others => '0'); -- s57f40
    signal n406_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s23 : std_logic;
    -- stage 23
    signal n402 : signed(57 downto 0) := (others => '0'); -- s58f40
    signal dt_next_sum : signed(58 downto 0) := (others => '0');
    signal dt_next_cut : signed(36 downto 0) := (others => '0');
    signal dt_next_over : unsigned(0 downto 0) := (others => '0');
    signal dt_next_under : unsigned(0 downto 0) := (others => '0');
    signal dt_next : signed(33 downto 0) := (others => '0'); -- s34f18
    signal t0_s24 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal q0_s24 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal r0_s24 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal ds_next_s24 : signed(29 downto 0) := (others => '0'); -- s30f18
    signal s1_next_s24 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal dt_next_s24 : signed(33 downto 0) := (others => '0'); -- s34f18
    signal n406_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s24 : std_logic;
    -- stage 24
    signal t1_sum : signed(34 downto 0) := (others => '0'); -- s35f18
    signal t1_next_over : unsigned(0 downto 0) := (others => '0');
    signal t1_next_under : unsigned(0 downto 0) := (others => '0');
    signal t1_next : signed(24 downto 0) := (others => '0'); -- s25f18
    signal valid_s25 : std_logic;
begin

    -- ---- stage 0 ----
    -- n_cross_ct
    n_cross_ct_n16 <= normal_y * ct_z;
    n_cross_ct_n17 <= normal_z * ct_y;
    n_cross_ct_n19 <= normal_z * ct_x;
    n_cross_ct_n20 <= normal_x * ct_z;
    n_cross_ct_n22 <= normal_x * ct_y;
    n_cross_ct_n23 <= normal_y * ct_x;
    -- bn
    bn_n34 <= "0";
    bn_n39 <= 32x"00000000";
    bn_n45 <= 16x"0000";
    bn_n51 <= 8x"00";
    bn_n57 <= 4x"0";
    bn_n63 <= "00";
    -- bn_length
    bn_length_n184 <= "1";
    bn_length_n199 <= "1";
    -- (unit)
    l_x <= resize(light_x, 29) - resize(vertex_x, 29);
    l_y <= resize(light_y, 29) - resize(vertex_y, 29);
    l_z <= resize(light_z, 29) - resize(vertex_z, 29);
    -- l_block
    l_block_n224_neg <= unsigned(-l_x);
    l_block_n224 <= l_block_n224_neg when l_x(28) = '1' else unsigned(l_x);
    l_block_n225 <= l_block_n224;
    l_block_n226_neg <= unsigned(-l_y);
    l_block_n226 <= l_block_n226_neg when l_y(28) = '1' else unsigned(l_y);
    l_block_n227 <= l_block_n226;
    l_block_n228_neg <= unsigned(-l_z);
    l_block_n228 <= l_block_n228_neg when l_z(28) = '1' else unsigned(l_z);
    l_block_n229 <= l_block_n228;
    l_block_n230 <= l_block_n225 or l_block_n227;
    l_block_n231 <= l_block_n230 or l_block_n229;
    l_block_largest <= l_block_n231;
    l_block_n233 <= l_block_largest;
    l_block_n234 <= l_block_n233(28 downto 13);
    l_block_n236 <= l_block_n233(12 downto 0);
    l_block_n237 <= l_block_n236 & bn_n45;
    l_block_n261 <= unsigned(l_x(28 downto 28));
    l_block_n262 <= unsigned(l_x);
    l_block_n263 <= l_block_n261 & l_block_n262;
    l_block_n265 <= l_block_n263(13 downto 0);
    l_block_n266 <= l_block_n265 & bn_n45;
    l_block_n286 <= unsigned(l_y(28 downto 28));
    l_block_n287 <= unsigned(l_y);
    l_block_n288 <= l_block_n286 & l_block_n287;
    l_block_n289 <= l_block_n288(13 downto 0);
    l_block_n290 <= l_block_n289 & bn_n45;
    l_block_n306 <= unsigned(l_z(28 downto 28));
    l_block_n307 <= unsigned(l_z);
    l_block_n308 <= l_block_n306 & l_block_n307;
    l_block_n309 <= l_block_n308(13 downto 0);
    l_block_n310 <= l_block_n309 & bn_n45;
    -- (unit)
    n392 <= 22x"100000";
    n393 <= n392 * q0;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    n_cross_ct_n18 <= resize(n_cross_ct_n16_s1, 33) - resize(n_cross_ct_n17_s1, 33);
    n_cross_ct_n21 <= resize(n_cross_ct_n19_s1, 33) - resize(n_cross_ct_n20_s1, 33);
    n_cross_ct_n24 <= resize(n_cross_ct_n22_s1, 33) - resize(n_cross_ct_n23_s1, 33);
    -- bn
    bn_n25_neg <= unsigned(-n_cross_ct_n18);
    bn_n25 <= bn_n25_neg when n_cross_ct_n18(32) = '1' else unsigned(n_cross_ct_n18);
    bn_n26 <= bn_n25;
    bn_n27_neg <= unsigned(-n_cross_ct_n21);
    bn_n27 <= bn_n27_neg when n_cross_ct_n21(32) = '1' else unsigned(n_cross_ct_n21);
    bn_n28 <= bn_n27;
    bn_n29_neg <= unsigned(-n_cross_ct_n24);
    bn_n29 <= bn_n29_neg when n_cross_ct_n24(32) = '1' else unsigned(n_cross_ct_n24);
    bn_n30 <= bn_n29;
    bn_n31 <= bn_n26 or bn_n28;
    bn_n32 <= bn_n31 or bn_n30;
    bn_largest <= bn_n32;
    bn_n35 <= bn_largest;
    bn_n36 <= bn_n35(32 downto 1);
    bn_n38 <= bn_n35(0 downto 0);
    bn_n40 <= bn_n38 & bn_n39;
    bn_n74 <= unsigned(n_cross_ct_n18(32 downto 32));
    bn_n75 <= unsigned(n_cross_ct_n18);
    bn_n76 <= bn_n74 & bn_n75;
    bn_n78 <= bn_n76(1 downto 0);
    bn_n79 <= bn_n78 & bn_n39;
    bn_n103 <= unsigned(n_cross_ct_n21(32 downto 32));
    bn_n104 <= unsigned(n_cross_ct_n21);
    bn_n105 <= bn_n103 & bn_n104;
    bn_n106 <= bn_n105(1 downto 0);
    bn_n107 <= bn_n106 & bn_n39;
    bn_n126 <= unsigned(n_cross_ct_n24(32 downto 32));
    bn_n127 <= unsigned(n_cross_ct_n24);
    bn_n128 <= bn_n126 & bn_n127;
    bn_n129 <= bn_n128(1 downto 0);
    bn_n130 <= bn_n129 & bn_n39;
    -- l_block
    l_block_n235 <= "1" when l_block_n234_s1 = resize(bn_n34, 16) else "0";
    l_block_n238 <= l_block_n237_s1 when l_block_n235(0) = '1' else l_block_n233_s1;
    l_block_n239 <= l_block_n238(28 downto 21);
    l_block_n240 <= "1" when l_block_n239 = resize(bn_n34, 8) else "0";
    l_block_n241 <= l_block_n238(20 downto 0);
    l_block_n242 <= l_block_n241 & bn_n51;
    l_block_n243 <= l_block_n242 when l_block_n240(0) = '1' else l_block_n238;
    l_block_n244 <= l_block_n243(28 downto 25);
    l_block_n245 <= "1" when l_block_n244 = resize(bn_n34, 4) else "0";
    l_block_n246 <= l_block_n243(24 downto 0);
    l_block_n247 <= l_block_n246 & bn_n57;
    l_block_n248 <= l_block_n247 when l_block_n245(0) = '1' else l_block_n243;
    l_block_n249 <= l_block_n248(28 downto 27);
    l_block_n251 <= l_block_n248(26 downto 0);
    l_block_n252 <= l_block_n251 & bn_n63;
    l_block_n256 <= l_block_n235 & l_block_n240;
    l_block_n257 <= l_block_n256 & l_block_n245;
    l_block_n260 <= "1" when l_block_largest_s1 = shift_left(resize(bn_n34, 29), 15) else "0";
    -- (unit)
    ks_q_sum <= resize(n393_s1, 48) + 48x"000000020000";
    ks_q_cut <= ks_q_sum(47 downto 18);
    ks_q <= ks_q_cut;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_n37 <= "1" when bn_n36_s2 = resize(bn_n34, 32) else "0";
    bn_n41 <= bn_n40_s2 when bn_n37(0) = '1' else bn_n35_s2;
    bn_n42 <= bn_n41(32 downto 17);
    bn_n43 <= "1" when bn_n42 = resize(bn_n34, 16) else "0";
    bn_n44 <= bn_n41(16 downto 0);
    bn_n46 <= bn_n44 & bn_n45;
    bn_n47 <= bn_n46 when bn_n43(0) = '1' else bn_n41;
    bn_n48 <= bn_n47(32 downto 25);
    bn_n49 <= "1" when bn_n48 = resize(bn_n34, 8) else "0";
    bn_n50 <= bn_n47(24 downto 0);
    bn_n52 <= bn_n50 & bn_n51;
    bn_n68 <= bn_n37 & bn_n43;
    bn_n69 <= bn_n68 & bn_n49;
    bn_n73 <= "1" when bn_largest_s2 = shift_left(resize(bn_n34, 33), 28) else "0";
    -- l_block
    l_block_n250 <= "1" when l_block_n249_s2 = resize(bn_n34, 2) else "0";
    l_block_n253 <= l_block_n252_s2 when l_block_n250(0) = '1' else l_block_n248_s2;
    l_block_n254 <= l_block_n253(28 downto 28);
    l_block_n255 <= "1" when l_block_n254 = bn_n34 else "0";
    l_block_n258 <= l_block_n257_s2 & l_block_n250;
    l_block_places <= l_block_n258 & l_block_n255;
    l_block_n264 <= l_block_places(4 downto 4);
    l_block_n267 <= l_block_n266_s2 when l_block_n264(0) = '1' else l_block_n263_s2;
    l_block_n268 <= l_block_places(3 downto 3);
    l_block_n269 <= l_block_n267(21 downto 0);
    l_block_n270 <= l_block_n269 & bn_n51;
    l_block_n271 <= l_block_n270 when l_block_n268(0) = '1' else l_block_n267;
    l_block_n272 <= l_block_places(2 downto 2);
    l_block_n273 <= l_block_n271(25 downto 0);
    l_block_n274 <= l_block_n273 & bn_n57;
    l_block_n275 <= l_block_n274 when l_block_n272(0) = '1' else l_block_n271;
    l_block_n276 <= l_block_places(1 downto 1);
    l_block_n277 <= l_block_n275(27 downto 0);
    l_block_n278 <= l_block_n277 & bn_n63;
    l_block_n279 <= l_block_n278 when l_block_n276(0) = '1' else l_block_n275;
    l_block_n280 <= l_block_places(0 downto 0);
    l_block_n281 <= l_block_n279(28 downto 0);
    l_block_n282 <= l_block_n281 & bn_n34;
    l_block_n283 <= l_block_n282 when l_block_n280(0) = '1' else l_block_n279;
    l_block_n284 <= signed(l_block_n283);
    l_block_x <= l_block_n284;
    l_block_n291 <= l_block_n290_s2 when l_block_n264(0) = '1' else l_block_n288_s2;
    l_block_n292 <= l_block_n291(21 downto 0);
    l_block_n293 <= l_block_n292 & bn_n51;
    l_block_n294 <= l_block_n293 when l_block_n268(0) = '1' else l_block_n291;
    l_block_n295 <= l_block_n294(25 downto 0);
    l_block_n296 <= l_block_n295 & bn_n57;
    l_block_n297 <= l_block_n296 when l_block_n272(0) = '1' else l_block_n294;
    l_block_n298 <= l_block_n297(27 downto 0);
    l_block_n299 <= l_block_n298 & bn_n63;
    l_block_n300 <= l_block_n299 when l_block_n276(0) = '1' else l_block_n297;
    l_block_n301 <= l_block_n300(28 downto 0);
    l_block_n302 <= l_block_n301 & bn_n34;
    l_block_n303 <= l_block_n302 when l_block_n280(0) = '1' else l_block_n300;
    l_block_n304 <= signed(l_block_n303);
    l_block_y <= l_block_n304;
    l_block_n311 <= l_block_n310_s2 when l_block_n264(0) = '1' else l_block_n308_s2;
    l_block_n312 <= l_block_n311(21 downto 0);
    l_block_n313 <= l_block_n312 & bn_n51;
    l_block_n314 <= l_block_n313 when l_block_n268(0) = '1' else l_block_n311;
    l_block_n315 <= l_block_n314(25 downto 0);
    l_block_n316 <= l_block_n315 & bn_n57;
    l_block_n317 <= l_block_n316 when l_block_n272(0) = '1' else l_block_n314;
    l_block_n318 <= l_block_n317(27 downto 0);
    l_block_n319 <= l_block_n318 & bn_n63;
    l_block_n320 <= l_block_n319 when l_block_n276(0) = '1' else l_block_n317;
    l_block_n321 <= l_block_n320(28 downto 0);
    l_block_n322 <= l_block_n321 & bn_n34;
    l_block_n323 <= l_block_n322 when l_block_n280(0) = '1' else l_block_n320;
    l_block_n324 <= signed(l_block_n323);
    l_block_z <= l_block_n324;
    -- (unit)
    n406 <= l_block_n260_s2 or bn_n73;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_n53 <= bn_n52_s3 when bn_n49_s3(0) = '1' else bn_n47_s3;
    bn_n54 <= bn_n53(32 downto 29);
    bn_n55 <= "1" when bn_n54 = resize(bn_n34, 4) else "0";
    bn_n56 <= bn_n53(28 downto 0);
    bn_n58 <= bn_n56 & bn_n57;
    bn_n59 <= bn_n58 when bn_n55(0) = '1' else bn_n53;
    bn_n60 <= bn_n59(32 downto 31);
    bn_n61 <= "1" when bn_n60 = resize(bn_n34, 2) else "0";
    bn_n62 <= bn_n59(30 downto 0);
    bn_n64 <= bn_n62 & bn_n63;
    bn_n65 <= bn_n64 when bn_n61(0) = '1' else bn_n59;
    bn_n66 <= bn_n65(32 downto 32);
    bn_n67 <= "1" when bn_n66 = bn_n34 else "0";
    bn_n70 <= bn_n69_s3 & bn_n55;
    bn_n71 <= bn_n70 & bn_n61;
    bn_places <= bn_n71 & bn_n67;
    bn_n77 <= bn_places(5 downto 5);
    bn_n80 <= bn_n79_s3 when bn_n77(0) = '1' else bn_n76_s3;
    bn_n81 <= bn_places(4 downto 4);
    bn_n82 <= bn_n80(17 downto 0);
    bn_n83 <= bn_n82 & bn_n45;
    bn_n84 <= bn_n83 when bn_n81(0) = '1' else bn_n80;
    bn_n85 <= bn_places(3 downto 3);
    bn_n86 <= bn_n84(25 downto 0);
    bn_n87 <= bn_n86 & bn_n51;
    bn_n89 <= bn_places(2 downto 2);
    bn_n93 <= bn_places(1 downto 1);
    bn_n97 <= bn_places(0 downto 0);
    bn_n108 <= bn_n107_s3 when bn_n77(0) = '1' else bn_n105_s3;
    bn_n109 <= bn_n108(17 downto 0);
    bn_n110 <= bn_n109 & bn_n45;
    bn_n111 <= bn_n110 when bn_n81(0) = '1' else bn_n108;
    bn_n112 <= bn_n111(25 downto 0);
    bn_n113 <= bn_n112 & bn_n51;
    bn_n131 <= bn_n130_s3 when bn_n77(0) = '1' else bn_n128_s3;
    bn_n132 <= bn_n131(17 downto 0);
    bn_n133 <= bn_n132 & bn_n45;
    bn_n134 <= bn_n133 when bn_n81(0) = '1' else bn_n131;
    bn_n135 <= bn_n134(25 downto 0);
    bn_n136 <= bn_n135 & bn_n51;
    -- (unit)
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
    bn_n88 <= bn_n87_s4 when bn_n85_s4(0) = '1' else bn_n84_s4;
    bn_n90 <= bn_n88(29 downto 0);
    bn_n91 <= bn_n90 & bn_n57;
    bn_n92 <= bn_n91 when bn_n89_s4(0) = '1' else bn_n88;
    bn_n94 <= bn_n92(31 downto 0);
    bn_n95 <= bn_n94 & bn_n63;
    bn_n96 <= bn_n95 when bn_n93_s4(0) = '1' else bn_n92;
    bn_n98 <= bn_n96(32 downto 0);
    bn_n99 <= bn_n98 & bn_n34;
    bn_n100 <= bn_n99 when bn_n97_s4(0) = '1' else bn_n96;
    bn_n101 <= signed(bn_n100);
    bn_x <= bn_n101;
    bn_n114 <= bn_n113_s4 when bn_n85_s4(0) = '1' else bn_n111_s4;
    bn_n115 <= bn_n114(29 downto 0);
    bn_n116 <= bn_n115 & bn_n57;
    bn_n117 <= bn_n116 when bn_n89_s4(0) = '1' else bn_n114;
    bn_n118 <= bn_n117(31 downto 0);
    bn_n119 <= bn_n118 & bn_n63;
    bn_n120 <= bn_n119 when bn_n93_s4(0) = '1' else bn_n117;
    bn_n121 <= bn_n120(32 downto 0);
    bn_n122 <= bn_n121 & bn_n34;
    bn_n123 <= bn_n122 when bn_n97_s4(0) = '1' else bn_n120;
    bn_n124 <= signed(bn_n123);
    bn_y <= bn_n124;
    bn_n137 <= bn_n136_s4 when bn_n85_s4(0) = '1' else bn_n134_s4;
    bn_n138 <= bn_n137(29 downto 0);
    bn_n139 <= bn_n138 & bn_n57;
    bn_n140 <= bn_n139 when bn_n89_s4(0) = '1' else bn_n137;
    bn_n141 <= bn_n140(31 downto 0);
    bn_n142 <= bn_n141 & bn_n63;
    bn_n143 <= bn_n142 when bn_n93_s4(0) = '1' else bn_n140;
    bn_n144 <= bn_n143(32 downto 0);
    bn_n145 <= bn_n144 & bn_n34;
    bn_n146 <= bn_n145 when bn_n97_s4(0) = '1' else bn_n143;
    bn_n147 <= signed(bn_n146);
    bn_z <= bn_n147;
    -- (unit)
    bn_norm_x_sum <= resize(bn_x, 35) + 35x"000008000";
    bn_norm_x_cut <= bn_norm_x_sum(34 downto 16);
    bn_norm_x_over <= "1" when bn_norm_x_cut(18) = '0' and (or bn_norm_x_cut(17 downto 17)) = '1' else "0";
    bn_norm_x <= 18x"1ffff" when bn_norm_x_over(0) = '1' else bn_norm_x_cut(17 downto 0);
    bn_norm_y_sum <= resize(bn_y, 35) + 35x"000008000";
    bn_norm_y_cut <= bn_norm_y_sum(34 downto 16);
    bn_norm_y_over <= "1" when bn_norm_y_cut(18) = '0' and (or bn_norm_y_cut(17 downto 17)) = '1' else "0";
    bn_norm_y <= 18x"1ffff" when bn_norm_y_over(0) = '1' else bn_norm_y_cut(17 downto 0);
    bn_norm_z_sum <= resize(bn_z, 35) + 35x"000008000";
    bn_norm_z_cut <= bn_norm_z_sum(34 downto 16);
    bn_norm_z_over <= "1" when bn_norm_z_cut(18) = '0' and (or bn_norm_z_cut(17 downto 17)) = '1' else "0";
    bn_norm_z <= 18x"1ffff" when bn_norm_z_over(0) = '1' else bn_norm_z_cut(17 downto 0);
    -- l_dot_l
    l_dot_l_n335 <= l_norm_x_s4 * l_norm_x_s4;
    l_dot_l_n336 <= l_norm_y_s4 * l_norm_y_s4;
    l_dot_l_n337 <= l_norm_z_s4 * l_norm_z_s4;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_square_n152 <= bn_norm_x_s5 * bn_norm_x_s5;
    bn_square_n153 <= bn_norm_y_s5 * bn_norm_y_s5;
    bn_square_n154 <= bn_norm_z_s5 * bn_norm_z_s5;
    -- l_dot_l
    l_dot_l_n338 <= resize(l_dot_l_n335_s5, 37) + resize(l_dot_l_n336_s5, 37);
    l_dot_l_n339 <= resize(l_dot_l_n338, 38) + resize(l_dot_l_n337_s5, 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_square_n155 <= resize(bn_square_n152_s6, 37) + resize(bn_square_n153_s6, 37);
    bn_square_n156 <= resize(bn_square_n155, 38) + resize(bn_square_n154_s6, 38);
    -- (unit)
    reciprocal_length_square_sum <= resize(l_dot_l_n339_s6, 39) + 39x"0000002000";
    reciprocal_length_square_cut <= reciprocal_length_square_sum(38 downto 14);
    reciprocal_length_square_over <= "1" when reciprocal_length_square_cut(24) = '0' and (or reciprocal_length_square_cut(23 downto 22)) = '1' else "0";
    reciprocal_length_square_under <= unsigned(reciprocal_length_square_cut(24 downto 24));
    reciprocal_length_square <= 22x"3fffff" when reciprocal_length_square_over(0) = '1' else 22x"000000" when reciprocal_length_square_under(0) = '1' else unsigned(reciprocal_length_square_cut(21 downto 0));
    -- reciprocal_length
    reciprocal_length_n341 <= reciprocal_length_square;
    reciprocal_length_n342 <= reciprocal_length_n341;
    reciprocal_length_n343 <= reciprocal_length_n342(21 downto 6);
    reciprocal_length_n344 <= "1" when reciprocal_length_n343 = resize(bn_n34, 16) else "0";
    reciprocal_length_n345 <= reciprocal_length_n342(5 downto 0);
    reciprocal_length_n346 <= reciprocal_length_n345 & bn_n45;
    reciprocal_length_n347 <= reciprocal_length_n346 when reciprocal_length_n344(0) = '1' else reciprocal_length_n342;
    reciprocal_length_n348 <= reciprocal_length_n347(21 downto 14);
    reciprocal_length_n349 <= "1" when reciprocal_length_n348 = resize(bn_n34, 8) else "0";
    reciprocal_length_n350 <= reciprocal_length_n347(13 downto 0);
    reciprocal_length_n351 <= reciprocal_length_n350 & bn_n51;
    reciprocal_length_n363 <= reciprocal_length_n344 & reciprocal_length_n349;
    reciprocal_length_n381 <= "1" when reciprocal_length_square = shift_left(resize(bn_n34, 22), 20) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    bn_length_square_sum <= resize(bn_square_n156_s7, 39) + 39x"0000002000";
    bn_length_square_cut <= bn_length_square_sum(38 downto 14);
    bn_length_square_over <= "1" when bn_length_square_cut(24) = '0' and (or bn_length_square_cut(23 downto 22)) = '1' else "0";
    bn_length_square_under <= unsigned(bn_length_square_cut(24 downto 24));
    bn_length_square <= 22x"3fffff" when bn_length_square_over(0) = '1' else 22x"000000" when bn_length_square_under(0) = '1' else unsigned(bn_length_square_cut(21 downto 0));
    -- bn_length
    bn_length_n158 <= bn_length_square;
    bn_length_n159 <= bn_length_n158;
    bn_length_n160 <= bn_length_n159(21 downto 6);
    bn_length_n161 <= "1" when bn_length_n160 = resize(bn_n34, 16) else "0";
    bn_length_n162 <= bn_length_n159(5 downto 0);
    bn_length_n163 <= bn_length_n162 & bn_n45;
    bn_length_n164 <= bn_length_n163 when bn_length_n161(0) = '1' else bn_length_n159;
    bn_length_n165 <= bn_length_n164(21 downto 14);
    bn_length_n166 <= "1" when bn_length_n165 = resize(bn_n34, 8) else "0";
    bn_length_n167 <= bn_length_n164(13 downto 0);
    bn_length_n168 <= bn_length_n167 & bn_n51;
    bn_length_n180 <= bn_length_n161 & bn_length_n166;
    bn_length_n200 <= "1" when bn_length_square = shift_left(resize(bn_n34, 22), 20) else "0";
    -- reciprocal_length
    reciprocal_length_n352 <= reciprocal_length_n351_s7 when reciprocal_length_n349_s7(0) = '1' else reciprocal_length_n347_s7;
    reciprocal_length_n353 <= reciprocal_length_n352(21 downto 18);
    reciprocal_length_n354 <= "1" when reciprocal_length_n353 = resize(bn_n34, 4) else "0";
    reciprocal_length_n355 <= reciprocal_length_n352(17 downto 0);
    reciprocal_length_n356 <= reciprocal_length_n355 & bn_n57;
    reciprocal_length_n357 <= reciprocal_length_n356 when reciprocal_length_n354(0) = '1' else reciprocal_length_n352;
    reciprocal_length_n358 <= reciprocal_length_n357(21 downto 20);
    reciprocal_length_n359 <= "1" when reciprocal_length_n358 = resize(bn_n34, 2) else "0";
    reciprocal_length_n360 <= reciprocal_length_n357(19 downto 0);
    reciprocal_length_n361 <= reciprocal_length_n360 & bn_n63;
    reciprocal_length_n362 <= reciprocal_length_n361 when reciprocal_length_n359(0) = '1' else reciprocal_length_n357;
    reciprocal_length_n364 <= reciprocal_length_n363_s7 & reciprocal_length_n354;
    reciprocal_length_n365 <= reciprocal_length_n364 & reciprocal_length_n359;
    reciprocal_length_n366 <= reciprocal_length_n362(21 downto 20);
    reciprocal_length_n367 <= signed(resize(reciprocal_length_n366, 3)) - signed(resize(bn_length_n184, 3));
    reciprocal_length_n368 <= unsigned(reciprocal_length_n367(1 downto 0));
    reciprocal_length_n369 <= reciprocal_length_n362(19 downto 2);
    reciprocal_length_n370 <= reciprocal_length_n368 & reciprocal_length_n369;
    reciprocal_length_n371 <= reciprocal_length_n370;
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n372 <= reciprocal_length_n371(19 downto 11);
    reciprocal_length_recip_root_n375 <= reciprocal_length_n371(10 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
                recip_root_row <= recip_root_rom(to_integer(reciprocal_length_recip_root_n372));
                reciprocal_length_recip_root_n375_s8 <= reciprocal_length_recip_root_n375;
                reciprocal_length_n381_s8 <= reciprocal_length_n381_s7;
                ks_q_s8 <= ks_q_s7;
                n406_s8 <= n406_s7;
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
    bn_length_n169 <= bn_length_n168_s8 when bn_length_n166_s8(0) = '1' else bn_length_n164_s8;
    bn_length_n170 <= bn_length_n169(21 downto 18);
    bn_length_n171 <= "1" when bn_length_n170 = resize(bn_n34, 4) else "0";
    bn_length_n172 <= bn_length_n169(17 downto 0);
    bn_length_n173 <= bn_length_n172 & bn_n57;
    bn_length_n174 <= bn_length_n173 when bn_length_n171(0) = '1' else bn_length_n169;
    bn_length_n175 <= bn_length_n174(21 downto 20);
    bn_length_n176 <= "1" when bn_length_n175 = resize(bn_n34, 2) else "0";
    bn_length_n177 <= bn_length_n174(19 downto 0);
    bn_length_n178 <= bn_length_n177 & bn_n63;
    bn_length_n179 <= bn_length_n178 when bn_length_n176(0) = '1' else bn_length_n174;
    bn_length_n181 <= bn_length_n180_s8 & bn_length_n171;
    bn_length_n182 <= bn_length_n181 & bn_length_n176;
    bn_length_n183 <= bn_length_n179(21 downto 20);
    bn_length_n185 <= signed(resize(bn_length_n183, 3)) - signed(resize(bn_length_n184, 3));
    bn_length_n186 <= unsigned(bn_length_n185(1 downto 0));
    bn_length_n187 <= bn_length_n179(19 downto 2);
    bn_length_n188 <= bn_length_n186 & bn_length_n187;
    bn_length_n189 <= bn_length_n188;
    -- bn_length.recip_root
    bn_length_recip_root_n190 <= bn_length_n189(19 downto 11);
    bn_length_recip_root_n193 <= bn_length_n189(10 downto 0);
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n373 <= recip_root_row(38 downto 16);
    reciprocal_length_recip_root_n374 <= signed(recip_root_row(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
                recip_root_row_2 <= recip_root_rom(to_integer(bn_length_recip_root_n190));
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
    bn_length_recip_root_n191 <= recip_root_row_2(38 downto 16);
    bn_length_recip_root_n192 <= signed(recip_root_row_2(15 downto 0));
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n376 <= resize(reciprocal_length_recip_root_n374_s9 * signed('0' & reciprocal_length_recip_root_n375_s9), 27);
    reciprocal_length_recip_root_n377 <= signed(shift_left(resize(reciprocal_length_recip_root_n373_s9, 36), 11)) + resize(reciprocal_length_recip_root_n376, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_length_recip_root_n194 <= resize(bn_length_recip_root_n192_s10 * signed('0' & bn_length_recip_root_n193_s10), 27);
    bn_length_recip_root_n195 <= signed(shift_left(resize(bn_length_recip_root_n191_s10, 36), 11)) + resize(bn_length_recip_root_n194, 36);
    -- reciprocal_length.recip_root
    reciprocal_length_recip_root_n378_sum <= resize(reciprocal_length_recip_root_n377_s10, 37) + 37x"0000001000";
    reciprocal_length_recip_root_n378_cut <= reciprocal_length_recip_root_n378_sum(36 downto 13);
    reciprocal_length_recip_root_n378_over <= "1" when reciprocal_length_recip_root_n378_cut(23) = '0' and (or reciprocal_length_recip_root_n378_cut(22 downto 22)) = '1' else "0";
    reciprocal_length_recip_root_n378_under <= unsigned(reciprocal_length_recip_root_n378_cut(23 downto 23));
    reciprocal_length_recip_root_n378 <= 22x"3fffff" when reciprocal_length_recip_root_n378_over(0) = '1' else 22x"000000" when reciprocal_length_recip_root_n378_under(0) = '1' else unsigned(reciprocal_length_recip_root_n378_cut(21 downto 0));
    -- reciprocal_length
    reciprocal_length_n379_past <= "1" when 4x"b" < reciprocal_length_n365_s10 else "0";
    reciprocal_length_n379_count <= 4x"b" when reciprocal_length_n379_past(0) = '1' else reciprocal_length_n365_s10;
    reciprocal_length_n379 <= shift_left(resize(reciprocal_length_recip_root_n378, 33), to_integer(reciprocal_length_n379_count));
    reciprocal_length_n380 <= reciprocal_length_n379;
    reciprocal_length_n382 <= shift_left(resize(bn_length_n199, 33), 23) when reciprocal_length_n381_s10(0) = '1' else reciprocal_length_n380;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_length_recip_root_n196_sum <= resize(bn_length_recip_root_n195_s11, 37) + 37x"0000001000";
    bn_length_recip_root_n196_cut <= bn_length_recip_root_n196_sum(36 downto 13);
    bn_length_recip_root_n196_over <= "1" when bn_length_recip_root_n196_cut(23) = '0' and (or bn_length_recip_root_n196_cut(22 downto 22)) = '1' else "0";
    bn_length_recip_root_n196_under <= unsigned(bn_length_recip_root_n196_cut(23 downto 23));
    bn_length_recip_root_n196 <= 22x"3fffff" when bn_length_recip_root_n196_over(0) = '1' else 22x"000000" when bn_length_recip_root_n196_under(0) = '1' else unsigned(bn_length_recip_root_n196_cut(21 downto 0));
    -- bn_length
    bn_length_n197_past <= "1" when 4x"b" < bn_length_n182_s11 else "0";
    bn_length_n197_count <= 4x"b" when bn_length_n197_past(0) = '1' else bn_length_n182_s11;
    bn_length_n197 <= shift_left(resize(bn_length_recip_root_n196, 33), to_integer(bn_length_n197_count));
    bn_length_n198 <= bn_length_n197;
    bn_length_n201 <= shift_left(resize(bn_length_n199, 33), 23) when bn_length_n200_s11(0) = '1' else bn_length_n198;
    -- reciprocal_length
    reciprocal_length_reciprocal_length_sum <= resize(reciprocal_length_n382_s11, 34) + 34x"000000004";
    reciprocal_length_reciprocal_length_cut <= reciprocal_length_reciprocal_length_sum(33 downto 3);
    reciprocal_length_reciprocal_length_over <= "1" when (or reciprocal_length_reciprocal_length_cut(30 downto 20)) = '1' else "0";
    reciprocal_length_reciprocal_length <= 20x"fffff" when reciprocal_length_reciprocal_length_over(0) = '1' else reciprocal_length_reciprocal_length_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_length_bn_length_sum <= resize(bn_length_n201_s12, 34) + 34x"000000004";
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
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    n203 <= resize(bn_norm_x_s13 * signed('0' & bn_length_bn_length_s13), 38);
    n205 <= resize(bn_norm_y_s13 * signed('0' & bn_length_bn_length_s13), 38);
    n207 <= resize(bn_norm_z_s13 * signed('0' & bn_length_bn_length_s13), 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    bn_unit_x_sum <= resize(n203_s14, 39) + 39x"0000010000";
    bn_unit_x_cut <= bn_unit_x_sum(38 downto 17);
    bn_unit_x_over <= "1" when bn_unit_x_cut(21) = '0' and (or bn_unit_x_cut(20 downto 19)) = '1' else "0";
    bn_unit_x_under <= "1" when bn_unit_x_cut(21) = '1' and (and bn_unit_x_cut(20 downto 19)) = '0' else "0";
    bn_unit_x <= 20x"7ffff" when bn_unit_x_over(0) = '1' else 20x"80000" when bn_unit_x_under(0) = '1' else bn_unit_x_cut(19 downto 0);
    bn_unit_y_sum <= resize(n205_s14, 39) + 39x"0000010000";
    bn_unit_y_cut <= bn_unit_y_sum(38 downto 17);
    bn_unit_y_over <= "1" when bn_unit_y_cut(21) = '0' and (or bn_unit_y_cut(20 downto 19)) = '1' else "0";
    bn_unit_y_under <= "1" when bn_unit_y_cut(21) = '1' and (and bn_unit_y_cut(20 downto 19)) = '0' else "0";
    bn_unit_y <= 20x"7ffff" when bn_unit_y_over(0) = '1' else 20x"80000" when bn_unit_y_under(0) = '1' else bn_unit_y_cut(19 downto 0);
    bn_unit_z_sum <= resize(n207_s14, 39) + 39x"0000010000";
    bn_unit_z_cut <= bn_unit_z_sum(38 downto 17);
    bn_unit_z_over <= "1" when bn_unit_z_cut(21) = '0' and (or bn_unit_z_cut(20 downto 19)) = '1' else "0";
    bn_unit_z_under <= "1" when bn_unit_z_cut(21) = '1' and (and bn_unit_z_cut(20 downto 19)) = '0' else "0";
    bn_unit_z <= 20x"7ffff" when bn_unit_z_over(0) = '1' else 20x"80000" when bn_unit_z_under(0) = '1' else bn_unit_z_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_cross_n_n209 <= bn_unit_y_s15 * normal_z_s15;
    bn_cross_n_n210 <= bn_unit_z_s15 * normal_y_s15;
    bn_cross_n_n212 <= bn_unit_z_s15 * normal_x_s15;
    bn_cross_n_n213 <= bn_unit_x_s15 * normal_z_s15;
    bn_cross_n_n215 <= bn_unit_x_s15 * normal_y_s15;
    bn_cross_n_n216 <= bn_unit_y_s15 * normal_x_s15;
    -- b_dot_l
    b_dot_l_n384 <= bn_unit_x_s15 * l_norm_x_s15;
    b_dot_l_n385 <= bn_unit_y_s15 * l_norm_y_s15;
    b_dot_l_n386 <= bn_unit_z_s15 * l_norm_z_s15;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
    bn_cross_n_n211 <= resize(bn_cross_n_n209_s16, 37) - resize(bn_cross_n_n210_s16, 37);
    bn_cross_n_n214 <= resize(bn_cross_n_n212_s16, 37) - resize(bn_cross_n_n213_s16, 37);
    bn_cross_n_n217 <= resize(bn_cross_n_n215_s16, 37) - resize(bn_cross_n_n216_s16, 37);
    -- (unit)
    n218_sum <= resize(bn_cross_n_n211, 38) + 38x"0000002000";
    n218_cut <= n218_sum(37 downto 14);
    n218 <= n218_cut;
    n219_sum <= resize(bn_cross_n_n214, 38) + 38x"0000002000";
    n219_cut <= n219_sum(37 downto 14);
    n219 <= n219_cut;
    n220_sum <= resize(bn_cross_n_n217, 38) + 38x"0000002000";
    n220_cut <= n220_sum(37 downto 14);
    n220 <= n220_cut;
    -- b_dot_l
    b_dot_l_n387 <= resize(b_dot_l_n384_s16, 39) + resize(b_dot_l_n385_s16, 39);
    b_dot_l_n388 <= resize(b_dot_l_n387, 40) + resize(b_dot_l_n386_s16, 40);
    -- (unit)
    b_l_sum <= resize(b_dot_l_n388, 41) + 41x"00000004000";
    b_l_cut <= b_l_sum(40 downto 15);
    b_l <= b_l_cut;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- t_dot_l
    t_dot_l_n329 <= n218_s17 * l_norm_x_s17;
    t_dot_l_n330 <= n219_s17 * l_norm_y_s17;
    t_dot_l_n331 <= n220_s17 * l_norm_z_s17;
    -- (unit)
    ds_product <= resize(b_l_s17 * signed('0' & reciprocal_length_reciprocal_length_s17), 46);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
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
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- t_dot_l
    t_dot_l_n332 <= resize(t_dot_l_n329_s18, 43) + resize(t_dot_l_n330_s18, 43);
    t_dot_l_n333 <= resize(t_dot_l_n332, 44) + resize(t_dot_l_n331_s18, 44);
    -- (unit)
    ds_unit_sum <= resize(ds_product_s18, 47) + 47x"000000020000";
    ds_unit_cut <= ds_unit_sum(46 downto 18);
    ds_unit_over <= "1" when ds_unit_cut(28) = '0' and (or ds_unit_cut(27 downto 22)) = '1' else "0";
    ds_unit_under <= "1" when ds_unit_cut(28) = '1' and (and ds_unit_cut(27 downto 22)) = '0' else "0";
    ds_unit <= 23x"3fffff" when ds_unit_over(0) = '1' else 23x"400000" when ds_unit_under(0) = '1' else ds_unit_cut(22 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s19 <= s0_s18;
                t0_s19 <= t0_s18;
                q0_s19 <= q0_s18;
                r0_s19 <= r0_s18;
                t_dot_l_n333_s19 <= t_dot_l_n333;
                reciprocal_length_reciprocal_length_s19 <= reciprocal_length_reciprocal_length_s18;
                ds_unit_s19 <= ds_unit;
                ks_q_s19 <= ks_q_s18;
                n406_s19 <= n406_s18;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    t_l_sum <= resize(t_dot_l_n333_s19, 45) + 45x"000000004000";
    t_l_cut <= t_l_sum(44 downto 15);
    t_l <= t_l_cut;
    n395 <= ds_unit_s19 * ks_q_s19;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                s0_s20 <= s0_s19;
                t0_s20 <= t0_s19;
                q0_s20 <= q0_s19;
                r0_s20 <= r0_s19;
                t_l_s20 <= t_l;
                reciprocal_length_reciprocal_length_s20 <= reciprocal_length_reciprocal_length_s19;
                ks_q_s20 <= ks_q_s19;
                n395_s20 <= n395;
                n406_s20 <= n406_s19;
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    ds_next_sum <= resize(n395_s20, 54) + 54x"00000000200000";
    ds_next_cut <= ds_next_sum(53 downto 22);
    ds_next_over <= "1" when ds_next_cut(31) = '0' and (or ds_next_cut(30 downto 29)) = '1' else "0";
    ds_next_under <= "1" when ds_next_cut(31) = '1' and (and ds_next_cut(30 downto 29)) = '0' else "0";
    ds_next <= 30x"1fffffff" when ds_next_over(0) = '1' else 30x"20000000" when ds_next_under(0) = '1' else ds_next_cut(29 downto 0);
    s1_sum <= resize(s0_s20, 31) + resize(ds_next, 31);
    s1_next_over <= "1" when s1_sum(30) = '0' and (or s1_sum(29 downto 24)) = '1' else "0";
    s1_next_under <= "1" when s1_sum(30) = '1' and (and s1_sum(29 downto 24)) = '0' else "0";
    s1_next <= 25x"0ffffff" when s1_next_over(0) = '1' else 25x"1000000" when s1_next_under(0) = '1' else s1_sum(24 downto 0);
    dt_product <= resize(t_l_s20 * signed('0' & reciprocal_length_reciprocal_length_s20), 50);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                t0_s21 <= t0_s20;
                q0_s21 <= q0_s20;
                r0_s21 <= r0_s20;
                ks_q_s21 <= ks_q_s20;
                ds_next_s21 <= ds_next;
                s1_next_s21 <= s1_next;
                dt_product_s21 <= dt_product;
                n406_s21 <= n406_s20;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----
    dt_unit_sum <= resize(dt_product_s21, 51) + 51x"0000000020000";
    dt_unit_cut <= dt_unit_sum(50 downto 18);
    dt_unit_over <= "1" when dt_unit_cut(32) = '0' and (or dt_unit_cut(31 downto 26)) = '1' else "0";
    dt_unit_under <= "1" when dt_unit_cut(32) = '1' and (and dt_unit_cut(31 downto 26)) = '0' else "0";
    dt_unit <= 27x"3ffffff" when dt_unit_over(0) = '1' else 27x"4000000" when dt_unit_under(0) = '1' else dt_unit_cut(26 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                t0_s22 <= t0_s21;
                q0_s22 <= q0_s21;
                r0_s22 <= r0_s21;
                ks_q_s22 <= ks_q_s21;
                ds_next_s22 <= ds_next_s21;
                s1_next_s22 <= s1_next_s21;
                dt_unit_s22 <= dt_unit;
                n406_s22 <= n406_s21;
            end if;
            if rst = '1' then
                valid_s22 <= '0';
            elsif ce = '1' then
                valid_s22 <= valid_s21;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----
    n401 <= dt_unit_s22 * ks_q_s22;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                t0_s23 <= t0_s22;
                q0_s23 <= q0_s22;
                r0_s23 <= r0_s22;
                ds_next_s23 <= ds_next_s22;
                s1_next_s23 <= s1_next_s22;
                n401_s23 <= n401;
                n406_s23 <= n406_s22;
            end if;
            if rst = '1' then
                valid_s23 <= '0';
            elsif ce = '1' then
                valid_s23 <= valid_s22;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----
    n402 <= -resize(n401_s23, 58);
    dt_next_sum <= resize(n402, 59) + 59x"000000000200000";
    dt_next_cut <= dt_next_sum(58 downto 22);
    dt_next_over <= "1" when dt_next_cut(36) = '0' and (or dt_next_cut(35 downto 33)) = '1' else "0";
    dt_next_under <= "1" when dt_next_cut(36) = '1' and (and dt_next_cut(35 downto 33)) = '0' else "0";
    dt_next <= 34x"1ffffffff" when dt_next_over(0) = '1' else 34x"200000000" when dt_next_under(0) = '1' else dt_next_cut(33 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                t0_s24 <= t0_s23;
                q0_s24 <= q0_s23;
                r0_s24 <= r0_s23;
                ds_next_s24 <= ds_next_s23;
                s1_next_s24 <= s1_next_s23;
                dt_next_s24 <= dt_next;
                n406_s24 <= n406_s23;
            end if;
            if rst = '1' then
                valid_s24 <= '0';
            elsif ce = '1' then
                valid_s24 <= valid_s23;
            end if;
        end if;
    end process;

    -- ---- stage 24 ----
    t1_sum <= resize(t0_s24, 35) + resize(dt_next_s24, 35);
    t1_next_over <= "1" when t1_sum(34) = '0' and (or t1_sum(33 downto 24)) = '1' else "0";
    t1_next_under <= "1" when t1_sum(34) = '1' and (and t1_sum(33 downto 24)) = '0' else "0";
    t1_next <= 25x"0ffffff" when t1_next_over(0) = '1' else 25x"1000000" when t1_next_under(0) = '1' else t1_sum(24 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                q1 <= q0_s24;
                r1 <= r0_s24;
                ds <= ds_next_s24;
                s1 <= s1_next_s24;
                dt <= dt_next_s24;
                t1 <= t1_next;
                degenerate <= n406_s24;
            end if;
            if rst = '1' then
                valid_s25 <= '0';
            elsif ce = '1' then
                valid_s25 <= valid_s24;
            end if;
        end if;
    end process;

    -- ---- stage 25 ----

    valid_out <= valid_s25;
end architecture;
