-- rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
-- made by fixpath 0.1.0; the inverse square root unit of US 6,980,218, FIG. 8
--   input_bits=20 input_frac_bits=18 root_int_bits=9 root_scheme=linear root_addr_bits=9
--   root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 6 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   r_relative: mean 1.23e-6, largest seen 4.83e-6 over the result, at a=269281
--   r_scaled: mean 9.98e-7, largest seen 4.76e-6 over the result, at least 1, at a=269281
--   r: mean 5.17e-5, largest seen 1.46e-3 (383.0 ulp) at a=1
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at a=155754
-- stated bound on each relative (relative to the result): 1.37e-5
-- stated bound on each scaled (relative to the result, at least 1): 1.18e-5
-- stated bound on each absolute: 5.08e-3
-- stated bound on each flag: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity rsqrt is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        a : in unsigned(19 downto 0); -- u20f18
        valid_out : out std_logic;
        r : out unsigned(26 downto 0) := (others => '0'); -- u27f18
        degenerate : out unsigned(0 downto 0) := (others => '0') -- u1f0
    );
end entity;

architecture rtl of rsqrt is
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
    signal reciprocal_root_n1 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n3 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n4 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal reciprocal_root_n5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n6 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n7 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal reciprocal_root_n8 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n9 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n10 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal reciprocal_root_n11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n12 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal reciprocal_root_n13 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal reciprocal_root_n14 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n15 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n16 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n18 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal reciprocal_root_n19 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n20 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n21 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n22 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n24 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal reciprocal_root_n25 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n26 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n28 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n29 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal reciprocal_root_n32 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n47 : unsigned(0 downto 0) := (others => '0'); -- u1e9
    signal reciprocal_root_n48 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n21_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n22_s1 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n26_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n29_s1 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal reciprocal_root_n48_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s1 : std_logic;
    -- stage 1
    signal reciprocal_root_n23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n27 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n30 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n31 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n33 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal reciprocal_root_n34 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n35 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal reciprocal_root_n36 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n37 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal reciprocal_root_recip_root_n38 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal reciprocal_root_recip_root_n41 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_root_n30_s2 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row : unsigned(38 downto 0) := (others => '0');
    signal reciprocal_root_recip_root_n41_s2 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_root_n48_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal reciprocal_root_recip_root_n39 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal reciprocal_root_recip_root_n40 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal reciprocal_root_n30_s3 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_recip_root_n39_s3 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal reciprocal_root_recip_root_n40_s3 : signed(15 downto 0) := (others => '0'); -- s16f33
    signal reciprocal_root_recip_root_n41_s3 : unsigned(10 downto 0) := (others => '0'); -- u11f0
    signal reciprocal_root_n48_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal reciprocal_root_recip_root_n42 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal reciprocal_root_recip_root_n43 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal reciprocal_root_n30_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_recip_root_n43_s4 : signed(35 downto 0) := (others => '0'); -- s36f33
    signal reciprocal_root_n48_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal reciprocal_root_recip_root_n44_sum : signed(36 downto 0) := (others => '0');
    signal reciprocal_root_recip_root_n44_cut : signed(23 downto 0) := (others => '0');
    signal reciprocal_root_recip_root_n44_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_recip_root_n44_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_recip_root_n44 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_root_n45_past : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n45_count : unsigned(3 downto 0) := (others => '0');
    signal reciprocal_root_n45 : unsigned(31 downto 0) := (others => '0'); -- u32f20
    signal reciprocal_root_n46 : unsigned(31 downto 0) := (others => '0'); -- u32f21
    signal reciprocal_root_n49 : unsigned(31 downto 0) := (others => '0'); -- u32f21
    signal reciprocal_root_n48_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n49_s5 : unsigned(31 downto 0) := (others => '0'); -- u32f21
    signal valid_s5 : std_logic;
    -- stage 5
    signal reciprocal_root_n50_sum : unsigned(32 downto 0) := (others => '0');
    signal reciprocal_root_n50_cut : unsigned(29 downto 0) := (others => '0');
    signal reciprocal_root_n50_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n50 : unsigned(26 downto 0) := (others => '0'); -- u27f18
    signal n51 : unsigned(26 downto 0) := (others => '0'); -- u27f18
    signal valid_s6 : std_logic;
begin

    -- ---- stage 0 ----
    -- reciprocal_root
    reciprocal_root_n1 <= a;
    reciprocal_root_n2 <= "0";
    reciprocal_root_n3 <= reciprocal_root_n1;
    reciprocal_root_n4 <= reciprocal_root_n3(19 downto 4);
    reciprocal_root_n5 <= "1" when reciprocal_root_n4 = resize(reciprocal_root_n2, 16) else "0";
    reciprocal_root_n6 <= reciprocal_root_n3(3 downto 0);
    reciprocal_root_n7 <= 16x"0000";
    reciprocal_root_n8 <= reciprocal_root_n6 & reciprocal_root_n7;
    reciprocal_root_n9 <= reciprocal_root_n8 when reciprocal_root_n5(0) = '1' else reciprocal_root_n3;
    reciprocal_root_n10 <= reciprocal_root_n9(19 downto 12);
    reciprocal_root_n11 <= "1" when reciprocal_root_n10 = resize(reciprocal_root_n2, 8) else "0";
    reciprocal_root_n12 <= reciprocal_root_n9(11 downto 0);
    reciprocal_root_n13 <= 8x"00";
    reciprocal_root_n14 <= reciprocal_root_n12 & reciprocal_root_n13;
    reciprocal_root_n15 <= reciprocal_root_n14 when reciprocal_root_n11(0) = '1' else reciprocal_root_n9;
    reciprocal_root_n16 <= reciprocal_root_n15(19 downto 16);
    reciprocal_root_n17 <= "1" when reciprocal_root_n16 = resize(reciprocal_root_n2, 4) else "0";
    reciprocal_root_n18 <= reciprocal_root_n15(15 downto 0);
    reciprocal_root_n19 <= 4x"0";
    reciprocal_root_n20 <= reciprocal_root_n18 & reciprocal_root_n19;
    reciprocal_root_n21 <= reciprocal_root_n20 when reciprocal_root_n17(0) = '1' else reciprocal_root_n15;
    reciprocal_root_n22 <= reciprocal_root_n21(19 downto 18);
    reciprocal_root_n24 <= reciprocal_root_n21(17 downto 0);
    reciprocal_root_n25 <= "00";
    reciprocal_root_n26 <= reciprocal_root_n24 & reciprocal_root_n25;
    reciprocal_root_n28 <= reciprocal_root_n5 & reciprocal_root_n11;
    reciprocal_root_n29 <= reciprocal_root_n28 & reciprocal_root_n17;
    reciprocal_root_n32 <= "1";
    reciprocal_root_n47 <= "1";
    reciprocal_root_n48 <= "1" when a = shift_left(resize(reciprocal_root_n2, 20), 18) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n21_s1 <= reciprocal_root_n21;
                reciprocal_root_n22_s1 <= reciprocal_root_n22;
                reciprocal_root_n26_s1 <= reciprocal_root_n26;
                reciprocal_root_n29_s1 <= reciprocal_root_n29;
                reciprocal_root_n48_s1 <= reciprocal_root_n48;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- reciprocal_root
    reciprocal_root_n23 <= "1" when reciprocal_root_n22_s1 = resize(reciprocal_root_n2, 2) else "0";
    reciprocal_root_n27 <= reciprocal_root_n26_s1 when reciprocal_root_n23(0) = '1' else reciprocal_root_n21_s1;
    reciprocal_root_n30 <= reciprocal_root_n29_s1 & reciprocal_root_n23;
    reciprocal_root_n31 <= reciprocal_root_n27(19 downto 18);
    reciprocal_root_n33 <= signed(resize(reciprocal_root_n31, 3)) - signed(resize(reciprocal_root_n32, 3));
    reciprocal_root_n34 <= unsigned(reciprocal_root_n33(1 downto 0));
    reciprocal_root_n35 <= reciprocal_root_n27(17 downto 0);
    reciprocal_root_n36 <= reciprocal_root_n34 & reciprocal_root_n35;
    reciprocal_root_n37 <= reciprocal_root_n36;
    -- reciprocal_root.recip_root
    reciprocal_root_recip_root_n38 <= reciprocal_root_n37(19 downto 11);
    reciprocal_root_recip_root_n41 <= reciprocal_root_n37(10 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s2 <= reciprocal_root_n30;
                recip_root_row <= recip_root_rom(to_integer(reciprocal_root_recip_root_n38));
                reciprocal_root_recip_root_n41_s2 <= reciprocal_root_recip_root_n41;
                reciprocal_root_n48_s2 <= reciprocal_root_n48_s1;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- reciprocal_root.recip_root
    reciprocal_root_recip_root_n39 <= recip_root_row(38 downto 16);
    reciprocal_root_recip_root_n40 <= signed(recip_root_row(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s3 <= reciprocal_root_n30_s2;
                reciprocal_root_recip_root_n39_s3 <= reciprocal_root_recip_root_n39;
                reciprocal_root_recip_root_n40_s3 <= reciprocal_root_recip_root_n40;
                reciprocal_root_recip_root_n41_s3 <= reciprocal_root_recip_root_n41_s2;
                reciprocal_root_n48_s3 <= reciprocal_root_n48_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- reciprocal_root.recip_root
    reciprocal_root_recip_root_n42 <= resize(reciprocal_root_recip_root_n40_s3 * signed('0' & reciprocal_root_recip_root_n41_s3), 27);
    reciprocal_root_recip_root_n43 <= signed(shift_left(resize(reciprocal_root_recip_root_n39_s3, 36), 11)) + resize(reciprocal_root_recip_root_n42, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s4 <= reciprocal_root_n30_s3;
                reciprocal_root_recip_root_n43_s4 <= reciprocal_root_recip_root_n43;
                reciprocal_root_n48_s4 <= reciprocal_root_n48_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- reciprocal_root.recip_root
    reciprocal_root_recip_root_n44_sum <= resize(reciprocal_root_recip_root_n43_s4, 37) + 37x"0000001000";
    reciprocal_root_recip_root_n44_cut <= reciprocal_root_recip_root_n44_sum(36 downto 13);
    reciprocal_root_recip_root_n44_over <= "1" when reciprocal_root_recip_root_n44_cut(23) = '0' and (or reciprocal_root_recip_root_n44_cut(22 downto 22)) = '1' else "0";
    reciprocal_root_recip_root_n44_under <= unsigned(reciprocal_root_recip_root_n44_cut(23 downto 23));
    reciprocal_root_recip_root_n44 <= 22x"3fffff" when reciprocal_root_recip_root_n44_over(0) = '1' else 22x"000000" when reciprocal_root_recip_root_n44_under(0) = '1' else unsigned(reciprocal_root_recip_root_n44_cut(21 downto 0));
    -- reciprocal_root
    reciprocal_root_n45_past <= "1" when 4x"a" < reciprocal_root_n30_s4 else "0";
    reciprocal_root_n45_count <= 4x"a" when reciprocal_root_n45_past(0) = '1' else reciprocal_root_n30_s4;
    reciprocal_root_n45 <= shift_left(resize(reciprocal_root_recip_root_n44, 32), to_integer(reciprocal_root_n45_count));
    reciprocal_root_n46 <= reciprocal_root_n45;
    reciprocal_root_n49 <= shift_left(resize(reciprocal_root_n47, 32), 30) when reciprocal_root_n48_s4(0) = '1' else reciprocal_root_n46;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n48_s5 <= reciprocal_root_n48_s4;
                reciprocal_root_n49_s5 <= reciprocal_root_n49;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- reciprocal_root
    reciprocal_root_n50_sum <= resize(reciprocal_root_n49_s5, 33) + 33x"000000004";
    reciprocal_root_n50_cut <= reciprocal_root_n50_sum(32 downto 3);
    reciprocal_root_n50_over <= "1" when (or reciprocal_root_n50_cut(29 downto 27)) = '1' else "0";
    reciprocal_root_n50 <= 27x"7ffffff" when reciprocal_root_n50_over(0) = '1' else reciprocal_root_n50_cut(26 downto 0);
    -- (unit)
    n51 <= shift_left(resize(reciprocal_root_n2, 27), 18) when reciprocal_root_n48_s5(0) = '1' else reciprocal_root_n50;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                degenerate <= reciprocal_root_n48_s5;
                r <= n51;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----

    valid_out <= valid_s6;
end architecture;
