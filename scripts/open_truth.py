#!/usr/bin/env python3
"""Opens the truth of a concealed recording beside what the diagnosis said of it.

    scripts/open_truth.py cases/concealed/truth.json out/concealed/diagnosis.json
"""
import argparse
import json


def parameters_in_words(parameters):
    return ", ".join(f"{name} {value:.4g}" if isinstance(value, float) else f"{name} {value}" for name, value in parameters.items())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("truth")
    parser.add_argument("diagnosis")
    arguments = parser.parse_args()
    with open(arguments.truth) as file:
        truth = json.load(file)
    with open(arguments.diagnosis) as file:
        diagnosis = json.load(file)
    print("\nThe diagnosis:", diagnosis["verdict"])
    for omitted in diagnosis["omitted"]:
        print(f"  {omitted['effect']} ({omitted['probability']:.0%})")
        for name, value in omitted["parameters"].items():
            if isinstance(value, dict) and "low" in value:
                print(f"    {name} {value['value']:.4g} {value['unit']} [{value['low']:.4g}, {value['high']:.4g}]")
            elif isinstance(value, dict):
                print(f"    {name} {value['value']}")
            else:
                print(f"    {name} {value}")
    print("The truth:")
    for hidden in truth["effects"] or [{"effect": "nothing", "parameters": {}}]:
        print(f"  {hidden['effect']} {parameters_in_words(hidden['parameters'])}")


if __name__ == "__main__":
    main()
