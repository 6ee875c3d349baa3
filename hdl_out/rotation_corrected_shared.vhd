-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
-- Angular Operation, section 3.1 and Fig. 7
--   variant=corrected output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
--   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
--   stages=auto rom=block schedule=shared interval=auto share_dot=auto share_mul=1 share_add=auto
--   share_table=auto share_root=auto share_divide=auto share_latency=auto share_loads=no
-- latency 13 cycles, interval 3 cycles; tables read on the clock
-- absolute errors against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   angle: mean 2.96e-1 rad, largest seen 1.03e0 rad at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
--   dot: mean 2.93e-1, largest seen 9.83e-1 at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
--   x: mean 1.90e-1, largest seen 7.70e-1 at phi_a=34757 theta_a=16352 phi_n=57388 theta_n=19960
--   y: mean 6.21e-2, largest seen 2.97e-1 at phi_a=12448 theta_a=16689 phi_n=28272 theta_n=16284
--   z: mean 1.80e-1, largest seen 7.54e-1 at phi_a=46723 theta_a=16419 phi_n=40254 theta_n=12730
-- no bound is stated: asin, 1/sin and 1/cos have infinite slopes, so no word length bounds the error; each table's own error is stated
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity rotation_corrected_shared is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits and the phase
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        ready : out std_logic; -- inputs are taken at this edge
        phi_a : in unsigned(15 downto 0); -- u16f16
        theta_a : in unsigned(15 downto 0); -- u16f16
        phi_n : in unsigned(15 downto 0); -- u16f16
        theta_n : in unsigned(15 downto 0); -- u16f16
        valid_out : out std_logic;
        phi : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        theta : out unsigned(15 downto 0) := (others => '0') -- u16f16
    );
end entity;

architecture rtl of rotation_corrected_shared is
    attribute rom_style : string;

    -- table sincos: sin s20f18, cos s20f18
    type sincos_rom_rows is array (0 to 1023) of unsigned(39 downto 0);
    impure function sincos_rom_file return sincos_rom_rows is
        file source : text open read_mode is "rotation_corrected_shared_sincos.hex";
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
        file source : text open read_mode is "rotation_corrected_shared_asin.hex";
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
        file source : text open read_mode is "rotation_corrected_shared_recip_sin.hex";
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
        file source : text open read_mode is "rotation_corrected_shared_recip_cos.hex";
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
        file source : text open read_mode is "rotation_corrected_shared_atan.hex";
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
        file source : text open read_mode is "rotation_corrected_shared_prop.hex";
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

    -- Words start at zero: numeric_std warns about comparing or indexing with undefined words.
    -- Valid bits don't, so a bit that a reset misses shows as unknown.
    -- phase
    signal phase : unsigned(1 downto 0) := (others => '0');
    signal phase_more : unsigned(1 downto 0) := (others => '0');
    signal phase_last : unsigned(0 downto 0) := (others => '0');
    signal phase_next : unsigned(1 downto 0) := (others => '0');
    signal phase_0 : unsigned(0 downto 0) := (others => '0');
    signal phase_1 : unsigned(0 downto 0) := (others => '0');
    signal phase_2 : unsigned(0 downto 0) := (others => '0');
    -- hold registers and results of units
    signal theta_n_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal theta_n_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n17_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal behind_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal theta_x_s4 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal y_double_s2 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal y_double_s5 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal recip_sin_half_recip_sin_s6 : signed(26 downto 0) := (others => '0'); -- s27f18
    signal recip_cos_half_recip_cos_s6 : signed(26 downto 0) := (others => '0'); -- s27f18
    signal n38 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n38_s8 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n43_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n43_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n46 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n46_s7 : signed(47 downto 0) := (others => '0'); -- s48f36
    signal n50_s5 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n50_s8 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n50_s11 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal prop_theta_prop_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n54_s5 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal n54_s8 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal n54_s11 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal n55 : signed(38 downto 0) := (others => '0'); -- s39f36
    signal n55_s12 : signed(38 downto 0) := (others => '0'); -- s39f36
    signal phi_next_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
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
    signal sincos_row : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_2 : unsigned(39 downto 0) := (others => '0');
    signal valid_s1 : std_logic;
    -- stage 1
    signal sincos_sin_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_sin_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal sincos_cos_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal n16 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal n17 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal y_double : signed(20 downto 0) := (others => '0'); -- s21f18
    -- stage 2
    signal sin_theta_x_sum : signed(21 downto 0) := (others => '0');
    signal sin_theta_x_cut : signed(20 downto 0) := (others => '0');
    signal sin_theta_x_over : unsigned(0 downto 0) := (others => '0');
    signal sin_theta_x_under : unsigned(0 downto 0) := (others => '0');
    signal sin_theta_x : signed(18 downto 0) := (others => '0'); -- s19f18
    signal asin_n19 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal asin_row : unsigned(17 downto 0) := (others => '0');
    -- stage 3
    signal asin_n20 : signed(17 downto 0) := (others => '0'); -- s18f18
    signal n26 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal n27 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n29 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n30 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal theta_x : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal valid_s4 : std_logic;
    -- stage 4
    signal z_exact : signed(18 downto 0) := (others => '0'); -- s19f18
    signal ang_z : signed(17 downto 0) := (others => '0'); -- s18f18
    signal recip_sin_n35 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n43 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n50_neg : unsigned(17 downto 0) := (others => '0');
    signal n50 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n54 : signed(18 downto 0) := (others => '0'); -- s19f18
    signal recip_sin_row : unsigned(26 downto 0) := (others => '0');
    signal recip_cos_row : unsigned(26 downto 0) := (others => '0');
    -- stage 5
    signal recip_sin_half_recip_sin : signed(26 downto 0) := (others => '0'); -- s27f18
    signal recip_cos_half_recip_cos : signed(26 downto 0) := (others => '0'); -- s27f18
    -- stage 6
    signal valid_s7 : std_logic;
    -- stage 7
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
    signal prop_row : unsigned(19 downto 0) := (others => '0');
    -- stage 8
    signal tan_phi_sum : signed(48 downto 0) := (others => '0');
    signal tan_phi_cut : signed(30 downto 0) := (others => '0');
    signal tan_phi_over : unsigned(0 downto 0) := (others => '0');
    signal tan_phi_under : unsigned(0 downto 0) := (others => '0');
    signal tan_phi : signed(22 downto 0) := (others => '0'); -- s23f18
    signal atan_n40 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal prop_theta_prop : signed(19 downto 0) := (others => '0'); -- s20f18
    signal atan_row : unsigned(17 downto 0) := (others => '0');
    -- stage 9
    signal atan_n41 : signed(17 downto 0) := (others => '0'); -- s18f18
    signal n42 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n44 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n45 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal n57_sum : unsigned(18 downto 0) := (others => '0');
    signal n57_cut : unsigned(16 downto 0) := (others => '0');
    signal n57 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal phi_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s10 : std_logic;
    -- stage 10
    -- stage 11
    -- stage 12
    signal n56 : signed(39 downto 0) := (others => '0'); -- s40f36
    signal n59_sum : signed(40 downto 0) := (others => '0');
    signal n59_cut : signed(20 downto 0) := (others => '0');
    signal n59 : signed(20 downto 0) := (others => '0'); -- s21f16
    signal theta_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s13 : std_logic;
    -- inputs of mul1
    signal mul1_in0 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal mul1_in1 : signed(26 downto 0) := (others => '0'); -- s27f18
    -- mul1, stage 0
    signal mul1_n0 : signed(47 downto 0) := (others => '0'); -- s48f36
    -- results of mul1
begin

    -- ---- phase ----
    phase_more <= phase + "01";
    phase_last <= "1" when phase = "10" else "0";
    phase_next <= "00" when phase_last(0) = '1' else phase_more;
    phase_0 <= "1" when phase = "00" else "0";
    phase_1 <= "1" when phase = "01" else "0";
    phase_2 <= "1" when phase = "10" else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if rst = '1' then
                phase <= (others => '0');
            elsif ce = '1' then
                phase <= phase_next;
            end if;
        end if;
    end process;

    -- ---- hold registers and results of units ----

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
            if ce = '1' and phase_0(0) = '1' then
                theta_n_s1 <= theta_n;
                behind_s1 <= behind;
            end if;
            if ce = '1' then
                sincos_row <= sincos_rom(to_integer(sincos_n10));
                sincos_row_2 <= sincos_rom(to_integer(sincos_n13));
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
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
            if ce = '1' and phase_1(0) = '1' then
                n17_s2 <= n17;
                y_double_s2 <= y_double;
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
                asin_row <= asin_rom(to_integer(asin_n19));
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
    theta_x <= n29 when behind_s1(0) = '1' else n30;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                theta_n_s4 <= theta_n_s1;
                theta_x_s4 <= theta_x;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s4 <= valid_s1;
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
            if ce = '1' and phase_1(0) = '1' then
                y_double_s5 <= y_double_s2;
                n43_s5 <= n43;
                n50_s5 <= n50;
                n54_s5 <= n54;
            end if;
            if ce = '1' then
                recip_sin_row <= recip_sin_rom(to_integer(recip_sin_n35));
                recip_cos_row <= recip_cos_rom(to_integer(recip_sin_n35));
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
            if ce = '1' and phase_2(0) = '1' then
                recip_sin_half_recip_sin_s6 <= recip_sin_half_recip_sin;
                recip_cos_half_recip_cos_s6 <= recip_cos_half_recip_cos;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                n46_s7 <= n46;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s7 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
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
            if ce = '1' and phase_1(0) = '1' then
                n38_s8 <= n38;
                n43_s8 <= n43_s5;
                n50_s8 <= n50_s5;
                n54_s8 <= n54_s5;
            end if;
            if ce = '1' then
                prop_row <= prop_rom(to_integer(prop_n51));
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    tan_phi_sum <= resize(n38_s8, 49) + 49x"0000000020000";
    tan_phi_cut <= tan_phi_sum(48 downto 18);
    tan_phi_over <= "1" when tan_phi_cut(30) = '0' and (or tan_phi_cut(29 downto 22)) = '1' else "0";
    tan_phi_under <= "1" when tan_phi_cut(30) = '1' and (and tan_phi_cut(29 downto 22)) = '0' else "0";
    tan_phi <= 23x"3fffff" when tan_phi_over(0) = '1' else 23x"400000" when tan_phi_under(0) = '1' else tan_phi_cut(22 downto 0);
    -- atan
    atan_n40 <= unsigned(tan_phi(22 downto 13));
    -- prop
    prop_theta_prop <= signed(prop_row);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                atan_row <= atan_rom(to_integer(atan_n40));
            end if;
            if ce = '1' and phase_2(0) = '1' then
                prop_theta_prop_s9 <= prop_theta_prop;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- atan
    atan_n41 <= signed(atan_row);
    -- (unit)
    n42 <= unsigned(atan_n41);
    n44 <= n42 xor n28;
    n45 <= n44 when n43_s8(0) = '1' else n42;
    n57_sum <= resize(n45, 19) + 19x"00002";
    n57_cut <= n57_sum(18 downto 2);
    n57 <= n57_cut;
    phi_next <= n57(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                phi_next_s10 <= phi_next;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s10 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_1(0) = '1' then
                n50_s11 <= n50_s8;
                n54_s11 <= n54_s8;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_2(0) = '1' then
                n55_s12 <= n55;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    n56 <= signed(shift_left(resize(n50_s11, 40), 18)) + resize(n55_s12, 40);
    n59_sum <= resize(n56, 41) + 41x"00000080000";
    n59_cut <= n59_sum(40 downto 20);
    n59 <= n59_cut;
    theta_next <= unsigned(n59(15 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                phi <= phi_next_s10;
                theta <= theta_next;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s13 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- inputs of mul1 ----
    mul1_in0 <= resize(n54_s11, 21) when phase_2(0) = '1' else y_double_s5;
    mul1_in1 <= recip_sin_half_recip_sin_s6 when phase_1(0) = '1' else resize(prop_theta_prop_s9, 27) when phase_2(0) = '1' else recip_cos_half_recip_cos_s6;

    -- ---- mul1, stage 0 ----
    mul1_n0 <= mul1_in0 * mul1_in1;

    -- ---- results of mul1 ----
    n38 <= mul1_n0;
    n46 <= mul1_n0;
    n55 <= mul1_n0(38 downto 0);

    ready <= phase_0(0);
    valid_out <= valid_s13 and phase_1(0);
end architecture;
