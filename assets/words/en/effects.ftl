# effects
