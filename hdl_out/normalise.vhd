-- normalise: block normalisation: three words shifted by the leading zeros of the largest
-- made by fixpath 0.1.0; the light vector of seed 000 (US 6,980,218) in fixed point: a displacement doesn't depend on its length
--   v_bits=16 v_frac_bits=8 norm_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 2 cycles, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   x: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
--   y: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
--   z: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
--   places: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at v_x=-7127 v_y=-10 v_z=-68
-- stated bound on each component: 7.63e-6
-- stated bound on each count and flag: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity normalise is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        v_x : in signed(15 downto 0); -- s16f8
        v_y : in signed(15 downto 0); -- s16f8
        v_z : in signed(15 downto 0); -- s16f8
        valid_out : out std_logic;
        x : out signed(17 downto 0) := (others => '0'); -- s18f17
        y : out signed(17 downto 0) := (others => '0'); -- s18f17
        z : out signed(17 downto 0) := (others => '0'); -- s18f17
        places : out unsigned(3 downto 0) := (others => '0'); -- u4f0
        degenerate : out unsigned(0 downto 0) := (others => '0') -- u1f0
    );
end entity;

architecture rtl of normalise is
    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal block_n3_neg : unsigned(15 downto 0) := (others => '0');
    signal block_n3 : unsigned(15 downto 0) := (others => '0'); -- u16f8
    signal block_n4 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n5_neg : unsigned(15 downto 0) := (others => '0');
    signal block_n5 : unsigned(15 downto 0) := (others => '0'); -- u16f8
    signal block_n6 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n7_neg : unsigned(15 downto 0) := (others => '0');
    signal block_n7 : unsigned(15 downto 0) := (others => '0'); -- u16f8
    signal block_n8 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n9 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n10 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_largest : unsigned(15 downto 0) := (others => '0'); -- u16f8
    signal block_n12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n13 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n14 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal block_n15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n16 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal block_n17 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal block_n18 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n19 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n20 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal block_n21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n22 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal block_n23 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal block_n24 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n25 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n26 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal block_n28 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal block_n29 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal block_n30 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n34 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal block_n37 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n38 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n39 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n40 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n42 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal block_n43 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n59 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n60 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n61 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n62 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal block_n63 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n76 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n77 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n78 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n79 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal block_n80 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n25_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n26_s1 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal block_n30_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n34_s1 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal block_n37_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n40_s1 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n43_s1 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n61_s1 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n63_s1 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n78_s1 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n80_s1 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal valid_s1 : std_logic;
    -- stage 1
    signal block_n27 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n31 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n32 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n33 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n35 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal block_places : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal block_n41 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n44 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n45 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n46 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal block_n47 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n48 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n49 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n50 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal block_n51 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n52 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n53 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal block_n54 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n55 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n56 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n57 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal block_x : signed(16 downto 0) := (others => '0'); -- s17f16
    signal block_n64 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n65 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal block_n66 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n67 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n68 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal block_n69 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n70 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n71 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n72 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n73 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n74 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal block_y : signed(16 downto 0) := (others => '0'); -- s17f16
    signal block_n81 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n82 : unsigned(12 downto 0) := (others => '0'); -- u13f0
    signal block_n83 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n84 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n85 : unsigned(14 downto 0) := (others => '0'); -- u15f0
    signal block_n86 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n87 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n88 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal block_n89 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n90 : unsigned(16 downto 0) := (others => '0'); -- u17f0
    signal block_n91 : signed(16 downto 0) := (others => '0'); -- s17f0
    signal block_z : signed(16 downto 0) := (others => '0'); -- s17f16
    signal norm_x_wide : signed(17 downto 0) := (others => '0');
    signal norm_x : signed(17 downto 0) := (others => '0'); -- s18f17
    signal norm_y_wide : signed(17 downto 0) := (others => '0');
    signal norm_y : signed(17 downto 0) := (others => '0'); -- s18f17
    signal norm_z_wide : signed(17 downto 0) := (others => '0');
    signal norm_z : signed(17 downto 0) := (others => '0'); -- s18f17
    signal n96 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s2 : std_logic;
begin

    -- ---- stage 0 ----
    -- block
    block_n3_neg <= unsigned(-v_x);
    block_n3 <= block_n3_neg when v_x(15) = '1' else unsigned(v_x);
    block_n4 <= block_n3;
    block_n5_neg <= unsigned(-v_y);
    block_n5 <= block_n5_neg when v_y(15) = '1' else unsigned(v_y);
    block_n6 <= block_n5;
    block_n7_neg <= unsigned(-v_z);
    block_n7 <= block_n7_neg when v_z(15) = '1' else unsigned(v_z);
    block_n8 <= block_n7;
    block_n9 <= block_n4 or block_n6;
    block_n10 <= block_n9 or block_n8;
    block_largest <= block_n10;
    block_n12 <= "0";
    block_n13 <= block_largest;
    block_n14 <= block_n13(15 downto 8);
    block_n15 <= "1" when block_n14 = resize(block_n12, 8) else "0";
    block_n16 <= block_n13(7 downto 0);
    block_n17 <= 8x"00";
    block_n18 <= block_n16 & block_n17;
    block_n19 <= block_n18 when block_n15(0) = '1' else block_n13;
    block_n20 <= block_n19(15 downto 12);
    block_n21 <= "1" when block_n20 = resize(block_n12, 4) else "0";
    block_n22 <= block_n19(11 downto 0);
    block_n23 <= 4x"0";
    block_n24 <= block_n22 & block_n23;
    block_n25 <= block_n24 when block_n21(0) = '1' else block_n19;
    block_n26 <= block_n25(15 downto 14);
    block_n28 <= block_n25(13 downto 0);
    block_n29 <= "00";
    block_n30 <= block_n28 & block_n29;
    block_n34 <= block_n15 & block_n21;
    block_n37 <= "1" when block_largest = shift_left(resize(block_n12, 16), 8) else "0";
    block_n38 <= unsigned(v_x(15 downto 15));
    block_n39 <= unsigned(v_x);
    block_n40 <= block_n38 & block_n39;
    block_n42 <= block_n40(8 downto 0);
    block_n43 <= block_n42 & block_n17;
    block_n59 <= unsigned(v_y(15 downto 15));
    block_n60 <= unsigned(v_y);
    block_n61 <= block_n59 & block_n60;
    block_n62 <= block_n61(8 downto 0);
    block_n63 <= block_n62 & block_n17;
    block_n76 <= unsigned(v_z(15 downto 15));
    block_n77 <= unsigned(v_z);
    block_n78 <= block_n76 & block_n77;
    block_n79 <= block_n78(8 downto 0);
    block_n80 <= block_n79 & block_n17;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                block_n25_s1 <= block_n25;
                block_n26_s1 <= block_n26;
                block_n30_s1 <= block_n30;
                block_n34_s1 <= block_n34;
                block_n37_s1 <= block_n37;
                block_n40_s1 <= block_n40;
                block_n43_s1 <= block_n43;
                block_n61_s1 <= block_n61;
                block_n63_s1 <= block_n63;
                block_n78_s1 <= block_n78;
                block_n80_s1 <= block_n80;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- block
    block_n27 <= "1" when block_n26_s1 = resize(block_n12, 2) else "0";
    block_n31 <= block_n30_s1 when block_n27(0) = '1' else block_n25_s1;
    block_n32 <= block_n31(15 downto 15);
    block_n33 <= "1" when block_n32 = block_n12 else "0";
    block_n35 <= block_n34_s1 & block_n27;
    block_places <= block_n35 & block_n33;
    block_n41 <= block_places(3 downto 3);
    block_n44 <= block_n43_s1 when block_n41(0) = '1' else block_n40_s1;
    block_n45 <= block_places(2 downto 2);
    block_n46 <= block_n44(12 downto 0);
    block_n47 <= block_n46 & block_n23;
    block_n48 <= block_n47 when block_n45(0) = '1' else block_n44;
    block_n49 <= block_places(1 downto 1);
    block_n50 <= block_n48(14 downto 0);
    block_n51 <= block_n50 & block_n29;
    block_n52 <= block_n51 when block_n49(0) = '1' else block_n48;
    block_n53 <= block_places(0 downto 0);
    block_n54 <= block_n52(15 downto 0);
    block_n55 <= block_n54 & block_n12;
    block_n56 <= block_n55 when block_n53(0) = '1' else block_n52;
    block_n57 <= signed(block_n56);
    block_x <= block_n57;
    block_n64 <= block_n63_s1 when block_n41(0) = '1' else block_n61_s1;
    block_n65 <= block_n64(12 downto 0);
    block_n66 <= block_n65 & block_n23;
    block_n67 <= block_n66 when block_n45(0) = '1' else block_n64;
    block_n68 <= block_n67(14 downto 0);
    block_n69 <= block_n68 & block_n29;
    block_n70 <= block_n69 when block_n49(0) = '1' else block_n67;
    block_n71 <= block_n70(15 downto 0);
    block_n72 <= block_n71 & block_n12;
    block_n73 <= block_n72 when block_n53(0) = '1' else block_n70;
    block_n74 <= signed(block_n73);
    block_y <= block_n74;
    block_n81 <= block_n80_s1 when block_n41(0) = '1' else block_n78_s1;
    block_n82 <= block_n81(12 downto 0);
    block_n83 <= block_n82 & block_n23;
    block_n84 <= block_n83 when block_n45(0) = '1' else block_n81;
    block_n85 <= block_n84(14 downto 0);
    block_n86 <= block_n85 & block_n29;
    block_n87 <= block_n86 when block_n49(0) = '1' else block_n84;
    block_n88 <= block_n87(15 downto 0);
    block_n89 <= block_n88 & block_n12;
    block_n90 <= block_n89 when block_n53(0) = '1' else block_n87;
    block_n91 <= signed(block_n90);
    block_z <= block_n91;
    -- (unit)
    norm_x_wide <= shift_left(resize(block_x, 18), 1);
    norm_x <= norm_x_wide;
    norm_y_wide <= shift_left(resize(block_y, 18), 1);
    norm_y <= norm_y_wide;
    norm_z_wide <= shift_left(resize(block_z, 18), 1);
    norm_z <= norm_z_wide;
    n96 <= resize(block_n12, 4) when block_n37_s1(0) = '1' else block_places;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                degenerate <= block_n37_s1;
                x <= norm_x;
                y <= norm_y;
                z <= norm_z;
                places <= n96;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----

    valid_out <= valid_s2;
end architecture;
