-- emboss: texture coordinates displaced by the direction of a light, for embossing
-- made by fixpath 0.1.0; seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)
--   setting=gx frame=auto normalise_basis=auto s_vector=auto l_sign=vertex-light t_sign=auto
--   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
--   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
--   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
--   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
--   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=6000 stages=auto
--   rom=block schedule=printed interval=auto share_dot=auto share_mul=auto share_add=auto
--   share_table=auto share_root=auto share_divide=auto share_latency=auto share_loads=no
-- latency 27 cycles, interval 8 cycles; tables read on the clock
-- errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   ds_texels: mean 5.15e-4 texel, largest seen 5.15e-3 texel at m0_x=12751 m0_y=1138 m0_z=-8250 m1_x=-7659 m1_y=7527 m1_z=-10799 m2_x=-3271 m2_y=-13191 m2_z=-6874 tangent_x=6051 tangent_y=-16238 tangent_z=-7522 binormal_x=1930 binormal_y=1907 binormal_z=-12126 light_x=-800273 light_y=28364200 light_z=-19691339 vertex_x=-756508 vertex_y=28226572 vertex_z=-19728074 s0=-256572 t0=-3577593
--   ds_relative: mean 2.02e-6, largest seen 1.35e-5 over the vector's length times its factor, each 1/4 where it is less, at m0_x=-3494 m0_y=636 m0_z=-2776 m1_x=1400 m1_y=4210 m1_z=-798 m2_x=2480 m2_y=-1481 m2_z=-3460 tangent_x=-11245 tangent_y=-8522 tangent_z=4359 binormal_x=17751 binormal_y=-4500 binormal_z=3988 light_x=-7945328 light_y=5646846 light_z=-26346403 vertex_x=10130098 vertex_y=3895478 vertex_z=-19350800 s0=3355968 t0=-3453276
--   ds: mean 2.01e-6, largest seen 2.01e-5 (5.3 ulp) at m0_x=12751 m0_y=1138 m0_z=-8250 m1_x=-7659 m1_y=7527 m1_z=-10799 m2_x=-3271 m2_y=-13191 m2_z=-6874 tangent_x=6051 tangent_y=-16238 tangent_z=-7522 binormal_x=1930 binormal_y=1907 binormal_z=-12126 light_x=-800273 light_y=28364200 light_z=-19691339 vertex_x=-756508 vertex_y=28226572 vertex_z=-19728074 s0=-256572 t0=-3577593
--   dt_texels: mean 5.19e-4 texel, largest seen 5.17e-3 texel at m0_x=13775 m0_y=-3610 m0_z=-7962 m1_x=4590 m1_y=15633 m1_z=853 m2_x=7440 m2_y=-2960 m2_z=14215 tangent_x=12678 tangent_y=-12502 tangent_z=1145 binormal_x=-1811 binormal_y=-12251 binormal_z=11433 light_x=-34415703 light_y=15909641 light_z=-16014085 vertex_x=-32232676 vertex_y=15321146 vertex_z=-16149628 s0=-4022697 t0=-1773471
--   dt_relative: mean 2.04e-6, largest seen 1.46e-5 over the vector's length times its factor, each 1/4 where it is less, at m0_x=3100 m0_y=-4584 m0_z=-3145 m1_x=5482 m1_y=3118 m1_z=859 m2_x=-922 m2_y=3127 m2_z=-5467 tangent_x=-10467 tangent_y=1822 tangent_z=-16786 binormal_x=-7767 binormal_y=-6278 binormal_z=7382 light_x=17363491 light_y=25020043 light_z=9977160 vertex_x=17368462 vertex_y=25166263 vertex_z=9975503 s0=-1376439 t0=3249385
--   dt: mean 2.03e-6, largest seen 2.02e-5 (5.3 ulp) at m0_x=13775 m0_y=-3610 m0_z=-7962 m1_x=4590 m1_y=15633 m1_z=853 m2_x=7440 m2_y=-2960 m2_z=14215 tangent_x=12678 tangent_y=-12502 tangent_z=1145 binormal_x=-1811 binormal_y=-12251 binormal_z=11433 light_x=-34415703 light_y=15909641 light_z=-16014085 vertex_x=-32232676 vertex_y=15321146 vertex_z=-16149628 s0=-4022697 t0=-1773471
--   s1: mean 2.01e-6, largest seen 2.01e-5 (5.3 ulp) at m0_x=12751 m0_y=1138 m0_z=-8250 m1_x=-7659 m1_y=7527 m1_z=-10799 m2_x=-3271 m2_y=-13191 m2_z=-6874 tangent_x=6051 tangent_y=-16238 tangent_z=-7522 binormal_x=1930 binormal_y=1907 binormal_z=-12126 light_x=-800273 light_y=28364200 light_z=-19691339 vertex_x=-756508 vertex_y=28226572 vertex_z=-19728074 s0=-256572 t0=-3577593
--   t1: mean 2.03e-6, largest seen 2.02e-5 (5.3 ulp) at m0_x=13775 m0_y=-3610 m0_z=-7962 m1_x=4590 m1_y=15633 m1_z=853 m2_x=7440 m2_y=-2960 m2_z=14215 tangent_x=12678 tangent_y=-12502 tangent_z=1145 binormal_x=-1811 binormal_y=-12251 binormal_z=11433 light_x=-34415703 light_y=15909641 light_z=-16014085 vertex_x=-32232676 vertex_y=15321146 vertex_z=-16149628 s0=-4022697 t0=-1773471
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at m0_x=4674 m0_y=5079 m0_z=-2162 m1_x=-3514 m1_y=4923 m1_z=3966 m2_x=-4257 m2_y=1512 m2_z=-5648 tangent_x=-2894 tangent_y=-19246 tangent_z=1152 binormal_x=-2531 binormal_y=7271 binormal_z=-13448 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897
-- stated bound on each relative displacement (over the vector's length times its factor, each 1/4 where it is less): 5.21e-5
-- stated bound on each displacement: 1.15e-3
-- stated bound on each displacement in texels: 2.93e-1
-- stated bound on each coordinate: 1.15e-3
-- stated bound on each flag and what is passed: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity emboss_printed is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits and the phase
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        ready : out std_logic; -- inputs are taken at this edge
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

architecture rtl of emboss_printed is
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
    -- phase
    signal phase : unsigned(2 downto 0) := (others => '0');
    signal phase_more : unsigned(2 downto 0) := (others => '0');
    signal phase_0 : unsigned(0 downto 0) := (others => '0');
    signal phase_1 : unsigned(0 downto 0) := (others => '0');
    signal phase_2 : unsigned(0 downto 0) := (others => '0');
    signal phase_3 : unsigned(0 downto 0) := (others => '0');
    signal phase_4 : unsigned(0 downto 0) := (others => '0');
    signal phase_5 : unsigned(0 downto 0) := (others => '0');
    signal phase_6 : unsigned(0 downto 0) := (others => '0');
    signal phase_7 : unsigned(0 downto 0) := (others => '0');
    -- hold registers and results of units
    signal m0_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m0_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m0_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m1_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m1_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m1_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m2_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m2_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal m2_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal tangent_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal tangent_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal tangent_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal binormal_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal binormal_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal binormal_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light_x_s1 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal light_y_s1 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal light_z_s1 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal light_z_s9 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal vertex_x_s1 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal vertex_y_s1 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal vertex_z_s1 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal vertex_z_s9 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal s0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal s0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal s0_s17 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s1 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s9 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s17 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t0_s25 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal t_x_n27 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_x_n27_s11 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_y_n32 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_y_n32_s12 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_z_n37 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_z_n37_s13 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal t_eye_x_s12 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_eye_y_s13 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_x_n45 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_x_n45_s15 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_y_n50 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_y_n50_s16 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_z_n55 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_z_n55_s17 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal b_eye_x_s16 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal b_eye_y_s17 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal l_x : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_x_s8 : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_y : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_y_s9 : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_z : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_z_s10 : signed(28 downto 0) := (others => '0'); -- s29f15
    signal l_block_n63_s9 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n68_s10 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n84_s11 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n86_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n89_s11 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n100_s11 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal l_block_n103_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n103_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n106_s9 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n109_s9 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_x_s12 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_n131_s10 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n133_s10 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_y_s12 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_block_n151_s11 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n153_s11 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_z_s12 : signed(29 downto 0) := (others => '0'); -- s30f29
    signal l_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal l_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal t_dot_l_n176 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal t_dot_l_n176_s15 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal t_l_s16 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal l_dot_l_n182 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal l_dot_l_n182_s16 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal reciprocal_length_square_s17 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_length_reciprocal_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal reciprocal_length_reciprocal_length_s22 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal b_dot_l_n233 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal b_dot_l_n233_s19 : signed(45 downto 0) := (others => '0'); -- s46f35
    signal b_l_s20 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal ds_product : signed(51 downto 0) := (others => '0'); -- s52f38
    signal ds_product_s23 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal s1_sum : signed(27 downto 0) := (others => '0'); -- s28f18
    signal s1_sum_s25 : signed(27 downto 0) := (others => '0'); -- s28f18
    signal dt_product : signed(51 downto 0) := (others => '0'); -- s52f38
    signal dt_product_s24 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal t1_sum : signed(27 downto 0) := (others => '0'); -- s28f18
    signal t1_sum_s26 : signed(27 downto 0) := (others => '0'); -- s28f18
    -- stage 0
    signal l_block_n71 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n76 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n82 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal l_block_n88 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal l_block_n94 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_length_n210 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_length_n225 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal valid_s1 : std_logic;
    -- stage 7
    -- stage 8
    signal l_block_n62_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n62 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n63 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n104 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n105 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n106 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n108 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n109 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal l_block_n64_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n64 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n65 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n68 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n129 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n130 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n131 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n132 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n133 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    -- stage 10
    signal l_block_n66_neg : unsigned(28 downto 0) := (others => '0');
    signal l_block_n66 : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n67 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n69 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_largest : unsigned(28 downto 0) := (others => '0'); -- u29f15
    signal l_block_n72 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n73 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal l_block_n74 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n75 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal l_block_n77 : unsigned(28 downto 0) := (others => '0'); -- u29f0
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
    signal l_block_n99 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n100 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal l_block_n103 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n149 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n150 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n151 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    signal l_block_n152 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal l_block_n153 : unsigned(29 downto 0) := (others => '0'); -- u30f0
    -- stage 11
    signal t_eye_x_sum : signed(34 downto 0) := (others => '0');
    signal t_eye_x_cut : signed(25 downto 0) := (others => '0');
    signal t_eye_x : signed(25 downto 0) := (others => '0'); -- s26f18
    signal l_block_n90 : unsigned(28 downto 0) := (others => '0'); -- u29f0
    signal l_block_n91 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal l_block_n92 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal l_block_n93 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal l_block_n95 : unsigned(28 downto 0) := (others => '0'); -- u29f0
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
    -- stage 12
    signal t_eye_y_sum : signed(34 downto 0) := (others => '0');
    signal t_eye_y_cut : signed(25 downto 0) := (others => '0');
    signal t_eye_y : signed(25 downto 0) := (others => '0'); -- s26f18
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
    -- stage 13
    signal t_eye_z_sum : signed(34 downto 0) := (others => '0');
    signal t_eye_z_cut : signed(25 downto 0) := (others => '0');
    signal t_eye_z : signed(25 downto 0) := (others => '0'); -- s26f18
    -- stage 14
    -- stage 15
    signal b_eye_x_sum : signed(34 downto 0) := (others => '0');
    signal b_eye_x_cut : signed(25 downto 0) := (others => '0');
    signal b_eye_x : signed(25 downto 0) := (others => '0'); -- s26f18
    signal t_l_sum : signed(46 downto 0) := (others => '0');
    signal t_l_cut : signed(31 downto 0) := (others => '0');
    signal t_l : signed(31 downto 0) := (others => '0'); -- s32f20
    -- stage 16
    signal b_eye_y_sum : signed(34 downto 0) := (others => '0');
    signal b_eye_y_cut : signed(25 downto 0) := (others => '0');
    signal b_eye_y : signed(25 downto 0) := (others => '0'); -- s26f18
    signal reciprocal_length_square_sum : signed(38 downto 0) := (others => '0');
    signal reciprocal_length_square_cut : signed(24 downto 0) := (others => '0');
    signal reciprocal_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal valid_s17 : std_logic;
    -- stage 17
    signal b_eye_z_sum : signed(34 downto 0) := (others => '0');
    signal b_eye_z_cut : signed(25 downto 0) := (others => '0');
    signal b_eye_z : signed(25 downto 0) := (others => '0'); -- s26f18
    -- stage 18
    -- stage 19
    signal b_l_sum : signed(46 downto 0) := (others => '0');
    signal b_l_cut : signed(31 downto 0) := (others => '0');
    signal b_l : signed(31 downto 0) := (others => '0'); -- s32f20
    -- stage 21
    -- stage 22
    -- stage 23
    signal ds_next_sum : signed(52 downto 0) := (others => '0');
    signal ds_next_cut : signed(32 downto 0) := (others => '0');
    signal ds_next_over : unsigned(0 downto 0) := (others => '0');
    signal ds_next_under : unsigned(0 downto 0) := (others => '0');
    signal ds_next : signed(26 downto 0) := (others => '0'); -- s27f18
    -- stage 24
    signal dt_next_sum : signed(52 downto 0) := (others => '0');
    signal dt_next_cut : signed(32 downto 0) := (others => '0');
    signal dt_next_over : unsigned(0 downto 0) := (others => '0');
    signal dt_next_under : unsigned(0 downto 0) := (others => '0');
    signal dt_next : signed(26 downto 0) := (others => '0'); -- s27f18
    signal valid_s25 : std_logic;
    -- stage 25
    signal s1_next_over : unsigned(0 downto 0) := (others => '0');
    signal s1_next_under : unsigned(0 downto 0) := (others => '0');
    signal s1_next : signed(24 downto 0) := (others => '0'); -- s25f18
    -- stage 26
    signal t1_next_over : unsigned(0 downto 0) := (others => '0');
    signal t1_next_under : unsigned(0 downto 0) := (others => '0');
    signal t1_next : signed(24 downto 0) := (others => '0'); -- s25f18
    -- what dot1 takes
    signal phase_2_6 : unsigned(0 downto 0) := (others => '0');
    signal phase_3_7 : unsigned(0 downto 0) := (others => '0');
    signal dot1_in0 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal dot1_in1_next : signed(15 downto 0) := (others => '0'); -- s16f14
    signal phase_0_4 : unsigned(0 downto 0) := (others => '0');
    signal dot1_in2 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal dot1_in3_next : signed(15 downto 0) := (others => '0'); -- s16f14
    signal dot1_in4 : signed(15 downto 0) := (others => '0'); -- s16f13
    signal dot1_in5_next : signed(15 downto 0) := (others => '0'); -- s16f14
    signal dot1_in1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal dot1_in3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal dot1_in5 : signed(15 downto 0) := (others => '0'); -- s16f14
    -- dot1, stage 0
    signal dot1_body_n0 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal dot1_body_n1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal dot1_body_n2 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal dot1_body_n0_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal dot1_body_n1_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal dot1_body_n2_s1 : signed(31 downto 0) := (others => '0'); -- s32f27
    -- dot1, stage 1
    signal dot1_body_n3 : signed(32 downto 0) := (others => '0'); -- s33f27
    signal dot1_body_n2_s2 : signed(31 downto 0) := (others => '0'); -- s32f27
    signal dot1_body_n3_s2 : signed(32 downto 0) := (others => '0'); -- s33f27
    -- dot1, stage 2
    signal dot1_body_n4 : signed(33 downto 0) := (others => '0'); -- s34f27
    signal dot1_body_n4_s3 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- dot1, stage 3
    signal dot1_body_n4_s4 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- dot1, stage 4
    signal dot1_body_n4_s5 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- dot1, stage 5
    signal dot1_body_n4_s6 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- dot1, stage 6
    signal dot1_body_n4_s7 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- dot1, stage 7
    signal dot1_body_n4_s8 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- dot1, stage 8
    signal dot1_body_n4_s9 : signed(33 downto 0) := (others => '0'); -- s34f27
    -- what dot1 gives
    -- what vfadder takes
    signal vfadder_in0 : signed(27 downto 0) := (others => '0'); -- s28f15
    signal vfadder_in1 : signed(27 downto 0) := (others => '0'); -- s28f15
    -- vfadder, stage 0
    signal vfadder_n0 : signed(28 downto 0) := (others => '0'); -- s29f15
    -- what vfadder gives
    -- what dot2 takes
    signal dot2_in0_next : signed(25 downto 0) := (others => '0'); -- s26f18
    signal phase_1_5 : unsigned(0 downto 0) := (others => '0');
    signal phase_1_5_6 : unsigned(0 downto 0) := (others => '0');
    signal dot2_in1_next : signed(17 downto 0) := (others => '0'); -- s18f17
    signal dot2_in2_next : signed(25 downto 0) := (others => '0'); -- s26f18
    signal dot2_in3_next : signed(17 downto 0) := (others => '0'); -- s18f17
    signal dot2_in4_next : signed(25 downto 0) := (others => '0'); -- s26f18
    signal dot2_in5_next : signed(17 downto 0) := (others => '0'); -- s18f17
    signal dot2_in0 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal dot2_in1 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal dot2_in2 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal dot2_in3 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal dot2_in4 : signed(25 downto 0) := (others => '0'); -- s26f18
    signal dot2_in5 : signed(17 downto 0) := (others => '0'); -- s18f17
    -- dot2, stage 0
    signal dot2_body_n0 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal dot2_body_n1 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal dot2_body_n2 : signed(43 downto 0) := (others => '0'); -- s44f35
    signal dot2_body_n3 : signed(44 downto 0) := (others => '0'); -- s45f35
    signal dot2_body_n4 : signed(45 downto 0) := (others => '0'); -- s46f35
    -- what dot2 gives
    -- what inverse_root takes
    signal inverse_root_in0 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    -- inverse_root, stage 0
    signal inverse_root_n1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_n2 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal inverse_root_n3 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal inverse_root_n4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_n5 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal inverse_root_n6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_n7 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal inverse_root_body_n0 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n1 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n2 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal inverse_root_body_n3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_body_n4 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal inverse_root_body_n5 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n6 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n7 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal inverse_root_body_n8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_body_n9 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal inverse_root_body_n10 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n11 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n12 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_body_n13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_body_n14 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal inverse_root_body_n15 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n16 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n17 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal inverse_root_body_n18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_body_n19 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal inverse_root_body_n20 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n22 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal inverse_root_body_n23 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal inverse_root_body_n24 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_body_n40 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_body_n16_s1 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n18_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal inverse_root_body_n20_s1 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n24_s1 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_body_n40_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    -- inverse_root, stage 1
    signal inverse_root_body_n21 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal inverse_root_body_n25 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal inverse_root_body_n26 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal inverse_root_body_n27 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal inverse_root_body_n28 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal inverse_root_body_n29 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal inverse_root_body_n30 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal inverse_root_body_n31 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal inverse_root_body_n34 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal inverse_root_body_n24_s2 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_recip_root_row : unsigned(38 downto 0) := (others => '0');
    signal inverse_root_body_n34_s2 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal inverse_root_body_n40_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    -- inverse_root, stage 2
    signal inverse_root_body_n32 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal inverse_root_body_n33 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal inverse_root_body_n35 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal inverse_root_body_n24_s3 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_body_n32_s3 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal inverse_root_body_n35_s3 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal inverse_root_body_n40_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    -- inverse_root, stage 3
    signal inverse_root_body_n36 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal inverse_root_body_n37_sum : signed(36 downto 0) := (others => '0');
    signal inverse_root_body_n37_cut : signed(23 downto 0) := (others => '0');
    signal inverse_root_body_n37_over : unsigned(0 downto 0) := (others => '0');
    signal inverse_root_body_n37_under : unsigned(0 downto 0) := (others => '0');
    signal inverse_root_body_n37 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal inverse_root_body_n24_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal inverse_root_body_n37_s4 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal inverse_root_body_n40_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    -- inverse_root, stage 4
    signal inverse_root_body_n38_past : unsigned(0 downto 0) := (others => '0');
    signal inverse_root_body_n38_count : unsigned(3 downto 0) := (others => '0');
    signal inverse_root_body_n38 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal inverse_root_body_n39 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal inverse_root_body_n41 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal inverse_root_body_n42_sum : unsigned(33 downto 0) := (others => '0');
    signal inverse_root_body_n42_cut : unsigned(30 downto 0) := (others => '0');
    signal inverse_root_body_n42_over : unsigned(0 downto 0) := (others => '0');
    signal inverse_root_body_n42 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    -- what inverse_root gives
    -- what multiplier takes
    signal multiplier_in0 : signed(31 downto 0) := (others => '0'); -- s32f20
    signal multiplier_in1 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    -- multiplier, stage 0
    signal multiplier_n0 : signed(51 downto 0) := (others => '0'); -- s52f38
    -- what multiplier gives
    -- what adder takes
    signal adder_in0 : signed(24 downto 0) := (others => '0'); -- s25f18
    signal adder_in1 : signed(26 downto 0) := (others => '0'); -- s27f18
    -- adder, stage 0
    signal adder_n0 : signed(27 downto 0) := (others => '0'); -- s28f18
    -- what adder gives
begin

    -- ---- phase ----
    phase_more <= phase + "001";
    phase_0 <= "1" when phase = "000" else "0";
    phase_1 <= "1" when phase = "001" else "0";
    phase_2 <= "1" when phase = "010" else "0";
    phase_3 <= "1" when phase = "011" else "0";
    phase_4 <= "1" when phase = "100" else "0";
    phase_5 <= "1" when phase = "101" else "0";
    phase_6 <= "1" when phase = "110" else "0";
    phase_7 <= "1" when phase = "111" else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if rst = '1' then
                phase <= (others => '0');
            elsif ce = '1' then
                phase <= phase_more;
            end if;
        end if;
    end process;

    -- ---- hold registers and results of units ----

    -- ---- stage 0 ----
    -- l_block
    l_block_n71 <= "0";
    l_block_n76 <= 16x"0000";
    l_block_n82 <= 8x"00";
    l_block_n88 <= 4x"0";
    l_block_n94 <= "00";
    -- reciprocal_length
    reciprocal_length_n210 <= "1";
    reciprocal_length_n225 <= "1";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                m0_x_s1 <= m0_x;
                m0_y_s1 <= m0_y;
                m0_z_s1 <= m0_z;
                m1_x_s1 <= m1_x;
                m1_y_s1 <= m1_y;
                m1_z_s1 <= m1_z;
                m2_x_s1 <= m2_x;
                m2_y_s1 <= m2_y;
                m2_z_s1 <= m2_z;
                tangent_x_s1 <= tangent_x;
                tangent_y_s1 <= tangent_y;
                tangent_z_s1 <= tangent_z;
                binormal_x_s1 <= binormal_x;
                binormal_y_s1 <= binormal_y;
                binormal_z_s1 <= binormal_z;
                light_x_s1 <= light_x;
                light_y_s1 <= light_y;
                light_z_s1 <= light_z;
                vertex_x_s1 <= vertex_x;
                vertex_y_s1 <= vertex_y;
                vertex_z_s1 <= vertex_z;
                s0_s1 <= s0;
                t0_s1 <= t0;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_7(0) = '1' then
                l_x_s8 <= l_x;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- l_block
    l_block_n62_neg <= unsigned(-l_x_s8);
    l_block_n62 <= l_block_n62_neg when l_x_s8(28) = '1' else unsigned(l_x_s8);
    l_block_n63 <= l_block_n62;
    l_block_n104 <= unsigned(l_x_s8(28 downto 28));
    l_block_n105 <= unsigned(l_x_s8);
    l_block_n106 <= l_block_n104 & l_block_n105;
    l_block_n108 <= l_block_n106(13 downto 0);
    l_block_n109 <= l_block_n108 & l_block_n76;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                light_z_s9 <= light_z_s1;
                vertex_z_s9 <= vertex_z_s1;
                s0_s9 <= s0_s1;
                t0_s9 <= t0_s1;
                l_y_s9 <= l_y;
                l_block_n63_s9 <= l_block_n63;
                l_block_n106_s9 <= l_block_n106;
                l_block_n109_s9 <= l_block_n109;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s9 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- l_block
    l_block_n64_neg <= unsigned(-l_y_s9);
    l_block_n64 <= l_block_n64_neg when l_y_s9(28) = '1' else unsigned(l_y_s9);
    l_block_n65 <= l_block_n64;
    l_block_n68 <= l_block_n63_s9 or l_block_n65;
    l_block_n129 <= unsigned(l_y_s9(28 downto 28));
    l_block_n130 <= unsigned(l_y_s9);
    l_block_n131 <= l_block_n129 & l_block_n130;
    l_block_n132 <= l_block_n131(13 downto 0);
    l_block_n133 <= l_block_n132 & l_block_n76;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_1(0) = '1' then
                l_z_s10 <= l_z;
                l_block_n68_s10 <= l_block_n68;
                l_block_n131_s10 <= l_block_n131;
                l_block_n133_s10 <= l_block_n133;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- l_block
    l_block_n66_neg <= unsigned(-l_z_s10);
    l_block_n66 <= l_block_n66_neg when l_z_s10(28) = '1' else unsigned(l_z_s10);
    l_block_n67 <= l_block_n66;
    l_block_n69 <= l_block_n68_s10 or l_block_n67;
    l_block_largest <= l_block_n69;
    l_block_n72 <= l_block_largest;
    l_block_n73 <= l_block_n72(28 downto 13);
    l_block_n74 <= "1" when l_block_n73 = resize(l_block_n71, 16) else "0";
    l_block_n75 <= l_block_n72(12 downto 0);
    l_block_n77 <= l_block_n75 & l_block_n76;
    l_block_n78 <= l_block_n77 when l_block_n74(0) = '1' else l_block_n72;
    l_block_n79 <= l_block_n78(28 downto 21);
    l_block_n80 <= "1" when l_block_n79 = resize(l_block_n71, 8) else "0";
    l_block_n81 <= l_block_n78(20 downto 0);
    l_block_n83 <= l_block_n81 & l_block_n82;
    l_block_n84 <= l_block_n83 when l_block_n80(0) = '1' else l_block_n78;
    l_block_n85 <= l_block_n84(28 downto 25);
    l_block_n86 <= "1" when l_block_n85 = resize(l_block_n71, 4) else "0";
    l_block_n87 <= l_block_n84(24 downto 0);
    l_block_n89 <= l_block_n87 & l_block_n88;
    l_block_n99 <= l_block_n74 & l_block_n80;
    l_block_n100 <= l_block_n99 & l_block_n86;
    l_block_n103 <= "1" when l_block_largest = shift_left(resize(l_block_n71, 29), 15) else "0";
    l_block_n149 <= unsigned(l_z_s10(28 downto 28));
    l_block_n150 <= unsigned(l_z_s10);
    l_block_n151 <= l_block_n149 & l_block_n150;
    l_block_n152 <= l_block_n151(13 downto 0);
    l_block_n153 <= l_block_n152 & l_block_n76;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_2(0) = '1' then
                t_x_n27_s11 <= t_x_n27;
                l_block_n84_s11 <= l_block_n84;
                l_block_n86_s11 <= l_block_n86;
                l_block_n89_s11 <= l_block_n89;
                l_block_n100_s11 <= l_block_n100;
                l_block_n103_s11 <= l_block_n103;
                l_block_n151_s11 <= l_block_n151;
                l_block_n153_s11 <= l_block_n153;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    t_eye_x_sum <= resize(t_x_n27_s11, 35) + 35x"000000100";
    t_eye_x_cut <= t_eye_x_sum(34 downto 9);
    t_eye_x <= t_eye_x_cut;
    -- l_block
    l_block_n90 <= l_block_n89_s11 when l_block_n86_s11(0) = '1' else l_block_n84_s11;
    l_block_n91 <= l_block_n90(28 downto 27);
    l_block_n92 <= "1" when l_block_n91 = resize(l_block_n71, 2) else "0";
    l_block_n93 <= l_block_n90(26 downto 0);
    l_block_n95 <= l_block_n93 & l_block_n94;
    l_block_n96 <= l_block_n95 when l_block_n92(0) = '1' else l_block_n90;
    l_block_n97 <= l_block_n96(28 downto 28);
    l_block_n98 <= "1" when l_block_n97 = l_block_n71 else "0";
    l_block_n101 <= l_block_n100_s11 & l_block_n92;
    l_block_places <= l_block_n101 & l_block_n98;
    l_block_n107 <= l_block_places(4 downto 4);
    l_block_n110 <= l_block_n109_s9 when l_block_n107(0) = '1' else l_block_n106_s9;
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
    l_block_n134 <= l_block_n133_s10 when l_block_n107(0) = '1' else l_block_n131_s10;
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
    l_block_n154 <= l_block_n153_s11 when l_block_n107(0) = '1' else l_block_n151_s11;
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
            if ce = '1' and phase_3(0) = '1' then
                t_y_n32_s12 <= t_y_n32;
                t_eye_x_s12 <= t_eye_x;
                l_block_x_s12 <= l_block_x;
                l_block_y_s12 <= l_block_y;
                l_block_z_s12 <= l_block_z;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    t_eye_y_sum <= resize(t_y_n32_s12, 35) + 35x"000000100";
    t_eye_y_cut <= t_eye_y_sum(34 downto 9);
    t_eye_y <= t_eye_y_cut;
    l_norm_x_sum <= resize(l_block_x_s12, 31) + 31x"00000800";
    l_norm_x_cut <= l_norm_x_sum(30 downto 12);
    l_norm_x_over <= "1" when l_norm_x_cut(18) = '0' and (or l_norm_x_cut(17 downto 17)) = '1' else "0";
    l_norm_x <= 18x"1ffff" when l_norm_x_over(0) = '1' else l_norm_x_cut(17 downto 0);
    l_norm_y_sum <= resize(l_block_y_s12, 31) + 31x"00000800";
    l_norm_y_cut <= l_norm_y_sum(30 downto 12);
    l_norm_y_over <= "1" when l_norm_y_cut(18) = '0' and (or l_norm_y_cut(17 downto 17)) = '1' else "0";
    l_norm_y <= 18x"1ffff" when l_norm_y_over(0) = '1' else l_norm_y_cut(17 downto 0);
    l_norm_z_sum <= resize(l_block_z_s12, 31) + 31x"00000800";
    l_norm_z_cut <= l_norm_z_sum(30 downto 12);
    l_norm_z_over <= "1" when l_norm_z_cut(18) = '0' and (or l_norm_z_cut(17 downto 17)) = '1' else "0";
    l_norm_z <= 18x"1ffff" when l_norm_z_over(0) = '1' else l_norm_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_4(0) = '1' then
                t_z_n37_s13 <= t_z_n37;
                t_eye_y_s13 <= t_eye_y;
                l_norm_x_s13 <= l_norm_x;
                l_norm_y_s13 <= l_norm_y;
                l_norm_z_s13 <= l_norm_z;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    t_eye_z_sum <= resize(t_z_n37_s13, 35) + 35x"000000100";
    t_eye_z_cut <= t_eye_z_sum(34 downto 9);
    t_eye_z <= t_eye_z_cut;

    -- ---- stage 14 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_6(0) = '1' then
                b_x_n45_s15 <= b_x_n45;
                t_dot_l_n176_s15 <= t_dot_l_n176;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    b_eye_x_sum <= resize(b_x_n45_s15, 35) + 35x"000000100";
    b_eye_x_cut <= b_eye_x_sum(34 downto 9);
    b_eye_x <= b_eye_x_cut;
    t_l_sum <= resize(t_dot_l_n176_s15, 47) + 47x"000000004000";
    t_l_cut <= t_l_sum(46 downto 15);
    t_l <= t_l_cut;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_7(0) = '1' then
                b_y_n50_s16 <= b_y_n50;
                b_eye_x_s16 <= b_eye_x;
                t_l_s16 <= t_l;
                l_dot_l_n182_s16 <= l_dot_l_n182;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    b_eye_y_sum <= resize(b_y_n50_s16, 35) + 35x"000000100";
    b_eye_y_cut <= b_eye_y_sum(34 downto 9);
    b_eye_y <= b_eye_y_cut;
    reciprocal_length_square_sum <= resize(l_dot_l_n182_s16, 39) + 39x"0000002000";
    reciprocal_length_square_cut <= reciprocal_length_square_sum(38 downto 14);
    reciprocal_length_square_over <= "1" when reciprocal_length_square_cut(24) = '0' and (or reciprocal_length_square_cut(23 downto 22)) = '1' else "0";
    reciprocal_length_square_under <= unsigned(reciprocal_length_square_cut(24 downto 24));
    reciprocal_length_square <= 22x"3fffff" when reciprocal_length_square_over(0) = '1' else 22x"000000" when reciprocal_length_square_under(0) = '1' else unsigned(reciprocal_length_square_cut(21 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                s0_s17 <= s0_s9;
                t0_s17 <= t0_s9;
                b_z_n55_s17 <= b_z_n55;
                b_eye_y_s17 <= b_eye_y;
                reciprocal_length_square_s17 <= reciprocal_length_square;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s17 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    b_eye_z_sum <= resize(b_z_n55_s17, 35) + 35x"000000100";
    b_eye_z_cut <= b_eye_z_sum(34 downto 9);
    b_eye_z <= b_eye_z_cut;

    -- ---- stage 18 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_2(0) = '1' then
                l_block_n103_s19 <= l_block_n103_s11;
                b_dot_l_n233_s19 <= b_dot_l_n233;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    b_l_sum <= resize(b_dot_l_n233_s19, 47) + 47x"000000004000";
    b_l_cut <= b_l_sum(46 downto 15);
    b_l <= b_l_cut;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_3(0) = '1' then
                b_l_s20 <= b_l;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_5(0) = '1' then
                reciprocal_length_reciprocal_length_s22 <= reciprocal_length_reciprocal_length;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_6(0) = '1' then
                ds_product_s23 <= ds_product;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----
    ds_next_sum <= resize(ds_product_s23, 53) + 53x"00000000080000";
    ds_next_cut <= ds_next_sum(52 downto 20);
    ds_next_over <= "1" when ds_next_cut(32) = '0' and (or ds_next_cut(31 downto 26)) = '1' else "0";
    ds_next_under <= "1" when ds_next_cut(32) = '1' and (and ds_next_cut(31 downto 26)) = '0' else "0";
    ds_next <= 27x"3ffffff" when ds_next_over(0) = '1' else 27x"4000000" when ds_next_under(0) = '1' else ds_next_cut(26 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_7(0) = '1' then
                ds <= ds_next;
                dt_product_s24 <= dt_product;
            end if;
        end if;
    end process;

    -- ---- stage 24 ----
    dt_next_sum <= resize(dt_product_s24, 53) + 53x"00000000080000";
    dt_next_cut <= dt_next_sum(52 downto 20);
    dt_next_over <= "1" when dt_next_cut(32) = '0' and (or dt_next_cut(31 downto 26)) = '1' else "0";
    dt_next_under <= "1" when dt_next_cut(32) = '1' and (and dt_next_cut(31 downto 26)) = '0' else "0";
    dt_next <= 27x"3ffffff" when dt_next_over(0) = '1' else 27x"4000000" when dt_next_under(0) = '1' else dt_next_cut(26 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                t0_s25 <= t0_s17;
                s1_sum_s25 <= s1_sum;
                dt <= dt_next;
            end if;
            if rst = '1' then
                valid_s25 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s25 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 25 ----
    s1_next_over <= "1" when s1_sum_s25(27) = '0' and (or s1_sum_s25(26 downto 24)) = '1' else "0";
    s1_next_under <= "1" when s1_sum_s25(27) = '1' and (and s1_sum_s25(26 downto 24)) = '0' else "0";
    s1_next <= 25x"0ffffff" when s1_next_over(0) = '1' else 25x"1000000" when s1_next_under(0) = '1' else s1_sum_s25(24 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_1(0) = '1' then
                s1 <= s1_next;
                t1_sum_s26 <= t1_sum;
            end if;
        end if;
    end process;

    -- ---- stage 26 ----
    t1_next_over <= "1" when t1_sum_s26(27) = '0' and (or t1_sum_s26(26 downto 24)) = '1' else "0";
    t1_next_under <= "1" when t1_sum_s26(27) = '1' and (and t1_sum_s26(26 downto 24)) = '0' else "0";
    t1_next <= 25x"0ffffff" when t1_next_over(0) = '1' else 25x"1000000" when t1_next_under(0) = '1' else t1_sum_s26(24 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_2(0) = '1' then
                degenerate <= l_block_n103_s19;
                t1 <= t1_next;
            end if;
        end if;
    end process;

    -- ---- what dot1 takes ----
    phase_2_6 <= phase_2 or phase_6;
    phase_3_7 <= phase_3 or phase_7;
    dot1_in0 <= m1_x_s1 when phase_2_6(0) = '1' else m2_x_s1 when phase_3_7(0) = '1' else m0_x_s1;
    dot1_in1_next <= binormal_x_s1 when phase_4(0) = '1' else tangent_x;
    phase_0_4 <= phase_0 or phase_4;
    dot1_in2 <= m1_y_s1 when phase_2_6(0) = '1' else m2_y_s1 when phase_3_7(0) = '1' else m0_y_s1;
    dot1_in3_next <= binormal_y_s1 when phase_4(0) = '1' else tangent_y;
    dot1_in4 <= m1_z_s1 when phase_2_6(0) = '1' else m2_z_s1 when phase_3_7(0) = '1' else m0_z_s1;
    dot1_in5_next <= binormal_z_s1 when phase_4(0) = '1' else tangent_z;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0_4(0) = '1' then
                dot1_in1 <= dot1_in1_next;
                dot1_in3 <= dot1_in3_next;
                dot1_in5 <= dot1_in5_next;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 0 ----
    -- body
    dot1_body_n0 <= dot1_in0 * dot1_in1;
    dot1_body_n1 <= dot1_in2 * dot1_in3;
    dot1_body_n2 <= dot1_in4 * dot1_in5;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n0_s1 <= dot1_body_n0;
                dot1_body_n1_s1 <= dot1_body_n1;
                dot1_body_n2_s1 <= dot1_body_n2;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 1 ----
    -- body
    dot1_body_n3 <= resize(dot1_body_n0_s1, 33) + resize(dot1_body_n1_s1, 33);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n2_s2 <= dot1_body_n2_s1;
                dot1_body_n3_s2 <= dot1_body_n3;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 2 ----
    -- body
    dot1_body_n4 <= resize(dot1_body_n3_s2, 34) + resize(dot1_body_n2_s2, 34);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s3 <= dot1_body_n4;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 3 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s4 <= dot1_body_n4_s3;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 4 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s5 <= dot1_body_n4_s4;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 5 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s6 <= dot1_body_n4_s5;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 6 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s7 <= dot1_body_n4_s6;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 7 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s8 <= dot1_body_n4_s7;
            end if;
        end if;
    end process;

    -- ---- dot1, stage 8 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot1_body_n4_s9 <= dot1_body_n4_s8;
            end if;
        end if;
    end process;

    -- ---- what dot1 gives ----
    t_x_n27 <= dot1_body_n4_s9;
    t_y_n32 <= dot1_body_n4_s9;
    t_z_n37 <= dot1_body_n4_s9;
    b_x_n45 <= dot1_body_n4_s9;
    b_y_n50 <= dot1_body_n4_s9;
    b_z_n55 <= dot1_body_n4_s9;

    -- ---- what vfadder takes ----
    vfadder_in0 <= vertex_z_s9 when phase_1(0) = '1' else vertex_x_s1 when phase_7(0) = '1' else vertex_y_s1;
    vfadder_in1 <= light_z_s9 when phase_1(0) = '1' else light_x_s1 when phase_7(0) = '1' else light_y_s1;

    -- ---- vfadder, stage 0 ----
    vfadder_n0 <= resize(vfadder_in0, 29) - resize(vfadder_in1, 29);

    -- ---- what vfadder gives ----
    l_x <= vfadder_n0;
    l_y <= vfadder_n0;
    l_z <= vfadder_n0;

    -- ---- what dot2 takes ----
    dot2_in0_next <= t_eye_x_s12 when phase_5(0) = '1' else shift_left(resize(l_norm_x_s13, 26), 1) when phase_6(0) = '1' else b_eye_x_s16;
    phase_1_5 <= phase_1 or phase_5;
    phase_1_5_6 <= phase_1_5 or phase_6;
    dot2_in1_next <= l_norm_x_s13;
    dot2_in2_next <= t_eye_y_s13 when phase_5(0) = '1' else shift_left(resize(l_norm_y_s13, 26), 1) when phase_6(0) = '1' else b_eye_y_s17;
    dot2_in3_next <= l_norm_y_s13;
    dot2_in4_next <= t_eye_z when phase_5(0) = '1' else shift_left(resize(l_norm_z_s13, 26), 1) when phase_6(0) = '1' else b_eye_z;
    dot2_in5_next <= l_norm_z_s13;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_1_5_6(0) = '1' then
                dot2_in0 <= dot2_in0_next;
                dot2_in2 <= dot2_in2_next;
                dot2_in4 <= dot2_in4_next;
            end if;
            if ce = '1' and phase_5(0) = '1' then
                dot2_in1 <= dot2_in1_next;
                dot2_in3 <= dot2_in3_next;
                dot2_in5 <= dot2_in5_next;
            end if;
        end if;
    end process;

    -- ---- dot2, stage 0 ----
    -- body
    dot2_body_n0 <= dot2_in0 * dot2_in1;
    dot2_body_n1 <= dot2_in2 * dot2_in3;
    dot2_body_n2 <= dot2_in4 * dot2_in5;
    dot2_body_n3 <= resize(dot2_body_n0, 45) + resize(dot2_body_n1, 45);
    dot2_body_n4 <= resize(dot2_body_n3, 46) + resize(dot2_body_n2, 46);

    -- ---- what dot2 gives ----
    t_dot_l_n176 <= dot2_body_n4;
    l_dot_l_n182 <= dot2_body_n4(38 downto 1);
    b_dot_l_n233 <= dot2_body_n4;

    -- ---- what inverse_root takes ----
    inverse_root_in0 <= reciprocal_length_square_s17;

    -- ---- inverse_root, stage 0 ----
    inverse_root_n1 <= "0";
    inverse_root_n2 <= 16x"0000";
    inverse_root_n3 <= 8x"00";
    inverse_root_n4 <= 4x"0";
    inverse_root_n5 <= "00";
    inverse_root_n6 <= "1";
    inverse_root_n7 <= "1";
    -- body
    inverse_root_body_n0 <= inverse_root_in0;
    inverse_root_body_n1 <= inverse_root_body_n0;
    inverse_root_body_n2 <= inverse_root_body_n1(21 downto 6);
    inverse_root_body_n3 <= "1" when inverse_root_body_n2 = resize(inverse_root_n1, 16) else "0";
    inverse_root_body_n4 <= inverse_root_body_n1(5 downto 0);
    inverse_root_body_n5 <= inverse_root_body_n4 & inverse_root_n2;
    inverse_root_body_n6 <= inverse_root_body_n5 when inverse_root_body_n3(0) = '1' else inverse_root_body_n1;
    inverse_root_body_n7 <= inverse_root_body_n6(21 downto 14);
    inverse_root_body_n8 <= "1" when inverse_root_body_n7 = resize(inverse_root_n1, 8) else "0";
    inverse_root_body_n9 <= inverse_root_body_n6(13 downto 0);
    inverse_root_body_n10 <= inverse_root_body_n9 & inverse_root_n3;
    inverse_root_body_n11 <= inverse_root_body_n10 when inverse_root_body_n8(0) = '1' else inverse_root_body_n6;
    inverse_root_body_n12 <= inverse_root_body_n11(21 downto 18);
    inverse_root_body_n13 <= "1" when inverse_root_body_n12 = resize(inverse_root_n1, 4) else "0";
    inverse_root_body_n14 <= inverse_root_body_n11(17 downto 0);
    inverse_root_body_n15 <= inverse_root_body_n14 & inverse_root_n4;
    inverse_root_body_n16 <= inverse_root_body_n15 when inverse_root_body_n13(0) = '1' else inverse_root_body_n11;
    inverse_root_body_n17 <= inverse_root_body_n16(21 downto 20);
    inverse_root_body_n18 <= "1" when inverse_root_body_n17 = resize(inverse_root_n1, 2) else "0";
    inverse_root_body_n19 <= inverse_root_body_n16(19 downto 0);
    inverse_root_body_n20 <= inverse_root_body_n19 & inverse_root_n5;
    inverse_root_body_n22 <= inverse_root_body_n3 & inverse_root_body_n8;
    inverse_root_body_n23 <= inverse_root_body_n22 & inverse_root_body_n13;
    inverse_root_body_n24 <= inverse_root_body_n23 & inverse_root_body_n18;
    inverse_root_body_n40 <= "1" when inverse_root_in0 = shift_left(resize(inverse_root_n1, 22), 20) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                inverse_root_body_n16_s1 <= inverse_root_body_n16;
                inverse_root_body_n18_s1 <= inverse_root_body_n18;
                inverse_root_body_n20_s1 <= inverse_root_body_n20;
                inverse_root_body_n24_s1 <= inverse_root_body_n24;
                inverse_root_body_n40_s1 <= inverse_root_body_n40;
            end if;
        end if;
    end process;

    -- ---- inverse_root, stage 1 ----
    -- body
    inverse_root_body_n21 <= inverse_root_body_n20_s1 when inverse_root_body_n18_s1(0) = '1' else inverse_root_body_n16_s1;
    inverse_root_body_n25 <= inverse_root_body_n21(21 downto 20);
    inverse_root_body_n26 <= signed(resize(inverse_root_body_n25, 3)) - signed(resize(inverse_root_n6, 3));
    inverse_root_body_n27 <= unsigned(inverse_root_body_n26(1 downto 0));
    inverse_root_body_n28 <= inverse_root_body_n21(19 downto 2);
    inverse_root_body_n29 <= inverse_root_body_n27 & inverse_root_body_n28;
    inverse_root_body_n30 <= inverse_root_body_n29;
    inverse_root_body_n31 <= inverse_root_body_n30(19 downto 11);
    inverse_root_body_n34 <= inverse_root_body_n30(10 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                inverse_root_body_n24_s2 <= inverse_root_body_n24_s1;
                inverse_root_recip_root_row <= recip_root_rom(to_integer(inverse_root_body_n31));
                inverse_root_body_n34_s2 <= inverse_root_body_n34;
                inverse_root_body_n40_s2 <= inverse_root_body_n40_s1;
            end if;
        end if;
    end process;

    -- ---- inverse_root, stage 2 ----
    -- body
    inverse_root_body_n32 <= inverse_root_recip_root_row(38 downto 16);
    inverse_root_body_n33 <= signed(inverse_root_recip_root_row(15 downto 0));
    inverse_root_body_n35 <= resize(inverse_root_body_n33 * signed('0' & inverse_root_body_n34_s2), 27);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                inverse_root_body_n24_s3 <= inverse_root_body_n24_s2;
                inverse_root_body_n32_s3 <= inverse_root_body_n32;
                inverse_root_body_n35_s3 <= inverse_root_body_n35;
                inverse_root_body_n40_s3 <= inverse_root_body_n40_s2;
            end if;
        end if;
    end process;

    -- ---- inverse_root, stage 3 ----
    -- body
    inverse_root_body_n36 <= signed(shift_left(resize(inverse_root_body_n32_s3, 36), 11)) + resize(inverse_root_body_n35_s3, 36);
    inverse_root_body_n37_sum <= resize(inverse_root_body_n36, 37) + 37x"0000001000";
    inverse_root_body_n37_cut <= inverse_root_body_n37_sum(36 downto 13);
    inverse_root_body_n37_over <= "1" when inverse_root_body_n37_cut(23) = '0' and (or inverse_root_body_n37_cut(22 downto 22)) = '1' else "0";
    inverse_root_body_n37_under <= unsigned(inverse_root_body_n37_cut(23 downto 23));
    inverse_root_body_n37 <= 22x"3fffff" when inverse_root_body_n37_over(0) = '1' else 22x"000000" when inverse_root_body_n37_under(0) = '1' else unsigned(inverse_root_body_n37_cut(21 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                inverse_root_body_n24_s4 <= inverse_root_body_n24_s3;
                inverse_root_body_n37_s4 <= inverse_root_body_n37;
                inverse_root_body_n40_s4 <= inverse_root_body_n40_s3;
            end if;
        end if;
    end process;

    -- ---- inverse_root, stage 4 ----
    -- body
    inverse_root_body_n38_past <= "1" when 4x"b" < inverse_root_body_n24_s4 else "0";
    inverse_root_body_n38_count <= 4x"b" when inverse_root_body_n38_past(0) = '1' else inverse_root_body_n24_s4;
    inverse_root_body_n38 <= shift_left(resize(inverse_root_body_n37_s4, 33), to_integer(inverse_root_body_n38_count));
    inverse_root_body_n39 <= inverse_root_body_n38;
    inverse_root_body_n41 <= shift_left(resize(inverse_root_n7, 33), 23) when inverse_root_body_n40_s4(0) = '1' else inverse_root_body_n39;
    inverse_root_body_n42_sum <= resize(inverse_root_body_n41, 34) + 34x"000000004";
    inverse_root_body_n42_cut <= inverse_root_body_n42_sum(33 downto 3);
    inverse_root_body_n42_over <= "1" when (or inverse_root_body_n42_cut(30 downto 20)) = '1' else "0";
    inverse_root_body_n42 <= 20x"fffff" when inverse_root_body_n42_over(0) = '1' else inverse_root_body_n42_cut(19 downto 0);

    -- ---- what inverse_root gives ----
    reciprocal_length_reciprocal_length <= inverse_root_body_n42;

    -- ---- what multiplier takes ----
    multiplier_in0 <= b_l_s20 when phase_7(0) = '1' else t_l_s16;
    multiplier_in1 <= reciprocal_length_reciprocal_length_s22;

    -- ---- multiplier, stage 0 ----
    multiplier_n0 <= resize(multiplier_in0 * signed('0' & multiplier_in1), 52);

    -- ---- what multiplier gives ----
    ds_product <= multiplier_n0;
    dt_product <= multiplier_n0;

    -- ---- what adder takes ----
    adder_in0 <= t0_s25 when phase_1(0) = '1' else s0_s17;
    adder_in1 <= dt when phase_1(0) = '1' else ds;

    -- ---- adder, stage 0 ----
    adder_n0 <= resize(adder_in0, 28) + resize(adder_in1, 28);

    -- ---- what adder gives ----
    s1_sum <= adder_n0;
    t1_sum <= adder_n0;

    ready <= phase_0(0);
    valid_out <= valid_s25 and phase_3(0);
end architecture;
