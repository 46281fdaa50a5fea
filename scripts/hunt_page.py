PAGE="""{base} {base_consistent}
{singles}

{combined} {reached}/{both} endless {endless:.2%}
{best}

{best_teeth}

{stated}
slope {slope} left {left} {rise}
"""
