-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
--   variant=exact output=polar-table angle_bits=16 table_addr_bits=10 scheme=direct
--   quarter_wave=off frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate
--   sincos_addr_bits=auto asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
--   prop_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
--   period_ps=5000 stages=auto rom=block
-- latency 18 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   angle: mean 1.43e-3 rad, largest seen 5.07e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   dot: mean 1.43e-3, largest seen 5.07e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   x: mean 7.76e-4, largest seen 4.02e-3 at phi_a=49436 theta_a=17053 phi_n=14175 theta_n=17886
--   y: mean 6.22e-4, largest seen 3.23e-3 at phi_a=58542 theta_a=14878 phi_n=27212 theta_n=6389
--   z: mean 7.43e-4, largest seen 4.00e-3 at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
-- stated bound on the angle: 1.82e-2 rad
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity rotation_exact_polar_table is
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

architecture rtl of rotation_exact_polar_table is
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

    -- table recip: recip u20f18
    type recip_rom_rows is array (0 to 1023) of unsigned(19 downto 0);
    constant recip_rom : recip_rom_rows := (
        20x"7ff01", 20x"7fd02", 20x"7fb04", 20x"7f907",
        20x"7f70b", 20x"7f510", 20x"7f316", 20x"7f11d",
        20x"7ef24", 20x"7ed2d", 20x"7eb37", 20x"7e942",
        20x"7e74e", 20x"7e55b", 20x"7e368", 20x"7e177",
        20x"7df87", 20x"7dd97", 20x"7dba9", 20x"7d9bb",
        20x"7d7cf", 20x"7d5e3", 20x"7d3f8", 20x"7d20f",
        20x"7d026", 20x"7ce3e", 20x"7cc57", 20x"7ca71",
        20x"7c88c", 20x"7c6a8", 20x"7c4c4", 20x"7c2e2",
        20x"7c100", 20x"7bf20", 20x"7bd40", 20x"7bb62",
        20x"7b984", 20x"7b7a7", 20x"7b5cb", 20x"7b3f0",
        20x"7b215", 20x"7b03c", 20x"7ae64", 20x"7ac8c",
        20x"7aab5", 20x"7a8e0", 20x"7a70b", 20x"7a537",
        20x"7a364", 20x"7a191", 20x"79fc0", 20x"79def",
        20x"79c1f", 20x"79a51", 20x"79883", 20x"796b5",
        20x"794e9", 20x"7931e", 20x"79153", 20x"78f89",
        20x"78dc1", 20x"78bf9", 20x"78a31", 20x"7886b",
        20x"786a5", 20x"784e1", 20x"7831d", 20x"7815a",
        20x"77f98", 20x"77dd6", 20x"77c16", 20x"77a56",
        20x"77897", 20x"776d9", 20x"7751b", 20x"7735f",
        20x"771a3", 20x"76fe8", 20x"76e2e", 20x"76c75",
        20x"76abd", 20x"76905", 20x"7674e", 20x"76598",
        20x"763e3", 20x"7622e", 20x"7607a", 20x"75ec7",
        20x"75d15", 20x"75b64", 20x"759b3", 20x"75803",
        20x"75654", 20x"754a6", 20x"752f8", 20x"7514c",
        20x"74fa0", 20x"74df4", 20x"74c4a", 20x"74aa0",
        20x"748f7", 20x"7474f", 20x"745a8", 20x"74401",
        20x"7425b", 20x"740b6", 20x"73f11", 20x"73d6e",
        20x"73bcb", 20x"73a28", 20x"73887", 20x"736e6",
        20x"73546", 20x"733a7", 20x"73208", 20x"7306b",
        20x"72ecd", 20x"72d31", 20x"72b95", 20x"729fa",
        20x"72860", 20x"726c7", 20x"7252e", 20x"72396",
        20x"721fe", 20x"72068", 20x"71ed2", 20x"71d3d",
        20x"71ba8", 20x"71a14", 20x"71881", 20x"716ef",
        20x"7155d", 20x"713cc", 20x"7123b", 20x"710ac",
        20x"70f1d", 20x"70d8f", 20x"70c01", 20x"70a74",
        20x"708e8", 20x"7075c", 20x"705d1", 20x"70447",
        20x"702be", 20x"70135", 20x"6ffac", 20x"6fe25",
        20x"6fc9e", 20x"6fb18", 20x"6f992", 20x"6f80e",
        20x"6f689", 20x"6f506", 20x"6f383", 20x"6f201",
        20x"6f07f", 20x"6eefe", 20x"6ed7e", 20x"6ebfe",
        20x"6ea7f", 20x"6e901", 20x"6e783", 20x"6e606",
        20x"6e48a", 20x"6e30e", 20x"6e193", 20x"6e019",
        20x"6de9f", 20x"6dd25", 20x"6dbad", 20x"6da35",
        20x"6d8be", 20x"6d747", 20x"6d5d1", 20x"6d45b",
        20x"6d2e7", 20x"6d172", 20x"6cfff", 20x"6ce8c",
        20x"6cd19", 20x"6cba8", 20x"6ca37", 20x"6c8c6",
        20x"6c756", 20x"6c5e7", 20x"6c478", 20x"6c30a",
        20x"6c19d", 20x"6c030", 20x"6bec3", 20x"6bd58",
        20x"6bbed", 20x"6ba82", 20x"6b918", 20x"6b7af",
        20x"6b646", 20x"6b4de", 20x"6b377", 20x"6b210",
        20x"6b0a9", 20x"6af44", 20x"6adde", 20x"6ac7a",
        20x"6ab16", 20x"6a9b2", 20x"6a84f", 20x"6a6ed",
        20x"6a58b", 20x"6a42a", 20x"6a2ca", 20x"6a16a",
        20x"6a00a", 20x"69eab", 20x"69d4d", 20x"69bef",
        20x"69a92", 20x"69936", 20x"697da", 20x"6967e",
        20x"69523", 20x"693c9", 20x"6926f", 20x"69116",
        20x"68fbd", 20x"68e65", 20x"68d0d", 20x"68bb6",
        20x"68a60", 20x"6890a", 20x"687b4", 20x"68660",
        20x"6850b", 20x"683b8", 20x"68264", 20x"68112",
        20x"67fbf", 20x"67e6e", 20x"67d1d", 20x"67bcc",
        20x"67a7c", 20x"6792d", 20x"677de", 20x"6768f",
        20x"67541", 20x"673f4", 20x"672a7", 20x"6715b",
        20x"6700f", 20x"66ec4", 20x"66d79", 20x"66c2f",
        20x"66ae5", 20x"6699c", 20x"66853", 20x"6670b",
        20x"665c3", 20x"6647c", 20x"66335", 20x"661ef",
        20x"660a9", 20x"65f64", 20x"65e20", 20x"65cdb",
        20x"65b98", 20x"65a55", 20x"65912", 20x"657d0",
        20x"6568e", 20x"6554d", 20x"6540d", 20x"652cd",
        20x"6518d", 20x"6504e", 20x"64f0f", 20x"64dd1",
        20x"64c93", 20x"64b56", 20x"64a19", 20x"648dd",
        20x"647a1", 20x"64666", 20x"6452b", 20x"643f1",
        20x"642b7", 20x"6417e", 20x"64045", 20x"63f0d",
        20x"63dd5", 20x"63c9d", 20x"63b67", 20x"63a30",
        20x"638fa", 20x"637c5", 20x"6368f", 20x"6355b",
        20x"63427", 20x"632f3", 20x"631c0", 20x"6308d",
        20x"62f5b", 20x"62e29", 20x"62cf8", 20x"62bc7",
        20x"62a96", 20x"62967", 20x"62837", 20x"62708",
        20x"625d9", 20x"624ab", 20x"6237e", 20x"62250",
        20x"62123", 20x"61ff7", 20x"61ecb", 20x"61da0",
        20x"61c75", 20x"61b4a", 20x"61a20", 20x"618f7",
        20x"617cd", 20x"616a5", 20x"6157c", 20x"61454",
        20x"6132d", 20x"61206", 20x"610df", 20x"60fb9",
        20x"60e93", 20x"60d6e", 20x"60c49", 20x"60b25",
        20x"60a01", 20x"608dd", 20x"607ba", 20x"60698",
        20x"60575", 20x"60453", 20x"60332", 20x"60211",
        20x"600f0", 20x"5ffd0", 20x"5feb1", 20x"5fd91",
        20x"5fc72", 20x"5fb54", 20x"5fa36", 20x"5f918",
        20x"5f7fb", 20x"5f6de", 20x"5f5c2", 20x"5f4a6",
        20x"5f38a", 20x"5f26f", 20x"5f155", 20x"5f03a",
        20x"5ef20", 20x"5ee07", 20x"5ecee", 20x"5ebd5",
        20x"5eabd", 20x"5e9a5", 20x"5e88d", 20x"5e776",
        20x"5e660", 20x"5e549", 20x"5e434", 20x"5e31e",
        20x"5e209", 20x"5e0f4", 20x"5dfe0", 20x"5decc",
        20x"5ddb9", 20x"5dca6", 20x"5db93", 20x"5da81",
        20x"5d96f", 20x"5d85d", 20x"5d74c", 20x"5d63b",
        20x"5d52b", 20x"5d41b", 20x"5d30b", 20x"5d1fc",
        20x"5d0ed", 20x"5cfdf", 20x"5ced1", 20x"5cdc3",
        20x"5ccb6", 20x"5cba9", 20x"5ca9c", 20x"5c990",
        20x"5c885", 20x"5c779", 20x"5c66e", 20x"5c564",
        20x"5c459", 20x"5c34f", 20x"5c246", 20x"5c13d",
        20x"5c034", 20x"5bf2c", 20x"5be24", 20x"5bd1c",
        20x"5bc15", 20x"5bb0e", 20x"5ba07", 20x"5b901",
        20x"5b7fb", 20x"5b6f6", 20x"5b5f1", 20x"5b4ec",
        20x"5b3e8", 20x"5b2e4", 20x"5b1e0", 20x"5b0dd",
        20x"5afda", 20x"5aed7", 20x"5add5", 20x"5acd3",
        20x"5abd2", 20x"5aad1", 20x"5a9d0", 20x"5a8d0",
        20x"5a7d0", 20x"5a6d0", 20x"5a5d0", 20x"5a4d1",
        20x"5a3d3", 20x"5a2d5", 20x"5a1d7", 20x"5a0d9",
        20x"59fdc", 20x"59edf", 20x"59de2", 20x"59ce6",
        20x"59bea", 20x"59aef", 20x"599f4", 20x"598f9",
        20x"597fe", 20x"59704", 20x"5960a", 20x"59511",
        20x"59418", 20x"5931f", 20x"59226", 20x"5912e",
        20x"59037", 20x"58f3f", 20x"58e48", 20x"58d51",
        20x"58c5b", 20x"58b65", 20x"58a6f", 20x"58979",
        20x"58884", 20x"58790", 20x"5869b", 20x"585a7",
        20x"584b3", 20x"583c0", 20x"582cd", 20x"581da",
        20x"580e7", 20x"57ff5", 20x"57f03", 20x"57e12",
        20x"57d21", 20x"57c30", 20x"57b3f", 20x"57a4f",
        20x"5795f", 20x"57870", 20x"57780", 20x"57692",
        20x"575a3", 20x"574b5", 20x"573c7", 20x"572d9",
        20x"571ec", 20x"570ff", 20x"57012", 20x"56f26",
        20x"56e39", 20x"56d4e", 20x"56c62", 20x"56b77",
        20x"56a8c", 20x"569a2", 20x"568b7", 20x"567ce",
        20x"566e4", 20x"565fb", 20x"56512", 20x"56429",
        20x"56341", 20x"56259", 20x"56171", 20x"56089",
        20x"55fa2", 20x"55ebb", 20x"55dd5", 20x"55cef",
        20x"55c09", 20x"55b23", 20x"55a3e", 20x"55959",
        20x"55874", 20x"5578f", 20x"556ab", 20x"555c7",
        20x"554e4", 20x"55401", 20x"5531e", 20x"5523b",
        20x"55159", 20x"55077", 20x"54f95", 20x"54eb3",
        20x"54dd2", 20x"54cf1", 20x"54c10", 20x"54b30",
        20x"54a50", 20x"54970", 20x"54891", 20x"547b2",
        20x"546d3", 20x"545f4", 20x"54516", 20x"54438",
        20x"5435a", 20x"5427d", 20x"541a0", 20x"540c3",
        20x"53fe6", 20x"53f0a", 20x"53e2e", 20x"53d52",
        20x"53c76", 20x"53b9b", 20x"53ac0", 20x"539e6",
        20x"5390b", 20x"53831", 20x"53757", 20x"5367e",
        20x"535a5", 20x"534cc", 20x"533f3", 20x"5331a",
        20x"53242", 20x"5316a", 20x"53093", 20x"52fbc",
        20x"52ee4", 20x"52e0e", 20x"52d37", 20x"52c61",
        20x"52b8b", 20x"52ab5", 20x"529e0", 20x"5290b",
        20x"52836", 20x"52761", 20x"5268d", 20x"525b9",
        20x"524e5", 20x"52411", 20x"5233e", 20x"5226b",
        20x"52198", 20x"520c6", 20x"51ff3", 20x"51f21",
        20x"51e50", 20x"51d7e", 20x"51cad", 20x"51bdc",
        20x"51b0b", 20x"51a3b", 20x"5196b", 20x"5189b",
        20x"517cb", 20x"516fc", 20x"5162d", 20x"5155e",
        20x"5148f", 20x"513c1", 20x"512f3", 20x"51225",
        20x"51158", 20x"5108a", 20x"50fbd", 20x"50ef0",
        20x"50e24", 20x"50d57", 20x"50c8b", 20x"50bc0",
        20x"50af4", 20x"50a29", 20x"5095e", 20x"50893",
        20x"507c8", 20x"506fe", 20x"50634", 20x"5056a",
        20x"504a0", 20x"503d7", 20x"5030e", 20x"50245",
        20x"5017d", 20x"500b4", 20x"4ffec", 20x"4ff24",
        20x"4fe5d", 20x"4fd95", 20x"4fcce", 20x"4fc07",
        20x"4fb41", 20x"4fa7a", 20x"4f9b4", 20x"4f8ee",
        20x"4f829", 20x"4f763", 20x"4f69e", 20x"4f5d9",
        20x"4f514", 20x"4f450", 20x"4f38c", 20x"4f2c8",
        20x"4f204", 20x"4f140", 20x"4f07d", 20x"4efba",
        20x"4eef7", 20x"4ee34", 20x"4ed72", 20x"4ecb0",
        20x"4ebee", 20x"4eb2c", 20x"4ea6b", 20x"4e9aa",
        20x"4e8e9", 20x"4e828", 20x"4e768", 20x"4e6a7",
        20x"4e5e7", 20x"4e527", 20x"4e468", 20x"4e3a9",
        20x"4e2e9", 20x"4e22a", 20x"4e16c", 20x"4e0ad",
        20x"4dfef", 20x"4df31", 20x"4de73", 20x"4ddb6",
        20x"4dcf9", 20x"4dc3b", 20x"4db7f", 20x"4dac2",
        20x"4da06", 20x"4d949", 20x"4d88d", 20x"4d7d2",
        20x"4d716", 20x"4d65b", 20x"4d5a0", 20x"4d4e5",
        20x"4d42a", 20x"4d370", 20x"4d2b6", 20x"4d1fc",
        20x"4d142", 20x"4d088", 20x"4cfcf", 20x"4cf16",
        20x"4ce5d", 20x"4cda4", 20x"4ccec", 20x"4cc33",
        20x"4cb7b", 20x"4cac4", 20x"4ca0c", 20x"4c955",
        20x"4c89d", 20x"4c7e7", 20x"4c730", 20x"4c679",
        20x"4c5c3", 20x"4c50d", 20x"4c457", 20x"4c3a1",
        20x"4c2ec", 20x"4c236", 20x"4c181", 20x"4c0cd",
        20x"4c018", 20x"4bf64", 20x"4beaf", 20x"4bdfb",
        20x"4bd48", 20x"4bc94", 20x"4bbe1", 20x"4bb2d",
        20x"4ba7a", 20x"4b9c8", 20x"4b915", 20x"4b863",
        20x"4b7b1", 20x"4b6ff", 20x"4b64d", 20x"4b59b",
        20x"4b4ea", 20x"4b439", 20x"4b388", 20x"4b2d7",
        20x"4b227", 20x"4b176", 20x"4b0c6", 20x"4b016",
        20x"4af67", 20x"4aeb7", 20x"4ae08", 20x"4ad59",
        20x"4acaa", 20x"4abfb", 20x"4ab4d", 20x"4aa9e",
        20x"4a9f0", 20x"4a942", 20x"4a895", 20x"4a7e7",
        20x"4a73a", 20x"4a68d", 20x"4a5e0", 20x"4a533",
        20x"4a487", 20x"4a3da", 20x"4a32e", 20x"4a282",
        20x"4a1d6", 20x"4a12b", 20x"4a07f", 20x"49fd4",
        20x"49f29", 20x"49e7e", 20x"49dd4", 20x"49d29",
        20x"49c7f", 20x"49bd5", 20x"49b2b", 20x"49a82",
        20x"499d8", 20x"4992f", 20x"49886", 20x"497dd",
        20x"49734", 20x"4968c", 20x"495e4", 20x"4953c",
        20x"49494", 20x"493ec", 20x"49344", 20x"4929d",
        20x"491f6", 20x"4914f", 20x"490a8", 20x"49001",
        20x"48f5b", 20x"48eb5", 20x"48e0f", 20x"48d69",
        20x"48cc3", 20x"48c1d", 20x"48b78", 20x"48ad3",
        20x"48a2e", 20x"48989", 20x"488e5", 20x"48840",
        20x"4879c", 20x"486f8", 20x"48654", 20x"485b0",
        20x"4850d", 20x"48469", 20x"483c6", 20x"48323",
        20x"48281", 20x"481de", 20x"4813c", 20x"48099",
        20x"47ff7", 20x"47f55", 20x"47eb4", 20x"47e12",
        20x"47d71", 20x"47ccf", 20x"47c2e", 20x"47b8e",
        20x"47aed", 20x"47a4c", 20x"479ac", 20x"4790c",
        20x"4786c", 20x"477cc", 20x"4772d", 20x"4768d",
        20x"475ee", 20x"4754f", 20x"474b0", 20x"47411",
        20x"47373", 20x"472d4", 20x"47236", 20x"47198",
        20x"470fa", 20x"4705c", 20x"46fbf", 20x"46f21",
        20x"46e84", 20x"46de7", 20x"46d4a", 20x"46cae",
        20x"46c11", 20x"46b75", 20x"46ad8", 20x"46a3c",
        20x"469a1", 20x"46905", 20x"46869", 20x"467ce",
        20x"46733", 20x"46698", 20x"465fd", 20x"46562",
        20x"464c8", 20x"4642d", 20x"46393", 20x"462f9",
        20x"4625f", 20x"461c6", 20x"4612c", 20x"46093",
        20x"45ffa", 20x"45f61", 20x"45ec8", 20x"45e2f",
        20x"45d96", 20x"45cfe", 20x"45c66", 20x"45bce",
        20x"45b36", 20x"45a9e", 20x"45a07", 20x"4596f",
        20x"458d8", 20x"45841", 20x"457aa", 20x"45713",
        20x"4567c", 20x"455e6", 20x"45550", 20x"454ba",
        20x"45424", 20x"4538e", 20x"452f8", 20x"45263",
        20x"451cd", 20x"45138", 20x"450a3", 20x"4500e",
        20x"44f79", 20x"44ee5", 20x"44e50", 20x"44dbc",
        20x"44d28", 20x"44c94", 20x"44c00", 20x"44b6d",
        20x"44ad9", 20x"44a46", 20x"449b3", 20x"44920",
        20x"4488d", 20x"447fa", 20x"44768", 20x"446d5",
        20x"44643", 20x"445b1", 20x"4451f", 20x"4448d",
        20x"443fc", 20x"4436a", 20x"442d9", 20x"44248",
        20x"441b7", 20x"44126", 20x"44095", 20x"44004",
        20x"43f74", 20x"43ee4", 20x"43e54", 20x"43dc4",
        20x"43d34", 20x"43ca4", 20x"43c15", 20x"43b85",
        20x"43af6", 20x"43a67", 20x"439d8", 20x"43949",
        20x"438ba", 20x"4382c", 20x"4379e", 20x"4370f",
        20x"43681", 20x"435f3", 20x"43566", 20x"434d8",
        20x"4344b", 20x"433bd", 20x"43330", 20x"432a3",
        20x"43216", 20x"43189", 20x"430fd", 20x"43070",
        20x"42fe4", 20x"42f58", 20x"42ecc", 20x"42e40",
        20x"42db4", 20x"42d28", 20x"42c9d", 20x"42c12",
        20x"42b86", 20x"42afb", 20x"42a70", 20x"429e6",
        20x"4295b", 20x"428d1", 20x"42846", 20x"427bc",
        20x"42732", 20x"426a8", 20x"4261e", 20x"42595",
        20x"4250b", 20x"42482", 20x"423f9", 20x"42370",
        20x"422e7", 20x"4225e", 20x"421d5", 20x"4214d",
        20x"420c4", 20x"4203c", 20x"41fb4", 20x"41f2c",
        20x"41ea4", 20x"41e1c", 20x"41d95", 20x"41d0d",
        20x"41c86", 20x"41bff", 20x"41b78", 20x"41af1",
        20x"41a6a", 20x"419e4", 20x"4195d", 20x"418d7",
        20x"41851", 20x"417ca", 20x"41744", 20x"416bf",
        20x"41639", 20x"415b3", 20x"4152e", 20x"414a9",
        20x"41424", 20x"4139f", 20x"4131a", 20x"41295",
        20x"41210", 20x"4118c", 20x"41107", 20x"41083",
        20x"40fff", 20x"40f7b", 20x"40ef7", 20x"40e74",
        20x"40df0", 20x"40d6d", 20x"40ce9", 20x"40c66",
        20x"40be3", 20x"40b60", 20x"40add", 20x"40a5b",
        20x"409d8", 20x"40956", 20x"408d3", 20x"40851",
        20x"407cf", 20x"4074d", 20x"406cc", 20x"4064a",
        20x"405c8", 20x"40547", 20x"404c6", 20x"40445",
        20x"403c4", 20x"40343", 20x"402c2", 20x"40241",
        20x"401c1", 20x"40141", 20x"400c0", 20x"40040"
    );
    attribute rom_style of recip_rom : constant is "block";

    -- table atan: atan u19f18, secant u19f18
    type atan_rom_rows is array (0 to 1023) of unsigned(37 downto 0);
    constant atan_rom : atan_rom_rows := (
        38x"0000a40000", 38x"0001ec0000", 38x"0003340001", 38x"00047c0002",
        38x"0005bc0003", 38x"0007040004", 38x"00084c0005", 38x"00098c0007",
        38x"000ad40009", 38x"000c1c000b", 38x"000d64000e", 38x"000ea40011",
        38x"000fec0014", 38x"0011340017", 38x"00127c001a", 38x"0013bc001e",
        38x"0015040022", 38x"00164c0026", 38x"001794002b", 38x"0018d40030",
        38x"001a1c0035", 38x"001b64003a", 38x"001cac003f", 38x"001dec0045",
        38x"001f34004b", 38x"00207c0051", 38x"0021bc0058", 38x"002304005f",
        38x"00244c0066", 38x"002594006d", 38x"0026d40074", 38x"00281c007c",
        38x"0029640084", 38x"002aa4008c", 38x"002bec0095", 38x"002d34009d",
        38x"002e7400a6", 38x"002fbc00b0", 38x"00310400b9", 38x"00324400c3",
        38x"00338c00cd", 38x"0034d400d7", 38x"00361c00e2", 38x"00375c00ec",
        38x"0038a400f7", 38x"0039ec0103", 38x"003b2c010e", 38x"003c74011a",
        38x"003dbc0126", 38x"003efc0132", 38x"004044013f", 38x"004184014b",
        38x"0042cc0158", 38x"0044140166", 38x"0045540173", 38x"00469c0181",
        38x"0047e4018f", 38x"004924019d", 38x"004a6c01ab", 38x"004bac01ba",
        38x"004cf401c9", 38x"004e3c01d8", 38x"004f7c01e8", 38x"0050c401f8",
        38x"0052040208", 38x"00534c0218", 38x"0054940228", 38x"0055d40239",
        38x"00571c024a", 38x"00585c025b", 38x"0059a4026d", 38x"005ae4027e",
        38x"005c2c0290", 38x"005d6c02a2", 38x"005eb402b5", 38x"005ffc02c8",
        38x"00613c02db", 38x"00628402ee", 38x"0063c40301", 38x"00650c0315",
        38x"00664c0329", 38x"006794033d", 38x"0068d40351", 38x"006a1c0366",
        38x"006b5c037b", 38x"006c9c0390", 38x"006de403a6", 38x"006f2403bb",
        38x"00706c03d1", 38x"0071ac03e7", 38x"0072f403fe", 38x"0074340414",
        38x"00757c042b", 38x"0076bc0442", 38x"0077fc045a", 38x"0079440472",
        38x"007a840489", 38x"007bc404a2", 38x"007d0c04ba", 38x"007e4c04d3",
        38x"007f9404eb", 38x"0080d40505", 38x"008214051e", 38x"00835c0538",
        38x"00849c0551", 38x"0085dc056c", 38x"0087240586", 38x"00886405a1",
        38x"0089a405bb", 38x"008ae405d6", 38x"008c2c05f2", 38x"008d6c060d",
        38x"008eac0629", 38x"008ff40645", 38x"0091340662", 38x"009274067e",
        38x"0093b4069b", 38x"0094f406b8", 38x"00963c06d5", 38x"00977c06f3",
        38x"0098bc0711", 38x"0099fc072f", 38x"009b3c074d", 38x"009c84076c",
        38x"009dc4078a", 38x"009f0407a9", 38x"00a04407c9", 38x"00a18407e8",
        38x"00a2c40808", 38x"00a4040828", 38x"00a5440848", 38x"00a68c0869",
        38x"00a7cc0889", 38x"00a90c08aa", 38x"00aa4c08cc", 38x"00ab8c08ed",
        38x"00accc090f", 38x"00ae0c0931", 38x"00af4c0953", 38x"00b08c0975",
        38x"00b1cc0998", 38x"00b30c09bb", 38x"00b44c09de", 38x"00b58c0a01",
        38x"00b6cc0a25", 38x"00b80c0a49", 38x"00b94c0a6d", 38x"00ba8c0a92",
        38x"00bbc40ab6", 38x"00bd040adb", 38x"00be440b00", 38x"00bf840b25",
        38x"00c0c40b4b", 38x"00c2040b71", 38x"00c3440b97", 38x"00c4840bbd",
        38x"00c5bc0be4", 38x"00c6fc0c0b", 38x"00c83c0c32", 38x"00c97c0c59",
        38x"00cabc0c80", 38x"00cbf40ca8", 38x"00cd340cd0", 38x"00ce740cf8",
        38x"00cfac0d21", 38x"00d0ec0d4a", 38x"00d22c0d73", 38x"00d36c0d9c",
        38x"00d4a40dc5", 38x"00d5e40def", 38x"00d7240e19", 38x"00d85c0e43",
        38x"00d99c0e6d", 38x"00dad40e98", 38x"00dc140ec3", 38x"00dd540eee",
        38x"00de8c0f19", 38x"00dfcc0f45", 38x"00e1040f71", 38x"00e2440f9d",
        38x"00e37c0fc9", 38x"00e4bc0ff6", 38x"00e5f41023", 38x"00e7341050",
        38x"00e86c107d", 38x"00e9ac10ab", 38x"00eae410d8", 38x"00ec241106",
        38x"00ed5c1134", 38x"00ee941163", 38x"00efd41192", 38x"00f10c11c1",
        38x"00f24c11f0", 38x"00f384121f", 38x"00f4bc124f", 38x"00f5fc127f",
        38x"00f73412af", 38x"00f86c12df", 38x"00f9a41310", 38x"00fae41341",
        38x"00fc1c1372", 38x"00fd5413a3", 38x"00fe8c13d5", 38x"00ffcc1406",
        38x"0101041438", 38x"01023c146b", 38x"010374149d", 38x"0104ac14d0",
        38x"0105e41503", 38x"0107241536", 38x"01085c1569", 38x"010994159d",
        38x"010acc15d1", 38x"010c041605", 38x"010d3c1639", 38x"010e74166e",
        38x"010fac16a3", 38x"0110e416d8", 38x"01121c170d", 38x"0113541743",
        38x"01148c1779", 38x"0115c417af", 38x"0116fc17e5", 38x"011834181b",
        38x"0119641852", 38x"011a9c1889", 38x"011bd418c0", 38x"011d0c18f8",
        38x"011e44192f", 38x"011f7c1967", 38x"0120ac199f", 38x"0121e419d7",
        38x"01231c1a10", 38x"0124541a49", 38x"0125841a82", 38x"0126bc1abb",
        38x"0127f41af5", 38x"0129241b2e", 38x"012a5c1b68", 38x"012b941ba2",
        38x"012cc41bdd", 38x"012dfc1c18", 38x"012f341c52", 38x"0130641c8e",
        38x"01319c1cc9", 38x"0132cc1d04", 38x"0134041d40", 38x"0135341d7c",
        38x"01366c1db9", 38x"01379c1df5", 38x"0138d41e32", 38x"013a041e6f",
        38x"013b341eac", 38x"013c6c1ee9", 38x"013d9c1f27", 38x"013ed41f65",
        38x"0140041fa3", 38x"0141341fe1", 38x"01426c2020", 38x"01439c205e",
        38x"0144cc209d", 38x"0145fc20dd", 38x"014734211c", 38x"014864215c",
        38x"014994219c", 38x"014ac421dc", 38x"014bf4221c", 38x"014d2c225d",
        38x"014e5c229e", 38x"014f8c22df", 38x"0150bc2320", 38x"0151ec2361",
        38x"01531c23a3", 38x"01544c23e5", 38x"01557c2427", 38x"0156ac246a",
        38x"0157dc24ac", 38x"01590c24ef", 38x"015a3c2532", 38x"015b6c2576",
        38x"015c9c25b9", 38x"015dcc25fd", 38x"015efc2641", 38x"01602c2685",
        38x"01615426c9", 38x"016284270e", 38x"0163b42753", 38x"0164e42798",
        38x"01660c27dd", 38x"01673c2823", 38x"01686c2869", 38x"01699c28af",
        38x"016ac428f5", 38x"016bf4293b", 38x"016d242982", 38x"016e4c29c9",
        38x"016f7c2a10", 38x"0170a42a57", 38x"0171d42a9f", 38x"0173042ae6",
        38x"01742c2b2e", 38x"01755c2b77", 38x"0176842bbf", 38x"0177b42c08",
        38x"0178dc2c50", 38x"017a042c9a", 38x"017b342ce3", 38x"017c5c2d2c",
        38x"017d8c2d76", 38x"017eb42dc0", 38x"017fdc2e0a", 38x"0181042e55",
        38x"0182342e9f", 38x"01835c2eea", 38x"0184842f35", 38x"0185ac2f80",
        38x"0186dc2fcc", 38x"0188043018", 38x"01892c3063", 38x"018a5430b0",
        38x"018b7c30fc", 38x"018ca43149", 38x"018dcc3195", 38x"018efc31e2",
        38x"0190243230", 38x"01914c327d", 38x"01927432cb", 38x"01939c3319",
        38x"0194c43367", 38x"0195e433b5", 38x"01970c3403", 38x"0198343452",
        38x"01995c34a1", 38x"019a8434f0", 38x"019bac3540", 38x"019cd4358f",
        38x"019df435df", 38x"019f1c362f", 38x"01a044367f", 38x"01a16c36d0",
        38x"01a28c3721", 38x"01a3b43771", 38x"01a4dc37c2", 38x"01a5fc3814",
        38x"01a7243865", 38x"01a84438b7", 38x"01a96c3909", 38x"01aa94395b",
        38x"01abb439ae", 38x"01acdc3a00", 38x"01adfc3a53", 38x"01af243aa6",
        38x"01b0443af9", 38x"01b1643b4d", 38x"01b28c3ba0", 38x"01b3ac3bf4",
        38x"01b4d43c48", 38x"01b5f43c9c", 38x"01b7143cf1", 38x"01b8343d46",
        38x"01b95c3d9b", 38x"01ba7c3df0", 38x"01bb9c3e45", 38x"01bcbc3e9a",
        38x"01bde43ef0", 38x"01bf043f46", 38x"01c0243f9c", 38x"01c1443ff3",
        38x"01c2644049", 38x"01c38440a0", 38x"01c4a440f7", 38x"01c5c4414e",
        38x"01c6e441a6", 38x"01c80441fd", 38x"01c9244255", 38x"01ca4442ad",
        38x"01cb644305", 38x"01cc84435e", 38x"01cda443b6", 38x"01cebc440f",
        38x"01cfdc4468", 38x"01d0fc44c2", 38x"01d21c451b", 38x"01d33c4575",
        38x"01d45445cf", 38x"01d5744629", 38x"01d6944683", 38x"01d7ac46de",
        38x"01d8cc4738", 38x"01d9e44793", 38x"01db0447ee", 38x"01dc24484a",
        38x"01dd3c48a5", 38x"01de5c4901", 38x"01df74495d", 38x"01e09449b9",
        38x"01e1ac4a15", 38x"01e2cc4a72", 38x"01e3e44acf", 38x"01e4fc4b2c",
        38x"01e61c4b89", 38x"01e7344be6", 38x"01e84c4c44", 38x"01e96c4ca1",
        38x"01ea844cff", 38x"01eb9c4d5d", 38x"01ecb44dbc", 38x"01edcc4e1a",
        38x"01eeec4e79", 38x"01f0044ed8", 38x"01f11c4f37", 38x"01f2344f97",
        38x"01f34c4ff6", 38x"01f4645056", 38x"01f57c50b6", 38x"01f6945116",
        38x"01f7ac5176", 38x"01f8c451d7", 38x"01f9dc5238", 38x"01faf45299",
        38x"01fc0c52fa", 38x"01fd24535b", 38x"01fe3453bd", 38x"01ff4c541e",
        38x"0200645480", 38x"02017c54e2", 38x"02028c5545", 38x"0203a455a7",
        38x"0204bc560a", 38x"0205cc566d", 38x"0206e456d0", 38x"0207fc5733",
        38x"02090c5797", 38x"020a2457fb", 38x"020b34585e", 38x"020c4c58c3",
        38x"020d5c5927", 38x"020e74598b", 38x"020f8459f0", 38x"02109c5a55",
        38x"0211ac5aba", 38x"0212c45b1f", 38x"0213d45b85", 38x"0214e45bea",
        38x"0215f45c50", 38x"02170c5cb6", 38x"02181c5d1c", 38x"02192c5d83",
        38x"021a3c5de9", 38x"021b545e50", 38x"021c645eb7", 38x"021d745f1e",
        38x"021e845f86", 38x"021f945fed", 38x"0220a46055", 38x"0221b460bd",
        38x"0222c46125", 38x"0223d4618e", 38x"0224e461f6", 38x"0225f4625f",
        38x"02270462c8", 38x"0228146331", 38x"022924639a", 38x"022a2c6403",
        38x"022b3c646d", 38x"022c4c64d7", 38x"022d5c6541", 38x"022e6465ab",
        38x"022f746616", 38x"0230846680", 38x"02319466eb", 38x"02329c6756",
        38x"0233ac67c1", 38x"0234b4682d", 38x"0235c46898", 38x"0236cc6904",
        38x"0237dc6970", 38x"0238e469dc", 38x"0239f46a48", 38x"023afc6ab5",
        38x"023c0c6b21", 38x"023d146b8e", 38x"023e1c6bfb", 38x"023f2c6c68",
        38x"0240346cd6", 38x"02413c6d43", 38x"02424c6db1", 38x"0243546e1f",
        38x"02445c6e8d", 38x"0245646efb", 38x"02466c6f6a", 38x"0247746fd9",
        38x"0248847047", 38x"02498c70b7", 38x"024a947126", 38x"024b9c7195",
        38x"024ca47205", 38x"024dac7275", 38x"024eb472e5", 38x"024fbc7355",
        38x"0250bc73c5", 38x"0251c47435", 38x"0252cc74a6", 38x"0253d47517",
        38x"0254dc7588", 38x"0255e475f9", 38x"0256e4766b", 38x"0257ec76dc",
        38x"0258f4774e", 38x"0259f477c0", 38x"025afc7832", 38x"025c0478a4",
        38x"025d047917", 38x"025e0c798a", 38x"025f0c79fc", 38x"0260147a6f",
        38x"0261147ae3", 38x"02621c7b56", 38x"02631c7bca", 38x"0264247c3d",
        38x"0265247cb1", 38x"02662c7d25", 38x"02672c7d9a", 38x"02682c7e0e",
        38x"02692c7e83", 38x"026a347ef7", 38x"026b347f6c", 38x"026c347fe2",
        38x"026d348057", 38x"026e3c80cc", 38x"026f3c8142", 38x"02703c81b8",
        38x"02713c822e", 38x"02723c82a4", 38x"02733c831b", 38x"02743c8391",
        38x"02753c8408", 38x"02763c847f", 38x"02773c84f6", 38x"02783c856d",
        38x"02793c85e4", 38x"027a34865c", 38x"027b3486d4", 38x"027c34874c",
        38x"027d3487c4", 38x"027e34883c", 38x"027f2c88b5", 38x"02802c892d",
        38x"02812c89a6", 38x"0282248a1f", 38x"0283248a98", 38x"0284248b11",
        38x"02851c8b8b", 38x"02861c8c04", 38x"0287148c7e", 38x"0288148cf8",
        38x"02890c8d72", 38x"028a0c8ded", 38x"028b048e67", 38x"028bfc8ee2",
        38x"028cfc8f5d", 38x"028df48fd8", 38x"028eec9053", 38x"028fec90ce",
        38x"0290e4914a", 38x"0291dc91c5", 38x"0292d49241", 38x"0293d492bd",
        38x"0294cc9339", 38x"0295c493b6", 38x"0296bc9432", 38x"0297b494af",
        38x"0298ac952c", 38x"0299a495a9", 38x"029a9c9626", 38x"029b9496a3",
        38x"029c8c9721", 38x"029d84979e", 38x"029e7c981c", 38x"029f74989a",
        38x"02a06c9918", 38x"02a15c9997", 38x"02a2549a15", 38x"02a34c9a94",
        38x"02a4449b13", 38x"02a5349b92", 38x"02a62c9c11", 38x"02a7249c90",
        38x"02a8149d10", 38x"02a90c9d8f", 38x"02aa049e0f", 38x"02aaf49e8f",
        38x"02abec9f0f", 38x"02acdc9f90", 38x"02add4a010", 38x"02aec4a091",
        38x"02afbca111", 38x"02b0aca192", 38x"02b19ca213", 38x"02b294a295",
        38x"02b384a316", 38x"02b474a398", 38x"02b56ca419", 38x"02b65ca49b",
        38x"02b74ca51d", 38x"02b83ca5a0", 38x"02b934a622", 38x"02ba24a6a5",
        38x"02bb14a727", 38x"02bc04a7aa", 38x"02bcf4a82d", 38x"02bde4a8b0",
        38x"02bed4a934", 38x"02bfc4a9b7", 38x"02c0b4aa3b", 38x"02c1a4aabf",
        38x"02c294ab43", 38x"02c384abc7", 38x"02c474ac4b", 38x"02c564accf",
        38x"02c64cad54", 38x"02c73cadd9", 38x"02c82cae5e", 38x"02c91caee3",
        38x"02ca04af68", 38x"02caf4afed", 38x"02cbe4b073", 38x"02ccccb0f8",
        38x"02cdbcb17e", 38x"02cea4b204", 38x"02cf94b28a", 38x"02d084b311",
        38x"02d16cb397", 38x"02d25cb41e", 38x"02d344b4a5", 38x"02d42cb52b",
        38x"02d51cb5b3", 38x"02d604b63a", 38x"02d6f4b6c1", 38x"02d7dcb749",
        38x"02d8c4b7d0", 38x"02d9acb858", 38x"02da9cb8e0", 38x"02db84b968",
        38x"02dc6cb9f1", 38x"02dd54ba79", 38x"02de3cbb02", 38x"02df2cbb8a",
        38x"02e014bc13", 38x"02e0fcbc9c", 38x"02e1e4bd25", 38x"02e2ccbdaf",
        38x"02e3b4be38", 38x"02e49cbec2", 38x"02e584bf4c", 38x"02e66cbfd6",
        38x"02e74cc060", 38x"02e834c0ea", 38x"02e91cc174", 38x"02ea04c1ff",
        38x"02eaecc28a", 38x"02ebd4c314", 38x"02ecb4c39f", 38x"02ed9cc42b",
        38x"02ee84c4b6", 38x"02ef64c541", 38x"02f04cc5cd", 38x"02f134c659",
        38x"02f214c6e4", 38x"02f2fcc770", 38x"02f3dcc7fd", 38x"02f4c4c889",
        38x"02f5a4c915", 38x"02f68cc9a2", 38x"02f76cca2f", 38x"02f84ccabc",
        38x"02f934cb49", 38x"02fa14cbd6", 38x"02fafccc63", 38x"02fbdcccf1",
        38x"02fcbccd7e", 38x"02fd9cce0c", 38x"02fe84ce9a", 38x"02ff64cf28",
        38x"030044cfb6", 38x"030124d045", 38x"030204d0d3", 38x"0302e4d162",
        38x"0303c4d1f0", 38x"0304a4d27f", 38x"030584d30e", 38x"030664d39e",
        38x"030744d42d", 38x"030824d4bc", 38x"030904d54c", 38x"0309e4d5dc",
        38x"030ac4d66c", 38x"030ba4d6fc", 38x"030c84d78c", 38x"030d64d81c",
        38x"030e3cd8ad", 38x"030f1cd93d", 38x"030ffcd9ce", 38x"0310d4da5f",
        38x"0311b4daf0", 38x"031294db81", 38x"03136cdc12", 38x"03144cdca4",
        38x"03152cdd36", 38x"031604ddc7", 38x"0316e4de59", 38x"0317bcdeeb",
        38x"03189cdf7d", 38x"031974e010", 38x"031a4ce0a2", 38x"031b2ce135",
        38x"031c04e1c7", 38x"031cdce25a", 38x"031dbce2ed", 38x"031e94e380",
        38x"031f6ce413", 38x"03204ce4a7", 38x"032124e53a", 38x"0321fce5ce",
        38x"0322d4e662", 38x"0323ace6f6", 38x"032484e78a", 38x"032564e81e",
        38x"03263ce8b2", 38x"032714e947", 38x"0327ece9db", 38x"0328c4ea70",
        38x"03299ceb05", 38x"032a74eb9a", 38x"032b44ec2f", 38x"032c1cecc4",
        38x"032cf4ed5a", 38x"032dccedef", 38x"032ea4ee85", 38x"032f7cef1b",
        38x"03304cefb1", 38x"033124f047", 38x"0331fcf0dd", 38x"0332d4f173",
        38x"0333a4f20a", 38x"03347cf2a0", 38x"03354cf337", 38x"033624f3ce",
        38x"0336fcf465", 38x"0337ccf4fc", 38x"0338a4f593", 38x"033974f62b",
        38x"033a4cf6c2", 38x"033b1cf75a", 38x"033bf4f7f2", 38x"033cc4f88a",
        38x"033d94f922", 38x"033e6cf9ba", 38x"033f3cfa52", 38x"03400cfaeb",
        38x"0340e4fb83", 38x"0341b4fc1c", 38x"034284fcb5", 38x"034354fd4e",
        38x"034424fde7", 38x"0344fcfe80", 38x"0345ccff19", 38x"03469cffb3",
        38x"03476d004d", 38x"03483d00e6", 38x"03490d0180", 38x"0349dd021a",
        38x"034aad02b4", 38x"034b7d034e", 38x"034c4d03e9", 38x"034d1d0483",
        38x"034ded051e", 38x"034eb505b9", 38x"034f850654", 38x"03505506ef",
        38x"035125078a", 38x"0351f50825", 38x"0352bd08c0", 38x"03538d095c",
        38x"03545d09f7", 38x"0355250a93", 38x"0355f50b2f", 38x"0356c50bcb",
        38x"03578d0c67", 38x"03585d0d03", 38x"0359250da0", 38x"0359f50e3c",
        38x"035abd0ed9", 38x"035b8d0f76", 38x"035c551012", 38x"035d2510af",
        38x"035ded114d", 38x"035eb511ea", 38x"035f851287", 38x"03604d1325",
        38x"03611513c2", 38x"0361e51460", 38x"0362ad14fe", 38x"036375159c",
        38x"03643d163a", 38x"03650d16d8", 38x"0365d51776", 38x"03669d1815",
        38x"03676518b4", 38x"03682d1952", 38x"0368f519f1", 38x"0369bd1a90",
        38x"036a851b2f", 38x"036b4d1bce", 38x"036c151c6e", 38x"036cdd1d0d",
        38x"036da51dac", 38x"036e6d1e4c", 38x"036f351eec", 38x"036ffd1f8c",
        38x"0370bd202c", 38x"03718520cc", 38x"03724d216c", 38x"037315220d",
        38x"0373dd22ad", 38x"03749d234e", 38x"03756523ee", 38x"03762d248f",
        38x"0376ed2530", 38x"0377b525d1", 38x"0378752672", 38x"03793d2714",
        38x"0379fd27b5", 38x"037ac52857", 38x"037b8d28f8", 38x"037c4d299a",
        38x"037d0d2a3c", 38x"037dd52ade", 38x"037e952b80", 38x"037f5d2c23",
        38x"03801d2cc5", 38x"0380dd2d67", 38x"0381a52e0a", 38x"0382652ead",
        38x"0383252f4f", 38x"0383e52ff2", 38x"0384ad3095", 38x"03856d3139",
        38x"03862d31dc", 38x"0386ed327f", 38x"0387ad3323", 38x"03886d33c6",
        38x"03892d346a", 38x"0389ed350e", 38x"038ab535b2", 38x"038b753656",
        38x"038c3536fa", 38x"038ced379f", 38x"038dad3843", 38x"038e6d38e7",
        38x"038f2d398c", 38x"038fed3a31", 38x"0390ad3ad6", 38x"03916d3b7b",
        38x"03922d3c20", 38x"0392e53cc5", 38x"0393a53d6a", 38x"0394653e10",
        38x"0395253eb5", 38x"0395dd3f5b", 38x"03969d4001", 38x"03975d40a7",
        38x"039815414d", 38x"0398d541f3", 38x"03998d4299", 38x"039a4d433f",
        38x"039b0543e6", 38x"039bc5448c", 38x"039c7d4533", 38x"039d3d45d9",
        38x"039df54680", 38x"039eb54727", 38x"039f6d47ce", 38x"03a0254875",
        38x"03a0e5491d", 38x"03a19d49c4", 38x"03a2554a6c", 38x"03a3154b13",
        38x"03a3cd4bbb", 38x"03a4854c63", 38x"03a53d4d0b", 38x"03a5fd4db3",
        38x"03a6b54e5b", 38x"03a76d4f03", 38x"03a8254fac", 38x"03a8dd5054",
        38x"03a99550fd", 38x"03aa4d51a5", 38x"03ab05524e", 38x"03abbd52f7",
        38x"03ac7553a0", 38x"03ad2d5449", 38x"03ade554f2", 38x"03ae9d559c",
        38x"03af555645", 38x"03b00d56ef", 38x"03b0c55798", 38x"03b17d5842",
        38x"03b22d58ec", 38x"03b2e55996", 38x"03b39d5a40", 38x"03b4555aea",
        38x"03b5055b94", 38x"03b5bd5c3f", 38x"03b6755ce9", 38x"03b7255d94",
        38x"03b7dd5e3e", 38x"03b8955ee9", 38x"03b9455f94", 38x"03b9fd603f",
        38x"03baad60ea", 38x"03bb656195", 38x"03bc156241", 38x"03bccd62ec",
        38x"03bd7d6397", 38x"03be356443", 38x"03bee564ef", 38x"03bf9d659b",
        38x"03c04d6646", 38x"03c0fd66f2", 38x"03c1b5679f", 38x"03c265684b",
        38x"03c31568f7", 38x"03c3c569a4", 38x"03c47d6a50", 38x"03c52d6afd",
        38x"03c5dd6ba9", 38x"03c68d6c56", 38x"03c73d6d03", 38x"03c7f56db0",
        38x"03c8a56e5d", 38x"03c9556f0a", 38x"03ca056fb8", 38x"03cab57065",
        38x"03cb657113", 38x"03cc1571c0", 38x"03ccc5726e", 38x"03cd75731c",
        38x"03ce2573ca", 38x"03ced57478", 38x"03cf857526", 38x"03d02d75d4",
        38x"03d0dd7682", 38x"03d18d7731", 38x"03d23d77df", 38x"03d2ed788e",
        38x"03d39d793d", 38x"03d44579eb", 38x"03d4f57a9a", 38x"03d5a57b49",
        38x"03d64d7bf8", 38x"03d6fd7ca8", 38x"03d7ad7d57", 38x"03d8557e06",
        38x"03d9057eb6", 38x"03d9b57f65", 38x"03da5d8015", 38x"03db0d80c5",
        38x"03dbb58175", 38x"03dc658225", 38x"03dd0d82d5", 38x"03ddbd8385",
        38x"03de658435", 38x"03df0d84e5", 38x"03dfbd8596", 38x"03e0658646",
        38x"03e11586f7", 38x"03e1bd87a8", 38x"03e2658858", 38x"03e30d8909",
        38x"03e3bd89ba", 38x"03e4658a6b", 38x"03e50d8b1d", 38x"03e5b58bce",
        38x"03e6658c7f", 38x"03e70d8d31", 38x"03e7b58de2", 38x"03e85d8e94",
        38x"03e9058f46", 38x"03e9ad8ff8", 38x"03ea5590aa", 38x"03eafd915c",
        38x"03eba5920e", 38x"03ec4d92c0", 38x"03ecf59372", 38x"03ed9d9425",
        38x"03ee4594d7", 38x"03eeed958a", 38x"03ef95963c", 38x"03f03d96ef",
        38x"03f0e597a2", 38x"03f18d9855", 38x"03f22d9908", 38x"03f2d599bb",
        38x"03f37d9a6e", 38x"03f4259b22", 38x"03f4c59bd5", 38x"03f56d9c89",
        38x"03f6159d3c", 38x"03f6b59df0", 38x"03f75d9ea4", 38x"03f8059f57",
        38x"03f8a5a00b", 38x"03f94da0bf", 38x"03f9f5a174", 38x"03fa95a228",
        38x"03fb3da2dc", 38x"03fbdda391", 38x"03fc85a445", 38x"03fd25a4fa",
        38x"03fdcda5ae", 38x"03fe6da663", 38x"03ff0da718", 38x"03ffb5a7cd"
    );
    attribute rom_style of atan_rom : constant is "block";

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
    signal azimuth_n83 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal azimuth_n87 : unsigned(18 downto 0) := (others => '0'); -- u19f18
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
    signal azimuth_n63_neg : unsigned(19 downto 0) := (others => '0');
    signal azimuth_n63 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n64_neg : unsigned(19 downto 0) := (others => '0');
    signal azimuth_n64 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n86 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_neg : unsigned(19 downto 0) := (others => '0');
    signal polar_angle_n97 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n63_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n64_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n86_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal azimuth_n65 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n66 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n67 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n68_padded : unsigned(31 downto 0) := (others => '0');
    signal azimuth_n68_skip16 : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n68_part16 : unsigned(15 downto 0) := (others => '0');
    signal azimuth_n68_skip8 : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n68_part8 : unsigned(7 downto 0) := (others => '0');
    signal azimuth_n68_skip4 : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n68_part4 : unsigned(3 downto 0) := (others => '0');
    signal azimuth_n68_skip2 : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n68_part2 : unsigned(1 downto 0) := (others => '0');
    signal azimuth_n68_skip1 : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n68 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal azimuth_n65_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n66_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n67_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n68_s4 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal azimuth_n86_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal azimuth_n69_past : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n69_count : unsigned(4 downto 0) := (others => '0');
    signal azimuth_n69 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal azimuth_n70 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal azimuth_n71_past : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n71_count : unsigned(4 downto 0) := (others => '0');
    signal azimuth_n71 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal azimuth_n72 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal azimuth_n73 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal azimuth_n74 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal azimuth_recip_n75 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal azimuth_n77 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal azimuth_n65_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n66_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal recip_row : unsigned(19 downto 0) := (others => '0');
    signal azimuth_n77_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal azimuth_n86_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s5 : std_logic;
    -- stage 5
    signal azimuth_recip_n76 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n65_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n66_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_recip_n76_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n77_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal azimuth_n86_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s6 : std_logic;
    -- stage 6
    signal azimuth_n78 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal azimuth_n65_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n66_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_n78_s7 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal azimuth_n86_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal azimuth_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal azimuth_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal azimuth_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal azimuth_atan_n80 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal azimuth_n65_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n66_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal atan_row : unsigned(37 downto 0) := (others => '0');
    signal azimuth_n86_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal azimuth_atan_n81 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal azimuth_atan_n82 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal azimuth_n84 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal azimuth_n85 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal azimuth_n66_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal azimuth_atan_n82_s9 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal azimuth_n85_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal azimuth_n86_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal azimuth_n90_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal azimuth_n88 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal azimuth_n89 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal azimuth_n91 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal azimuth_n92 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal azimuth_n93 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal azimuth_n94 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal n125_sum : unsigned(18 downto 0) := (others => '0');
    signal n125_cut : unsigned(16 downto 0) := (others => '0');
    signal n125 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal phi_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal azimuth_n94_s10 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal polar_angle_n97_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s10 : std_logic;
    -- stage 10
    signal azimuth_n95_sum : unsigned(39 downto 0) := (others => '0');
    signal azimuth_n95_cut : unsigned(21 downto 0) := (others => '0');
    signal azimuth_n95_over : unsigned(0 downto 0) := (others => '0');
    signal azimuth_n95 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal n96_over : unsigned(0 downto 0) := (others => '0');
    signal n96_under : unsigned(0 downto 0) := (others => '0');
    signal n96 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal polar_angle_n98_neg : unsigned(19 downto 0) := (others => '0');
    signal polar_angle_n98 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n121 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n97_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n98_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n118_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s11 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s11 : std_logic;
    -- stage 11
    signal polar_angle_n99 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n100 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n101 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n102_padded : unsigned(31 downto 0) := (others => '0');
    signal polar_angle_n102_skip16 : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n102_part16 : unsigned(15 downto 0) := (others => '0');
    signal polar_angle_n102_skip8 : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n102_part8 : unsigned(7 downto 0) := (others => '0');
    signal polar_angle_n102_skip4 : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n102_part4 : unsigned(3 downto 0) := (others => '0');
    signal polar_angle_n102_skip2 : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n102_part2 : unsigned(1 downto 0) := (others => '0');
    signal polar_angle_n102_skip1 : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n102 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal polar_angle_n99_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n100_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n101_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n102_s12 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal polar_angle_n118_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s12 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s12 : std_logic;
    -- stage 12
    signal polar_angle_n103_past : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n103_count : unsigned(4 downto 0) := (others => '0');
    signal polar_angle_n103 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal polar_angle_n104 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal polar_angle_n105_past : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_n105_count : unsigned(4 downto 0) := (others => '0');
    signal polar_angle_n105 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal polar_angle_n106 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal polar_angle_n107 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal polar_angle_n108 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal polar_angle_recip_n109 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal polar_angle_n111 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal polar_angle_n99_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal recip_row_2 : unsigned(19 downto 0) := (others => '0');
    signal polar_angle_n111_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal polar_angle_n118_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s13 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s13 : std_logic;
    -- stage 13
    signal polar_angle_recip_n110 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n99_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_recip_n110_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal polar_angle_n111_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal polar_angle_n118_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s14 : std_logic;
    -- stage 14
    signal polar_angle_n112 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal polar_angle_n99_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n112_s15 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal polar_angle_n118_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s15 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s15 : std_logic;
    -- stage 15
    signal polar_angle_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal polar_angle_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal polar_angle_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal polar_angle_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal polar_angle_atan_n114 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal polar_angle_n99_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal atan_row_2 : unsigned(37 downto 0) := (others => '0');
    signal polar_angle_n118_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s16 : std_logic;
    -- stage 16
    signal polar_angle_atan_n115 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal polar_angle_n116 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal polar_angle_n117 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal polar_angle_n117_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal polar_angle_n118_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal polar_angle_n121_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_next_s17 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s17 : std_logic;
    -- stage 17
    signal polar_angle_n119 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal polar_angle_n120 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal polar_angle_n122 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal polar_angle_n123 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal polar_angle_n124 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n127_sum : unsigned(18 downto 0) := (others => '0');
    signal n127_cut : unsigned(16 downto 0) := (others => '0');
    signal n127 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal theta_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s18 : std_logic;
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
    azimuth_n83 <= 19x"10000";
    azimuth_n87 <= 19x"20000";

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
    azimuth_n63_neg <= unsigned(-x);
    azimuth_n63 <= azimuth_n63_neg when x(19) = '1' else unsigned(x);
    azimuth_n64_neg <= unsigned(-y);
    azimuth_n64 <= azimuth_n64_neg when y(19) = '1' else unsigned(y);
    azimuth_n86 <= unsigned(x(19 downto 19));
    azimuth_n90 <= unsigned(y(19 downto 19));
    -- polar_angle
    polar_angle_n97_neg <= unsigned(-z);
    polar_angle_n97 <= polar_angle_n97_neg when z(19) = '1' else unsigned(z);
    polar_angle_n118 <= unsigned(z(19 downto 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n63_s3 <= azimuth_n63;
                azimuth_n64_s3 <= azimuth_n64;
                azimuth_n86_s3 <= azimuth_n86;
                azimuth_n90_s3 <= azimuth_n90;
                polar_angle_n97_s3 <= polar_angle_n97;
                polar_angle_n118_s3 <= polar_angle_n118;
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
    azimuth_n65 <= "1" when azimuth_n63_s3 < azimuth_n64_s3 else "0";
    azimuth_n66 <= azimuth_n64_s3 when azimuth_n65(0) = '1' else azimuth_n63_s3;
    azimuth_n67 <= azimuth_n63_s3 when azimuth_n65(0) = '1' else azimuth_n64_s3;
    azimuth_n68_padded <= azimuth_n66 & 12x"fff";
    azimuth_n68_skip16 <= "1" when azimuth_n68_padded(31 downto 16) = 16x"0000" else "0";
    azimuth_n68_part16 <= azimuth_n68_padded(15 downto 0) when azimuth_n68_skip16(0) = '1' else azimuth_n68_padded(31 downto 16);
    azimuth_n68_skip8 <= "1" when azimuth_n68_part16(15 downto 8) = 8x"00" else "0";
    azimuth_n68_part8 <= azimuth_n68_part16(7 downto 0) when azimuth_n68_skip8(0) = '1' else azimuth_n68_part16(15 downto 8);
    azimuth_n68_skip4 <= "1" when azimuth_n68_part8(7 downto 4) = 4x"0" else "0";
    azimuth_n68_part4 <= azimuth_n68_part8(3 downto 0) when azimuth_n68_skip4(0) = '1' else azimuth_n68_part8(7 downto 4);
    azimuth_n68_skip2 <= "1" when azimuth_n68_part4(3 downto 2) = "00" else "0";
    azimuth_n68_part2 <= azimuth_n68_part4(1 downto 0) when azimuth_n68_skip2(0) = '1' else azimuth_n68_part4(3 downto 2);
    azimuth_n68_skip1 <= "1" when azimuth_n68_part2(1 downto 1) = "0" else "0";
    azimuth_n68 <= azimuth_n68_skip16 & azimuth_n68_skip8 & azimuth_n68_skip4 & azimuth_n68_skip2 & azimuth_n68_skip1;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n65_s4 <= azimuth_n65;
                azimuth_n66_s4 <= azimuth_n66;
                azimuth_n67_s4 <= azimuth_n67;
                azimuth_n68_s4 <= azimuth_n68;
                azimuth_n86_s4 <= azimuth_n86_s3;
                azimuth_n90_s4 <= azimuth_n90_s3;
                polar_angle_n97_s4 <= polar_angle_n97_s3;
                polar_angle_n118_s4 <= polar_angle_n118_s3;
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
    azimuth_n69_past <= "1" when 5x"14" < azimuth_n68_s4 else "0";
    azimuth_n69_count <= 5x"14" when azimuth_n69_past(0) = '1' else azimuth_n68_s4;
    azimuth_n69 <= shift_left(resize(azimuth_n66_s4, 40), to_integer(azimuth_n69_count));
    azimuth_n70 <= azimuth_n69(19 downto 0);
    azimuth_n71_past <= "1" when 5x"14" < azimuth_n68_s4 else "0";
    azimuth_n71_count <= 5x"14" when azimuth_n71_past(0) = '1' else azimuth_n68_s4;
    azimuth_n71 <= shift_left(resize(azimuth_n67_s4, 40), to_integer(azimuth_n71_count));
    azimuth_n72 <= azimuth_n71(19 downto 0);
    azimuth_n73 <= azimuth_n70(18 downto 0);
    azimuth_n74 <= azimuth_n73;
    -- azimuth.recip
    azimuth_recip_n75 <= azimuth_n74(18 downto 9);
    -- azimuth
    azimuth_n77 <= azimuth_n72;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n65_s5 <= azimuth_n65_s4;
                azimuth_n66_s5 <= azimuth_n66_s4;
                recip_row <= recip_rom(to_integer(azimuth_recip_n75));
                azimuth_n77_s5 <= azimuth_n77;
                azimuth_n86_s5 <= azimuth_n86_s4;
                azimuth_n90_s5 <= azimuth_n90_s4;
                polar_angle_n97_s5 <= polar_angle_n97_s4;
                polar_angle_n118_s5 <= polar_angle_n118_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- azimuth.recip
    azimuth_recip_n76 <= recip_row;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n65_s6 <= azimuth_n65_s5;
                azimuth_n66_s6 <= azimuth_n66_s5;
                azimuth_recip_n76_s6 <= azimuth_recip_n76;
                azimuth_n77_s6 <= azimuth_n77_s5;
                azimuth_n86_s6 <= azimuth_n86_s5;
                azimuth_n90_s6 <= azimuth_n90_s5;
                polar_angle_n97_s6 <= polar_angle_n97_s5;
                polar_angle_n118_s6 <= polar_angle_n118_s5;
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
    azimuth_n78 <= azimuth_n77_s6 * azimuth_recip_n76_s6;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n65_s7 <= azimuth_n65_s6;
                azimuth_n66_s7 <= azimuth_n66_s6;
                azimuth_n78_s7 <= azimuth_n78;
                azimuth_n86_s7 <= azimuth_n86_s6;
                azimuth_n90_s7 <= azimuth_n90_s6;
                polar_angle_n97_s7 <= polar_angle_n97_s6;
                polar_angle_n118_s7 <= polar_angle_n118_s6;
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
    azimuth_ratio_sum <= resize(azimuth_n78_s7, 41) + 41x"00000080000";
    azimuth_ratio_cut <= azimuth_ratio_sum(40 downto 20);
    azimuth_ratio_over <= "1" when (or azimuth_ratio_cut(20 downto 18)) = '1' else "0";
    azimuth_ratio <= 18x"3ffff" when azimuth_ratio_over(0) = '1' else azimuth_ratio_cut(17 downto 0);
    -- azimuth.atan
    azimuth_atan_n80 <= azimuth_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n65_s8 <= azimuth_n65_s7;
                azimuth_n66_s8 <= azimuth_n66_s7;
                atan_row <= atan_rom(to_integer(azimuth_atan_n80));
                azimuth_n86_s8 <= azimuth_n86_s7;
                azimuth_n90_s8 <= azimuth_n90_s7;
                polar_angle_n97_s8 <= polar_angle_n97_s7;
                polar_angle_n118_s8 <= polar_angle_n118_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- azimuth.atan
    azimuth_atan_n81 <= atan_row(37 downto 19);
    azimuth_atan_n82 <= atan_row(18 downto 0);
    -- azimuth
    azimuth_n84 <= signed(resize(azimuth_n83, 20)) - signed(resize(azimuth_atan_n81, 20));
    azimuth_n85 <= azimuth_n84 when azimuth_n65_s8(0) = '1' else signed(resize(azimuth_atan_n81, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n66_s9 <= azimuth_n66_s8;
                azimuth_atan_n82_s9 <= azimuth_atan_n82;
                azimuth_n85_s9 <= azimuth_n85;
                azimuth_n86_s9 <= azimuth_n86_s8;
                azimuth_n90_s9 <= azimuth_n90_s8;
                polar_angle_n97_s9 <= polar_angle_n97_s8;
                polar_angle_n118_s9 <= polar_angle_n118_s8;
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
    azimuth_n88 <= signed(resize(azimuth_n87, 21)) - resize(azimuth_n85_s9, 21);
    azimuth_n89 <= azimuth_n88 when azimuth_n86_s9(0) = '1' else resize(azimuth_n85_s9, 21);
    azimuth_n91 <= -resize(azimuth_n89, 22);
    azimuth_n92 <= azimuth_n91 when azimuth_n90_s9(0) = '1' else resize(azimuth_n89, 22);
    azimuth_n93 <= unsigned(azimuth_n92(17 downto 0));
    azimuth_n94 <= azimuth_n66_s9 * azimuth_atan_n82_s9;
    -- (unit)
    n125_sum <= resize(azimuth_n93, 19) + 19x"00002";
    n125_cut <= n125_sum(18 downto 2);
    n125 <= n125_cut;
    phi_next <= n125(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                azimuth_n94_s10 <= azimuth_n94;
                polar_angle_n97_s10 <= polar_angle_n97_s9;
                polar_angle_n118_s10 <= polar_angle_n118_s9;
                phi_next_s10 <= phi_next;
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
    azimuth_n95_sum <= resize(azimuth_n94_s10, 40) + 40x"0000020000";
    azimuth_n95_cut <= azimuth_n95_sum(39 downto 18);
    azimuth_n95_over <= "1" when (or azimuth_n95_cut(21 downto 20)) = '1' else "0";
    azimuth_n95 <= 21x"0fffff" when azimuth_n95_over(0) = '1' else signed(azimuth_n95_cut(20 downto 0));
    -- (unit)
    n96_over <= "1" when azimuth_n95(20) = '0' and (or azimuth_n95(19 downto 19)) = '1' else "0";
    n96_under <= "1" when azimuth_n95(20) = '1' and (and azimuth_n95(19 downto 19)) = '0' else "0";
    n96 <= 20x"7ffff" when n96_over(0) = '1' else 20x"80000" when n96_under(0) = '1' else azimuth_n95(19 downto 0);
    -- polar_angle
    polar_angle_n98_neg <= unsigned(-n96);
    polar_angle_n98 <= polar_angle_n98_neg when n96(19) = '1' else unsigned(n96);
    polar_angle_n121 <= unsigned(n96(19 downto 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n97_s11 <= polar_angle_n97_s10;
                polar_angle_n98_s11 <= polar_angle_n98;
                polar_angle_n118_s11 <= polar_angle_n118_s10;
                polar_angle_n121_s11 <= polar_angle_n121;
                phi_next_s11 <= phi_next_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- polar_angle
    polar_angle_n99 <= "1" when polar_angle_n97_s11 < polar_angle_n98_s11 else "0";
    polar_angle_n100 <= polar_angle_n98_s11 when polar_angle_n99(0) = '1' else polar_angle_n97_s11;
    polar_angle_n101 <= polar_angle_n97_s11 when polar_angle_n99(0) = '1' else polar_angle_n98_s11;
    polar_angle_n102_padded <= polar_angle_n100 & 12x"fff";
    polar_angle_n102_skip16 <= "1" when polar_angle_n102_padded(31 downto 16) = 16x"0000" else "0";
    polar_angle_n102_part16 <= polar_angle_n102_padded(15 downto 0) when polar_angle_n102_skip16(0) = '1' else polar_angle_n102_padded(31 downto 16);
    polar_angle_n102_skip8 <= "1" when polar_angle_n102_part16(15 downto 8) = 8x"00" else "0";
    polar_angle_n102_part8 <= polar_angle_n102_part16(7 downto 0) when polar_angle_n102_skip8(0) = '1' else polar_angle_n102_part16(15 downto 8);
    polar_angle_n102_skip4 <= "1" when polar_angle_n102_part8(7 downto 4) = 4x"0" else "0";
    polar_angle_n102_part4 <= polar_angle_n102_part8(3 downto 0) when polar_angle_n102_skip4(0) = '1' else polar_angle_n102_part8(7 downto 4);
    polar_angle_n102_skip2 <= "1" when polar_angle_n102_part4(3 downto 2) = "00" else "0";
    polar_angle_n102_part2 <= polar_angle_n102_part4(1 downto 0) when polar_angle_n102_skip2(0) = '1' else polar_angle_n102_part4(3 downto 2);
    polar_angle_n102_skip1 <= "1" when polar_angle_n102_part2(1 downto 1) = "0" else "0";
    polar_angle_n102 <= polar_angle_n102_skip16 & polar_angle_n102_skip8 & polar_angle_n102_skip4 & polar_angle_n102_skip2 & polar_angle_n102_skip1;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n99_s12 <= polar_angle_n99;
                polar_angle_n100_s12 <= polar_angle_n100;
                polar_angle_n101_s12 <= polar_angle_n101;
                polar_angle_n102_s12 <= polar_angle_n102;
                polar_angle_n118_s12 <= polar_angle_n118_s11;
                polar_angle_n121_s12 <= polar_angle_n121_s11;
                phi_next_s12 <= phi_next_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- polar_angle
    polar_angle_n103_past <= "1" when 5x"14" < polar_angle_n102_s12 else "0";
    polar_angle_n103_count <= 5x"14" when polar_angle_n103_past(0) = '1' else polar_angle_n102_s12;
    polar_angle_n103 <= shift_left(resize(polar_angle_n100_s12, 40), to_integer(polar_angle_n103_count));
    polar_angle_n104 <= polar_angle_n103(19 downto 0);
    polar_angle_n105_past <= "1" when 5x"14" < polar_angle_n102_s12 else "0";
    polar_angle_n105_count <= 5x"14" when polar_angle_n105_past(0) = '1' else polar_angle_n102_s12;
    polar_angle_n105 <= shift_left(resize(polar_angle_n101_s12, 40), to_integer(polar_angle_n105_count));
    polar_angle_n106 <= polar_angle_n105(19 downto 0);
    polar_angle_n107 <= polar_angle_n104(18 downto 0);
    polar_angle_n108 <= polar_angle_n107;
    -- polar_angle.recip
    polar_angle_recip_n109 <= polar_angle_n108(18 downto 9);
    -- polar_angle
    polar_angle_n111 <= polar_angle_n106;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n99_s13 <= polar_angle_n99_s12;
                recip_row_2 <= recip_rom(to_integer(polar_angle_recip_n109));
                polar_angle_n111_s13 <= polar_angle_n111;
                polar_angle_n118_s13 <= polar_angle_n118_s12;
                polar_angle_n121_s13 <= polar_angle_n121_s12;
                phi_next_s13 <= phi_next_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- polar_angle.recip
    polar_angle_recip_n110 <= recip_row_2;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n99_s14 <= polar_angle_n99_s13;
                polar_angle_recip_n110_s14 <= polar_angle_recip_n110;
                polar_angle_n111_s14 <= polar_angle_n111_s13;
                polar_angle_n118_s14 <= polar_angle_n118_s13;
                polar_angle_n121_s14 <= polar_angle_n121_s13;
                phi_next_s14 <= phi_next_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- polar_angle
    polar_angle_n112 <= polar_angle_n111_s14 * polar_angle_recip_n110_s14;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n99_s15 <= polar_angle_n99_s14;
                polar_angle_n112_s15 <= polar_angle_n112;
                polar_angle_n118_s15 <= polar_angle_n118_s14;
                polar_angle_n121_s15 <= polar_angle_n121_s14;
                phi_next_s15 <= phi_next_s14;
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
    polar_angle_ratio_sum <= resize(polar_angle_n112_s15, 41) + 41x"00000080000";
    polar_angle_ratio_cut <= polar_angle_ratio_sum(40 downto 20);
    polar_angle_ratio_over <= "1" when (or polar_angle_ratio_cut(20 downto 18)) = '1' else "0";
    polar_angle_ratio <= 18x"3ffff" when polar_angle_ratio_over(0) = '1' else polar_angle_ratio_cut(17 downto 0);
    -- polar_angle.atan
    polar_angle_atan_n114 <= polar_angle_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n99_s16 <= polar_angle_n99_s15;
                atan_row_2 <= atan_rom(to_integer(polar_angle_atan_n114));
                polar_angle_n118_s16 <= polar_angle_n118_s15;
                polar_angle_n121_s16 <= polar_angle_n121_s15;
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
    -- polar_angle.atan
    polar_angle_atan_n115 <= atan_row_2(37 downto 19);
    -- polar_angle
    polar_angle_n116 <= signed(resize(azimuth_n83, 20)) - signed(resize(polar_angle_atan_n115, 20));
    polar_angle_n117 <= polar_angle_n116 when polar_angle_n99_s16(0) = '1' else signed(resize(polar_angle_atan_n115, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                polar_angle_n117_s17 <= polar_angle_n117;
                polar_angle_n118_s17 <= polar_angle_n118_s16;
                polar_angle_n121_s17 <= polar_angle_n121_s16;
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
    polar_angle_n119 <= signed(resize(azimuth_n87, 21)) - resize(polar_angle_n117_s17, 21);
    polar_angle_n120 <= polar_angle_n119 when polar_angle_n118_s17(0) = '1' else resize(polar_angle_n117_s17, 21);
    polar_angle_n122 <= -resize(polar_angle_n120, 22);
    polar_angle_n123 <= polar_angle_n122 when polar_angle_n121_s17(0) = '1' else resize(polar_angle_n120, 22);
    polar_angle_n124 <= unsigned(polar_angle_n123(17 downto 0));
    -- (unit)
    n127_sum <= resize(polar_angle_n124, 19) + 19x"00002";
    n127_cut <= n127_sum(18 downto 2);
    n127 <= n127_cut;
    theta_next <= n127(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi <= phi_next_s17;
                theta <= theta_next;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----

    valid_out <= valid_s18;
end architecture;
