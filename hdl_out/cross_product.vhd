-- cross_product: cross product: six exact products, three differences, one rounding each
-- made by fixpath 0.1.0; seed 002 (GL_NV_texgen_emboss): B = N x CT, T = BN x N; in formats of any width
--   v_bits=16 v_frac_bits=14 w_bits=16 w_frac_bits=14 out_bits=24 out_frac_bits=18
--   overflow=saturate rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 2 cycles, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   x: mean 9.48e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=20649 v_y=-26028 v_z=2820 w_x=-23798 w_y=-24668 w_z=-11884
--   y: mean 9.45e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-21854 v_y=9541 v_z=17626 w_x=-14940 w_y=-27950 w_z=-11372
--   z: mean 9.46e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-23936 v_y=12028 v_z=-25780 w_x=-29216 w_y=23561 w_z=-20909
-- stated bound on each result: 1.91e-6
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity cross_product is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        v_x : in signed(15 downto 0); -- s16f14
        v_y : in signed(15 downto 0); -- s16f14
        v_z : in signed(15 downto 0); -- s16f14
        w_x : in signed(15 downto 0); -- s16f14
        w_y : in signed(15 downto 0); -- s16f14
        w_z : in signed(15 downto 0); -- s16f14
        valid_out : out std_logic;
        x : out signed(23 downto 0) := (others => '0'); -- s24f18
        y : out signed(23 downto 0) := (others => '0'); -- s24f18
        z : out signed(23 downto 0) := (others => '0') -- s24f18
    );
end entity;

architecture rtl of cross_product is
    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal products_n6 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n7 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n9 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n10 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n12 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n13 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n6_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n7_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n9_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n10_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n12_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal products_n13_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal valid_s1 : std_logic;
    -- stage 1
    signal products_n8 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal products_n11 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal products_n14 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal n15_sum : signed(33 downto 0) := (others => '0');
    signal n15_cut : signed(23 downto 0) := (others => '0');
    signal n15 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal n16_sum : signed(33 downto 0) := (others => '0');
    signal n16_cut : signed(23 downto 0) := (others => '0');
    signal n16 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal n17_sum : signed(33 downto 0) := (others => '0');
    signal n17_cut : signed(23 downto 0) := (others => '0');
    signal n17 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal valid_s2 : std_logic;
begin

    -- ---- stage 0 ----
    -- products
    products_n6 <= v_y * w_z;
    products_n7 <= v_z * w_y;
    products_n9 <= v_z * w_x;
    products_n10 <= v_x * w_z;
    products_n12 <= v_x * w_y;
    products_n13 <= v_y * w_x;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                products_n6_s1 <= products_n6;
                products_n7_s1 <= products_n7;
                products_n9_s1 <= products_n9;
                products_n10_s1 <= products_n10;
                products_n12_s1 <= products_n12;
                products_n13_s1 <= products_n13;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- products
    products_n8 <= resize(products_n6_s1, 33) - resize(products_n7_s1, 33);
    products_n11 <= resize(products_n9_s1, 33) - resize(products_n10_s1, 33);
    products_n14 <= resize(products_n12_s1, 33) - resize(products_n13_s1, 33);
    -- (unit)
    n15_sum <= resize(products_n8, 34) + 34x"000000200";
    n15_cut <= n15_sum(33 downto 10);
    n15 <= n15_cut;
    n16_sum <= resize(products_n11, 34) + 34x"000000200";
    n16_cut <= n16_sum(33 downto 10);
    n16 <= n16_cut;
    n17_sum <= resize(products_n14, 34) + 34x"000000200";
    n17_cut <= n17_sum(33 downto 10);
    n17 <= n17_cut;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                x <= n15;
                y <= n16;
                z <= n17;
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
