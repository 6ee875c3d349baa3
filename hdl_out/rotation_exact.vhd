-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
-- Angular Operation, section 3.1 and Fig. 7
--   variant=exact output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
--   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
--   stages=auto rom=block
-- latency 3 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   angle: mean 1.41e-3 rad, largest seen 4.85e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   dot: mean 1.65e-3, largest seen 4.85e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   x: mean 9.18e-4, largest seen 4.10e-3 (268.8 ulp) at phi_a=29150 theta_a=16832 phi_n=13217 theta_n=8896
--   y: mean 7.11e-4, largest seen 2.97e-3 (194.4 ulp) at phi_a=63595 theta_a=15808 phi_n=31274 theta_n=12249
--   z: mean 8.46e-4, largest seen 3.82e-3 (250.3 ulp) at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
-- stated bound on each component: 6.05e-3
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity rotation_exact is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        phi_a : in unsigned(15 downto 0); -- u16f16
        theta_a : in unsigned(15 downto 0); -- u16f16
        phi_n : in unsigned(15 downto 0); -- u16f16
        theta_n : in unsigned(15 downto 0); -- u16f16
        valid_out : out std_logic;
        x : out signed(17 downto 0) := (others => '0'); -- s18f16
        y : out signed(17 downto 0) := (others => '0'); -- s18f16
        z : out signed(17 downto 0) := (others => '0') -- s18f16
    );
end entity;

architecture rtl of rotation_exact is
    attribute rom_style : string;

    -- table sincos: sin s20f18, cos s20f18
    type sincos_rom_rows is array (0 to 1023) of unsigned(39 downto 0);
    constant sincos_rom : sincos_rom_rows := (
        40x"003183fffe", 40x"009603fff4", 40x"00fa83ffe0", 40x"015f13ffc3",
        40x"01c393ff9b", 40x"022803ff6a", 40x"028c83ff2f", 40x"02f0f3feea",
        40x"035553fe9b", 40x"03b9b3fe42", 40x"041e13fde0", 40x"048263fd73",
        40x"04e6a3fcfd", 40x"054ad3fc7d", 40x"05af03fbf3", 40x"061313fb5f",
        40x"067723fac2", 40x"06db23fa1a", 40x"073f13f969", 40x"07a2e3f8ae",
        40x"0806b3f7e9", 40x"086a63f71b", 40x"08ce03f642", 40x"093183f560",
        40x"0994f3f474", 40x"09f853f37e", 40x"0a5b93f27f", 40x"0abeb3f176",
        40x"0b21c3f063", 40x"0b84b3ef46", 40x"0be793ee20", 40x"0c4a43ecf0",
        40x"0cace3ebb6", 40x"0d0f53ea73", 40x"0d71b3e926", 40x"0dd3f3e7cf",
        40x"0e3603e66f", 40x"0e97f3e505", 40x"0ef9c3e391", 40x"0f5b73e214",
        40x"0fbcf3e08d", 40x"101e53defd", 40x"107f83dd63", 40x"10e093dbc0",
        40x"114183da13", 40x"11a233d85c", 40x"1202c3d69c", 40x"126323d4d3",
        40x"12c353d300", 40x"132363d124", 40x"138333cf3e", 40x"13e2d3cd4f",
        40x"144253cb57", 40x"14a193c955", 40x"1500a3c749", 40x"155f83c535",
        40x"15be23c317", 40x"161c93c0f0", 40x"167ad3bec0", 40x"16d8d3bc86",
        40x"1736a3ba43", 40x"179433b7f7", 40x"17f193b5a2", 40x"184eb3b344",
        40x"18ab93b0dc", 40x"190833ae6c", 40x"196493abf2", 40x"19c0c3a96f",
        40x"1a1ca3a6e4", 40x"1a7853a44f", 40x"1ad3b3a1b1", 40x"1b2ee39f0a",
        40x"1b89c39c5b", 40x"1be45399a2", 40x"1c3eb396e1", 40x"1c98c39416",
        40x"1cf2939143", 40x"1d4c138e67", 40x"1da5538b83", 40x"1dfe438895",
        40x"1e56f3859f", 40x"1eaf5382a0", 40x"1f07637f99", 40x"1f5f237c89",
        40x"1fb6a37970", 40x"200dd3764e", 40x"2064a37325", 40x"20bb336ff2",
        40x"2111736cb7", 40x"2167536974", 40x"21bcf36628", 40x"22123362d4",
        40x"2267235f78", 40x"22bbc35c13", 40x"23100358a6", 40x"2363f35531",
        40x"23b78351b3", 40x"240ac34e2d", 40x"245db34a9f", 40x"24b0334709",
        40x"250273436b", 40x"2554433fc5", 40x"25a5c33c17", 40x"25f6d33861",
        40x"26479334a3", 40x"26980330dc", 40x"26e8032d0f", 40x"2737a32939",
        40x"2786e3255b", 40x"27d5c32176", 40x"2824431d89", 40x"2872531994",
        40x"28c0131598", 40x"290d631194", 40x"295a530d88", 40x"29a6d30975",
        40x"29f2f3055b", 40x"2a3eb30139", 40x"2a8a02fd0f", 40x"2ad4e2f8df",
        40x"2b1f62f4a6", 40x"2b6972f067", 40x"2bb322ec20", 40x"2bfc62e7d2",
        40x"2c4532e37d", 40x"2c8d92df21", 40x"2cd582dabe", 40x"2d1d02d654",
        40x"2d6422d1e2", 40x"2daac2cd6a", 40x"2df102c8eb", 40x"2e36c2c465",
        40x"2e7c12bfd8", 40x"2ec0f2bb44", 40x"2f0562b6aa", 40x"2f4962b209",
        40x"2f8ce2ad61", 40x"2fcff2a8b3", 40x"301282a3fe", 40x"3054a29f42",
        40x"3096529a80", 40x"30d78295b8", 40x"31184290e9", 40x"3158828c14",
        40x"3198428739", 40x"31d7928257", 40x"3216627d70", 40x"3254c27882",
        40x"329292738e", 40x"32cff26e94", 40x"330cd26994", 40x"334932648e",
        40x"3385225f82", 40x"33c0825a70", 40x"33fb625558", 40x"3435d2503b",
        40x"346fb24b18", 40x"34a91245ef", 40x"34e1f240c1", 40x"351a523b8d",
        40x"3552323654", 40x"3589823115", 40x"35c0522bd1", 40x"35f6a22687",
        40x"362c722138", 40x"3661b21be4", 40x"369672168b", 40x"36caa2112c",
        40x"36fe520bc9", 40x"3731820660", 40x"37642200f2", 40x"379631fb80",
        40x"37c7c1f608", 40x"37f8d1f08c", 40x"382941eb0b", 40x"385931e585",
        40x"388891dffb", 40x"38b771da6b", 40x"38e5c1d4d8", 40x"391381cf3f",
        40x"3940b1c9a3", 40x"396d61c402", 40x"399971be5c", 40x"39c501b8b2",
        40x"39f001b304", 40x"3a1a71ad52", 40x"3a4441a79c", 40x"3a6d91a1e1",
        40x"3a96519c23", 40x"3abe819660", 40x"3ae621909a", 40x"3b0d318ad0",
        40x"3b33a18502", 40x"3b59917f30", 40x"3b7ee1795b", 40x"3ba3a17382",
        40x"3bc7d16da5", 40x"3beb7167c5", 40x"3c0e7161e1", 40x"3c30f15bfa",
        40x"3c52d1560f", 40x"3c74115022", 40x"3c94d14a31", 40x"3cb4f1443d",
        40x"3cd4713e45", 40x"3cf361384b", 40x"3d11c1324e", 40x"3d2f912c4d",
        40x"3d4cc1264a", 40x"3d69512044", 40x"3d85511a3b", 40x"3da0c11430",
        40x"3dbb910e22", 40x"3dd5d10811", 40x"3def7101fd", 40x"3e0870fbe8",
        40x"3e20e0f5cf", 40x"3e38b0efb5", 40x"3e4ff0e998", 40x"3e6690e378",
        40x"3e7ca0dd57", 40x"3e9200d734", 40x"3ea6e0d10e", 40x"3ebb10cae6",
        40x"3eceb0c4bd", 40x"3ee1b0be91", 40x"3ef420b864", 40x"3f05f0b235",
        40x"3f1720ac04", 40x"3f27b0a5d2", 40x"3f37b09f9e", 40x"3f47009968",
        40x"3f55c09331", 40x"3f63f08cf9", 40x"3f717086bf", 40x"3f7e608084",
        40x"3f8ab07a47", 40x"3f9660740a", 40x"3fa1806dcb", 40x"3fabf0678b",
        40x"3fb5d0614b", 40x"3fbf105b09", 40x"3fc7b054c6", 40x"3fcfb04e83",
        40x"3fd720483f", 40x"3fdde041fa", 40x"3fe4103bb5", 40x"3fe9a0356f",
        40x"3fee902f28", 40x"3ff2e028e1", 40x"3ff690229a", 40x"3ff9b01c52",
        40x"3ffc20160a", 40x"3ffe000fc2", 40x"3fff400979", 40x"3fffe00331",
        40x"3fffeffce8", 40x"3fff4ff6a0", 40x"3ffe0ff058", 40x"3ffc3fea0f",
        40x"3ff9bfe3c7", 40x"3ff6afdd80", 40x"3ff2ffd738", 40x"3feeafd0f1",
        40x"3fe9bfcaab", 40x"3fe42fc465", 40x"3fde0fbe1f", 40x"3fd73fb7da",
        40x"3fcfdfb196", 40x"3fc7dfab53", 40x"3fbf3fa510", 40x"3fb5ff9ecf",
        40x"3fac2f988e", 40x"3fa1af924e", 40x"3f969f8c0f", 40x"3f8aef85d2",
        40x"3f7e9f7f95", 40x"3f71bf795a", 40x"3f642f7320", 40x"3f560f6ce8",
        40x"3f474f66b1", 40x"3f37ef607b", 40x"3f27ff5a47", 40x"3f176f5415",
        40x"3f063f4de4", 40x"3ef46f47b5", 40x"3ee20f4187", 40x"3ecf0f3b5c",
        40x"3ebb6f3532", 40x"3ea73f2f0b", 40x"3e926f28e5", 40x"3e7cff22c1",
        40x"3e66ff1ca0", 40x"3e505f1681", 40x"3e391f1064", 40x"3e214f0a49",
        40x"3e08df0431", 40x"3defdefe1b", 40x"3dd63ef808", 40x"3dbc0ef1f7",
        40x"3da13eebe8", 40x"3d85cee5dd", 40x"3d69cedfd4", 40x"3d4d3ed9ce",
        40x"3d300ed3cb", 40x"3d124ecdca", 40x"3cf3eec7cd", 40x"3cd4fec1d3",
        40x"3cb57ebbdb", 40x"3c955eb5e7", 40x"3c749eaff6", 40x"3c535eaa08",
        40x"3c317ea41e", 40x"3c0f0e9e37", 40x"3bec0e9853", 40x"3bc86e9273",
        40x"3ba43e8c96", 40x"3b7f7e86bd", 40x"3b5a2e80e7", 40x"3b344e7b15",
        40x"3b0dce7547", 40x"3ae6ce6f7d", 40x"3abf2e69b7", 40x"3a96fe63f4",
        40x"3a6e4e5e36", 40x"3a44fe587b", 40x"3a1b1e52c5", 40x"39f0ae4d12",
        40x"39c5be4764", 40x"399a2e41bb", 40x"396e1e3c15", 40x"39416e3674",
        40x"39143e30d7", 40x"38e67e2b3f", 40x"38b83e25ab", 40x"38895e201c",
        40x"3859fe1a91", 40x"382a0e150b", 40x"37f99e0f8a", 40x"37c89e0a0e",
        40x"37970e0496", 40x"3764edff23", 40x"37325df9b6", 40x"36ff2df44d",
        40x"36cb7deee9", 40x"36974de98b", 40x"36628de431", 40x"362d4ddedd",
        40x"35f78dd98e", 40x"35c13dd444", 40x"358a6dcf00", 40x"35531dc9c1",
        40x"351b3dc488", 40x"34e2ddbf54", 40x"34a9fdba25", 40x"34709db4fd",
        40x"3436bdafd9", 40x"33fc5daabc", 40x"33c17da5a4", 40x"33861da093",
        40x"334a3d9b87", 40x"330dcd9680", 40x"32d0fd9180", 40x"32939d8c86",
        40x"3255bd8792", 40x"32176d82a4", 40x"31d89d7dbc", 40x"31994d78db",
        40x"31598d73ff", 40x"31194d6f2a", 40x"30d88d6a5b", 40x"30975d6593",
        40x"3055bd60d1", 40x"30139d5c15", 40x"2fd0fd5760", 40x"2f8dfd52b2",
        40x"2f4a6d4e0a", 40x"2f067d4969", 40x"2ec20d44ce", 40x"2e7d2d403a",
        40x"2e37dd3bad", 40x"2df21d3727", 40x"2dabed32a8", 40x"2d654d2e30",
        40x"2d1e2d29be", 40x"2cd6ad2554", 40x"2c8ebd20f0", 40x"2c465d1c94",
        40x"2bfd8d183f", 40x"2bb44d13f1", 40x"2b6aad0faa", 40x"2b209d0b6a",
        40x"2ad61d0732", 40x"2a8b3d0301", 40x"2a3fecfed8", 40x"29f42cfab6",
        40x"29a80cf69b", 40x"295b8cf288", 40x"290e9cee7c", 40x"28c14cea78",
        40x"28739ce67c", 40x"28257ce287", 40x"27d70cde9a", 40x"27882cdab4",
        40x"2738ecd6d7", 40x"26e94cd301", 40x"26994ccf33", 40x"2648eccb6d",
        40x"25f82cc7ae", 40x"25a70cc3f8", 40x"25558cc04a", 40x"2503bcbca3",
        40x"24b18cb905", 40x"245efcb56f", 40x"240c1cb1e1", 40x"23b8dcae5b",
        40x"23654caadd", 40x"23115ca768", 40x"22bd1ca3fb", 40x"22687ca096",
        40x"22138c9d39", 40x"21be4c99e5", 40x"2168bc9699", 40x"2112cc9356",
        40x"20bc9c901b", 40x"20660c8ce8", 40x"200f2c89be", 40x"1fb80c869d",
        40x"1f608c8384", 40x"1f08cc8073", 40x"1eb0bc7d6c", 40x"1e585c7a6d",
        40x"1dffbc7777", 40x"1da6bc7489", 40x"1d4d8c71a4", 40x"1cf3fc6ec8",
        40x"1c9a3c6bf5", 40x"1c402c692a", 40x"1be5cc6669", 40x"1b8b2c63b0",
        40x"1b304c6100", 40x"1ad52c5e59", 40x"1a79cc5bbc", 40x"1a1e1c5927",
        40x"19c23c569b", 40x"19660c5418", 40x"1909ac519e", 40x"18ad0c4f2d",
        40x"18502c4cc6", 40x"17f30c4a67", 40x"1795bc4812", 40x"17382c45c6",
        40x"16da5c4383", 40x"167c5c4149", 40x"161e1c3f19", 40x"15bfac3cf1",
        40x"1560fc3ad3", 40x"15022c38bf", 40x"14a31c36b3", 40x"1443dc34b1",
        40x"13e45c32b9", 40x"1384bc30ca", 40x"1324ec2ee4", 40x"12c4dc2d07",
        40x"1264ac2b34", 40x"12044c296b", 40x"11a3bc27ab", 40x"11430c25f4",
        40x"10e22c2447", 40x"10811c22a3", 40x"101fdc2109", 40x"0fbe8c1f79",
        40x"0f5cfc1df2", 40x"0efb5c1c75", 40x"0e998c1b01", 40x"0e378c1997",
        40x"0dd57c1836", 40x"0d734c16e0", 40x"0d10ec1592", 40x"0cae6c144f",
        40x"0c4bdc1315", 40x"0be91c11e5", 40x"0b864c10be", 40x"0b235c0fa1",
        40x"0ac04c0e8e", 40x"0a5d2c0d85", 40x"09f9ec0c85", 40x"09968c0b90",
        40x"09331c0aa4", 40x"08cf9c09c1", 40x"086bfc08e9", 40x"08084c081a",
        40x"07a47c0755", 40x"0740ac069a", 40x"06dcbc05e8", 40x"0678bc0541",
        40x"0614bc04a3", 40x"05b09c040f", 40x"054c6c0385", 40x"04e83c0305",
        40x"0483fc028e", 40x"041fac0222", 40x"03bb5c01bf", 40x"0356fc0166",
        40x"02f28c0117", 40x"028e1c00d2", 40x"0229ac0097", 40x"01c52c0065",
        40x"0160ac003e", 40x"00fc2c0020", 40x"00979c000c", 40x"00331c0002",
        40x"ffce8c0002", 40x"ff6a0c000c", 40x"ff058c0020", 40x"fea0fc003d",
        40x"fe3c7c0065", 40x"fdd80c0096", 40x"fd738c00d1", 40x"fd0f1c0116",
        40x"fcaabc0165", 40x"fc465c01be", 40x"fbe1fc0220", 40x"fb7dac028d",
        40x"fb196c0303", 40x"fab53c0383", 40x"fa510c040d", 40x"f9ecfc04a1",
        40x"f988ec053e", 40x"f924ec05e6", 40x"f8c0fc0697", 40x"f85d2c0752",
        40x"f7f95c0817", 40x"f795ac08e5", 40x"f7320c09be", 40x"f6ce8c0aa0",
        40x"f66b1c0b8c", 40x"f607bc0c82", 40x"f5a47c0d81", 40x"f5415c0e8a",
        40x"f4de4c0f9d", 40x"f47b5c10ba", 40x"f4187c11e0", 40x"f3b5cc1310",
        40x"f3532c144a", 40x"f2f0bc158d", 40x"f28e5c16da", 40x"f22c1c1831",
        40x"f1ca0c1991", 40x"f1681c1afb", 40x"f1064c1c6f", 40x"f0a49c1dec",
        40x"f0431c1f73", 40x"efe1bc2103", 40x"ef808c229d", 40x"ef1f7c2440",
        40x"eebe8c25ed", 40x"ee5ddc27a4", 40x"edfd4c2964", 40x"ed9cec2b2d",
        40x"ed3cbc2d00", 40x"ecdcac2edc", 40x"ec7cdc30c2", 40x"ec1d3c32b1",
        40x"ebbdbc34a9", 40x"eb5e7c36ab", 40x"eaff6c38b7", 40x"eaa08c3acb",
        40x"ea41ec3ce9", 40x"e9e37c3f10", 40x"e9853c4140", 40x"e9273c437a",
        40x"e8c96c45bd", 40x"e86bdc4809", 40x"e80e7c4a5e", 40x"e7b15c4cbc",
        40x"e7547c4f24", 40x"e6f7dc5194", 40x"e69b7c540e", 40x"e63f4c5691",
        40x"e5e36c591c", 40x"e587bc5bb1", 40x"e52c5c5e4f", 40x"e4d12c60f6",
        40x"e4764c63a5", 40x"e41bbc665e", 40x"e3c15c691f", 40x"e3674c6bea",
        40x"e30d7c6ebd", 40x"e2b3fc7199", 40x"e25abc747d", 40x"e201cc776b",
        40x"e1a91c7a61", 40x"e150bc7d60", 40x"e0f8ac8067", 40x"e0a0ec8377",
        40x"e0496c8690", 40x"dff23c89b2", 40x"df9b6c8cdb", 40x"df44dc900e",
        40x"deee9c9349", 40x"de98bc968c", 40x"de431c99d8", 40x"ddeddc9d2c",
        40x"dd98eca088", 40x"dd444ca3ed", 40x"dcf00ca75a", 40x"dc9c1caacf",
        40x"dc488cae4d", 40x"dbf54cb1d3", 40x"dba25cb561", 40x"db4fdcb8f7",
        40x"dafd9cbc95", 40x"daabccc03b", 40x"da5a4cc3e9", 40x"da093cc79f",
        40x"d9b87ccb5d", 40x"d9680ccf24", 40x"d9180cd2f1", 40x"d8c86cd6c7",
        40x"d8792cdaa5", 40x"d82a4cde8a", 40x"d7dbcce277", 40x"d78dbce66c",
        40x"d73ffcea68", 40x"d6f2acee6c", 40x"d6a5bcf278", 40x"d6593cf68b",
        40x"d60d1cfaa5", 40x"d5c15cfec7", 40x"d5760d02f1", 40x"d52b2d0721",
        40x"d4e0ad0b5a", 40x"d4969d0f99", 40x"d44ced13e0", 40x"d403ad182e",
        40x"d3badd1c83", 40x"d3727d20df", 40x"d32a8d2542", 40x"d2e30d29ac",
        40x"d29bed2e1e", 40x"d2554d3296", 40x"d20f0d3715", 40x"d1c94d3b9b",
        40x"d183fd4028", 40x"d13f1d44bc", 40x"d0faad4956", 40x"d0b6ad4df7",
        40x"d0732d529f", 40x"d0301d574d", 40x"cfed8d5c02", 40x"cfab6d60be",
        40x"cf69bd6580", 40x"cf288d6a48", 40x"cee7cd6f17", 40x"cea78d73ec",
        40x"ce67cd78c7", 40x"ce287d7da9", 40x"cde9ad8290", 40x"cdab4d877e",
        40x"cd6d7d8c72", 40x"cd301d916c", 40x"ccf33d966c", 40x"ccb6dd9b72",
        40x"cc7aeda07e", 40x"cc3f8da590", 40x"cc04adaaa8", 40x"cbca3dafc5",
        40x"cb905db4e8", 40x"cb56fdba11", 40x"cb1e1dbf3f", 40x"cae5bdc473",
        40x"caadddc9ac", 40x"ca768dceeb", 40x"ca3fbdd42f", 40x"ca096dd979",
        40x"c9d39ddec8", 40x"c99e5de41c", 40x"c9699de975", 40x"c9356deed4",
        40x"c901bdf437", 40x"c8ce8df9a0", 40x"c89bedff0e", 40x"c869de0480",
        40x"c8384e09f8", 40x"c8073e0f74", 40x"c7d6ce14f5", 40x"c7a6de1a7b",
        40x"c7777e2005", 40x"c7489e2595", 40x"c71a4e2b28", 40x"c6ec8e30c1",
        40x"c6bf5e365d", 40x"c692ae3bfe", 40x"c6669e41a4", 40x"c63b0e474e",
        40x"c6100e4cfc", 40x"c5e59e52ae", 40x"c5bbce5864", 40x"c5927e5e1f",
        40x"c569be63dd", 40x"c5418e69a0", 40x"c519ee6f66", 40x"c4f2de7530",
        40x"c4cc6e7afe", 40x"c4a67e80d0", 40x"c4812e86a5", 40x"c45c6e8c7e",
        40x"c4383e925b", 40x"c4149e983b", 40x"c3f19e9e1f", 40x"c3cf1ea406",
        40x"c3ad3ea9f1", 40x"c38bfeafde", 40x"c36b3eb5cf", 40x"c34b1ebbc3",
        40x"c32b9ec1bb", 40x"c30caec7b5", 40x"c2ee4ecdb2", 40x"c2d07ed3b3",
        40x"c2b34ed9b6", 40x"c296bedfbc", 40x"c27abee5c5", 40x"c25f4eebd0",
        40x"c2447ef1de", 40x"c22a3ef7ef", 40x"c2109efe03", 40x"c1f79f0418",
        40x"c1df2f0a31", 40x"c1c75f104b", 40x"c1b01f1668", 40x"c1997f1c88",
        40x"c1836f22a9", 40x"c16e0f28cc", 40x"c1592f2ef2", 40x"c144ff351a",
        40x"c1315f3b43", 40x"c11e5f416f", 40x"c10bef479c", 40x"c0fa1f4dcb",
        40x"c0e8ef53fc", 40x"c0d85f5a2e", 40x"c0c85f6062", 40x"c0b90f6698",
        40x"c0aa4f6ccf", 40x"c09c1f7307", 40x"c08e9f7941", 40x"c081af7f7c",
        40x"c0755f85b9", 40x"c069af8bf6", 40x"c05e8f9235", 40x"c0541f9875",
        40x"c04a3f9eb5", 40x"c040ffa4f7", 40x"c0385fab3a", 40x"c0305fb17d",
        40x"c028efb7c1", 40x"c0222fbe06", 40x"c01bffc44b", 40x"c0166fca91",
        40x"c0117fd0d8", 40x"c00d2fd71f", 40x"c0097fdd66", 40x"c0065fe3ae",
        40x"c003efe9f6", 40x"c0020ff03e", 40x"c000cff687", 40x"c0002ffccf",
        40x"c000200318", 40x"c000c00960", 40x"c002000fa8", 40x"c003d015f1",
        40x"c006501c39", 40x"c009602280", 40x"c00d1028c8", 40x"c011602f0f",
        40x"c016503555", 40x"c01be03b9b", 40x"c0220041e1", 40x"c028d04826",
        40x"c030304e6a", 40x"c0383054ad", 40x"c040d05af0", 40x"c04a106131",
        40x"c053e06772", 40x"c05e606db2", 40x"c0697073f1", 40x"c075207a2e",
        40x"c08170806b", 40x"c08e5086a6", 40x"c09be08ce0", 40x"c0aa009318",
        40x"c0b8c0994f", 40x"c0c8209f85", 40x"c0d810a5b9", 40x"c0e8a0abeb",
        40x"c0f9d0b21c", 40x"c10ba0b84b", 40x"c11e00be79", 40x"c13100c4a4",
        40x"c144a0cace", 40x"c158d0d0f5", 40x"c16da0d71b", 40x"c18310dd3f",
        40x"c19910e360", 40x"c1afb0e97f", 40x"c1c6f0ef9c", 40x"c1dec0f5b7",
        40x"c1f730fbcf", 40x"c2103101e5", 40x"c229d107f8", 40x"c244010e09",
        40x"c25ed11418", 40x"c27a411a23", 40x"c29641202c", 40x"c2b2d12632",
        40x"c2d0012c35", 40x"c2edc13236", 40x"c30c213833", 40x"c32b113e2d",
        40x"c34a914425", 40x"c36ab14a19", 40x"c38b71500a", 40x"c3acb155f8",
        40x"c3ce915be2", 40x"c3f10161c9", 40x"c4140167ad", 40x"c437a16d8d",
        40x"c45bd1736a", 40x"c480917943", 40x"c4a5e17f19", 40x"c4cbc184eb",
        40x"c4f2418ab9", 40x"c519419083", 40x"c540e19649", 40x"c569119c0c",
        40x"c591c1a1ca", 40x"c5bb11a785", 40x"c5e4f1ad3b", 40x"c60f61b2ee",
        40x"c63a51b89c", 40x"c665e1be45", 40x"c691f1c3eb", 40x"c6bea1c98c",
        40x"c6ebd1cf29", 40x"c71991d4c1", 40x"c747d1da55", 40x"c776b1dfe4",
        40x"c7a611e56f", 40x"c7d601eaf5", 40x"c80671f076", 40x"c83771f5f2",
        40x"c86901fb6a", 40x"c89b2200dd", 40x"c8cdb2064a", 40x"c900e20bb3",
        40x"c934921117", 40x"c968c21675", 40x"c99d821bcf", 40x"c9d2c22123",
        40x"ca08822672", 40x"ca3ed22bbc", 40x"ca75a23100", 40x"caacf2363f",
        40x"cae4d23b78", 40x"cb1d3240ac", 40x"cb561245db", 40x"cb8f724b03",
        40x"cbc9525027", 40x"cc03b25544", 40x"cc3e925a5c", 40x"cc79f25f6d",
        40x"ccb5d26479", 40x"ccf2426980", 40x"cd2f126e80", 40x"cd6c72737a",
        40x"cdaa52786e", 40x"cde8a27d5c", 40x"ce27728244", 40x"ce66c28725",
        40x"cea6828c01", 40x"cee6c290d6", 40x"cf278295a5", 40x"cf68b29a6d",
        40x"cfaa529f2f", 40x"cfec72a3eb", 40x"d02f12a8a0", 40x"d07212ad4e",
        40x"d0b5a2b1f6", 40x"d0f992b697", 40x"d13e02bb32", 40x"d182e2bfc6",
        40x"d1c832c453", 40x"d20df2c8d9", 40x"d25422cd58", 40x"d29ac2d1d0",
        40x"d2e1e2d642", 40x"d32962daac", 40x"d37152df10", 40x"d3b9b2e36c",
        40x"d40282e7c1", 40x"d44bc2ec0f", 40x"d49562f056", 40x"d4df72f496",
        40x"d529f2f8ce", 40x"d574d2fcff", 40x"d5c0230128", 40x"d60be3054a",
        40x"d658030965", 40x"d6a4830d78", 40x"d6f1731184", 40x"d73ec31588",
        40x"d78c731984", 40x"d7da931d79", 40x"d829032166", 40x"d877e3254c",
        40x"d8c7232929", 40x"d916c32cff", 40x"d966c330cd", 40x"d9b7233493",
        40x"da07e33852", 40x"da59033c08", 40x"daaa833fb6", 40x"dafc53435d",
        40x"db4e8346fb", 40x"dba1134a91", 40x"dbf3f34e1f", 40x"dc473351a5",
        40x"dc9ac35523", 40x"dceeb35898", 40x"dd42f35c05", 40x"dd97935f6a",
        40x"ddec8362c7", 40x"de41c3661b", 40x"de97536967", 40x"deed436caa",
        40x"df43736fe5", 40x"df9a037318", 40x"dff0e37642", 40x"e048037963",
        40x"e09f837c7c", 40x"e0f7437f8d", 40x"e14f538294", 40x"e1a7b38593",
        40x"e200538889", 40x"e259538b77", 40x"e2b2838e5c", 40x"e30c139138",
        40x"e365d3940b", 40x"e3bfe396d6", 40x"e41a439997", 40x"e474e39c50",
        40x"e4cfc39f00", 40x"e52ae3a1a7", 40x"e58643a444", 40x"e5e1f3a6d9",
        40x"e63dd3a965", 40x"e69a03abe8", 40x"e6f663ae62", 40x"e75303b0d3",
        40x"e7afe3b33a", 40x"e80d03b599", 40x"e86a53b7ee", 40x"e8c7e3ba3a",
        40x"e925b3bc7d", 40x"e983b3beb7", 40x"e9e1f3c0e7", 40x"ea4063c30f",
        40x"ea9f13c52d", 40x"eafde3c741", 40x"eb5cf3c94d", 40x"ebbc33cb4f",
        40x"ec1bb3cd47", 40x"ec7b53cf36", 40x"ecdb23d11c", 40x"ed3b33d2f9",
        40x"ed9b63d4cc", 40x"edfbc3d695", 40x"ee5c53d855", 40x"eebd03da0c",
        40x"ef1de3dbb9", 40x"ef7ef3dd5d", 40x"efe033def7", 40x"f04183e087",
        40x"f0a313e20e", 40x"f104b3e38b", 40x"f16683e4ff", 40x"f1c883e669",
        40x"f22a93e7ca", 40x"f28cc3e920", 40x"f2ef23ea6e", 40x"f351a3ebb1",
        40x"f3b433eceb", 40x"f416f3ee1b", 40x"f479c3ef42", 40x"f4dcb3f05f",
        40x"f53fc3f172", 40x"f5a2e3f27b", 40x"f60623f37b", 40x"f66983f470",
        40x"f6ccf3f55c", 40x"f73073f63f", 40x"f79413f717", 40x"f7f7c3f7e6",
        40x"f85b93f8ab", 40x"f8bf63f966", 40x"f92353fa18", 40x"f98753fabf",
        40x"f9eb53fb5d", 40x"fa4f73fbf1", 40x"fab3a3fc7b", 40x"fb17d3fcfb",
        40x"fb7c13fd72", 40x"fbe063fdde", 40x"fc44b3fe41", 40x"fca913fe9a",
        40x"fd0d83fee9", 40x"fd71f3ff2e", 40x"fdd663ff69", 40x"fe3ae3ff9b",
        40x"fe9f63ffc2", 40x"ff03e3ffe0", 40x"ff6873fff4", 40x"ffccf3fffe"
    );
    attribute rom_style of sincos_rom : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_2 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_2 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_3 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_3 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_4 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_4 : constant is "block";

    -- Words start at zero: numeric_std warns about comparing or indexing with undefined words.
    -- Valid bits don't, so a bit that a reset misses shows as unknown.
    -- stage 0
    signal angles_n4 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n6 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal angles_ang_x : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n8 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_ang_y : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n10 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal angles_x_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n12 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_x_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n14 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal angles_y_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n16 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_y_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n18 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal angles_a_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n20 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_a_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_n22 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n24 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n26 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n29 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n32 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n35 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n38 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n41 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_row : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_2 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_3 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_4 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_5 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_6 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_7 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_8 : unsigned(39 downto 0) := (others => '0');
    signal valid_s1 : std_logic;
    -- stage 1
    signal sincos_cos_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_xpn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_xpn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_xmn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_xmn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_ypn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_ypn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_ymn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_ymn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_apn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_apn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_amn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_amn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sums_n44 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_n45 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_n46 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal sums_n47 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal sums_n48 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_n49 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal sums_n51 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_y_sum : signed(20 downto 0) := (others => '0'); -- s21f19
    signal sums_n53 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_n54 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_n55 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal sums_n56 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal sums_n57 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal sums_n58 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal sums_n47_s2 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal sums_n49_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal sums_y_sum_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal sums_n56_s2 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal sums_n58_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal valid_s2 : std_logic;
    -- stage 2
    signal sums_x_sum : signed(22 downto 0) := (others => '0'); -- s23f20
    signal sums_z_sum : signed(22 downto 0) := (others => '0'); -- s23f20
    signal x_next_sum : signed(23 downto 0) := (others => '0');
    signal x_next_cut : signed(19 downto 0) := (others => '0');
    signal x_next_over : unsigned(0 downto 0) := (others => '0');
    signal x_next_under : unsigned(0 downto 0) := (others => '0');
    signal x_next : signed(17 downto 0) := (others => '0'); -- s18f16
    signal y_next_sum : signed(21 downto 0) := (others => '0');
    signal y_next_cut : signed(18 downto 0) := (others => '0');
    signal y_next_over : unsigned(0 downto 0) := (others => '0');
    signal y_next : signed(17 downto 0) := (others => '0'); -- s18f16
    signal z_next_sum : signed(23 downto 0) := (others => '0');
    signal z_next_cut : signed(19 downto 0) := (others => '0');
    signal z_next_over : unsigned(0 downto 0) := (others => '0');
    signal z_next_under : unsigned(0 downto 0) := (others => '0');
    signal z_next : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s3 : std_logic;
begin

    -- ---- stage 0 ----
    -- angles
    angles_n4 <= signed(resize(phi_a, 17)) - signed(resize(phi_n, 17));
    angles_delta <= unsigned(angles_n4(15 downto 0));
    angles_n6 <= resize(theta_a, 17) + resize(angles_delta, 17);
    angles_ang_x <= angles_n6(15 downto 0);
    angles_n8 <= signed(resize(theta_a, 17)) - signed(resize(angles_delta, 17));
    angles_ang_y <= unsigned(angles_n8(15 downto 0));
    angles_n10 <= resize(angles_ang_x, 17) + resize(theta_n, 17);
    angles_x_plus_n <= angles_n10(15 downto 0);
    angles_n12 <= signed(resize(angles_ang_x, 17)) - signed(resize(theta_n, 17));
    angles_x_minus_n <= unsigned(angles_n12(15 downto 0));
    angles_n14 <= resize(angles_ang_y, 17) + resize(theta_n, 17);
    angles_y_plus_n <= angles_n14(15 downto 0);
    angles_n16 <= signed(resize(angles_ang_y, 17)) - signed(resize(theta_n, 17));
    angles_y_minus_n <= unsigned(angles_n16(15 downto 0));
    angles_n18 <= resize(theta_a, 17) + resize(theta_n, 17);
    angles_a_plus_n <= angles_n18(15 downto 0);
    angles_n20 <= signed(resize(theta_a, 17)) - signed(resize(theta_n, 17));
    angles_a_minus_n <= unsigned(angles_n20(15 downto 0));
    -- sincos
    sincos_n22 <= angles_ang_y(15 downto 6);
    sincos_n24 <= angles_ang_x(15 downto 6);
    sincos_n26 <= angles_x_plus_n(15 downto 6);
    sincos_n29 <= angles_x_minus_n(15 downto 6);
    sincos_n32 <= angles_y_plus_n(15 downto 6);
    sincos_n35 <= angles_y_minus_n(15 downto 6);
    sincos_n38 <= angles_a_plus_n(15 downto 6);
    sincos_n41 <= angles_a_minus_n(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sincos_row <= sincos_rom(to_integer(sincos_n22));
                sincos_row_2 <= sincos_rom(to_integer(sincos_n24));
                sincos_row_3 <= sincos_rom_2(to_integer(sincos_n26));
                sincos_row_4 <= sincos_rom_2(to_integer(sincos_n29));
                sincos_row_5 <= sincos_rom_3(to_integer(sincos_n32));
                sincos_row_6 <= sincos_rom_3(to_integer(sincos_n35));
                sincos_row_7 <= sincos_rom_4(to_integer(sincos_n38));
                sincos_row_8 <= sincos_rom_4(to_integer(sincos_n41));
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- sincos
    sincos_cos_y <= signed(sincos_row(19 downto 0));
    sincos_cos_x <= signed(sincos_row_2(19 downto 0));
    sincos_sin_xpn <= signed(sincos_row_3(39 downto 20));
    sincos_cos_xpn <= signed(sincos_row_3(19 downto 0));
    sincos_sin_xmn <= signed(sincos_row_4(39 downto 20));
    sincos_cos_xmn <= signed(sincos_row_4(19 downto 0));
    sincos_sin_ypn <= signed(sincos_row_5(39 downto 20));
    sincos_cos_ypn <= signed(sincos_row_5(19 downto 0));
    sincos_sin_ymn <= signed(sincos_row_6(39 downto 20));
    sincos_cos_ymn <= signed(sincos_row_6(19 downto 0));
    sincos_sin_apn <= signed(sincos_row_7(39 downto 20));
    sincos_cos_apn <= signed(sincos_row_7(19 downto 0));
    sincos_sin_amn <= signed(sincos_row_8(39 downto 20));
    sincos_cos_amn <= signed(sincos_row_8(19 downto 0));
    -- sums
    sums_n44 <= resize(sincos_sin_xpn, 21) + resize(sincos_sin_xmn, 21);
    sums_n45 <= resize(sincos_sin_ypn, 21) + resize(sincos_sin_ymn, 21);
    sums_n46 <= resize(sums_n44, 22) + resize(sums_n45, 22);
    sums_n47 <= sums_n46;
    sums_n48 <= resize(sincos_sin_apn, 21) - resize(sincos_sin_amn, 21);
    sums_n49 <= sums_n48;
    sums_n51 <= resize(sincos_cos_y, 21) - resize(sincos_cos_x, 21);
    sums_y_sum <= sums_n51;
    sums_n53 <= resize(sincos_cos_xmn, 21) - resize(sincos_cos_xpn, 21);
    sums_n54 <= resize(sincos_cos_ymn, 21) - resize(sincos_cos_ypn, 21);
    sums_n55 <= resize(sums_n53, 22) + resize(sums_n54, 22);
    sums_n56 <= sums_n55;
    sums_n57 <= resize(sincos_cos_apn, 21) + resize(sincos_cos_amn, 21);
    sums_n58 <= sums_n57;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                sums_n47_s2 <= sums_n47;
                sums_n49_s2 <= sums_n49;
                sums_y_sum_s2 <= sums_y_sum;
                sums_n56_s2 <= sums_n56;
                sums_n58_s2 <= sums_n58;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- sums
    sums_x_sum <= resize(sums_n47_s2, 23) - shift_left(resize(sums_n49_s2, 23), 1);
    sums_z_sum <= resize(sums_n56_s2, 23) + shift_left(resize(sums_n58_s2, 23), 1);
    -- (unit)
    x_next_sum <= resize(sums_x_sum, 24) + 24x"000008";
    x_next_cut <= x_next_sum(23 downto 4);
    x_next_over <= "1" when x_next_cut(19) = '0' and (or x_next_cut(18 downto 17)) = '1' else "0";
    x_next_under <= "1" when x_next_cut(19) = '1' and (and x_next_cut(18 downto 17)) = '0' else "0";
    x_next <= 18x"1ffff" when x_next_over(0) = '1' else 18x"20000" when x_next_under(0) = '1' else x_next_cut(17 downto 0);
    y_next_sum <= resize(sums_y_sum_s2, 22) + 22x"000004";
    y_next_cut <= y_next_sum(21 downto 3);
    y_next_over <= "1" when y_next_cut(18) = '0' and (or y_next_cut(17 downto 17)) = '1' else "0";
    y_next <= 18x"1ffff" when y_next_over(0) = '1' else y_next_cut(17 downto 0);
    z_next_sum <= resize(sums_z_sum, 24) + 24x"000008";
    z_next_cut <= z_next_sum(23 downto 4);
    z_next_over <= "1" when z_next_cut(19) = '0' and (or z_next_cut(18 downto 17)) = '1' else "0";
    z_next_under <= "1" when z_next_cut(19) = '1' and (and z_next_cut(18 downto 17)) = '0' else "0";
    z_next <= 18x"1ffff" when z_next_over(0) = '1' else 18x"20000" when z_next_under(0) = '1' else z_next_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x <= x_next;
                y <= y_next;
                z <= z_next;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----

    valid_out <= valid_s3;
end architecture;
