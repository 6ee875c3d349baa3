{% for line in header %}--{% if line %} {{ line }}{% endif %}
{% endfor -%}
--
-- Self-checking testbench of {{ name }}.
-- Each line of {{ vectors }} holds the input words and then the
-- expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
-- {% if interval > 1 %}every {{ interval }} cycles when the module is ready, with words that it must ignore in between.
-- The{% else %}per cycle. The{% endif %} second pass sends the first {{ again }} again with stalls and gaps,
-- {% if state %}starting with a reset{% else %}with a reset in mid-stream{% endif %}. Every bit of every output and the latency are compared.
-- The last line says PASS or FAIL; a failure ends with a nonzero status, for which GHDL prints one
-- more line. With --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity {{ name }}_tb is
end entity;

architecture test of {{ name }}_tb is
    constant latency : natural := {{ latency }};
{%- if interval > 1 %}
    constant interval : natural := {{ interval }};
{%- endif %}
    constant shown : natural := 10; -- of the mismatches

    -- The prefix dut_ keeps the ports' names apart from the names used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
{%- if interval > 1 %}
    signal ready : std_logic;
{%- endif %}
{%- for port in inputs %}
    signal dut_{{ port.name }} : {{ port.shape }} := (others => '0');
{%- endfor %}
{%- for port in outputs %}
    signal dut_{{ port.name }} : {{ port.shape }};
{%- endfor %}
    signal done : boolean := false;

    function hex(word : std_logic_vector) return string is
        variable digits : string(1 to (word'length + 3) / 4) := to_hstring(word);
    begin
        for i in digits'range loop
            if digits(i) >= 'A' and digits(i) <= 'F' then
                digits(i) := character'val(character'pos(digits(i)) + 32);
            end if;
        end loop;
        return digits;
    end function;
begin
    dut : entity work.{{ top }}
        port map (
{%- if latency > 0 %}
            clk => clk, rst => rst, ce => ce,
{%- endif %}
            valid_in => valid_in, valid_out => valid_out
{%- if interval > 1 %},
            ready => ready
{%- endif %}
{%- for port in inputs + outputs -%}
            ,
            {{ port.name }} => dut_{{ port.name }}
{%- endfor %}
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector({{ output_bits - 1 }} downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := {{ count }};
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
{%- if interval > 1 %}
        variable phase : natural := 0; -- as the module should count it
        variable should_be_ready : std_logic;
{%- endif %}
{%- if resets > 1 %}
        variable resets : natural := {{ resets }}; -- cycles under reset that are left: memories are written
{%- endif %}
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
{%- for port in inputs + outputs %}
        variable next_{{ port.name }} : std_logic_vector({{ port.bits - 1 }} downto 0) := (others => '0');
{%- endfor %}

        procedure print(message : string) is
        begin
            write(output, message & LF);
        end procedure;

        procedure mismatch(message : string) is
        begin
            mismatches := mismatches + 1;
            if mismatches <= shown then
                print("mismatch: " & message);
            end if;
        end procedure;

        procedure open_vectors is
            variable status : file_open_status;
        begin
            sent := 0;
            checked := 0;
            more := true;
            reset_done := {{ "true" if state else "false" }};{{ " -- it would forget words of earlier samples" if state }}
            file_open(status, vectors, "{{ vectors }}", read_mode);
            if status /= open_ok then
                print("FAIL: {{ vectors }} can't be read");
                std.env.finish(1);
            end if;
        end procedure;

        procedure read_vector is
            variable words : line;
            variable good : boolean;
        begin
            more := false;
            while not endfile(vectors) and not more loop
                readline(vectors, words);
                more := words'length > 0;
            end loop;
            if more then
{%- for port in inputs + outputs %}
                hread(words, next_{{ port.name }}, good);
                more := more and good;
{%- endfor %}
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: {{ vectors }} is cut short after vector " & to_string(sent));
                end if;
            end if;
        end procedure;

        procedure check is
            procedure check_port(port_name : string; want, got : std_logic_vector) is
            begin
                if got /= want then
                    mismatch("vector " & to_string(number(latency)) & " " & port_name
                        & " expected " & hex(want) & " got " & hex(got));
                end if;
            end procedure;
        begin
            -- Nothing is known before the first edge under reset.
            if started and valid_out /= valid(latency) then
                mismatch("vector " & to_string(checked) & " valid_out expected "
                    & to_string(valid(latency)) & " got " & to_string(valid_out));
            end if;
{%- if interval > 1 %}
            should_be_ready := '0';
            if phase = 0 then
                should_be_ready := '1';
            end if;
            if started and ready /= should_be_ready then
                mismatch("vector " & to_string(sent) & " ready expected "
                    & to_string(should_be_ready) & " got " & to_string(ready));
            end if;
{%- endif %}
            -- Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if ce = '1' and valid(latency) = '1' then
{%- for port in outputs %}
                check_port("{{ port.name }}", expected(latency)({{ port.top }} downto {{ port.low }}),
                    std_logic_vector(dut_{{ port.name }}));
{%- endfor %}
                checked := checked + 1;
            end if;
        end procedure;

        procedure move_on is
        begin
            for i in latency downto 1 loop
                if rst = '1' then
                    valid(i) := '0';
                elsif ce = '1' then
                    valid(i) := valid(i - 1);
                end if;
                if ce = '1' then
                    expected(i) := expected(i - 1);
                    number(i) := number(i - 1);
                end if;
            end loop;
{%- if interval > 1 %}
            if rst = '1' then
                phase := 0;
            elsif ce = '1' then
                phase := (phase + 1) mod interval;
            end if;
{%- endif %}
        end procedure;

        -- Sets the inputs after this edge. They don't change while the pipeline is stalled.
        procedure drive is
        begin
            lfsr := lfsr(30 downto 0) & (lfsr(31) xor lfsr(21) xor lfsr(1) xor lfsr(0));
            rst <= '0';
            ce <= '1';
            if stalls and lfsr(2 downto 0) = 0 then
                ce <= '0';
            end if;
            if ce = '1'{% if interval > 1 %} or valid(0) = '0'{% endif %} then
                valid(0) := '0';
                if {% if interval > 1 %}phase = 0 and {% endif %}more and not (stalls and lfsr(5 downto 3) = 0) then
                    read_vector;
                    if more then
                        valid(0) := '1';
{%- for port in outputs %}
                        expected(0)({{ port.top }} downto {{ port.low }}) := next_{{ port.name }};
{%- endfor %}
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = {{ again }} then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
{%- if interval > 1 %}
                if phase /= 0 and lfsr(6) = '1' then
                    valid_in <= '1';
                end if;
{%- endif %}
                -- In a gap the inputs are the complement of the latest words.
                if valid(0) = '1' then
{%- for port in inputs %}
                    dut_{{ port.name }} <= {{ 'signed' if port.signed else 'unsigned' }}(next_{{ port.name }});
{%- endfor %}
                else
{%- for port in inputs %}
                    dut_{{ port.name }} <= {{ 'signed' if port.signed else 'unsigned' }}(not next_{{ port.name }});
{%- endfor %}
                end if;
            end if;
            -- A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if stalls and not reset_done and sent = {{ again }} / 2{% if interval > 1 %} and phase = interval / 2{% endif %} then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: {{ vectors }} holds " & to_string(passed)
                    & " vectors and should hold " & to_string(count));
            end if;
            if mismatches = 0 and passed = count then
                print("PASS " & to_string(passed) & " vectors");
                done <= true;
            else
                print("FAIL " & to_string(mismatches) & " mismatches in " & to_string(passed)
                    & " vectors");
                std.env.finish(1);
            end if;
        end procedure;
    begin
        open_vectors;
        while not done loop
            wait until rising_edge(clk);
            check;
            if rst = '1' and stalls then
                -- Words in flight are lost. The word that hasn't entered yet isn't.
                for i in 1 to latency loop
                    if valid(i) = '1' then
                        checked := checked + 1;
                    end if;
                end loop;
            end if;
            move_on;
{%- if resets > 1 %}
            if resets > 1 then
                resets := resets - 1;
            else
                drive;
            end if;
{%- else %}
            drive;
{%- endif %}
            started := true;
            if not more and checked = sent then
                file_close(vectors);
                if not stalls then
                    passed := checked;
                    stalls := true;
{%- if state %}
                    rst <= '1';
{%- endif %}
                    open_vectors;
                else
                    finish;
                    wait;
                end if;
            end if;
        end loop;
    end process;
end architecture;
