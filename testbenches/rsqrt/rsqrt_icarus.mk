# rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
# make -f rsqrt_icarus.mk           runs the testbench
# make -f rsqrt_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: rsqrt_tb.vvp
	vvp -n $<
wave: rsqrt_tb.vvp
	vvp -n $< +vcd
rsqrt_tb.vvp: $(HDL)/rsqrt.v rsqrt_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f rsqrt_tb.vvp rsqrt_tb.vcd
