# dot: dot product of three: exact products and sums, one rounding
# make -f dot_icarus.mk           runs the testbench
# make -f dot_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: dot_tb.vvp
	vvp -n $<
wave: dot_tb.vvp
	vvp -n $< +vcd
dot_tb.vvp: $(HDL)/dot.v dot_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f dot_tb.vvp dot_tb.vcd
