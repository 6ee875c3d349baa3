-- combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
-- made by fixpath 0.1.0; seed 000 (US 6,980,218), the texture combination of the emboss; seed 003 has the same text
--   filter=bilinear lights=1 difference=undisplaced-displaced channel_bits=8 fraction_bits=8
--   guard_bits=4 gain_log2=0 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 4 cycles, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   out_r: mean 1.94e-1, largest seen 5.91e-1 (0.6 ulp) at h_00=188 h_10=50 h_01=155 h_11=31 h_a=110 h_b=236 d0_00=43 d0_10=113 d0_01=189 d0_11=244 d0_a=153 d0_b=59 r=146 g=32 b=19
--   out_g: mean 1.95e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
--   out_b: mean 1.94e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
-- stated bound on each channel: 6.25e-1
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity combine is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        h_00 : in unsigned(7 downto 0); -- u8f0
        h_10 : in unsigned(7 downto 0); -- u8f0
        h_01 : in unsigned(7 downto 0); -- u8f0
        h_11 : in unsigned(7 downto 0); -- u8f0
        h_a : in unsigned(7 downto 0); -- u8f8
        h_b : in unsigned(7 downto 0); -- u8f8
        d0_00 : in unsigned(7 downto 0); -- u8f0
        d0_10 : in unsigned(7 downto 0); -- u8f0
        d0_01 : in unsigned(7 downto 0); -- u8f0
        d0_11 : in unsigned(7 downto 0); -- u8f0
        d0_a : in unsigned(7 downto 0); -- u8f8
        d0_b : in unsigned(7 downto 0); -- u8f8
        r : in unsigned(7 downto 0); -- u8f0
        g : in unsigned(7 downto 0); -- u8f0
        b : in unsigned(7 downto 0); -- u8f0
        valid_out : out std_logic;
        out_r : out unsigned(7 downto 0) := (others => '0'); -- u8f0
        out_g : out unsigned(7 downto 0) := (others => '0'); -- u8f0
        out_b : out unsigned(7 downto 0) := (others => '0') -- u8f0
    );
end entity;

architecture rtl of combine is
    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal h_n15 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal h_n16 : signed(16 downto 0) := (others => '0'); -- s17f8
    signal h_n17 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal h_n19 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal h_n20 : signed(16 downto 0) := (others => '0'); -- s17f8
    signal h_n21 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal d0_n27 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal d0_n28 : signed(16 downto 0) := (others => '0'); -- s17f8
    signal d0_n29 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal d0_n31 : signed(8 downto 0) := (others => '0'); -- s9f0
    signal d0_n32 : signed(16 downto 0) := (others => '0'); -- s17f8
    signal d0_n33 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal n40 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal n43 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal h_b_s1 : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal d0_b_s1 : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal r_s1 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal g_s1 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal b_s1 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal h_n17_s1 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal h_n21_s1 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal d0_n29_s1 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal d0_n33_s1 : signed(17 downto 0) := (others => '0'); -- s18f8
    signal valid_s1 : std_logic;
    -- stage 1
    signal h_n18_sum : signed(18 downto 0) := (others => '0');
    signal h_n18_cut : signed(14 downto 0) := (others => '0');
    signal h_n18 : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal h_n22_sum : signed(18 downto 0) := (others => '0');
    signal h_n22_cut : signed(14 downto 0) := (others => '0');
    signal h_n22 : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal h_n23 : signed(12 downto 0) := (others => '0'); -- s13f4
    signal h_n24 : signed(20 downto 0) := (others => '0'); -- s21f12
    signal d0_n30_sum : signed(18 downto 0) := (others => '0');
    signal d0_n30_cut : signed(14 downto 0) := (others => '0');
    signal d0_n30 : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal d0_n34_sum : signed(18 downto 0) := (others => '0');
    signal d0_n34_cut : signed(14 downto 0) := (others => '0');
    signal d0_n34 : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal d0_n35 : signed(12 downto 0) := (others => '0'); -- s13f4
    signal d0_n36 : signed(20 downto 0) := (others => '0'); -- s21f12
    signal r_s2 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal g_s2 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal b_s2 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal h_n18_s2 : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal h_n24_s2 : signed(20 downto 0) := (others => '0'); -- s21f12
    signal d0_n30_s2 : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal d0_n36_s2 : signed(20 downto 0) := (others => '0'); -- s21f12
    signal valid_s2 : std_logic;
    -- stage 2
    signal h_n25 : signed(21 downto 0) := (others => '0'); -- s22f12
    signal h_height_sum : signed(22 downto 0) := (others => '0');
    signal h_height_cut : signed(14 downto 0) := (others => '0');
    signal h_height : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal d0_n37 : signed(21 downto 0) := (others => '0'); -- s22f12
    signal d0_height_sum : signed(22 downto 0) := (others => '0');
    signal d0_height_cut : signed(14 downto 0) := (others => '0');
    signal d0_height : unsigned(11 downto 0) := (others => '0'); -- u12f4
    signal relief : signed(12 downto 0) := (others => '0'); -- s13f4
    signal n41 : signed(13 downto 0) := (others => '0'); -- s14f4
    signal n49 : signed(13 downto 0) := (others => '0'); -- s14f4
    signal n56 : signed(13 downto 0) := (others => '0'); -- s14f4
    signal n41_s3 : signed(13 downto 0) := (others => '0'); -- s14f4
    signal n49_s3 : signed(13 downto 0) := (others => '0'); -- s14f4
    signal n56_s3 : signed(13 downto 0) := (others => '0'); -- s14f4
    signal valid_s3 : std_logic;
    -- stage 3
    signal n42_sum : signed(14 downto 0) := (others => '0');
    signal n42_cut : signed(10 downto 0) := (others => '0');
    signal n42 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal n44 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n45 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n46 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal n47 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal out_r_next : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal n50_sum : signed(14 downto 0) := (others => '0');
    signal n50_cut : signed(10 downto 0) := (others => '0');
    signal n50 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal n51 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n52 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n53 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal n54 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal out_g_next : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal n57_sum : signed(14 downto 0) := (others => '0');
    signal n57_cut : signed(10 downto 0) := (others => '0');
    signal n57 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal n58 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n59 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n60 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal n61 : signed(10 downto 0) := (others => '0'); -- s11f0
    signal out_b_next : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal valid_s4 : std_logic;
begin

    -- ---- stage 0 ----
    -- h
    h_n15 <= signed(resize(h_10, 9)) - signed(resize(h_00, 9));
    h_n16 <= resize(h_n15 * signed('0' & h_a), 17);
    h_n17 <= signed(shift_left(resize(h_00, 18), 8)) + resize(h_n16, 18);
    h_n19 <= signed(resize(h_11, 9)) - signed(resize(h_01, 9));
    h_n20 <= resize(h_n19 * signed('0' & h_a), 17);
    h_n21 <= signed(shift_left(resize(h_01, 18), 8)) + resize(h_n20, 18);
    -- d0
    d0_n27 <= signed(resize(d0_10, 9)) - signed(resize(d0_00, 9));
    d0_n28 <= resize(d0_n27 * signed('0' & d0_a), 17);
    d0_n29 <= signed(shift_left(resize(d0_00, 18), 8)) + resize(d0_n28, 18);
    d0_n31 <= signed(resize(d0_11, 9)) - signed(resize(d0_01, 9));
    d0_n32 <= resize(d0_n31 * signed('0' & d0_a), 17);
    d0_n33 <= signed(shift_left(resize(d0_01, 18), 8)) + resize(d0_n32, 18);
    -- (unit)
    n40 <= 8x"ff";
    n43 <= "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                h_b_s1 <= h_b;
                d0_b_s1 <= d0_b;
                r_s1 <= r;
                g_s1 <= g;
                b_s1 <= b;
                h_n17_s1 <= h_n17;
                h_n21_s1 <= h_n21;
                d0_n29_s1 <= d0_n29;
                d0_n33_s1 <= d0_n33;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- h
    h_n18_sum <= resize(h_n17_s1, 19) + 19x"00008";
    h_n18_cut <= h_n18_sum(18 downto 4);
    h_n18 <= unsigned(h_n18_cut(11 downto 0));
    h_n22_sum <= resize(h_n21_s1, 19) + 19x"00008";
    h_n22_cut <= h_n22_sum(18 downto 4);
    h_n22 <= unsigned(h_n22_cut(11 downto 0));
    h_n23 <= signed(resize(h_n22, 13)) - signed(resize(h_n18, 13));
    h_n24 <= resize(h_n23 * signed('0' & h_b_s1), 21);
    -- d0
    d0_n30_sum <= resize(d0_n29_s1, 19) + 19x"00008";
    d0_n30_cut <= d0_n30_sum(18 downto 4);
    d0_n30 <= unsigned(d0_n30_cut(11 downto 0));
    d0_n34_sum <= resize(d0_n33_s1, 19) + 19x"00008";
    d0_n34_cut <= d0_n34_sum(18 downto 4);
    d0_n34 <= unsigned(d0_n34_cut(11 downto 0));
    d0_n35 <= signed(resize(d0_n34, 13)) - signed(resize(d0_n30, 13));
    d0_n36 <= resize(d0_n35 * signed('0' & d0_b_s1), 21);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                r_s2 <= r_s1;
                g_s2 <= g_s1;
                b_s2 <= b_s1;
                h_n18_s2 <= h_n18;
                h_n24_s2 <= h_n24;
                d0_n30_s2 <= d0_n30;
                d0_n36_s2 <= d0_n36;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- h
    h_n25 <= signed(shift_left(resize(h_n18_s2, 22), 8)) + resize(h_n24_s2, 22);
    h_height_sum <= resize(h_n25, 23) + 23x"000080";
    h_height_cut <= h_height_sum(22 downto 8);
    h_height <= unsigned(h_height_cut(11 downto 0));
    -- d0
    d0_n37 <= signed(shift_left(resize(d0_n30_s2, 22), 8)) + resize(d0_n36_s2, 22);
    d0_height_sum <= resize(d0_n37, 23) + 23x"000080";
    d0_height_cut <= d0_height_sum(22 downto 8);
    d0_height <= unsigned(d0_height_cut(11 downto 0));
    -- (unit)
    relief <= signed(resize(h_height, 13)) - signed(resize(d0_height, 13));
    n41 <= signed(shift_left(resize(r_s2, 14), 4)) + resize(relief, 14);
    n49 <= signed(shift_left(resize(g_s2, 14), 4)) + resize(relief, 14);
    n56 <= signed(shift_left(resize(b_s2, 14), 4)) + resize(relief, 14);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n41_s3 <= n41;
                n49_s3 <= n49;
                n56_s3 <= n56;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    n42_sum <= resize(n41_s3, 15) + 15x"0008";
    n42_cut <= n42_sum(14 downto 4);
    n42 <= n42_cut;
    n44 <= "1" when signed(resize(n40, 11)) < n42 else "0";
    n45 <= unsigned(n42(10 downto 10));
    n46 <= signed(resize(n40, 11)) when n44(0) = '1' else n42;
    n47 <= signed(resize(n43, 11)) when n45(0) = '1' else n46;
    out_r_next <= unsigned(n47(7 downto 0));
    n50_sum <= resize(n49_s3, 15) + 15x"0008";
    n50_cut <= n50_sum(14 downto 4);
    n50 <= n50_cut;
    n51 <= "1" when signed(resize(n40, 11)) < n50 else "0";
    n52 <= unsigned(n50(10 downto 10));
    n53 <= signed(resize(n40, 11)) when n51(0) = '1' else n50;
    n54 <= signed(resize(n43, 11)) when n52(0) = '1' else n53;
    out_g_next <= unsigned(n54(7 downto 0));
    n57_sum <= resize(n56_s3, 15) + 15x"0008";
    n57_cut <= n57_sum(14 downto 4);
    n57 <= n57_cut;
    n58 <= "1" when signed(resize(n40, 11)) < n57 else "0";
    n59 <= unsigned(n57(10 downto 10));
    n60 <= signed(resize(n40, 11)) when n58(0) = '1' else n57;
    n61 <= signed(resize(n43, 11)) when n59(0) = '1' else n60;
    out_b_next <= unsigned(n61(7 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                out_r <= out_r_next;
                out_g <= out_g_next;
                out_b <= out_b_next;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----

    valid_out <= valid_s4;
end architecture;
