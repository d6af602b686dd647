"""What the paper's scene and its methods are called; it imports nothing, for lists and help."""

#: The scene that the shortcuts are for.
SCENE = "stick-slip"

#: The phases of its motion.
PHASES = ("stick", "slip")

#: The paper's name of each method that has one of its own, by the name it has in every scene.
METHODS = {"hb": "hb", "hb-ck": "hb-c1", "ck": "c1"}
