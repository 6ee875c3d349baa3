# basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
# make -f basis_icarus.mk           runs the testbench
# make -f basis_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: basis_tb.vvp
	vvp -n $<
wave: basis_tb.vvp
	vvp -n $< +vcd
basis_tb.vvp: $(HDL)/basis.v basis_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f basis_tb.vvp basis_tb.vcd
