# rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
# make -f rsqrt_newton_icarus.mk           runs the testbench
# make -f rsqrt_newton_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: rsqrt_newton_tb.vvp
	vvp -n $<
wave: rsqrt_newton_tb.vvp
	vvp -n $< +vcd
rsqrt_newton_tb.vvp: $(HDL)/rsqrt_newton.v rsqrt_newton_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f rsqrt_newton_tb.vvp rsqrt_newton_tb.vcd
