# {{ title }}
# make -f {{ name }}_icarus.mk           runs the testbench
# make -f {{ name }}_icarus.mk wave      runs it with a VCD
.PHONY: run wave clean
run: {{ name }}_tb.vvp
	vvp -n $<
wave: {{ name }}_tb.vvp
	vvp -n $< +vcd
{{ name }}_tb.vvp: {{ name }}.v {{ name }}_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f {{ name }}_tb.vvp {{ name }}_tb.vcd
