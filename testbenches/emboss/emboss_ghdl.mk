# emboss: texture coordinates displaced by the direction of a light, for embossing
# make -f emboss_ghdl.mk             runs the VHDL testbench
# make -f emboss_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_emboss
run: ghdl_emboss/work-obj08.cf
	ghdl -r $(GHDL) emboss_tb
wave: ghdl_emboss/work-obj08.cf
	ghdl -r $(GHDL) emboss_tb --vcd=emboss_tb.vcd
ghdl_emboss/work-obj08.cf: $(HDL)/emboss.vhd emboss_tb.vhd
	rm -rf ghdl_emboss
	mkdir ghdl_emboss
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_emboss emboss_tb.vcd
