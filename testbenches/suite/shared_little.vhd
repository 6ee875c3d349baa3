-- under test
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity little is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits and the phase
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        ready : out std_logic; -- inputs are taken at this edge
        x : in signed(5 downto 0); -- s6f4
        y : in signed(5 downto 0); -- s6f4
        valid_out : out std_logic;
        sum : out signed(12 downto 0) := (others => '0'); -- s13f8
        passed : out signed(5 downto 0) := (others => '0') -- s6f4
    );
end entity;

architecture rtl of little is
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
    signal x_s1 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal x_s4 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal y_s1 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal y_s4 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal y_s7 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal square : signed(11 downto 0) := (others => '0'); -- s12f8
    signal square_s4 : signed(11 downto 0) := (others => '0'); -- s12f8
    signal narrow_s5 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal cube : signed(11 downto 0) := (others => '0'); -- s12f8
    signal cube_s8 : signed(11 downto 0) := (others => '0'); -- s12f8
    signal both : signed(11 downto 0) := (others => '0'); -- s12f8
    signal both_s9 : signed(11 downto 0) := (others => '0'); -- s12f8
    -- stage 0
    signal valid_s1 : std_logic;
    -- stage 3
    signal valid_s4 : std_logic;
    -- stage 4
    signal narrow_sum : signed(12 downto 0) := (others => '0');
    signal narrow_cut : signed(8 downto 0) := (others => '0');
    signal narrow_over : unsigned(0 downto 0) := (others => '0');
    signal narrow_under : unsigned(0 downto 0) := (others => '0');
    signal narrow : signed(5 downto 0) := (others => '0'); -- s6f4
    -- stage 6
    signal valid_s7 : std_logic;
    -- stage 7
    -- stage 8
    -- stage 9
    signal n6 : signed(12 downto 0) := (others => '0'); -- s13f8
    signal valid_s10 : std_logic;
    -- inputs of mul1
    signal mul1_in0_next : signed(5 downto 0) := (others => '0'); -- s6f4
    signal phase_0_1 : unsigned(0 downto 0) := (others => '0');
    signal mul1_in1_next : signed(5 downto 0) := (others => '0'); -- s6f4
    signal mul1_in0 : signed(5 downto 0) := (others => '0'); -- s6f4
    signal mul1_in1 : signed(5 downto 0) := (others => '0'); -- s6f4
    -- mul1, stage 0
    signal mul1_n0 : signed(11 downto 0) := (others => '0'); -- s12f8
    signal mul1_n0_s1 : signed(11 downto 0) := (others => '0'); -- s12f8
    -- mul1, stage 1
    signal mul1_n0_s2 : signed(11 downto 0) := (others => '0'); -- s12f8
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

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                x_s1 <= x;
                y_s1 <= y;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                x_s4 <= x_s1;
                y_s4 <= y_s1;
                square_s4 <= square;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s4 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    narrow_sum <= resize(square_s4, 13) + 13x"0008";
    narrow_cut <= narrow_sum(12 downto 4);
    narrow_over <= "1" when narrow_cut(8) = '0' and (or narrow_cut(7 downto 5)) = '1' else "0";
    narrow_under <= "1" when narrow_cut(8) = '1' and (and narrow_cut(7 downto 5)) = '0' else "0";
    narrow <= 6x"1f" when narrow_over(0) = '1' else 6x"20" when narrow_under(0) = '1' else narrow_cut(5 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_1(0) = '1' then
                narrow_s5 <= narrow;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                y_s7 <= y_s4;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s7 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_1(0) = '1' then
                cube_s8 <= cube;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_2(0) = '1' then
                both_s9 <= both;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    n6 <= resize(cube_s8, 13) + resize(both_s9, 13);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0(0) = '1' then
                passed <= y_s7;
                sum <= n6;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' and phase_0(0) = '1' then
                valid_s10 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- inputs of mul1 ----
    mul1_in0_next <= narrow when phase_1(0) = '1' else x;
    phase_0_1 <= phase_0 or phase_1;
    mul1_in1_next <= x_s4 when phase_1(0) = '1' else y_s4 when phase_2(0) = '1' else x;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' and phase_0_1(0) = '1' then
                mul1_in0 <= mul1_in0_next;
            end if;
            if ce = '1' then
                mul1_in1 <= mul1_in1_next;
            end if;
        end if;
    end process;

    -- ---- mul1, stage 0 ----
    mul1_n0 <= mul1_in0 * mul1_in1;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                mul1_n0_s1 <= mul1_n0;
            end if;
        end if;
    end process;

    -- ---- mul1, stage 1 ----

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                mul1_n0_s2 <= mul1_n0_s1;
            end if;
        end if;
    end process;

    -- ---- results of mul1 ----
    square <= mul1_n0_s2;
    cube <= mul1_n0_s2;
    both <= mul1_n0_s2;

    ready <= phase_0(0);
    valid_out <= valid_s10 and phase_1(0);
end architecture;
