-- kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
-- made by fixpath 0.1.0; Kugler 1998 (IMEM), as seed 001 (Lee et al.) describes it; largely a reconstruction
--   conversion=table tilt_addr_bits=14 map_angle_bits=8 map_addr_bits=12 angle_bits=16
--   table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up
--   recip_addr_bits=auto atan_addr_bits=auto cordic_iterations=auto highlight=on light_bits=16
--   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
-- latency 21 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 1.64e-2, largest seen 3.21e-1 (21034.8 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
--   diffuse: mean 1.43e-2, largest seen 1.61e-1 (10548.1 ulp) at n_x=64337 n_y=68 n_z=-12481 psi=46469 phi_p=59889 theta_p=8345 phi_l=60553 theta_l=24577 phi_h=60753 theta_h=28326
--   specular: mean 3.33e-3, largest seen 2.10e-1 (13738.9 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
--   pw_angle: mean 6.11e-2 rad, largest seen 1.66e-1 rad at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
--   pw_dot: mean 6.11e-2, largest seen 1.66e-1 at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
--   pw_x: mean 2.72e-2, largest seen 1.50e-1 at n_x=-40953 n_y=22153 n_z=46120 psi=61767 phi_p=36536 theta_p=8148 phi_l=60944 theta_l=4014 phi_h=33548 theta_h=9549
--   pw_y: mean 2.71e-2, largest seen 1.47e-1 at n_x=13068 n_y=52261 n_z=-37322 psi=50906 phi_p=20746 theta_p=8211 phi_l=13848 theta_l=18740 phi_h=19374 theta_h=27605
--   pw_z: mean 3.70e-2, largest seen 1.56e-1 at n_x=58525 n_y=-14807 n_z=25506 psi=44588 phi_p=12702 theta_p=8159 phi_l=49639 theta_l=20508 phi_h=63118 theta_h=22796
--   pl_angle: mean 8.82e-2 rad, largest seen 2.91e-1 rad at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
--   pl_dot: mean 8.82e-2, largest seen 2.90e-1 at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
--   pl_x: mean 4.70e-2, largest seen 2.78e-1 at n_x=36200 n_y=-53003 n_z=-13238 psi=14755 phi_p=47780 theta_p=7407 phi_l=57722 theta_l=28642 phi_h=58499 theta_h=19711
--   pl_y: mean 3.86e-2, largest seen 1.99e-1 at n_x=1054 n_y=243 n_z=65527 psi=4485 phi_p=44708 theta_p=8256 phi_l=16693 theta_l=28786 phi_h=40236 theta_h=23869
--   pl_z: mean 4.65e-2, largest seen 2.53e-1 at n_x=-21222 n_y=60550 n_z=-13354 psi=8628 phi_p=51032 theta_p=3342 phi_l=50666 theta_l=26736 phi_h=12630 theta_h=28946
--   ph_angle: mean 8.83e-2 rad, largest seen 2.92e-1 rad at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
--   ph_dot: mean 8.83e-2, largest seen 2.91e-1 at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
--   ph_x: mean 4.70e-2, largest seen 2.42e-1 at n_x=40289 n_y=36933 n_z=-36161 psi=5281 phi_p=51702 theta_p=5800 phi_l=12406 theta_l=11093 phi_h=11666 theta_h=24712
--   ph_y: mean 3.87e-2, largest seen 1.90e-1 at n_x=18685 n_y=41876 n_z=-46821 psi=56218 phi_p=58881 theta_p=9312 phi_l=60146 theta_l=20332 phi_h=65052 theta_h=17648
--   ph_z: mean 4.67e-2, largest seen 2.45e-1 at n_x=63088 n_y=-17640 n_z=1940 psi=34649 phi_p=1283 theta_p=7197 phi_l=57191 theta_l=29307 phi_h=60648 theta_h=22533
-- no bound is stated: near a pole, a cell of a map has azimuths of the whole turn in it: no cell size bounds the light
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity kugler is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        n_x : in signed(17 downto 0); -- s18f16
        n_y : in signed(17 downto 0); -- s18f16
        n_z : in signed(17 downto 0); -- s18f16
        psi : in unsigned(15 downto 0); -- u16f16
        phi_p : in unsigned(15 downto 0); -- u16f16
        theta_p : in unsigned(15 downto 0); -- u16f16
        phi_l : in unsigned(15 downto 0); -- u16f16
        theta_l : in unsigned(15 downto 0); -- u16f16
        phi_h : in unsigned(15 downto 0); -- u16f16
        theta_h : in unsigned(15 downto 0); -- u16f16
        valid_out : out std_logic;
        intensity : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        diffuse : out unsigned(15 downto 0) := (others => '0'); -- u16f16
        specular : out unsigned(15 downto 0) := (others => '0') -- u16f16
    );
end entity;

architecture rtl of kugler is
    attribute rom_style : string;

    -- table recip: recip u20f18
    type recip_rom_rows is array (0 to 1023) of unsigned(19 downto 0);
    impure function recip_rom_file return recip_rom_rows is
        file source : text open read_mode is "kugler_recip.hex";
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
        file source : text open read_mode is "kugler_atan.hex";
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

    -- table tilt_map: phi u8f8, theta u8f9
    type tilt_map_rom_rows is array (0 to 16383) of unsigned(15 downto 0);
    impure function tilt_map_rom_file return tilt_map_rom_rows is
        file source : text open read_mode is "kugler_tilt_map.hex";
        variable row : line;
        variable all_rows : tilt_map_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant tilt_map_rom : tilt_map_rom_rows := tilt_map_rom_file;
    attribute rom_style of tilt_map_rom : constant is "block";

    -- table diffuse_map: light u16f16
    type diffuse_map_rom_rows is array (0 to 4095) of unsigned(15 downto 0);
    impure function diffuse_map_rom_file return diffuse_map_rom_rows is
        file source : text open read_mode is "kugler_diffuse_map.hex";
        variable row : line;
        variable all_rows : diffuse_map_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant diffuse_map_rom : diffuse_map_rom_rows := diffuse_map_rom_file;
    attribute rom_style of diffuse_map_rom : constant is "block";

    -- table specular_map: light u16f16
    type specular_map_rom_rows is array (0 to 4095) of unsigned(15 downto 0);
    impure function specular_map_rom_file return specular_map_rom_rows is
        file source : text open read_mode is "kugler_specular_map.hex";
        variable row : line;
        variable all_rows : specular_map_rom_rows;
    begin
        for address in all_rows'range loop
            readline(source, row);
            hread(row, all_rows(address));
        end loop;
        return all_rows;
    end function;
    constant specular_map_rom : specular_map_rom_rows := specular_map_rom_file;
    attribute rom_style of specular_map_rom : constant is "block";

    -- a copy of table tilt_map: phi u8f8, theta u8f9
    constant tilt_map_rom_2 : tilt_map_rom_rows := tilt_map_rom;
    attribute rom_style of tilt_map_rom_2 : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal setup_n10_wide : signed(19 downto 0) := (others => '0');
    signal setup_n10 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_n11_wide : signed(19 downto 0) := (others => '0');
    signal setup_n11 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_n12_wide : signed(19 downto 0) := (others => '0');
    signal setup_n12 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_normal_azimuth_n13_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_normal_azimuth_n13 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n14_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_normal_azimuth_n14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n17 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n33 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_normal_azimuth_n36 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n37 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_normal_azimuth_n40 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n47 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n79 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_phi_texture : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n81 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_n82_cut : unsigned(5 downto 0) := (others => '0');
    signal setup_n82_over : unsigned(0 downto 0) := (others => '0');
    signal setup_n82 : unsigned(4 downto 0) := (others => '0'); -- u5f6
    signal setup_n83 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_n86 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n94 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_n99_cut : unsigned(4 downto 0) := (others => '0');
    signal light_n99_over : unsigned(0 downto 0) := (others => '0');
    signal light_n99 : unsigned(3 downto 0) := (others => '0'); -- u4f5
    signal light_n100 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal light_n105 : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal half_n116_cut : unsigned(4 downto 0) := (others => '0');
    signal half_n116_over : unsigned(0 downto 0) := (others => '0');
    signal half_n116 : unsigned(3 downto 0) := (others => '0'); -- u4f5
    signal half_n117 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal phi_l_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s1 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n15_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n17_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n36_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s1 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s1 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s1 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s1 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s1 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s1 : std_logic;
    -- stage 1
    signal setup_normal_azimuth_n18_padded : unsigned(31 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_skip16 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_part16 : unsigned(15 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_skip8 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_part8 : unsigned(7 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_skip4 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_part4 : unsigned(3 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_skip2 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_part2 : unsigned(1 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18_skip1 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n18 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_normal_azimuth_n19_past : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n19_count : unsigned(4 downto 0) := (others => '0');
    signal setup_normal_azimuth_n19 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_normal_azimuth_n20 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_normal_azimuth_n21_past : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n21_count : unsigned(4 downto 0) := (others => '0');
    signal setup_normal_azimuth_n21 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_normal_azimuth_n22 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_normal_azimuth_n23 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_normal_azimuth_n24 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal setup_normal_azimuth_recip_n25 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_normal_azimuth_n27 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal phi_l_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s2 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n15_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16_s2 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_recip_n25_s2 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_normal_azimuth_n27_s2 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_normal_azimuth_n36_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s2 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s2 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s2 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s2 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal phi_l_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n15_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal recip_row : unsigned(19 downto 0) := (others => '0');
    signal setup_normal_azimuth_n27_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_normal_azimuth_n36_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s3 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s3 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s3 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s3 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal setup_normal_azimuth_recip_n26 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal phi_l_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s4 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n15_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_recip_n26_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n27_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_normal_azimuth_n36_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s4 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s4 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal setup_normal_azimuth_n28 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal phi_l_s5 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s5 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n15_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_n28_s5 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_normal_azimuth_n36_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s5 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s5 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s5 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s5 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s5 : std_logic;
    -- stage 5
    signal setup_normal_azimuth_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal setup_normal_azimuth_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal setup_normal_azimuth_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_normal_azimuth_atan_n30 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal phi_l_s6 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s6 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n15_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n16_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal atan_row : unsigned(37 downto 0) := (others => '0');
    signal setup_normal_azimuth_n36_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s6 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s6 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s6 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s6 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s6 : std_logic;
    -- stage 6
    signal setup_normal_azimuth_atan_n31 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_normal_azimuth_atan_n32 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_normal_azimuth_n34 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_normal_azimuth_n35 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal phi_l_s7 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s7 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n16_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_azimuth_atan_n32_s7 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_normal_azimuth_n35_s7 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_normal_azimuth_n36_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_azimuth_n40_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n47_s7 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_n86_s7 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s7 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s7 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal setup_normal_azimuth_n38 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_normal_azimuth_n39 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_normal_azimuth_n41 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_normal_azimuth_n42 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_normal_azimuth_n43 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_normal_azimuth_n44 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal setup_normal_n75_sum : unsigned(18 downto 0) := (others => '0');
    signal setup_normal_n75_cut : unsigned(16 downto 0) := (others => '0');
    signal setup_normal_n75 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_normal_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_l_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_azimuth_n44_s8 : unsigned(38 downto 0) := (others => '0'); -- u39f36
    signal setup_normal_polar_angle_n47_s8 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s8 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s8 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s8 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s8 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal setup_normal_azimuth_n45_sum : unsigned(39 downto 0) := (others => '0');
    signal setup_normal_azimuth_n45_cut : unsigned(21 downto 0) := (others => '0');
    signal setup_normal_azimuth_n45_over : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_azimuth_n45 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_normal_n46_over : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_n46_under : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_n46 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_normal_polar_angle_n48_neg : unsigned(19 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n48 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n71 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal phi_l_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n47_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n48_s9 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n68_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s9 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s9 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s9 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s9 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal setup_normal_polar_angle_n49 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n50 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n51 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n52_padded : unsigned(31 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_skip16 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_part16 : unsigned(15 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_skip8 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_part8 : unsigned(7 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_skip4 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_part4 : unsigned(3 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_skip2 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_part2 : unsigned(1 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52_skip1 : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n52 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal phi_l_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n49_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n50_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n51_s10 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n52_s10 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal setup_normal_polar_angle_n68_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s10 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s10 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s10 : std_logic;
    -- stage 10
    signal setup_normal_polar_angle_n53_past : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n53_count : unsigned(4 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n53 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_normal_polar_angle_n54 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_normal_polar_angle_n55_past : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n55_count : unsigned(4 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n55 : unsigned(39 downto 0) := (others => '0'); -- u40f18
    signal setup_normal_polar_angle_n56 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal setup_normal_polar_angle_n57 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal setup_normal_polar_angle_n58 : unsigned(18 downto 0) := (others => '0'); -- u19f20
    signal setup_normal_polar_angle_recip_n59 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal setup_normal_polar_angle_n61 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal phi_l_s11 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s11 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n49_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal recip_row_2 : unsigned(19 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n61_s11 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_normal_polar_angle_n68_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s11 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s11 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s11 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s11 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s11 : std_logic;
    -- stage 11
    signal setup_normal_polar_angle_recip_n60 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal phi_l_s12 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s12 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n49_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_recip_n60_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal setup_normal_polar_angle_n61_s12 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal setup_normal_polar_angle_n68_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s12 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s12 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s12 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s12 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s12 : std_logic;
    -- stage 12
    signal setup_normal_polar_angle_n62 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal phi_l_s13 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s13 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n49_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n62_s13 : unsigned(39 downto 0) := (others => '0'); -- u40f38
    signal setup_normal_polar_angle_n68_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s13 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s13 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s13 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s13 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s13 : std_logic;
    -- stage 13
    signal setup_normal_polar_angle_ratio_sum : unsigned(40 downto 0) := (others => '0');
    signal setup_normal_polar_angle_ratio_cut : unsigned(20 downto 0) := (others => '0');
    signal setup_normal_polar_angle_ratio_over : unsigned(0 downto 0) := (others => '0');
    signal setup_normal_polar_angle_ratio : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_normal_polar_angle_atan_n64 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal phi_l_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n49_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal atan_row_2 : unsigned(37 downto 0) := (others => '0');
    signal setup_normal_polar_angle_n68_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s14 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s14 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s14 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s14 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s14 : std_logic;
    -- stage 14
    signal setup_normal_polar_angle_atan_n65 : unsigned(18 downto 0) := (others => '0'); -- u19f18
    signal setup_normal_polar_angle_n66 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_normal_polar_angle_n67 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal phi_l_s15 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s15 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_polar_angle_n67_s15 : signed(19 downto 0) := (others => '0'); -- s20f18
    signal setup_normal_polar_angle_n68_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_polar_angle_n71_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal setup_normal_phi_s15 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s15 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s15 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s15 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s15 : std_logic;
    -- stage 15
    signal setup_normal_polar_angle_n69 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_normal_polar_angle_n70 : signed(20 downto 0) := (others => '0'); -- s21f18
    signal setup_normal_polar_angle_n72 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_normal_polar_angle_n73 : signed(21 downto 0) := (others => '0'); -- s22f18
    signal setup_normal_polar_angle_n74 : unsigned(17 downto 0) := (others => '0'); -- u18f18
    signal setup_normal_n77_sum : unsigned(18 downto 0) := (others => '0');
    signal setup_normal_n77_cut : unsigned(16 downto 0) := (others => '0');
    signal setup_normal_n77 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_normal_theta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_l_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_phi_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_theta_s16 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_n86_s16 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n100_s16 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s16 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s16 : std_logic;
    -- stage 16
    signal setup_n84_cut : unsigned(4 downto 0) := (others => '0');
    signal setup_n84_over : unsigned(0 downto 0) := (others => '0');
    signal setup_n84 : unsigned(3 downto 0) := (others => '0'); -- u4f5
    signal setup_n85 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal setup_n87 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal phi_l_s17 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal phi_h_s17 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal setup_normal_phi_s17 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal tilt_map_row : unsigned(15 downto 0) := (others => '0');
    signal light_n100_s17 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal half_n117_s17 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal valid_s17 : std_logic;
    -- stage 17
    signal setup_n88 : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal setup_theta : unsigned(7 downto 0) := (others => '0'); -- u8f9
    signal setup_n90 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal setup_phi : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_n92 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal light_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_n95 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal light_n96 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal light_n97_cut : unsigned(4 downto 0) := (others => '0');
    signal light_n97 : unsigned(4 downto 0) := (others => '0'); -- u5f6
    signal light_n98 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal light_n101 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal light_n102 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal half_n112 : signed(16 downto 0) := (others => '0'); -- s17f16
    signal half_delta : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_n114 : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_n115 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal half_n118 : unsigned(9 downto 0) := (others => '0'); -- u10f0
    signal half_n119 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal light_n102_s18 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal half_n119_s18 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal valid_s18 : std_logic;
    -- stage 18
    signal tilt_map_row_2 : unsigned(15 downto 0) := (others => '0');
    signal tilt_map_row_3 : unsigned(15 downto 0) := (others => '0');
    signal valid_s19 : std_logic;
    -- stage 19
    signal light_n103 : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal light_theta : unsigned(7 downto 0) := (others => '0'); -- u8f9
    signal light_phi : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal light_n107 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal light_n108_cut : unsigned(5 downto 0) := (others => '0');
    signal light_n108 : unsigned(5 downto 0) := (others => '0'); -- u6f7
    signal light_n109 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal light_n110 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal half_n120 : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal half_theta : unsigned(7 downto 0) := (others => '0'); -- u8f9
    signal half_phi : unsigned(7 downto 0) := (others => '0'); -- u8f8
    signal half_n123 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal half_n124_cut : unsigned(5 downto 0) := (others => '0');
    signal half_n124 : unsigned(5 downto 0) := (others => '0'); -- u6f7
    signal half_n125 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal half_n126 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal diffuse_map_row : unsigned(15 downto 0) := (others => '0');
    signal specular_map_row : unsigned(15 downto 0) := (others => '0');
    signal valid_s20 : std_logic;
    -- stage 20
    signal light_diffuse : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal half_specular : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal n128 : unsigned(16 downto 0) := (others => '0'); -- u17f16
    signal intensity_next_over : unsigned(0 downto 0) := (others => '0');
    signal intensity_next : unsigned(15 downto 0) := (others => '0'); -- u16f16
    signal valid_s21 : std_logic;
begin

    -- ---- stage 0 ----
    -- setup
    setup_n10_wide <= shift_left(resize(n_x, 20), 2);
    setup_n10 <= setup_n10_wide;
    setup_n11_wide <= shift_left(resize(n_y, 20), 2);
    setup_n11 <= setup_n11_wide;
    setup_n12_wide <= shift_left(resize(n_z, 20), 2);
    setup_n12 <= setup_n12_wide;
    -- setup.normal.azimuth
    setup_normal_azimuth_n13_neg <= unsigned(-setup_n10);
    setup_normal_azimuth_n13 <= setup_normal_azimuth_n13_neg when setup_n10(19) = '1' else unsigned(setup_n10);
    setup_normal_azimuth_n14_neg <= unsigned(-setup_n11);
    setup_normal_azimuth_n14 <= setup_normal_azimuth_n14_neg when setup_n11(19) = '1' else unsigned(setup_n11);
    setup_normal_azimuth_n15 <= "1" when setup_normal_azimuth_n13 < setup_normal_azimuth_n14 else "0";
    setup_normal_azimuth_n16 <= setup_normal_azimuth_n14 when setup_normal_azimuth_n15(0) = '1' else setup_normal_azimuth_n13;
    setup_normal_azimuth_n17 <= setup_normal_azimuth_n13 when setup_normal_azimuth_n15(0) = '1' else setup_normal_azimuth_n14;
    setup_normal_azimuth_n33 <= 19x"10000";
    setup_normal_azimuth_n36 <= unsigned(setup_n10(19 downto 19));
    setup_normal_azimuth_n37 <= 19x"20000";
    setup_normal_azimuth_n40 <= unsigned(setup_n11(19 downto 19));
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n47_neg <= unsigned(-setup_n12);
    setup_normal_polar_angle_n47 <= setup_normal_polar_angle_n47_neg when setup_n12(19) = '1' else unsigned(setup_n12);
    setup_normal_polar_angle_n68 <= unsigned(setup_n12(19 downto 19));
    -- setup
    setup_n79 <= resize(phi_p, 17) + resize(psi, 17);
    setup_phi_texture <= setup_n79(15 downto 0);
    setup_n81 <= setup_phi_texture(15 downto 11);
    setup_n82_cut <= theta_p(15 downto 10);
    setup_n82_over <= "1" when (or setup_n82_cut(5 downto 5)) = '1' else "0";
    setup_n82 <= 5x"1f" when setup_n82_over(0) = '1' else setup_n82_cut(4 downto 0);
    setup_n83 <= setup_n82;
    setup_n86 <= setup_n81 & setup_n83;
    -- light
    light_n94 <= 16x"8000";
    light_n99_cut <= theta_l(15 downto 11);
    light_n99_over <= "1" when (or light_n99_cut(4 downto 4)) = '1' else "0";
    light_n99 <= 4x"f" when light_n99_over(0) = '1' else light_n99_cut(3 downto 0);
    light_n100 <= light_n99;
    light_n105 <= 8x"80";
    -- half
    half_n116_cut <= theta_h(15 downto 11);
    half_n116_over <= "1" when (or half_n116_cut(4 downto 4)) = '1' else "0";
    half_n116 <= 4x"f" when half_n116_over(0) = '1' else half_n116_cut(3 downto 0);
    half_n117 <= half_n116;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s1 <= phi_l;
                phi_h_s1 <= phi_h;
                setup_normal_azimuth_n15_s1 <= setup_normal_azimuth_n15;
                setup_normal_azimuth_n16_s1 <= setup_normal_azimuth_n16;
                setup_normal_azimuth_n17_s1 <= setup_normal_azimuth_n17;
                setup_normal_azimuth_n36_s1 <= setup_normal_azimuth_n36;
                setup_normal_azimuth_n40_s1 <= setup_normal_azimuth_n40;
                setup_normal_polar_angle_n47_s1 <= setup_normal_polar_angle_n47;
                setup_normal_polar_angle_n68_s1 <= setup_normal_polar_angle_n68;
                setup_n86_s1 <= setup_n86;
                light_n100_s1 <= light_n100;
                half_n117_s1 <= half_n117;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- setup.normal.azimuth
    setup_normal_azimuth_n18_padded <= setup_normal_azimuth_n16_s1 & 12x"fff";
    setup_normal_azimuth_n18_skip16 <= "1" when setup_normal_azimuth_n18_padded(31 downto 16) = 16x"0000" else "0";
    setup_normal_azimuth_n18_part16 <= setup_normal_azimuth_n18_padded(15 downto 0) when setup_normal_azimuth_n18_skip16(0) = '1' else setup_normal_azimuth_n18_padded(31 downto 16);
    setup_normal_azimuth_n18_skip8 <= "1" when setup_normal_azimuth_n18_part16(15 downto 8) = 8x"00" else "0";
    setup_normal_azimuth_n18_part8 <= setup_normal_azimuth_n18_part16(7 downto 0) when setup_normal_azimuth_n18_skip8(0) = '1' else setup_normal_azimuth_n18_part16(15 downto 8);
    setup_normal_azimuth_n18_skip4 <= "1" when setup_normal_azimuth_n18_part8(7 downto 4) = 4x"0" else "0";
    setup_normal_azimuth_n18_part4 <= setup_normal_azimuth_n18_part8(3 downto 0) when setup_normal_azimuth_n18_skip4(0) = '1' else setup_normal_azimuth_n18_part8(7 downto 4);
    setup_normal_azimuth_n18_skip2 <= "1" when setup_normal_azimuth_n18_part4(3 downto 2) = "00" else "0";
    setup_normal_azimuth_n18_part2 <= setup_normal_azimuth_n18_part4(1 downto 0) when setup_normal_azimuth_n18_skip2(0) = '1' else setup_normal_azimuth_n18_part4(3 downto 2);
    setup_normal_azimuth_n18_skip1 <= "1" when setup_normal_azimuth_n18_part2(1 downto 1) = "0" else "0";
    setup_normal_azimuth_n18 <= setup_normal_azimuth_n18_skip16 & setup_normal_azimuth_n18_skip8 & setup_normal_azimuth_n18_skip4 & setup_normal_azimuth_n18_skip2 & setup_normal_azimuth_n18_skip1;
    setup_normal_azimuth_n19_past <= "1" when 5x"14" < setup_normal_azimuth_n18 else "0";
    setup_normal_azimuth_n19_count <= 5x"14" when setup_normal_azimuth_n19_past(0) = '1' else setup_normal_azimuth_n18;
    setup_normal_azimuth_n19 <= shift_left(resize(setup_normal_azimuth_n16_s1, 40), to_integer(setup_normal_azimuth_n19_count));
    setup_normal_azimuth_n20 <= setup_normal_azimuth_n19(19 downto 0);
    setup_normal_azimuth_n21_past <= "1" when 5x"14" < setup_normal_azimuth_n18 else "0";
    setup_normal_azimuth_n21_count <= 5x"14" when setup_normal_azimuth_n21_past(0) = '1' else setup_normal_azimuth_n18;
    setup_normal_azimuth_n21 <= shift_left(resize(setup_normal_azimuth_n17_s1, 40), to_integer(setup_normal_azimuth_n21_count));
    setup_normal_azimuth_n22 <= setup_normal_azimuth_n21(19 downto 0);
    setup_normal_azimuth_n23 <= setup_normal_azimuth_n20(18 downto 0);
    setup_normal_azimuth_n24 <= setup_normal_azimuth_n23;
    -- setup.normal.azimuth.recip
    setup_normal_azimuth_recip_n25 <= setup_normal_azimuth_n24(18 downto 9);
    -- setup.normal.azimuth
    setup_normal_azimuth_n27 <= setup_normal_azimuth_n22;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s2 <= phi_l_s1;
                phi_h_s2 <= phi_h_s1;
                setup_normal_azimuth_n15_s2 <= setup_normal_azimuth_n15_s1;
                setup_normal_azimuth_n16_s2 <= setup_normal_azimuth_n16_s1;
                setup_normal_azimuth_recip_n25_s2 <= setup_normal_azimuth_recip_n25;
                setup_normal_azimuth_n27_s2 <= setup_normal_azimuth_n27;
                setup_normal_azimuth_n36_s2 <= setup_normal_azimuth_n36_s1;
                setup_normal_azimuth_n40_s2 <= setup_normal_azimuth_n40_s1;
                setup_normal_polar_angle_n47_s2 <= setup_normal_polar_angle_n47_s1;
                setup_normal_polar_angle_n68_s2 <= setup_normal_polar_angle_n68_s1;
                setup_n86_s2 <= setup_n86_s1;
                light_n100_s2 <= light_n100_s1;
                half_n117_s2 <= half_n117_s1;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s3 <= phi_l_s2;
                phi_h_s3 <= phi_h_s2;
                setup_normal_azimuth_n15_s3 <= setup_normal_azimuth_n15_s2;
                setup_normal_azimuth_n16_s3 <= setup_normal_azimuth_n16_s2;
                recip_row <= recip_rom(to_integer(setup_normal_azimuth_recip_n25_s2));
                setup_normal_azimuth_n27_s3 <= setup_normal_azimuth_n27_s2;
                setup_normal_azimuth_n36_s3 <= setup_normal_azimuth_n36_s2;
                setup_normal_azimuth_n40_s3 <= setup_normal_azimuth_n40_s2;
                setup_normal_polar_angle_n47_s3 <= setup_normal_polar_angle_n47_s2;
                setup_normal_polar_angle_n68_s3 <= setup_normal_polar_angle_n68_s2;
                setup_n86_s3 <= setup_n86_s2;
                light_n100_s3 <= light_n100_s2;
                half_n117_s3 <= half_n117_s2;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- setup.normal.azimuth.recip
    setup_normal_azimuth_recip_n26 <= recip_row;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s4 <= phi_l_s3;
                phi_h_s4 <= phi_h_s3;
                setup_normal_azimuth_n15_s4 <= setup_normal_azimuth_n15_s3;
                setup_normal_azimuth_n16_s4 <= setup_normal_azimuth_n16_s3;
                setup_normal_azimuth_recip_n26_s4 <= setup_normal_azimuth_recip_n26;
                setup_normal_azimuth_n27_s4 <= setup_normal_azimuth_n27_s3;
                setup_normal_azimuth_n36_s4 <= setup_normal_azimuth_n36_s3;
                setup_normal_azimuth_n40_s4 <= setup_normal_azimuth_n40_s3;
                setup_normal_polar_angle_n47_s4 <= setup_normal_polar_angle_n47_s3;
                setup_normal_polar_angle_n68_s4 <= setup_normal_polar_angle_n68_s3;
                setup_n86_s4 <= setup_n86_s3;
                light_n100_s4 <= light_n100_s3;
                half_n117_s4 <= half_n117_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- setup.normal.azimuth
    setup_normal_azimuth_n28 <= setup_normal_azimuth_n27_s4 * setup_normal_azimuth_recip_n26_s4;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s5 <= phi_l_s4;
                phi_h_s5 <= phi_h_s4;
                setup_normal_azimuth_n15_s5 <= setup_normal_azimuth_n15_s4;
                setup_normal_azimuth_n16_s5 <= setup_normal_azimuth_n16_s4;
                setup_normal_azimuth_n28_s5 <= setup_normal_azimuth_n28;
                setup_normal_azimuth_n36_s5 <= setup_normal_azimuth_n36_s4;
                setup_normal_azimuth_n40_s5 <= setup_normal_azimuth_n40_s4;
                setup_normal_polar_angle_n47_s5 <= setup_normal_polar_angle_n47_s4;
                setup_normal_polar_angle_n68_s5 <= setup_normal_polar_angle_n68_s4;
                setup_n86_s5 <= setup_n86_s4;
                light_n100_s5 <= light_n100_s4;
                half_n117_s5 <= half_n117_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- setup.normal.azimuth
    setup_normal_azimuth_ratio_sum <= resize(setup_normal_azimuth_n28_s5, 41) + 41x"00000080000";
    setup_normal_azimuth_ratio_cut <= setup_normal_azimuth_ratio_sum(40 downto 20);
    setup_normal_azimuth_ratio_over <= "1" when (or setup_normal_azimuth_ratio_cut(20 downto 18)) = '1' else "0";
    setup_normal_azimuth_ratio <= 18x"3ffff" when setup_normal_azimuth_ratio_over(0) = '1' else setup_normal_azimuth_ratio_cut(17 downto 0);
    -- setup.normal.azimuth.atan
    setup_normal_azimuth_atan_n30 <= setup_normal_azimuth_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s6 <= phi_l_s5;
                phi_h_s6 <= phi_h_s5;
                setup_normal_azimuth_n15_s6 <= setup_normal_azimuth_n15_s5;
                setup_normal_azimuth_n16_s6 <= setup_normal_azimuth_n16_s5;
                atan_row <= atan_rom(to_integer(setup_normal_azimuth_atan_n30));
                setup_normal_azimuth_n36_s6 <= setup_normal_azimuth_n36_s5;
                setup_normal_azimuth_n40_s6 <= setup_normal_azimuth_n40_s5;
                setup_normal_polar_angle_n47_s6 <= setup_normal_polar_angle_n47_s5;
                setup_normal_polar_angle_n68_s6 <= setup_normal_polar_angle_n68_s5;
                setup_n86_s6 <= setup_n86_s5;
                light_n100_s6 <= light_n100_s5;
                half_n117_s6 <= half_n117_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- setup.normal.azimuth.atan
    setup_normal_azimuth_atan_n31 <= atan_row(37 downto 19);
    setup_normal_azimuth_atan_n32 <= atan_row(18 downto 0);
    -- setup.normal.azimuth
    setup_normal_azimuth_n34 <= signed(resize(setup_normal_azimuth_n33, 20)) - signed(resize(setup_normal_azimuth_atan_n31, 20));
    setup_normal_azimuth_n35 <= setup_normal_azimuth_n34 when setup_normal_azimuth_n15_s6(0) = '1' else signed(resize(setup_normal_azimuth_atan_n31, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s7 <= phi_l_s6;
                phi_h_s7 <= phi_h_s6;
                setup_normal_azimuth_n16_s7 <= setup_normal_azimuth_n16_s6;
                setup_normal_azimuth_atan_n32_s7 <= setup_normal_azimuth_atan_n32;
                setup_normal_azimuth_n35_s7 <= setup_normal_azimuth_n35;
                setup_normal_azimuth_n36_s7 <= setup_normal_azimuth_n36_s6;
                setup_normal_azimuth_n40_s7 <= setup_normal_azimuth_n40_s6;
                setup_normal_polar_angle_n47_s7 <= setup_normal_polar_angle_n47_s6;
                setup_normal_polar_angle_n68_s7 <= setup_normal_polar_angle_n68_s6;
                setup_n86_s7 <= setup_n86_s6;
                light_n100_s7 <= light_n100_s6;
                half_n117_s7 <= half_n117_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- setup.normal.azimuth
    setup_normal_azimuth_n38 <= signed(resize(setup_normal_azimuth_n37, 21)) - resize(setup_normal_azimuth_n35_s7, 21);
    setup_normal_azimuth_n39 <= setup_normal_azimuth_n38 when setup_normal_azimuth_n36_s7(0) = '1' else resize(setup_normal_azimuth_n35_s7, 21);
    setup_normal_azimuth_n41 <= -resize(setup_normal_azimuth_n39, 22);
    setup_normal_azimuth_n42 <= setup_normal_azimuth_n41 when setup_normal_azimuth_n40_s7(0) = '1' else resize(setup_normal_azimuth_n39, 22);
    setup_normal_azimuth_n43 <= unsigned(setup_normal_azimuth_n42(17 downto 0));
    setup_normal_azimuth_n44 <= setup_normal_azimuth_n16_s7 * setup_normal_azimuth_atan_n32_s7;
    -- setup.normal
    setup_normal_n75_sum <= resize(setup_normal_azimuth_n43, 19) + 19x"00002";
    setup_normal_n75_cut <= setup_normal_n75_sum(18 downto 2);
    setup_normal_n75 <= setup_normal_n75_cut;
    setup_normal_phi <= setup_normal_n75(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s8 <= phi_l_s7;
                phi_h_s8 <= phi_h_s7;
                setup_normal_azimuth_n44_s8 <= setup_normal_azimuth_n44;
                setup_normal_polar_angle_n47_s8 <= setup_normal_polar_angle_n47_s7;
                setup_normal_polar_angle_n68_s8 <= setup_normal_polar_angle_n68_s7;
                setup_normal_phi_s8 <= setup_normal_phi;
                setup_n86_s8 <= setup_n86_s7;
                light_n100_s8 <= light_n100_s7;
                half_n117_s8 <= half_n117_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- setup.normal.azimuth
    setup_normal_azimuth_n45_sum <= resize(setup_normal_azimuth_n44_s8, 40) + 40x"0000020000";
    setup_normal_azimuth_n45_cut <= setup_normal_azimuth_n45_sum(39 downto 18);
    setup_normal_azimuth_n45_over <= "1" when (or setup_normal_azimuth_n45_cut(21 downto 20)) = '1' else "0";
    setup_normal_azimuth_n45 <= 21x"0fffff" when setup_normal_azimuth_n45_over(0) = '1' else signed(setup_normal_azimuth_n45_cut(20 downto 0));
    -- setup.normal
    setup_normal_n46_over <= "1" when setup_normal_azimuth_n45(20) = '0' and (or setup_normal_azimuth_n45(19 downto 19)) = '1' else "0";
    setup_normal_n46_under <= "1" when setup_normal_azimuth_n45(20) = '1' and (and setup_normal_azimuth_n45(19 downto 19)) = '0' else "0";
    setup_normal_n46 <= 20x"7ffff" when setup_normal_n46_over(0) = '1' else 20x"80000" when setup_normal_n46_under(0) = '1' else setup_normal_azimuth_n45(19 downto 0);
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n48_neg <= unsigned(-setup_normal_n46);
    setup_normal_polar_angle_n48 <= setup_normal_polar_angle_n48_neg when setup_normal_n46(19) = '1' else unsigned(setup_normal_n46);
    setup_normal_polar_angle_n71 <= unsigned(setup_normal_n46(19 downto 19));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s9 <= phi_l_s8;
                phi_h_s9 <= phi_h_s8;
                setup_normal_polar_angle_n47_s9 <= setup_normal_polar_angle_n47_s8;
                setup_normal_polar_angle_n48_s9 <= setup_normal_polar_angle_n48;
                setup_normal_polar_angle_n68_s9 <= setup_normal_polar_angle_n68_s8;
                setup_normal_polar_angle_n71_s9 <= setup_normal_polar_angle_n71;
                setup_normal_phi_s9 <= setup_normal_phi_s8;
                setup_n86_s9 <= setup_n86_s8;
                light_n100_s9 <= light_n100_s8;
                half_n117_s9 <= half_n117_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n49 <= "1" when setup_normal_polar_angle_n47_s9 < setup_normal_polar_angle_n48_s9 else "0";
    setup_normal_polar_angle_n50 <= setup_normal_polar_angle_n48_s9 when setup_normal_polar_angle_n49(0) = '1' else setup_normal_polar_angle_n47_s9;
    setup_normal_polar_angle_n51 <= setup_normal_polar_angle_n47_s9 when setup_normal_polar_angle_n49(0) = '1' else setup_normal_polar_angle_n48_s9;
    setup_normal_polar_angle_n52_padded <= setup_normal_polar_angle_n50 & 12x"fff";
    setup_normal_polar_angle_n52_skip16 <= "1" when setup_normal_polar_angle_n52_padded(31 downto 16) = 16x"0000" else "0";
    setup_normal_polar_angle_n52_part16 <= setup_normal_polar_angle_n52_padded(15 downto 0) when setup_normal_polar_angle_n52_skip16(0) = '1' else setup_normal_polar_angle_n52_padded(31 downto 16);
    setup_normal_polar_angle_n52_skip8 <= "1" when setup_normal_polar_angle_n52_part16(15 downto 8) = 8x"00" else "0";
    setup_normal_polar_angle_n52_part8 <= setup_normal_polar_angle_n52_part16(7 downto 0) when setup_normal_polar_angle_n52_skip8(0) = '1' else setup_normal_polar_angle_n52_part16(15 downto 8);
    setup_normal_polar_angle_n52_skip4 <= "1" when setup_normal_polar_angle_n52_part8(7 downto 4) = 4x"0" else "0";
    setup_normal_polar_angle_n52_part4 <= setup_normal_polar_angle_n52_part8(3 downto 0) when setup_normal_polar_angle_n52_skip4(0) = '1' else setup_normal_polar_angle_n52_part8(7 downto 4);
    setup_normal_polar_angle_n52_skip2 <= "1" when setup_normal_polar_angle_n52_part4(3 downto 2) = "00" else "0";
    setup_normal_polar_angle_n52_part2 <= setup_normal_polar_angle_n52_part4(1 downto 0) when setup_normal_polar_angle_n52_skip2(0) = '1' else setup_normal_polar_angle_n52_part4(3 downto 2);
    setup_normal_polar_angle_n52_skip1 <= "1" when setup_normal_polar_angle_n52_part2(1 downto 1) = "0" else "0";
    setup_normal_polar_angle_n52 <= setup_normal_polar_angle_n52_skip16 & setup_normal_polar_angle_n52_skip8 & setup_normal_polar_angle_n52_skip4 & setup_normal_polar_angle_n52_skip2 & setup_normal_polar_angle_n52_skip1;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s10 <= phi_l_s9;
                phi_h_s10 <= phi_h_s9;
                setup_normal_polar_angle_n49_s10 <= setup_normal_polar_angle_n49;
                setup_normal_polar_angle_n50_s10 <= setup_normal_polar_angle_n50;
                setup_normal_polar_angle_n51_s10 <= setup_normal_polar_angle_n51;
                setup_normal_polar_angle_n52_s10 <= setup_normal_polar_angle_n52;
                setup_normal_polar_angle_n68_s10 <= setup_normal_polar_angle_n68_s9;
                setup_normal_polar_angle_n71_s10 <= setup_normal_polar_angle_n71_s9;
                setup_normal_phi_s10 <= setup_normal_phi_s9;
                setup_n86_s10 <= setup_n86_s9;
                light_n100_s10 <= light_n100_s9;
                half_n117_s10 <= half_n117_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n53_past <= "1" when 5x"14" < setup_normal_polar_angle_n52_s10 else "0";
    setup_normal_polar_angle_n53_count <= 5x"14" when setup_normal_polar_angle_n53_past(0) = '1' else setup_normal_polar_angle_n52_s10;
    setup_normal_polar_angle_n53 <= shift_left(resize(setup_normal_polar_angle_n50_s10, 40), to_integer(setup_normal_polar_angle_n53_count));
    setup_normal_polar_angle_n54 <= setup_normal_polar_angle_n53(19 downto 0);
    setup_normal_polar_angle_n55_past <= "1" when 5x"14" < setup_normal_polar_angle_n52_s10 else "0";
    setup_normal_polar_angle_n55_count <= 5x"14" when setup_normal_polar_angle_n55_past(0) = '1' else setup_normal_polar_angle_n52_s10;
    setup_normal_polar_angle_n55 <= shift_left(resize(setup_normal_polar_angle_n51_s10, 40), to_integer(setup_normal_polar_angle_n55_count));
    setup_normal_polar_angle_n56 <= setup_normal_polar_angle_n55(19 downto 0);
    setup_normal_polar_angle_n57 <= setup_normal_polar_angle_n54(18 downto 0);
    setup_normal_polar_angle_n58 <= setup_normal_polar_angle_n57;
    -- setup.normal.polar_angle.recip
    setup_normal_polar_angle_recip_n59 <= setup_normal_polar_angle_n58(18 downto 9);
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n61 <= setup_normal_polar_angle_n56;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s11 <= phi_l_s10;
                phi_h_s11 <= phi_h_s10;
                setup_normal_polar_angle_n49_s11 <= setup_normal_polar_angle_n49_s10;
                recip_row_2 <= recip_rom(to_integer(setup_normal_polar_angle_recip_n59));
                setup_normal_polar_angle_n61_s11 <= setup_normal_polar_angle_n61;
                setup_normal_polar_angle_n68_s11 <= setup_normal_polar_angle_n68_s10;
                setup_normal_polar_angle_n71_s11 <= setup_normal_polar_angle_n71_s10;
                setup_normal_phi_s11 <= setup_normal_phi_s10;
                setup_n86_s11 <= setup_n86_s10;
                light_n100_s11 <= light_n100_s10;
                half_n117_s11 <= half_n117_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- setup.normal.polar_angle.recip
    setup_normal_polar_angle_recip_n60 <= recip_row_2;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s12 <= phi_l_s11;
                phi_h_s12 <= phi_h_s11;
                setup_normal_polar_angle_n49_s12 <= setup_normal_polar_angle_n49_s11;
                setup_normal_polar_angle_recip_n60_s12 <= setup_normal_polar_angle_recip_n60;
                setup_normal_polar_angle_n61_s12 <= setup_normal_polar_angle_n61_s11;
                setup_normal_polar_angle_n68_s12 <= setup_normal_polar_angle_n68_s11;
                setup_normal_polar_angle_n71_s12 <= setup_normal_polar_angle_n71_s11;
                setup_normal_phi_s12 <= setup_normal_phi_s11;
                setup_n86_s12 <= setup_n86_s11;
                light_n100_s12 <= light_n100_s11;
                half_n117_s12 <= half_n117_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n62 <= setup_normal_polar_angle_n61_s12 * setup_normal_polar_angle_recip_n60_s12;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s13 <= phi_l_s12;
                phi_h_s13 <= phi_h_s12;
                setup_normal_polar_angle_n49_s13 <= setup_normal_polar_angle_n49_s12;
                setup_normal_polar_angle_n62_s13 <= setup_normal_polar_angle_n62;
                setup_normal_polar_angle_n68_s13 <= setup_normal_polar_angle_n68_s12;
                setup_normal_polar_angle_n71_s13 <= setup_normal_polar_angle_n71_s12;
                setup_normal_phi_s13 <= setup_normal_phi_s12;
                setup_n86_s13 <= setup_n86_s12;
                light_n100_s13 <= light_n100_s12;
                half_n117_s13 <= half_n117_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- setup.normal.polar_angle
    setup_normal_polar_angle_ratio_sum <= resize(setup_normal_polar_angle_n62_s13, 41) + 41x"00000080000";
    setup_normal_polar_angle_ratio_cut <= setup_normal_polar_angle_ratio_sum(40 downto 20);
    setup_normal_polar_angle_ratio_over <= "1" when (or setup_normal_polar_angle_ratio_cut(20 downto 18)) = '1' else "0";
    setup_normal_polar_angle_ratio <= 18x"3ffff" when setup_normal_polar_angle_ratio_over(0) = '1' else setup_normal_polar_angle_ratio_cut(17 downto 0);
    -- setup.normal.polar_angle.atan
    setup_normal_polar_angle_atan_n64 <= setup_normal_polar_angle_ratio(17 downto 8);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s14 <= phi_l_s13;
                phi_h_s14 <= phi_h_s13;
                setup_normal_polar_angle_n49_s14 <= setup_normal_polar_angle_n49_s13;
                atan_row_2 <= atan_rom(to_integer(setup_normal_polar_angle_atan_n64));
                setup_normal_polar_angle_n68_s14 <= setup_normal_polar_angle_n68_s13;
                setup_normal_polar_angle_n71_s14 <= setup_normal_polar_angle_n71_s13;
                setup_normal_phi_s14 <= setup_normal_phi_s13;
                setup_n86_s14 <= setup_n86_s13;
                light_n100_s14 <= light_n100_s13;
                half_n117_s14 <= half_n117_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- setup.normal.polar_angle.atan
    setup_normal_polar_angle_atan_n65 <= atan_row_2(37 downto 19);
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n66 <= signed(resize(setup_normal_azimuth_n33, 20)) - signed(resize(setup_normal_polar_angle_atan_n65, 20));
    setup_normal_polar_angle_n67 <= setup_normal_polar_angle_n66 when setup_normal_polar_angle_n49_s14(0) = '1' else signed(resize(setup_normal_polar_angle_atan_n65, 20));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s15 <= phi_l_s14;
                phi_h_s15 <= phi_h_s14;
                setup_normal_polar_angle_n67_s15 <= setup_normal_polar_angle_n67;
                setup_normal_polar_angle_n68_s15 <= setup_normal_polar_angle_n68_s14;
                setup_normal_polar_angle_n71_s15 <= setup_normal_polar_angle_n71_s14;
                setup_normal_phi_s15 <= setup_normal_phi_s14;
                setup_n86_s15 <= setup_n86_s14;
                light_n100_s15 <= light_n100_s14;
                half_n117_s15 <= half_n117_s14;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- setup.normal.polar_angle
    setup_normal_polar_angle_n69 <= signed(resize(setup_normal_azimuth_n37, 21)) - resize(setup_normal_polar_angle_n67_s15, 21);
    setup_normal_polar_angle_n70 <= setup_normal_polar_angle_n69 when setup_normal_polar_angle_n68_s15(0) = '1' else resize(setup_normal_polar_angle_n67_s15, 21);
    setup_normal_polar_angle_n72 <= -resize(setup_normal_polar_angle_n70, 22);
    setup_normal_polar_angle_n73 <= setup_normal_polar_angle_n72 when setup_normal_polar_angle_n71_s15(0) = '1' else resize(setup_normal_polar_angle_n70, 22);
    setup_normal_polar_angle_n74 <= unsigned(setup_normal_polar_angle_n73(17 downto 0));
    -- setup.normal
    setup_normal_n77_sum <= resize(setup_normal_polar_angle_n74, 19) + 19x"00002";
    setup_normal_n77_cut <= setup_normal_n77_sum(18 downto 2);
    setup_normal_n77 <= setup_normal_n77_cut;
    setup_normal_theta <= setup_normal_n77(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s16 <= phi_l_s15;
                phi_h_s16 <= phi_h_s15;
                setup_normal_phi_s16 <= setup_normal_phi_s15;
                setup_normal_theta_s16 <= setup_normal_theta;
                setup_n86_s16 <= setup_n86_s15;
                light_n100_s16 <= light_n100_s15;
                half_n117_s16 <= half_n117_s15;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- setup
    setup_n84_cut <= setup_normal_theta_s16(15 downto 11);
    setup_n84_over <= "1" when (or setup_n84_cut(4 downto 4)) = '1' else "0";
    setup_n84 <= 4x"f" when setup_n84_over(0) = '1' else setup_n84_cut(3 downto 0);
    setup_n85 <= setup_n84;
    setup_n87 <= setup_n86_s16 & setup_n85;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                phi_l_s17 <= phi_l_s16;
                phi_h_s17 <= phi_h_s16;
                setup_normal_phi_s17 <= setup_normal_phi_s16;
                tilt_map_row <= tilt_map_rom(to_integer(setup_n87));
                light_n100_s17 <= light_n100_s16;
                half_n117_s17 <= half_n117_s16;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- setup
    setup_n88 <= tilt_map_row(15 downto 8);
    setup_theta <= tilt_map_row(7 downto 0);
    setup_n90 <= shift_left(resize(setup_n88, 17), 8) + resize(setup_normal_phi_s17, 17);
    setup_phi <= setup_n90(15 downto 0);
    -- light
    light_n92 <= signed(resize(setup_phi, 17)) - signed(resize(phi_l_s17, 17));
    light_delta <= unsigned(light_n92(15 downto 0));
    light_n95 <= light_delta xor light_n94;
    light_n96 <= light_n95(15 downto 11);
    light_n97_cut <= setup_theta(7 downto 3);
    light_n97 <= light_n97_cut;
    light_n98 <= light_n97;
    light_n101 <= light_n96 & light_n98;
    light_n102 <= light_n101 & light_n100_s17;
    -- half
    half_n112 <= signed(resize(setup_phi, 17)) - signed(resize(phi_h_s17, 17));
    half_delta <= unsigned(half_n112(15 downto 0));
    half_n114 <= half_delta xor light_n94;
    half_n115 <= half_n114(15 downto 11);
    half_n118 <= half_n115 & light_n98;
    half_n119 <= half_n118 & half_n117_s17;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                light_n102_s18 <= light_n102;
                half_n119_s18 <= half_n119;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                tilt_map_row_2 <= tilt_map_rom(to_integer(light_n102_s18));
                tilt_map_row_3 <= tilt_map_rom_2(to_integer(half_n119_s18));
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- light
    light_n103 <= tilt_map_row_2(15 downto 8);
    light_theta <= tilt_map_row_2(7 downto 0);
    light_phi <= light_n103 xor light_n105;
    light_n107 <= light_phi(7 downto 2);
    light_n108_cut <= light_theta(7 downto 2);
    light_n108 <= light_n108_cut;
    light_n109 <= light_n108;
    light_n110 <= light_n107 & light_n109;
    -- half
    half_n120 <= tilt_map_row_3(15 downto 8);
    half_theta <= tilt_map_row_3(7 downto 0);
    half_phi <= half_n120 xor light_n105;
    half_n123 <= half_phi(7 downto 2);
    half_n124_cut <= half_theta(7 downto 2);
    half_n124 <= half_n124_cut;
    half_n125 <= half_n124;
    half_n126 <= half_n123 & half_n125;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse_map_row <= diffuse_map_rom(to_integer(light_n110));
                specular_map_row <= specular_map_rom(to_integer(half_n126));
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    -- light
    light_diffuse <= diffuse_map_row;
    -- half
    half_specular <= specular_map_row;
    -- (unit)
    n128 <= resize(light_diffuse, 17) + resize(half_specular, 17);
    intensity_next_over <= "1" when (or n128(16 downto 16)) = '1' else "0";
    intensity_next <= 16x"ffff" when intensity_next_over(0) = '1' else n128(15 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                diffuse <= light_diffuse;
                specular <= half_specular;
                intensity <= intensity_next;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----

    valid_out <= valid_s21;
end architecture;
