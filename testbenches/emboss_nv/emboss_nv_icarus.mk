# emboss: texture coordinates displaced by the direction of a light, for embossing
# make -f emboss_nv_icarus.mk           runs the testbench
# make -f emboss_nv_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: emboss_nv_tb.vvp
	vvp -n $<
wave: emboss_nv_tb.vvp
	vvp -n $< +vcd
emboss_nv_tb.vvp: $(HDL)/emboss_nv.v emboss_nv_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f emboss_nv_tb.vvp emboss_nv_tb.vcd
