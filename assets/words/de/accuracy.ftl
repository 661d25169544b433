# accuracy
