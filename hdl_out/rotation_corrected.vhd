-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
--   variant=corrected output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
--   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
--   stages=auto rom=block
-- latency 11 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   angle: mean 2.96e-1 rad, largest seen 1.03e0 rad at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
--   dot: mean 2.93e-1, largest seen 9.83e-1 at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
--   x: mean 1.90e-1, largest seen 7.70e-1 at phi_a=34757 theta_a=16352 phi_n=57388 theta_n=19960
--   y: mean 6.21e-2, largest seen 2.97e-1 at phi_a=12448 theta_a=16689 phi_n=28272 theta_n=16284
--   z: mean 1.80e-1, largest seen 7.54e-1 at phi_a=46723 theta_a=16419 phi_n=40254 theta_n=12730
-- no bound is stated: asin, 1/sin and 1/cos have infinite slopes, which no word length bounds; each table's own error is stated
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity rotation_corrected is
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

architecture rtl of rotation_corrected is
    attribute rom_style : string;

    -- table sincos: sin s20f18, cos s20f18
    type sincos_rom_rows is array (0 to 1023) of unsigned(39 downto 0);
    impure function sincos_rom_file return sincos_rom_rows is
        file source : text open read_mode is "rotation_corrected_sincos.hex";
        variable row : line;
        variable all_rows : sincos_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant sincos_rom : sincos_rom_rows := sincos_rom_file;
    attribute rom_style of sincos_rom : constant is "block";

    -- table asin: asin s18f18
    type asin_rom_rows is array (0 to 1023) of unsigned(17 downto 0);
    impure function asin_rom_file return asin_rom_rows is
        file source : text open read_mode is "rotation_corrected_asin.hex";
        variable row : line;
        variable all_rows : asin_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant asin_rom : asin_rom_rows := asin_rom_file;
    attribute rom_style of asin_rom : constant is "block";

    -- table recip_sin: half_recip_sin s27f18
    type recip_sin_rom_rows is array (0 to 1023) of unsigned(26 downto 0);
    impure function recip_sin_rom_file return recip_sin_rom_rows is
        file source : text open read_mode is "rotation_corrected_recip_sin.hex";
        variable row : line;
        variable all_rows : recip_sin_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant recip_sin_rom : recip_sin_rom_rows := recip_sin_rom_file;
    attribute rom_style of recip_sin_rom : constant is "block";

    -- table recip_cos: half_recip_cos s27f18
    type recip_cos_rom_rows is array (0 to 1023) of unsigned(26 downto 0);
    impure function recip_cos_rom_file return recip_cos_rom_rows is
        file source : text open read_mode is "rotation_corrected_recip_cos.hex";
        variable row : line;
        variable all_rows : recip_cos_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant recip_cos_rom : recip_cos_rom_rows := recip_cos_rom_file;
    attribute rom_style of recip_cos_rom : constant is "block";

    -- table atan: atan s18f18
    type atan_rom_rows is array (0 to 1023) of unsigned(17 downto 0);
    impure function atan_rom_file return atan_rom_rows is
        file source : text open read_mode is "rotation_corrected_atan.hex";
        variable row : line;
        variable all_rows : atan_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant atan_rom : atan_rom_rows := atan_rom_file;
    attribute rom_style of atan_rom : constant is "block";

    -- table prop: prop s20f18
    type prop_rom_rows is array (0 to 1023) of unsigned(19 downto 0);
    impure function prop_rom_file return prop_rom_rows is
        file source : text open read_mode is "rotation_corrected_prop.hex";
        variable row : line;
        variable all_rows : prop_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant prop_rom : prop_rom_rows := prop_rom_file;
    attribute rom_style of prop_rom : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal angles_delta_exact : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_n6 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal angles_n7 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal angles_ang_x : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal angles_ang_y : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_n10 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n13 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n21 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n22 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n24 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal behind : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n28 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n53 : unsigned(0 downto 0) := (others => '0'); -- u1f2
    signal theta_n_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_row : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_2 : unsigned(39 downto 0) := (others => '0');
    signal behind_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s1 : std_logic;
    -- stage 1
    signal sincos_sin_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n16 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal n17 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal y_double : signed(20 downto 0) := (others => '0'); -- s21f18
    signal theta_n_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n17_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal behind_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal y_double_s2 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s2 : std_logic;
    -- stage 2
    signal sin_theta_x_sum : signed(21 downto 0) := (others => '0');
    signal sin_theta_x_cut : signed(20 downto 0) := (others => '0');
    signal sin_theta_x_over : unsigned(0 downto 0) := (others => '0');
    signal sin_theta_x_under : unsigned(0 downto 0) := (others => '0');
    signal sin_theta_x : signed(18 downto 0) := (others => '0'); -- s19f18
    signal asin_n19 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal theta_n_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal asin_row : unsigned(17 downto 0) := (others => '0');
    signal behind_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal y_double_s3 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s3 : std_logic;
    -- stage 3
    signal asin_n20 : signed(17 downto 0) := (others => '0'); -- s18f18
    signal n26 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal n27 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n29 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n30 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal theta_x : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal theta_n_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal theta_x_s4 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal y_double_s4 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s4 : std_logic;
    -- stage 4
    signal z_exact : signed(18 downto 0) := (others => '0'); -- s19f18
    signal ang_z : signed(17 downto 0) := (others => '0'); -- s18f18
    signal recip_sin_n35 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n43 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n50_neg : unsigned(17 downto 0) := (others => '0');
    signal n50 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n54 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal y_double_s5 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal recip_sin_row : unsigned(26 downto 0) := (others => '0');
    signal recip_cos_row : unsigned(26 downto 0) := (others => '0');
    signal n43_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n50_s5 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n54_s5 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal valid_s5 : std_logic;
    -- stage 5
    signal recip_sin_half_recip_sin : signed(26 downto 0) := (others => '0'); -- s27f18
    signal recip_cos_half_recip_cos : signed(26 downto 0) := (others => '0'); -- s27f18
    signal y_double_s6 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal recip_sin_half_recip_sin_s6 : signed(26 downto 0) := (others => '0'); -- s27f18
    signal recip_cos_half_recip_cos_s6 : signed(26 downto 0) := (others => '0'); -- s27f18
    signal n43_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n50_s6 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n54_s6 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal valid_s6 : std_logic;
    -- stage 6
    signal n38 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n46 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n38_s7 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n43_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n46_s7 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n50_s7 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n54_s7 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal valid_s7 : std_logic;
    -- stage 7
    signal tan_phi_sum : signed(48 downto 0) := (others => '0');
    signal tan_phi_cut : signed(30 downto 0) := (others => '0');
    signal tan_phi_over : unsigned(0 downto 0) := (others => '0');
    signal tan_phi_under : unsigned(0 downto 0) := (others => '0');
    signal tan_phi : signed(22 downto 0) := (others => '0'); -- s23f18
    signal atan_n40 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal y_k_sum : signed(48 downto 0) := (others => '0');
    signal y_k_cut : signed(30 downto 0) := (others => '0');
    signal y_k_over : unsigned(0 downto 0) := (others => '0');
    signal y_k_under : unsigned(0 downto 0) := (others => '0');
    signal y_k : signed(18 downto 0) := (others => '0'); -- s19f18
    signal n48_neg : unsigned(18 downto 0) := (others => '0');
    signal n48 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal n49_over : unsigned(0 downto 0) := (others => '0');
    signal n49 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal prop_n51 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal atan_row : unsigned(17 downto 0) := (others => '0');
    signal n43_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n50_s8 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal prop_row : unsigned(19 downto 0) := (others => '0');
    signal n54_s8 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal valid_s8 : std_logic;
    -- stage 8
    signal atan_n41 : signed(17 downto 0) := (others => '0'); -- s18f18
    signal n42 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n44 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n45 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal prop_theta_prop : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n57_sum : unsigned(18 downto 0) := (others => '0');
    signal n57_cut : unsigned(16 downto 0) := (others => '0');
    signal n57 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal phi_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n50_s9 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal prop_theta_prop_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n54_s9 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal phi_next_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s9 : std_logic;
    -- stage 9
    signal n55 : signed(38 downto 0) := (others => '0'); -- s39f36
    signal n50_s10 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n55_s10 : signed(38 downto 0) := (others => '0'); -- s39f36
    signal phi_next_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s10 : std_logic;
    -- stage 10
    signal n56 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal n59_sum : signed(40 downto 0) := (others => '0');
    signal n59_cut : signed(20 downto 0) := (others => '0');
    signal n59 : signed(20 downto 0) := (others => '0'); -- s21f16
    signal theta_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s11 : std_logic;
begin

    -- ---- stage 0 ----
    -- angles
    angles_delta_exact <= signed(resize(phi_a, 17)) - signed(resize(phi_n, 17));
    angles_delta <= unsigned(angles_delta_exact(15 downto 0));
    angles_n6 <= resize(theta_a, 17) + resize(angles_delta, 17);
    angles_n7 <= signed(resize(theta_a, 17)) - signed(resize(angles_delta, 17));
    angles_ang_x <= angles_n6(15 downto 0);
    angles_ang_y <= unsigned(angles_n7(15 downto 0));
    -- sincos
    sincos_n10 <= angles_ang_x(15 downto 6);
    sincos_n13 <= angles_ang_y(15 downto 6);
    -- (unit)
    n21 <= 16x"4000";
    n22 <= 16x"c000";
    n23 <= "1" when n21 < theta_a else "0";
    n24 <= "1" when theta_a < n22 else "0";
    behind <= n23 and n24;
    n28 <= 18x"20000";
    n53 <= "1";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s1 <= theta_n;
                sincos_row <= sincos_rom(to_integer(sincos_n10));
                sincos_row_2 <= sincos_rom(to_integer(sincos_n13));
                behind_s1 <= behind;
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
    sincos_sin_x <= signed(sincos_row(39 downto 20));
    sincos_cos_x <= signed(sincos_row(19 downto 0));
    sincos_sin_y <= signed(sincos_row_2(39 downto 20));
    sincos_cos_y <= signed(sincos_row_2(19 downto 0));
    -- (unit)
    n16 <= resize(sincos_sin_x, 21) + resize(sincos_sin_y, 21);
    n17 <= n16;
    y_double <= resize(sincos_cos_y, 21) - resize(sincos_cos_x, 21);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s2 <= theta_n_s1;
                n17_s2 <= n17;
                behind_s2 <= behind_s1;
                y_double_s2 <= y_double;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    sin_theta_x_sum <= resize(n17_s2, 22) + 22x"000001";
    sin_theta_x_cut <= sin_theta_x_sum(21 downto 1);
    sin_theta_x_over <= "1" when sin_theta_x_cut(20) = '0' and (or sin_theta_x_cut(19 downto 18)) = '1' else "0";
    sin_theta_x_under <= "1" when sin_theta_x_cut(20) = '1' and (and sin_theta_x_cut(19 downto 18)) = '0' else "0";
    sin_theta_x <= 19x"3ffff" when sin_theta_x_over(0) = '1' else 19x"40000" when sin_theta_x_under(0) = '1' else sin_theta_x_cut(18 downto 0);
    -- asin
    asin_n19 <= unsigned(sin_theta_x(18 downto 9));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s3 <= theta_n_s2;
                asin_row <= asin_rom(to_integer(asin_n19));
                behind_s3 <= behind_s2;
                y_double_s3 <= y_double_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- asin
    asin_n20 <= signed(asin_row);
    -- (unit)
    n26 <= -resize(asin_n20, 19);
    n27 <= unsigned(n26(17 downto 0));
    n29 <= n27 xor n28;
    n30 <= unsigned(asin_n20);
    theta_x <= n29 when behind_s3(0) = '1' else n30;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s4 <= theta_n_s3;
                theta_x_s4 <= theta_x;
                y_double_s4 <= y_double_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    z_exact <= signed(resize(theta_x_s4, 19)) - signed(shift_left(resize(theta_n_s4, 19), 2));
    ang_z <= z_exact(17 downto 0);
    -- recip_sin
    recip_sin_n35 <= unsigned(ang_z(17 downto 8));
    -- (unit)
    n43 <= unsigned(ang_z(17 downto 17));
    n50_neg <= unsigned(-ang_z);
    n50 <= n50_neg when ang_z(17) = '1' else unsigned(ang_z);
    n54 <= signed(shift_left(resize(n53, 19), 16)) - signed(resize(n50, 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_double_s5 <= y_double_s4;
                recip_sin_row <= recip_sin_rom(to_integer(recip_sin_n35));
                recip_cos_row <= recip_cos_rom(to_integer(recip_sin_n35));
                n43_s5 <= n43;
                n50_s5 <= n50;
                n54_s5 <= n54;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- recip_sin
    recip_sin_half_recip_sin <= signed(recip_sin_row);
    -- recip_cos
    recip_cos_half_recip_cos <= signed(recip_cos_row);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                y_double_s6 <= y_double_s5;
                recip_sin_half_recip_sin_s6 <= recip_sin_half_recip_sin;
                recip_cos_half_recip_cos_s6 <= recip_cos_half_recip_cos;
                n43_s6 <= n43_s5;
                n50_s6 <= n50_s5;
                n54_s6 <= n54_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    n38 <= y_double_s6 * recip_sin_half_recip_sin_s6;
    n46 <= y_double_s6 * recip_cos_half_recip_cos_s6;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n38_s7 <= n38;
                n43_s7 <= n43_s6;
                n46_s7 <= n46;
                n50_s7 <= n50_s6;
                n54_s7 <= n54_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    tan_phi_sum <= resize(n38_s7, 49) + 49x"0000000020000";
    tan_phi_cut <= tan_phi_sum(48 downto 18);
    tan_phi_over <= "1" when tan_phi_cut(30) = '0' and (or tan_phi_cut(29 downto 22)) = '1' else "0";
    tan_phi_under <= "1" when tan_phi_cut(30) = '1' and (and tan_phi_cut(29 downto 22)) = '0' else "0";
    tan_phi <= 23x"3fffff" when tan_phi_over(0) = '1' else 23x"400000" when tan_phi_under(0) = '1' else tan_phi_cut(22 downto 0);
    -- atan
    atan_n40 <= unsigned(tan_phi(22 downto 13));
    -- (unit)
    y_k_sum <= resize(n46_s7, 49) + 49x"0000000020000";
    y_k_cut <= y_k_sum(48 downto 18);
    y_k_over <= "1" when y_k_cut(30) = '0' and (or y_k_cut(29 downto 18)) = '1' else "0";
    y_k_under <= "1" when y_k_cut(30) = '1' and (and y_k_cut(29 downto 18)) = '0' else "0";
    y_k <= 19x"3ffff" when y_k_over(0) = '1' else 19x"40000" when y_k_under(0) = '1' else y_k_cut(18 downto 0);
    n48_neg <= unsigned(-y_k);
    n48 <= n48_neg when y_k(18) = '1' else unsigned(y_k);
    n49_over <= "1" when (or n48(18 downto 18)) = '1' else "0";
    n49 <= 18x"3ffff" when n49_over(0) = '1' else n48(17 downto 0);
    -- prop
    prop_n51 <= n49(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                atan_row <= atan_rom(to_integer(atan_n40));
                n43_s8 <= n43_s7;
                n50_s8 <= n50_s7;
                prop_row <= prop_rom(to_integer(prop_n51));
                n54_s8 <= n54_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- atan
    atan_n41 <= signed(atan_row);
    -- (unit)
    n42 <= unsigned(atan_n41);
    n44 <= n42 xor n28;
    n45 <= n44 when n43_s8(0) = '1' else n42;
    -- prop
    prop_theta_prop <= signed(prop_row);
    -- (unit)
    n57_sum <= resize(n45, 19) + 19x"00002";
    n57_cut <= n57_sum(18 downto 2);
    n57 <= n57_cut;
    phi_next <= n57(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n50_s9 <= n50_s8;
                prop_theta_prop_s9 <= prop_theta_prop;
                n54_s9 <= n54_s8;
                phi_next_s9 <= phi_next;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    n55 <= n54_s9 * prop_theta_prop_s9;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n50_s10 <= n50_s9;
                n55_s10 <= n55;
                phi_next_s10 <= phi_next_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    n56 <= signed(shift_left(resize(n50_s10, 40), 18)) + resize(n55_s10, 40);
    n59_sum <= resize(n56, 41) + 41x"00000080000";
    n59_cut <= n59_sum(40 downto 20);
    n59 <= n59_cut;
    theta_next <= unsigned(n59(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi <= phi_next_s10;
                theta <= theta_next;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----

    valid_out <= valid_s11;
end architecture;
