-- sampler: texels and fractions of texture coordinates, nearest or bilinear, wrapped or clamped
-- made by fixpath 0.1.0; seed 000 (US 6,980,218), texture look-ups of the emboss; texel centres as in OpenGL
--   filter=bilinear address_s=wrap address_t=wrap int_bits=4 frac_bits=20 log2_width=9
--   log2_height=9 fraction_bits=8 period_ps=5000 stages=auto rom=block
-- latency 1 cycle, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   i0: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
--   i1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
--   a: mean 1.71e-3, largest seen 3.42e-3 (0.9 ulp) at s=-3629073 t=8031806
--   j0: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
--   j1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at s=11969441 t=-12161653
--   b: mean 1.71e-3, largest seen 3.42e-3 (0.9 ulp) at s=4664360 t=-2354817
-- stated bound on each texel: 0.00e0
-- stated bound on each fraction: 3.42e-3
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity sampler is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        s : in signed(24 downto 0); -- s25f20
        t : in signed(24 downto 0); -- s25f20
        valid_out : out std_logic;
        i0 : out unsigned(8 downto 0) := (others => '0'); -- u9f0
        i1 : out unsigned(8 downto 0) := (others => '0'); -- u9f0
        a : out unsigned(7 downto 0) := (others => '0'); -- u8f8
        j0 : out unsigned(8 downto 0) := (others => '0'); -- u9f0
        j1 : out unsigned(8 downto 0) := (others => '0'); -- u9f0
        b : out unsigned(7 downto 0) := (others => '0') -- u8f8
    );
end entity;

architecture rtl of sampler is
    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal u_n2 : signed(24 downto 0) := (others => '0'); -- s25f11
    signal u_n3 : unsigned(0 downto 0) := (others => '0'); -- u1f1
    signal u_n4 : signed(25 downto 0) := (others => '0'); -- s26f11
    signal u_n5_cut : signed(14 downto 0) := (others => '0');
    signal u_n5 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal u_n6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal u_n7 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal u_position_cut : signed(22 downto 0) := (others => '0');
    signal u_position : signed(22 downto 0) := (others => '0'); -- s23f8
    signal u_a : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal u_i0 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal u_i1 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal v_n12 : signed(24 downto 0) := (others => '0'); -- s25f11
    signal v_n13 : signed(25 downto 0) := (others => '0'); -- s26f11
    signal v_n14_cut : signed(14 downto 0) := (others => '0');
    signal v_n14 : signed(14 downto 0) := (others => '0'); -- s15f0
    signal v_n15 : signed(15 downto 0) := (others => '0'); -- s16f0
    signal v_position_cut : signed(22 downto 0) := (others => '0');
    signal v_position : signed(22 downto 0) := (others => '0'); -- s23f8
    signal v_b : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal v_j0 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal v_j1 : unsigned(8 downto 0) := (others => '0'); -- u9f0
    signal valid_s1 : std_logic;
begin

    -- ---- stage 0 ----
    -- u
    u_n2 <= s;
    u_n3 <= "1";
    u_n4 <= resize(u_n2, 26) - signed(shift_left(resize(u_n3, 26), 10));
    u_n5_cut <= u_n4(25 downto 11);
    u_n5 <= u_n5_cut;
    u_n6 <= "1";
    u_n7 <= resize(u_n5, 16) + signed(resize(u_n6, 16));
    u_position_cut <= u_n4(25 downto 3);
    u_position <= u_position_cut;
    u_a <= unsigned(u_position(7 downto 0));
    u_i0 <= unsigned(u_n5(8 downto 0));
    u_i1 <= unsigned(u_n7(8 downto 0));
    -- v
    v_n12 <= t;
    v_n13 <= resize(v_n12, 26) - signed(shift_left(resize(u_n3, 26), 10));
    v_n14_cut <= v_n13(25 downto 11);
    v_n14 <= v_n14_cut;
    v_n15 <= resize(v_n14, 16) + signed(resize(u_n6, 16));
    v_position_cut <= v_n13(25 downto 3);
    v_position <= v_position_cut;
    v_b <= unsigned(v_position(7 downto 0));
    v_j0 <= unsigned(v_n14(8 downto 0));
    v_j1 <= unsigned(v_n15(8 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                a <= u_a;
                i0 <= u_i0;
                i1 <= u_i1;
                b <= v_b;
                j0 <= v_j0;
                j1 <= v_j1;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----

    valid_out <= valid_s1;
end architecture;
