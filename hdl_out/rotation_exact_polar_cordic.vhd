-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
--   variant=exact output=polar-cordic angle_bits=16 table_addr_bits=10 scheme=direct
--   quarter_wave=off frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate
--   sincos_addr_bits=auto asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
--   prop_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
--   period_ps=5000 stages=auto rom=block
-- latency 27 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   angle: mean 1.41e-3 rad, largest seen 4.89e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   dot: mean 1.41e-3, largest seen 4.89e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   x: mean 7.66e-4, largest seen 4.11e-3 at phi_a=29150 theta_a=16832 phi_n=13217 theta_n=8896
--   y: mean 6.08e-4, largest seen 3.10e-3 at phi_a=30741 theta_a=4418 phi_n=47062 theta_n=20098
--   z: mean 7.28e-4, largest seen 3.81e-3 at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
-- stated bound on the angle: 1.07e-2 rad
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity rotation_exact_polar_cordic is
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
        phi : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        theta : out unsigned(15 downto 0) := (others => '0') -- u16f16
    );
end entity;

architecture rtl of rotation_exact_polar_cordic is
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

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
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
    signal azimuth_n65 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n76 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n77 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n78 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n84 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n95 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n106 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n117 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n128 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n139 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n150 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n161 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n172 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n183 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n194 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n205 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n216 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n227 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n238 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n249 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n260 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n268 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n273 : unsigned(23 downto 0) := (others => '0'); -- u24f24
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
    signal x_sum : signed(23 downto 0) := (others => '0');
    signal x_cut : signed(21 downto 0) := (others => '0');
    signal x_over : unsigned(0 downto 0) := (others => '0');
    signal x_under : unsigned(0 downto 0) := (others => '0');
    signal x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal y_sum : signed(21 downto 0) := (others => '0');
    signal y_cut : signed(20 downto 0) := (others => '0');
    signal y_over : unsigned(0 downto 0) := (others => '0');
    signal y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal z_sum : signed(23 downto 0) := (others => '0');
    signal z_cut : signed(21 downto 0) := (others => '0');
    signal z_over : unsigned(0 downto 0) := (others => '0');
    signal z_under : unsigned(0 downto 0) := (others => '0');
    signal z : signed(19 downto 0) := (others => '0'); -- s20f18
    signal azimuth_n63_wide : signed(25 downto 0) := (others => '0');
    signal azimuth_n63 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n64_wide : signed(25 downto 0) := (others => '0');
    signal azimuth_n64 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n66 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n67 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n69 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n70 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n71 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n73 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n75_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n75_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n75 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n80 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n276 : signed(19 downto 0) := (others => '0'); -- s20f42
    signal polar_angle_n277 : signed(19 downto 0) := (others => '0'); -- s20f40
    signal polar_angle_n278 : signed(22 downto 0) := (others => '0'); -- s23f42
    signal polar_angle_n279 : signed(19 downto 0) := (others => '0'); -- s20f38
    signal polar_angle_n281 : signed(19 downto 0) := (others => '0'); -- s20f33
    signal polar_angle_n283 : signed(19 downto 0) := (others => '0'); -- s20f30
    signal polar_angle_n285 : signed(19 downto 0) := (others => '0'); -- s20f27
    signal polar_angle_n287 : signed(19 downto 0) := (others => '0'); -- s20f25
    signal polar_angle_n289 : signed(19 downto 0) := (others => '0'); -- s20f23
    signal polar_angle_n291 : signed(19 downto 0) := (others => '0'); -- s20f21
    signal polar_angle_n293 : signed(19 downto 0) := (others => '0'); -- s20f19
    signal polar_angle_n295 : signed(19 downto 0) := (others => '0'); -- s20f17
    signal azimuth_n63_s3 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n66_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n67_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n69_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n70_s3 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n75_s3 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n80_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n278_s3 : signed(22 downto 0) := (others => '0'); -- s23f42
    signal polar_angle_n279_s3 : signed(19 downto 0) := (others => '0'); -- s20f38
    signal polar_angle_n281_s3 : signed(19 downto 0) := (others => '0'); -- s20f33
    signal polar_angle_n283_s3 : signed(19 downto 0) := (others => '0'); -- s20f30
    signal polar_angle_n285_s3 : signed(19 downto 0) := (others => '0'); -- s20f27
    signal polar_angle_n287_s3 : signed(19 downto 0) := (others => '0'); -- s20f25
    signal polar_angle_n289_s3 : signed(19 downto 0) := (others => '0'); -- s20f23
    signal polar_angle_n291_s3 : signed(19 downto 0) := (others => '0'); -- s20f21
    signal polar_angle_n293_s3 : signed(19 downto 0) := (others => '0'); -- s20f19
    signal polar_angle_n295_s3 : signed(19 downto 0) := (others => '0'); -- s20f17
    signal valid_s3 : std_logic;
    -- stage 3
    signal azimuth_n68 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n72 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n74_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n74_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n74 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n79 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n81 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n82_term : unsigned(27 downto 0) := (others => '0');
    signal azimuth_n82 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n83_term : unsigned(27 downto 0) := (others => '0');
    signal azimuth_n83 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal azimuth_n85_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n85 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n86_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n86_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n86 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n87_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n87_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n87 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n88_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n88_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n88 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n89 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n91 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal azimuth_n92 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal azimuth_n93_term : unsigned(28 downto 0) := (others => '0');
    signal azimuth_n93 : signed(28 downto 0) := (others => '0'); -- s29f25
    signal azimuth_n96_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n96 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n280 : signed(24 downto 0) := (others => '0'); -- s25f42
    signal polar_angle_n282 : signed(29 downto 0) := (others => '0'); -- s30f42
    signal polar_angle_n284 : signed(32 downto 0) := (others => '0'); -- s33f42
    signal azimuth_n69_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n88_s4 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n90_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n92_s4 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal azimuth_n93_s4 : signed(28 downto 0) := (others => '0'); -- s29f25
    signal azimuth_n96_s4 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n284_s4 : signed(32 downto 0) := (others => '0'); -- s33f42
    signal polar_angle_n285_s4 : signed(19 downto 0) := (others => '0'); -- s20f27
    signal polar_angle_n287_s4 : signed(19 downto 0) := (others => '0'); -- s20f25
    signal polar_angle_n289_s4 : signed(19 downto 0) := (others => '0'); -- s20f23
    signal polar_angle_n291_s4 : signed(19 downto 0) := (others => '0'); -- s20f21
    signal polar_angle_n293_s4 : signed(19 downto 0) := (others => '0'); -- s20f19
    signal polar_angle_n295_s4 : signed(19 downto 0) := (others => '0'); -- s20f17
    signal valid_s4 : std_logic;
    -- stage 4
    signal azimuth_n94_term : unsigned(28 downto 0) := (others => '0');
    signal azimuth_n94 : signed(28 downto 0) := (others => '0'); -- s29f25
    signal azimuth_n97_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n97_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n97 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n98_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n98_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n98_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n98 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n99_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n99_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n99_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n99 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n100 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n101 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n102 : signed(26 downto 0) := (others => '0'); -- s27f26
    signal azimuth_n103 : signed(26 downto 0) := (others => '0'); -- s27f26
    signal azimuth_n104_term : unsigned(29 downto 0) := (others => '0');
    signal azimuth_n104 : signed(29 downto 0) := (others => '0'); -- s30f26
    signal azimuth_n105_term : unsigned(29 downto 0) := (others => '0');
    signal azimuth_n105 : signed(29 downto 0) := (others => '0'); -- s30f26
    signal azimuth_n107_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n107 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n108_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n108_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n108 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n109_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n109_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n109_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n109 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n110_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n110_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n110_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n110 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n111 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n113 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal azimuth_n114 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal polar_angle_n286 : signed(35 downto 0) := (others => '0'); -- s36f42
    signal polar_angle_n288 : signed(37 downto 0) := (others => '0'); -- s38f42
    signal azimuth_n69_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n108_s5 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n109_s5 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n110_s5 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n111_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n113_s5 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal azimuth_n114_s5 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal polar_angle_n288_s5 : signed(37 downto 0) := (others => '0'); -- s38f42
    signal polar_angle_n289_s5 : signed(19 downto 0) := (others => '0'); -- s20f23
    signal polar_angle_n291_s5 : signed(19 downto 0) := (others => '0'); -- s20f21
    signal polar_angle_n293_s5 : signed(19 downto 0) := (others => '0'); -- s20f19
    signal polar_angle_n295_s5 : signed(19 downto 0) := (others => '0'); -- s20f17
    signal valid_s5 : std_logic;
    -- stage 5
    signal azimuth_n112 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n115_term : unsigned(30 downto 0) := (others => '0');
    signal azimuth_n115 : signed(30 downto 0) := (others => '0'); -- s31f27
    signal azimuth_n116_term : unsigned(30 downto 0) := (others => '0');
    signal azimuth_n116 : signed(30 downto 0) := (others => '0'); -- s31f27
    signal azimuth_n118_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n118 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n119_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n119_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n119 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n120_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n120_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n120_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n120 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n121_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n121_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n121_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n121 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n122 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n124 : signed(26 downto 0) := (others => '0'); -- s27f28
    signal azimuth_n125 : signed(26 downto 0) := (others => '0'); -- s27f28
    signal azimuth_n126_term : unsigned(31 downto 0) := (others => '0');
    signal azimuth_n126 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal azimuth_n127_term : unsigned(31 downto 0) := (others => '0');
    signal azimuth_n127 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal azimuth_n129_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n129 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n130_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n130_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n130 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n131_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n131_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n131_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n131 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n136 : signed(26 downto 0) := (others => '0'); -- s27f29
    signal polar_angle_n290 : signed(39 downto 0) := (others => '0'); -- s40f42
    signal polar_angle_n292 : signed(41 downto 0) := (others => '0'); -- s42f42
    signal azimuth_n69_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n127_s6 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal azimuth_n130_s6 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n131_s6 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n136_s6 : signed(26 downto 0) := (others => '0'); -- s27f29
    signal polar_angle_n292_s6 : signed(41 downto 0) := (others => '0'); -- s42f42
    signal polar_angle_n293_s6 : signed(19 downto 0) := (others => '0'); -- s20f19
    signal polar_angle_n295_s6 : signed(19 downto 0) := (others => '0'); -- s20f17
    signal valid_s6 : std_logic;
    -- stage 6
    signal azimuth_n132_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n132_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n132_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n132 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n133 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n134 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n135 : signed(26 downto 0) := (others => '0'); -- s27f29
    signal azimuth_n137_term : unsigned(32 downto 0) := (others => '0');
    signal azimuth_n137 : signed(32 downto 0) := (others => '0'); -- s33f29
    signal azimuth_n138_term : unsigned(32 downto 0) := (others => '0');
    signal azimuth_n138 : signed(32 downto 0) := (others => '0'); -- s33f29
    signal azimuth_n140_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n140 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n141_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n141_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n141 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n142_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n142_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n142_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n142 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n143_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n143_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n143_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n143 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n144 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n145 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n146 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal azimuth_n147 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal azimuth_n151_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n151 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n294 : signed(43 downto 0) := (others => '0'); -- s44f42
    signal polar_angle_n296 : signed(45 downto 0) := (others => '0'); -- s46f42
    signal polar_angle_n297_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n297_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n297_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n297 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n301 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n69_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n142_s7 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n143_s7 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n144_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n145_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n146_s7 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal azimuth_n147_s7 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal azimuth_n151_s7 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n297_s7 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n301_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal azimuth_n148_term : unsigned(33 downto 0) := (others => '0');
    signal azimuth_n148 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal azimuth_n149_term : unsigned(33 downto 0) := (others => '0');
    signal azimuth_n149 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal azimuth_n152_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n152_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n152 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n153_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n153_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n153_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n153 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n154_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n154_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n154_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n154 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n155 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n156 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n157 : signed(26 downto 0) := (others => '0'); -- s27f31
    signal azimuth_n158 : signed(26 downto 0) := (others => '0'); -- s27f31
    signal azimuth_n159_term : unsigned(34 downto 0) := (others => '0');
    signal azimuth_n159 : signed(34 downto 0) := (others => '0'); -- s35f31
    signal azimuth_n160_term : unsigned(34 downto 0) := (others => '0');
    signal azimuth_n160 : signed(34 downto 0) := (others => '0'); -- s35f31
    signal azimuth_n162_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n162 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n163_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n163_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n163 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n164_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n164_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n164_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n164 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n169 : signed(26 downto 0) := (others => '0'); -- s27f32
    signal polar_angle_n298 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n302 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal polar_angle_n304 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal polar_angle_n306_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n306_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n306 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n69_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n160_s8 : signed(34 downto 0) := (others => '0'); -- s35f31
    signal azimuth_n163_s8 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n164_s8 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n169_s8 : signed(26 downto 0) := (others => '0'); -- s27f32
    signal polar_angle_n298_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s8 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s8 : std_logic;
    -- stage 8
    signal azimuth_n165_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n165_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n165_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n165 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n166 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n167 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n168 : signed(26 downto 0) := (others => '0'); -- s27f32
    signal azimuth_n170_term : unsigned(35 downto 0) := (others => '0');
    signal azimuth_n170 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal azimuth_n171_term : unsigned(35 downto 0) := (others => '0');
    signal azimuth_n171 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal azimuth_n173_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n173 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n174_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n174_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n174 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n175_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n175_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n175_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n175 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n176_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n176_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n176_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n176 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n177 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n178 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n179 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal azimuth_n180 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal azimuth_n184_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n184 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n69_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n175_s9 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n176_s9 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n177_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n178_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n179_s9 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal azimuth_n180_s9 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal azimuth_n184_s9 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n298_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s9 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s9 : std_logic;
    -- stage 9
    signal azimuth_n181_term : unsigned(36 downto 0) := (others => '0');
    signal azimuth_n181 : signed(36 downto 0) := (others => '0'); -- s37f33
    signal azimuth_n182_term : unsigned(36 downto 0) := (others => '0');
    signal azimuth_n182 : signed(36 downto 0) := (others => '0'); -- s37f33
    signal azimuth_n185_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n185_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n185 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n186_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n186_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n186_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n186 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n187_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n187_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n187_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n187 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n188 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n189 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n190 : signed(26 downto 0) := (others => '0'); -- s27f34
    signal azimuth_n191 : signed(26 downto 0) := (others => '0'); -- s27f34
    signal azimuth_n192_term : unsigned(37 downto 0) := (others => '0');
    signal azimuth_n192 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal azimuth_n193_term : unsigned(37 downto 0) := (others => '0');
    signal azimuth_n193 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal azimuth_n195_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n195 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n196_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n196_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n196 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n197_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n197_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n197_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n197 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n202 : signed(26 downto 0) := (others => '0'); -- s27f35
    signal azimuth_n69_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n193_s10 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal azimuth_n196_s10 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n197_s10 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n202_s10 : signed(26 downto 0) := (others => '0'); -- s27f35
    signal polar_angle_n298_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s10 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s10 : std_logic;
    -- stage 10
    signal azimuth_n198_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n198_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n198_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n198 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n199 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n200 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n201 : signed(26 downto 0) := (others => '0'); -- s27f35
    signal azimuth_n203_term : unsigned(38 downto 0) := (others => '0');
    signal azimuth_n203 : signed(38 downto 0) := (others => '0'); -- s39f35
    signal azimuth_n204_term : unsigned(38 downto 0) := (others => '0');
    signal azimuth_n204 : signed(38 downto 0) := (others => '0'); -- s39f35
    signal azimuth_n206_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n206 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n207_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n207_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n207 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n208_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n208_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n208_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n208 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n209_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n209_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n209_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n209 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n210 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n211 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n212 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal azimuth_n213 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal azimuth_n217_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n217 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n69_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n208_s11 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n209_s11 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n210_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n211_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n212_s11 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal azimuth_n213_s11 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal azimuth_n217_s11 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n298_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s11 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s11 : std_logic;
    -- stage 11
    signal azimuth_n214_term : unsigned(39 downto 0) := (others => '0');
    signal azimuth_n214 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal azimuth_n215_term : unsigned(39 downto 0) := (others => '0');
    signal azimuth_n215 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal azimuth_n218_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n218_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n218 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n219_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n219_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n219_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n219 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n220_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n220_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n220_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n220 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n221 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n222 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n223 : signed(26 downto 0) := (others => '0'); -- s27f37
    signal azimuth_n224 : signed(26 downto 0) := (others => '0'); -- s27f37
    signal azimuth_n225_term : unsigned(40 downto 0) := (others => '0');
    signal azimuth_n225 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal azimuth_n226_term : unsigned(40 downto 0) := (others => '0');
    signal azimuth_n226 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal azimuth_n228_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n228 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n229_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n229_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n229 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n230_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n230_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n230_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n230 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n235 : signed(26 downto 0) := (others => '0'); -- s27f38
    signal azimuth_n69_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n226_s12 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal azimuth_n229_s12 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n230_s12 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n235_s12 : signed(26 downto 0) := (others => '0'); -- s27f38
    signal polar_angle_n298_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s12 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s12 : std_logic;
    -- stage 12
    signal azimuth_n231_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n231_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n231_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n231 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n232 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n233 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n234 : signed(26 downto 0) := (others => '0'); -- s27f38
    signal azimuth_n236_term : unsigned(41 downto 0) := (others => '0');
    signal azimuth_n236 : signed(41 downto 0) := (others => '0'); -- s42f38
    signal azimuth_n237_term : unsigned(41 downto 0) := (others => '0');
    signal azimuth_n237 : signed(41 downto 0) := (others => '0'); -- s42f38
    signal azimuth_n239_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n239 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n240_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n240_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n240 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n241_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n241_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n241_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n241 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n242_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n242_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n242_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n242 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n243 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n244 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n245 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal azimuth_n246 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal azimuth_n69_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n240_s13 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n241_s13 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n242_s13 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n243_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n244_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n245_s13 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal azimuth_n246_s13 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal polar_angle_n298_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s13 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s13 : std_logic;
    -- stage 13
    signal azimuth_n247_term : unsigned(42 downto 0) := (others => '0');
    signal azimuth_n247 : signed(42 downto 0) := (others => '0'); -- s43f39
    signal azimuth_n248_term : unsigned(42 downto 0) := (others => '0');
    signal azimuth_n248 : signed(42 downto 0) := (others => '0'); -- s43f39
    signal azimuth_n250_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n250 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n251_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n251_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n251 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n252_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n252_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n252_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n252 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n253_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n253_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n253_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n253 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n254 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n255 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n256 : signed(26 downto 0) := (others => '0'); -- s27f40
    signal azimuth_n257 : signed(26 downto 0) := (others => '0'); -- s27f40
    signal azimuth_n258_term : unsigned(43 downto 0) := (others => '0');
    signal azimuth_n258 : signed(43 downto 0) := (others => '0'); -- s44f40
    signal azimuth_n259_term : unsigned(43 downto 0) := (others => '0');
    signal azimuth_n259 : signed(43 downto 0) := (others => '0'); -- s44f40
    signal azimuth_n261_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n261 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n262_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n262_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n262 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n69_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n258_s14 : signed(43 downto 0) := (others => '0'); -- s44f40
    signal azimuth_n259_s14 : signed(43 downto 0) := (others => '0'); -- s44f40
    signal azimuth_n262_s14 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n298_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n306_s14 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal valid_s14 : std_logic;
    -- stage 14
    signal azimuth_n263_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n263_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n263_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n263 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n264_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n264_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n264_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n264 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n265 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n266 : signed(26 downto 0) := (others => '0'); -- s27f41
    signal azimuth_n267_term : unsigned(44 downto 0) := (others => '0');
    signal azimuth_n267 : signed(44 downto 0) := (others => '0'); -- s45f41
    signal azimuth_n269_term : unsigned(24 downto 0) := (others => '0');
    signal azimuth_n269 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal azimuth_n270_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n270_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n270 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal azimuth_n271_cut : signed(27 downto 0) := (others => '0');
    signal azimuth_n271_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n271_under : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n271 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal azimuth_n272 : unsigned(23 downto 0) := (others => '0'); -- u24f24
    signal azimuth_n274 : unsigned(23 downto 0) := (others => '0'); -- u24f24
    signal azimuth_n275 : unsigned(23 downto 0) := (others => '0'); -- u24f24
    signal polar_angle_n299 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n303 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal n480_sum : unsigned(24 downto 0) := (others => '0');
    signal n480_cut : unsigned(16 downto 0) := (others => '0');
    signal n480 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal phi_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal azimuth_n271_s15 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n298_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n299_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n301_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n303_s15 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal polar_angle_n306_s15 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal phi_next_s15 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s15 : std_logic;
    -- stage 15
    signal polar_angle_n300 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n305 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal polar_angle_n307_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n307_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n307 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n308 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n309 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n310 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n311_term : unsigned(27 downto 0) := (others => '0');
    signal polar_angle_n311 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal polar_angle_n312_term : unsigned(27 downto 0) := (others => '0');
    signal polar_angle_n312 : signed(27 downto 0) := (others => '0'); -- s28f24
    signal polar_angle_n313_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n313 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n314_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n314_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n314 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n315_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n315_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n315 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n316_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n316_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n316 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n317 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n318 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n319 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal polar_angle_n320 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal polar_angle_n301_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n314_s16 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n315_s16 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n316_s16 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n317_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n318_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n319_s16 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal polar_angle_n320_s16 : signed(26 downto 0) := (others => '0'); -- s27f25
    signal phi_next_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s16 : std_logic;
    -- stage 16
    signal polar_angle_n321_term : unsigned(28 downto 0) := (others => '0');
    signal polar_angle_n321 : signed(28 downto 0) := (others => '0'); -- s29f25
    signal polar_angle_n322_term : unsigned(28 downto 0) := (others => '0');
    signal polar_angle_n322 : signed(28 downto 0) := (others => '0'); -- s29f25
    signal polar_angle_n323_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n323 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n324_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n324_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n324 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n325_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n325_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n325_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n325 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n326_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n326_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n326_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n326 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n327 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n328 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n329 : signed(26 downto 0) := (others => '0'); -- s27f26
    signal polar_angle_n330 : signed(26 downto 0) := (others => '0'); -- s27f26
    signal polar_angle_n331_term : unsigned(29 downto 0) := (others => '0');
    signal polar_angle_n331 : signed(29 downto 0) := (others => '0'); -- s30f26
    signal polar_angle_n332_term : unsigned(29 downto 0) := (others => '0');
    signal polar_angle_n332 : signed(29 downto 0) := (others => '0'); -- s30f26
    signal polar_angle_n333_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n333 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n334_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n334_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n334 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n335_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n335_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n335_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n335 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n336_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n336_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n336_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n336 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n337 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n339 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal polar_angle_n340 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal polar_angle_n301_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n334_s17 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n335_s17 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n336_s17 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n337_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n339_s17 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal polar_angle_n340_s17 : signed(26 downto 0) := (others => '0'); -- s27f27
    signal phi_next_s17 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s17 : std_logic;
    -- stage 17
    signal polar_angle_n338 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n341_term : unsigned(30 downto 0) := (others => '0');
    signal polar_angle_n341 : signed(30 downto 0) := (others => '0'); -- s31f27
    signal polar_angle_n342_term : unsigned(30 downto 0) := (others => '0');
    signal polar_angle_n342 : signed(30 downto 0) := (others => '0'); -- s31f27
    signal polar_angle_n343_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n343 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n344_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n344_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n344 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n345_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n345_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n345_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n345 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n346_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n346_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n346_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n346 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n347 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n348 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n349 : signed(26 downto 0) := (others => '0'); -- s27f28
    signal polar_angle_n350 : signed(26 downto 0) := (others => '0'); -- s27f28
    signal polar_angle_n351_term : unsigned(31 downto 0) := (others => '0');
    signal polar_angle_n351 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal polar_angle_n352_term : unsigned(31 downto 0) := (others => '0');
    signal polar_angle_n352 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal polar_angle_n353_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n353 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n354_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n354_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n354 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n355_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n355_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n355_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n355 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n360 : signed(26 downto 0) := (others => '0'); -- s27f29
    signal polar_angle_n301_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n352_s18 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal polar_angle_n354_s18 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n355_s18 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n360_s18 : signed(26 downto 0) := (others => '0'); -- s27f29
    signal phi_next_s18 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s18 : std_logic;
    -- stage 18
    signal polar_angle_n356_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n356_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n356_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n356 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n357 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n358 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n359 : signed(26 downto 0) := (others => '0'); -- s27f29
    signal polar_angle_n361_term : unsigned(32 downto 0) := (others => '0');
    signal polar_angle_n361 : signed(32 downto 0) := (others => '0'); -- s33f29
    signal polar_angle_n362_term : unsigned(32 downto 0) := (others => '0');
    signal polar_angle_n362 : signed(32 downto 0) := (others => '0'); -- s33f29
    signal polar_angle_n363_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n363 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n364_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n364_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n364 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n365_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n365_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n365_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n365 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n366_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n366_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n366_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n366 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n367 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n368 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n369 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal polar_angle_n370 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal polar_angle_n373_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n373 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n301_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n365_s19 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n366_s19 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n367_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n368_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n369_s19 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal polar_angle_n370_s19 : signed(26 downto 0) := (others => '0'); -- s27f30
    signal polar_angle_n373_s19 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal phi_next_s19 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s19 : std_logic;
    -- stage 19
    signal polar_angle_n371_term : unsigned(33 downto 0) := (others => '0');
    signal polar_angle_n371 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal polar_angle_n372_term : unsigned(33 downto 0) := (others => '0');
    signal polar_angle_n372 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal polar_angle_n374_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n374_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n374 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n375_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n375_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n375_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n375 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n376_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n376_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n376_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n376 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n377 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n378 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n379 : signed(26 downto 0) := (others => '0'); -- s27f31
    signal polar_angle_n380 : signed(26 downto 0) := (others => '0'); -- s27f31
    signal polar_angle_n381_term : unsigned(34 downto 0) := (others => '0');
    signal polar_angle_n381 : signed(34 downto 0) := (others => '0'); -- s35f31
    signal polar_angle_n382_term : unsigned(34 downto 0) := (others => '0');
    signal polar_angle_n382 : signed(34 downto 0) := (others => '0'); -- s35f31
    signal polar_angle_n383_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n383 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n384_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n384_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n384 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n385_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n385_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n385_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n385 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n390 : signed(26 downto 0) := (others => '0'); -- s27f32
    signal polar_angle_n301_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n382_s20 : signed(34 downto 0) := (others => '0'); -- s35f31
    signal polar_angle_n384_s20 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n385_s20 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n390_s20 : signed(26 downto 0) := (others => '0'); -- s27f32
    signal phi_next_s20 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s20 : std_logic;
    -- stage 20
    signal polar_angle_n386_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n386_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n386_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n386 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n387 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n388 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n389 : signed(26 downto 0) := (others => '0'); -- s27f32
    signal polar_angle_n391_term : unsigned(35 downto 0) := (others => '0');
    signal polar_angle_n391 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal polar_angle_n392_term : unsigned(35 downto 0) := (others => '0');
    signal polar_angle_n392 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal polar_angle_n393_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n393 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n394_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n394_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n394 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n395_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n395_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n395_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n395 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n396_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n396_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n396_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n396 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n397 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n398 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n399 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal polar_angle_n400 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal polar_angle_n403_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n403 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n301_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n395_s21 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n396_s21 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n397_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n398_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n399_s21 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal polar_angle_n400_s21 : signed(26 downto 0) := (others => '0'); -- s27f33
    signal polar_angle_n403_s21 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal phi_next_s21 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s21 : std_logic;
    -- stage 21
    signal polar_angle_n401_term : unsigned(36 downto 0) := (others => '0');
    signal polar_angle_n401 : signed(36 downto 0) := (others => '0'); -- s37f33
    signal polar_angle_n402_term : unsigned(36 downto 0) := (others => '0');
    signal polar_angle_n402 : signed(36 downto 0) := (others => '0'); -- s37f33
    signal polar_angle_n404_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n404_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n404 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n405_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n405_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n405_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n405 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n406_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n406_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n406_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n406 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n407 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n408 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n409 : signed(26 downto 0) := (others => '0'); -- s27f34
    signal polar_angle_n410 : signed(26 downto 0) := (others => '0'); -- s27f34
    signal polar_angle_n411_term : unsigned(37 downto 0) := (others => '0');
    signal polar_angle_n411 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal polar_angle_n412_term : unsigned(37 downto 0) := (others => '0');
    signal polar_angle_n412 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal polar_angle_n413_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n413 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n414_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n414_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n414 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n415_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n415_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n415_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n415 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n420 : signed(26 downto 0) := (others => '0'); -- s27f35
    signal polar_angle_n301_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n412_s22 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal polar_angle_n414_s22 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n415_s22 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n420_s22 : signed(26 downto 0) := (others => '0'); -- s27f35
    signal phi_next_s22 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s22 : std_logic;
    -- stage 22
    signal polar_angle_n416_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n416_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n416_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n416 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n417 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n418 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n419 : signed(26 downto 0) := (others => '0'); -- s27f35
    signal polar_angle_n421_term : unsigned(38 downto 0) := (others => '0');
    signal polar_angle_n421 : signed(38 downto 0) := (others => '0'); -- s39f35
    signal polar_angle_n422_term : unsigned(38 downto 0) := (others => '0');
    signal polar_angle_n422 : signed(38 downto 0) := (others => '0'); -- s39f35
    signal polar_angle_n423_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n423 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n424_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n424_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n424 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n425_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n425_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n425_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n425 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n426_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n426_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n426_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n426 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n427 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n428 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n429 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal polar_angle_n430 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal polar_angle_n433_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n433 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n301_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n425_s23 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n426_s23 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n427_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n428_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n429_s23 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal polar_angle_n430_s23 : signed(26 downto 0) := (others => '0'); -- s27f36
    signal polar_angle_n433_s23 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal phi_next_s23 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s23 : std_logic;
    -- stage 23
    signal polar_angle_n431_term : unsigned(39 downto 0) := (others => '0');
    signal polar_angle_n431 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal polar_angle_n432_term : unsigned(39 downto 0) := (others => '0');
    signal polar_angle_n432 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal polar_angle_n434_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n434_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n434 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n435_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n435_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n435_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n435 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n436_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n436_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n436_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n436 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n437 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n438 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n439 : signed(26 downto 0) := (others => '0'); -- s27f37
    signal polar_angle_n440 : signed(26 downto 0) := (others => '0'); -- s27f37
    signal polar_angle_n441_term : unsigned(40 downto 0) := (others => '0');
    signal polar_angle_n441 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal polar_angle_n442_term : unsigned(40 downto 0) := (others => '0');
    signal polar_angle_n442 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal polar_angle_n443_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n443 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n444_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n444_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n444 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n445_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n445_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n445_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n445 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n450 : signed(26 downto 0) := (others => '0'); -- s27f38
    signal polar_angle_n301_s24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n442_s24 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal polar_angle_n444_s24 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n445_s24 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n450_s24 : signed(26 downto 0) := (others => '0'); -- s27f38
    signal phi_next_s24 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s24 : std_logic;
    -- stage 24
    signal polar_angle_n446_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n446_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n446_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n446 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n447 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n448 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n449 : signed(26 downto 0) := (others => '0'); -- s27f38
    signal polar_angle_n451_term : unsigned(41 downto 0) := (others => '0');
    signal polar_angle_n451 : signed(41 downto 0) := (others => '0'); -- s42f38
    signal polar_angle_n452_term : unsigned(41 downto 0) := (others => '0');
    signal polar_angle_n452 : signed(41 downto 0) := (others => '0'); -- s42f38
    signal polar_angle_n453_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n453 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n454_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n454_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n454 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n455_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n455_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n455_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n455 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n456_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n456_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n456_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n456 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n457 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n458 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n459 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal polar_angle_n460 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal polar_angle_n301_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n454_s25 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n455_s25 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n456_s25 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n457_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n458_s25 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n459_s25 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal polar_angle_n460_s25 : signed(26 downto 0) := (others => '0'); -- s27f39
    signal phi_next_s25 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s25 : std_logic;
    -- stage 25
    signal polar_angle_n461_term : unsigned(42 downto 0) := (others => '0');
    signal polar_angle_n461 : signed(42 downto 0) := (others => '0'); -- s43f39
    signal polar_angle_n462_term : unsigned(42 downto 0) := (others => '0');
    signal polar_angle_n462 : signed(42 downto 0) := (others => '0'); -- s43f39
    signal polar_angle_n463_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n463 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n464_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n464_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n464 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n465_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n465_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n465_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n465 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n466_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n466_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n466_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n466 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n467 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n468 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n469 : signed(26 downto 0) := (others => '0'); -- s27f40
    signal polar_angle_n470_term : unsigned(43 downto 0) := (others => '0');
    signal polar_angle_n470 : signed(43 downto 0) := (others => '0'); -- s44f40
    signal polar_angle_n471_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n471 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n472_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n472_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n472 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n301_s26 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n470_s26 : signed(43 downto 0) := (others => '0'); -- s44f40
    signal polar_angle_n472_s26 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal phi_next_s26 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s26 : std_logic;
    -- stage 26
    signal polar_angle_n473_cut : signed(27 downto 0) := (others => '0');
    signal polar_angle_n473_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n473_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n473 : signed(26 downto 0) := (others => '0'); -- s27f24
    signal polar_angle_n474 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n475_term : unsigned(24 downto 0) := (others => '0');
    signal polar_angle_n475 : signed(24 downto 0) := (others => '0'); -- s25f24
    signal polar_angle_n476_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n476_under : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n476 : signed(23 downto 0) := (others => '0'); -- s24f24
    signal polar_angle_n477 : unsigned(23 downto 0) := (others => '0'); -- u24f24
    signal polar_angle_n478 : unsigned(23 downto 0) := (others => '0'); -- u24f24
    signal polar_angle_n479 : unsigned(23 downto 0) := (others => '0'); -- u24f24
    signal n482_sum : unsigned(24 downto 0) := (others => '0');
    signal n482_cut : unsigned(16 downto 0) := (others => '0');
    signal n482 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal theta_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s27 : std_logic;
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
    -- azimuth
    azimuth_n65 <= "0";
    azimuth_n76 <= "1";
    azimuth_n77 <= 24x"b8f8f2";
    azimuth_n78 <= 24x"000000";
    azimuth_n84 <= 24x"200000";
    azimuth_n95 <= 24x"12e405";
    azimuth_n106 <= 24x"09fb38";
    azimuth_n117 <= 24x"051112";
    azimuth_n128 <= 24x"028b0d";
    azimuth_n139 <= 24x"0145d8";
    azimuth_n150 <= 24x"00a2f6";
    azimuth_n161 <= 24x"00517c";
    azimuth_n172 <= 24x"0028be";
    azimuth_n183 <= 24x"00145f";
    azimuth_n194 <= 24x"000a30";
    azimuth_n205 <= 24x"000518";
    azimuth_n216 <= 24x"00028c";
    azimuth_n227 <= 24x"000146";
    azimuth_n238 <= 24x"0000a3";
    azimuth_n249 <= 24x"000051";
    azimuth_n260 <= 24x"000029";
    azimuth_n268 <= 24x"000014";
    azimuth_n273 <= 24x"800000";

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
    x_sum <= resize(sums_x_sum, 24) + 24x"000002";
    x_cut <= x_sum(23 downto 2);
    x_over <= "1" when x_cut(21) = '0' and (or x_cut(20 downto 19)) = '1' else "0";
    x_under <= "1" when x_cut(21) = '1' and (and x_cut(20 downto 19)) = '0' else "0";
    x <= 20x"7ffff" when x_over(0) = '1' else 20x"80000" when x_under(0) = '1' else x_cut(19 downto 0);
    y_sum <= resize(sums_y_sum_s2, 22) + 22x"000001";
    y_cut <= y_sum(21 downto 1);
    y_over <= "1" when y_cut(20) = '0' and (or y_cut(19 downto 19)) = '1' else "0";
    y <= 20x"7ffff" when y_over(0) = '1' else y_cut(19 downto 0);
    z_sum <= resize(sums_z_sum, 24) + 24x"000002";
    z_cut <= z_sum(23 downto 2);
    z_over <= "1" when z_cut(21) = '0' and (or z_cut(20 downto 19)) = '1' else "0";
    z_under <= "1" when z_cut(21) = '1' and (and z_cut(20 downto 19)) = '0' else "0";
    z <= 20x"7ffff" when z_over(0) = '1' else 20x"80000" when z_under(0) = '1' else z_cut(19 downto 0);
    -- azimuth
    azimuth_n63_wide <= shift_left(resize(x, 26), 6);
    azimuth_n63 <= resize(azimuth_n63_wide, 27);
    azimuth_n64_wide <= shift_left(resize(y, 26), 6);
    azimuth_n64 <= resize(azimuth_n64_wide, 27);
    azimuth_n66 <= "1" when unsigned(azimuth_n63) = shift_left(resize(azimuth_n65, 27), 24) else "0";
    azimuth_n67 <= "1" when unsigned(azimuth_n64) = shift_left(resize(azimuth_n65, 27), 24) else "0";
    azimuth_n69 <= unsigned(azimuth_n63(26 downto 26));
    azimuth_n70 <= -resize(azimuth_n63, 28);
    azimuth_n71 <= -resize(azimuth_n64, 28);
    azimuth_n73 <= azimuth_n71 when azimuth_n69(0) = '1' else resize(azimuth_n64, 28);
    azimuth_n75_over <= "1" when azimuth_n73(27) = '0' and (or azimuth_n73(26 downto 26)) = '1' else "0";
    azimuth_n75_under <= "1" when azimuth_n73(27) = '1' and (and azimuth_n73(26 downto 26)) = '0' else "0";
    azimuth_n75 <= 27x"3ffffff" when azimuth_n75_over(0) = '1' else 27x"4000000" when azimuth_n75_under(0) = '1' else azimuth_n73(26 downto 0);
    azimuth_n80 <= unsigned(azimuth_n75(26 downto 26));
    -- polar_angle
    polar_angle_n276 <= z;
    polar_angle_n277 <= z;
    polar_angle_n278 <= resize(polar_angle_n276, 23) + shift_left(resize(polar_angle_n277, 23), 2);
    polar_angle_n279 <= z;
    polar_angle_n281 <= z;
    polar_angle_n283 <= z;
    polar_angle_n285 <= z;
    polar_angle_n287 <= z;
    polar_angle_n289 <= z;
    polar_angle_n291 <= z;
    polar_angle_n293 <= z;
    polar_angle_n295 <= z;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n63_s3 <= azimuth_n63;
                azimuth_n66_s3 <= azimuth_n66;
                azimuth_n67_s3 <= azimuth_n67;
                azimuth_n69_s3 <= azimuth_n69;
                azimuth_n70_s3 <= azimuth_n70;
                azimuth_n75_s3 <= azimuth_n75;
                azimuth_n80_s3 <= azimuth_n80;
                polar_angle_n278_s3 <= polar_angle_n278;
                polar_angle_n279_s3 <= polar_angle_n279;
                polar_angle_n281_s3 <= polar_angle_n281;
                polar_angle_n283_s3 <= polar_angle_n283;
                polar_angle_n285_s3 <= polar_angle_n285;
                polar_angle_n287_s3 <= polar_angle_n287;
                polar_angle_n289_s3 <= polar_angle_n289;
                polar_angle_n291_s3 <= polar_angle_n291;
                polar_angle_n293_s3 <= polar_angle_n293;
                polar_angle_n295_s3 <= polar_angle_n295;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- azimuth
    azimuth_n68 <= azimuth_n66_s3 and azimuth_n67_s3;
    azimuth_n72 <= azimuth_n70_s3 when azimuth_n69_s3(0) = '1' else resize(azimuth_n63_s3, 28);
    azimuth_n74_over <= "1" when azimuth_n72(27) = '0' and (or azimuth_n72(26 downto 26)) = '1' else "0";
    azimuth_n74_under <= "1" when azimuth_n72(27) = '1' and (and azimuth_n72(26 downto 26)) = '0' else "0";
    azimuth_n74 <= 27x"3ffffff" when azimuth_n74_over(0) = '1' else 27x"4000000" when azimuth_n74_under(0) = '1' else azimuth_n72(26 downto 0);
    azimuth_n79 <= azimuth_n77 when azimuth_n68(0) = '1' else azimuth_n78;
    azimuth_n81 <= azimuth_n80_s3 xor azimuth_n76;
    azimuth_n82_term <= unsigned(resize(azimuth_n75_s3, 28)) xor (27 downto 0 => azimuth_n80_s3(0));
    azimuth_n82 <= resize(azimuth_n74, 28) + signed(azimuth_n82_term) + azimuth_n80_s3(0);
    azimuth_n83_term <= unsigned(resize(azimuth_n74, 28)) xor (27 downto 0 => azimuth_n81(0));
    azimuth_n83 <= resize(azimuth_n75_s3, 28) + signed(azimuth_n83_term) + azimuth_n81(0);
    azimuth_n85_term <= unsigned(resize(azimuth_n84, 25)) xor (24 downto 0 => azimuth_n80_s3(0));
    azimuth_n85 <= resize(azimuth_n79, 25) + signed(azimuth_n85_term) + azimuth_n80_s3(0);
    azimuth_n86_over <= "1" when azimuth_n85(24) = '0' and (or azimuth_n85(23 downto 23)) = '1' else "0";
    azimuth_n86_under <= "1" when azimuth_n85(24) = '1' and (and azimuth_n85(23 downto 23)) = '0' else "0";
    azimuth_n86 <= 24x"7fffff" when azimuth_n86_over(0) = '1' else 24x"800000" when azimuth_n86_under(0) = '1' else azimuth_n85(23 downto 0);
    azimuth_n87_over <= "1" when azimuth_n82(27) = '0' and (or azimuth_n82(26 downto 26)) = '1' else "0";
    azimuth_n87_under <= "1" when azimuth_n82(27) = '1' and (and azimuth_n82(26 downto 26)) = '0' else "0";
    azimuth_n87 <= 27x"3ffffff" when azimuth_n87_over(0) = '1' else 27x"4000000" when azimuth_n87_under(0) = '1' else azimuth_n82(26 downto 0);
    azimuth_n88_over <= "1" when azimuth_n83(27) = '0' and (or azimuth_n83(26 downto 26)) = '1' else "0";
    azimuth_n88_under <= "1" when azimuth_n83(27) = '1' and (and azimuth_n83(26 downto 26)) = '0' else "0";
    azimuth_n88 <= 27x"3ffffff" when azimuth_n88_over(0) = '1' else 27x"4000000" when azimuth_n88_under(0) = '1' else azimuth_n83(26 downto 0);
    azimuth_n89 <= unsigned(azimuth_n88(26 downto 26));
    azimuth_n90 <= azimuth_n89 xor azimuth_n76;
    azimuth_n91 <= azimuth_n88;
    azimuth_n92 <= azimuth_n87;
    azimuth_n93_term <= unsigned(resize(azimuth_n91, 29)) xor (28 downto 0 => azimuth_n89(0));
    azimuth_n93 <= shift_left(resize(azimuth_n87, 29), 1) + signed(azimuth_n93_term) + azimuth_n89(0);
    azimuth_n96_term <= unsigned(resize(azimuth_n95, 25)) xor (24 downto 0 => azimuth_n89(0));
    azimuth_n96 <= resize(azimuth_n86, 25) + signed(azimuth_n96_term) + azimuth_n89(0);
    -- polar_angle
    polar_angle_n280 <= resize(polar_angle_n278_s3, 25) + shift_left(resize(polar_angle_n279_s3, 25), 4);
    polar_angle_n282 <= resize(polar_angle_n280, 30) + shift_left(resize(polar_angle_n281_s3, 30), 9);
    polar_angle_n284 <= resize(polar_angle_n282, 33) + shift_left(resize(polar_angle_n283_s3, 33), 12);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s4 <= azimuth_n69_s3;
                azimuth_n88_s4 <= azimuth_n88;
                azimuth_n90_s4 <= azimuth_n90;
                azimuth_n92_s4 <= azimuth_n92;
                azimuth_n93_s4 <= azimuth_n93;
                azimuth_n96_s4 <= azimuth_n96;
                polar_angle_n284_s4 <= polar_angle_n284;
                polar_angle_n285_s4 <= polar_angle_n285_s3;
                polar_angle_n287_s4 <= polar_angle_n287_s3;
                polar_angle_n289_s4 <= polar_angle_n289_s3;
                polar_angle_n291_s4 <= polar_angle_n291_s3;
                polar_angle_n293_s4 <= polar_angle_n293_s3;
                polar_angle_n295_s4 <= polar_angle_n295_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- azimuth
    azimuth_n94_term <= unsigned(resize(azimuth_n92_s4, 29)) xor (28 downto 0 => azimuth_n90_s4(0));
    azimuth_n94 <= shift_left(resize(azimuth_n88_s4, 29), 1) + signed(azimuth_n94_term) + azimuth_n90_s4(0);
    azimuth_n97_over <= "1" when azimuth_n96_s4(24) = '0' and (or azimuth_n96_s4(23 downto 23)) = '1' else "0";
    azimuth_n97_under <= "1" when azimuth_n96_s4(24) = '1' and (and azimuth_n96_s4(23 downto 23)) = '0' else "0";
    azimuth_n97 <= 24x"7fffff" when azimuth_n97_over(0) = '1' else 24x"800000" when azimuth_n97_under(0) = '1' else azimuth_n96_s4(23 downto 0);
    azimuth_n98_cut <= azimuth_n93_s4(28 downto 1);
    azimuth_n98_over <= "1" when azimuth_n98_cut(27) = '0' and (or azimuth_n98_cut(26 downto 26)) = '1' else "0";
    azimuth_n98_under <= "1" when azimuth_n98_cut(27) = '1' and (and azimuth_n98_cut(26 downto 26)) = '0' else "0";
    azimuth_n98 <= 27x"3ffffff" when azimuth_n98_over(0) = '1' else 27x"4000000" when azimuth_n98_under(0) = '1' else azimuth_n98_cut(26 downto 0);
    azimuth_n99_cut <= azimuth_n94(28 downto 1);
    azimuth_n99_over <= "1" when azimuth_n99_cut(27) = '0' and (or azimuth_n99_cut(26 downto 26)) = '1' else "0";
    azimuth_n99_under <= "1" when azimuth_n99_cut(27) = '1' and (and azimuth_n99_cut(26 downto 26)) = '0' else "0";
    azimuth_n99 <= 27x"3ffffff" when azimuth_n99_over(0) = '1' else 27x"4000000" when azimuth_n99_under(0) = '1' else azimuth_n99_cut(26 downto 0);
    azimuth_n100 <= unsigned(azimuth_n99(26 downto 26));
    azimuth_n101 <= azimuth_n100 xor azimuth_n76;
    azimuth_n102 <= azimuth_n99;
    azimuth_n103 <= azimuth_n98;
    azimuth_n104_term <= unsigned(resize(azimuth_n102, 30)) xor (29 downto 0 => azimuth_n100(0));
    azimuth_n104 <= shift_left(resize(azimuth_n98, 30), 2) + signed(azimuth_n104_term) + azimuth_n100(0);
    azimuth_n105_term <= unsigned(resize(azimuth_n103, 30)) xor (29 downto 0 => azimuth_n101(0));
    azimuth_n105 <= shift_left(resize(azimuth_n99, 30), 2) + signed(azimuth_n105_term) + azimuth_n101(0);
    azimuth_n107_term <= unsigned(resize(azimuth_n106, 25)) xor (24 downto 0 => azimuth_n100(0));
    azimuth_n107 <= resize(azimuth_n97, 25) + signed(azimuth_n107_term) + azimuth_n100(0);
    azimuth_n108_over <= "1" when azimuth_n107(24) = '0' and (or azimuth_n107(23 downto 23)) = '1' else "0";
    azimuth_n108_under <= "1" when azimuth_n107(24) = '1' and (and azimuth_n107(23 downto 23)) = '0' else "0";
    azimuth_n108 <= 24x"7fffff" when azimuth_n108_over(0) = '1' else 24x"800000" when azimuth_n108_under(0) = '1' else azimuth_n107(23 downto 0);
    azimuth_n109_cut <= azimuth_n104(29 downto 2);
    azimuth_n109_over <= "1" when azimuth_n109_cut(27) = '0' and (or azimuth_n109_cut(26 downto 26)) = '1' else "0";
    azimuth_n109_under <= "1" when azimuth_n109_cut(27) = '1' and (and azimuth_n109_cut(26 downto 26)) = '0' else "0";
    azimuth_n109 <= 27x"3ffffff" when azimuth_n109_over(0) = '1' else 27x"4000000" when azimuth_n109_under(0) = '1' else azimuth_n109_cut(26 downto 0);
    azimuth_n110_cut <= azimuth_n105(29 downto 2);
    azimuth_n110_over <= "1" when azimuth_n110_cut(27) = '0' and (or azimuth_n110_cut(26 downto 26)) = '1' else "0";
    azimuth_n110_under <= "1" when azimuth_n110_cut(27) = '1' and (and azimuth_n110_cut(26 downto 26)) = '0' else "0";
    azimuth_n110 <= 27x"3ffffff" when azimuth_n110_over(0) = '1' else 27x"4000000" when azimuth_n110_under(0) = '1' else azimuth_n110_cut(26 downto 0);
    azimuth_n111 <= unsigned(azimuth_n110(26 downto 26));
    azimuth_n113 <= azimuth_n110;
    azimuth_n114 <= azimuth_n109;
    -- polar_angle
    polar_angle_n286 <= resize(polar_angle_n284_s4, 36) - shift_left(resize(polar_angle_n285_s4, 36), 15);
    polar_angle_n288 <= resize(polar_angle_n286, 38) - shift_left(resize(polar_angle_n287_s4, 38), 17);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s5 <= azimuth_n69_s4;
                azimuth_n108_s5 <= azimuth_n108;
                azimuth_n109_s5 <= azimuth_n109;
                azimuth_n110_s5 <= azimuth_n110;
                azimuth_n111_s5 <= azimuth_n111;
                azimuth_n113_s5 <= azimuth_n113;
                azimuth_n114_s5 <= azimuth_n114;
                polar_angle_n288_s5 <= polar_angle_n288;
                polar_angle_n289_s5 <= polar_angle_n289_s4;
                polar_angle_n291_s5 <= polar_angle_n291_s4;
                polar_angle_n293_s5 <= polar_angle_n293_s4;
                polar_angle_n295_s5 <= polar_angle_n295_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- azimuth
    azimuth_n112 <= azimuth_n111_s5 xor azimuth_n76;
    azimuth_n115_term <= unsigned(resize(azimuth_n113_s5, 31)) xor (30 downto 0 => azimuth_n111_s5(0));
    azimuth_n115 <= shift_left(resize(azimuth_n109_s5, 31), 3) + signed(azimuth_n115_term) + azimuth_n111_s5(0);
    azimuth_n116_term <= unsigned(resize(azimuth_n114_s5, 31)) xor (30 downto 0 => azimuth_n112(0));
    azimuth_n116 <= shift_left(resize(azimuth_n110_s5, 31), 3) + signed(azimuth_n116_term) + azimuth_n112(0);
    azimuth_n118_term <= unsigned(resize(azimuth_n117, 25)) xor (24 downto 0 => azimuth_n111_s5(0));
    azimuth_n118 <= resize(azimuth_n108_s5, 25) + signed(azimuth_n118_term) + azimuth_n111_s5(0);
    azimuth_n119_over <= "1" when azimuth_n118(24) = '0' and (or azimuth_n118(23 downto 23)) = '1' else "0";
    azimuth_n119_under <= "1" when azimuth_n118(24) = '1' and (and azimuth_n118(23 downto 23)) = '0' else "0";
    azimuth_n119 <= 24x"7fffff" when azimuth_n119_over(0) = '1' else 24x"800000" when azimuth_n119_under(0) = '1' else azimuth_n118(23 downto 0);
    azimuth_n120_cut <= azimuth_n115(30 downto 3);
    azimuth_n120_over <= "1" when azimuth_n120_cut(27) = '0' and (or azimuth_n120_cut(26 downto 26)) = '1' else "0";
    azimuth_n120_under <= "1" when azimuth_n120_cut(27) = '1' and (and azimuth_n120_cut(26 downto 26)) = '0' else "0";
    azimuth_n120 <= 27x"3ffffff" when azimuth_n120_over(0) = '1' else 27x"4000000" when azimuth_n120_under(0) = '1' else azimuth_n120_cut(26 downto 0);
    azimuth_n121_cut <= azimuth_n116(30 downto 3);
    azimuth_n121_over <= "1" when azimuth_n121_cut(27) = '0' and (or azimuth_n121_cut(26 downto 26)) = '1' else "0";
    azimuth_n121_under <= "1" when azimuth_n121_cut(27) = '1' and (and azimuth_n121_cut(26 downto 26)) = '0' else "0";
    azimuth_n121 <= 27x"3ffffff" when azimuth_n121_over(0) = '1' else 27x"4000000" when azimuth_n121_under(0) = '1' else azimuth_n121_cut(26 downto 0);
    azimuth_n122 <= unsigned(azimuth_n121(26 downto 26));
    azimuth_n123 <= azimuth_n122 xor azimuth_n76;
    azimuth_n124 <= azimuth_n121;
    azimuth_n125 <= azimuth_n120;
    azimuth_n126_term <= unsigned(resize(azimuth_n124, 32)) xor (31 downto 0 => azimuth_n122(0));
    azimuth_n126 <= shift_left(resize(azimuth_n120, 32), 4) + signed(azimuth_n126_term) + azimuth_n122(0);
    azimuth_n127_term <= unsigned(resize(azimuth_n125, 32)) xor (31 downto 0 => azimuth_n123(0));
    azimuth_n127 <= shift_left(resize(azimuth_n121, 32), 4) + signed(azimuth_n127_term) + azimuth_n123(0);
    azimuth_n129_term <= unsigned(resize(azimuth_n128, 25)) xor (24 downto 0 => azimuth_n122(0));
    azimuth_n129 <= resize(azimuth_n119, 25) + signed(azimuth_n129_term) + azimuth_n122(0);
    azimuth_n130_over <= "1" when azimuth_n129(24) = '0' and (or azimuth_n129(23 downto 23)) = '1' else "0";
    azimuth_n130_under <= "1" when azimuth_n129(24) = '1' and (and azimuth_n129(23 downto 23)) = '0' else "0";
    azimuth_n130 <= 24x"7fffff" when azimuth_n130_over(0) = '1' else 24x"800000" when azimuth_n130_under(0) = '1' else azimuth_n129(23 downto 0);
    azimuth_n131_cut <= azimuth_n126(31 downto 4);
    azimuth_n131_over <= "1" when azimuth_n131_cut(27) = '0' and (or azimuth_n131_cut(26 downto 26)) = '1' else "0";
    azimuth_n131_under <= "1" when azimuth_n131_cut(27) = '1' and (and azimuth_n131_cut(26 downto 26)) = '0' else "0";
    azimuth_n131 <= 27x"3ffffff" when azimuth_n131_over(0) = '1' else 27x"4000000" when azimuth_n131_under(0) = '1' else azimuth_n131_cut(26 downto 0);
    azimuth_n136 <= azimuth_n131;
    -- polar_angle
    polar_angle_n290 <= resize(polar_angle_n288_s5, 40) + shift_left(resize(polar_angle_n289_s5, 40), 19);
    polar_angle_n292 <= resize(polar_angle_n290, 42) + shift_left(resize(polar_angle_n291_s5, 42), 21);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s6 <= azimuth_n69_s5;
                azimuth_n127_s6 <= azimuth_n127;
                azimuth_n130_s6 <= azimuth_n130;
                azimuth_n131_s6 <= azimuth_n131;
                azimuth_n136_s6 <= azimuth_n136;
                polar_angle_n292_s6 <= polar_angle_n292;
                polar_angle_n293_s6 <= polar_angle_n293_s5;
                polar_angle_n295_s6 <= polar_angle_n295_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- azimuth
    azimuth_n132_cut <= azimuth_n127_s6(31 downto 4);
    azimuth_n132_over <= "1" when azimuth_n132_cut(27) = '0' and (or azimuth_n132_cut(26 downto 26)) = '1' else "0";
    azimuth_n132_under <= "1" when azimuth_n132_cut(27) = '1' and (and azimuth_n132_cut(26 downto 26)) = '0' else "0";
    azimuth_n132 <= 27x"3ffffff" when azimuth_n132_over(0) = '1' else 27x"4000000" when azimuth_n132_under(0) = '1' else azimuth_n132_cut(26 downto 0);
    azimuth_n133 <= unsigned(azimuth_n132(26 downto 26));
    azimuth_n134 <= azimuth_n133 xor azimuth_n76;
    azimuth_n135 <= azimuth_n132;
    azimuth_n137_term <= unsigned(resize(azimuth_n135, 33)) xor (32 downto 0 => azimuth_n133(0));
    azimuth_n137 <= shift_left(resize(azimuth_n131_s6, 33), 5) + signed(azimuth_n137_term) + azimuth_n133(0);
    azimuth_n138_term <= unsigned(resize(azimuth_n136_s6, 33)) xor (32 downto 0 => azimuth_n134(0));
    azimuth_n138 <= shift_left(resize(azimuth_n132, 33), 5) + signed(azimuth_n138_term) + azimuth_n134(0);
    azimuth_n140_term <= unsigned(resize(azimuth_n139, 25)) xor (24 downto 0 => azimuth_n133(0));
    azimuth_n140 <= resize(azimuth_n130_s6, 25) + signed(azimuth_n140_term) + azimuth_n133(0);
    azimuth_n141_over <= "1" when azimuth_n140(24) = '0' and (or azimuth_n140(23 downto 23)) = '1' else "0";
    azimuth_n141_under <= "1" when azimuth_n140(24) = '1' and (and azimuth_n140(23 downto 23)) = '0' else "0";
    azimuth_n141 <= 24x"7fffff" when azimuth_n141_over(0) = '1' else 24x"800000" when azimuth_n141_under(0) = '1' else azimuth_n140(23 downto 0);
    azimuth_n142_cut <= azimuth_n137(32 downto 5);
    azimuth_n142_over <= "1" when azimuth_n142_cut(27) = '0' and (or azimuth_n142_cut(26 downto 26)) = '1' else "0";
    azimuth_n142_under <= "1" when azimuth_n142_cut(27) = '1' and (and azimuth_n142_cut(26 downto 26)) = '0' else "0";
    azimuth_n142 <= 27x"3ffffff" when azimuth_n142_over(0) = '1' else 27x"4000000" when azimuth_n142_under(0) = '1' else azimuth_n142_cut(26 downto 0);
    azimuth_n143_cut <= azimuth_n138(32 downto 5);
    azimuth_n143_over <= "1" when azimuth_n143_cut(27) = '0' and (or azimuth_n143_cut(26 downto 26)) = '1' else "0";
    azimuth_n143_under <= "1" when azimuth_n143_cut(27) = '1' and (and azimuth_n143_cut(26 downto 26)) = '0' else "0";
    azimuth_n143 <= 27x"3ffffff" when azimuth_n143_over(0) = '1' else 27x"4000000" when azimuth_n143_under(0) = '1' else azimuth_n143_cut(26 downto 0);
    azimuth_n144 <= unsigned(azimuth_n143(26 downto 26));
    azimuth_n145 <= azimuth_n144 xor azimuth_n76;
    azimuth_n146 <= azimuth_n143;
    azimuth_n147 <= azimuth_n142;
    azimuth_n151_term <= unsigned(resize(azimuth_n150, 25)) xor (24 downto 0 => azimuth_n144(0));
    azimuth_n151 <= resize(azimuth_n141, 25) + signed(azimuth_n151_term) + azimuth_n144(0);
    -- polar_angle
    polar_angle_n294 <= resize(polar_angle_n292_s6, 44) - shift_left(resize(polar_angle_n293_s6, 44), 23);
    polar_angle_n296 <= resize(polar_angle_n294, 46) + shift_left(resize(polar_angle_n295_s6, 46), 25);
    polar_angle_n297_cut <= polar_angle_n296(45 downto 18);
    polar_angle_n297_over <= "1" when polar_angle_n297_cut(27) = '0' and (or polar_angle_n297_cut(26 downto 26)) = '1' else "0";
    polar_angle_n297_under <= "1" when polar_angle_n297_cut(27) = '1' and (and polar_angle_n297_cut(26 downto 26)) = '0' else "0";
    polar_angle_n297 <= 27x"3ffffff" when polar_angle_n297_over(0) = '1' else 27x"4000000" when polar_angle_n297_under(0) = '1' else polar_angle_n297_cut(26 downto 0);
    polar_angle_n301 <= unsigned(polar_angle_n297(26 downto 26));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s7 <= azimuth_n69_s6;
                azimuth_n142_s7 <= azimuth_n142;
                azimuth_n143_s7 <= azimuth_n143;
                azimuth_n144_s7 <= azimuth_n144;
                azimuth_n145_s7 <= azimuth_n145;
                azimuth_n146_s7 <= azimuth_n146;
                azimuth_n147_s7 <= azimuth_n147;
                azimuth_n151_s7 <= azimuth_n151;
                polar_angle_n297_s7 <= polar_angle_n297;
                polar_angle_n301_s7 <= polar_angle_n301;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- azimuth
    azimuth_n148_term <= unsigned(resize(azimuth_n146_s7, 34)) xor (33 downto 0 => azimuth_n144_s7(0));
    azimuth_n148 <= shift_left(resize(azimuth_n142_s7, 34), 6) + signed(azimuth_n148_term) + azimuth_n144_s7(0);
    azimuth_n149_term <= unsigned(resize(azimuth_n147_s7, 34)) xor (33 downto 0 => azimuth_n145_s7(0));
    azimuth_n149 <= shift_left(resize(azimuth_n143_s7, 34), 6) + signed(azimuth_n149_term) + azimuth_n145_s7(0);
    azimuth_n152_over <= "1" when azimuth_n151_s7(24) = '0' and (or azimuth_n151_s7(23 downto 23)) = '1' else "0";
    azimuth_n152_under <= "1" when azimuth_n151_s7(24) = '1' and (and azimuth_n151_s7(23 downto 23)) = '0' else "0";
    azimuth_n152 <= 24x"7fffff" when azimuth_n152_over(0) = '1' else 24x"800000" when azimuth_n152_under(0) = '1' else azimuth_n151_s7(23 downto 0);
    azimuth_n153_cut <= azimuth_n148(33 downto 6);
    azimuth_n153_over <= "1" when azimuth_n153_cut(27) = '0' and (or azimuth_n153_cut(26 downto 26)) = '1' else "0";
    azimuth_n153_under <= "1" when azimuth_n153_cut(27) = '1' and (and azimuth_n153_cut(26 downto 26)) = '0' else "0";
    azimuth_n153 <= 27x"3ffffff" when azimuth_n153_over(0) = '1' else 27x"4000000" when azimuth_n153_under(0) = '1' else azimuth_n153_cut(26 downto 0);
    azimuth_n154_cut <= azimuth_n149(33 downto 6);
    azimuth_n154_over <= "1" when azimuth_n154_cut(27) = '0' and (or azimuth_n154_cut(26 downto 26)) = '1' else "0";
    azimuth_n154_under <= "1" when azimuth_n154_cut(27) = '1' and (and azimuth_n154_cut(26 downto 26)) = '0' else "0";
    azimuth_n154 <= 27x"3ffffff" when azimuth_n154_over(0) = '1' else 27x"4000000" when azimuth_n154_under(0) = '1' else azimuth_n154_cut(26 downto 0);
    azimuth_n155 <= unsigned(azimuth_n154(26 downto 26));
    azimuth_n156 <= azimuth_n155 xor azimuth_n76;
    azimuth_n157 <= azimuth_n154;
    azimuth_n158 <= azimuth_n153;
    azimuth_n159_term <= unsigned(resize(azimuth_n157, 35)) xor (34 downto 0 => azimuth_n155(0));
    azimuth_n159 <= shift_left(resize(azimuth_n153, 35), 7) + signed(azimuth_n159_term) + azimuth_n155(0);
    azimuth_n160_term <= unsigned(resize(azimuth_n158, 35)) xor (34 downto 0 => azimuth_n156(0));
    azimuth_n160 <= shift_left(resize(azimuth_n154, 35), 7) + signed(azimuth_n160_term) + azimuth_n156(0);
    azimuth_n162_term <= unsigned(resize(azimuth_n161, 25)) xor (24 downto 0 => azimuth_n155(0));
    azimuth_n162 <= resize(azimuth_n152, 25) + signed(azimuth_n162_term) + azimuth_n155(0);
    azimuth_n163_over <= "1" when azimuth_n162(24) = '0' and (or azimuth_n162(23 downto 23)) = '1' else "0";
    azimuth_n163_under <= "1" when azimuth_n162(24) = '1' and (and azimuth_n162(23 downto 23)) = '0' else "0";
    azimuth_n163 <= 24x"7fffff" when azimuth_n163_over(0) = '1' else 24x"800000" when azimuth_n163_under(0) = '1' else azimuth_n162(23 downto 0);
    azimuth_n164_cut <= azimuth_n159(34 downto 7);
    azimuth_n164_over <= "1" when azimuth_n164_cut(27) = '0' and (or azimuth_n164_cut(26 downto 26)) = '1' else "0";
    azimuth_n164_under <= "1" when azimuth_n164_cut(27) = '1' and (and azimuth_n164_cut(26 downto 26)) = '0' else "0";
    azimuth_n164 <= 27x"3ffffff" when azimuth_n164_over(0) = '1' else 27x"4000000" when azimuth_n164_under(0) = '1' else azimuth_n164_cut(26 downto 0);
    azimuth_n169 <= azimuth_n164;
    -- polar_angle
    polar_angle_n298 <= "1" when unsigned(polar_angle_n297_s7) = shift_left(resize(azimuth_n65, 27), 24) else "0";
    polar_angle_n302 <= -resize(polar_angle_n297_s7, 28);
    polar_angle_n304 <= polar_angle_n302 when polar_angle_n301_s7(0) = '1' else resize(polar_angle_n297_s7, 28);
    polar_angle_n306_over <= "1" when polar_angle_n304(27) = '0' and (or polar_angle_n304(26 downto 26)) = '1' else "0";
    polar_angle_n306_under <= "1" when polar_angle_n304(27) = '1' and (and polar_angle_n304(26 downto 26)) = '0' else "0";
    polar_angle_n306 <= 27x"3ffffff" when polar_angle_n306_over(0) = '1' else 27x"4000000" when polar_angle_n306_under(0) = '1' else polar_angle_n304(26 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s8 <= azimuth_n69_s7;
                azimuth_n160_s8 <= azimuth_n160;
                azimuth_n163_s8 <= azimuth_n163;
                azimuth_n164_s8 <= azimuth_n164;
                azimuth_n169_s8 <= azimuth_n169;
                polar_angle_n298_s8 <= polar_angle_n298;
                polar_angle_n301_s8 <= polar_angle_n301_s7;
                polar_angle_n306_s8 <= polar_angle_n306;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- azimuth
    azimuth_n165_cut <= azimuth_n160_s8(34 downto 7);
    azimuth_n165_over <= "1" when azimuth_n165_cut(27) = '0' and (or azimuth_n165_cut(26 downto 26)) = '1' else "0";
    azimuth_n165_under <= "1" when azimuth_n165_cut(27) = '1' and (and azimuth_n165_cut(26 downto 26)) = '0' else "0";
    azimuth_n165 <= 27x"3ffffff" when azimuth_n165_over(0) = '1' else 27x"4000000" when azimuth_n165_under(0) = '1' else azimuth_n165_cut(26 downto 0);
    azimuth_n166 <= unsigned(azimuth_n165(26 downto 26));
    azimuth_n167 <= azimuth_n166 xor azimuth_n76;
    azimuth_n168 <= azimuth_n165;
    azimuth_n170_term <= unsigned(resize(azimuth_n168, 36)) xor (35 downto 0 => azimuth_n166(0));
    azimuth_n170 <= shift_left(resize(azimuth_n164_s8, 36), 8) + signed(azimuth_n170_term) + azimuth_n166(0);
    azimuth_n171_term <= unsigned(resize(azimuth_n169_s8, 36)) xor (35 downto 0 => azimuth_n167(0));
    azimuth_n171 <= shift_left(resize(azimuth_n165, 36), 8) + signed(azimuth_n171_term) + azimuth_n167(0);
    azimuth_n173_term <= unsigned(resize(azimuth_n172, 25)) xor (24 downto 0 => azimuth_n166(0));
    azimuth_n173 <= resize(azimuth_n163_s8, 25) + signed(azimuth_n173_term) + azimuth_n166(0);
    azimuth_n174_over <= "1" when azimuth_n173(24) = '0' and (or azimuth_n173(23 downto 23)) = '1' else "0";
    azimuth_n174_under <= "1" when azimuth_n173(24) = '1' and (and azimuth_n173(23 downto 23)) = '0' else "0";
    azimuth_n174 <= 24x"7fffff" when azimuth_n174_over(0) = '1' else 24x"800000" when azimuth_n174_under(0) = '1' else azimuth_n173(23 downto 0);
    azimuth_n175_cut <= azimuth_n170(35 downto 8);
    azimuth_n175_over <= "1" when azimuth_n175_cut(27) = '0' and (or azimuth_n175_cut(26 downto 26)) = '1' else "0";
    azimuth_n175_under <= "1" when azimuth_n175_cut(27) = '1' and (and azimuth_n175_cut(26 downto 26)) = '0' else "0";
    azimuth_n175 <= 27x"3ffffff" when azimuth_n175_over(0) = '1' else 27x"4000000" when azimuth_n175_under(0) = '1' else azimuth_n175_cut(26 downto 0);
    azimuth_n176_cut <= azimuth_n171(35 downto 8);
    azimuth_n176_over <= "1" when azimuth_n176_cut(27) = '0' and (or azimuth_n176_cut(26 downto 26)) = '1' else "0";
    azimuth_n176_under <= "1" when azimuth_n176_cut(27) = '1' and (and azimuth_n176_cut(26 downto 26)) = '0' else "0";
    azimuth_n176 <= 27x"3ffffff" when azimuth_n176_over(0) = '1' else 27x"4000000" when azimuth_n176_under(0) = '1' else azimuth_n176_cut(26 downto 0);
    azimuth_n177 <= unsigned(azimuth_n176(26 downto 26));
    azimuth_n178 <= azimuth_n177 xor azimuth_n76;
    azimuth_n179 <= azimuth_n176;
    azimuth_n180 <= azimuth_n175;
    azimuth_n184_term <= unsigned(resize(azimuth_n183, 25)) xor (24 downto 0 => azimuth_n177(0));
    azimuth_n184 <= resize(azimuth_n174, 25) + signed(azimuth_n184_term) + azimuth_n177(0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s9 <= azimuth_n69_s8;
                azimuth_n175_s9 <= azimuth_n175;
                azimuth_n176_s9 <= azimuth_n176;
                azimuth_n177_s9 <= azimuth_n177;
                azimuth_n178_s9 <= azimuth_n178;
                azimuth_n179_s9 <= azimuth_n179;
                azimuth_n180_s9 <= azimuth_n180;
                azimuth_n184_s9 <= azimuth_n184;
                polar_angle_n298_s9 <= polar_angle_n298_s8;
                polar_angle_n301_s9 <= polar_angle_n301_s8;
                polar_angle_n306_s9 <= polar_angle_n306_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- azimuth
    azimuth_n181_term <= unsigned(resize(azimuth_n179_s9, 37)) xor (36 downto 0 => azimuth_n177_s9(0));
    azimuth_n181 <= shift_left(resize(azimuth_n175_s9, 37), 9) + signed(azimuth_n181_term) + azimuth_n177_s9(0);
    azimuth_n182_term <= unsigned(resize(azimuth_n180_s9, 37)) xor (36 downto 0 => azimuth_n178_s9(0));
    azimuth_n182 <= shift_left(resize(azimuth_n176_s9, 37), 9) + signed(azimuth_n182_term) + azimuth_n178_s9(0);
    azimuth_n185_over <= "1" when azimuth_n184_s9(24) = '0' and (or azimuth_n184_s9(23 downto 23)) = '1' else "0";
    azimuth_n185_under <= "1" when azimuth_n184_s9(24) = '1' and (and azimuth_n184_s9(23 downto 23)) = '0' else "0";
    azimuth_n185 <= 24x"7fffff" when azimuth_n185_over(0) = '1' else 24x"800000" when azimuth_n185_under(0) = '1' else azimuth_n184_s9(23 downto 0);
    azimuth_n186_cut <= azimuth_n181(36 downto 9);
    azimuth_n186_over <= "1" when azimuth_n186_cut(27) = '0' and (or azimuth_n186_cut(26 downto 26)) = '1' else "0";
    azimuth_n186_under <= "1" when azimuth_n186_cut(27) = '1' and (and azimuth_n186_cut(26 downto 26)) = '0' else "0";
    azimuth_n186 <= 27x"3ffffff" when azimuth_n186_over(0) = '1' else 27x"4000000" when azimuth_n186_under(0) = '1' else azimuth_n186_cut(26 downto 0);
    azimuth_n187_cut <= azimuth_n182(36 downto 9);
    azimuth_n187_over <= "1" when azimuth_n187_cut(27) = '0' and (or azimuth_n187_cut(26 downto 26)) = '1' else "0";
    azimuth_n187_under <= "1" when azimuth_n187_cut(27) = '1' and (and azimuth_n187_cut(26 downto 26)) = '0' else "0";
    azimuth_n187 <= 27x"3ffffff" when azimuth_n187_over(0) = '1' else 27x"4000000" when azimuth_n187_under(0) = '1' else azimuth_n187_cut(26 downto 0);
    azimuth_n188 <= unsigned(azimuth_n187(26 downto 26));
    azimuth_n189 <= azimuth_n188 xor azimuth_n76;
    azimuth_n190 <= azimuth_n187;
    azimuth_n191 <= azimuth_n186;
    azimuth_n192_term <= unsigned(resize(azimuth_n190, 38)) xor (37 downto 0 => azimuth_n188(0));
    azimuth_n192 <= shift_left(resize(azimuth_n186, 38), 10) + signed(azimuth_n192_term) + azimuth_n188(0);
    azimuth_n193_term <= unsigned(resize(azimuth_n191, 38)) xor (37 downto 0 => azimuth_n189(0));
    azimuth_n193 <= shift_left(resize(azimuth_n187, 38), 10) + signed(azimuth_n193_term) + azimuth_n189(0);
    azimuth_n195_term <= unsigned(resize(azimuth_n194, 25)) xor (24 downto 0 => azimuth_n188(0));
    azimuth_n195 <= resize(azimuth_n185, 25) + signed(azimuth_n195_term) + azimuth_n188(0);
    azimuth_n196_over <= "1" when azimuth_n195(24) = '0' and (or azimuth_n195(23 downto 23)) = '1' else "0";
    azimuth_n196_under <= "1" when azimuth_n195(24) = '1' and (and azimuth_n195(23 downto 23)) = '0' else "0";
    azimuth_n196 <= 24x"7fffff" when azimuth_n196_over(0) = '1' else 24x"800000" when azimuth_n196_under(0) = '1' else azimuth_n195(23 downto 0);
    azimuth_n197_cut <= azimuth_n192(37 downto 10);
    azimuth_n197_over <= "1" when azimuth_n197_cut(27) = '0' and (or azimuth_n197_cut(26 downto 26)) = '1' else "0";
    azimuth_n197_under <= "1" when azimuth_n197_cut(27) = '1' and (and azimuth_n197_cut(26 downto 26)) = '0' else "0";
    azimuth_n197 <= 27x"3ffffff" when azimuth_n197_over(0) = '1' else 27x"4000000" when azimuth_n197_under(0) = '1' else azimuth_n197_cut(26 downto 0);
    azimuth_n202 <= azimuth_n197;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s10 <= azimuth_n69_s9;
                azimuth_n193_s10 <= azimuth_n193;
                azimuth_n196_s10 <= azimuth_n196;
                azimuth_n197_s10 <= azimuth_n197;
                azimuth_n202_s10 <= azimuth_n202;
                polar_angle_n298_s10 <= polar_angle_n298_s9;
                polar_angle_n301_s10 <= polar_angle_n301_s9;
                polar_angle_n306_s10 <= polar_angle_n306_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- azimuth
    azimuth_n198_cut <= azimuth_n193_s10(37 downto 10);
    azimuth_n198_over <= "1" when azimuth_n198_cut(27) = '0' and (or azimuth_n198_cut(26 downto 26)) = '1' else "0";
    azimuth_n198_under <= "1" when azimuth_n198_cut(27) = '1' and (and azimuth_n198_cut(26 downto 26)) = '0' else "0";
    azimuth_n198 <= 27x"3ffffff" when azimuth_n198_over(0) = '1' else 27x"4000000" when azimuth_n198_under(0) = '1' else azimuth_n198_cut(26 downto 0);
    azimuth_n199 <= unsigned(azimuth_n198(26 downto 26));
    azimuth_n200 <= azimuth_n199 xor azimuth_n76;
    azimuth_n201 <= azimuth_n198;
    azimuth_n203_term <= unsigned(resize(azimuth_n201, 39)) xor (38 downto 0 => azimuth_n199(0));
    azimuth_n203 <= shift_left(resize(azimuth_n197_s10, 39), 11) + signed(azimuth_n203_term) + azimuth_n199(0);
    azimuth_n204_term <= unsigned(resize(azimuth_n202_s10, 39)) xor (38 downto 0 => azimuth_n200(0));
    azimuth_n204 <= shift_left(resize(azimuth_n198, 39), 11) + signed(azimuth_n204_term) + azimuth_n200(0);
    azimuth_n206_term <= unsigned(resize(azimuth_n205, 25)) xor (24 downto 0 => azimuth_n199(0));
    azimuth_n206 <= resize(azimuth_n196_s10, 25) + signed(azimuth_n206_term) + azimuth_n199(0);
    azimuth_n207_over <= "1" when azimuth_n206(24) = '0' and (or azimuth_n206(23 downto 23)) = '1' else "0";
    azimuth_n207_under <= "1" when azimuth_n206(24) = '1' and (and azimuth_n206(23 downto 23)) = '0' else "0";
    azimuth_n207 <= 24x"7fffff" when azimuth_n207_over(0) = '1' else 24x"800000" when azimuth_n207_under(0) = '1' else azimuth_n206(23 downto 0);
    azimuth_n208_cut <= azimuth_n203(38 downto 11);
    azimuth_n208_over <= "1" when azimuth_n208_cut(27) = '0' and (or azimuth_n208_cut(26 downto 26)) = '1' else "0";
    azimuth_n208_under <= "1" when azimuth_n208_cut(27) = '1' and (and azimuth_n208_cut(26 downto 26)) = '0' else "0";
    azimuth_n208 <= 27x"3ffffff" when azimuth_n208_over(0) = '1' else 27x"4000000" when azimuth_n208_under(0) = '1' else azimuth_n208_cut(26 downto 0);
    azimuth_n209_cut <= azimuth_n204(38 downto 11);
    azimuth_n209_over <= "1" when azimuth_n209_cut(27) = '0' and (or azimuth_n209_cut(26 downto 26)) = '1' else "0";
    azimuth_n209_under <= "1" when azimuth_n209_cut(27) = '1' and (and azimuth_n209_cut(26 downto 26)) = '0' else "0";
    azimuth_n209 <= 27x"3ffffff" when azimuth_n209_over(0) = '1' else 27x"4000000" when azimuth_n209_under(0) = '1' else azimuth_n209_cut(26 downto 0);
    azimuth_n210 <= unsigned(azimuth_n209(26 downto 26));
    azimuth_n211 <= azimuth_n210 xor azimuth_n76;
    azimuth_n212 <= azimuth_n209;
    azimuth_n213 <= azimuth_n208;
    azimuth_n217_term <= unsigned(resize(azimuth_n216, 25)) xor (24 downto 0 => azimuth_n210(0));
    azimuth_n217 <= resize(azimuth_n207, 25) + signed(azimuth_n217_term) + azimuth_n210(0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s11 <= azimuth_n69_s10;
                azimuth_n208_s11 <= azimuth_n208;
                azimuth_n209_s11 <= azimuth_n209;
                azimuth_n210_s11 <= azimuth_n210;
                azimuth_n211_s11 <= azimuth_n211;
                azimuth_n212_s11 <= azimuth_n212;
                azimuth_n213_s11 <= azimuth_n213;
                azimuth_n217_s11 <= azimuth_n217;
                polar_angle_n298_s11 <= polar_angle_n298_s10;
                polar_angle_n301_s11 <= polar_angle_n301_s10;
                polar_angle_n306_s11 <= polar_angle_n306_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- azimuth
    azimuth_n214_term <= unsigned(resize(azimuth_n212_s11, 40)) xor (39 downto 0 => azimuth_n210_s11(0));
    azimuth_n214 <= shift_left(resize(azimuth_n208_s11, 40), 12) + signed(azimuth_n214_term) + azimuth_n210_s11(0);
    azimuth_n215_term <= unsigned(resize(azimuth_n213_s11, 40)) xor (39 downto 0 => azimuth_n211_s11(0));
    azimuth_n215 <= shift_left(resize(azimuth_n209_s11, 40), 12) + signed(azimuth_n215_term) + azimuth_n211_s11(0);
    azimuth_n218_over <= "1" when azimuth_n217_s11(24) = '0' and (or azimuth_n217_s11(23 downto 23)) = '1' else "0";
    azimuth_n218_under <= "1" when azimuth_n217_s11(24) = '1' and (and azimuth_n217_s11(23 downto 23)) = '0' else "0";
    azimuth_n218 <= 24x"7fffff" when azimuth_n218_over(0) = '1' else 24x"800000" when azimuth_n218_under(0) = '1' else azimuth_n217_s11(23 downto 0);
    azimuth_n219_cut <= azimuth_n214(39 downto 12);
    azimuth_n219_over <= "1" when azimuth_n219_cut(27) = '0' and (or azimuth_n219_cut(26 downto 26)) = '1' else "0";
    azimuth_n219_under <= "1" when azimuth_n219_cut(27) = '1' and (and azimuth_n219_cut(26 downto 26)) = '0' else "0";
    azimuth_n219 <= 27x"3ffffff" when azimuth_n219_over(0) = '1' else 27x"4000000" when azimuth_n219_under(0) = '1' else azimuth_n219_cut(26 downto 0);
    azimuth_n220_cut <= azimuth_n215(39 downto 12);
    azimuth_n220_over <= "1" when azimuth_n220_cut(27) = '0' and (or azimuth_n220_cut(26 downto 26)) = '1' else "0";
    azimuth_n220_under <= "1" when azimuth_n220_cut(27) = '1' and (and azimuth_n220_cut(26 downto 26)) = '0' else "0";
    azimuth_n220 <= 27x"3ffffff" when azimuth_n220_over(0) = '1' else 27x"4000000" when azimuth_n220_under(0) = '1' else azimuth_n220_cut(26 downto 0);
    azimuth_n221 <= unsigned(azimuth_n220(26 downto 26));
    azimuth_n222 <= azimuth_n221 xor azimuth_n76;
    azimuth_n223 <= azimuth_n220;
    azimuth_n224 <= azimuth_n219;
    azimuth_n225_term <= unsigned(resize(azimuth_n223, 41)) xor (40 downto 0 => azimuth_n221(0));
    azimuth_n225 <= shift_left(resize(azimuth_n219, 41), 13) + signed(azimuth_n225_term) + azimuth_n221(0);
    azimuth_n226_term <= unsigned(resize(azimuth_n224, 41)) xor (40 downto 0 => azimuth_n222(0));
    azimuth_n226 <= shift_left(resize(azimuth_n220, 41), 13) + signed(azimuth_n226_term) + azimuth_n222(0);
    azimuth_n228_term <= unsigned(resize(azimuth_n227, 25)) xor (24 downto 0 => azimuth_n221(0));
    azimuth_n228 <= resize(azimuth_n218, 25) + signed(azimuth_n228_term) + azimuth_n221(0);
    azimuth_n229_over <= "1" when azimuth_n228(24) = '0' and (or azimuth_n228(23 downto 23)) = '1' else "0";
    azimuth_n229_under <= "1" when azimuth_n228(24) = '1' and (and azimuth_n228(23 downto 23)) = '0' else "0";
    azimuth_n229 <= 24x"7fffff" when azimuth_n229_over(0) = '1' else 24x"800000" when azimuth_n229_under(0) = '1' else azimuth_n228(23 downto 0);
    azimuth_n230_cut <= azimuth_n225(40 downto 13);
    azimuth_n230_over <= "1" when azimuth_n230_cut(27) = '0' and (or azimuth_n230_cut(26 downto 26)) = '1' else "0";
    azimuth_n230_under <= "1" when azimuth_n230_cut(27) = '1' and (and azimuth_n230_cut(26 downto 26)) = '0' else "0";
    azimuth_n230 <= 27x"3ffffff" when azimuth_n230_over(0) = '1' else 27x"4000000" when azimuth_n230_under(0) = '1' else azimuth_n230_cut(26 downto 0);
    azimuth_n235 <= azimuth_n230;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s12 <= azimuth_n69_s11;
                azimuth_n226_s12 <= azimuth_n226;
                azimuth_n229_s12 <= azimuth_n229;
                azimuth_n230_s12 <= azimuth_n230;
                azimuth_n235_s12 <= azimuth_n235;
                polar_angle_n298_s12 <= polar_angle_n298_s11;
                polar_angle_n301_s12 <= polar_angle_n301_s11;
                polar_angle_n306_s12 <= polar_angle_n306_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- azimuth
    azimuth_n231_cut <= azimuth_n226_s12(40 downto 13);
    azimuth_n231_over <= "1" when azimuth_n231_cut(27) = '0' and (or azimuth_n231_cut(26 downto 26)) = '1' else "0";
    azimuth_n231_under <= "1" when azimuth_n231_cut(27) = '1' and (and azimuth_n231_cut(26 downto 26)) = '0' else "0";
    azimuth_n231 <= 27x"3ffffff" when azimuth_n231_over(0) = '1' else 27x"4000000" when azimuth_n231_under(0) = '1' else azimuth_n231_cut(26 downto 0);
    azimuth_n232 <= unsigned(azimuth_n231(26 downto 26));
    azimuth_n233 <= azimuth_n232 xor azimuth_n76;
    azimuth_n234 <= azimuth_n231;
    azimuth_n236_term <= unsigned(resize(azimuth_n234, 42)) xor (41 downto 0 => azimuth_n232(0));
    azimuth_n236 <= shift_left(resize(azimuth_n230_s12, 42), 14) + signed(azimuth_n236_term) + azimuth_n232(0);
    azimuth_n237_term <= unsigned(resize(azimuth_n235_s12, 42)) xor (41 downto 0 => azimuth_n233(0));
    azimuth_n237 <= shift_left(resize(azimuth_n231, 42), 14) + signed(azimuth_n237_term) + azimuth_n233(0);
    azimuth_n239_term <= unsigned(resize(azimuth_n238, 25)) xor (24 downto 0 => azimuth_n232(0));
    azimuth_n239 <= resize(azimuth_n229_s12, 25) + signed(azimuth_n239_term) + azimuth_n232(0);
    azimuth_n240_over <= "1" when azimuth_n239(24) = '0' and (or azimuth_n239(23 downto 23)) = '1' else "0";
    azimuth_n240_under <= "1" when azimuth_n239(24) = '1' and (and azimuth_n239(23 downto 23)) = '0' else "0";
    azimuth_n240 <= 24x"7fffff" when azimuth_n240_over(0) = '1' else 24x"800000" when azimuth_n240_under(0) = '1' else azimuth_n239(23 downto 0);
    azimuth_n241_cut <= azimuth_n236(41 downto 14);
    azimuth_n241_over <= "1" when azimuth_n241_cut(27) = '0' and (or azimuth_n241_cut(26 downto 26)) = '1' else "0";
    azimuth_n241_under <= "1" when azimuth_n241_cut(27) = '1' and (and azimuth_n241_cut(26 downto 26)) = '0' else "0";
    azimuth_n241 <= 27x"3ffffff" when azimuth_n241_over(0) = '1' else 27x"4000000" when azimuth_n241_under(0) = '1' else azimuth_n241_cut(26 downto 0);
    azimuth_n242_cut <= azimuth_n237(41 downto 14);
    azimuth_n242_over <= "1" when azimuth_n242_cut(27) = '0' and (or azimuth_n242_cut(26 downto 26)) = '1' else "0";
    azimuth_n242_under <= "1" when azimuth_n242_cut(27) = '1' and (and azimuth_n242_cut(26 downto 26)) = '0' else "0";
    azimuth_n242 <= 27x"3ffffff" when azimuth_n242_over(0) = '1' else 27x"4000000" when azimuth_n242_under(0) = '1' else azimuth_n242_cut(26 downto 0);
    azimuth_n243 <= unsigned(azimuth_n242(26 downto 26));
    azimuth_n244 <= azimuth_n243 xor azimuth_n76;
    azimuth_n245 <= azimuth_n242;
    azimuth_n246 <= azimuth_n241;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s13 <= azimuth_n69_s12;
                azimuth_n240_s13 <= azimuth_n240;
                azimuth_n241_s13 <= azimuth_n241;
                azimuth_n242_s13 <= azimuth_n242;
                azimuth_n243_s13 <= azimuth_n243;
                azimuth_n244_s13 <= azimuth_n244;
                azimuth_n245_s13 <= azimuth_n245;
                azimuth_n246_s13 <= azimuth_n246;
                polar_angle_n298_s13 <= polar_angle_n298_s12;
                polar_angle_n301_s13 <= polar_angle_n301_s12;
                polar_angle_n306_s13 <= polar_angle_n306_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- azimuth
    azimuth_n247_term <= unsigned(resize(azimuth_n245_s13, 43)) xor (42 downto 0 => azimuth_n243_s13(0));
    azimuth_n247 <= shift_left(resize(azimuth_n241_s13, 43), 15) + signed(azimuth_n247_term) + azimuth_n243_s13(0);
    azimuth_n248_term <= unsigned(resize(azimuth_n246_s13, 43)) xor (42 downto 0 => azimuth_n244_s13(0));
    azimuth_n248 <= shift_left(resize(azimuth_n242_s13, 43), 15) + signed(azimuth_n248_term) + azimuth_n244_s13(0);
    azimuth_n250_term <= unsigned(resize(azimuth_n249, 25)) xor (24 downto 0 => azimuth_n243_s13(0));
    azimuth_n250 <= resize(azimuth_n240_s13, 25) + signed(azimuth_n250_term) + azimuth_n243_s13(0);
    azimuth_n251_over <= "1" when azimuth_n250(24) = '0' and (or azimuth_n250(23 downto 23)) = '1' else "0";
    azimuth_n251_under <= "1" when azimuth_n250(24) = '1' and (and azimuth_n250(23 downto 23)) = '0' else "0";
    azimuth_n251 <= 24x"7fffff" when azimuth_n251_over(0) = '1' else 24x"800000" when azimuth_n251_under(0) = '1' else azimuth_n250(23 downto 0);
    azimuth_n252_cut <= azimuth_n247(42 downto 15);
    azimuth_n252_over <= "1" when azimuth_n252_cut(27) = '0' and (or azimuth_n252_cut(26 downto 26)) = '1' else "0";
    azimuth_n252_under <= "1" when azimuth_n252_cut(27) = '1' and (and azimuth_n252_cut(26 downto 26)) = '0' else "0";
    azimuth_n252 <= 27x"3ffffff" when azimuth_n252_over(0) = '1' else 27x"4000000" when azimuth_n252_under(0) = '1' else azimuth_n252_cut(26 downto 0);
    azimuth_n253_cut <= azimuth_n248(42 downto 15);
    azimuth_n253_over <= "1" when azimuth_n253_cut(27) = '0' and (or azimuth_n253_cut(26 downto 26)) = '1' else "0";
    azimuth_n253_under <= "1" when azimuth_n253_cut(27) = '1' and (and azimuth_n253_cut(26 downto 26)) = '0' else "0";
    azimuth_n253 <= 27x"3ffffff" when azimuth_n253_over(0) = '1' else 27x"4000000" when azimuth_n253_under(0) = '1' else azimuth_n253_cut(26 downto 0);
    azimuth_n254 <= unsigned(azimuth_n253(26 downto 26));
    azimuth_n255 <= azimuth_n254 xor azimuth_n76;
    azimuth_n256 <= azimuth_n253;
    azimuth_n257 <= azimuth_n252;
    azimuth_n258_term <= unsigned(resize(azimuth_n256, 44)) xor (43 downto 0 => azimuth_n254(0));
    azimuth_n258 <= shift_left(resize(azimuth_n252, 44), 16) + signed(azimuth_n258_term) + azimuth_n254(0);
    azimuth_n259_term <= unsigned(resize(azimuth_n257, 44)) xor (43 downto 0 => azimuth_n255(0));
    azimuth_n259 <= shift_left(resize(azimuth_n253, 44), 16) + signed(azimuth_n259_term) + azimuth_n255(0);
    azimuth_n261_term <= unsigned(resize(azimuth_n260, 25)) xor (24 downto 0 => azimuth_n254(0));
    azimuth_n261 <= resize(azimuth_n251, 25) + signed(azimuth_n261_term) + azimuth_n254(0);
    azimuth_n262_over <= "1" when azimuth_n261(24) = '0' and (or azimuth_n261(23 downto 23)) = '1' else "0";
    azimuth_n262_under <= "1" when azimuth_n261(24) = '1' and (and azimuth_n261(23 downto 23)) = '0' else "0";
    azimuth_n262 <= 24x"7fffff" when azimuth_n262_over(0) = '1' else 24x"800000" when azimuth_n262_under(0) = '1' else azimuth_n261(23 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n69_s14 <= azimuth_n69_s13;
                azimuth_n258_s14 <= azimuth_n258;
                azimuth_n259_s14 <= azimuth_n259;
                azimuth_n262_s14 <= azimuth_n262;
                polar_angle_n298_s14 <= polar_angle_n298_s13;
                polar_angle_n301_s14 <= polar_angle_n301_s13;
                polar_angle_n306_s14 <= polar_angle_n306_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- azimuth
    azimuth_n263_cut <= azimuth_n258_s14(43 downto 16);
    azimuth_n263_over <= "1" when azimuth_n263_cut(27) = '0' and (or azimuth_n263_cut(26 downto 26)) = '1' else "0";
    azimuth_n263_under <= "1" when azimuth_n263_cut(27) = '1' and (and azimuth_n263_cut(26 downto 26)) = '0' else "0";
    azimuth_n263 <= 27x"3ffffff" when azimuth_n263_over(0) = '1' else 27x"4000000" when azimuth_n263_under(0) = '1' else azimuth_n263_cut(26 downto 0);
    azimuth_n264_cut <= azimuth_n259_s14(43 downto 16);
    azimuth_n264_over <= "1" when azimuth_n264_cut(27) = '0' and (or azimuth_n264_cut(26 downto 26)) = '1' else "0";
    azimuth_n264_under <= "1" when azimuth_n264_cut(27) = '1' and (and azimuth_n264_cut(26 downto 26)) = '0' else "0";
    azimuth_n264 <= 27x"3ffffff" when azimuth_n264_over(0) = '1' else 27x"4000000" when azimuth_n264_under(0) = '1' else azimuth_n264_cut(26 downto 0);
    azimuth_n265 <= unsigned(azimuth_n264(26 downto 26));
    azimuth_n266 <= azimuth_n264;
    azimuth_n267_term <= unsigned(resize(azimuth_n266, 45)) xor (44 downto 0 => azimuth_n265(0));
    azimuth_n267 <= shift_left(resize(azimuth_n263, 45), 17) + signed(azimuth_n267_term) + azimuth_n265(0);
    azimuth_n269_term <= unsigned(resize(azimuth_n268, 25)) xor (24 downto 0 => azimuth_n265(0));
    azimuth_n269 <= resize(azimuth_n262_s14, 25) + signed(azimuth_n269_term) + azimuth_n265(0);
    azimuth_n270_over <= "1" when azimuth_n269(24) = '0' and (or azimuth_n269(23 downto 23)) = '1' else "0";
    azimuth_n270_under <= "1" when azimuth_n269(24) = '1' and (and azimuth_n269(23 downto 23)) = '0' else "0";
    azimuth_n270 <= 24x"7fffff" when azimuth_n270_over(0) = '1' else 24x"800000" when azimuth_n270_under(0) = '1' else azimuth_n269(23 downto 0);
    azimuth_n271_cut <= azimuth_n267(44 downto 17);
    azimuth_n271_over <= "1" when azimuth_n271_cut(27) = '0' and (or azimuth_n271_cut(26 downto 26)) = '1' else "0";
    azimuth_n271_under <= "1" when azimuth_n271_cut(27) = '1' and (and azimuth_n271_cut(26 downto 26)) = '0' else "0";
    azimuth_n271 <= 27x"3ffffff" when azimuth_n271_over(0) = '1' else 27x"4000000" when azimuth_n271_under(0) = '1' else azimuth_n271_cut(26 downto 0);
    azimuth_n272 <= unsigned(azimuth_n270);
    azimuth_n274 <= azimuth_n272 xor azimuth_n273;
    azimuth_n275 <= azimuth_n274 when azimuth_n69_s14(0) = '1' else azimuth_n272;
    -- polar_angle
    polar_angle_n299 <= "1" when unsigned(azimuth_n271) = shift_left(resize(azimuth_n65, 27), 24) else "0";
    polar_angle_n303 <= -resize(azimuth_n271, 28);
    -- (unit)
    n480_sum <= resize(azimuth_n275, 25) + 25x"0000080";
    n480_cut <= n480_sum(24 downto 8);
    n480 <= n480_cut;
    phi_next <= n480(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n271_s15 <= azimuth_n271;
                polar_angle_n298_s15 <= polar_angle_n298_s14;
                polar_angle_n299_s15 <= polar_angle_n299;
                polar_angle_n301_s15 <= polar_angle_n301_s14;
                polar_angle_n303_s15 <= polar_angle_n303;
                polar_angle_n306_s15 <= polar_angle_n306_s14;
                phi_next_s15 <= phi_next;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- polar_angle
    polar_angle_n300 <= polar_angle_n298_s15 and polar_angle_n299_s15;
    polar_angle_n305 <= polar_angle_n303_s15 when polar_angle_n301_s15(0) = '1' else resize(azimuth_n271_s15, 28);
    polar_angle_n307_over <= "1" when polar_angle_n305(27) = '0' and (or polar_angle_n305(26 downto 26)) = '1' else "0";
    polar_angle_n307_under <= "1" when polar_angle_n305(27) = '1' and (and polar_angle_n305(26 downto 26)) = '0' else "0";
    polar_angle_n307 <= 27x"3ffffff" when polar_angle_n307_over(0) = '1' else 27x"4000000" when polar_angle_n307_under(0) = '1' else polar_angle_n305(26 downto 0);
    polar_angle_n308 <= azimuth_n77 when polar_angle_n300(0) = '1' else azimuth_n78;
    polar_angle_n309 <= unsigned(polar_angle_n307(26 downto 26));
    polar_angle_n310 <= polar_angle_n309 xor azimuth_n76;
    polar_angle_n311_term <= unsigned(resize(polar_angle_n307, 28)) xor (27 downto 0 => polar_angle_n309(0));
    polar_angle_n311 <= resize(polar_angle_n306_s15, 28) + signed(polar_angle_n311_term) + polar_angle_n309(0);
    polar_angle_n312_term <= unsigned(resize(polar_angle_n306_s15, 28)) xor (27 downto 0 => polar_angle_n310(0));
    polar_angle_n312 <= resize(polar_angle_n307, 28) + signed(polar_angle_n312_term) + polar_angle_n310(0);
    polar_angle_n313_term <= unsigned(resize(azimuth_n84, 25)) xor (24 downto 0 => polar_angle_n309(0));
    polar_angle_n313 <= resize(polar_angle_n308, 25) + signed(polar_angle_n313_term) + polar_angle_n309(0);
    polar_angle_n314_over <= "1" when polar_angle_n313(24) = '0' and (or polar_angle_n313(23 downto 23)) = '1' else "0";
    polar_angle_n314_under <= "1" when polar_angle_n313(24) = '1' and (and polar_angle_n313(23 downto 23)) = '0' else "0";
    polar_angle_n314 <= 24x"7fffff" when polar_angle_n314_over(0) = '1' else 24x"800000" when polar_angle_n314_under(0) = '1' else polar_angle_n313(23 downto 0);
    polar_angle_n315_over <= "1" when polar_angle_n311(27) = '0' and (or polar_angle_n311(26 downto 26)) = '1' else "0";
    polar_angle_n315_under <= "1" when polar_angle_n311(27) = '1' and (and polar_angle_n311(26 downto 26)) = '0' else "0";
    polar_angle_n315 <= 27x"3ffffff" when polar_angle_n315_over(0) = '1' else 27x"4000000" when polar_angle_n315_under(0) = '1' else polar_angle_n311(26 downto 0);
    polar_angle_n316_over <= "1" when polar_angle_n312(27) = '0' and (or polar_angle_n312(26 downto 26)) = '1' else "0";
    polar_angle_n316_under <= "1" when polar_angle_n312(27) = '1' and (and polar_angle_n312(26 downto 26)) = '0' else "0";
    polar_angle_n316 <= 27x"3ffffff" when polar_angle_n316_over(0) = '1' else 27x"4000000" when polar_angle_n316_under(0) = '1' else polar_angle_n312(26 downto 0);
    polar_angle_n317 <= unsigned(polar_angle_n316(26 downto 26));
    polar_angle_n318 <= polar_angle_n317 xor azimuth_n76;
    polar_angle_n319 <= polar_angle_n316;
    polar_angle_n320 <= polar_angle_n315;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s16 <= polar_angle_n301_s15;
                polar_angle_n314_s16 <= polar_angle_n314;
                polar_angle_n315_s16 <= polar_angle_n315;
                polar_angle_n316_s16 <= polar_angle_n316;
                polar_angle_n317_s16 <= polar_angle_n317;
                polar_angle_n318_s16 <= polar_angle_n318;
                polar_angle_n319_s16 <= polar_angle_n319;
                polar_angle_n320_s16 <= polar_angle_n320;
                phi_next_s16 <= phi_next_s15;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- polar_angle
    polar_angle_n321_term <= unsigned(resize(polar_angle_n319_s16, 29)) xor (28 downto 0 => polar_angle_n317_s16(0));
    polar_angle_n321 <= shift_left(resize(polar_angle_n315_s16, 29), 1) + signed(polar_angle_n321_term) + polar_angle_n317_s16(0);
    polar_angle_n322_term <= unsigned(resize(polar_angle_n320_s16, 29)) xor (28 downto 0 => polar_angle_n318_s16(0));
    polar_angle_n322 <= shift_left(resize(polar_angle_n316_s16, 29), 1) + signed(polar_angle_n322_term) + polar_angle_n318_s16(0);
    polar_angle_n323_term <= unsigned(resize(azimuth_n95, 25)) xor (24 downto 0 => polar_angle_n317_s16(0));
    polar_angle_n323 <= resize(polar_angle_n314_s16, 25) + signed(polar_angle_n323_term) + polar_angle_n317_s16(0);
    polar_angle_n324_over <= "1" when polar_angle_n323(24) = '0' and (or polar_angle_n323(23 downto 23)) = '1' else "0";
    polar_angle_n324_under <= "1" when polar_angle_n323(24) = '1' and (and polar_angle_n323(23 downto 23)) = '0' else "0";
    polar_angle_n324 <= 24x"7fffff" when polar_angle_n324_over(0) = '1' else 24x"800000" when polar_angle_n324_under(0) = '1' else polar_angle_n323(23 downto 0);
    polar_angle_n325_cut <= polar_angle_n321(28 downto 1);
    polar_angle_n325_over <= "1" when polar_angle_n325_cut(27) = '0' and (or polar_angle_n325_cut(26 downto 26)) = '1' else "0";
    polar_angle_n325_under <= "1" when polar_angle_n325_cut(27) = '1' and (and polar_angle_n325_cut(26 downto 26)) = '0' else "0";
    polar_angle_n325 <= 27x"3ffffff" when polar_angle_n325_over(0) = '1' else 27x"4000000" when polar_angle_n325_under(0) = '1' else polar_angle_n325_cut(26 downto 0);
    polar_angle_n326_cut <= polar_angle_n322(28 downto 1);
    polar_angle_n326_over <= "1" when polar_angle_n326_cut(27) = '0' and (or polar_angle_n326_cut(26 downto 26)) = '1' else "0";
    polar_angle_n326_under <= "1" when polar_angle_n326_cut(27) = '1' and (and polar_angle_n326_cut(26 downto 26)) = '0' else "0";
    polar_angle_n326 <= 27x"3ffffff" when polar_angle_n326_over(0) = '1' else 27x"4000000" when polar_angle_n326_under(0) = '1' else polar_angle_n326_cut(26 downto 0);
    polar_angle_n327 <= unsigned(polar_angle_n326(26 downto 26));
    polar_angle_n328 <= polar_angle_n327 xor azimuth_n76;
    polar_angle_n329 <= polar_angle_n326;
    polar_angle_n330 <= polar_angle_n325;
    polar_angle_n331_term <= unsigned(resize(polar_angle_n329, 30)) xor (29 downto 0 => polar_angle_n327(0));
    polar_angle_n331 <= shift_left(resize(polar_angle_n325, 30), 2) + signed(polar_angle_n331_term) + polar_angle_n327(0);
    polar_angle_n332_term <= unsigned(resize(polar_angle_n330, 30)) xor (29 downto 0 => polar_angle_n328(0));
    polar_angle_n332 <= shift_left(resize(polar_angle_n326, 30), 2) + signed(polar_angle_n332_term) + polar_angle_n328(0);
    polar_angle_n333_term <= unsigned(resize(azimuth_n106, 25)) xor (24 downto 0 => polar_angle_n327(0));
    polar_angle_n333 <= resize(polar_angle_n324, 25) + signed(polar_angle_n333_term) + polar_angle_n327(0);
    polar_angle_n334_over <= "1" when polar_angle_n333(24) = '0' and (or polar_angle_n333(23 downto 23)) = '1' else "0";
    polar_angle_n334_under <= "1" when polar_angle_n333(24) = '1' and (and polar_angle_n333(23 downto 23)) = '0' else "0";
    polar_angle_n334 <= 24x"7fffff" when polar_angle_n334_over(0) = '1' else 24x"800000" when polar_angle_n334_under(0) = '1' else polar_angle_n333(23 downto 0);
    polar_angle_n335_cut <= polar_angle_n331(29 downto 2);
    polar_angle_n335_over <= "1" when polar_angle_n335_cut(27) = '0' and (or polar_angle_n335_cut(26 downto 26)) = '1' else "0";
    polar_angle_n335_under <= "1" when polar_angle_n335_cut(27) = '1' and (and polar_angle_n335_cut(26 downto 26)) = '0' else "0";
    polar_angle_n335 <= 27x"3ffffff" when polar_angle_n335_over(0) = '1' else 27x"4000000" when polar_angle_n335_under(0) = '1' else polar_angle_n335_cut(26 downto 0);
    polar_angle_n336_cut <= polar_angle_n332(29 downto 2);
    polar_angle_n336_over <= "1" when polar_angle_n336_cut(27) = '0' and (or polar_angle_n336_cut(26 downto 26)) = '1' else "0";
    polar_angle_n336_under <= "1" when polar_angle_n336_cut(27) = '1' and (and polar_angle_n336_cut(26 downto 26)) = '0' else "0";
    polar_angle_n336 <= 27x"3ffffff" when polar_angle_n336_over(0) = '1' else 27x"4000000" when polar_angle_n336_under(0) = '1' else polar_angle_n336_cut(26 downto 0);
    polar_angle_n337 <= unsigned(polar_angle_n336(26 downto 26));
    polar_angle_n339 <= polar_angle_n336;
    polar_angle_n340 <= polar_angle_n335;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s17 <= polar_angle_n301_s16;
                polar_angle_n334_s17 <= polar_angle_n334;
                polar_angle_n335_s17 <= polar_angle_n335;
                polar_angle_n336_s17 <= polar_angle_n336;
                polar_angle_n337_s17 <= polar_angle_n337;
                polar_angle_n339_s17 <= polar_angle_n339;
                polar_angle_n340_s17 <= polar_angle_n340;
                phi_next_s17 <= phi_next_s16;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- polar_angle
    polar_angle_n338 <= polar_angle_n337_s17 xor azimuth_n76;
    polar_angle_n341_term <= unsigned(resize(polar_angle_n339_s17, 31)) xor (30 downto 0 => polar_angle_n337_s17(0));
    polar_angle_n341 <= shift_left(resize(polar_angle_n335_s17, 31), 3) + signed(polar_angle_n341_term) + polar_angle_n337_s17(0);
    polar_angle_n342_term <= unsigned(resize(polar_angle_n340_s17, 31)) xor (30 downto 0 => polar_angle_n338(0));
    polar_angle_n342 <= shift_left(resize(polar_angle_n336_s17, 31), 3) + signed(polar_angle_n342_term) + polar_angle_n338(0);
    polar_angle_n343_term <= unsigned(resize(azimuth_n117, 25)) xor (24 downto 0 => polar_angle_n337_s17(0));
    polar_angle_n343 <= resize(polar_angle_n334_s17, 25) + signed(polar_angle_n343_term) + polar_angle_n337_s17(0);
    polar_angle_n344_over <= "1" when polar_angle_n343(24) = '0' and (or polar_angle_n343(23 downto 23)) = '1' else "0";
    polar_angle_n344_under <= "1" when polar_angle_n343(24) = '1' and (and polar_angle_n343(23 downto 23)) = '0' else "0";
    polar_angle_n344 <= 24x"7fffff" when polar_angle_n344_over(0) = '1' else 24x"800000" when polar_angle_n344_under(0) = '1' else polar_angle_n343(23 downto 0);
    polar_angle_n345_cut <= polar_angle_n341(30 downto 3);
    polar_angle_n345_over <= "1" when polar_angle_n345_cut(27) = '0' and (or polar_angle_n345_cut(26 downto 26)) = '1' else "0";
    polar_angle_n345_under <= "1" when polar_angle_n345_cut(27) = '1' and (and polar_angle_n345_cut(26 downto 26)) = '0' else "0";
    polar_angle_n345 <= 27x"3ffffff" when polar_angle_n345_over(0) = '1' else 27x"4000000" when polar_angle_n345_under(0) = '1' else polar_angle_n345_cut(26 downto 0);
    polar_angle_n346_cut <= polar_angle_n342(30 downto 3);
    polar_angle_n346_over <= "1" when polar_angle_n346_cut(27) = '0' and (or polar_angle_n346_cut(26 downto 26)) = '1' else "0";
    polar_angle_n346_under <= "1" when polar_angle_n346_cut(27) = '1' and (and polar_angle_n346_cut(26 downto 26)) = '0' else "0";
    polar_angle_n346 <= 27x"3ffffff" when polar_angle_n346_over(0) = '1' else 27x"4000000" when polar_angle_n346_under(0) = '1' else polar_angle_n346_cut(26 downto 0);
    polar_angle_n347 <= unsigned(polar_angle_n346(26 downto 26));
    polar_angle_n348 <= polar_angle_n347 xor azimuth_n76;
    polar_angle_n349 <= polar_angle_n346;
    polar_angle_n350 <= polar_angle_n345;
    polar_angle_n351_term <= unsigned(resize(polar_angle_n349, 32)) xor (31 downto 0 => polar_angle_n347(0));
    polar_angle_n351 <= shift_left(resize(polar_angle_n345, 32), 4) + signed(polar_angle_n351_term) + polar_angle_n347(0);
    polar_angle_n352_term <= unsigned(resize(polar_angle_n350, 32)) xor (31 downto 0 => polar_angle_n348(0));
    polar_angle_n352 <= shift_left(resize(polar_angle_n346, 32), 4) + signed(polar_angle_n352_term) + polar_angle_n348(0);
    polar_angle_n353_term <= unsigned(resize(azimuth_n128, 25)) xor (24 downto 0 => polar_angle_n347(0));
    polar_angle_n353 <= resize(polar_angle_n344, 25) + signed(polar_angle_n353_term) + polar_angle_n347(0);
    polar_angle_n354_over <= "1" when polar_angle_n353(24) = '0' and (or polar_angle_n353(23 downto 23)) = '1' else "0";
    polar_angle_n354_under <= "1" when polar_angle_n353(24) = '1' and (and polar_angle_n353(23 downto 23)) = '0' else "0";
    polar_angle_n354 <= 24x"7fffff" when polar_angle_n354_over(0) = '1' else 24x"800000" when polar_angle_n354_under(0) = '1' else polar_angle_n353(23 downto 0);
    polar_angle_n355_cut <= polar_angle_n351(31 downto 4);
    polar_angle_n355_over <= "1" when polar_angle_n355_cut(27) = '0' and (or polar_angle_n355_cut(26 downto 26)) = '1' else "0";
    polar_angle_n355_under <= "1" when polar_angle_n355_cut(27) = '1' and (and polar_angle_n355_cut(26 downto 26)) = '0' else "0";
    polar_angle_n355 <= 27x"3ffffff" when polar_angle_n355_over(0) = '1' else 27x"4000000" when polar_angle_n355_under(0) = '1' else polar_angle_n355_cut(26 downto 0);
    polar_angle_n360 <= polar_angle_n355;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s18 <= polar_angle_n301_s17;
                polar_angle_n352_s18 <= polar_angle_n352;
                polar_angle_n354_s18 <= polar_angle_n354;
                polar_angle_n355_s18 <= polar_angle_n355;
                polar_angle_n360_s18 <= polar_angle_n360;
                phi_next_s18 <= phi_next_s17;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- polar_angle
    polar_angle_n356_cut <= polar_angle_n352_s18(31 downto 4);
    polar_angle_n356_over <= "1" when polar_angle_n356_cut(27) = '0' and (or polar_angle_n356_cut(26 downto 26)) = '1' else "0";
    polar_angle_n356_under <= "1" when polar_angle_n356_cut(27) = '1' and (and polar_angle_n356_cut(26 downto 26)) = '0' else "0";
    polar_angle_n356 <= 27x"3ffffff" when polar_angle_n356_over(0) = '1' else 27x"4000000" when polar_angle_n356_under(0) = '1' else polar_angle_n356_cut(26 downto 0);
    polar_angle_n357 <= unsigned(polar_angle_n356(26 downto 26));
    polar_angle_n358 <= polar_angle_n357 xor azimuth_n76;
    polar_angle_n359 <= polar_angle_n356;
    polar_angle_n361_term <= unsigned(resize(polar_angle_n359, 33)) xor (32 downto 0 => polar_angle_n357(0));
    polar_angle_n361 <= shift_left(resize(polar_angle_n355_s18, 33), 5) + signed(polar_angle_n361_term) + polar_angle_n357(0);
    polar_angle_n362_term <= unsigned(resize(polar_angle_n360_s18, 33)) xor (32 downto 0 => polar_angle_n358(0));
    polar_angle_n362 <= shift_left(resize(polar_angle_n356, 33), 5) + signed(polar_angle_n362_term) + polar_angle_n358(0);
    polar_angle_n363_term <= unsigned(resize(azimuth_n139, 25)) xor (24 downto 0 => polar_angle_n357(0));
    polar_angle_n363 <= resize(polar_angle_n354_s18, 25) + signed(polar_angle_n363_term) + polar_angle_n357(0);
    polar_angle_n364_over <= "1" when polar_angle_n363(24) = '0' and (or polar_angle_n363(23 downto 23)) = '1' else "0";
    polar_angle_n364_under <= "1" when polar_angle_n363(24) = '1' and (and polar_angle_n363(23 downto 23)) = '0' else "0";
    polar_angle_n364 <= 24x"7fffff" when polar_angle_n364_over(0) = '1' else 24x"800000" when polar_angle_n364_under(0) = '1' else polar_angle_n363(23 downto 0);
    polar_angle_n365_cut <= polar_angle_n361(32 downto 5);
    polar_angle_n365_over <= "1" when polar_angle_n365_cut(27) = '0' and (or polar_angle_n365_cut(26 downto 26)) = '1' else "0";
    polar_angle_n365_under <= "1" when polar_angle_n365_cut(27) = '1' and (and polar_angle_n365_cut(26 downto 26)) = '0' else "0";
    polar_angle_n365 <= 27x"3ffffff" when polar_angle_n365_over(0) = '1' else 27x"4000000" when polar_angle_n365_under(0) = '1' else polar_angle_n365_cut(26 downto 0);
    polar_angle_n366_cut <= polar_angle_n362(32 downto 5);
    polar_angle_n366_over <= "1" when polar_angle_n366_cut(27) = '0' and (or polar_angle_n366_cut(26 downto 26)) = '1' else "0";
    polar_angle_n366_under <= "1" when polar_angle_n366_cut(27) = '1' and (and polar_angle_n366_cut(26 downto 26)) = '0' else "0";
    polar_angle_n366 <= 27x"3ffffff" when polar_angle_n366_over(0) = '1' else 27x"4000000" when polar_angle_n366_under(0) = '1' else polar_angle_n366_cut(26 downto 0);
    polar_angle_n367 <= unsigned(polar_angle_n366(26 downto 26));
    polar_angle_n368 <= polar_angle_n367 xor azimuth_n76;
    polar_angle_n369 <= polar_angle_n366;
    polar_angle_n370 <= polar_angle_n365;
    polar_angle_n373_term <= unsigned(resize(azimuth_n150, 25)) xor (24 downto 0 => polar_angle_n367(0));
    polar_angle_n373 <= resize(polar_angle_n364, 25) + signed(polar_angle_n373_term) + polar_angle_n367(0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s19 <= polar_angle_n301_s18;
                polar_angle_n365_s19 <= polar_angle_n365;
                polar_angle_n366_s19 <= polar_angle_n366;
                polar_angle_n367_s19 <= polar_angle_n367;
                polar_angle_n368_s19 <= polar_angle_n368;
                polar_angle_n369_s19 <= polar_angle_n369;
                polar_angle_n370_s19 <= polar_angle_n370;
                polar_angle_n373_s19 <= polar_angle_n373;
                phi_next_s19 <= phi_next_s18;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- polar_angle
    polar_angle_n371_term <= unsigned(resize(polar_angle_n369_s19, 34)) xor (33 downto 0 => polar_angle_n367_s19(0));
    polar_angle_n371 <= shift_left(resize(polar_angle_n365_s19, 34), 6) + signed(polar_angle_n371_term) + polar_angle_n367_s19(0);
    polar_angle_n372_term <= unsigned(resize(polar_angle_n370_s19, 34)) xor (33 downto 0 => polar_angle_n368_s19(0));
    polar_angle_n372 <= shift_left(resize(polar_angle_n366_s19, 34), 6) + signed(polar_angle_n372_term) + polar_angle_n368_s19(0);
    polar_angle_n374_over <= "1" when polar_angle_n373_s19(24) = '0' and (or polar_angle_n373_s19(23 downto 23)) = '1' else "0";
    polar_angle_n374_under <= "1" when polar_angle_n373_s19(24) = '1' and (and polar_angle_n373_s19(23 downto 23)) = '0' else "0";
    polar_angle_n374 <= 24x"7fffff" when polar_angle_n374_over(0) = '1' else 24x"800000" when polar_angle_n374_under(0) = '1' else polar_angle_n373_s19(23 downto 0);
    polar_angle_n375_cut <= polar_angle_n371(33 downto 6);
    polar_angle_n375_over <= "1" when polar_angle_n375_cut(27) = '0' and (or polar_angle_n375_cut(26 downto 26)) = '1' else "0";
    polar_angle_n375_under <= "1" when polar_angle_n375_cut(27) = '1' and (and polar_angle_n375_cut(26 downto 26)) = '0' else "0";
    polar_angle_n375 <= 27x"3ffffff" when polar_angle_n375_over(0) = '1' else 27x"4000000" when polar_angle_n375_under(0) = '1' else polar_angle_n375_cut(26 downto 0);
    polar_angle_n376_cut <= polar_angle_n372(33 downto 6);
    polar_angle_n376_over <= "1" when polar_angle_n376_cut(27) = '0' and (or polar_angle_n376_cut(26 downto 26)) = '1' else "0";
    polar_angle_n376_under <= "1" when polar_angle_n376_cut(27) = '1' and (and polar_angle_n376_cut(26 downto 26)) = '0' else "0";
    polar_angle_n376 <= 27x"3ffffff" when polar_angle_n376_over(0) = '1' else 27x"4000000" when polar_angle_n376_under(0) = '1' else polar_angle_n376_cut(26 downto 0);
    polar_angle_n377 <= unsigned(polar_angle_n376(26 downto 26));
    polar_angle_n378 <= polar_angle_n377 xor azimuth_n76;
    polar_angle_n379 <= polar_angle_n376;
    polar_angle_n380 <= polar_angle_n375;
    polar_angle_n381_term <= unsigned(resize(polar_angle_n379, 35)) xor (34 downto 0 => polar_angle_n377(0));
    polar_angle_n381 <= shift_left(resize(polar_angle_n375, 35), 7) + signed(polar_angle_n381_term) + polar_angle_n377(0);
    polar_angle_n382_term <= unsigned(resize(polar_angle_n380, 35)) xor (34 downto 0 => polar_angle_n378(0));
    polar_angle_n382 <= shift_left(resize(polar_angle_n376, 35), 7) + signed(polar_angle_n382_term) + polar_angle_n378(0);
    polar_angle_n383_term <= unsigned(resize(azimuth_n161, 25)) xor (24 downto 0 => polar_angle_n377(0));
    polar_angle_n383 <= resize(polar_angle_n374, 25) + signed(polar_angle_n383_term) + polar_angle_n377(0);
    polar_angle_n384_over <= "1" when polar_angle_n383(24) = '0' and (or polar_angle_n383(23 downto 23)) = '1' else "0";
    polar_angle_n384_under <= "1" when polar_angle_n383(24) = '1' and (and polar_angle_n383(23 downto 23)) = '0' else "0";
    polar_angle_n384 <= 24x"7fffff" when polar_angle_n384_over(0) = '1' else 24x"800000" when polar_angle_n384_under(0) = '1' else polar_angle_n383(23 downto 0);
    polar_angle_n385_cut <= polar_angle_n381(34 downto 7);
    polar_angle_n385_over <= "1" when polar_angle_n385_cut(27) = '0' and (or polar_angle_n385_cut(26 downto 26)) = '1' else "0";
    polar_angle_n385_under <= "1" when polar_angle_n385_cut(27) = '1' and (and polar_angle_n385_cut(26 downto 26)) = '0' else "0";
    polar_angle_n385 <= 27x"3ffffff" when polar_angle_n385_over(0) = '1' else 27x"4000000" when polar_angle_n385_under(0) = '1' else polar_angle_n385_cut(26 downto 0);
    polar_angle_n390 <= polar_angle_n385;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s20 <= polar_angle_n301_s19;
                polar_angle_n382_s20 <= polar_angle_n382;
                polar_angle_n384_s20 <= polar_angle_n384;
                polar_angle_n385_s20 <= polar_angle_n385;
                polar_angle_n390_s20 <= polar_angle_n390;
                phi_next_s20 <= phi_next_s19;
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    -- polar_angle
    polar_angle_n386_cut <= polar_angle_n382_s20(34 downto 7);
    polar_angle_n386_over <= "1" when polar_angle_n386_cut(27) = '0' and (or polar_angle_n386_cut(26 downto 26)) = '1' else "0";
    polar_angle_n386_under <= "1" when polar_angle_n386_cut(27) = '1' and (and polar_angle_n386_cut(26 downto 26)) = '0' else "0";
    polar_angle_n386 <= 27x"3ffffff" when polar_angle_n386_over(0) = '1' else 27x"4000000" when polar_angle_n386_under(0) = '1' else polar_angle_n386_cut(26 downto 0);
    polar_angle_n387 <= unsigned(polar_angle_n386(26 downto 26));
    polar_angle_n388 <= polar_angle_n387 xor azimuth_n76;
    polar_angle_n389 <= polar_angle_n386;
    polar_angle_n391_term <= unsigned(resize(polar_angle_n389, 36)) xor (35 downto 0 => polar_angle_n387(0));
    polar_angle_n391 <= shift_left(resize(polar_angle_n385_s20, 36), 8) + signed(polar_angle_n391_term) + polar_angle_n387(0);
    polar_angle_n392_term <= unsigned(resize(polar_angle_n390_s20, 36)) xor (35 downto 0 => polar_angle_n388(0));
    polar_angle_n392 <= shift_left(resize(polar_angle_n386, 36), 8) + signed(polar_angle_n392_term) + polar_angle_n388(0);
    polar_angle_n393_term <= unsigned(resize(azimuth_n172, 25)) xor (24 downto 0 => polar_angle_n387(0));
    polar_angle_n393 <= resize(polar_angle_n384_s20, 25) + signed(polar_angle_n393_term) + polar_angle_n387(0);
    polar_angle_n394_over <= "1" when polar_angle_n393(24) = '0' and (or polar_angle_n393(23 downto 23)) = '1' else "0";
    polar_angle_n394_under <= "1" when polar_angle_n393(24) = '1' and (and polar_angle_n393(23 downto 23)) = '0' else "0";
    polar_angle_n394 <= 24x"7fffff" when polar_angle_n394_over(0) = '1' else 24x"800000" when polar_angle_n394_under(0) = '1' else polar_angle_n393(23 downto 0);
    polar_angle_n395_cut <= polar_angle_n391(35 downto 8);
    polar_angle_n395_over <= "1" when polar_angle_n395_cut(27) = '0' and (or polar_angle_n395_cut(26 downto 26)) = '1' else "0";
    polar_angle_n395_under <= "1" when polar_angle_n395_cut(27) = '1' and (and polar_angle_n395_cut(26 downto 26)) = '0' else "0";
    polar_angle_n395 <= 27x"3ffffff" when polar_angle_n395_over(0) = '1' else 27x"4000000" when polar_angle_n395_under(0) = '1' else polar_angle_n395_cut(26 downto 0);
    polar_angle_n396_cut <= polar_angle_n392(35 downto 8);
    polar_angle_n396_over <= "1" when polar_angle_n396_cut(27) = '0' and (or polar_angle_n396_cut(26 downto 26)) = '1' else "0";
    polar_angle_n396_under <= "1" when polar_angle_n396_cut(27) = '1' and (and polar_angle_n396_cut(26 downto 26)) = '0' else "0";
    polar_angle_n396 <= 27x"3ffffff" when polar_angle_n396_over(0) = '1' else 27x"4000000" when polar_angle_n396_under(0) = '1' else polar_angle_n396_cut(26 downto 0);
    polar_angle_n397 <= unsigned(polar_angle_n396(26 downto 26));
    polar_angle_n398 <= polar_angle_n397 xor azimuth_n76;
    polar_angle_n399 <= polar_angle_n396;
    polar_angle_n400 <= polar_angle_n395;
    polar_angle_n403_term <= unsigned(resize(azimuth_n183, 25)) xor (24 downto 0 => polar_angle_n397(0));
    polar_angle_n403 <= resize(polar_angle_n394, 25) + signed(polar_angle_n403_term) + polar_angle_n397(0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s21 <= polar_angle_n301_s20;
                polar_angle_n395_s21 <= polar_angle_n395;
                polar_angle_n396_s21 <= polar_angle_n396;
                polar_angle_n397_s21 <= polar_angle_n397;
                polar_angle_n398_s21 <= polar_angle_n398;
                polar_angle_n399_s21 <= polar_angle_n399;
                polar_angle_n400_s21 <= polar_angle_n400;
                polar_angle_n403_s21 <= polar_angle_n403;
                phi_next_s21 <= phi_next_s20;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----
    -- polar_angle
    polar_angle_n401_term <= unsigned(resize(polar_angle_n399_s21, 37)) xor (36 downto 0 => polar_angle_n397_s21(0));
    polar_angle_n401 <= shift_left(resize(polar_angle_n395_s21, 37), 9) + signed(polar_angle_n401_term) + polar_angle_n397_s21(0);
    polar_angle_n402_term <= unsigned(resize(polar_angle_n400_s21, 37)) xor (36 downto 0 => polar_angle_n398_s21(0));
    polar_angle_n402 <= shift_left(resize(polar_angle_n396_s21, 37), 9) + signed(polar_angle_n402_term) + polar_angle_n398_s21(0);
    polar_angle_n404_over <= "1" when polar_angle_n403_s21(24) = '0' and (or polar_angle_n403_s21(23 downto 23)) = '1' else "0";
    polar_angle_n404_under <= "1" when polar_angle_n403_s21(24) = '1' and (and polar_angle_n403_s21(23 downto 23)) = '0' else "0";
    polar_angle_n404 <= 24x"7fffff" when polar_angle_n404_over(0) = '1' else 24x"800000" when polar_angle_n404_under(0) = '1' else polar_angle_n403_s21(23 downto 0);
    polar_angle_n405_cut <= polar_angle_n401(36 downto 9);
    polar_angle_n405_over <= "1" when polar_angle_n405_cut(27) = '0' and (or polar_angle_n405_cut(26 downto 26)) = '1' else "0";
    polar_angle_n405_under <= "1" when polar_angle_n405_cut(27) = '1' and (and polar_angle_n405_cut(26 downto 26)) = '0' else "0";
    polar_angle_n405 <= 27x"3ffffff" when polar_angle_n405_over(0) = '1' else 27x"4000000" when polar_angle_n405_under(0) = '1' else polar_angle_n405_cut(26 downto 0);
    polar_angle_n406_cut <= polar_angle_n402(36 downto 9);
    polar_angle_n406_over <= "1" when polar_angle_n406_cut(27) = '0' and (or polar_angle_n406_cut(26 downto 26)) = '1' else "0";
    polar_angle_n406_under <= "1" when polar_angle_n406_cut(27) = '1' and (and polar_angle_n406_cut(26 downto 26)) = '0' else "0";
    polar_angle_n406 <= 27x"3ffffff" when polar_angle_n406_over(0) = '1' else 27x"4000000" when polar_angle_n406_under(0) = '1' else polar_angle_n406_cut(26 downto 0);
    polar_angle_n407 <= unsigned(polar_angle_n406(26 downto 26));
    polar_angle_n408 <= polar_angle_n407 xor azimuth_n76;
    polar_angle_n409 <= polar_angle_n406;
    polar_angle_n410 <= polar_angle_n405;
    polar_angle_n411_term <= unsigned(resize(polar_angle_n409, 38)) xor (37 downto 0 => polar_angle_n407(0));
    polar_angle_n411 <= shift_left(resize(polar_angle_n405, 38), 10) + signed(polar_angle_n411_term) + polar_angle_n407(0);
    polar_angle_n412_term <= unsigned(resize(polar_angle_n410, 38)) xor (37 downto 0 => polar_angle_n408(0));
    polar_angle_n412 <= shift_left(resize(polar_angle_n406, 38), 10) + signed(polar_angle_n412_term) + polar_angle_n408(0);
    polar_angle_n413_term <= unsigned(resize(azimuth_n194, 25)) xor (24 downto 0 => polar_angle_n407(0));
    polar_angle_n413 <= resize(polar_angle_n404, 25) + signed(polar_angle_n413_term) + polar_angle_n407(0);
    polar_angle_n414_over <= "1" when polar_angle_n413(24) = '0' and (or polar_angle_n413(23 downto 23)) = '1' else "0";
    polar_angle_n414_under <= "1" when polar_angle_n413(24) = '1' and (and polar_angle_n413(23 downto 23)) = '0' else "0";
    polar_angle_n414 <= 24x"7fffff" when polar_angle_n414_over(0) = '1' else 24x"800000" when polar_angle_n414_under(0) = '1' else polar_angle_n413(23 downto 0);
    polar_angle_n415_cut <= polar_angle_n411(37 downto 10);
    polar_angle_n415_over <= "1" when polar_angle_n415_cut(27) = '0' and (or polar_angle_n415_cut(26 downto 26)) = '1' else "0";
    polar_angle_n415_under <= "1" when polar_angle_n415_cut(27) = '1' and (and polar_angle_n415_cut(26 downto 26)) = '0' else "0";
    polar_angle_n415 <= 27x"3ffffff" when polar_angle_n415_over(0) = '1' else 27x"4000000" when polar_angle_n415_under(0) = '1' else polar_angle_n415_cut(26 downto 0);
    polar_angle_n420 <= polar_angle_n415;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s22 <= polar_angle_n301_s21;
                polar_angle_n412_s22 <= polar_angle_n412;
                polar_angle_n414_s22 <= polar_angle_n414;
                polar_angle_n415_s22 <= polar_angle_n415;
                polar_angle_n420_s22 <= polar_angle_n420;
                phi_next_s22 <= phi_next_s21;
            end if;
            if rst = '1' then
                valid_s22 <= '0';
            elsif ce = '1' then
                valid_s22 <= valid_s21;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----
    -- polar_angle
    polar_angle_n416_cut <= polar_angle_n412_s22(37 downto 10);
    polar_angle_n416_over <= "1" when polar_angle_n416_cut(27) = '0' and (or polar_angle_n416_cut(26 downto 26)) = '1' else "0";
    polar_angle_n416_under <= "1" when polar_angle_n416_cut(27) = '1' and (and polar_angle_n416_cut(26 downto 26)) = '0' else "0";
    polar_angle_n416 <= 27x"3ffffff" when polar_angle_n416_over(0) = '1' else 27x"4000000" when polar_angle_n416_under(0) = '1' else polar_angle_n416_cut(26 downto 0);
    polar_angle_n417 <= unsigned(polar_angle_n416(26 downto 26));
    polar_angle_n418 <= polar_angle_n417 xor azimuth_n76;
    polar_angle_n419 <= polar_angle_n416;
    polar_angle_n421_term <= unsigned(resize(polar_angle_n419, 39)) xor (38 downto 0 => polar_angle_n417(0));
    polar_angle_n421 <= shift_left(resize(polar_angle_n415_s22, 39), 11) + signed(polar_angle_n421_term) + polar_angle_n417(0);
    polar_angle_n422_term <= unsigned(resize(polar_angle_n420_s22, 39)) xor (38 downto 0 => polar_angle_n418(0));
    polar_angle_n422 <= shift_left(resize(polar_angle_n416, 39), 11) + signed(polar_angle_n422_term) + polar_angle_n418(0);
    polar_angle_n423_term <= unsigned(resize(azimuth_n205, 25)) xor (24 downto 0 => polar_angle_n417(0));
    polar_angle_n423 <= resize(polar_angle_n414_s22, 25) + signed(polar_angle_n423_term) + polar_angle_n417(0);
    polar_angle_n424_over <= "1" when polar_angle_n423(24) = '0' and (or polar_angle_n423(23 downto 23)) = '1' else "0";
    polar_angle_n424_under <= "1" when polar_angle_n423(24) = '1' and (and polar_angle_n423(23 downto 23)) = '0' else "0";
    polar_angle_n424 <= 24x"7fffff" when polar_angle_n424_over(0) = '1' else 24x"800000" when polar_angle_n424_under(0) = '1' else polar_angle_n423(23 downto 0);
    polar_angle_n425_cut <= polar_angle_n421(38 downto 11);
    polar_angle_n425_over <= "1" when polar_angle_n425_cut(27) = '0' and (or polar_angle_n425_cut(26 downto 26)) = '1' else "0";
    polar_angle_n425_under <= "1" when polar_angle_n425_cut(27) = '1' and (and polar_angle_n425_cut(26 downto 26)) = '0' else "0";
    polar_angle_n425 <= 27x"3ffffff" when polar_angle_n425_over(0) = '1' else 27x"4000000" when polar_angle_n425_under(0) = '1' else polar_angle_n425_cut(26 downto 0);
    polar_angle_n426_cut <= polar_angle_n422(38 downto 11);
    polar_angle_n426_over <= "1" when polar_angle_n426_cut(27) = '0' and (or polar_angle_n426_cut(26 downto 26)) = '1' else "0";
    polar_angle_n426_under <= "1" when polar_angle_n426_cut(27) = '1' and (and polar_angle_n426_cut(26 downto 26)) = '0' else "0";
    polar_angle_n426 <= 27x"3ffffff" when polar_angle_n426_over(0) = '1' else 27x"4000000" when polar_angle_n426_under(0) = '1' else polar_angle_n426_cut(26 downto 0);
    polar_angle_n427 <= unsigned(polar_angle_n426(26 downto 26));
    polar_angle_n428 <= polar_angle_n427 xor azimuth_n76;
    polar_angle_n429 <= polar_angle_n426;
    polar_angle_n430 <= polar_angle_n425;
    polar_angle_n433_term <= unsigned(resize(azimuth_n216, 25)) xor (24 downto 0 => polar_angle_n427(0));
    polar_angle_n433 <= resize(polar_angle_n424, 25) + signed(polar_angle_n433_term) + polar_angle_n427(0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s23 <= polar_angle_n301_s22;
                polar_angle_n425_s23 <= polar_angle_n425;
                polar_angle_n426_s23 <= polar_angle_n426;
                polar_angle_n427_s23 <= polar_angle_n427;
                polar_angle_n428_s23 <= polar_angle_n428;
                polar_angle_n429_s23 <= polar_angle_n429;
                polar_angle_n430_s23 <= polar_angle_n430;
                polar_angle_n433_s23 <= polar_angle_n433;
                phi_next_s23 <= phi_next_s22;
            end if;
            if rst = '1' then
                valid_s23 <= '0';
            elsif ce = '1' then
                valid_s23 <= valid_s22;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----
    -- polar_angle
    polar_angle_n431_term <= unsigned(resize(polar_angle_n429_s23, 40)) xor (39 downto 0 => polar_angle_n427_s23(0));
    polar_angle_n431 <= shift_left(resize(polar_angle_n425_s23, 40), 12) + signed(polar_angle_n431_term) + polar_angle_n427_s23(0);
    polar_angle_n432_term <= unsigned(resize(polar_angle_n430_s23, 40)) xor (39 downto 0 => polar_angle_n428_s23(0));
    polar_angle_n432 <= shift_left(resize(polar_angle_n426_s23, 40), 12) + signed(polar_angle_n432_term) + polar_angle_n428_s23(0);
    polar_angle_n434_over <= "1" when polar_angle_n433_s23(24) = '0' and (or polar_angle_n433_s23(23 downto 23)) = '1' else "0";
    polar_angle_n434_under <= "1" when polar_angle_n433_s23(24) = '1' and (and polar_angle_n433_s23(23 downto 23)) = '0' else "0";
    polar_angle_n434 <= 24x"7fffff" when polar_angle_n434_over(0) = '1' else 24x"800000" when polar_angle_n434_under(0) = '1' else polar_angle_n433_s23(23 downto 0);
    polar_angle_n435_cut <= polar_angle_n431(39 downto 12);
    polar_angle_n435_over <= "1" when polar_angle_n435_cut(27) = '0' and (or polar_angle_n435_cut(26 downto 26)) = '1' else "0";
    polar_angle_n435_under <= "1" when polar_angle_n435_cut(27) = '1' and (and polar_angle_n435_cut(26 downto 26)) = '0' else "0";
    polar_angle_n435 <= 27x"3ffffff" when polar_angle_n435_over(0) = '1' else 27x"4000000" when polar_angle_n435_under(0) = '1' else polar_angle_n435_cut(26 downto 0);
    polar_angle_n436_cut <= polar_angle_n432(39 downto 12);
    polar_angle_n436_over <= "1" when polar_angle_n436_cut(27) = '0' and (or polar_angle_n436_cut(26 downto 26)) = '1' else "0";
    polar_angle_n436_under <= "1" when polar_angle_n436_cut(27) = '1' and (and polar_angle_n436_cut(26 downto 26)) = '0' else "0";
    polar_angle_n436 <= 27x"3ffffff" when polar_angle_n436_over(0) = '1' else 27x"4000000" when polar_angle_n436_under(0) = '1' else polar_angle_n436_cut(26 downto 0);
    polar_angle_n437 <= unsigned(polar_angle_n436(26 downto 26));
    polar_angle_n438 <= polar_angle_n437 xor azimuth_n76;
    polar_angle_n439 <= polar_angle_n436;
    polar_angle_n440 <= polar_angle_n435;
    polar_angle_n441_term <= unsigned(resize(polar_angle_n439, 41)) xor (40 downto 0 => polar_angle_n437(0));
    polar_angle_n441 <= shift_left(resize(polar_angle_n435, 41), 13) + signed(polar_angle_n441_term) + polar_angle_n437(0);
    polar_angle_n442_term <= unsigned(resize(polar_angle_n440, 41)) xor (40 downto 0 => polar_angle_n438(0));
    polar_angle_n442 <= shift_left(resize(polar_angle_n436, 41), 13) + signed(polar_angle_n442_term) + polar_angle_n438(0);
    polar_angle_n443_term <= unsigned(resize(azimuth_n227, 25)) xor (24 downto 0 => polar_angle_n437(0));
    polar_angle_n443 <= resize(polar_angle_n434, 25) + signed(polar_angle_n443_term) + polar_angle_n437(0);
    polar_angle_n444_over <= "1" when polar_angle_n443(24) = '0' and (or polar_angle_n443(23 downto 23)) = '1' else "0";
    polar_angle_n444_under <= "1" when polar_angle_n443(24) = '1' and (and polar_angle_n443(23 downto 23)) = '0' else "0";
    polar_angle_n444 <= 24x"7fffff" when polar_angle_n444_over(0) = '1' else 24x"800000" when polar_angle_n444_under(0) = '1' else polar_angle_n443(23 downto 0);
    polar_angle_n445_cut <= polar_angle_n441(40 downto 13);
    polar_angle_n445_over <= "1" when polar_angle_n445_cut(27) = '0' and (or polar_angle_n445_cut(26 downto 26)) = '1' else "0";
    polar_angle_n445_under <= "1" when polar_angle_n445_cut(27) = '1' and (and polar_angle_n445_cut(26 downto 26)) = '0' else "0";
    polar_angle_n445 <= 27x"3ffffff" when polar_angle_n445_over(0) = '1' else 27x"4000000" when polar_angle_n445_under(0) = '1' else polar_angle_n445_cut(26 downto 0);
    polar_angle_n450 <= polar_angle_n445;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s24 <= polar_angle_n301_s23;
                polar_angle_n442_s24 <= polar_angle_n442;
                polar_angle_n444_s24 <= polar_angle_n444;
                polar_angle_n445_s24 <= polar_angle_n445;
                polar_angle_n450_s24 <= polar_angle_n450;
                phi_next_s24 <= phi_next_s23;
            end if;
            if rst = '1' then
                valid_s24 <= '0';
            elsif ce = '1' then
                valid_s24 <= valid_s23;
            end if;
        end if;
    end process;

    -- ---- stage 24 ----
    -- polar_angle
    polar_angle_n446_cut <= polar_angle_n442_s24(40 downto 13);
    polar_angle_n446_over <= "1" when polar_angle_n446_cut(27) = '0' and (or polar_angle_n446_cut(26 downto 26)) = '1' else "0";
    polar_angle_n446_under <= "1" when polar_angle_n446_cut(27) = '1' and (and polar_angle_n446_cut(26 downto 26)) = '0' else "0";
    polar_angle_n446 <= 27x"3ffffff" when polar_angle_n446_over(0) = '1' else 27x"4000000" when polar_angle_n446_under(0) = '1' else polar_angle_n446_cut(26 downto 0);
    polar_angle_n447 <= unsigned(polar_angle_n446(26 downto 26));
    polar_angle_n448 <= polar_angle_n447 xor azimuth_n76;
    polar_angle_n449 <= polar_angle_n446;
    polar_angle_n451_term <= unsigned(resize(polar_angle_n449, 42)) xor (41 downto 0 => polar_angle_n447(0));
    polar_angle_n451 <= shift_left(resize(polar_angle_n445_s24, 42), 14) + signed(polar_angle_n451_term) + polar_angle_n447(0);
    polar_angle_n452_term <= unsigned(resize(polar_angle_n450_s24, 42)) xor (41 downto 0 => polar_angle_n448(0));
    polar_angle_n452 <= shift_left(resize(polar_angle_n446, 42), 14) + signed(polar_angle_n452_term) + polar_angle_n448(0);
    polar_angle_n453_term <= unsigned(resize(azimuth_n238, 25)) xor (24 downto 0 => polar_angle_n447(0));
    polar_angle_n453 <= resize(polar_angle_n444_s24, 25) + signed(polar_angle_n453_term) + polar_angle_n447(0);
    polar_angle_n454_over <= "1" when polar_angle_n453(24) = '0' and (or polar_angle_n453(23 downto 23)) = '1' else "0";
    polar_angle_n454_under <= "1" when polar_angle_n453(24) = '1' and (and polar_angle_n453(23 downto 23)) = '0' else "0";
    polar_angle_n454 <= 24x"7fffff" when polar_angle_n454_over(0) = '1' else 24x"800000" when polar_angle_n454_under(0) = '1' else polar_angle_n453(23 downto 0);
    polar_angle_n455_cut <= polar_angle_n451(41 downto 14);
    polar_angle_n455_over <= "1" when polar_angle_n455_cut(27) = '0' and (or polar_angle_n455_cut(26 downto 26)) = '1' else "0";
    polar_angle_n455_under <= "1" when polar_angle_n455_cut(27) = '1' and (and polar_angle_n455_cut(26 downto 26)) = '0' else "0";
    polar_angle_n455 <= 27x"3ffffff" when polar_angle_n455_over(0) = '1' else 27x"4000000" when polar_angle_n455_under(0) = '1' else polar_angle_n455_cut(26 downto 0);
    polar_angle_n456_cut <= polar_angle_n452(41 downto 14);
    polar_angle_n456_over <= "1" when polar_angle_n456_cut(27) = '0' and (or polar_angle_n456_cut(26 downto 26)) = '1' else "0";
    polar_angle_n456_under <= "1" when polar_angle_n456_cut(27) = '1' and (and polar_angle_n456_cut(26 downto 26)) = '0' else "0";
    polar_angle_n456 <= 27x"3ffffff" when polar_angle_n456_over(0) = '1' else 27x"4000000" when polar_angle_n456_under(0) = '1' else polar_angle_n456_cut(26 downto 0);
    polar_angle_n457 <= unsigned(polar_angle_n456(26 downto 26));
    polar_angle_n458 <= polar_angle_n457 xor azimuth_n76;
    polar_angle_n459 <= polar_angle_n456;
    polar_angle_n460 <= polar_angle_n455;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s25 <= polar_angle_n301_s24;
                polar_angle_n454_s25 <= polar_angle_n454;
                polar_angle_n455_s25 <= polar_angle_n455;
                polar_angle_n456_s25 <= polar_angle_n456;
                polar_angle_n457_s25 <= polar_angle_n457;
                polar_angle_n458_s25 <= polar_angle_n458;
                polar_angle_n459_s25 <= polar_angle_n459;
                polar_angle_n460_s25 <= polar_angle_n460;
                phi_next_s25 <= phi_next_s24;
            end if;
            if rst = '1' then
                valid_s25 <= '0';
            elsif ce = '1' then
                valid_s25 <= valid_s24;
            end if;
        end if;
    end process;

    -- ---- stage 25 ----
    -- polar_angle
    polar_angle_n461_term <= unsigned(resize(polar_angle_n459_s25, 43)) xor (42 downto 0 => polar_angle_n457_s25(0));
    polar_angle_n461 <= shift_left(resize(polar_angle_n455_s25, 43), 15) + signed(polar_angle_n461_term) + polar_angle_n457_s25(0);
    polar_angle_n462_term <= unsigned(resize(polar_angle_n460_s25, 43)) xor (42 downto 0 => polar_angle_n458_s25(0));
    polar_angle_n462 <= shift_left(resize(polar_angle_n456_s25, 43), 15) + signed(polar_angle_n462_term) + polar_angle_n458_s25(0);
    polar_angle_n463_term <= unsigned(resize(azimuth_n249, 25)) xor (24 downto 0 => polar_angle_n457_s25(0));
    polar_angle_n463 <= resize(polar_angle_n454_s25, 25) + signed(polar_angle_n463_term) + polar_angle_n457_s25(0);
    polar_angle_n464_over <= "1" when polar_angle_n463(24) = '0' and (or polar_angle_n463(23 downto 23)) = '1' else "0";
    polar_angle_n464_under <= "1" when polar_angle_n463(24) = '1' and (and polar_angle_n463(23 downto 23)) = '0' else "0";
    polar_angle_n464 <= 24x"7fffff" when polar_angle_n464_over(0) = '1' else 24x"800000" when polar_angle_n464_under(0) = '1' else polar_angle_n463(23 downto 0);
    polar_angle_n465_cut <= polar_angle_n461(42 downto 15);
    polar_angle_n465_over <= "1" when polar_angle_n465_cut(27) = '0' and (or polar_angle_n465_cut(26 downto 26)) = '1' else "0";
    polar_angle_n465_under <= "1" when polar_angle_n465_cut(27) = '1' and (and polar_angle_n465_cut(26 downto 26)) = '0' else "0";
    polar_angle_n465 <= 27x"3ffffff" when polar_angle_n465_over(0) = '1' else 27x"4000000" when polar_angle_n465_under(0) = '1' else polar_angle_n465_cut(26 downto 0);
    polar_angle_n466_cut <= polar_angle_n462(42 downto 15);
    polar_angle_n466_over <= "1" when polar_angle_n466_cut(27) = '0' and (or polar_angle_n466_cut(26 downto 26)) = '1' else "0";
    polar_angle_n466_under <= "1" when polar_angle_n466_cut(27) = '1' and (and polar_angle_n466_cut(26 downto 26)) = '0' else "0";
    polar_angle_n466 <= 27x"3ffffff" when polar_angle_n466_over(0) = '1' else 27x"4000000" when polar_angle_n466_under(0) = '1' else polar_angle_n466_cut(26 downto 0);
    polar_angle_n467 <= unsigned(polar_angle_n466(26 downto 26));
    polar_angle_n468 <= polar_angle_n467 xor azimuth_n76;
    polar_angle_n469 <= polar_angle_n465;
    polar_angle_n470_term <= unsigned(resize(polar_angle_n469, 44)) xor (43 downto 0 => polar_angle_n468(0));
    polar_angle_n470 <= shift_left(resize(polar_angle_n466, 44), 16) + signed(polar_angle_n470_term) + polar_angle_n468(0);
    polar_angle_n471_term <= unsigned(resize(azimuth_n260, 25)) xor (24 downto 0 => polar_angle_n467(0));
    polar_angle_n471 <= resize(polar_angle_n464, 25) + signed(polar_angle_n471_term) + polar_angle_n467(0);
    polar_angle_n472_over <= "1" when polar_angle_n471(24) = '0' and (or polar_angle_n471(23 downto 23)) = '1' else "0";
    polar_angle_n472_under <= "1" when polar_angle_n471(24) = '1' and (and polar_angle_n471(23 downto 23)) = '0' else "0";
    polar_angle_n472 <= 24x"7fffff" when polar_angle_n472_over(0) = '1' else 24x"800000" when polar_angle_n472_under(0) = '1' else polar_angle_n471(23 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n301_s26 <= polar_angle_n301_s25;
                polar_angle_n470_s26 <= polar_angle_n470;
                polar_angle_n472_s26 <= polar_angle_n472;
                phi_next_s26 <= phi_next_s25;
            end if;
            if rst = '1' then
                valid_s26 <= '0';
            elsif ce = '1' then
                valid_s26 <= valid_s25;
            end if;
        end if;
    end process;

    -- ---- stage 26 ----
    -- polar_angle
    polar_angle_n473_cut <= polar_angle_n470_s26(43 downto 16);
    polar_angle_n473_over <= "1" when polar_angle_n473_cut(27) = '0' and (or polar_angle_n473_cut(26 downto 26)) = '1' else "0";
    polar_angle_n473_under <= "1" when polar_angle_n473_cut(27) = '1' and (and polar_angle_n473_cut(26 downto 26)) = '0' else "0";
    polar_angle_n473 <= 27x"3ffffff" when polar_angle_n473_over(0) = '1' else 27x"4000000" when polar_angle_n473_under(0) = '1' else polar_angle_n473_cut(26 downto 0);
    polar_angle_n474 <= unsigned(polar_angle_n473(26 downto 26));
    polar_angle_n475_term <= unsigned(resize(azimuth_n268, 25)) xor (24 downto 0 => polar_angle_n474(0));
    polar_angle_n475 <= resize(polar_angle_n472_s26, 25) + signed(polar_angle_n475_term) + polar_angle_n474(0);
    polar_angle_n476_over <= "1" when polar_angle_n475(24) = '0' and (or polar_angle_n475(23 downto 23)) = '1' else "0";
    polar_angle_n476_under <= "1" when polar_angle_n475(24) = '1' and (and polar_angle_n475(23 downto 23)) = '0' else "0";
    polar_angle_n476 <= 24x"7fffff" when polar_angle_n476_over(0) = '1' else 24x"800000" when polar_angle_n476_under(0) = '1' else polar_angle_n475(23 downto 0);
    polar_angle_n477 <= unsigned(polar_angle_n476);
    polar_angle_n478 <= polar_angle_n477 xor azimuth_n273;
    polar_angle_n479 <= polar_angle_n478 when polar_angle_n301_s26(0) = '1' else polar_angle_n477;
    -- (unit)
    n482_sum <= resize(polar_angle_n479, 25) + 25x"0000080";
    n482_cut <= n482_sum(24 downto 8);
    n482 <= n482_cut;
    theta_next <= n482(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi <= phi_next_s26;
                theta <= theta_next;
            end if;
            if rst = '1' then
                valid_s27 <= '0';
            elsif ce = '1' then
                valid_s27 <= valid_s26;
            end if;
        end if;
    end process;

    -- ---- stage 27 ----

    valid_out <= valid_s27;
end architecture;
