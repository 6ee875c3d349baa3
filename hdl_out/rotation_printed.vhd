-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; seed 001 (Lee et al.), section 3.1 and Fig. 7
--   variant=printed output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
--   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
--   stages=auto rom=block
-- latency 10 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   angle: mean 1.49e0 rad, largest seen 3.14e0 rad at phi_a=15344 theta_a=12973 phi_n=15490 theta_n=26226
--   dot: mean 1.28e0, largest seen 2.00e0 at phi_a=15344 theta_a=12973 phi_n=15490 theta_n=26226
--   x: mean 7.73e-1, largest seen 2.00e0 at phi_a=37985 theta_a=3793 phi_n=38551 theta_n=19699
--   y: mean 5.55e-1, largest seen 1.99e0 at phi_a=65309 theta_a=16773 phi_n=16202 theta_n=27589
--   z: mean 5.94e-1, largest seen 1.99e0 at phi_a=29194 theta_a=9772 phi_n=60747 theta_n=22698
-- no bound is stated: asin, 1/sin and 1/cos have infinite slopes, which no word length bounds; each table's own error is stated
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity rotation_printed is
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

architecture rtl of rotation_printed is
    attribute rom_style : string;

    -- table sincos: sin s20f18, cos s20f18
    type sincos_rom_rows is array (0 to 1023) of unsigned(39 downto 0);
    impure function sincos_rom_file return sincos_rom_rows is
        file source : text open read_mode is "rotation_printed_sincos.hex";
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
        file source : text open read_mode is "rotation_printed_asin.hex";
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
        file source : text open read_mode is "rotation_printed_recip_sin.hex";
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
        file source : text open read_mode is "rotation_printed_recip_cos.hex";
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
        file source : text open read_mode is "rotation_printed_atan.hex";
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
        file source : text open read_mode is "rotation_printed_prop.hex";
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
    signal angles_n5 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal angles_n6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal angles_n7 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal angles_n8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal angles_ang_x : unsigned(16 downto 0) := (others => '0'); -- u17f17
    signal angles_ang_y : unsigned(16 downto 0) := (others => '0'); -- u17f17
    signal sincos_n11 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal sincos_n14 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n34 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n41 : unsigned(0 downto 0) := (others => '0'); -- u1f2
    signal theta_n_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_row : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_2 : unsigned(39 downto 0) := (others => '0');
    signal valid_s1 : std_logic;
    -- stage 1
    signal sincos_sin_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n17 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal n18 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal y_double : signed(20 downto 0) := (others => '0'); -- s21f18
    signal theta_n_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n18_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal y_double_s2 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s2 : std_logic;
    -- stage 2
    signal sin_theta_x_sum : signed(21 downto 0) := (others => '0');
    signal sin_theta_x_cut : signed(20 downto 0) := (others => '0');
    signal sin_theta_x_over : unsigned(0 downto 0) := (others => '0');
    signal sin_theta_x_under : unsigned(0 downto 0) := (others => '0');
    signal sin_theta_x : signed(18 downto 0) := (others => '0'); -- s19f18
    signal asin_n20 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal theta_n_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal asin_row : unsigned(17 downto 0) := (others => '0');
    signal y_double_s3 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s3 : std_logic;
    -- stage 3
    signal asin_theta_x : signed(17 downto 0) := (others => '0'); -- s18f18
    signal z_exact : signed(19 downto 0) := (others => '0'); -- s20f18
    signal ang_z : signed(17 downto 0) := (others => '0'); -- s18f18
    signal recip_sin_n25 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n33 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n42 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal z_exact_s4 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal y_double_s4 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal recip_sin_row : unsigned(26 downto 0) := (others => '0');
    signal recip_cos_row : unsigned(26 downto 0) := (others => '0');
    signal n33_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n42_s4 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s4 : std_logic;
    -- stage 4
    signal recip_sin_half_recip_sin : signed(26 downto 0) := (others => '0'); -- s27f18
    signal recip_cos_half_recip_cos : signed(26 downto 0) := (others => '0'); -- s27f18
    signal z_exact_s5 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal y_double_s5 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal recip_sin_half_recip_sin_s5 : signed(26 downto 0) := (others => '0'); -- s27f18
    signal recip_cos_half_recip_cos_s5 : signed(26 downto 0) := (others => '0'); -- s27f18
    signal n33_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n42_s5 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s5 : std_logic;
    -- stage 5
    signal n28 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n37 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal z_exact_s6 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n28_s6 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n33_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n37_s6 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n42_s6 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s6 : std_logic;
    -- stage 6
    signal tan_phi_sum : signed(48 downto 0) := (others => '0');
    signal tan_phi_cut : signed(30 downto 0) := (others => '0');
    signal tan_phi_over : unsigned(0 downto 0) := (others => '0');
    signal tan_phi_under : unsigned(0 downto 0) := (others => '0');
    signal tan_phi : signed(22 downto 0) := (others => '0'); -- s23f18
    signal atan_n30 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal y_k_sum : signed(48 downto 0) := (others => '0');
    signal y_k_cut : signed(30 downto 0) := (others => '0');
    signal y_k_over : unsigned(0 downto 0) := (others => '0');
    signal y_k_under : unsigned(0 downto 0) := (others => '0');
    signal y_k : signed(18 downto 0) := (others => '0'); -- s19f18
    signal prop_n39 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal z_exact_s7 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal atan_row : unsigned(17 downto 0) := (others => '0');
    signal n33_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal prop_row : unsigned(19 downto 0) := (others => '0');
    signal n42_s7 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal valid_s7 : std_logic;
    -- stage 7
    signal atan_n31 : signed(17 downto 0) := (others => '0'); -- s18f18
    signal n32 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n35 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n36 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal prop_theta_prop : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n45_sum : unsigned(18 downto 0) := (others => '0');
    signal n45_cut : unsigned(16 downto 0) := (others => '0');
    signal n45 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal phi_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal z_exact_s8 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal prop_theta_prop_s8 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n42_s8 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal phi_next_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s8 : std_logic;
    -- stage 8
    signal n43 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal z_exact_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n43_s9 : signed(40 downto 0) := (others => '0'); -- s41f36
    signal phi_next_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s9 : std_logic;
    -- stage 9
    signal n44 : signed(41 downto 0) := (others => '0'); -- s42f36
    signal n47_sum : signed(42 downto 0) := (others => '0');
    signal n47_cut : signed(22 downto 0) := (others => '0');
    signal n47 : signed(22 downto 0) := (others => '0'); -- s23f16
    signal theta_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s10 : std_logic;
begin

    -- ---- stage 0 ----
    -- angles
    angles_delta_exact <= signed(resize(phi_a, 17)) - signed(resize(phi_n, 17));
    angles_n5 <= signed(resize(theta_a, 18)) + resize(angles_delta_exact, 18);
    angles_n6 <= angles_n5;
    angles_n7 <= signed(resize(theta_a, 18)) - resize(angles_delta_exact, 18);
    angles_n8 <= angles_n7;
    angles_ang_x <= unsigned(angles_n6(16 downto 0));
    angles_ang_y <= unsigned(angles_n8(16 downto 0));
    -- sincos
    sincos_n11 <= angles_ang_x(16 downto 7);
    sincos_n14 <= angles_ang_y(16 downto 7);
    -- (unit)
    n34 <= 18x"20000";
    n41 <= "1";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s1 <= theta_n;
                sincos_row <= sincos_rom(to_integer(sincos_n11));
                sincos_row_2 <= sincos_rom(to_integer(sincos_n14));
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
    n17 <= resize(sincos_sin_x, 21) + resize(sincos_sin_y, 21);
    n18 <= n17;
    y_double <= resize(sincos_cos_y, 21) - resize(sincos_cos_x, 21);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s2 <= theta_n_s1;
                n18_s2 <= n18;
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
    sin_theta_x_sum <= resize(n18_s2, 22) + 22x"000001";
    sin_theta_x_cut <= sin_theta_x_sum(21 downto 1);
    sin_theta_x_over <= "1" when sin_theta_x_cut(20) = '0' and (or sin_theta_x_cut(19 downto 18)) = '1' else "0";
    sin_theta_x_under <= "1" when sin_theta_x_cut(20) = '1' and (and sin_theta_x_cut(19 downto 18)) = '0' else "0";
    sin_theta_x <= 19x"3ffff" when sin_theta_x_over(0) = '1' else 19x"40000" when sin_theta_x_under(0) = '1' else sin_theta_x_cut(18 downto 0);
    -- asin
    asin_n20 <= unsigned(sin_theta_x(18 downto 9));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_n_s3 <= theta_n_s2;
                asin_row <= asin_rom(to_integer(asin_n20));
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
    asin_theta_x <= signed(asin_row);
    -- (unit)
    z_exact <= resize(asin_theta_x, 20) - signed(shift_left(resize(theta_n_s3, 20), 2));
    ang_z <= z_exact(17 downto 0);
    -- recip_sin
    recip_sin_n25 <= unsigned(ang_z(17 downto 8));
    -- (unit)
    n33 <= unsigned(ang_z(17 downto 17));
    n42 <= signed(shift_left(resize(n41, 21), 16)) - resize(z_exact, 21);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                z_exact_s4 <= z_exact;
                y_double_s4 <= y_double_s3;
                recip_sin_row <= recip_sin_rom(to_integer(recip_sin_n25));
                recip_cos_row <= recip_cos_rom(to_integer(recip_sin_n25));
                n33_s4 <= n33;
                n42_s4 <= n42;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- recip_sin
    recip_sin_half_recip_sin <= signed(recip_sin_row);
    -- recip_cos
    recip_cos_half_recip_cos <= signed(recip_cos_row);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                z_exact_s5 <= z_exact_s4;
                y_double_s5 <= y_double_s4;
                recip_sin_half_recip_sin_s5 <= recip_sin_half_recip_sin;
                recip_cos_half_recip_cos_s5 <= recip_cos_half_recip_cos;
                n33_s5 <= n33_s4;
                n42_s5 <= n42_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    n28 <= y_double_s5 * recip_sin_half_recip_sin_s5;
    n37 <= y_double_s5 * recip_cos_half_recip_cos_s5;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                z_exact_s6 <= z_exact_s5;
                n28_s6 <= n28;
                n33_s6 <= n33_s5;
                n37_s6 <= n37;
                n42_s6 <= n42_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    tan_phi_sum <= resize(n28_s6, 49) + 49x"0000000020000";
    tan_phi_cut <= tan_phi_sum(48 downto 18);
    tan_phi_over <= "1" when tan_phi_cut(30) = '0' and (or tan_phi_cut(29 downto 22)) = '1' else "0";
    tan_phi_under <= "1" when tan_phi_cut(30) = '1' and (and tan_phi_cut(29 downto 22)) = '0' else "0";
    tan_phi <= 23x"3fffff" when tan_phi_over(0) = '1' else 23x"400000" when tan_phi_under(0) = '1' else tan_phi_cut(22 downto 0);
    -- atan
    atan_n30 <= unsigned(tan_phi(22 downto 13));
    -- (unit)
    y_k_sum <= resize(n37_s6, 49) + 49x"0000000020000";
    y_k_cut <= y_k_sum(48 downto 18);
    y_k_over <= "1" when y_k_cut(30) = '0' and (or y_k_cut(29 downto 18)) = '1' else "0";
    y_k_under <= "1" when y_k_cut(30) = '1' and (and y_k_cut(29 downto 18)) = '0' else "0";
    y_k <= 19x"3ffff" when y_k_over(0) = '1' else 19x"40000" when y_k_under(0) = '1' else y_k_cut(18 downto 0);
    -- prop
    prop_n39 <= unsigned(y_k(18 downto 9));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                z_exact_s7 <= z_exact_s6;
                atan_row <= atan_rom(to_integer(atan_n30));
                n33_s7 <= n33_s6;
                prop_row <= prop_rom(to_integer(prop_n39));
                n42_s7 <= n42_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- atan
    atan_n31 <= signed(atan_row);
    -- (unit)
    n32 <= unsigned(atan_n31);
    n35 <= n32 xor n34;
    n36 <= n35 when n33_s7(0) = '1' else n32;
    -- prop
    prop_theta_prop <= signed(prop_row);
    -- (unit)
    n45_sum <= resize(n36, 19) + 19x"00002";
    n45_cut <= n45_sum(18 downto 2);
    n45 <= n45_cut;
    phi_next <= n45(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                z_exact_s8 <= z_exact_s7;
                prop_theta_prop_s8 <= prop_theta_prop;
                n42_s8 <= n42_s7;
                phi_next_s8 <= phi_next;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    n43 <= n42_s8 * prop_theta_prop_s8;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                z_exact_s9 <= z_exact_s8;
                n43_s9 <= n43;
                phi_next_s9 <= phi_next_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    n44 <= shift_left(resize(z_exact_s9, 42), 18) + resize(n43_s9, 42);
    n47_sum <= resize(n44, 43) + 43x"00000080000";
    n47_cut <= n47_sum(42 downto 20);
    n47 <= n47_cut;
    theta_next <= unsigned(n47(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi <= phi_next_s9;
                theta <= theta_next;
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
