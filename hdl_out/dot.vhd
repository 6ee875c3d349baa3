-- dot: dot product of three: exact products and sums, one rounding
-- made by fixpath 0.1.0; the vector dot units of seed 000 (US 6,980,218, FIG. 8), in formats of any width
--   v_bits=16 v_frac_bits=14 w_bits=16 w_frac_bits=14 out_bits=24 out_frac_bits=18
--   overflow=saturate rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 3 cycles, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   dot_product: mean 9.56e-7, largest seen 1.91e-6 (0.5 ulp) at v_x=-62 v_y=-9 v_z=-2277 w_x=-2863 w_y=-7 w_z=13
-- stated bound on each result: 1.91e-6
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity dot is
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
        dot_product : out signed(23 downto 0) := (others => '0') -- s24f18
    );
end entity;

architecture rtl of dot is
    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal v_dot_w_n6 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal v_dot_w_n7 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal v_dot_w_n8 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal v_dot_w_n6_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal v_dot_w_n7_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal v_dot_w_n8_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal valid_s1 : std_logic;
    -- stage 1
    signal v_dot_w_n9 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal v_dot_w_n10 : signed(33 downto 0) := (others => '0'); -- s34f28
    signal v_dot_w_n10_s2 : signed(33 downto 0) := (others => '0'); -- s34f28
    signal valid_s2 : std_logic;
    -- stage 2
    signal n11_sum : signed(34 downto 0) := (others => '0');
    signal n11_cut : signed(24 downto 0) := (others => '0');
    signal n11_over : unsigned(0 downto 0) := (others => '0');
    signal n11 : signed(23 downto 0) := (others => '0'); -- s24f18
    signal valid_s3 : std_logic;
begin

    -- ---- stage 0 ----
    -- v_dot_w
    v_dot_w_n6 <= v_x * w_x;
    v_dot_w_n7 <= v_y * w_y;
    v_dot_w_n8 <= v_z * w_z;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                v_dot_w_n6_s1 <= v_dot_w_n6;
                v_dot_w_n7_s1 <= v_dot_w_n7;
                v_dot_w_n8_s1 <= v_dot_w_n8;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- v_dot_w
    v_dot_w_n9 <= resize(v_dot_w_n6_s1, 33) + resize(v_dot_w_n7_s1, 33);
    v_dot_w_n10 <= resize(v_dot_w_n9, 34) + resize(v_dot_w_n8_s1, 34);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                v_dot_w_n10_s2 <= v_dot_w_n10;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    n11_sum <= resize(v_dot_w_n10_s2, 35) + 35x"000000200";
    n11_cut <= n11_sum(34 downto 10);
    n11_over <= "1" when n11_cut(24) = '0' and (or n11_cut(23 downto 23)) = '1' else "0";
    n11 <= 24x"7fffff" when n11_over(0) = '1' else n11_cut(23 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_product <= n11;
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
