# {{ title }}
# make -f {{ name }}_icarus.mk           runs the testbench
# make -f {{ name }}_icarus.mk wave      runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
{%- if tables %}
TABLES = {{ tables | join(" ") }}
{%- endif %}
.PHONY: run wave clean
run: {{ name }}_tb.vvp{{ " $(TABLES)" if tables }}
	vvp -n $<
wave: {{ name }}_tb.vvp{{ " $(TABLES)" if tables }}
	vvp -n $< +vcd
{{ name }}_tb.vvp: $(HDL)/{{ name }}.v {{ top ~ ".v " if bench }}{{ name }}_tb.v
	iverilog -g2005 -Wall -o $@ $^
{%- if tables %}
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
{%- endif %}
clean:
	rm -f {{ name }}_tb.vvp {{ name }}_tb.vcd
