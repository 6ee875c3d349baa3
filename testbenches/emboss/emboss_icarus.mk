# emboss: texture coordinates displaced by the direction of a light, for embossing
# make -f emboss_icarus.mk           runs the testbench
# make -f emboss_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
run: emboss_tb.vvp
	vvp -n $<
wave: emboss_tb.vvp
	vvp -n $< +vcd
emboss_tb.vvp: $(HDL)/emboss.v emboss_tb.v
	iverilog -g2005 -Wall -o $@ $^
clean:
	rm -f emboss_tb.vvp emboss_tb.vcd
