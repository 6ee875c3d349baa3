# ernst: light of a bump-mapped pixel by matrix, normalisation and Cartesian dot products
# make -f ernst_icarus.mk           runs the testbench
# make -f ernst_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: ernst_tb.vvp
	vvp -n $<
wave: ernst_tb.vvp
	vvp -n $< +vcd
ernst_tb.vvp: $(HDL)/ernst.v ernst_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f ernst_tb.vvp ernst_tb.vcd
