{% for line in header %}--{% if line %} {{ line }}{% endif %}
{% endfor -%}
--
-- {{ name }} with its surroundings, for its testbench. The bench has the ports of a module with
-- one rate and without memories. Names between backslashes belong to the bench.
{%- for rate in rates %}
-- Words of rate {{ rate.name }} enter {{ entry - rate.entry }} cycle{{ "s" if entry - rate.entry != 1 }} before the sample of the fastest rate that they came with, and only
-- if they differ from the previous ones.
{%- endfor %}
{%- for memory in memories %}
-- Words of memory {{ memory.title }} come from {{ memory.file }}{{ "; they are written during the reset" if memory.write }}.
{%- endfor %}
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
{%- if memories %}
use std.textio.all;
{%- endif %}

entity {{ top }} is
    port (
        clk : in std_logic;
        rst : in std_logic;
        ce : in std_logic;
        valid_in : in std_logic;
{%- if interval > 1 %}
        ready : out std_logic;
{%- endif %}
{%- for port in inputs %}
        {{ port.name }} : in {{ port.shape }};
{%- endfor %}
        valid_out : out std_logic
{%- for port in outputs -%}
        ;
        {{ port.name }} : out {{ port.shape }}
{%- endfor %}
    );
end entity;

architecture bench of {{ top }} is
    signal \taken\ : std_logic;
{%- if interval > 1 %}
    signal \ready\ : std_logic;
{%- endif %}
{%- for rate in rates %}
    signal \words {{ rate.name }}\, \last {{ rate.name }}\ : std_logic_vector({{ rate.bits - 1 }} downto 0);
    signal \known {{ rate.name }}\ : std_logic := '0';
    signal \changed {{ rate.name }}\ : std_logic;
{%- if rate.entry > 0 %}
    signal \valid {{ rate.name }}\ : std_logic_vector(1 to {{ rate.entry }});
{%- endif %}
{%- endfor %}
{%- if entry > 0 %}
    signal \valid\ : std_logic_vector(1 to {{ entry }});
{%- for port in inputs if port.entry > 0 %}
    type \late {{ port.name }} t\ is array (1 to {{ port.entry }}) of {{ port.shape }};
    signal \late {{ port.name }}\ : \late {{ port.name }} t\ := (others => (others => '0'));
{%- endfor %}
{%- endif %}
{%- for memory in memories %}
    type \rows {{ memory.title }} t\ is array (0 to {{ memory.last }}) of unsigned({{ memory.row_bits - 1 }} downto 0);
    impure function \read {{ memory.title }}\ return \rows {{ memory.title }} t\ is
        file \source\ : text open read_mode is "{{ memory.file }}";
        variable \row\ : line;
        variable \all rows\ : \rows {{ memory.title }} t\;
    begin
        for \address\ in \all rows\'range loop
            readline(\source\, \row\);
            hread(\row\, \all rows\(\address\));
        end loop;
        return \all rows\;
    end function;
    constant \rows {{ memory.title }}\ : \rows {{ memory.title }} t\ := \read {{ memory.title }}\;
{%- if memory.write %}
    signal \load {{ memory.title }}\ : unsigned({{ memory.addr_bits - 1 }} downto 0) := (others => '0');
    signal \row {{ memory.title }}\ : unsigned({{ memory.row_bits - 1 }} downto 0);
{%- endif %}
{%- for read in memory.reads %}
    signal \address {{ read.address }}\ : unsigned({{ memory.addr_bits - 1 }} downto 0);
    type \row {{ read.address }} t\ is array (1 to {{ memory.latency }}) of unsigned({{ memory.row_bits - 1 }} downto 0);
    signal \row {{ read.address }}\ : \row {{ read.address }} t\ := (others => (others => '0'));
{%- endfor %}
{%- endfor %}
begin
    \taken\ <= valid_in{{ " and \\ready\\" if interval > 1 }};
{%- if interval > 1 %}
    ready <= \ready\;
{%- endif %}
{%- for rate in rates %}

    -- Words of rate {{ rate.name }} and of slower rates.
    \words {{ rate.name }}\ <= {% for name in rate.ports %}std_logic_vector({{ name }}){{ " & " if not loop.last }}{% endfor %};
    \changed {{ rate.name }}\ <= '0' when \known {{ rate.name }}\ = '1' and \last {{ rate.name }}\ = \words {{ rate.name }}\ else \taken\;
    process (clk)
    begin
        if rising_edge(clk) then
            if rst = '1' then
                \known {{ rate.name }}\ <= '0';
            elsif ce = '1' and \taken\ = '1' then
                \known {{ rate.name }}\ <= '1';
            end if;
            if ce = '1' and \taken\ = '1' then
                \last {{ rate.name }}\ <= \words {{ rate.name }}\;
            end if;
{%- if rate.entry > 0 %}
            if rst = '1' then
                \valid {{ rate.name }}\ <= (others => '0');
            elsif ce = '1' then
                \valid {{ rate.name }}\(1) <= \changed {{ rate.name }}\;
{%- if rate.entry > 1 %}
                \valid {{ rate.name }}\(2 to {{ rate.entry }}) <= \valid {{ rate.name }}\(1 to {{ rate.entry - 1 }});
{%- endif %}
            end if;
{%- endif %}
        end if;
    end process;
{%- endfor %}
{%- if entry > 0 %}

    -- Delays for rates that enter later.
    process (clk)
    begin
        if rising_edge(clk) then
            if rst = '1' then
                \valid\ <= (others => '0');
            elsif ce = '1' then
                \valid\(1) <= \taken\;
{%- if entry > 1 %}
                \valid\(2 to {{ entry }}) <= \valid\(1 to {{ entry - 1 }});
{%- endif %}
            end if;
            if ce = '1' then
{%- for port in inputs if port.entry > 0 %}
                \late {{ port.name }}\(1) <= {{ port.name }};
{%- if port.entry > 1 %}
                \late {{ port.name }}\(2 to {{ port.entry }}) <= \late {{ port.name }}\(1 to {{ port.entry - 1 }});
{%- endif %}
{%- endfor %}
            end if;
        end if;
    end process;
{%- endif %}
{%- for memory in memories %}
{%- if memory.write %}

    \row {{ memory.title }}\ <= \rows {{ memory.title }}\(to_integer(\load {{ memory.title }}\));
    process (clk)
    begin
        if rising_edge(clk) and rst = '1' then
            \load {{ memory.title }}\ <= \load {{ memory.title }}\ + 1;
        end if;
    end process;
{%- endif %}
{%- for read in memory.reads %}

    process (clk)
    begin
        if rising_edge(clk) and ce = '1' then
            \row {{ read.address }}\(1) <= \rows {{ memory.title }}\(to_integer(\address {{ read.address }}\));
{%- if memory.latency > 1 %}
            \row {{ read.address }}\(2 to {{ memory.latency }}) <= \row {{ read.address }}\(1 to {{ memory.latency - 1 }});
{%- endif %}
        end if;
    end process;
{%- endfor %}
{%- endfor %}

    \dut\ : entity work.{{ name }}
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => {{ "\\valid\\(" ~ entry ~ ")" if entry > 0 else "\\taken\\" }}, valid_out => valid_out
{%- for rate in rates %},
            {{ rate.port }} => {{ "\\valid " ~ rate.name ~ "\\(" ~ rate.entry ~ ")" if rate.entry > 0 else "\\changed " ~ rate.name ~ "\\" }}
{%- if rate.ready %},
            {{ rate.ready }} => {{ "\\ready\\" if rate.is_all else "open" }}
{%- endif %}
{%- endfor %}
{%- if unit_interval > 1 %},
            ready => {{ "\\ready\\" if unit_interval == interval else "open" }}
{%- endif %}
{%- for port in inputs -%}
            ,
            {{ port.name }} => {{ "\\late " ~ port.name ~ "\\(" ~ port.entry ~ ")" if port.entry > 0 else port.name }}
{%- endfor %}
{%- for port in outputs -%}
            ,
            {{ port.name }} => {{ port.name }}
{%- endfor %}
{%- for memory in memories %}
{%- for read in memory.reads -%}
            ,
            {{ read.address }} => \address {{ read.address }}\
{%- for data in read.data -%}
            ,
            {{ data.name }} => {{ "signed" if data.signed else "unsigned" }}(\row {{ read.address }}\({{ memory.latency }})({{ data.top }} downto {{ data.low }}))
{%- endfor %}
{%- endfor %}
{%- if memory.write -%}
            ,
            {{ memory.write.enable }}(0) => rst,
            {{ memory.write.address }} => \load {{ memory.title }}\
{%- for data in memory.write.data -%}
            ,
            {{ data.name }} => {{ "signed" if data.signed else "unsigned" }}(\row {{ memory.title }}\({{ data.top }} downto {{ data.low }}))
{%- endfor %}
{%- endif %}
{%- endfor %}
        );
end architecture;
