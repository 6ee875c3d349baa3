-- rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
-- made by fixpath 0.1.0; the inverse square root unit of seed 000 (US 6,980,218, FIG. 8)
--   input_bits=20 input_frac_bits=18 root_int_bits=9 root_scheme=newton root_addr_bits=7
--   root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 10 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   r_relative: mean 1.31e-5, largest seen 9.11e-5 over the result, at a=4
--   r_scaled: mean 1.23e-5, largest seen 9.11e-5 over the result, or 1 where it is less, at a=4
--   r: mean 1.52e-3, largest seen 4.66e-2 (12223.0 ulp) at a=1
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at a=155754
-- stated bound on each relative (over the result): 3.78e-4
-- stated bound on each scaled (over the result, or 1 where it is less): 3.76e-4
-- stated bound on each absolute: 1.91e-1
-- stated bound on each flag: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity rsqrt_newton is
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

architecture rtl of rsqrt_newton is
    attribute rom_style : string;

    -- table recip_root: recip_sqrt u12f10
    type recip_root_rom_rows is array (0 to 127) of unsigned(11 downto 0);
    constant recip_root_rom : recip_root_rom_rows := (
        12x"7f0", 12x"7d2", 12x"7b5", 12x"799",
        12x"77e", 12x"764", 12x"74b", 12x"733",
        12x"71d", 12x"706", 12x"6f1", 12x"6dd",
        12x"6c9", 12x"6b6", 12x"6a3", 12x"691",
        12x"680", 12x"66f", 12x"65e", 12x"64e",
        12x"63f", 12x"630", 12x"621", 12x"613",
        12x"605", 12x"5f8", 12x"5eb", 12x"5de",
        12x"5d1", 12x"5c5", 12x"5b9", 12x"5ae",
        12x"5a3", 12x"598", 12x"58d", 12x"582",
        12x"578", 12x"56e", 12x"564", 12x"55a",
        12x"551", 12x"547", 12x"53e", 12x"535",
        12x"52d", 12x"524", 12x"51c", 12x"513",
        12x"50b", 12x"503", 12x"4fc", 12x"4f4",
        12x"4ec", 12x"4e5", 12x"4de", 12x"4d7",
        12x"4d0", 12x"4c9", 12x"4c2", 12x"4bb",
        12x"4b5", 12x"4ae", 12x"4a8", 12x"4a2",
        12x"49b", 12x"495", 12x"48f", 12x"489",
        12x"484", 12x"47e", 12x"478", 12x"473",
        12x"46d", 12x"468", 12x"463", 12x"45d",
        12x"458", 12x"453", 12x"44e", 12x"449",
        12x"444", 12x"43f", 12x"43b", 12x"436",
        12x"431", 12x"42d", 12x"428", 12x"424",
        12x"41f", 12x"41b", 12x"417", 12x"412",
        12x"40e", 12x"40a", 12x"406", 12x"402",
        12x"3fe", 12x"3fa", 12x"3f6", 12x"3f2",
        12x"3ee", 12x"3eb", 12x"3e7", 12x"3e3",
        12x"3e0", 12x"3dc", 12x"3d8", 12x"3d5",
        12x"3d1", 12x"3ce", 12x"3cb", 12x"3c7",
        12x"3c4", 12x"3c0", 12x"3bd", 12x"3ba",
        12x"3b7", 12x"3b4", 12x"3b0", 12x"3ad",
        12x"3aa", 12x"3a7", 12x"3a4", 12x"3a1",
        12x"39e", 12x"39b", 12x"398", 12x"395"
    );
    attribute rom_style of recip_root_rom : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
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
    signal reciprocal_root_n45 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n53 : unsigned(0 downto 0) := (others => '0'); -- u1e9
    signal reciprocal_root_n54 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n21_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n22_s1 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal reciprocal_root_n26_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n29_s1 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal reciprocal_root_n54_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
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
    signal reciprocal_root_n38 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal reciprocal_root_n39 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal reciprocal_root_recip_root_n40 : unsigned(6 downto 0) := (others => '0'); -- u7f0
    signal reciprocal_root_n30_s2 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n37_s2 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal recip_root_row : unsigned(11 downto 0) := (others => '0');
    signal reciprocal_root_n54_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal reciprocal_root_recip_root_n41 : unsigned(11 downto 0) := (others => '0'); -- u12f10
    signal reciprocal_root_n30_s3 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n37_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal reciprocal_root_recip_root_n41_s3 : unsigned(11 downto 0) := (others => '0'); -- u12f10
    signal reciprocal_root_n54_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal reciprocal_root_n42 : unsigned(31 downto 0) := (others => '0'); -- u32f30
    signal reciprocal_root_n30_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_recip_root_n41_s4 : unsigned(11 downto 0) := (others => '0'); -- u12f10
    signal reciprocal_root_n42_s4 : unsigned(31 downto 0) := (others => '0'); -- u32f30
    signal reciprocal_root_n54_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal reciprocal_root_n43_sum : unsigned(32 downto 0) := (others => '0');
    signal reciprocal_root_n43_cut : unsigned(22 downto 0) := (others => '0');
    signal reciprocal_root_n43_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n43 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_root_n30_s5 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_recip_root_n41_s5 : unsigned(11 downto 0) := (others => '0'); -- u12f10
    signal reciprocal_root_n43_s5 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_root_n54_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s5 : std_logic;
    -- stage 5
    signal reciprocal_root_n44 : unsigned(33 downto 0) := (others => '0'); -- u34f30
    signal reciprocal_root_n30_s6 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_recip_root_n41_s6 : unsigned(11 downto 0) := (others => '0'); -- u12f10
    signal reciprocal_root_n44_s6 : unsigned(33 downto 0) := (others => '0'); -- u34f30
    signal reciprocal_root_n54_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s6 : std_logic;
    -- stage 6
    signal reciprocal_root_n46 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal reciprocal_root_n47_sum : signed(35 downto 0) := (others => '0');
    signal reciprocal_root_n47_cut : signed(25 downto 0) := (others => '0');
    signal reciprocal_root_n47_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n47_under : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n47 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_root_n30_s7 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_recip_root_n41_s7 : unsigned(11 downto 0) := (others => '0'); -- u12f10
    signal reciprocal_root_n47_s7 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_root_n54_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal reciprocal_root_n48 : unsigned(33 downto 0) := (others => '0'); -- u34f30
    signal reciprocal_root_n49 : unsigned(33 downto 0) := (others => '0'); -- u34f31
    signal reciprocal_root_n30_s8 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal reciprocal_root_n49_s8 : unsigned(33 downto 0) := (others => '0'); -- u34f31
    signal reciprocal_root_n54_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal reciprocal_root_n50_sum : unsigned(34 downto 0) := (others => '0');
    signal reciprocal_root_n50_cut : unsigned(23 downto 0) := (others => '0');
    signal reciprocal_root_n50_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n50 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal reciprocal_root_n51_past : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n51_count : unsigned(3 downto 0) := (others => '0');
    signal reciprocal_root_n51 : unsigned(31 downto 0) := (others => '0'); -- u32f20
    signal reciprocal_root_n52 : unsigned(31 downto 0) := (others => '0'); -- u32f21
    signal reciprocal_root_n55 : unsigned(31 downto 0) := (others => '0'); -- u32f21
    signal reciprocal_root_n54_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal reciprocal_root_n55_s9 : unsigned(31 downto 0) := (others => '0'); -- u32f21
    signal valid_s9 : std_logic;
    -- stage 9
    signal reciprocal_root_n56_sum : unsigned(32 downto 0) := (others => '0');
    signal reciprocal_root_n56_cut : unsigned(29 downto 0) := (others => '0');
    signal reciprocal_root_n56_over : unsigned(0 downto 0) := (others => '0');
    signal reciprocal_root_n56 : unsigned(26 downto 0) := (others => '0'); -- u27f18
    signal n57 : unsigned(26 downto 0) := (others => '0'); -- u27f18
    signal valid_s10 : std_logic;
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
    reciprocal_root_n45 <= "11";
    reciprocal_root_n53 <= "1";
    reciprocal_root_n54 <= "1" when a = shift_left(resize(reciprocal_root_n2, 20), 18) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n21_s1 <= reciprocal_root_n21;
                reciprocal_root_n22_s1 <= reciprocal_root_n22;
                reciprocal_root_n26_s1 <= reciprocal_root_n26;
                reciprocal_root_n29_s1 <= reciprocal_root_n29;
                reciprocal_root_n54_s1 <= reciprocal_root_n54;
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
    reciprocal_root_n36 <= reciprocal_root_n27;
    reciprocal_root_n37 <= reciprocal_root_n36;
    reciprocal_root_n38 <= reciprocal_root_n34 & reciprocal_root_n35;
    reciprocal_root_n39 <= reciprocal_root_n38;
    -- reciprocal_root.recip_root
    reciprocal_root_recip_root_n40 <= reciprocal_root_n39(19 downto 13);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s2 <= reciprocal_root_n30;
                reciprocal_root_n37_s2 <= reciprocal_root_n37;
                recip_root_row <= recip_root_rom(to_integer(reciprocal_root_recip_root_n40));
                reciprocal_root_n54_s2 <= reciprocal_root_n54_s1;
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
    reciprocal_root_recip_root_n41 <= recip_root_row;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s3 <= reciprocal_root_n30_s2;
                reciprocal_root_n37_s3 <= reciprocal_root_n37_s2;
                reciprocal_root_recip_root_n41_s3 <= reciprocal_root_recip_root_n41;
                reciprocal_root_n54_s3 <= reciprocal_root_n54_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- reciprocal_root
    reciprocal_root_n42 <= reciprocal_root_n37_s3 * reciprocal_root_recip_root_n41_s3;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s4 <= reciprocal_root_n30_s3;
                reciprocal_root_recip_root_n41_s4 <= reciprocal_root_recip_root_n41_s3;
                reciprocal_root_n42_s4 <= reciprocal_root_n42;
                reciprocal_root_n54_s4 <= reciprocal_root_n54_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- reciprocal_root
    reciprocal_root_n43_sum <= resize(reciprocal_root_n42_s4, 33) + 33x"000000200";
    reciprocal_root_n43_cut <= reciprocal_root_n43_sum(32 downto 10);
    reciprocal_root_n43_over <= "1" when (or reciprocal_root_n43_cut(22 downto 22)) = '1' else "0";
    reciprocal_root_n43 <= 22x"3fffff" when reciprocal_root_n43_over(0) = '1' else reciprocal_root_n43_cut(21 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s5 <= reciprocal_root_n30_s4;
                reciprocal_root_recip_root_n41_s5 <= reciprocal_root_recip_root_n41_s4;
                reciprocal_root_n43_s5 <= reciprocal_root_n43;
                reciprocal_root_n54_s5 <= reciprocal_root_n54_s4;
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
    reciprocal_root_n44 <= reciprocal_root_n43_s5 * reciprocal_root_recip_root_n41_s5;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s6 <= reciprocal_root_n30_s5;
                reciprocal_root_recip_root_n41_s6 <= reciprocal_root_recip_root_n41_s5;
                reciprocal_root_n44_s6 <= reciprocal_root_n44;
                reciprocal_root_n54_s6 <= reciprocal_root_n54_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- reciprocal_root
    reciprocal_root_n46 <= signed(shift_left(resize(reciprocal_root_n45, 35), 30)) - signed(resize(reciprocal_root_n44_s6, 35));
    reciprocal_root_n47_sum <= resize(reciprocal_root_n46, 36) + 36x"000000200";
    reciprocal_root_n47_cut <= reciprocal_root_n47_sum(35 downto 10);
    reciprocal_root_n47_over <= "1" when reciprocal_root_n47_cut(25) = '0' and (or reciprocal_root_n47_cut(24 downto 22)) = '1' else "0";
    reciprocal_root_n47_under <= unsigned(reciprocal_root_n47_cut(25 downto 25));
    reciprocal_root_n47 <= 22x"3fffff" when reciprocal_root_n47_over(0) = '1' else 22x"000000" when reciprocal_root_n47_under(0) = '1' else unsigned(reciprocal_root_n47_cut(21 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s7 <= reciprocal_root_n30_s6;
                reciprocal_root_recip_root_n41_s7 <= reciprocal_root_recip_root_n41_s6;
                reciprocal_root_n47_s7 <= reciprocal_root_n47;
                reciprocal_root_n54_s7 <= reciprocal_root_n54_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- reciprocal_root
    reciprocal_root_n48 <= reciprocal_root_recip_root_n41_s7 * reciprocal_root_n47_s7;
    reciprocal_root_n49 <= reciprocal_root_n48;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n30_s8 <= reciprocal_root_n30_s7;
                reciprocal_root_n49_s8 <= reciprocal_root_n49;
                reciprocal_root_n54_s8 <= reciprocal_root_n54_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- reciprocal_root
    reciprocal_root_n50_sum <= resize(reciprocal_root_n49_s8, 35) + 35x"000000400";
    reciprocal_root_n50_cut <= reciprocal_root_n50_sum(34 downto 11);
    reciprocal_root_n50_over <= "1" when (or reciprocal_root_n50_cut(23 downto 22)) = '1' else "0";
    reciprocal_root_n50 <= 22x"3fffff" when reciprocal_root_n50_over(0) = '1' else reciprocal_root_n50_cut(21 downto 0);
    reciprocal_root_n51_past <= "1" when 4x"a" < reciprocal_root_n30_s8 else "0";
    reciprocal_root_n51_count <= 4x"a" when reciprocal_root_n51_past(0) = '1' else reciprocal_root_n30_s8;
    reciprocal_root_n51 <= shift_left(resize(reciprocal_root_n50, 32), to_integer(reciprocal_root_n51_count));
    reciprocal_root_n52 <= reciprocal_root_n51;
    reciprocal_root_n55 <= shift_left(resize(reciprocal_root_n53, 32), 30) when reciprocal_root_n54_s8(0) = '1' else reciprocal_root_n52;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                reciprocal_root_n54_s9 <= reciprocal_root_n54_s8;
                reciprocal_root_n55_s9 <= reciprocal_root_n55;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- reciprocal_root
    reciprocal_root_n56_sum <= resize(reciprocal_root_n55_s9, 33) + 33x"000000004";
    reciprocal_root_n56_cut <= reciprocal_root_n56_sum(32 downto 3);
    reciprocal_root_n56_over <= "1" when (or reciprocal_root_n56_cut(29 downto 27)) = '1' else "0";
    reciprocal_root_n56 <= 27x"7ffffff" when reciprocal_root_n56_over(0) = '1' else reciprocal_root_n56_cut(26 downto 0);
    -- (unit)
    n57 <= shift_left(resize(reciprocal_root_n2, 27), 18) when reciprocal_root_n54_s9(0) = '1' else reciprocal_root_n56;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                degenerate <= reciprocal_root_n54_s9;
                r <= n57;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----

    valid_out <= valid_s10;
end architecture;
