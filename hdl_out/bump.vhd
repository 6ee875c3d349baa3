-- bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
-- made by fixpath 0.1.0; seed 001 (Lee et al.), Fig. 8; the turn psi and the exact pipelines are this project's
--   pipeline=exact-polar conversion=table angle_bits=16 table_addr_bits=10 scheme=direct
--   quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   cos_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
--   highlight=on diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16
--   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
-- latency 24 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 4.50e-4, largest seen 8.09e-3 (529.9 ulp) at phi_l=54099 theta_l=21061 phi_h=60333 theta_h=25870 phi_n=4085 theta_n=24243 psi=15789 phi_p=37530 theta_p=7850
--   diffuse: mean 3.83e-4, largest seen 4.02e-3 (263.2 ulp) at phi_l=44654 theta_l=8576 phi_h=60159 theta_h=5510 phi_n=58665 theta_n=10045 psi=11801 phi_p=60790 theta_p=4186
--   specular: mean 1.09e-4, largest seen 7.98e-3 (522.8 ulp) at phi_l=40708 theta_l=14134 phi_h=34659 theta_h=13276 phi_n=35527 theta_n=15280 psi=31916 phi_p=11259 theta_p=2671
--   dot_l: mean 1.24e-3, largest seen 6.37e-3 (417.4 ulp) at phi_l=61704 theta_l=22170 phi_h=4275 theta_h=14080 phi_n=20110 theta_n=22175 psi=22018 phi_p=55143 theta_p=8416
--   dot_h: mean 1.25e-3, largest seen 6.38e-3 (417.8 ulp) at phi_l=40990 theta_l=19166 phi_h=52190 theta_h=15291 phi_n=57641 theta_n=20094 psi=62778 phi_p=9870 theta_p=8515
--   lt_angle: mean 1.43e-3 rad, largest seen 4.45e-3 rad at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
--   lt_dot: mean 1.43e-3, largest seen 4.45e-3 at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
--   lt_x: mean 7.74e-4, largest seen 4.05e-3 at phi_l=6884 theta_l=16156 phi_h=11810 theta_h=14024 phi_n=5223 theta_n=13921 psi=46897 phi_p=28640 theta_p=7461
--   lt_y: mean 6.21e-4, largest seen 3.10e-3 at phi_l=40221 theta_l=13057 phi_h=11896 theta_h=1741 phi_n=6618 theta_n=8346 psi=32754 phi_p=13032 theta_p=5385
--   lt_z: mean 7.41e-4, largest seen 4.08e-3 at phi_l=55938 theta_l=23167 phi_h=56369 theta_h=21833 phi_n=7227 theta_n=16515 psi=2242 phi_p=14438 theta_p=4655
--   ht_angle: mean 1.43e-3 rad, largest seen 5.28e-3 rad at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
--   ht_dot: mean 1.43e-3, largest seen 5.28e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
--   ht_x: mean 7.83e-4, largest seen 4.09e-3 at phi_l=31111 theta_l=19790 phi_h=29735 theta_h=16324 phi_n=29676 theta_n=17022 psi=22911 phi_p=3532 theta_p=8126
--   ht_y: mean 6.21e-4, largest seen 3.21e-3 at phi_l=15384 theta_l=20283 phi_h=16010 theta_h=30916 phi_n=33483 theta_n=20732 psi=60970 phi_p=20741 theta_p=7238
--   ht_z: mean 7.39e-4, largest seen 4.45e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
-- stated bound on each dot: 2.73e-2
-- stated bound on each diffuse: 1.67e-2
-- stated bound on each specular: 1.81e-1
-- stated bound on each intensity: 1.97e-1
-- stated bound on the angle: 1.82e-2 rad
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity bump is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        phi_l : in unsigned(15 downto 0); -- u16f16
        theta_l : in unsigned(15 downto 0); -- u16f16
        phi_h : in unsigned(15 downto 0); -- u16f16
        theta_h : in unsigned(15 downto 0); -- u16f16
        phi_n : in unsigned(15 downto 0); -- u16f16
        theta_n : in unsigned(15 downto 0); -- u16f16
        psi : in unsigned(15 downto 0); -- u16f16
        phi_p : in unsigned(15 downto 0); -- u16f16
        theta_p : in unsigned(15 downto 0); -- u16f16
        valid_out : out std_logic;
        intensity : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        diffuse : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        specular : out unsigned(15 downto 0) := (others => '0') -- u16f16
    );
end entity;

architecture rtl of bump is
    attribute rom_style : string;

    -- table sincos: sin s20f18, cos s20f18
    type sincos_rom_rows is array (0 to 1023) of unsigned(39 downto 0);
    impure function sincos_rom_file return sincos_rom_rows is
        file source : text open read_mode is "bump_sincos.hex";
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

    -- table recip: recip u20f18
    type recip_rom_rows is array (0 to 1023) of unsigned(19 downto 0);
    impure function recip_rom_file return recip_rom_rows is
        file source : text open read_mode is "bump_recip.hex";
        variable row : line;
        variable all_rows : recip_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant recip_rom : recip_rom_rows := recip_rom_file;
    attribute rom_style of recip_rom : constant is "block";

    -- table atan: atan u19f18, secant u19f18
    type atan_rom_rows is array (0 to 1023) of unsigned(37 downto 0);
    impure function atan_rom_file return atan_rom_rows is
        file source : text open read_mode is "bump_atan.hex";
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

    -- table cos: cos s20f18
    type cos_rom_rows is array (0 to 1023) of unsigned(19 downto 0);
    impure function cos_rom_file return cos_rom_rows is
        file source : text open read_mode is "bump_cos.hex";
        variable row : line;
        variable all_rows : cos_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant cos_rom : cos_rom_rows := cos_rom_file;
    attribute rom_style of cos_rom : constant is "block";

    -- table diffuse: light u16f16
    type diffuse_rom_rows is array (0 to 1023) of unsigned(15 downto 0);
    impure function diffuse_rom_file return diffuse_rom_rows is
        file source : text open read_mode is "bump_diffuse.hex";
        variable row : line;
        variable all_rows : diffuse_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant diffuse_rom : diffuse_rom_rows := diffuse_rom_file;
    attribute rom_style of diffuse_rom : constant is "block";

    -- table specular: light u16f16
    type specular_rom_rows is array (0 to 1023) of unsigned(15 downto 0);
    impure function specular_rom_file return specular_rom_rows is
        file source : text open read_mode is "bump_specular.hex";
        variable row : line;
        variable all_rows : specular_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant specular_rom : specular_rom_rows := specular_rom_file;
    attribute rom_style of specular_rom : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_2 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_2 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_3 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_3 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_4 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_4 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_5 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_5 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_6 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_6 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_7 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_7 : constant is "block";

    -- a copy of table sincos: sin s20f18, cos s20f18
    constant sincos_rom_8 : sincos_rom_rows := sincos_rom;
    attribute rom_style of sincos_rom_8 : constant is "block";

    -- a copy of table recip: recip u20f18
    constant recip_rom_2 : recip_rom_rows := recip_rom;
    attribute rom_style of recip_rom_2 : constant is "block";

    -- a copy of table atan: atan u19f18, secant u19f18
    constant atan_rom_2 : atan_rom_rows := atan_rom;
    attribute rom_style of atan_rom_2 : constant is "block";

    -- a copy of table cos: cos s20f18
    constant cos_rom_2 : cos_rom_rows := cos_rom;
    attribute rom_style of cos_rom_2 : constant is "block";

    -- a copy of table cos: cos s20f18
    constant cos_rom_3 : cos_rom_rows := cos_rom;
    attribute rom_style of cos_rom_3 : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal light_angles_n9 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal light_angles_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n11 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal light_angles_ang_x : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n13 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal light_angles_ang_y : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n15 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal light_angles_x_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n17 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal light_angles_x_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n19 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal light_angles_y_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n21 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal light_angles_y_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n23 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal light_angles_a_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_angles_n25 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal light_angles_a_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_sincos_n27 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n29 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n31 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n34 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n37 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n40 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n43 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_sincos_n46 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_azimuth_n88 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal light_azimuth_n92 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal half_angles_n134 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal half_angles_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n136 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal half_angles_ang_x : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n138 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal half_angles_ang_y : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n140 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal half_angles_x_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n142 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal half_angles_x_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n144 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal half_angles_y_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n146 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal half_angles_y_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n148 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal half_angles_a_plus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_angles_n150 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal half_angles_a_minus_n : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_sincos_n152 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n154 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n156 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n159 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n162 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n165 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n168 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_sincos_n171 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal bump_n257 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal bump_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n297 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n306 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n307 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n318 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n319 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal theta_p_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal sincos_row : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_2 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_3 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_4 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_5 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_6 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_7 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_8 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_9 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_10 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_11 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_12 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_13 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_14 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_15 : unsigned(39 downto 0) := (others => '0');
    signal sincos_row_16 : unsigned(39 downto 0) := (others => '0');
    signal bump_phi_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s1 : std_logic;
    -- stage 1
    signal light_sincos_cos_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_sin_xpn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_xpn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_sin_xmn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_xmn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_sin_ypn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_ypn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_sin_ymn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_ymn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_sin_apn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_apn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_sin_amn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sincos_cos_amn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_sums_n49 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_n50 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_n51 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal light_sums_n52 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal light_sums_n53 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_n54 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal light_sums_n56 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_y_sum : signed(20 downto 0) := (others => '0'); -- s21f19
    signal light_sums_n58 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_n59 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_n60 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal light_sums_n61 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal light_sums_n62 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_sums_n63 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal half_sincos_cos_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_sin_xpn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_xpn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_sin_xmn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_xmn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_sin_ypn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_ypn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_sin_ymn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_ymn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_sin_apn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_apn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_sin_amn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sincos_cos_amn : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_sums_n174 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_n175 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_n176 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal half_sums_n177 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal half_sums_n178 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_n179 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal half_sums_n181 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_y_sum : signed(20 downto 0) := (others => '0'); -- s21f19
    signal half_sums_n183 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_n184 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_n185 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal half_sums_n186 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal half_sums_n187 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_sums_n188 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal theta_p_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_sums_n52_s2 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal light_sums_n54_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal light_sums_y_sum_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal light_sums_n61_s2 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal light_sums_n63_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal half_sums_n177_s2 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal half_sums_n179_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal half_sums_y_sum_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal half_sums_n186_s2 : signed(21 downto 0) := (others => '0'); -- s22f20
    signal half_sums_n188_s2 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal bump_phi_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s2 : std_logic;
    -- stage 2
    signal light_sums_x_sum : signed(22 downto 0) := (others => '0'); -- s23f20
    signal light_sums_z_sum : signed(22 downto 0) := (others => '0'); -- s23f20
    signal light_x_sum : signed(23 downto 0) := (others => '0');
    signal light_x_cut : signed(21 downto 0) := (others => '0');
    signal light_x_over : unsigned(0 downto 0) := (others => '0');
    signal light_x_under : unsigned(0 downto 0) := (others => '0');
    signal light_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_y_sum : signed(21 downto 0) := (others => '0');
    signal light_y_cut : signed(20 downto 0) := (others => '0');
    signal light_y_over : unsigned(0 downto 0) := (others => '0');
    signal light_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_z_sum : signed(23 downto 0) := (others => '0');
    signal light_z_cut : signed(21 downto 0) := (others => '0');
    signal light_z_over : unsigned(0 downto 0) := (others => '0');
    signal light_z_under : unsigned(0 downto 0) := (others => '0');
    signal light_z : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_azimuth_n68_neg : unsigned(19 downto 0) := (others => '0');
    signal light_azimuth_n68 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n69_neg : unsigned(19 downto 0) := (others => '0');
    signal light_azimuth_n69 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n91 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_neg : unsigned(19 downto 0) := (others => '0');
    signal light_polar_angle_n102 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_sums_x_sum : signed(22 downto 0) := (others => '0'); -- s23f20
    signal half_sums_z_sum : signed(22 downto 0) := (others => '0'); -- s23f20
    signal half_x_sum : signed(23 downto 0) := (others => '0');
    signal half_x_cut : signed(21 downto 0) := (others => '0');
    signal half_x_over : unsigned(0 downto 0) := (others => '0');
    signal half_x_under : unsigned(0 downto 0) := (others => '0');
    signal half_x : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_y_sum : signed(21 downto 0) := (others => '0');
    signal half_y_cut : signed(20 downto 0) := (others => '0');
    signal half_y_over : unsigned(0 downto 0) := (others => '0');
    signal half_y : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_z_sum : signed(23 downto 0) := (others => '0');
    signal half_z_cut : signed(21 downto 0) := (others => '0');
    signal half_z_over : unsigned(0 downto 0) := (others => '0');
    signal half_z_under : unsigned(0 downto 0) := (others => '0');
    signal half_z : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_azimuth_n193_neg : unsigned(19 downto 0) := (others => '0');
    signal half_azimuth_n193 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n194_neg : unsigned(19 downto 0) := (others => '0');
    signal half_azimuth_n194 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n215 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_neg : unsigned(19 downto 0) := (others => '0');
    signal half_polar_angle_n225 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal theta_p_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n68_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n69_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n91_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n193_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n194_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n215_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s3 : std_logic;
    -- stage 3
    signal light_azimuth_n70 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n71 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n72 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n73_padded : unsigned(31 downto 0) := (others => '0');
    signal light_azimuth_n73_skip16 : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n73_part16 : unsigned(15 downto 0) := (others => '0');
    signal light_azimuth_n73_skip8 : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n73_part8 : unsigned(7 downto 0) := (others => '0');
    signal light_azimuth_n73_skip4 : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n73_part4 : unsigned(3 downto 0) := (others => '0');
    signal light_azimuth_n73_skip2 : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n73_part2 : unsigned(1 downto 0) := (others => '0');
    signal light_azimuth_n73_skip1 : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n73 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal half_azimuth_n195 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n197 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n198_padded : unsigned(31 downto 0) := (others => '0');
    signal half_azimuth_n198_skip16 : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n198_part16 : unsigned(15 downto 0) := (others => '0');
    signal half_azimuth_n198_skip8 : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n198_part8 : unsigned(7 downto 0) := (others => '0');
    signal half_azimuth_n198_skip4 : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n198_part4 : unsigned(3 downto 0) := (others => '0');
    signal half_azimuth_n198_skip2 : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n198_part2 : unsigned(1 downto 0) := (others => '0');
    signal half_azimuth_n198_skip1 : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n198 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal theta_p_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n70_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n71_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n72_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n73_s4 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal light_azimuth_n91_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n195_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n197_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n198_s4 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal half_azimuth_n215_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s4 : std_logic;
    -- stage 4
    signal light_azimuth_n74_past : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n74_count : unsigned(4 downto 0) := (others => '0');
    signal light_azimuth_n74 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal light_azimuth_n75 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal light_azimuth_n76_past : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n76_count : unsigned(4 downto 0) := (others => '0');
    signal light_azimuth_n76 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal light_azimuth_n77 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal light_azimuth_n78 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal light_azimuth_n79 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal light_azimuth_recip_n80 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_azimuth_n82 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal half_azimuth_n199_past : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n199_count : unsigned(4 downto 0) := (others => '0');
    signal half_azimuth_n199 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal half_azimuth_n200 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal half_azimuth_n201_past : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n201_count : unsigned(4 downto 0) := (others => '0');
    signal half_azimuth_n201 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal half_azimuth_n202 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal half_azimuth_n203 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal half_azimuth_n204 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal half_azimuth_recip_n205 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_azimuth_n207 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal theta_p_s5 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n70_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n71_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal recip_row : unsigned(19 downto 0) := (others => '0');
    signal light_azimuth_n82_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal light_azimuth_n91_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n195_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal recip_row_2 : unsigned(19 downto 0) := (others => '0');
    signal half_azimuth_n207_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal half_azimuth_n215_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s5 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s5 : std_logic;
    -- stage 5
    signal light_azimuth_recip_n81 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_recip_n206 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal theta_p_s6 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n70_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n71_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_recip_n81_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n82_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal light_azimuth_n91_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n195_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_recip_n206_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n207_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal half_azimuth_n215_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s6 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s6 : std_logic;
    -- stage 6
    signal light_azimuth_n83 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal half_azimuth_n208 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal theta_p_s7 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n70_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n71_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_n83_s7 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal light_azimuth_n91_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n195_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_n208_s7 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal half_azimuth_n215_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s7 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s7 : std_logic;
    -- stage 7
    signal light_azimuth_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal light_azimuth_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal light_azimuth_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal light_azimuth_atan_n85 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_azimuth_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal half_azimuth_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal half_azimuth_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal half_azimuth_atan_n210 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal theta_p_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n70_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n71_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal atan_row : unsigned(37 downto 0) := (others => '0');
    signal light_azimuth_n91_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n195_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal atan_row_2 : unsigned(37 downto 0) := (others => '0');
    signal half_azimuth_n215_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s8 : std_logic;
    -- stage 8
    signal light_azimuth_atan_n86 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal light_azimuth_atan_n87 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal light_azimuth_n89 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_azimuth_n90 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_azimuth_atan_n211 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal half_azimuth_atan_n212 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal half_azimuth_n213 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_azimuth_n214 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal theta_p_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n71_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_azimuth_atan_n87_s9 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal light_azimuth_n90_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_azimuth_n91_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_azimuth_n95_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n102_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n196_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_azimuth_atan_n212_s9 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal half_azimuth_n214_s9 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_azimuth_n215_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n218_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal bump_phi_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s9 : std_logic;
    -- stage 9
    signal light_azimuth_n93 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_azimuth_n94 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_azimuth_n96 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal light_azimuth_n97 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal light_azimuth_n98 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal light_azimuth_n99 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal light_n130_sum : unsigned(18 downto 0) := (others => '0');
    signal light_n130_cut : unsigned(16 downto 0) := (others => '0');
    signal light_n130 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal light_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_azimuth_n216 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_azimuth_n217 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_azimuth_n219 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal half_azimuth_n220 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal half_azimuth_n221 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal half_azimuth_n222 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal half_n253_sum : unsigned(18 downto 0) := (others => '0');
    signal half_n253_cut : unsigned(16 downto 0) := (others => '0');
    signal half_n253 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal half_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal theta_p_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_azimuth_n99_s10 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal light_polar_angle_n102_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_phi_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_azimuth_n222_s10 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal half_polar_angle_n225_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_phi_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal bump_phi_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s10 : std_logic;
    -- stage 10
    signal light_azimuth_n100_sum : unsigned(39 downto 0) := (others => '0');
    signal light_azimuth_n100_cut : unsigned(21 downto 0) := (others => '0');
    signal light_azimuth_n100_over : unsigned(0 downto 0) := (others => '0');
    signal light_azimuth_n100 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_n101_over : unsigned(0 downto 0) := (others => '0');
    signal light_n101_under : unsigned(0 downto 0) := (others => '0');
    signal light_n101 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_polar_angle_n103_neg : unsigned(19 downto 0) := (others => '0');
    signal light_polar_angle_n103 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n126 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_azimuth_n223_sum : unsigned(39 downto 0) := (others => '0');
    signal half_azimuth_n223_cut : unsigned(21 downto 0) := (others => '0');
    signal half_azimuth_n223_over : unsigned(0 downto 0) := (others => '0');
    signal half_azimuth_n223 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_n224_over : unsigned(0 downto 0) := (others => '0');
    signal half_n224_under : unsigned(0 downto 0) := (others => '0');
    signal half_n224 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_polar_angle_n226_neg : unsigned(19 downto 0) := (others => '0');
    signal half_polar_angle_n226 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n249 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_n259 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal dot_l_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_cos_n269 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_h_n278 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal dot_h_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_h_cos_n288 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal theta_p_s11 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n102_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n103_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n123_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n225_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n226_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n246_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal cos_row : unsigned(19 downto 0) := (others => '0');
    signal cos_row_2 : unsigned(19 downto 0) := (others => '0');
    signal valid_s11 : std_logic;
    -- stage 11
    signal light_polar_angle_n104 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n105 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n106 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n107_padded : unsigned(31 downto 0) := (others => '0');
    signal light_polar_angle_n107_skip16 : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n107_part16 : unsigned(15 downto 0) := (others => '0');
    signal light_polar_angle_n107_skip8 : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n107_part8 : unsigned(7 downto 0) := (others => '0');
    signal light_polar_angle_n107_skip4 : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n107_part4 : unsigned(3 downto 0) := (others => '0');
    signal light_polar_angle_n107_skip2 : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n107_part2 : unsigned(1 downto 0) := (others => '0');
    signal light_polar_angle_n107_skip1 : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n107 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal half_polar_angle_n227 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n228 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n229 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n230_padded : unsigned(31 downto 0) := (others => '0');
    signal half_polar_angle_n230_skip16 : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n230_part16 : unsigned(15 downto 0) := (others => '0');
    signal half_polar_angle_n230_skip8 : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n230_part8 : unsigned(7 downto 0) := (others => '0');
    signal half_polar_angle_n230_skip4 : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n230_part4 : unsigned(3 downto 0) := (others => '0');
    signal half_polar_angle_n230_skip2 : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n230_part2 : unsigned(1 downto 0) := (others => '0');
    signal half_polar_angle_n230_skip1 : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n230 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal dot_l_cos_cos_delta : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta : signed(19 downto 0) := (others => '0'); -- s20f18
    signal theta_p_s12 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n104_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n105_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n106_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n107_s12 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal light_polar_angle_n123_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n227_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n228_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n229_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n230_s12 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal half_polar_angle_n246_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_cos_cos_delta_s12 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s12 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s12 : std_logic;
    -- stage 12
    signal light_polar_angle_n108_past : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n108_count : unsigned(4 downto 0) := (others => '0');
    signal light_polar_angle_n108 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal light_polar_angle_n109 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal light_polar_angle_n110_past : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_n110_count : unsigned(4 downto 0) := (others => '0');
    signal light_polar_angle_n110 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal light_polar_angle_n111 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal light_polar_angle_n112 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal light_polar_angle_n113 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal light_polar_angle_recip_n114 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_polar_angle_n116 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal half_polar_angle_n231_past : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n231_count : unsigned(4 downto 0) := (others => '0');
    signal half_polar_angle_n231 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal half_polar_angle_n232 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal half_polar_angle_n233_past : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_n233_count : unsigned(4 downto 0) := (others => '0');
    signal half_polar_angle_n233 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal half_polar_angle_n234 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal half_polar_angle_n235 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal half_polar_angle_n236 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal half_polar_angle_recip_n237 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_polar_angle_n239 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal theta_p_s13 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n104_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal recip_row_3 : unsigned(19 downto 0) := (others => '0');
    signal light_polar_angle_n116_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal light_polar_angle_n123_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n227_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal recip_row_4 : unsigned(19 downto 0) := (others => '0');
    signal half_polar_angle_n239_s13 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal half_polar_angle_n246_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_cos_cos_delta_s13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s13 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s13 : std_logic;
    -- stage 13
    signal light_polar_angle_recip_n115 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_recip_n238 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal theta_p_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n104_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_recip_n115_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal light_polar_angle_n116_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal light_polar_angle_n123_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n227_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_recip_n238_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal half_polar_angle_n239_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal half_polar_angle_n246_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_cos_cos_delta_s14 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s14 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s14 : std_logic;
    -- stage 14
    signal light_polar_angle_n117 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal half_polar_angle_n240 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal theta_p_s15 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n104_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n117_s15 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal light_polar_angle_n123_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n227_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n240_s15 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal half_polar_angle_n246_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_cos_cos_delta_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s15 : std_logic;
    -- stage 15
    signal light_polar_angle_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal light_polar_angle_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal light_polar_angle_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal light_polar_angle_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal light_polar_angle_atan_n119 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_polar_angle_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal half_polar_angle_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal half_polar_angle_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal half_polar_angle_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal half_polar_angle_atan_n242 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal theta_p_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n104_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal atan_row_3 : unsigned(37 downto 0) := (others => '0');
    signal light_polar_angle_n123_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n227_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal atan_row_4 : unsigned(37 downto 0) := (others => '0');
    signal half_polar_angle_n246_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_cos_cos_delta_s16 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s16 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s16 : std_logic;
    -- stage 16
    signal light_polar_angle_atan_n120 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal light_polar_angle_n121 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_polar_angle_n122 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_polar_angle_atan_n243 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal half_polar_angle_n244 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_polar_angle_n245 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal theta_p_s17 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_polar_angle_n122_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal light_polar_angle_n123_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal light_polar_angle_n126_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n245_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal half_polar_angle_n246_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal half_polar_angle_n249_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal dot_l_cos_cos_delta_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s17 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s17 : std_logic;
    -- stage 17
    signal light_polar_angle_n124 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_polar_angle_n125 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal light_polar_angle_n127 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal light_polar_angle_n128 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal light_polar_angle_n129 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal light_n132_sum : unsigned(18 downto 0) := (others => '0');
    signal light_n132_cut : unsigned(16 downto 0) := (others => '0');
    signal light_n132 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal light_theta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_polar_angle_n247 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_polar_angle_n248 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal half_polar_angle_n250 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal half_polar_angle_n251 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal half_polar_angle_n252 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal half_n255_sum : unsigned(18 downto 0) := (others => '0');
    signal half_n255_cut : unsigned(16 downto 0) := (others => '0');
    signal half_n255 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal half_theta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal theta_p_s18 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_theta_s18 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_theta_s18 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_cos_cos_delta_s18 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_delta_s18 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s18 : std_logic;
    -- stage 18
    signal dot_l_n261 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal dot_l_sum : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_n263 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal dot_l_difference : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_l_cos_n265 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_l_cos_n267 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_h_n280 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal dot_h_sum : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_h_n282 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal dot_h_difference : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal dot_h_cos_n284 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal dot_h_cos_n286 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal cos_row_3 : unsigned(19 downto 0) := (others => '0');
    signal cos_row_4 : unsigned(19 downto 0) := (others => '0');
    signal dot_l_cos_cos_delta_s19 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal cos_row_5 : unsigned(19 downto 0) := (others => '0');
    signal cos_row_6 : unsigned(19 downto 0) := (others => '0');
    signal dot_h_cos_cos_delta_s19 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal valid_s19 : std_logic;
    -- stage 19
    signal dot_l_cos_cos_sum : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_cos_cos_difference : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_n271 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_l_n272 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_l_n273 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_l_n274 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_h_cos_cos_sum : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_cos_cos_difference : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_n290 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_h_n291 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_h_n292 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal dot_h_n293 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_l_cos_cos_delta_s20 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_l_n272_s20 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_l_n274_s20 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_h_cos_cos_delta_s20 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal dot_h_n291_s20 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_h_n293_s20 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal valid_s20 : std_logic;
    -- stage 20
    signal dot_l_n275 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal dot_h_n294 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal dot_l_n272_s21 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_l_n275_s21 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal dot_h_n291_s21 : signed(20 downto 0) := (others => '0'); -- s21f19
    signal dot_h_n294_s21 : signed(40 downto 0) := (others => '0'); -- s41f37
    signal valid_s21 : std_logic;
    -- stage 21
    signal dot_l_n276 : signed(41 downto 0) := (others => '0'); -- s42f37
    signal dot_l_sum_2 : signed(42 downto 0) := (others => '0');
    signal dot_l_cut : signed(21 downto 0) := (others => '0');
    signal dot_l_over : unsigned(0 downto 0) := (others => '0');
    signal dot_l_under : unsigned(0 downto 0) := (others => '0');
    signal dot_l : signed(17 downto 0) := (others => '0'); -- s18f16
    signal dot_h_n295 : signed(41 downto 0) := (others => '0'); -- s42f37
    signal dot_h_sum_2 : signed(42 downto 0) := (others => '0');
    signal dot_h_cut : signed(21 downto 0) := (others => '0');
    signal dot_h_over : unsigned(0 downto 0) := (others => '0');
    signal dot_h_under : unsigned(0 downto 0) := (others => '0');
    signal dot_h : signed(17 downto 0) := (others => '0'); -- s18f16
    signal n298 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n299 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal diffuse_index_under : unsigned(0 downto 0) := (others => '0');
    signal diffuse_index : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n301 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n302 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal n303 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal diffuse_n304 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n310 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n311 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal specular_index_under : unsigned(0 downto 0) := (others => '0');
    signal specular_index : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal n313 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n314 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal n315 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_n316 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n298_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n301_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_n304_s22 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal n310_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n313_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal specular_n316_s22 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal valid_s22 : std_logic;
    -- stage 22
    signal n298_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n301_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal diffuse_row : unsigned(15 downto 0) := (others => '0');
    signal n310_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal n313_s23 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal specular_row : unsigned(15 downto 0) := (others => '0');
    signal valid_s23 : std_logic;
    -- stage 23
    signal diffuse_n305 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n308 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal diffuse_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_n317 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n320 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal specular_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n322 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal intensity_next_over : unsigned(0 downto 0) := (others => '0');
    signal intensity_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s24 : std_logic;
begin

    -- ---- stage 0 ----
    -- light.angles
    light_angles_n9 <= signed(resize(phi_l, 17)) - signed(resize(phi_n, 17));
    light_angles_delta <= unsigned(light_angles_n9(15 downto 0));
    light_angles_n11 <= resize(theta_l, 17) + resize(light_angles_delta, 17);
    light_angles_ang_x <= light_angles_n11(15 downto 0);
    light_angles_n13 <= signed(resize(theta_l, 17)) - signed(resize(light_angles_delta, 17));
    light_angles_ang_y <= unsigned(light_angles_n13(15 downto 0));
    light_angles_n15 <= resize(light_angles_ang_x, 17) + resize(theta_n, 17);
    light_angles_x_plus_n <= light_angles_n15(15 downto 0);
    light_angles_n17 <= signed(resize(light_angles_ang_x, 17)) - signed(resize(theta_n, 17));
    light_angles_x_minus_n <= unsigned(light_angles_n17(15 downto 0));
    light_angles_n19 <= resize(light_angles_ang_y, 17) + resize(theta_n, 17);
    light_angles_y_plus_n <= light_angles_n19(15 downto 0);
    light_angles_n21 <= signed(resize(light_angles_ang_y, 17)) - signed(resize(theta_n, 17));
    light_angles_y_minus_n <= unsigned(light_angles_n21(15 downto 0));
    light_angles_n23 <= resize(theta_l, 17) + resize(theta_n, 17);
    light_angles_a_plus_n <= light_angles_n23(15 downto 0);
    light_angles_n25 <= signed(resize(theta_l, 17)) - signed(resize(theta_n, 17));
    light_angles_a_minus_n <= unsigned(light_angles_n25(15 downto 0));
    -- light.sincos
    light_sincos_n27 <= light_angles_ang_y(15 downto 6);
    light_sincos_n29 <= light_angles_ang_x(15 downto 6);
    light_sincos_n31 <= light_angles_x_plus_n(15 downto 6);
    light_sincos_n34 <= light_angles_x_minus_n(15 downto 6);
    light_sincos_n37 <= light_angles_y_plus_n(15 downto 6);
    light_sincos_n40 <= light_angles_y_minus_n(15 downto 6);
    light_sincos_n43 <= light_angles_a_plus_n(15 downto 6);
    light_sincos_n46 <= light_angles_a_minus_n(15 downto 6);
    -- light.azimuth
    light_azimuth_n88 <= 19x"10000";
    light_azimuth_n92 <= 19x"20000";
    -- half.angles
    half_angles_n134 <= signed(resize(phi_h, 17)) - signed(resize(phi_n, 17));
    half_angles_delta <= unsigned(half_angles_n134(15 downto 0));
    half_angles_n136 <= resize(theta_h, 17) + resize(half_angles_delta, 17);
    half_angles_ang_x <= half_angles_n136(15 downto 0);
    half_angles_n138 <= signed(resize(theta_h, 17)) - signed(resize(half_angles_delta, 17));
    half_angles_ang_y <= unsigned(half_angles_n138(15 downto 0));
    half_angles_n140 <= resize(half_angles_ang_x, 17) + resize(theta_n, 17);
    half_angles_x_plus_n <= half_angles_n140(15 downto 0);
    half_angles_n142 <= signed(resize(half_angles_ang_x, 17)) - signed(resize(theta_n, 17));
    half_angles_x_minus_n <= unsigned(half_angles_n142(15 downto 0));
    half_angles_n144 <= resize(half_angles_ang_y, 17) + resize(theta_n, 17);
    half_angles_y_plus_n <= half_angles_n144(15 downto 0);
    half_angles_n146 <= signed(resize(half_angles_ang_y, 17)) - signed(resize(theta_n, 17));
    half_angles_y_minus_n <= unsigned(half_angles_n146(15 downto 0));
    half_angles_n148 <= resize(theta_h, 17) + resize(theta_n, 17);
    half_angles_a_plus_n <= half_angles_n148(15 downto 0);
    half_angles_n150 <= signed(resize(theta_h, 17)) - signed(resize(theta_n, 17));
    half_angles_a_minus_n <= unsigned(half_angles_n150(15 downto 0));
    -- half.sincos
    half_sincos_n152 <= half_angles_ang_y(15 downto 6);
    half_sincos_n154 <= half_angles_ang_x(15 downto 6);
    half_sincos_n156 <= half_angles_x_plus_n(15 downto 6);
    half_sincos_n159 <= half_angles_x_minus_n(15 downto 6);
    half_sincos_n162 <= half_angles_y_plus_n(15 downto 6);
    half_sincos_n165 <= half_angles_y_minus_n(15 downto 6);
    half_sincos_n168 <= half_angles_a_plus_n(15 downto 6);
    half_sincos_n171 <= half_angles_a_minus_n(15 downto 6);
    -- bump
    bump_n257 <= resize(phi_p, 17) + resize(psi, 17);
    bump_phi <= bump_n257(15 downto 0);
    -- (unit)
    n297 <= "0";
    n306 <= 16x"b333";
    n307 <= 16x"199a";
    n318 <= 16x"4ccd";
    n319 <= 16x"0000";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s1 <= theta_p;
                sincos_row <= sincos_rom(to_integer(light_sincos_n27));
                sincos_row_2 <= sincos_rom(to_integer(light_sincos_n29));
                sincos_row_3 <= sincos_rom_2(to_integer(light_sincos_n31));
                sincos_row_4 <= sincos_rom_2(to_integer(light_sincos_n34));
                sincos_row_5 <= sincos_rom_3(to_integer(light_sincos_n37));
                sincos_row_6 <= sincos_rom_3(to_integer(light_sincos_n40));
                sincos_row_7 <= sincos_rom_4(to_integer(light_sincos_n43));
                sincos_row_8 <= sincos_rom_4(to_integer(light_sincos_n46));
                sincos_row_9 <= sincos_rom_5(to_integer(half_sincos_n152));
                sincos_row_10 <= sincos_rom_5(to_integer(half_sincos_n154));
                sincos_row_11 <= sincos_rom_6(to_integer(half_sincos_n156));
                sincos_row_12 <= sincos_rom_6(to_integer(half_sincos_n159));
                sincos_row_13 <= sincos_rom_7(to_integer(half_sincos_n162));
                sincos_row_14 <= sincos_rom_7(to_integer(half_sincos_n165));
                sincos_row_15 <= sincos_rom_8(to_integer(half_sincos_n168));
                sincos_row_16 <= sincos_rom_8(to_integer(half_sincos_n171));
                bump_phi_s1 <= bump_phi;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- light.sincos
    light_sincos_cos_y <= signed(sincos_row(19 downto 0));
    light_sincos_cos_x <= signed(sincos_row_2(19 downto 0));
    light_sincos_sin_xpn <= signed(sincos_row_3(39 downto 20));
    light_sincos_cos_xpn <= signed(sincos_row_3(19 downto 0));
    light_sincos_sin_xmn <= signed(sincos_row_4(39 downto 20));
    light_sincos_cos_xmn <= signed(sincos_row_4(19 downto 0));
    light_sincos_sin_ypn <= signed(sincos_row_5(39 downto 20));
    light_sincos_cos_ypn <= signed(sincos_row_5(19 downto 0));
    light_sincos_sin_ymn <= signed(sincos_row_6(39 downto 20));
    light_sincos_cos_ymn <= signed(sincos_row_6(19 downto 0));
    light_sincos_sin_apn <= signed(sincos_row_7(39 downto 20));
    light_sincos_cos_apn <= signed(sincos_row_7(19 downto 0));
    light_sincos_sin_amn <= signed(sincos_row_8(39 downto 20));
    light_sincos_cos_amn <= signed(sincos_row_8(19 downto 0));
    -- light.sums
    light_sums_n49 <= resize(light_sincos_sin_xpn, 21) + resize(light_sincos_sin_xmn, 21);
    light_sums_n50 <= resize(light_sincos_sin_ypn, 21) + resize(light_sincos_sin_ymn, 21);
    light_sums_n51 <= resize(light_sums_n49, 22) + resize(light_sums_n50, 22);
    light_sums_n52 <= light_sums_n51;
    light_sums_n53 <= resize(light_sincos_sin_apn, 21) - resize(light_sincos_sin_amn, 21);
    light_sums_n54 <= light_sums_n53;
    light_sums_n56 <= resize(light_sincos_cos_y, 21) - resize(light_sincos_cos_x, 21);
    light_sums_y_sum <= light_sums_n56;
    light_sums_n58 <= resize(light_sincos_cos_xmn, 21) - resize(light_sincos_cos_xpn, 21);
    light_sums_n59 <= resize(light_sincos_cos_ymn, 21) - resize(light_sincos_cos_ypn, 21);
    light_sums_n60 <= resize(light_sums_n58, 22) + resize(light_sums_n59, 22);
    light_sums_n61 <= light_sums_n60;
    light_sums_n62 <= resize(light_sincos_cos_apn, 21) + resize(light_sincos_cos_amn, 21);
    light_sums_n63 <= light_sums_n62;
    -- half.sincos
    half_sincos_cos_y <= signed(sincos_row_9(19 downto 0));
    half_sincos_cos_x <= signed(sincos_row_10(19 downto 0));
    half_sincos_sin_xpn <= signed(sincos_row_11(39 downto 20));
    half_sincos_cos_xpn <= signed(sincos_row_11(19 downto 0));
    half_sincos_sin_xmn <= signed(sincos_row_12(39 downto 20));
    half_sincos_cos_xmn <= signed(sincos_row_12(19 downto 0));
    half_sincos_sin_ypn <= signed(sincos_row_13(39 downto 20));
    half_sincos_cos_ypn <= signed(sincos_row_13(19 downto 0));
    half_sincos_sin_ymn <= signed(sincos_row_14(39 downto 20));
    half_sincos_cos_ymn <= signed(sincos_row_14(19 downto 0));
    half_sincos_sin_apn <= signed(sincos_row_15(39 downto 20));
    half_sincos_cos_apn <= signed(sincos_row_15(19 downto 0));
    half_sincos_sin_amn <= signed(sincos_row_16(39 downto 20));
    half_sincos_cos_amn <= signed(sincos_row_16(19 downto 0));
    -- half.sums
    half_sums_n174 <= resize(half_sincos_sin_xpn, 21) + resize(half_sincos_sin_xmn, 21);
    half_sums_n175 <= resize(half_sincos_sin_ypn, 21) + resize(half_sincos_sin_ymn, 21);
    half_sums_n176 <= resize(half_sums_n174, 22) + resize(half_sums_n175, 22);
    half_sums_n177 <= half_sums_n176;
    half_sums_n178 <= resize(half_sincos_sin_apn, 21) - resize(half_sincos_sin_amn, 21);
    half_sums_n179 <= half_sums_n178;
    half_sums_n181 <= resize(half_sincos_cos_y, 21) - resize(half_sincos_cos_x, 21);
    half_sums_y_sum <= half_sums_n181;
    half_sums_n183 <= resize(half_sincos_cos_xmn, 21) - resize(half_sincos_cos_xpn, 21);
    half_sums_n184 <= resize(half_sincos_cos_ymn, 21) - resize(half_sincos_cos_ypn, 21);
    half_sums_n185 <= resize(half_sums_n183, 22) + resize(half_sums_n184, 22);
    half_sums_n186 <= half_sums_n185;
    half_sums_n187 <= resize(half_sincos_cos_apn, 21) + resize(half_sincos_cos_amn, 21);
    half_sums_n188 <= half_sums_n187;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s2 <= theta_p_s1;
                light_sums_n52_s2 <= light_sums_n52;
                light_sums_n54_s2 <= light_sums_n54;
                light_sums_y_sum_s2 <= light_sums_y_sum;
                light_sums_n61_s2 <= light_sums_n61;
                light_sums_n63_s2 <= light_sums_n63;
                half_sums_n177_s2 <= half_sums_n177;
                half_sums_n179_s2 <= half_sums_n179;
                half_sums_y_sum_s2 <= half_sums_y_sum;
                half_sums_n186_s2 <= half_sums_n186;
                half_sums_n188_s2 <= half_sums_n188;
                bump_phi_s2 <= bump_phi_s1;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- light.sums
    light_sums_x_sum <= resize(light_sums_n52_s2, 23) - shift_left(resize(light_sums_n54_s2, 23), 1);
    light_sums_z_sum <= resize(light_sums_n61_s2, 23) + shift_left(resize(light_sums_n63_s2, 23), 1);
    -- light
    light_x_sum <= resize(light_sums_x_sum, 24) + 24x"000002";
    light_x_cut <= light_x_sum(23 downto 2);
    light_x_over <= "1" when light_x_cut(21) = '0' and (or light_x_cut(20 downto 19)) = '1' else "0";
    light_x_under <= "1" when light_x_cut(21) = '1' and (and light_x_cut(20 downto 19)) = '0' else "0";
    light_x <= 20x"7ffff" when light_x_over(0) = '1' else 20x"80000" when light_x_under(0) = '1' else light_x_cut(19 downto 0);
    light_y_sum <= resize(light_sums_y_sum_s2, 22) + 22x"000001";
    light_y_cut <= light_y_sum(21 downto 1);
    light_y_over <= "1" when light_y_cut(20) = '0' and (or light_y_cut(19 downto 19)) = '1' else "0";
    light_y <= 20x"7ffff" when light_y_over(0) = '1' else light_y_cut(19 downto 0);
    light_z_sum <= resize(light_sums_z_sum, 24) + 24x"000002";
    light_z_cut <= light_z_sum(23 downto 2);
    light_z_over <= "1" when light_z_cut(21) = '0' and (or light_z_cut(20 downto 19)) = '1' else "0";
    light_z_under <= "1" when light_z_cut(21) = '1' and (and light_z_cut(20 downto 19)) = '0' else "0";
    light_z <= 20x"7ffff" when light_z_over(0) = '1' else 20x"80000" when light_z_under(0) = '1' else light_z_cut(19 downto 0);
    -- light.azimuth
    light_azimuth_n68_neg <= unsigned(-light_x);
    light_azimuth_n68 <= light_azimuth_n68_neg when light_x(19) = '1' else unsigned(light_x);
    light_azimuth_n69_neg <= unsigned(-light_y);
    light_azimuth_n69 <= light_azimuth_n69_neg when light_y(19) = '1' else unsigned(light_y);
    light_azimuth_n91 <= unsigned(light_x(19 downto 19));
    light_azimuth_n95 <= unsigned(light_y(19 downto 19));
    -- light.polar_angle
    light_polar_angle_n102_neg <= unsigned(-light_z);
    light_polar_angle_n102 <= light_polar_angle_n102_neg when light_z(19) = '1' else unsigned(light_z);
    light_polar_angle_n123 <= unsigned(light_z(19 downto 19));
    -- half.sums
    half_sums_x_sum <= resize(half_sums_n177_s2, 23) - shift_left(resize(half_sums_n179_s2, 23), 1);
    half_sums_z_sum <= resize(half_sums_n186_s2, 23) + shift_left(resize(half_sums_n188_s2, 23), 1);
    -- half
    half_x_sum <= resize(half_sums_x_sum, 24) + 24x"000002";
    half_x_cut <= half_x_sum(23 downto 2);
    half_x_over <= "1" when half_x_cut(21) = '0' and (or half_x_cut(20 downto 19)) = '1' else "0";
    half_x_under <= "1" when half_x_cut(21) = '1' and (and half_x_cut(20 downto 19)) = '0' else "0";
    half_x <= 20x"7ffff" when half_x_over(0) = '1' else 20x"80000" when half_x_under(0) = '1' else half_x_cut(19 downto 0);
    half_y_sum <= resize(half_sums_y_sum_s2, 22) + 22x"000001";
    half_y_cut <= half_y_sum(21 downto 1);
    half_y_over <= "1" when half_y_cut(20) = '0' and (or half_y_cut(19 downto 19)) = '1' else "0";
    half_y <= 20x"7ffff" when half_y_over(0) = '1' else half_y_cut(19 downto 0);
    half_z_sum <= resize(half_sums_z_sum, 24) + 24x"000002";
    half_z_cut <= half_z_sum(23 downto 2);
    half_z_over <= "1" when half_z_cut(21) = '0' and (or half_z_cut(20 downto 19)) = '1' else "0";
    half_z_under <= "1" when half_z_cut(21) = '1' and (and half_z_cut(20 downto 19)) = '0' else "0";
    half_z <= 20x"7ffff" when half_z_over(0) = '1' else 20x"80000" when half_z_under(0) = '1' else half_z_cut(19 downto 0);
    -- half.azimuth
    half_azimuth_n193_neg <= unsigned(-half_x);
    half_azimuth_n193 <= half_azimuth_n193_neg when half_x(19) = '1' else unsigned(half_x);
    half_azimuth_n194_neg <= unsigned(-half_y);
    half_azimuth_n194 <= half_azimuth_n194_neg when half_y(19) = '1' else unsigned(half_y);
    half_azimuth_n215 <= unsigned(half_x(19 downto 19));
    half_azimuth_n218 <= unsigned(half_y(19 downto 19));
    -- half.polar_angle
    half_polar_angle_n225_neg <= unsigned(-half_z);
    half_polar_angle_n225 <= half_polar_angle_n225_neg when half_z(19) = '1' else unsigned(half_z);
    half_polar_angle_n246 <= unsigned(half_z(19 downto 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s3 <= theta_p_s2;
                light_azimuth_n68_s3 <= light_azimuth_n68;
                light_azimuth_n69_s3 <= light_azimuth_n69;
                light_azimuth_n91_s3 <= light_azimuth_n91;
                light_azimuth_n95_s3 <= light_azimuth_n95;
                light_polar_angle_n102_s3 <= light_polar_angle_n102;
                light_polar_angle_n123_s3 <= light_polar_angle_n123;
                half_azimuth_n193_s3 <= half_azimuth_n193;
                half_azimuth_n194_s3 <= half_azimuth_n194;
                half_azimuth_n215_s3 <= half_azimuth_n215;
                half_azimuth_n218_s3 <= half_azimuth_n218;
                half_polar_angle_n225_s3 <= half_polar_angle_n225;
                half_polar_angle_n246_s3 <= half_polar_angle_n246;
                bump_phi_s3 <= bump_phi_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- light.azimuth
    light_azimuth_n70 <= "1" when light_azimuth_n68_s3 < light_azimuth_n69_s3 else "0";
    light_azimuth_n71 <= light_azimuth_n69_s3 when light_azimuth_n70(0) = '1' else light_azimuth_n68_s3;
    light_azimuth_n72 <= light_azimuth_n68_s3 when light_azimuth_n70(0) = '1' else light_azimuth_n69_s3;
    light_azimuth_n73_padded <= light_azimuth_n71 & 12x"fff";
    light_azimuth_n73_skip16 <= "1" when light_azimuth_n73_padded(31 downto 16) = 16x"0000" else "0";
    light_azimuth_n73_part16 <= light_azimuth_n73_padded(15 downto 0) when light_azimuth_n73_skip16(0) = '1' else light_azimuth_n73_padded(31 downto 16);
    light_azimuth_n73_skip8 <= "1" when light_azimuth_n73_part16(15 downto 8) = 8x"00" else "0";
    light_azimuth_n73_part8 <= light_azimuth_n73_part16(7 downto 0) when light_azimuth_n73_skip8(0) = '1' else light_azimuth_n73_part16(15 downto 8);
    light_azimuth_n73_skip4 <= "1" when light_azimuth_n73_part8(7 downto 4) = 4x"0" else "0";
    light_azimuth_n73_part4 <= light_azimuth_n73_part8(3 downto 0) when light_azimuth_n73_skip4(0) = '1' else light_azimuth_n73_part8(7 downto 4);
    light_azimuth_n73_skip2 <= "1" when light_azimuth_n73_part4(3 downto 2) = "00" else "0";
    light_azimuth_n73_part2 <= light_azimuth_n73_part4(1 downto 0) when light_azimuth_n73_skip2(0) = '1' else light_azimuth_n73_part4(3 downto 2);
    light_azimuth_n73_skip1 <= "1" when light_azimuth_n73_part2(1 downto 1) = "0" else "0";
    light_azimuth_n73 <= light_azimuth_n73_skip16 & light_azimuth_n73_skip8 & light_azimuth_n73_skip4 & light_azimuth_n73_skip2 & light_azimuth_n73_skip1;
    -- half.azimuth
    half_azimuth_n195 <= "1" when half_azimuth_n193_s3 < half_azimuth_n194_s3 else "0";
    half_azimuth_n196 <= half_azimuth_n194_s3 when half_azimuth_n195(0) = '1' else half_azimuth_n193_s3;
    half_azimuth_n197 <= half_azimuth_n193_s3 when half_azimuth_n195(0) = '1' else half_azimuth_n194_s3;
    half_azimuth_n198_padded <= half_azimuth_n196 & 12x"fff";
    half_azimuth_n198_skip16 <= "1" when half_azimuth_n198_padded(31 downto 16) = 16x"0000" else "0";
    half_azimuth_n198_part16 <= half_azimuth_n198_padded(15 downto 0) when half_azimuth_n198_skip16(0) = '1' else half_azimuth_n198_padded(31 downto 16);
    half_azimuth_n198_skip8 <= "1" when half_azimuth_n198_part16(15 downto 8) = 8x"00" else "0";
    half_azimuth_n198_part8 <= half_azimuth_n198_part16(7 downto 0) when half_azimuth_n198_skip8(0) = '1' else half_azimuth_n198_part16(15 downto 8);
    half_azimuth_n198_skip4 <= "1" when half_azimuth_n198_part8(7 downto 4) = 4x"0" else "0";
    half_azimuth_n198_part4 <= half_azimuth_n198_part8(3 downto 0) when half_azimuth_n198_skip4(0) = '1' else half_azimuth_n198_part8(7 downto 4);
    half_azimuth_n198_skip2 <= "1" when half_azimuth_n198_part4(3 downto 2) = "00" else "0";
    half_azimuth_n198_part2 <= half_azimuth_n198_part4(1 downto 0) when half_azimuth_n198_skip2(0) = '1' else half_azimuth_n198_part4(3 downto 2);
    half_azimuth_n198_skip1 <= "1" when half_azimuth_n198_part2(1 downto 1) = "0" else "0";
    half_azimuth_n198 <= half_azimuth_n198_skip16 & half_azimuth_n198_skip8 & half_azimuth_n198_skip4 & half_azimuth_n198_skip2 & half_azimuth_n198_skip1;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s4 <= theta_p_s3;
                light_azimuth_n70_s4 <= light_azimuth_n70;
                light_azimuth_n71_s4 <= light_azimuth_n71;
                light_azimuth_n72_s4 <= light_azimuth_n72;
                light_azimuth_n73_s4 <= light_azimuth_n73;
                light_azimuth_n91_s4 <= light_azimuth_n91_s3;
                light_azimuth_n95_s4 <= light_azimuth_n95_s3;
                light_polar_angle_n102_s4 <= light_polar_angle_n102_s3;
                light_polar_angle_n123_s4 <= light_polar_angle_n123_s3;
                half_azimuth_n195_s4 <= half_azimuth_n195;
                half_azimuth_n196_s4 <= half_azimuth_n196;
                half_azimuth_n197_s4 <= half_azimuth_n197;
                half_azimuth_n198_s4 <= half_azimuth_n198;
                half_azimuth_n215_s4 <= half_azimuth_n215_s3;
                half_azimuth_n218_s4 <= half_azimuth_n218_s3;
                half_polar_angle_n225_s4 <= half_polar_angle_n225_s3;
                half_polar_angle_n246_s4 <= half_polar_angle_n246_s3;
                bump_phi_s4 <= bump_phi_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- light.azimuth
    light_azimuth_n74_past <= "1" when 5x"14" < light_azimuth_n73_s4 else "0";
    light_azimuth_n74_count <= 5x"14" when light_azimuth_n74_past(0) = '1' else light_azimuth_n73_s4;
    light_azimuth_n74 <= shift_left(resize(light_azimuth_n71_s4, 40), to_integer(light_azimuth_n74_count));
    light_azimuth_n75 <= light_azimuth_n74(19 downto 0);
    light_azimuth_n76_past <= "1" when 5x"14" < light_azimuth_n73_s4 else "0";
    light_azimuth_n76_count <= 5x"14" when light_azimuth_n76_past(0) = '1' else light_azimuth_n73_s4;
    light_azimuth_n76 <= shift_left(resize(light_azimuth_n72_s4, 40), to_integer(light_azimuth_n76_count));
    light_azimuth_n77 <= light_azimuth_n76(19 downto 0);
    light_azimuth_n78 <= light_azimuth_n75(18 downto 0);
    light_azimuth_n79 <= light_azimuth_n78;
    -- light.azimuth.recip
    light_azimuth_recip_n80 <= light_azimuth_n79(18 downto 9);
    -- light.azimuth
    light_azimuth_n82 <= light_azimuth_n77;
    -- half.azimuth
    half_azimuth_n199_past <= "1" when 5x"14" < half_azimuth_n198_s4 else "0";
    half_azimuth_n199_count <= 5x"14" when half_azimuth_n199_past(0) = '1' else half_azimuth_n198_s4;
    half_azimuth_n199 <= shift_left(resize(half_azimuth_n196_s4, 40), to_integer(half_azimuth_n199_count));
    half_azimuth_n200 <= half_azimuth_n199(19 downto 0);
    half_azimuth_n201_past <= "1" when 5x"14" < half_azimuth_n198_s4 else "0";
    half_azimuth_n201_count <= 5x"14" when half_azimuth_n201_past(0) = '1' else half_azimuth_n198_s4;
    half_azimuth_n201 <= shift_left(resize(half_azimuth_n197_s4, 40), to_integer(half_azimuth_n201_count));
    half_azimuth_n202 <= half_azimuth_n201(19 downto 0);
    half_azimuth_n203 <= half_azimuth_n200(18 downto 0);
    half_azimuth_n204 <= half_azimuth_n203;
    -- half.azimuth.recip
    half_azimuth_recip_n205 <= half_azimuth_n204(18 downto 9);
    -- half.azimuth
    half_azimuth_n207 <= half_azimuth_n202;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s5 <= theta_p_s4;
                light_azimuth_n70_s5 <= light_azimuth_n70_s4;
                light_azimuth_n71_s5 <= light_azimuth_n71_s4;
                recip_row <= recip_rom(to_integer(light_azimuth_recip_n80));
                light_azimuth_n82_s5 <= light_azimuth_n82;
                light_azimuth_n91_s5 <= light_azimuth_n91_s4;
                light_azimuth_n95_s5 <= light_azimuth_n95_s4;
                light_polar_angle_n102_s5 <= light_polar_angle_n102_s4;
                light_polar_angle_n123_s5 <= light_polar_angle_n123_s4;
                half_azimuth_n195_s5 <= half_azimuth_n195_s4;
                half_azimuth_n196_s5 <= half_azimuth_n196_s4;
                recip_row_2 <= recip_rom(to_integer(half_azimuth_recip_n205));
                half_azimuth_n207_s5 <= half_azimuth_n207;
                half_azimuth_n215_s5 <= half_azimuth_n215_s4;
                half_azimuth_n218_s5 <= half_azimuth_n218_s4;
                half_polar_angle_n225_s5 <= half_polar_angle_n225_s4;
                half_polar_angle_n246_s5 <= half_polar_angle_n246_s4;
                bump_phi_s5 <= bump_phi_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- light.azimuth.recip
    light_azimuth_recip_n81 <= recip_row;
    -- half.azimuth.recip
    half_azimuth_recip_n206 <= recip_row_2;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s6 <= theta_p_s5;
                light_azimuth_n70_s6 <= light_azimuth_n70_s5;
                light_azimuth_n71_s6 <= light_azimuth_n71_s5;
                light_azimuth_recip_n81_s6 <= light_azimuth_recip_n81;
                light_azimuth_n82_s6 <= light_azimuth_n82_s5;
                light_azimuth_n91_s6 <= light_azimuth_n91_s5;
                light_azimuth_n95_s6 <= light_azimuth_n95_s5;
                light_polar_angle_n102_s6 <= light_polar_angle_n102_s5;
                light_polar_angle_n123_s6 <= light_polar_angle_n123_s5;
                half_azimuth_n195_s6 <= half_azimuth_n195_s5;
                half_azimuth_n196_s6 <= half_azimuth_n196_s5;
                half_azimuth_recip_n206_s6 <= half_azimuth_recip_n206;
                half_azimuth_n207_s6 <= half_azimuth_n207_s5;
                half_azimuth_n215_s6 <= half_azimuth_n215_s5;
                half_azimuth_n218_s6 <= half_azimuth_n218_s5;
                half_polar_angle_n225_s6 <= half_polar_angle_n225_s5;
                half_polar_angle_n246_s6 <= half_polar_angle_n246_s5;
                bump_phi_s6 <= bump_phi_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- light.azimuth
    light_azimuth_n83 <= light_azimuth_n82_s6 * light_azimuth_recip_n81_s6;
    -- half.azimuth
    half_azimuth_n208 <= half_azimuth_n207_s6 * half_azimuth_recip_n206_s6;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s7 <= theta_p_s6;
                light_azimuth_n70_s7 <= light_azimuth_n70_s6;
                light_azimuth_n71_s7 <= light_azimuth_n71_s6;
                light_azimuth_n83_s7 <= light_azimuth_n83;
                light_azimuth_n91_s7 <= light_azimuth_n91_s6;
                light_azimuth_n95_s7 <= light_azimuth_n95_s6;
                light_polar_angle_n102_s7 <= light_polar_angle_n102_s6;
                light_polar_angle_n123_s7 <= light_polar_angle_n123_s6;
                half_azimuth_n195_s7 <= half_azimuth_n195_s6;
                half_azimuth_n196_s7 <= half_azimuth_n196_s6;
                half_azimuth_n208_s7 <= half_azimuth_n208;
                half_azimuth_n215_s7 <= half_azimuth_n215_s6;
                half_azimuth_n218_s7 <= half_azimuth_n218_s6;
                half_polar_angle_n225_s7 <= half_polar_angle_n225_s6;
                half_polar_angle_n246_s7 <= half_polar_angle_n246_s6;
                bump_phi_s7 <= bump_phi_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- light.azimuth
    light_azimuth_ratio_sum <= resize(light_azimuth_n83_s7, 41) + 41x"00000080000";
    light_azimuth_ratio_cut <= light_azimuth_ratio_sum(40 downto 20);
    light_azimuth_ratio_over <= "1" when (or light_azimuth_ratio_cut(20 downto 18)) = '1' else "0";
    light_azimuth_ratio <= 18x"3ffff" when light_azimuth_ratio_over(0) = '1' else light_azimuth_ratio_cut(17 downto 0);
    -- light.azimuth.atan
    light_azimuth_atan_n85 <= light_azimuth_ratio(17 downto 8);
    -- half.azimuth
    half_azimuth_ratio_sum <= resize(half_azimuth_n208_s7, 41) + 41x"00000080000";
    half_azimuth_ratio_cut <= half_azimuth_ratio_sum(40 downto 20);
    half_azimuth_ratio_over <= "1" when (or half_azimuth_ratio_cut(20 downto 18)) = '1' else "0";
    half_azimuth_ratio <= 18x"3ffff" when half_azimuth_ratio_over(0) = '1' else half_azimuth_ratio_cut(17 downto 0);
    -- half.azimuth.atan
    half_azimuth_atan_n210 <= half_azimuth_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s8 <= theta_p_s7;
                light_azimuth_n70_s8 <= light_azimuth_n70_s7;
                light_azimuth_n71_s8 <= light_azimuth_n71_s7;
                atan_row <= atan_rom(to_integer(light_azimuth_atan_n85));
                light_azimuth_n91_s8 <= light_azimuth_n91_s7;
                light_azimuth_n95_s8 <= light_azimuth_n95_s7;
                light_polar_angle_n102_s8 <= light_polar_angle_n102_s7;
                light_polar_angle_n123_s8 <= light_polar_angle_n123_s7;
                half_azimuth_n195_s8 <= half_azimuth_n195_s7;
                half_azimuth_n196_s8 <= half_azimuth_n196_s7;
                atan_row_2 <= atan_rom(to_integer(half_azimuth_atan_n210));
                half_azimuth_n215_s8 <= half_azimuth_n215_s7;
                half_azimuth_n218_s8 <= half_azimuth_n218_s7;
                half_polar_angle_n225_s8 <= half_polar_angle_n225_s7;
                half_polar_angle_n246_s8 <= half_polar_angle_n246_s7;
                bump_phi_s8 <= bump_phi_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- light.azimuth.atan
    light_azimuth_atan_n86 <= atan_row(37 downto 19);
    light_azimuth_atan_n87 <= atan_row(18 downto 0);
    -- light.azimuth
    light_azimuth_n89 <= signed(resize(light_azimuth_n88, 20)) - signed(resize(light_azimuth_atan_n86, 20));
    light_azimuth_n90 <= light_azimuth_n89 when light_azimuth_n70_s8(0) = '1' else signed(resize(light_azimuth_atan_n86, 20));
    -- half.azimuth.atan
    half_azimuth_atan_n211 <= atan_row_2(37 downto 19);
    half_azimuth_atan_n212 <= atan_row_2(18 downto 0);
    -- half.azimuth
    half_azimuth_n213 <= signed(resize(light_azimuth_n88, 20)) - signed(resize(half_azimuth_atan_n211, 20));
    half_azimuth_n214 <= half_azimuth_n213 when half_azimuth_n195_s8(0) = '1' else signed(resize(half_azimuth_atan_n211, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s9 <= theta_p_s8;
                light_azimuth_n71_s9 <= light_azimuth_n71_s8;
                light_azimuth_atan_n87_s9 <= light_azimuth_atan_n87;
                light_azimuth_n90_s9 <= light_azimuth_n90;
                light_azimuth_n91_s9 <= light_azimuth_n91_s8;
                light_azimuth_n95_s9 <= light_azimuth_n95_s8;
                light_polar_angle_n102_s9 <= light_polar_angle_n102_s8;
                light_polar_angle_n123_s9 <= light_polar_angle_n123_s8;
                half_azimuth_n196_s9 <= half_azimuth_n196_s8;
                half_azimuth_atan_n212_s9 <= half_azimuth_atan_n212;
                half_azimuth_n214_s9 <= half_azimuth_n214;
                half_azimuth_n215_s9 <= half_azimuth_n215_s8;
                half_azimuth_n218_s9 <= half_azimuth_n218_s8;
                half_polar_angle_n225_s9 <= half_polar_angle_n225_s8;
                half_polar_angle_n246_s9 <= half_polar_angle_n246_s8;
                bump_phi_s9 <= bump_phi_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- light.azimuth
    light_azimuth_n93 <= signed(resize(light_azimuth_n92, 21)) - resize(light_azimuth_n90_s9, 21);
    light_azimuth_n94 <= light_azimuth_n93 when light_azimuth_n91_s9(0) = '1' else resize(light_azimuth_n90_s9, 21);
    light_azimuth_n96 <= -resize(light_azimuth_n94, 22);
    light_azimuth_n97 <= light_azimuth_n96 when light_azimuth_n95_s9(0) = '1' else resize(light_azimuth_n94, 22);
    light_azimuth_n98 <= unsigned(light_azimuth_n97(17 downto 0));
    light_azimuth_n99 <= light_azimuth_n71_s9 * light_azimuth_atan_n87_s9;
    -- light
    light_n130_sum <= resize(light_azimuth_n98, 19) + 19x"00002";
    light_n130_cut <= light_n130_sum(18 downto 2);
    light_n130 <= light_n130_cut;
    light_phi <= light_n130(15 downto 0);
    -- half.azimuth
    half_azimuth_n216 <= signed(resize(light_azimuth_n92, 21)) - resize(half_azimuth_n214_s9, 21);
    half_azimuth_n217 <= half_azimuth_n216 when half_azimuth_n215_s9(0) = '1' else resize(half_azimuth_n214_s9, 21);
    half_azimuth_n219 <= -resize(half_azimuth_n217, 22);
    half_azimuth_n220 <= half_azimuth_n219 when half_azimuth_n218_s9(0) = '1' else resize(half_azimuth_n217, 22);
    half_azimuth_n221 <= unsigned(half_azimuth_n220(17 downto 0));
    half_azimuth_n222 <= half_azimuth_n196_s9 * half_azimuth_atan_n212_s9;
    -- half
    half_n253_sum <= resize(half_azimuth_n221, 19) + 19x"00002";
    half_n253_cut <= half_n253_sum(18 downto 2);
    half_n253 <= half_n253_cut;
    half_phi <= half_n253(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s10 <= theta_p_s9;
                light_azimuth_n99_s10 <= light_azimuth_n99;
                light_polar_angle_n102_s10 <= light_polar_angle_n102_s9;
                light_polar_angle_n123_s10 <= light_polar_angle_n123_s9;
                light_phi_s10 <= light_phi;
                half_azimuth_n222_s10 <= half_azimuth_n222;
                half_polar_angle_n225_s10 <= half_polar_angle_n225_s9;
                half_polar_angle_n246_s10 <= half_polar_angle_n246_s9;
                half_phi_s10 <= half_phi;
                bump_phi_s10 <= bump_phi_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- light.azimuth
    light_azimuth_n100_sum <= resize(light_azimuth_n99_s10, 40) + 40x"0000020000";
    light_azimuth_n100_cut <= light_azimuth_n100_sum(39 downto 18);
    light_azimuth_n100_over <= "1" when (or light_azimuth_n100_cut(21 downto 20)) = '1' else "0";
    light_azimuth_n100 <= 21x"0fffff" when light_azimuth_n100_over(0) = '1' else signed(light_azimuth_n100_cut(20 downto 0));
    -- light
    light_n101_over <= "1" when light_azimuth_n100(20) = '0' and (or light_azimuth_n100(19 downto 19)) = '1' else "0";
    light_n101_under <= "1" when light_azimuth_n100(20) = '1' and (and light_azimuth_n100(19 downto 19)) = '0' else "0";
    light_n101 <= 20x"7ffff" when light_n101_over(0) = '1' else 20x"80000" when light_n101_under(0) = '1' else light_azimuth_n100(19 downto 0);
    -- light.polar_angle
    light_polar_angle_n103_neg <= unsigned(-light_n101);
    light_polar_angle_n103 <= light_polar_angle_n103_neg when light_n101(19) = '1' else unsigned(light_n101);
    light_polar_angle_n126 <= unsigned(light_n101(19 downto 19));
    -- half.azimuth
    half_azimuth_n223_sum <= resize(half_azimuth_n222_s10, 40) + 40x"0000020000";
    half_azimuth_n223_cut <= half_azimuth_n223_sum(39 downto 18);
    half_azimuth_n223_over <= "1" when (or half_azimuth_n223_cut(21 downto 20)) = '1' else "0";
    half_azimuth_n223 <= 21x"0fffff" when half_azimuth_n223_over(0) = '1' else signed(half_azimuth_n223_cut(20 downto 0));
    -- half
    half_n224_over <= "1" when half_azimuth_n223(20) = '0' and (or half_azimuth_n223(19 downto 19)) = '1' else "0";
    half_n224_under <= "1" when half_azimuth_n223(20) = '1' and (and half_azimuth_n223(19 downto 19)) = '0' else "0";
    half_n224 <= 20x"7ffff" when half_n224_over(0) = '1' else 20x"80000" when half_n224_under(0) = '1' else half_azimuth_n223(19 downto 0);
    -- half.polar_angle
    half_polar_angle_n226_neg <= unsigned(-half_n224);
    half_polar_angle_n226 <= half_polar_angle_n226_neg when half_n224(19) = '1' else unsigned(half_n224);
    half_polar_angle_n249 <= unsigned(half_n224(19 downto 19));
    -- dot_l
    dot_l_n259 <= signed(resize(light_phi_s10, 17)) - signed(resize(bump_phi_s10, 17));
    dot_l_delta <= unsigned(dot_l_n259(15 downto 0));
    -- dot_l.cos
    dot_l_cos_n269 <= dot_l_delta(15 downto 6);
    -- dot_h
    dot_h_n278 <= signed(resize(half_phi_s10, 17)) - signed(resize(bump_phi_s10, 17));
    dot_h_delta <= unsigned(dot_h_n278(15 downto 0));
    -- dot_h.cos
    dot_h_cos_n288 <= dot_h_delta(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s11 <= theta_p_s10;
                light_polar_angle_n102_s11 <= light_polar_angle_n102_s10;
                light_polar_angle_n103_s11 <= light_polar_angle_n103;
                light_polar_angle_n123_s11 <= light_polar_angle_n123_s10;
                light_polar_angle_n126_s11 <= light_polar_angle_n126;
                half_polar_angle_n225_s11 <= half_polar_angle_n225_s10;
                half_polar_angle_n226_s11 <= half_polar_angle_n226;
                half_polar_angle_n246_s11 <= half_polar_angle_n246_s10;
                half_polar_angle_n249_s11 <= half_polar_angle_n249;
                cos_row <= cos_rom(to_integer(dot_l_cos_n269));
                cos_row_2 <= cos_rom(to_integer(dot_h_cos_n288));
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- light.polar_angle
    light_polar_angle_n104 <= "1" when light_polar_angle_n102_s11 < light_polar_angle_n103_s11 else "0";
    light_polar_angle_n105 <= light_polar_angle_n103_s11 when light_polar_angle_n104(0) = '1' else light_polar_angle_n102_s11;
    light_polar_angle_n106 <= light_polar_angle_n102_s11 when light_polar_angle_n104(0) = '1' else light_polar_angle_n103_s11;
    light_polar_angle_n107_padded <= light_polar_angle_n105 & 12x"fff";
    light_polar_angle_n107_skip16 <= "1" when light_polar_angle_n107_padded(31 downto 16) = 16x"0000" else "0";
    light_polar_angle_n107_part16 <= light_polar_angle_n107_padded(15 downto 0) when light_polar_angle_n107_skip16(0) = '1' else light_polar_angle_n107_padded(31 downto 16);
    light_polar_angle_n107_skip8 <= "1" when light_polar_angle_n107_part16(15 downto 8) = 8x"00" else "0";
    light_polar_angle_n107_part8 <= light_polar_angle_n107_part16(7 downto 0) when light_polar_angle_n107_skip8(0) = '1' else light_polar_angle_n107_part16(15 downto 8);
    light_polar_angle_n107_skip4 <= "1" when light_polar_angle_n107_part8(7 downto 4) = 4x"0" else "0";
    light_polar_angle_n107_part4 <= light_polar_angle_n107_part8(3 downto 0) when light_polar_angle_n107_skip4(0) = '1' else light_polar_angle_n107_part8(7 downto 4);
    light_polar_angle_n107_skip2 <= "1" when light_polar_angle_n107_part4(3 downto 2) = "00" else "0";
    light_polar_angle_n107_part2 <= light_polar_angle_n107_part4(1 downto 0) when light_polar_angle_n107_skip2(0) = '1' else light_polar_angle_n107_part4(3 downto 2);
    light_polar_angle_n107_skip1 <= "1" when light_polar_angle_n107_part2(1 downto 1) = "0" else "0";
    light_polar_angle_n107 <= light_polar_angle_n107_skip16 & light_polar_angle_n107_skip8 & light_polar_angle_n107_skip4 & light_polar_angle_n107_skip2 & light_polar_angle_n107_skip1;
    -- half.polar_angle
    half_polar_angle_n227 <= "1" when half_polar_angle_n225_s11 < half_polar_angle_n226_s11 else "0";
    half_polar_angle_n228 <= half_polar_angle_n226_s11 when half_polar_angle_n227(0) = '1' else half_polar_angle_n225_s11;
    half_polar_angle_n229 <= half_polar_angle_n225_s11 when half_polar_angle_n227(0) = '1' else half_polar_angle_n226_s11;
    half_polar_angle_n230_padded <= half_polar_angle_n228 & 12x"fff";
    half_polar_angle_n230_skip16 <= "1" when half_polar_angle_n230_padded(31 downto 16) = 16x"0000" else "0";
    half_polar_angle_n230_part16 <= half_polar_angle_n230_padded(15 downto 0) when half_polar_angle_n230_skip16(0) = '1' else half_polar_angle_n230_padded(31 downto 16);
    half_polar_angle_n230_skip8 <= "1" when half_polar_angle_n230_part16(15 downto 8) = 8x"00" else "0";
    half_polar_angle_n230_part8 <= half_polar_angle_n230_part16(7 downto 0) when half_polar_angle_n230_skip8(0) = '1' else half_polar_angle_n230_part16(15 downto 8);
    half_polar_angle_n230_skip4 <= "1" when half_polar_angle_n230_part8(7 downto 4) = 4x"0" else "0";
    half_polar_angle_n230_part4 <= half_polar_angle_n230_part8(3 downto 0) when half_polar_angle_n230_skip4(0) = '1' else half_polar_angle_n230_part8(7 downto 4);
    half_polar_angle_n230_skip2 <= "1" when half_polar_angle_n230_part4(3 downto 2) = "00" else "0";
    half_polar_angle_n230_part2 <= half_polar_angle_n230_part4(1 downto 0) when half_polar_angle_n230_skip2(0) = '1' else half_polar_angle_n230_part4(3 downto 2);
    half_polar_angle_n230_skip1 <= "1" when half_polar_angle_n230_part2(1 downto 1) = "0" else "0";
    half_polar_angle_n230 <= half_polar_angle_n230_skip16 & half_polar_angle_n230_skip8 & half_polar_angle_n230_skip4 & half_polar_angle_n230_skip2 & half_polar_angle_n230_skip1;
    -- dot_l.cos
    dot_l_cos_cos_delta <= signed(cos_row);
    -- dot_h.cos
    dot_h_cos_cos_delta <= signed(cos_row_2);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s12 <= theta_p_s11;
                light_polar_angle_n104_s12 <= light_polar_angle_n104;
                light_polar_angle_n105_s12 <= light_polar_angle_n105;
                light_polar_angle_n106_s12 <= light_polar_angle_n106;
                light_polar_angle_n107_s12 <= light_polar_angle_n107;
                light_polar_angle_n123_s12 <= light_polar_angle_n123_s11;
                light_polar_angle_n126_s12 <= light_polar_angle_n126_s11;
                half_polar_angle_n227_s12 <= half_polar_angle_n227;
                half_polar_angle_n228_s12 <= half_polar_angle_n228;
                half_polar_angle_n229_s12 <= half_polar_angle_n229;
                half_polar_angle_n230_s12 <= half_polar_angle_n230;
                half_polar_angle_n246_s12 <= half_polar_angle_n246_s11;
                half_polar_angle_n249_s12 <= half_polar_angle_n249_s11;
                dot_l_cos_cos_delta_s12 <= dot_l_cos_cos_delta;
                dot_h_cos_cos_delta_s12 <= dot_h_cos_cos_delta;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- light.polar_angle
    light_polar_angle_n108_past <= "1" when 5x"14" < light_polar_angle_n107_s12 else "0";
    light_polar_angle_n108_count <= 5x"14" when light_polar_angle_n108_past(0) = '1' else light_polar_angle_n107_s12;
    light_polar_angle_n108 <= shift_left(resize(light_polar_angle_n105_s12, 40), to_integer(light_polar_angle_n108_count));
    light_polar_angle_n109 <= light_polar_angle_n108(19 downto 0);
    light_polar_angle_n110_past <= "1" when 5x"14" < light_polar_angle_n107_s12 else "0";
    light_polar_angle_n110_count <= 5x"14" when light_polar_angle_n110_past(0) = '1' else light_polar_angle_n107_s12;
    light_polar_angle_n110 <= shift_left(resize(light_polar_angle_n106_s12, 40), to_integer(light_polar_angle_n110_count));
    light_polar_angle_n111 <= light_polar_angle_n110(19 downto 0);
    light_polar_angle_n112 <= light_polar_angle_n109(18 downto 0);
    light_polar_angle_n113 <= light_polar_angle_n112;
    -- light.polar_angle.recip
    light_polar_angle_recip_n114 <= light_polar_angle_n113(18 downto 9);
    -- light.polar_angle
    light_polar_angle_n116 <= light_polar_angle_n111;
    -- half.polar_angle
    half_polar_angle_n231_past <= "1" when 5x"14" < half_polar_angle_n230_s12 else "0";
    half_polar_angle_n231_count <= 5x"14" when half_polar_angle_n231_past(0) = '1' else half_polar_angle_n230_s12;
    half_polar_angle_n231 <= shift_left(resize(half_polar_angle_n228_s12, 40), to_integer(half_polar_angle_n231_count));
    half_polar_angle_n232 <= half_polar_angle_n231(19 downto 0);
    half_polar_angle_n233_past <= "1" when 5x"14" < half_polar_angle_n230_s12 else "0";
    half_polar_angle_n233_count <= 5x"14" when half_polar_angle_n233_past(0) = '1' else half_polar_angle_n230_s12;
    half_polar_angle_n233 <= shift_left(resize(half_polar_angle_n229_s12, 40), to_integer(half_polar_angle_n233_count));
    half_polar_angle_n234 <= half_polar_angle_n233(19 downto 0);
    half_polar_angle_n235 <= half_polar_angle_n232(18 downto 0);
    half_polar_angle_n236 <= half_polar_angle_n235;
    -- half.polar_angle.recip
    half_polar_angle_recip_n237 <= half_polar_angle_n236(18 downto 9);
    -- half.polar_angle
    half_polar_angle_n239 <= half_polar_angle_n234;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s13 <= theta_p_s12;
                light_polar_angle_n104_s13 <= light_polar_angle_n104_s12;
                recip_row_3 <= recip_rom_2(to_integer(light_polar_angle_recip_n114));
                light_polar_angle_n116_s13 <= light_polar_angle_n116;
                light_polar_angle_n123_s13 <= light_polar_angle_n123_s12;
                light_polar_angle_n126_s13 <= light_polar_angle_n126_s12;
                half_polar_angle_n227_s13 <= half_polar_angle_n227_s12;
                recip_row_4 <= recip_rom_2(to_integer(half_polar_angle_recip_n237));
                half_polar_angle_n239_s13 <= half_polar_angle_n239;
                half_polar_angle_n246_s13 <= half_polar_angle_n246_s12;
                half_polar_angle_n249_s13 <= half_polar_angle_n249_s12;
                dot_l_cos_cos_delta_s13 <= dot_l_cos_cos_delta_s12;
                dot_h_cos_cos_delta_s13 <= dot_h_cos_cos_delta_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- light.polar_angle.recip
    light_polar_angle_recip_n115 <= recip_row_3;
    -- half.polar_angle.recip
    half_polar_angle_recip_n238 <= recip_row_4;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s14 <= theta_p_s13;
                light_polar_angle_n104_s14 <= light_polar_angle_n104_s13;
                light_polar_angle_recip_n115_s14 <= light_polar_angle_recip_n115;
                light_polar_angle_n116_s14 <= light_polar_angle_n116_s13;
                light_polar_angle_n123_s14 <= light_polar_angle_n123_s13;
                light_polar_angle_n126_s14 <= light_polar_angle_n126_s13;
                half_polar_angle_n227_s14 <= half_polar_angle_n227_s13;
                half_polar_angle_recip_n238_s14 <= half_polar_angle_recip_n238;
                half_polar_angle_n239_s14 <= half_polar_angle_n239_s13;
                half_polar_angle_n246_s14 <= half_polar_angle_n246_s13;
                half_polar_angle_n249_s14 <= half_polar_angle_n249_s13;
                dot_l_cos_cos_delta_s14 <= dot_l_cos_cos_delta_s13;
                dot_h_cos_cos_delta_s14 <= dot_h_cos_cos_delta_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- light.polar_angle
    light_polar_angle_n117 <= light_polar_angle_n116_s14 * light_polar_angle_recip_n115_s14;
    -- half.polar_angle
    half_polar_angle_n240 <= half_polar_angle_n239_s14 * half_polar_angle_recip_n238_s14;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s15 <= theta_p_s14;
                light_polar_angle_n104_s15 <= light_polar_angle_n104_s14;
                light_polar_angle_n117_s15 <= light_polar_angle_n117;
                light_polar_angle_n123_s15 <= light_polar_angle_n123_s14;
                light_polar_angle_n126_s15 <= light_polar_angle_n126_s14;
                half_polar_angle_n227_s15 <= half_polar_angle_n227_s14;
                half_polar_angle_n240_s15 <= half_polar_angle_n240;
                half_polar_angle_n246_s15 <= half_polar_angle_n246_s14;
                half_polar_angle_n249_s15 <= half_polar_angle_n249_s14;
                dot_l_cos_cos_delta_s15 <= dot_l_cos_cos_delta_s14;
                dot_h_cos_cos_delta_s15 <= dot_h_cos_cos_delta_s14;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- light.polar_angle
    light_polar_angle_ratio_sum <= resize(light_polar_angle_n117_s15, 41) + 41x"00000080000";
    light_polar_angle_ratio_cut <= light_polar_angle_ratio_sum(40 downto 20);
    light_polar_angle_ratio_over <= "1" when (or light_polar_angle_ratio_cut(20 downto 18)) = '1' else "0";
    light_polar_angle_ratio <= 18x"3ffff" when light_polar_angle_ratio_over(0) = '1' else light_polar_angle_ratio_cut(17 downto 0);
    -- light.polar_angle.atan
    light_polar_angle_atan_n119 <= light_polar_angle_ratio(17 downto 8);
    -- half.polar_angle
    half_polar_angle_ratio_sum <= resize(half_polar_angle_n240_s15, 41) + 41x"00000080000";
    half_polar_angle_ratio_cut <= half_polar_angle_ratio_sum(40 downto 20);
    half_polar_angle_ratio_over <= "1" when (or half_polar_angle_ratio_cut(20 downto 18)) = '1' else "0";
    half_polar_angle_ratio <= 18x"3ffff" when half_polar_angle_ratio_over(0) = '1' else half_polar_angle_ratio_cut(17 downto 0);
    -- half.polar_angle.atan
    half_polar_angle_atan_n242 <= half_polar_angle_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s16 <= theta_p_s15;
                light_polar_angle_n104_s16 <= light_polar_angle_n104_s15;
                atan_row_3 <= atan_rom_2(to_integer(light_polar_angle_atan_n119));
                light_polar_angle_n123_s16 <= light_polar_angle_n123_s15;
                light_polar_angle_n126_s16 <= light_polar_angle_n126_s15;
                half_polar_angle_n227_s16 <= half_polar_angle_n227_s15;
                atan_row_4 <= atan_rom_2(to_integer(half_polar_angle_atan_n242));
                half_polar_angle_n246_s16 <= half_polar_angle_n246_s15;
                half_polar_angle_n249_s16 <= half_polar_angle_n249_s15;
                dot_l_cos_cos_delta_s16 <= dot_l_cos_cos_delta_s15;
                dot_h_cos_cos_delta_s16 <= dot_h_cos_cos_delta_s15;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- light.polar_angle.atan
    light_polar_angle_atan_n120 <= atan_row_3(37 downto 19);
    -- light.polar_angle
    light_polar_angle_n121 <= signed(resize(light_azimuth_n88, 20)) - signed(resize(light_polar_angle_atan_n120, 20));
    light_polar_angle_n122 <= light_polar_angle_n121 when light_polar_angle_n104_s16(0) = '1' else signed(resize(light_polar_angle_atan_n120, 20));
    -- half.polar_angle.atan
    half_polar_angle_atan_n243 <= atan_row_4(37 downto 19);
    -- half.polar_angle
    half_polar_angle_n244 <= signed(resize(light_azimuth_n88, 20)) - signed(resize(half_polar_angle_atan_n243, 20));
    half_polar_angle_n245 <= half_polar_angle_n244 when half_polar_angle_n227_s16(0) = '1' else signed(resize(half_polar_angle_atan_n243, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s17 <= theta_p_s16;
                light_polar_angle_n122_s17 <= light_polar_angle_n122;
                light_polar_angle_n123_s17 <= light_polar_angle_n123_s16;
                light_polar_angle_n126_s17 <= light_polar_angle_n126_s16;
                half_polar_angle_n245_s17 <= half_polar_angle_n245;
                half_polar_angle_n246_s17 <= half_polar_angle_n246_s16;
                half_polar_angle_n249_s17 <= half_polar_angle_n249_s16;
                dot_l_cos_cos_delta_s17 <= dot_l_cos_cos_delta_s16;
                dot_h_cos_cos_delta_s17 <= dot_h_cos_cos_delta_s16;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- light.polar_angle
    light_polar_angle_n124 <= signed(resize(light_azimuth_n92, 21)) - resize(light_polar_angle_n122_s17, 21);
    light_polar_angle_n125 <= light_polar_angle_n124 when light_polar_angle_n123_s17(0) = '1' else resize(light_polar_angle_n122_s17, 21);
    light_polar_angle_n127 <= -resize(light_polar_angle_n125, 22);
    light_polar_angle_n128 <= light_polar_angle_n127 when light_polar_angle_n126_s17(0) = '1' else resize(light_polar_angle_n125, 22);
    light_polar_angle_n129 <= unsigned(light_polar_angle_n128(17 downto 0));
    -- light
    light_n132_sum <= resize(light_polar_angle_n129, 19) + 19x"00002";
    light_n132_cut <= light_n132_sum(18 downto 2);
    light_n132 <= light_n132_cut;
    light_theta <= light_n132(15 downto 0);
    -- half.polar_angle
    half_polar_angle_n247 <= signed(resize(light_azimuth_n92, 21)) - resize(half_polar_angle_n245_s17, 21);
    half_polar_angle_n248 <= half_polar_angle_n247 when half_polar_angle_n246_s17(0) = '1' else resize(half_polar_angle_n245_s17, 21);
    half_polar_angle_n250 <= -resize(half_polar_angle_n248, 22);
    half_polar_angle_n251 <= half_polar_angle_n250 when half_polar_angle_n249_s17(0) = '1' else resize(half_polar_angle_n248, 22);
    half_polar_angle_n252 <= unsigned(half_polar_angle_n251(17 downto 0));
    -- half
    half_n255_sum <= resize(half_polar_angle_n252, 19) + 19x"00002";
    half_n255_cut <= half_n255_sum(18 downto 2);
    half_n255 <= half_n255_cut;
    half_theta <= half_n255(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                theta_p_s18 <= theta_p_s17;
                light_theta_s18 <= light_theta;
                half_theta_s18 <= half_theta;
                dot_l_cos_cos_delta_s18 <= dot_l_cos_cos_delta_s17;
                dot_h_cos_cos_delta_s18 <= dot_h_cos_cos_delta_s17;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- dot_l
    dot_l_n261 <= resize(light_theta_s18, 17) + resize(theta_p_s18, 17);
    dot_l_sum <= dot_l_n261(15 downto 0);
    dot_l_n263 <= signed(resize(light_theta_s18, 17)) - signed(resize(theta_p_s18, 17));
    dot_l_difference <= unsigned(dot_l_n263(15 downto 0));
    -- dot_l.cos
    dot_l_cos_n265 <= dot_l_sum(15 downto 6);
    dot_l_cos_n267 <= dot_l_difference(15 downto 6);
    -- dot_h
    dot_h_n280 <= resize(half_theta_s18, 17) + resize(theta_p_s18, 17);
    dot_h_sum <= dot_h_n280(15 downto 0);
    dot_h_n282 <= signed(resize(half_theta_s18, 17)) - signed(resize(theta_p_s18, 17));
    dot_h_difference <= unsigned(dot_h_n282(15 downto 0));
    -- dot_h.cos
    dot_h_cos_n284 <= dot_h_sum(15 downto 6);
    dot_h_cos_n286 <= dot_h_difference(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                cos_row_3 <= cos_rom_2(to_integer(dot_l_cos_n265));
                cos_row_4 <= cos_rom_2(to_integer(dot_l_cos_n267));
                dot_l_cos_cos_delta_s19 <= dot_l_cos_cos_delta_s18;
                cos_row_5 <= cos_rom_3(to_integer(dot_h_cos_n284));
                cos_row_6 <= cos_rom_3(to_integer(dot_h_cos_n286));
                dot_h_cos_cos_delta_s19 <= dot_h_cos_cos_delta_s18;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- dot_l.cos
    dot_l_cos_cos_sum <= signed(cos_row_3);
    dot_l_cos_cos_difference <= signed(cos_row_4);
    -- dot_l
    dot_l_n271 <= resize(dot_l_cos_cos_sum, 21) + resize(dot_l_cos_cos_difference, 21);
    dot_l_n272 <= dot_l_n271;
    dot_l_n273 <= resize(dot_l_cos_cos_difference, 21) - resize(dot_l_cos_cos_sum, 21);
    dot_l_n274 <= dot_l_n273;
    -- dot_h.cos
    dot_h_cos_cos_sum <= signed(cos_row_5);
    dot_h_cos_cos_difference <= signed(cos_row_6);
    -- dot_h
    dot_h_n290 <= resize(dot_h_cos_cos_sum, 21) + resize(dot_h_cos_cos_difference, 21);
    dot_h_n291 <= dot_h_n290;
    dot_h_n292 <= resize(dot_h_cos_cos_difference, 21) - resize(dot_h_cos_cos_sum, 21);
    dot_h_n293 <= dot_h_n292;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_cos_cos_delta_s20 <= dot_l_cos_cos_delta_s19;
                dot_l_n272_s20 <= dot_l_n272;
                dot_l_n274_s20 <= dot_l_n274;
                dot_h_cos_cos_delta_s20 <= dot_h_cos_cos_delta_s19;
                dot_h_n291_s20 <= dot_h_n291;
                dot_h_n293_s20 <= dot_h_n293;
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    -- dot_l
    dot_l_n275 <= dot_l_n274_s20 * dot_l_cos_cos_delta_s20;
    -- dot_h
    dot_h_n294 <= dot_h_n293_s20 * dot_h_cos_cos_delta_s20;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                dot_l_n272_s21 <= dot_l_n272_s20;
                dot_l_n275_s21 <= dot_l_n275;
                dot_h_n291_s21 <= dot_h_n291_s20;
                dot_h_n294_s21 <= dot_h_n294;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----
    -- dot_l
    dot_l_n276 <= shift_left(resize(dot_l_n272_s21, 42), 18) + resize(dot_l_n275_s21, 42);
    -- (unit)
    dot_l_sum_2 <= resize(dot_l_n276, 43) + 43x"00000100000";
    dot_l_cut <= dot_l_sum_2(42 downto 21);
    dot_l_over <= "1" when dot_l_cut(21) = '0' and (or dot_l_cut(20 downto 17)) = '1' else "0";
    dot_l_under <= "1" when dot_l_cut(21) = '1' and (and dot_l_cut(20 downto 17)) = '0' else "0";
    dot_l <= 18x"1ffff" when dot_l_over(0) = '1' else 18x"20000" when dot_l_under(0) = '1' else dot_l_cut(17 downto 0);
    -- dot_h
    dot_h_n295 <= shift_left(resize(dot_h_n291_s21, 42), 18) + resize(dot_h_n294_s21, 42);
    -- (unit)
    dot_h_sum_2 <= resize(dot_h_n295, 43) + 43x"00000100000";
    dot_h_cut <= dot_h_sum_2(42 downto 21);
    dot_h_over <= "1" when dot_h_cut(21) = '0' and (or dot_h_cut(20 downto 17)) = '1' else "0";
    dot_h_under <= "1" when dot_h_cut(21) = '1' and (and dot_h_cut(20 downto 17)) = '0' else "0";
    dot_h <= 18x"1ffff" when dot_h_over(0) = '1' else 18x"20000" when dot_h_under(0) = '1' else dot_h_cut(17 downto 0);
    n298 <= unsigned(dot_l(17 downto 17));
    n299 <= signed(shift_left(resize(n297, 18), 16)) when n298(0) = '1' else dot_l;
    diffuse_index_under <= unsigned(n299(17 downto 17));
    diffuse_index <= 17x"00000" when diffuse_index_under(0) = '1' else unsigned(n299(16 downto 0));
    n301 <= diffuse_index(16 downto 16);
    n302 <= diffuse_index(15 downto 0);
    n303 <= n302;
    -- diffuse
    diffuse_n304 <= n303(15 downto 6);
    -- (unit)
    n310 <= unsigned(dot_h(17 downto 17));
    n311 <= signed(shift_left(resize(n297, 18), 16)) when n310(0) = '1' else dot_h;
    specular_index_under <= unsigned(n311(17 downto 17));
    specular_index <= 17x"00000" when specular_index_under(0) = '1' else unsigned(n311(16 downto 0));
    n313 <= specular_index(16 downto 16);
    n314 <= specular_index(15 downto 0);
    n315 <= n314;
    -- specular
    specular_n316 <= n315(15 downto 6);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n298_s22 <= n298;
                n301_s22 <= n301;
                diffuse_n304_s22 <= diffuse_n304;
                n310_s22 <= n310;
                n313_s22 <= n313;
                specular_n316_s22 <= specular_n316;
            end if;
            if rst = '1' then
                valid_s22 <= '0';
            elsif ce = '1' then
                valid_s22 <= valid_s21;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n298_s23 <= n298_s22;
                n301_s23 <= n301_s22;
                diffuse_row <= diffuse_rom(to_integer(diffuse_n304_s22));
                n310_s23 <= n310_s22;
                n313_s23 <= n313_s22;
                specular_row <= specular_rom(to_integer(specular_n316_s22));
            end if;
            if rst = '1' then
                valid_s23 <= '0';
            elsif ce = '1' then
                valid_s23 <= valid_s22;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----
    -- diffuse
    diffuse_n305 <= diffuse_row;
    -- (unit)
    n308 <= n306 when n301_s23(0) = '1' else diffuse_n305;
    diffuse_next <= n307 when n298_s23(0) = '1' else n308;
    -- specular
    specular_n317 <= specular_row;
    -- (unit)
    n320 <= n318 when n313_s23(0) = '1' else specular_n317;
    specular_next <= n319 when n310_s23(0) = '1' else n320;
    n322 <= resize(diffuse_next, 17) + resize(specular_next, 17);
    intensity_next_over <= "1" when (or n322(16 downto 16)) = '1' else "0";
    intensity_next <= 16x"ffff" when intensity_next_over(0) = '1' else n322(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse <= diffuse_next;
                specular <= specular_next;
                intensity <= intensity_next;
            end if;
            if rst = '1' then
                valid_s24 <= '0';
            elsif ce = '1' then
                valid_s24 <= valid_s23;
            end if;
        end if;
    end process;

    -- ---- stage 24 ----

    valid_out <= valid_s24;
end architecture;
